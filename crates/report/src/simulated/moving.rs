//! Points of the block, gears and driveline of a simulated run.

use crate::kit::number;
use crate::kit::table::{Cell, Table};
use crate::simulated::columns::{table, words};
use crate::simulated::result::SimulationResult;

/// Motion of the points of the block that were asked for, where it moves.
pub(super) fn points_table(result: &SimulationResult) -> Option<Table> {
    let range = result.last_period();
    let rows: Vec<Vec<Cell>> = result
        .points
        .iter()
        .filter_map(|point| {
            Some((point, point.displacement.get(range.clone()).filter(|all| !all.is_empty())?))
        })
        .map(|(point, all)| {
            let span = |k: usize| {
                let most = all.iter().map(|at| at[k]).fold(f64::NEG_INFINITY, f64::max);
                let least = all.iter().map(|at| at[k]).fold(f64::INFINITY, f64::min);
                most - least
            };
            let size = |at: &[f64; 3]| at.iter().map(|part| part * part).sum::<f64>().sqrt();
            let largest = all.iter().map(size).fold(0.0, f64::max);
            let mut row = vec![Cell::text(&point.name)];
            row.extend(point.at.iter().map(|place| Cell::number(1e3 * place, 5)));
            row.extend((0..3).map(|k| Cell::number(1e3 * span(k), 4)));
            row.push(Cell::number(1e3 * largest, 4));
            row
        })
        .collect();
    let mut columns = vec![words("point", "")];
    columns.extend(["x", "y", "z"].map(|axis| words(axis, "mm")));
    columns.extend(["span along x", "span along y", "span along z", "largest"].map(|head| words(head, "mm")));
    let note =
        "Spans of the paths, and the largest displacement from where the point is with the block as drawn.";
    (!rows.is_empty())
        .then(|| table("simulated-points", "Points of the block in the last period", note, columns, rows))
}

/// Torques of gears, forces of teeth where their pressure angle is given, and what the bearings carry together.
pub(super) fn gears_table(result: &SimulationResult) -> Option<Table> {
    let rotors = result.period.extremes.rotors.get(1..)?;
    if result.gears.is_empty() || rotors.is_empty() {
        return None;
    }
    let rows = result.gears.iter().zip(rotors).map(|(name, rotor)| {
        let force = rotor.gear_force.value;
        vec![
            Cell::text(name),
            Cell::number(rotor.gear_torque.least.value, 4),
            Cell::number(rotor.gear_torque.most.value, 4),
            if force > 0.0 { Cell::number(force, 5) } else { Cell::text("-") },
            Cell::number(rotor.bearing_force.value, 5),
            Cell::number(rotor.bearing_moment.value, 5),
        ]
    });
    let columns = vec![
        words("shaft", ""),
        words("least torque", "N m"),
        words("largest torque", "N m"),
        words("force of its teeth", "N"),
        words("bearings together", "N"),
        words("their moment", "N m"),
    ];
    let note = "Torque of gear or chain on the shaft. Bearings: sum of their forces, and their moment across the axis about the origin, which is the couple of a shaft whose forces cancel. \
                Teeth need their pressure angle: `mesh` of [simulation]; without, the bearings lack their force.";
    Some(table("simulated-gears", "Gears and shafts in the last period", note, columns, rows.collect()))
}

/// The driveline: twist and torque of its springs, speeds of its inertias.
pub(super) fn driveline_table(result: &SimulationResult) -> Option<Table> {
    let samples = &result.run.samples;
    let range = result.last_period();
    let springs = samples.driveline_springs.get(range.clone())?;
    let links = samples.driveline.get(range)?;
    let bounds = |values: &dyn Fn(usize) -> f64| {
        (0..springs.len())
            .map(values)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    };
    let torques = &result.period.extremes.driveline;
    let rows = torques.iter().enumerate().map(|(index, torque)| {
        let [least, most] = bounds(&|k| springs[k][index][0].to_degrees());
        let [slowest, fastest] = bounds(&|k| number::rpm(links[k][index][1]));
        vec![
            Cell::text(format!("{}", index + 1)),
            Cell::number(least, 5),
            Cell::number(most, 5),
            Cell::number(torque.least.value, 5),
            Cell::number(torque.most.value, 5),
            Cell::number(slowest, 6),
            Cell::number(fastest, 6),
        ]
    });
    let columns = vec![
        words("inertia", ""),
        words("least twist", "deg"),
        words("largest twist", "deg"),
        words("least torque", "N m"),
        words("largest torque", "N m"),
        words("lowest speed", "rpm"),
        words("highest speed", "rpm"),
    ];
    let note = "Twist and torque of the spring before each inertia, its damper included, positive where it drives the inertia; 0 where the clutch is open.";
    let rows: Vec<Vec<Cell>> = rows.collect();
    (!rows.is_empty() && !springs.is_empty())
        .then(|| table("simulated-driveline", "Driveline in the last period", note, columns, rows))
}
