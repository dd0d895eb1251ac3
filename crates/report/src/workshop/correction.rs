//! What to do about the unbalance of a rotor, as tables.

use super::grade::{COUPLE, grade_tables, plain};
use super::mass::{grams, on_rotor, rotor_angle, rotor_degrees};
use crate::kit::number;
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table};
use lanchester_task::workshop::{Action, VibrationQuantity};
use lanchester_workshop::{Correction, NextStep, PlaneCorrection, Remark, RunFindings, ShownVibration};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Effects are told per this much unbalance: 100 g mm [kg m].
const REFERENCE: f64 = 1e-4;

/// Corrections, vibration now and after, influence coefficients, the log of the runs; empty ones are left out.
pub fn correction_tables(correction: &Correction) -> Vec<Table> {
    let mut tables = vec![planes_table(&correction.planes, correction.next == NextStep::Finished)];
    if let Some(runs) = &correction.runs {
        tables.extend([sensors_table(runs), influence_table(runs), log_table(runs)]);
    }
    tables.retain(|table| !table.rows.is_empty());
    tables
}

/// The correction for a terminal.
pub fn correction_text(correction: &Correction) -> String {
    let mut out = format!("{}\n", correction.name);
    if correction.next == NextStep::Finished {
        out += &format!("{}\n", next_words(correction));
    }
    for table in correction_tables(correction) {
        out += "\n";
        out += &table.text();
    }
    if let Some(condition) = correction.runs.as_ref().and_then(|runs| runs.condition) {
        out += &format!(
            "\ncondition of the influence coefficients: {} (1 is best; so many times may the relative error of a reading grow)\n",
            plain(condition, 3)
        );
    }
    if let Some(grade) = &correction.grade_now {
        let kept = |kept: Option<bool>| match kept {
            Some(true) => "kept",
            Some(false) => "not kept",
            None => "not judged",
        };
        out += &format!("\nG {}: {} now", plain(1e3 * grade.grade, 4), kept(grade.kept));
        if let Some(after) = &correction.grade_after {
            out += &format!(", {} when corrected as told", kept(after.kept));
        }
        out += "\n";
        if [Some(grade), correction.grade_after.as_ref()].into_iter().flatten().any(|own| own.kept.is_none())
        {
            out += COUPLE;
        }
        for table in grade_tables(grade) {
            out += "\n";
            out += &table.text();
        }
    }
    out += &remarks_text(&correction.remarks);
    if correction.next != NextStep::Finished {
        out += &format!("\n{}\n", next_words(correction));
    }
    out
}

pub(super) fn remarks_text(remarks: &[Remark]) -> String {
    remarks.iter().map(|remark| format!("\ndoubt: {}\nhint: {}\n", remark.message, remark.hint)).collect()
}

fn next_words(correction: &Correction) -> String {
    match (&correction.next, correction.holds) {
        (NextStep::Finished, _) => "every limit holds: nothing to do".to_owned(),
        (NextStep::Try { planes }, _) if planes.is_empty() => {
            "next: name the planes where weight may be added or removed, [[plane]]".to_owned()
        }
        (NextStep::Try { planes }, _) => format!(
            "next: put a trial weight in plane {}, run at the same speed, and add the run to the sheet; {}",
            planes.first().map_or("", String::as_str),
            if planes.len() > 1 { "then the same in each of the other planes" } else { "then read on" }
        ),
        (NextStep::Settle, _) => {
            "next: settle the doubts; until then the corrections are not to be relied on".to_owned()
        }
        (NextStep::Correct, holds) => {
            let why = match (holds, &correction.grade_now) {
                (Some(false), _) => "a limit does not hold yet",
                (_, Some(_)) => "the couple is not judged",
                (_, None) => "no limit is stated",
            };
            let again = match correction.runs {
                Some(_) => "run again, and add the run to the sheet",
                None => "and measure again",
            };
            format!("next: {why}: make the corrections, {again}")
        }
    }
}

fn planes_table(planes: &[PlaneCorrection], finished: bool) -> Table {
    let mut rows = Vec::new();
    for plane in planes {
        let action = if plane.action == Action::Add { "add" } else { "remove" };
        let noise = below(plane.unbalance.norm());
        let left = on_rotor(plane.left, noise);
        if plane.placements.is_empty() {
            let mut row = vec![Cell::text(plane.plane.clone()), Cell::text("nothing")];
            row.extend([Cell::Empty, Cell::Empty, Cell::Empty]);
            row.extend(left.clone());
            rows.push(row);
        }
        for (index, placement) in plane.placements.iter().enumerate() {
            let mut row = vec![
                Cell::text(plane.plane.clone()),
                Cell::text(action),
                Cell::number(1e6 * placement.unbalance, 4),
                rotor_angle(placement.angle, 1),
                placement.mass.map_or(Cell::Empty, grams_fine),
            ];
            row.extend(if index == 0 { left.clone() } else { [Cell::Empty, Cell::Empty] });
            rows.push(row);
        }
    }
    Table {
        id: "corrections",
        title: if finished { "What would take the rest" } else { "Corrections" }.to_owned(),
        note: "Angles count on the rotor. What allowed angles cannot give is left.".to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("plane"),
            Column::words("do"),
            Column::numbers("unbalance", "g mm"),
            Column::numbers("at", "deg"),
            Column::numbers("mass", "g"),
            Column::numbers("left", "g mm"),
            Column::numbers("at", "deg"),
        ],
        rows,
    }
}

/// Balance weights are weighed to a hundredth of a gram.
fn grams_fine(mass: f64) -> Cell {
    match grams(mass) {
        Cell::Number { value, .. } => Cell::Number { value, decimals: 2 },
        other => other,
    }
}

/// Unit of a workshop for a quantity, and what a value in SI is multiplied with.
pub(super) fn unit(quantity: VibrationQuantity) -> (&'static str, f64) {
    match quantity {
        VibrationQuantity::Displacement => ("um", 1e6),
        VibrationQuantity::Velocity => ("mm/s", 1e3),
        VibrationQuantity::Acceleration => ("m/s2", 1.0),
    }
}

fn amplitude(quantity: VibrationQuantity, value: f64) -> Cell {
    Cell::number(unit(quantity).1 * value, 4)
}

fn shown(vibration: Option<ShownVibration>) -> [Cell; 2] {
    vibration.map_or([Cell::Empty, Cell::Empty], |vibration| {
        [amplitude(vibration.quantity, vibration.amplitude), rotor_angle(vibration.phase, 0)]
    })
}

fn rpm(speed: f64) -> Cell {
    Cell::Number { value: number::rpm(speed), decimals: 0 }
}

fn sensors_table(runs: &RunFindings) -> Table {
    let rows = runs.sensors.iter().map(|sensor| {
        let quantity = sensor.now.quantity;
        let mut row =
            vec![Cell::text(sensor.sensor.clone()), rpm(sensor.speed), Cell::text(unit(quantity).0)];
        row.extend(shown(Some(sensor.now)));
        row.extend(sensor.after.map_or([Cell::Empty, Cell::Empty], |after| {
            // What vanishes has no phase.
            if after.amplitude <= below(sensor.now.amplitude) {
                [Cell::Number { value: 0.0, decimals: 0 }, Cell::Empty]
            } else {
                shown(Some(after))
            }
        }));
        row.push(sensor.scatter.map_or(Cell::Empty, |scatter| amplitude(quantity, scatter)));
        row.push(sensor.limit.map_or(Cell::Empty, |limit| amplitude(quantity, limit)));
        row.push(match sensor.limit {
            Some(limit) if sensor.now.amplitude <= limit => Cell::text("holds"),
            Some(_) => Cell::text("exceeded"),
            None => Cell::Empty,
        });
        row
    });
    Table {
        id: "vibration",
        title: "Vibration now, and as predicted with the corrections".to_owned(),
        note: "Amplitudes as the detector of the sensor gives them. The scatter is the standard deviation of a reading that the \
               runs themselves show."
            .to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("sensor"),
            Column::numbers("speed", "rpm"),
            Column::words("in"),
            Column::numbers("now", ""),
            Column::numbers("at", "deg"),
            Column::numbers("after", ""),
            Column::numbers("at", "deg"),
            Column::numbers("scatter", ""),
            Column::numbers("limit", ""),
            Column::words("verdict"),
        ],
        rows: rows.collect(),
    }
}

fn influence_table(runs: &RunFindings) -> Table {
    let rows = runs.influence.iter().map(|influence| {
        // The response is that of the velocity, a quarter turn ahead of the displacement.
        let lag = (FRAC_PI_2 - influence.response.arg()).rem_euclid(TAU);
        vec![
            Cell::text(influence.plane.clone()),
            Cell::text(influence.sensor.clone()),
            rpm(influence.speed),
            Cell::text(unit(influence.quantity).0),
            amplitude(influence.quantity, influence.shown * REFERENCE),
            rotor_angle(lag, 0),
            influence.deviation.map_or(Cell::Empty, |deviation| Cell::Number {
                value: 100.0 * deviation / influence.response.norm(),
                decimals: 1,
            }),
        ]
    });
    Table {
        id: "influence",
        title: "Influence of 100 g mm".to_owned(),
        note: "The lag is the angle that the rotor turns from the passing of the heavy spot at the sensor to the peak of the \
               displacement: near 0 well below resonance, near 180 deg well above."
            .to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("plane"),
            Column::words("sensor"),
            Column::numbers("speed", "rpm"),
            Column::words("in"),
            Column::numbers("effect", ""),
            Column::numbers("lag", "deg"),
            Column::numbers("deviation", "%"),
        ],
        rows: rows.collect(),
    }
}

fn log_table(runs: &RunFindings) -> Table {
    let mut rows = Vec::new();
    for entry in &runs.log {
        let weights: Vec<String> = entry
            .weights
            .iter()
            .map(|(plane, unbalance)| {
                let angle = number::plain(rotor_degrees(unbalance.arg(), 0), 0);
                format!("{plane} {} g mm at {angle}", plain(1e6 * unbalance.norm(), 4))
            })
            .collect();
        for (index, sensor) in entry.sensors.iter().enumerate() {
            let first = index == 0;
            let quantity = sensor.measured.quantity;
            let mut row = vec![
                Cell::text(if first { entry.name.as_str() } else { "" }),
                if first { rpm(entry.speed) } else { Cell::Empty },
                Cell::text(sensor.sensor.clone()),
                Cell::text(unit(quantity).0),
            ];
            row.extend(shown(Some(sensor.measured)));
            row.extend(shown(sensor.predicted));
            row.push(sensor.missed.map_or(Cell::Empty, |missed| amplitude(quantity, missed)));
            row.push(Cell::text(if first { weights.join("; ") } else { String::new() }));
            rows.push(row);
        }
    }
    Table {
        id: "runs",
        title: "Runs, and what the runs before each predicted".to_owned(),
        note: "Weights are those on the rotor in the run, beyond its first state; angles in degrees on the rotor.".to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("run"),
            Column::numbers("speed", "rpm"),
            Column::words("sensor"),
            Column::words("in"),
            Column::numbers("measured", ""),
            Column::numbers("at", "deg"),
            Column::numbers("predicted", ""),
            Column::numbers("at", "deg"),
            Column::numbers("missed", ""),
            Column::words("weights"),
        ],
        rows,
    }
}
