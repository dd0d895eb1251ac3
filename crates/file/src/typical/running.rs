//! Flywheel, bearings and a run in time.

use super::sizes::Sizes;
use super::words::{Block, list, mm, number, quantity};
use super::{Found, From};
use serde_json::Value as Json;
use std::f64::consts::PI;

/// Mean effective pressure over the heat of the fuel: what an ideal cycle of a petrol or Diesel engine makes of it, less what is lost.
const WORK_SHARE: f64 = 0.5;

impl From<'_> {
    pub(super) fn flywheel(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        let inertia = || {
            let work = WORK_SHARE * sizes.energy() * sizes.swept;
            // At full load the work of the longest pause between firings swings in and out of it.
            1.45 * sizes.ratios.flywheel * work / sizes.evenness / engine.speed.lowest.powi(2)
        };
        let text = |inertia: f64| quantity(inertia, "kg m2", 1.0, 2);
        let crank = || text(crank_inertia(sizes));
        let needs_crank = engine.crank_body.is_none();
        let comment = match self.kind {
            super::EngineKind::AircraftPetrol => "airscrew and hub",
            _ => "from the work of the longest pause between firings over the square of the lowest speed",
        };
        let crank_comment = "pins, webs and counterweights of usual proportions";
        match &engine.flywheel {
            None => {
                let block = Block::new("[flywheel]", "for smooth running at the lowest speed.").line(
                    "inertia",
                    text(inertia()),
                    comment,
                );
                Found::Blocks(vec![match needs_crank {
                    true => block.line("crankshaft_inertia", crank(), crank_comment),
                    false => block,
                }])
            }
            Some(_) => {
                let mut keys = Vec::new();
                if !self.has("flywheel.inertia") {
                    keys.push((
                        "flywheel.inertia".into(),
                        Json::from(text(inertia()).trim_matches('"')),
                        comment.into(),
                    ));
                }
                if needs_crank && !self.has("flywheel.crankshaft_inertia") {
                    let value = Json::from(crank().trim_matches('"'));
                    keys.push(("flywheel.crankshaft_inertia".into(), value, crank_comment.into()));
                }
                if keys.is_empty() { Found::There } else { Found::Keys(keys) }
            }
        }
    }

    pub(super) fn bearings(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if self.has("bearings") {
            return Found::There;
        }
        let body = engine.crank_body.as_ref();
        let piston_pin = 0.25 * sizes.bore;
        let (pin, journal) = match body {
            Some(body) => (body.pin_diameter, body.journal_diameter),
            None => (sizes.pin, sizes.journal),
        };
        let sized = |block: Block, key: &str, of: f64, width: f64, comment: &str| {
            let block = if body.is_none() { block.line("diameter", mm(of), key) } else { block };
            block.line("width", mm(width), comment).line(
                "diametral_clearance",
                quantity(0.001 * of, "mm", 1e-3, 2),
                "0.001 of the diameter",
            )
        };
        let first = Block::new("[bearings.piston_pin]", "plain bearings scaled to bore, pin and journal.")
            .line("diameter", mm(piston_pin), "0.25 bore")
            .line("width", mm(0.26 * sizes.bore), "0.26 bore");
        let crankpin = sized(
            Block::new("[bearings.crankpin]", ""),
            "of the pin",
            pin,
            0.9 * sizes.rod_width(),
            "0.9 of the big end, which leaves 4 % of the pin free",
        );
        let main = sized(
            Block::new("[bearings.main]", ""),
            "of the journal",
            journal,
            sizes.main_width(),
            "0.36 journal, as far as there is room",
        );
        let film = Block::new("[bearings.film]", "")
            .line("viscosity", quantity(sizes.ratios.viscosity, "mPa s", 1e-3, 2), "of the hot oil")
            .line("supply_pressure", "\"4 bar\"", "");
        Found::Blocks(vec![first, crankpin, main, film])
    }

    pub(super) fn simulation(&self) -> Found {
        if self.has("simulation") {
            return Found::There;
        }
        let speed = self.file.engine.speed;
        let middle = 0.5 * (speed.lowest + speed.highest) * 30.0 / PI;
        let block = Block::new("[simulation]", "a run from the middle of the speed range.")
            .line(
                "start",
                format!("{{ speed = \"{} rpm\" }}", number(middle, 2)),
                "between the lowest and the highest speed",
            )
            .line("duration", "\"10 revolutions\"", "")
            .line("step", "\"2 deg\"", "");
        Found::Blocks(vec![block])
    }
}

/// Moment of inertia of all crankshafts with their counterweights [kg m2], about.
pub(super) fn crank_inertia(sizes: &Sizes<'_>) -> f64 {
    const STEEL: f64 = 7850.0;
    let engine = sizes.engine;
    let reach = 0.6 * sizes.bore;
    let pin = PI / 4.0 * sizes.pin.powi(2) * sizes.pin_length().max(0.2 * sizes.bore) * STEEL;
    // A web about as wide as 1.3 journals, from one journal radius below the axis to the end beyond the pin.
    let (below, above) = (0.6 * sizes.journal, 0.7 * sizes.pin);
    let webs = |radius: f64| {
        let (width, length) = (1.3 * sizes.journal, below + radius + above);
        let mass = 2.0 * width * length * sizes.web * STEEL;
        let centre = (radius + above - below) / 2.0;
        mass * ((width * width + length * length) / 12.0 + centre * centre)
    };
    let throws: f64 = engine.throws.iter().map(|throw| pin * throw.radius.powi(2) + webs(throw.radius)).sum();
    let weights: f64 = engine.counterweights.iter().map(|weight| weight.unbalance * reach).sum();
    throws + weights
}

/// Three values as a list.
pub(super) fn three(values: [String; 3]) -> String {
    list(&values)
}
