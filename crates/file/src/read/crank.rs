//! Crankshafts and throws.

pub(in crate::read) mod body;
pub(in crate::read) mod details;
pub(in crate::read) mod mains;
pub(in crate::read) mod material;
pub(in crate::read) mod stress;

use super::layers::Layers;
use super::reader::Reader;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::Ratio;
use lanchester_model::{Crankshaft, Throw};
use lanchester_numerics::about_zero;
use lanchester_units::Dimension;
use std::f64::consts::TAU;

/// Directions that differ by less [rad] are one.
const SAME_ANGLE: f64 = 1e-9;

/// A throw and where the file speaks of it.
#[derive(Debug, Clone)]
pub(super) struct DraftThrow {
    pub(super) throw: Throw,
    /// Its header, or the layout's.
    pub(super) span: Span,
    /// What gives its radius.
    pub(super) radius_span: Span,
    pub(super) web_distance: Option<f64>,
    /// What gives its web distance.
    pub(super) web_span: Span,
    /// How far the middles of its webs stand outside half the web distance [m].
    pub(super) web_growth: [f64; 2],
    /// Planes of its webs [m] where the file gives them, front then rear.
    pub(super) web_positions: [Option<f64>; 2],
    /// What gives its unbalance or masses, if the file gives them.
    pub(super) weighed: Option<Span>,
}

impl DraftThrow {
    pub(super) fn new(throw: Throw, span: Span, masses: &ThrowMasses) -> DraftThrow {
        let mut draft = DraftThrow {
            throw,
            span,
            radius_span: masses.radius_span.clone(),
            web_distance: masses.web_distance,
            web_span: masses.web_span.clone(),
            web_growth: [0.0; 2],
            web_positions: [None; 2],
            weighed: masses.weighed.clone(),
        };
        draft.move_by(0.0);
        draft
    }

    /// Moves it along z; its webs stay at half their distance from its plane, but for what is said of single ones.
    pub(super) fn move_by(&mut self, distance: f64) {
        self.throw.z += distance;
        self.web_positions.iter_mut().flatten().for_each(|position| *position += distance);
        let z = self.throw.z;
        let [front, rear] = self.web_growth;
        let usual = self.web_distance.map(|distance| [z - distance / 2.0 - front, z + distance / 2.0 + rear]);
        let [front, rear] = self.web_positions;
        self.throw.webs = match (front, rear, usual) {
            (Some(front), Some(rear), _) => Some([front, rear]),
            (front, rear, Some(usual)) => Some([front.unwrap_or(usual[0]), rear.unwrap_or(usual[1])]),
            _ => None,
        };
    }
}

/// What a throw has whatever its place.
#[derive(Debug, Clone)]
pub(super) struct ThrowMasses {
    pub(super) radius: f64,
    pub(super) unbalance: f64,
    pub(super) web_distance: Option<f64>,
    radius_span: Span,
    web_span: Span,
    /// What gives the unbalance, if something does.
    weighed: Option<Span>,
}

const UNBALANCE_KEYS: [&str; 4] = ["unbalance", "pin_mass", "web_mass", "web_radius"];

impl<'a> Reader<'a> {
    /// The crankshafts; one if the file names none.
    pub(super) fn crankshafts(&mut self) -> Option<Vec<Crankshaft>> {
        let sections = match self.root.tables("crankshaft") {
            Field::Given(spot) if !spot.value.is_empty() => spot.value,
            Field::Bad => return None,
            _ => {
                let name = "crankshaft".to_string();
                let mains = self.main_positions(None)?;
                return Some(vec![Crankshaft { name, ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, mains }]);
            }
        };
        let read: Vec<Option<Crankshaft>> =
            sections.iter().enumerate().map(|(index, section)| self.crankshaft(index, section)).collect();
        for (index, crankshaft) in read.iter().enumerate() {
            let Some(crankshaft) = crankshaft else { continue };
            let twin = read[..index]
                .iter()
                .position(|other| other.as_ref().is_some_and(|o| o.x == crankshaft.x && o.y == crankshaft.y));
            if let Some(twin) = twin {
                let (one, two) = (twin + 1, index + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0507",
                        sections[index].span.clone(),
                        format!("crankshafts {one} and {two} lie on one axis"),
                    )
                    .related(sections[twin].span.clone(), "the other")
                    .hint("give x and y of the axis"),
                );
            }
        }
        self.check_unique_parts("crankshaft", sections, &read, |crankshaft| &crankshaft.name);
        read.into_iter().collect()
    }

    fn crankshaft(&mut self, index: usize, section: &'a Section) -> Option<Crankshaft> {
        let name = section.text("name").or(format!("crankshaft {}", index + 1));
        let ratio = if index == 0 {
            section.ratio("ratio").or(Ratio::ONE)
        } else {
            self.required(section, "ratio", section.ratio("ratio"))
        };
        let [phase, x, y] = ["phase", "x", "y"].map(|key| section.number(key).or(0.0));
        let mains = self.main_positions(Some(section));
        let crankshaft =
            Crankshaft { name: name?, ratio: ratio?, phase: phase?, x: x?, y: y?, mains: mains? };
        if index > 0 {
            return Some(crankshaft);
        }
        let wrong = [
            ("ratio", crankshaft.ratio != Ratio::ONE),
            ("phase", crankshaft.phase != 0.0),
            ("x", crankshaft.x != 0.0),
            ("y", crankshaft.y != 0.0),
        ];
        for (key, _) in wrong.iter().filter(|(_, wrong)| *wrong) {
            let due = if *key == "ratio" { "1" } else { "0" };
            self.mistakes.push(
                Mistake::error(
                    "E0504",
                    section.value_span(key),
                    format!("`{key}` of the first crankshaft must be {due}"),
                )
                .hint("angles, speeds and places are counted from crankshaft 1; leave it out here"),
            );
        }
        // The rest of the file is read as if it were right.
        Some(Crankshaft { ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, ..crankshaft })
    }

    /// Radius, unbalance and web distance, from the throw's own table over `[crank]`.
    pub(super) fn throw_masses(&mut self, layers: &Layers<'a>) -> Option<ThrowMasses> {
        let radius = self.radius(layers);
        let (web_distance, web_span) = match layers.number("web_distance") {
            Field::Given(spot) => (Some(Some(spot.value)), spot.span),
            Field::Absent => (Some(None), layers.place()),
            Field::Bad => (None, 0..0),
        };
        let unbalance = self.throw_unbalance(layers, radius.as_ref().map(|(radius, _)| *radius));
        let weighed = layers.with_any(&UNBALANCE_KEYS).and_then(|section| {
            UNBALANCE_KEYS.iter().find(|key| section.has(key)).map(|key| section.value_span(key))
        });
        let (radius, radius_span) = radius?;
        Some(ThrowMasses {
            radius,
            unbalance: unbalance?,
            web_distance: web_distance?,
            radius_span,
            web_span,
            weighed,
        })
    }

    fn radius(&mut self, layers: &Layers<'a>) -> Option<(f64, Span)> {
        let Some(section) = layers.with_any(&["stroke", "radius"]) else {
            self.missing_in(layers, "the crank radius", "stroke = \"95.5 mm\"");
            return None;
        };
        let (stroke, radius) = (section.number("stroke"), section.number("radius"));
        match (stroke, radius) {
            (Field::Given(stroke), Field::Absent) => Some((stroke.value / 2.0, stroke.span)),
            (Field::Absent, Field::Given(radius)) => Some((radius.value, radius.span)),
            (Field::Absent, _) | (_, Field::Absent) => None,
            _ => {
                self.two_sources(section, "stroke", "radius", "the crank radius");
                None
            }
        }
    }

    /// What the keys of the throw and of `[crank]` say; 0 where they say nothing: with `[crank.body]` it is found later.
    fn throw_unbalance(&mut self, layers: &Layers<'a>, radius: Option<f64>) -> Option<f64> {
        let Some(section) = layers.with_any(&UNBALANCE_KEYS) else { return Some(0.0) };
        let [unbalance, pin, web, web_radius] = UNBALANCE_KEYS.map(|key| section.number(key));
        if section.has("unbalance") {
            let other = UNBALANCE_KEYS[1..].iter().find(|key| section.has(key));
            if let Some(other) = other {
                self.two_sources(section, "unbalance", other, "the unbalance of the throw");
                return None;
            }
            return unbalance.given();
        }
        if section.has("web_mass") != section.has("web_radius") {
            let (there, gone) =
                if section.has("web_mass") { ("web_mass", "web_radius") } else { ("web_radius", "web_mass") };
            if self.whole {
                self.without_effect(section, there, &format!("`{gone}` is missing"), &section.example(gone));
            }
            return None;
        }
        let (pin, web, web_radius) = (pin.or(0.0)?, web.or(0.0)?, web_radius.or(0.0)?);
        Some(pin * radius? + 2.0 * web * web_radius)
    }

    /// A throw of the general form.
    pub(super) fn throw(
        &mut self,
        index: usize,
        section: &'a Section,
        crankshafts: Option<&[Crankshaft]>,
    ) -> Option<DraftThrow> {
        let crankshaft = section.whole("crankshaft");
        let span = section.value_span("crankshaft");
        let crankshaft = crankshaft.or(1).and_then(|number| {
            self.existing(number, crankshafts.map(<[Crankshaft]>::len), "crankshaft", span)
        });
        let angle = self.required(section, "angle", section.number("angle"));
        let z = self.required(section, "z", section.number("z"));
        let masses = self.throw_masses(&self.layers(&[Some(section)], "crank"));
        if let (0, Some(angle), Some(of), Some(crankshafts)) = (index, angle, crankshaft, crankshafts) {
            let phase = crankshafts.get(of).map_or(0.0, |crankshaft| crankshaft.phase);
            let off = about_zero(angle + phase, TAU);
            if off.abs() > SAME_ANGLE {
                let off = lanchester_units::readable(off, Dimension::Angle);
                self.mistakes.push(
                    Mistake::error(
                        "E0503",
                        section.value_span("angle"),
                        format!("throw 1 must stand at 0 deg, got {off}"),
                    )
                    .label("not along +x")
                    .hint(format!("all angles count from throw 1: take {off} off all of them")),
                );
                return None;
            }
        }
        let masses = masses?;
        let throw = Throw {
            crankshaft: crankshaft?,
            angle: angle?,
            z: z?,
            radius: masses.radius,
            unbalance: masses.unbalance,
            unbalance_offset: 0.0,
            webs: None,
        };
        Some(DraftThrow::new(throw, section.span.clone(), &masses))
    }

    /// Index of part `number` (from 1) if there are so many; `None` for `count` says that nobody knows.
    pub(super) fn existing(
        &mut self,
        number: i64,
        count: Option<usize>,
        what: &str,
        span: Span,
    ) -> Option<usize> {
        let index = usize::try_from(number).ok()?.checked_sub(1)?;
        let count = count?;
        if index < count {
            return Some(index);
        }
        // Tables may hide behind a mistake of syntax.
        if self.whole {
            let there = match count {
                0 => format!("there is no {what} at all"),
                1 => format!("there is only {what} 1"),
                _ => format!("there are {what}s 1 to {count}"),
            };
            self.mistakes
                .push(Mistake::error("E0205", span, format!("{what} {number} does not exist")).hint(there));
        }
        None
    }
}
