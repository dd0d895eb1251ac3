//! The bobweight sheet: weighed parts, pin by pin.

use crate::document::{Field, Section};
use crate::read::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_task::workshop::{BobweightSheet, CylinderParts, PinParts};

/// What holds for all pins.
#[derive(Clone, Copy)]
struct Common<'a> {
    parts: Option<&'a Section>,
    rods: usize,
    oil: f64,
    has_engine: bool,
}

impl<'a> Reader<'a> {
    /// The bobweight sheet; the inner `None` where the file has none.
    pub(super) fn bobweight_sheet(&mut self) -> Option<Option<BobweightSheet>> {
        let root = self.root;
        if !["bobweight", "parts", "pin"].iter().any(|key| root.has(key)) {
            return Some(None);
        }
        let (section, broken) = self.section("bobweight");
        let (parts, parts_broken) = self.section("parts");
        let pins = root.tables("pin").or(&[]);
        let (mut rotating_share, mut reciprocating_share) = (Some(1.0), Some(None));
        let (mut bank_angle, mut split_angle) = (Some(None), Some(0.0));
        let (mut count, mut rods, mut oil) = (Some(1), Some(1), Some(0.0));
        if let Some(section) = section {
            rotating_share = section.number("rotating_share").or(1.0);
            reciprocating_share = optional(section.number("reciprocating_share"));
            bank_angle = optional(section.number("bank_angle"));
            split_angle = section.number("split_angle").or(0.0);
            count = section.whole("pins").or(1);
            rods = section.whole("rods").or(1);
            oil = section.number("oil").or(0.0);
            if section.has("split_angle") && !section.has("bank_angle") {
                self.without_effect(section, "split_angle", "no bank angle is given", "add `bank_angle`");
            }
            if section.has("pins") && root.has("pin") {
                self.without_effect(section, "pins", "every [[pin]] is listed", "leave it out");
            }
        }
        if parts.is_none() && !parts_broken && !root.has("pin") {
            let hint = "add [parts] with big_end = \"460 g\", small_end = \"170 g\", piston = \"560 g\"";
            let place = section.map_or(0..0, |section| section.span.clone());
            self.missing(place, "[parts] is missing".into(), hint.into());
            return None;
        }
        if broken || parts_broken {
            return None;
        }
        let common = Common { parts, rods: rods? as usize, oil: oil?, has_engine: root.has("engine") };
        let pins = match pins? {
            [] => {
                let rods = vec![self.cylinder_parts(None, &common)?; common.rods];
                let pin = |place: usize| PinParts {
                    name: format!("pin {}", place + 1),
                    throw: common.has_engine.then_some(place + 1),
                    oil: common.oil,
                    cylinders: rods.clone(),
                };
                (0..count? as usize).map(pin).collect()
            }
            sections => {
                let pins: Vec<Option<PinParts>> =
                    sections.iter().enumerate().map(|(k, section)| self.pin(section, k, &common)).collect();
                let pins: Vec<PinParts> = pins.into_iter().collect::<Option<_>>()?;
                self.check_throws(sections, &pins);
                pins
            }
        };
        Some(Some(BobweightSheet {
            rotating_share: rotating_share?,
            reciprocating_share: reciprocating_share?,
            bank_angle: bank_angle?,
            split_angle: split_angle?,
            pins,
        }))
    }

    fn pin(&mut self, section: &'a Section, place: usize, common: &Common<'a>) -> Option<PinParts> {
        let name = section.text("name").or(format!("pin {}", place + 1));
        let throw = section.whole("throw").or(place as i64 + 1);
        let oil = section.number("oil").or(common.oil);
        let rods = section.whole("rods").or(common.rods as i64);
        if section.has("throw") && !common.has_engine {
            self.without_effect(
                section,
                "throw",
                "the sheet names no engine",
                "add `engine`, or leave it out",
            );
        }
        if section.has("rods") && section.has("cylinder") {
            self.two_sources(section, "cylinder", "rods", "the number of rods");
            return None;
        }
        let cylinders = match section.tables("cylinder").or(&[])? {
            [] => vec![self.cylinder_parts(Some((section, None)), common)?; rods? as usize],
            sections => {
                let own: Vec<Option<CylinderParts>> = sections
                    .iter()
                    .map(|own| self.cylinder_parts(Some((section, Some(own))), common))
                    .collect();
                own.into_iter().collect::<Option<Vec<_>>>()?
            }
        };
        Some(PinParts {
            name: name?,
            throw: throw.filter(|_| common.has_engine).map(|number| number as usize),
            oil: oil?,
            cylinders,
        })
    }

    /// The parts of one cylinder: its own before those of `[parts]`.
    fn cylinder_parts(
        &mut self,
        own: Option<(&'a Section, Option<&'a Section>)>,
        common: &Common<'a>,
    ) -> Option<CylinderParts> {
        let layers: Vec<&Section> =
            own.and_then(|(_, cylinder)| cylinder).into_iter().chain(common.parts).collect();
        let place = match own {
            Some((pin, cylinder)) => cylinder.unwrap_or(pin).span.clone(),
            None => common.parts.map_or(0..0, |parts| parts.span.clone()),
        };
        let mut find = |key: &str, needed: bool| {
            // Every layer is asked, so that a key that another one covers counts as used.
            let fields: Vec<Field<f64>> = layers.iter().map(|layer| layer.number(key)).collect();
            match fields.into_iter().find(|field| !matches!(field, Field::Absent)) {
                Some(field) => field.given(),
                None if needed => {
                    let example = layers.first().map_or_else(String::new, |layer| layer.example(key));
                    let hint = format!("weigh it and add it to [parts]: {example}");
                    self.missing(place.clone(), format!("`{key}` of a cylinder is missing"), hint);
                    None
                }
                None => Some(0.0),
            }
        };
        let [big_end, small_end, piston] = ["big_end", "small_end", "piston"].map(|key| find(key, true));
        let [bearing, piston_pin, rings, locks] =
            ["bearing", "piston_pin", "rings", "locks"].map(|key| find(key, false));
        Some(CylinderParts {
            big_end: big_end?,
            bearing: bearing?,
            small_end: small_end?,
            piston: piston?,
            piston_pin: piston_pin?,
            rings: rings?,
            locks: locks?,
        })
    }

    /// Two pins on one throw.
    fn check_throws(&mut self, sections: &'a [Section], pins: &[PinParts]) {
        for (index, pin) in pins.iter().enumerate() {
            let Some(throw) = pin.throw else { continue };
            if let Some(first) = pins[..index].iter().position(|other| other.throw == pin.throw) {
                let message = format!("two pins stand for throw {throw}");
                self.mistakes.push(
                    Mistake::error("E1106", sections[index].value_span("throw"), message)
                        .label("second pin")
                        .related(sections[first].value_span("throw"), "first pin")
                        .hint("give each pin its own throw"),
                );
            }
        }
    }
}

/// `None` if it is bad.
fn optional<T>(field: Field<T>) -> Option<Option<T>> {
    match field {
        Field::Absent => Some(None),
        Field::Bad => None,
        Field::Given(spot) => Some(Some(spot.value)),
    }
}
