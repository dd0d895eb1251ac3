//! What `[bearings.main]`, `[bearings.crankpin]` and `[bearings.film]` say beyond sizes.

use super::reader::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::{
    BearingData, BearingDesign, BearingLaw, Cavitation, EngineParts, Housing, Oil, OilGroove,
};
use std::f64::consts::TAU;

/// A turn, to rounding.
const A_TURN: f64 = TAU * (1.0 + 1e-9);

impl<'a> Reader<'a> {
    /// The design of the bearings: the outer `None` says bad, the inner one absent.
    pub(super) fn bearing_design(&mut self) -> Option<Option<BearingDesign>> {
        let (section, broken) = self.section("bearings");
        let Some(section) = section else { return (!broken).then_some(None) };
        let main = self.bearings_of(section, "main");
        let crankpin = self.bearings_of(section, "crankpin");
        let oil = self.oil(section);
        let ((main, main_each), (crankpin, crankpin_each)) = (main?, crankpin?);
        let design = BearingDesign { main, main_each, crankpin, crankpin_each, oil: oil? };
        Some((design != BearingDesign::default()).then_some(design))
    }

    /// Those of all, and single ones with their index.
    fn bearings_of(
        &mut self,
        bearings: &'a Section,
        key: &str,
    ) -> Option<(BearingData, Vec<(usize, BearingData)>)> {
        let section = match bearings.table(key) {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some((BearingData::default(), Vec::new())),
            Field::Bad => return None,
        };
        let all = self.bearing_data(section);
        let mut each: Vec<(usize, BearingData)> = Vec::new();
        let mut is_good = true;
        for own in section.tables("each").or(&[])? {
            let number = self.required(own, "number", own.whole("number"));
            let data = self.bearing_data(own);
            let width = number_of(own, "width");
            let (Some(number), Some(data), Some(width)) = (number, data, width) else {
                is_good = false;
                continue;
            };
            let index = usize::try_from(number - 1).unwrap_or(0);
            if each.iter().any(|(known, _)| *known == index) {
                let message = format!("bearing {number} has two tables");
                self.mistakes
                    .push(Mistake::error("E0203", own.value_span("number"), message).hint("join the two"));
                is_good = false;
            }
            each.push((index, BearingData { width, ..data }));
        }
        Some((all?, each)).filter(|_| is_good)
    }

    fn bearing_data(&mut self, section: &'a Section) -> Option<BearingData> {
        let [diametral_clearance, stiffness, damping] =
            ["diametral_clearance", "stiffness", "damping"].map(|key| number_of(section, key));
        let model = section.word("model");
        let grooves = self.grooves(section);
        let housing = match section.word("housing_stiffness") {
            Field::Given(_) => Some(Some(Housing::Rigid)),
            Field::Absent => Some(None),
            Field::Bad => {
                number_of(section, "housing_stiffness").map(|stiffness| stiffness.map(Housing::Stiffness))
            }
        };
        if model.is_bad() {
            return None;
        }
        let law = model.given().and_then(|word| BearingLaw::ALL.into_iter().find(|law| law.word() == word));
        Some(BearingData {
            width: None,
            diametral_clearance: diametral_clearance?,
            model: law,
            stiffness: stiffness?,
            damping: damping?,
            grooves: grooves?,
            housing: housing?,
        })
    }

    fn grooves(&mut self, section: &'a Section) -> Option<Option<Vec<OilGroove>>> {
        let tables = match section.tables("grooves") {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        let (mut found, mut is_good) = (Vec::new(), true);
        for own in tables {
            let [from, to, width] =
                ["from", "to", "width"].map(|key| self.required(own, key, own.number(key)));
            let (Some(from), Some(to), Some(width)) = (from, to, width) else {
                is_good = false;
                continue;
            };
            if !(to > from && to - from <= A_TURN) {
                let message = "a groove must end after it begins, at most a turn on";
                self.mistakes.push(
                    Mistake::error("E0108", own.value_span("to"), message)
                        .label("out of range")
                        .hint("for example from = \"-60 deg\", to = \"60 deg\""),
                );
                is_good = false;
            }
            if let Field::Given(bearing) = section.number("width")
                && width >= bearing.value
            {
                self.mistakes.push(
                    Mistake::error("E1301", own.value_span("width"), "the groove is as wide as its bearing")
                        .related(bearing.span, "the bearing")
                        .hint("give a narrower groove"),
                );
                is_good = false;
            }
            found.push(OilGroove { from, to, width });
        }
        is_good.then_some(Some(found))
    }

    fn oil(&mut self, bearings: &'a Section) -> Option<Oil> {
        let section = match bearings.table("film") {
            Field::Given(spot) => spot.value,
            Field::Absent => return Some(Oil::default()),
            Field::Bad => return None,
        };
        let sources = ["viscosity", "kinematic_viscosity", "oil"];
        let given: Vec<&str> = sources.into_iter().filter(|key| section.has(key)).collect();
        if let [keep, other, ..] = given.as_slice() {
            self.two_sources(section, keep, other, "the viscosity");
        }
        for (key, beside, message) in [
            ("kinematic_viscosity", "density", "a kinematic viscosity needs the `density` of the oil"),
            ("oil", "temperature", "the viscosity of an oil needs its `temperature`"),
        ] {
            if section.has(key) && !section.has(beside) {
                self.missing(section.key_span(key), message.into(), section.example(beside));
            }
        }
        let name = section.text("oil");
        let cavitation = section.word("cavitation");
        if name.is_bad() || cavitation.is_bad() {
            return None;
        }
        let number = |key: &str| number_of(section, key);
        let kinematic = number("kinematic_viscosity")?.zip(number("density")?);
        Some(Oil {
            viscosity: number("viscosity")?.or(kinematic.map(|(kinematic, density)| kinematic * density)),
            name: name.given(),
            temperature: number("temperature")?,
            density: number("density")?,
            cavitation: cavitation
                .given()
                .and_then(|word| Cavitation::ALL.into_iter().find(|one| one.word() == word)),
            supply_pressure: number("supply_pressure")?,
            roughness: number("roughness")?,
        })
    }

    /// Bearings that differ must be there.
    pub(super) fn check_bearing_numbers(&mut self, parts: &EngineParts) {
        let (Some(section), Some(_)) = (self.section("bearings").0, &parts.bearing_design) else { return };
        for (key, count, what) in [
            ("main", parts.main_bearings().len(), "main bearing"),
            ("crankpin", parts.cylinders.len(), "cylinder"),
        ] {
            let Some(table) = section.table(key).given() else { continue };
            for own in table.tables("each").given().unwrap_or(&[]) {
                if let Field::Given(number) = own.whole("number") {
                    self.existing(number.value, Some(count), what, number.span);
                }
            }
        }
    }
}

/// The outer `None` says bad, the inner one absent.
fn number_of(section: &Section, key: &str) -> Option<Option<f64>> {
    match section.number(key) {
        Field::Given(spot) => Some(Some(spot.value)),
        Field::Absent => Some(None),
        Field::Bad => None,
    }
}
