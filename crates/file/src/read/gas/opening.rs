//! Valves and ports: `[gas.intake]` and `[gas.exhaust]`.

use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;
use lanchester_model::{Opening, OpeningShape, SingleZone};
use std::f64::consts::{PI, TAU};

/// Usual discharge coefficient.
const DISCHARGE: f64 = 0.7;
/// Share of a cycle that an opening may stay open.
const LONGEST_SHARE: f64 = 0.6;

/// Keys of a valve that ports or a given area have no use for.
const OF_VALVES: [&str; 4] = ["lift", "diameter", "number", "piston_clearance"];

fn cycle_of(strokes: Strokes) -> f64 {
    TAU * f64::from(strokes.revolutions())
}

impl<'a> Reader<'a> {
    pub(super) fn opening(
        &mut self,
        gas: &'a Section,
        key: &'static str,
        strokes: Strokes,
    ) -> Option<Opening> {
        let Some(section) = Self::gas_table(gas, key)? else {
            self.missing(
                gas.span.clone(),
                format!("a single zone needs [gas.{key}]"),
                "add its opens, closes, lift and diameter, or opens and area for ports".into(),
            );
            return None;
        };
        let cycle = cycle_of(strokes);
        let opens = self.required(section, "opens", section.number("opens"));
        let opens =
            opens.map(|angle| if (0.0..cycle).contains(&angle) { angle } else { angle.rem_euclid(cycle) });
        let closes = match section.number("closes") {
            Field::Given(spot) => Some(Some(spot)),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let discharge_coefficient = section.number("discharge_coefficient").or(DISCHARGE);
        if let Some(coefficient) = discharge_coefficient
            && coefficient > 1.0
        {
            let message = format!("`discharge_coefficient` must be at most 1, got {coefficient}");
            self.mistakes.push(
                Mistake::error("E1202", section.value_span("discharge_coefficient"), message)
                    .label("out of range")
                    .hint("it is the effective area over the geometric one, such as 0.7"),
            );
        }
        let closes = match (opens, closes?) {
            (Some(opens), Some(spot)) => {
                let turns = ((spot.value - opens) / cycle).floor();
                let inside = spot.value > opens && spot.value < opens + cycle;
                let closes = if inside { spot.value } else { spot.value - turns * cycle };
                let [from, to] = [opens, spot.value].map(f64::to_degrees);
                let open = closes - opens;
                if open <= 0.0 || open > LONGEST_SHARE * cycle {
                    let message = format!(
                        "from {from:.4} deg to {to:.4} deg it would be open over {:.0} of {:.0} deg",
                        open.to_degrees(),
                        cycle.to_degrees()
                    );
                    self.mistakes.push(
                        Mistake::error("E1203", section.value_span("closes"), message)
                            .label("closes before it opens")
                            .related(section.value_span("opens"), "opens")
                            .hint("angles count from the firing top dead centre in the sense of rotation"),
                    );
                    return None;
                }
                Some(closes)
            }
            (None, Some(_)) => return None,
            (_, None) => None,
        };
        let shape = self.opening_shape(section, closes);
        Some(Opening { opens: opens?, discharge_coefficient: discharge_coefficient?, shape: shape? })
    }

    fn opening_shape(&mut self, section: &'a Section, closes: Option<f64>) -> Option<OpeningShape> {
        if section.has("area") {
            for key in OF_VALVES.into_iter().filter(|key| section.has(key)) {
                self.two_sources(section, "area", key, "how far it opens");
            }
            let area = section.number("area").given();
            return Some(match closes {
                Some(closes) => OpeningShape::Area { closes, area: area? },
                None => OpeningShape::Port { area: area? },
            });
        }
        let lift = self.required(section, "lift", section.number("lift"));
        let diameter = self.required(section, "diameter", section.number("diameter"));
        let number = section.whole("number").or(1);
        let piston_clearance = match section.number("piston_clearance") {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let Some(closes) = closes else {
            self.missing(
                section.span.clone(),
                format!("`closes` is missing in {}", section.title()),
                format!(
                    "{}; ports that the piston closes have an area instead of lift and diameter",
                    section.example("closes")
                ),
            );
            return None;
        };
        Some(OpeningShape::Valve {
            closes,
            lift: lift?,
            diameter: diameter?,
            number: u32::try_from(number?).ok()?,
            piston_clearance: piston_clearance?,
        })
    }

    /// Nothing may be open at the firing top dead centre, and nothing while heat is released before it.
    pub(super) fn check_timing(&mut self, gas: &'a Section, zone: &SingleZone, strokes: Strokes) -> bool {
        let cycle = cycle_of(strokes);
        let mut is_good = true;
        let mut latest_closing = -cycle;
        for (key, opening) in [("intake", zone.intake), ("exhaust", zone.exhaust)] {
            let Field::Given(section) = gas.table(key) else { continue };
            let section = section.value;
            let closes = match opening.shape {
                OpeningShape::Valve { closes, .. } | OpeningShape::Area { closes, .. } => closes,
                OpeningShape::Port { .. } => {
                    if !(opening.opens > 0.0 && opening.opens < PI) {
                        let message = format!(
                            "ports that open at {:.4} deg are not uncovered by a piston on its way down",
                            opening.opens.to_degrees()
                        );
                        self.mistakes.push(
                            Mistake::error("E1203", section.value_span("opens"), message)
                                .hint("give an angle between 0 deg and 180 deg"),
                        );
                        is_good = false;
                        continue;
                    }
                    TAU - opening.opens
                }
            };
            // Open from `opens` to `closes`, and again a cycle later.
            if closes > cycle {
                let message = format!(
                    "open from {:.4} deg to {:.4} deg, it would be open at the firing top dead centre",
                    opening.opens.to_degrees(),
                    closes.to_degrees()
                );
                self.mistakes.push(
                    Mistake::error("E1203", section.value_span("opens"), message).hint(
                        "angles count from the firing top dead centre, not from that of the gas exchange",
                    ),
                );
                is_good = false;
            }
            latest_closing = latest_closing.max(closes - cycle);
        }
        let Some(combustion) = &zone.combustion else { return is_good };
        let Field::Given(release) = gas.table("heat_release") else { return is_good };
        let earliest_opening = zone.intake.opens.min(zone.exhaust.opens);
        for (index, stage) in combustion.stages.iter().enumerate() {
            let section = match release.value.table("second") {
                Field::Given(second) if index > 0 => second.value,
                _ => release.value,
            };
            if is_good && (stage.start < latest_closing || stage.start >= earliest_opening) {
                let message = format!(
                    "heat released from {:.4} deg on would be released while the cylinder is open: it is closed from {:.4} deg to {:.4} deg",
                    stage.start.to_degrees(),
                    latest_closing.to_degrees(),
                    earliest_opening.to_degrees()
                );
                self.mistakes.push(
                    Mistake::error("E1204", section.value_span("start"), message)
                        .hint("angles count from the firing top dead centre, negative before it"),
                );
                is_good = false;
            }
        }
        is_good
    }
}
