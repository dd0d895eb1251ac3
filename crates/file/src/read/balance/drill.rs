//! Holes of which a free weight is one.

use super::Reader;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::angle;
use lanchester_task::workshop::{DrillDirection, Surface};
use lanchester_task::{Catalogue, DRILL_POINT, DrillCatalogue, Phase};
use lanchester_units::Dimension;
use std::f64::consts::PI;

/// Step of depths where none is given [m].
const DEPTH_STEP: f64 = 1e-3;
/// Most holes of a weight.
const MOST_HOLES: usize = 20_000;

/// Holes, and the unbalances that they are.
type Holes = (DrillCatalogue, Catalogue);

impl<'a> Reader<'a> {
    /// `drill`, with at least one hole between the least and the largest amount; `Some(None)` where it is not given.
    pub(super) fn drilled(
        &mut self,
        section: &'a Section,
        (least, most): (f64, Option<f64>),
    ) -> Option<Option<Holes>> {
        let drill = match section.table("drill") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(drill) => drill.value,
        };
        if let Some(other) = ["step", "catalogue", "unbalance"].into_iter().find(|key| section.has(key)) {
            self.two_sources(section, "drill", other, "the amounts of the weight");
            return None;
        }
        let catalogue = self.drill_catalogue(drill)?;
        if section.has("radius") && catalogue.slug_density.is_none() {
            let why = "an empty hole adds no mass; `radius` of `drill` is where it begins";
            self.without_effect(section, "radius", why, "leave it out");
            return None;
        }
        let count = catalogue.count();
        if count > MOST_HOLES {
            let message = format!("`drill` has {count} holes, more than {MOST_HOLES}");
            self.mistakes.push(
                Mistake::error("E0004", section.key_span("drill"), message)
                    .hint("take a larger depth_step, or fewer diameters"),
            );
            return None;
        }
        let amounts: Vec<f64> = catalogue.holes().iter().map(|hole| hole.unbalance).collect();
        if amounts.is_empty() {
            let message = "`drill` has no hole that weighs anything";
            let hint = match catalogue.slug_density {
                Some(slug) if slug <= catalogue.density => {
                    "slugs must be denser than what is drilled: slug_density = \"18 g/cm3\""
                }
                _ => {
                    "the point of the drill alone may be longer than max_depth: give more depth or smaller drills"
                }
            };
            self.mistakes.push(Mistake::error("E0305", section.key_span("drill"), message).hint(hint));
            return None;
        }
        let amounts = Catalogue::Amounts(amounts);
        let last = most.map_or(amounts.last(), |most| amounts.below(most));
        if last == 0 || amounts.amount(last) < least * (1.0 - 1e-9) {
            let [first, end] = [amounts.amount(1), amounts.amount(amounts.last())]
                .map(|amount| lanchester_units::readable(amount, Dimension::Unbalance));
            let message =
                format!("no hole of `drill` lies between `least` and `most`: they weigh {first} to {end}");
            self.mistakes.push(
                Mistake::error("E0305", section.key_span("drill"), message)
                    .hint("widen `least` and `most`, or allow other drills or depths"),
            );
            return None;
        }
        Some(Some((catalogue, amounts)))
    }

    fn drill_catalogue(&mut self, section: &'a Section) -> Option<DrillCatalogue> {
        let direction = self.required(section, "direction", section.word("direction"));
        let surface = section.word("surface").or("round");
        let [radius, max_depth, density] =
            ["radius", "max_depth", "density"].map(|key| self.required(section, key, section.number(key)));
        let depth_step = section.number("depth_step").or(DEPTH_STEP);
        let point = section.number("point").or(DRILL_POINT.to_radians());
        let slug_density = section.number("slug_density");
        let diameters = match section.numbers("diameters") {
            Field::Given(list) => Some(list.value.iter().map(|spot| spot.value).collect()),
            Field::Absent => Some(DrillCatalogue::metric()),
            Field::Bad => None,
        };
        if direction == Some("axial") && section.has("surface") {
            self.without_effect(section, "surface", "an axial hole begins on a flat face", "leave it out");
        }
        if let Some(point) = point.filter(|point| *point > PI * (1.0 + 1e-12)) {
            let got = lanchester_units::readable(point, Dimension::Angle);
            let message = format!("the angle of a drill point is at most 180 deg, got {got}");
            self.mistakes.push(Mistake::error("E0108", section.value_span("point"), message).hint(
                "it is the full angle of the cone: 118 deg for a common drill, 180 deg for a flat bottom",
            ));
            return None;
        }
        if slug_density.is_bad() {
            return None;
        }
        let mut diameters: Vec<f64> = diameters?;
        if diameters.is_empty() {
            let span = section.value_span("diameters");
            let mistake = Mistake::error("E0206", span, "`diameters` is empty");
            self.mistakes.push(mistake.hint(section.example("diameters")));
            return None;
        }
        diameters.sort_by(f64::total_cmp);
        diameters.dedup();
        Some(DrillCatalogue {
            direction: if direction? == "radial" { DrillDirection::Radial } else { DrillDirection::Axial },
            surface: if surface? == "round" { Surface::Round } else { Surface::Flat },
            radius: radius?,
            diameters,
            max_depth: max_depth?,
            depth_step: depth_step?,
            point: point?.min(PI),
            density: density?,
            slug_density: slug_density.given(),
        })
    }
}

/// The direction of a weight whose hole has this direction: opposite to an empty hole.
pub(super) fn of_weight(phase: Phase, drill: Option<&DrillCatalogue>) -> Phase {
    match (drill, phase) {
        (Some(drill), Phase::Direction(angle)) if drill.slug_density.is_none() => {
            Phase::Direction(angle::direction(angle + PI))
        }
        (_, phase) => phase,
    }
}
