//! Tables of the engine itself: masses, geometry and unbalances.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, own_cells};
use lanchester_model::{Engine, RodJoint, RodMassRule, Strokes};
use std::f64::consts::TAU;

/// The engine at a glance: name and value, for the head of a report.
pub fn main_data(engine: &Engine, speed: f64) -> Vec<(&'static str, String)> {
    let mut data = vec![("cylinders", engine.cylinders.len().to_string())];
    let cycle = match engine.strokes {
        Strokes::Two => "two-stroke",
        Strokes::Four => "four-stroke",
    };
    data.push(("cycle", cycle.to_owned()));
    let bores: Vec<f64> = engine.cylinders.iter().filter_map(|c| c.bore).collect();
    if bores.len() == engine.cylinders.len() {
        data.push(("bore", span(&bores, 1e3, "mm")));
    }
    let radius = |c: &lanchester_model::Cylinder| engine.throws[c.throw].radius;
    let strokes: Vec<f64> = engine.cylinders.iter().map(|c| 2.0 * radius(c)).collect();
    data.push(("crank stroke", span(&strokes, 1e3, "mm")));
    if bores.len() == engine.cylinders.len() {
        let swept: f64 = bores.iter().zip(&strokes).map(|(b, s)| 0.125 * TAU * b * b * s).sum();
        data.push(("displacement", format!("{} cm³", number::short(1e6 * swept, 4))));
    }
    let rods: Vec<f64> = engine.cylinders.iter().map(|c| c.rod.length).collect();
    data.push(("rod length", span(&rods, 1e3, "mm")));
    let ratios: Vec<f64> = engine.cylinders.iter().map(|c| radius(c) / c.rod.length).collect();
    data.push(("rod ratio r/l", span_digits(&ratios, 1.0, "", 3)));
    let reciprocating: Vec<f64> =
        engine.cylinders.iter().map(lanchester_model::Cylinder::reciprocating_mass).collect();
    data.push(("reciprocating mass", span(&reciprocating, 1.0, "kg")));
    if let Some(order) = firing_order(engine) {
        data.push(("firing order", order));
    }
    data.push(("speed", format!("{} rpm", number::short(number::rpm(speed), 4))));
    data
}

/// Cylinders in the order in which they fire: "1–3–4–2"; those that fire together are joined by +.
pub fn firing_order(engine: &Engine) -> Option<String> {
    let mut firing: Vec<(f64, usize)> = Vec::with_capacity(engine.cylinders.len());
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        firing.push((cylinder.firing_angle?, index + 1));
    }
    let first = firing.first()?.0;
    for entry in &mut firing {
        // A hair below the cycle is 0: cylinder 1 leads even after rounding.
        entry.0 = (entry.0 - first + 1e-6).rem_euclid(engine.working_cycle(entry.1 - 1));
    }
    firing.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut out = String::new();
    for (k, (angle, number)) in firing.iter().enumerate() {
        if k > 0 {
            out.push_str(if angle - firing[k - 1].0 < 1e-3 { "+" } else { "\u{2013}" });
        }
        out.push_str(&number.to_string());
    }
    Some(out)
}

/// Masses and geometry of every cylinder.
pub fn masses_table(engine: &Engine) -> Table {
    let cylinders = &engine.cylinders;
    let grams = |f: &dyn Fn(usize) -> f64| own_cells((0..cylinders.len()).map(|k| 1e3 * f(k)), 4);
    let lengths = |f: &dyn Fn(usize) -> f64| own_cells((0..cylinders.len()).map(|k| 1e3 * f(k)), 4);
    let rule = |k: usize| match (cylinders[k].rod.joint, cylinders[k].rod.mass_rule) {
        (RodJoint::Articulated { master, .. }, _) => format!("articulated on {}", master + 1),
        (_, RodMassRule::Thirds) => "thirds".to_owned(),
        (_, RodMassRule::WeighedEnds) => "weighed ends".to_owned(),
        (_, RodMassRule::CentreOfGravity) => "centre of gravity".to_owned(),
    };
    let mut columns = vec![
        (
            Column::numbers("cylinder", ""),
            (1..=cylinders.len()).map(|n| Cell::Number { value: n as f64, decimals: 0 }).collect(),
        ),
        (
            Column::numbers("throw", ""),
            cylinders.iter().map(|c| Cell::Number { value: (c.throw + 1) as f64, decimals: 0 }).collect(),
        ),
        (
            Column::numbers("axis", "deg"),
            cylinders
                .iter()
                .map(|c| Cell::Number { value: number::phase_degrees(c.angle), decimals: 1 })
                .collect(),
        ),
        (Column::numbers("z", "mm"), lengths(&|k| cylinders[k].z)),
        (Column::numbers("piston", "g"), grams(&|k| cylinders[k].piston_mass)),
        (Column::numbers("rod, small end", "g"), grams(&|k| cylinders[k].rod.small_end_mass)),
        (Column::numbers("reciprocating", "g"), grams(&|k| cylinders[k].reciprocating_mass())),
        (Column::numbers("rod, big end", "g"), grams(&|k| cylinders[k].rod.big_end_mass)),
        (Column::numbers("rod length", "mm"), lengths(&|k| cylinders[k].rod.length)),
    ];
    if cylinders.iter().any(|c| c.net_offset() != 0.0) {
        columns.push((Column::numbers("net offset", "mm"), lengths(&|k| cylinders[k].net_offset())));
    }
    columns.push((Column::words("rod mass by"), (0..cylinders.len()).map(|k| Cell::text(rule(k))).collect()));
    Table::of_columns(
        "masses",
        "Cylinders",
        "The reciprocating mass is the piston with its pin and the rod's small end.",
        columns,
    )
}

/// Unbalance of every throw, and the counterweights that stand against it.
pub fn throws_table(engine: &Engine) -> Table {
    let throws = &engine.throws;
    let unbalances = |f: &dyn Fn(usize) -> f64| own_cells((0..throws.len()).map(|k| 1e6 * f(k)), 5);
    let mut columns = vec![
        (
            Column::numbers("throw", ""),
            (1..=throws.len()).map(|n| Cell::Number { value: n as f64, decimals: 0 }).collect(),
        ),
        (
            Column::numbers("angle", "deg"),
            throws
                .iter()
                .map(|t| Cell::Number { value: number::phase_degrees(t.angle), decimals: 1 })
                .collect(),
        ),
        (Column::numbers("z", "mm"), own_cells(throws.iter().map(|t| 1e3 * t.z), 4)),
        (Column::numbers("radius", "mm"), own_cells(throws.iter().map(|t| 1e3 * t.radius), 4)),
        (Column::numbers("crank", "g mm"), unbalances(&|k| throws[k].unbalance)),
        (Column::numbers("rod big ends", "g mm"), unbalances(&|k| engine.rod_unbalance(k))),
        (Column::numbers("together", "g mm"), unbalances(&|k| throws[k].unbalance + engine.rod_unbalance(k))),
    ];
    if engine.crankshafts.len() > 1 {
        let names = throws.iter().map(|t| Cell::text(&engine.crankshafts[t.crankshaft].name)).collect();
        columns.insert(1, (Column::words("crankshaft"), names));
    }
    Table::of_columns(
        "throws",
        "Throws",
        "Unbalance (mass times radius) along the throw, before counterweights.",
        columns,
    )
}

/// Counterweights and the weights of balance shafts; `None` without any.
pub fn weights_table(engine: &Engine) -> Option<Table> {
    let mut rows: Vec<(String, String, f64, f64, f64)> = Vec::new();
    for weight in &engine.counterweights {
        let crankshaft = &engine.crankshafts[weight.crankshaft];
        rows.push((
            weight.name.clone(),
            crankshaft.ratio.to_string(),
            weight.z,
            weight.unbalance,
            weight.angle,
        ));
    }
    for shaft in &engine.shafts {
        for weight in &shaft.weights {
            rows.push((
                shaft.name.clone(),
                shaft.ratio.to_string(),
                weight.z,
                weight.unbalance,
                weight.phase,
            ));
        }
    }
    if rows.is_empty() {
        return None;
    }
    Some(Table::of_columns(
        "weights",
        "Counterweights and balance shafts",
        "Speed over that of the crank, negative against it; directions at θ = 0 on their own shaft.",
        vec![
            (Column::words("weight"), rows.iter().map(|r| Cell::text(&r.0)).collect()),
            (
                Column::numbers("speed ratio", ""),
                rows.iter().map(|r| Cell::text(r.1.replace('-', "\u{2212}"))).collect(),
            ),
            (Column::numbers("z", "mm"), own_cells(rows.iter().map(|r| 1e3 * r.2), 4)),
            (Column::numbers("unbalance", "g mm"), own_cells(rows.iter().map(|r| 1e6 * r.3), 5)),
            (
                Column::numbers("direction", "deg"),
                rows.iter()
                    .map(|r| Cell::Number { value: number::phase_degrees(r.4), decimals: 1 })
                    .collect(),
            ),
        ],
    ))
}

/// One value, or the range if they differ.
fn span(values: &[f64], factor: f64, unit: &str) -> String {
    span_digits(values, factor, unit, 4)
}

fn span_digits(values: &[f64], factor: f64, unit: &str, digits: i32) -> String {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min) * factor;
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) * factor;
    let (low, high) = (number::trimmed(low, digits), number::trimmed(high, digits));
    let range = if low == high { low } else { format!("{low} to {high}") };
    if unit.is_empty() { range } else { format!("{range} {unit}") }
}
