//! Points of the block and gears of a simulated run.

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

/// Torques of gears, and forces of teeth where their pressure angle is given.
pub(super) fn gears_table(result: &SimulationResult) -> Option<Table> {
    let reactions = result.run.samples.reactions.get(result.last_period())?;
    if result.gears.is_empty() || reactions.is_empty() {
        return None;
    }
    let rows = result.gears.iter().enumerate().map(|(index, name)| {
        let own = || reactions.iter().filter_map(|all| all.rotors.get(index + 1));
        let [least, most] =
            [f64::min, f64::max].map(|pick| own().map(|r| r.gear_torque).reduce(pick).unwrap_or(0.0));
        let size = |force: [f64; 3]| force.iter().map(|part| part * part).sum::<f64>().sqrt();
        let force = own().map(|rotor| size(rotor.gear_force)).fold(0.0, f64::max);
        let bearings = own().map(|rotor| size(rotor.bearings.force)).fold(0.0, f64::max);
        vec![
            Cell::text(name),
            Cell::number(least, 4),
            Cell::number(most, 4),
            if force > 0.0 { Cell::number(force, 5) } else { Cell::text("-") },
            Cell::number(bearings, 5),
        ]
    });
    let columns = vec![
        words("shaft", ""),
        words("least torque", "N m"),
        words("largest torque", "N m"),
        words("force of its teeth", "N"),
        words("bearings together", "N"),
    ];
    let note = "Torque of gear or chain on the shaft. Teeth need their pressure angle: `mesh` of [simulation]; without, the bearings lack their force.";
    Some(table("simulated-gears", "Gears and shafts in the last period", note, columns, rows.collect()))
}
