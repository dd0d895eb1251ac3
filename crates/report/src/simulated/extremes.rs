//! Largest and smallest values over the whole run, beside those of its last period.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table};
use crate::simulated::columns::{table, words};
use crate::simulated::result::SimulationResult;
use lanchester_multibody::{Bounds, MainRule, Peak, RunExtremes};

/// An extreme of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ExtremeRow {
    /// What it is.
    pub quantity: String,
    /// Its unit, SI.
    pub unit: &'static str,
    /// Over the whole run.
    pub whole: Peak,
    /// Over the last period.
    pub last_period: Peak,
}

impl ExtremeRow {
    /// Factor and unit in which tables show it.
    fn shown(&self) -> (f64, &'static str) {
        match self.unit {
            "rad/s" => (number::rpm(1.0), "rpm"),
            "m" => (1e3, "mm"),
            "rad" => (1e3, "mrad"),
            unit => (1.0, unit),
        }
    }
}

/// All extremes of one summary, in order.
fn peaks(result: &SimulationResult, extremes: &RunExtremes) -> Vec<(String, &'static str, Peak)> {
    let mut all = Vec::new();
    let mut both = |names: [String; 2], unit: &'static str, bounds: &Bounds| {
        let [most, least] = names;
        all.push((most, unit, bounds.most));
        all.push((least, unit, bounds.least));
    };
    let ends = |name: &str| [format!("{name}, most"), format!("{name}, least")];
    both(ends("speed"), "rad/s", &extremes.speed);
    if let Some(torque) = &extremes.shaft_torque {
        both(ends("shaft torque"), "N m", torque);
    }
    for (index, torque) in extremes.driveline.iter().enumerate() {
        both(ends(&format!("torque of driveline spring {}", index + 1)), "N m", torque);
    }
    for (axis, bounds) in ["x", "y", "z"].into_iter().zip(&extremes.position) {
        both(ends(&format!("block along {axis}")), "m", bounds);
    }
    for (axis, bounds) in ["x", "y", "z"].into_iter().zip(&extremes.turn) {
        both(ends(&format!("turn of the block about {axis}")), "rad", bounds);
    }
    for (name, peak) in result.mounts.iter().zip(&extremes.mounts) {
        all.push((format!("force of mount {name}"), "N", *peak));
    }
    for (index, own) in extremes.cylinders.iter().enumerate() {
        let of = |joint: &str| format!("{joint} of cylinder {}", index + 1);
        all.push((of("side thrust"), "N", own.side_thrust));
        all.push((of("piston pin"), "N", own.piston_pin));
        all.push((of("lower pin"), "N", own.lower_pin));
    }
    let rule = MainRule::ALL.iter().position(|rule| *rule == result.main_rule).unwrap_or(0);
    for (shaft, (rotor, planes)) in extremes.rotors.iter().zip(&result.mains).enumerate() {
        for (main, peak) in rotor.mains[rule].iter().enumerate().take(planes.len()) {
            all.push((format!("main bearing {}.{}", shaft + 1, main + 1), "N", *peak));
        }
    }
    for (rotor, name) in extremes.rotors.iter().skip(1).zip(&result.gears) {
        all.push((format!("gear torque of {name}, most"), "N m", rotor.gear_torque.most));
        all.push((format!("gear torque of {name}, least"), "N m", rotor.gear_torque.least));
        all.push((format!("force on the bearings of {name}"), "N", rotor.bearing_force));
        all.push((format!("moment on the bearings of {name}"), "N m", rotor.bearing_moment));
    }
    all
}

/// Largest and smallest values over the whole run, beside those of the last period.
pub fn extreme_rows(result: &SimulationResult) -> Vec<ExtremeRow> {
    let whole = peaks(result, &result.run.extremes).into_iter();
    let rows = whole
        .zip(peaks(result, &result.period.extremes))
        .map(|((quantity, unit, whole), last)| ExtremeRow { quantity, unit, whole, last_period: last.2 });
    rows.collect()
}

/// The same as a table, where the run is more than its last period.
pub(super) fn extremes_table(result: &SimulationResult) -> Option<Table> {
    if result.run.extremes == result.period.extremes || result.run.samples.time.len() < 2 {
        return None;
    }
    let rows = extreme_rows(result).into_iter().map(|row| {
        let (factor, unit) = row.shown();
        vec![
            Cell::text(&row.quantity),
            Cell::text(unit),
            Cell::number(factor * row.whole.value, 5),
            Cell::number(row.whole.time, 5),
            Cell::number(row.whole.theta.to_degrees(), 6),
            Cell::number(factor * row.last_period.value, 5),
        ]
    });
    let columns = vec![
        words("quantity", ""),
        words("unit", ""),
        Column::numbers("whole run", ""),
        words("at time", "s"),
        words("crank angle", "deg"),
        Column::numbers("last period", ""),
    ];
    let note = format!(
        "Main bearings by the rule `{}`. Between the places that are evaluated extremes are those of parabolas.",
        result.main_rule.name()
    );
    let title = "Largest and smallest values over the whole run";
    Some(table("simulated-extremes", title, &note, columns, rows.collect()))
}
