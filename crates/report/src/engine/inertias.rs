//! The table of everything that turns: inertia, what it is at crankshaft 1, and where the number comes from.

use crate::kit::table::{Cell, Column, Table};
use lanchester_model::{InertiaSum, RotatingBody, RotatingKind};

/// Digits of an inertia in print.
const DIGITS: i32 = 4;

/// All rotating bodies with their sum, in kg mm^2. `throws` has crankshaft, index, mass [kg] and inertia [kg m^2] of what belongs to single throws, which is part of
/// the crankshafts' own numbers; `driveline` ratio and inertia [kg m^2] of what is behind springs, which is not in the sum.
pub fn inertia_table(
    bodies: &[RotatingBody],
    throws: &[(usize, usize, f64, f64)],
    driveline: &[(f64, f64)],
    sum: &InertiaSum,
) -> Table {
    let mut rows: Vec<[Cell; 6]> = Vec::new();
    let inertia = |value: f64| Cell::number(1e6 * value, DIGITS);
    for body in bodies {
        let origin = match body.inertia {
            Some(inertia) => inertia.origin.words().to_owned(),
            None => match body.kind {
                RotatingKind::Crankshaft(_) => format!("unknown: `{}` or [crank.body] gives it", body.key),
                _ => format!("unknown: `{}` gives it", body.key),
            },
        };
        rows.push([
            Cell::text(body.name.clone()),
            body.mass.map_or(Cell::Empty, |mass| Cell::number(mass.value, DIGITS)),
            body.inertia.map_or(Cell::Empty, |own| inertia(own.value)),
            Cell::number(body.ratio, DIGITS),
            body.referred().map_or(Cell::Empty, |own| inertia(own.value)),
            Cell::text(origin),
        ]);
        let is_own = |own: &&(usize, usize, f64, f64)| body.kind == RotatingKind::Crankshaft(own.0);
        for (_, throw, mass, own) in throws.iter().filter(is_own) {
            rows.push([
                Cell::text(format!("  of it throw {}", throw + 1)),
                Cell::number(*mass, DIGITS),
                inertia(*own),
                Cell::Empty,
                Cell::Empty,
                Cell::text("from its shape"),
            ]);
        }
    }
    for (index, (ratio, own)) in driveline.iter().enumerate() {
        rows.push([
            Cell::text(format!("driveline {}", index + 1)),
            Cell::Empty,
            inertia(*own),
            Cell::number(*ratio, DIGITS),
            Cell::Empty,
            Cell::text("given; behind a spring, not in the sum"),
        ]);
    }
    let missing = if sum.missing.is_empty() { "" } else { " (as far as known)" };
    let mut origins: Vec<&str> = Vec::new();
    for words in bodies.iter().filter_map(|body| Some(body.inertia?.origin.words())) {
        if !origins.contains(&words) {
            origins.push(words);
        }
    }
    let origin = if origins.is_empty() { "unknown".to_owned() } else { origins.join(" and ") };
    rows.push([
        Cell::text(format!("sum{missing}")),
        Cell::Empty,
        Cell::Empty,
        Cell::Empty,
        sum.origin.map_or(Cell::Empty, |_| inertia(sum.known)),
        Cell::text(origin),
    ]);
    let heads = [
        Column::words("body"),
        Column::numbers("mass", "kg"),
        Column::numbers("inertia", "kg mm²"),
        Column::numbers("ratio", ""),
        Column::numbers("at crankshaft 1", "kg mm²"),
        Column::words("origin"),
    ];
    let columns = heads.into_iter().enumerate().map(|(k, head)| {
        let cells = rows.iter().map(|row| row[k].clone()).collect();
        (head, cells)
    });
    Table::of_columns(
        "inertias",
        "Inertias of what turns",
        "Crankshafts without rods. At crankshaft 1: times the ratio squared.",
        columns.collect(),
    )
}
