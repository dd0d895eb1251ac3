//! Balance factors as tables.

use super::mass::{grams, percent};
use crate::kit::number;
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table, column_cells, own_cells};
use lanchester_workshop::{FactorAnswer, FactorEffect, FactorGiven, ThrowFactor};

/// Definitions, ellipses, and what one factor for all throws does.
pub fn factor_tables(answer: &FactorAnswer) -> Vec<Table> {
    let mut tables = vec![masses(answer), definitions(answer), ellipses(answer)];
    tables.extend(common(answer));
    tables
}

/// Balance factors for a terminal.
pub fn factor_text(answer: &FactorAnswer) -> String {
    let rpm = number::terminal(number::rpm(answer.speed), 0);
    let mut out =
        format!("{}: balance factors {}, forces at {rpm} rpm\n", answer.engine, given(answer.given));
    for table in factor_tables(answer) {
        out += "\n";
        out += &table.text();
    }
    if !answer.elsewhere.is_empty() {
        out += &format!(
            "\ncounterweights in the plane of no throw or web are left out: {}\n",
            answer.elsewhere.join(", ")
        );
    }
    out
}

fn given(given: FactorGiven) -> String {
    let share = |share: f64| format!("{} %", number::plain(100.0 * share, 1));
    match given {
        FactorGiven::AsBuilt => "with the counterweights of the file".to_owned(),
        FactorGiven::ReciprocatingShare(value) => format!("for {} of the reciprocating mass", share(value)),
        FactorGiven::WetReciprocatingShare(value) => {
            format!("for {} of the reciprocating mass, oil counted as rotating", share(value))
        }
        FactorGiven::TotalShare(value) => format!("for {} of rotating and reciprocating mass", share(value)),
        FactorGiven::Bobweight(mass) => format!("for a bobweight of {} g", number::plain(1e3 * mass, 1)),
        FactorGiven::BobweightShare(value) => {
            format!("for a bobweight of {} of all masses at the pin", share(value))
        }
        FactorGiven::Counterweight(unbalance) => {
            format!("for a counterweight of {} kg mm", number::plain(1e3 * unbalance, 3))
        }
        FactorGiven::AxisRatio(ratio) => {
            format!("for a residual {} times as large along the cylinders as across", number::plain(ratio, 3))
        }
        FactorGiven::LeastPeak => "for the smallest peak of the first-order force".to_owned(),
    }
}

fn throw_column(throws: &[ThrowFactor]) -> (Column, Vec<Cell>) {
    (Column::words("throw"), throws.iter().map(|t| Cell::text(t.throw.to_string())).collect())
}

fn masses(answer: &FactorAnswer) -> Table {
    let throws = &answer.throws;
    let unbalances = |of: &dyn Fn(&ThrowFactor) -> f64| own_cells(throws.iter().map(|t| 1e3 * of(t)), 5);
    let columns = vec![
        throw_column(throws),
        (
            Column::words("cylinders"),
            throws.iter().map(|t| Cell::text(number::list(&t.cylinders).replace('\u{2013}', "-"))).collect(),
        ),
        (Column::numbers("crank itself", "kg mm"), unbalances(&|t| t.masses.crank)),
        (Column::numbers("rotating R", "kg mm"), unbalances(&|t| t.masses.rotating_unbalance())),
        (Column::numbers("reciprocating P", "kg mm"), unbalances(&|t| t.masses.reciprocating_unbalance())),
        (Column::numbers("counterweight", "kg mm"), unbalances(&|t| t.counterweight.norm())),
        (
            Column::numbers("from the throw", "deg"),
            throws
                .iter()
                .map(|t| match t.counterweight.norm() > 0.0 {
                    true => Cell::Number { value: number::phase_degrees(t.counterweight.arg()), decimals: 1 },
                    false => Cell::Empty,
                })
                .collect(),
        ),
        (Column::numbers("opposite w", "kg mm"), unbalances(&|t| t.opposite)),
    ];
    Table::of_columns(
        "factor-masses",
        "Unbalance of each throw",
        "R: crank and big ends; P: pistons and small ends, times the crank radius; w: the counterweight's part opposite the throw.",
        columns,
    )
}

fn definitions(answer: &FactorAnswer) -> Table {
    let throws = &answer.throws;
    let shares =
        |of: &dyn Fn(&ThrowFactor) -> Option<f64>| throws.iter().map(|t| percent(of(t))).collect::<Vec<_>>();
    let mut columns = vec![
        throw_column(throws),
        (Column::numbers("of reciprocating", "%"), shares(&|t| t.reciprocating_share)),
    ];
    if throws.iter().any(|t| t.oil > 0.0) {
        columns.push((Column::numbers("wet", "%"), shares(&|t| t.wet_reciprocating_share)));
    }
    columns.extend([
        (Column::numbers("of total", "%"), shares(&|t| t.total_share)),
        (Column::numbers("bobweight", "g"), throws.iter().map(|t| grams(t.bobweight)).collect()),
        (Column::numbers("of all at the pin", "%"), shares(&|t| t.bobweight_share)),
        (Column::numbers("least peak at", "%"), shares(&|t| t.least_peak_share)),
    ]);
    Table::of_columns(
        "factor-definitions",
        "Balance factor by every definition",
        "Of reciprocating: (w - R) / P; of total: w / (R + P); bobweight: the mass at the pin that brings the crank to rest.",
        columns,
    )
}

fn ellipses(answer: &FactorAnswer) -> Table {
    let throws = &answer.throws;
    let size = throws
        .iter()
        .enumerate()
        .fold(0.0f64, |m, (k, t)| m.max(t.masses.reciprocating_unbalance() * answer.square(k)));
    let forces = |of: &dyn Fn(&ThrowFactor) -> f64| {
        column_cells(throws.iter().enumerate().map(|(k, t)| of(t) * answer.square(k)), 5, below(size))
    };
    let columns = vec![
        throw_column(throws),
        (Column::numbers("along", "N"), forces(&|t| t.along)),
        (Column::numbers("across", "N"), forces(&|t| t.across)),
        (Column::numbers("semi-major axis", "N"), forces(&|t| t.ellipse.major)),
        (Column::numbers("shorter", "N"), forces(&|t| t.ellipse.minor)),
        (
            Column::numbers("tilt", "deg"),
            throws
                .iter()
                .map(|t| match t.ellipse.minor < t.ellipse.major * (1.0 - 1e-9) {
                    true => Cell::Number { value: number::phase_degrees(t.ellipse.tilt), decimals: 1 },
                    false => Cell::Empty,
                })
                .collect(),
        ),
        (Column::words("turns"), throws.iter().map(|t| Cell::text(t.ellipse.sense.name())).collect()),
    ];
    Table::of_columns(
        "factor-ellipses",
        "Residual first-order force of each throw: along and across its cylinders, and its ellipse",
        "Tilt of the longer axis from +x; a circle has none.",
        columns,
    )
}

/// What one factor for all throws does to the whole engine.
fn common(answer: &FactorAnswer) -> Option<Table> {
    let mut rows = Vec::new();
    for (index, crankshaft) in answer.crankshafts.iter().enumerate() {
        for (name, effect) in [("force", &crankshaft.force), ("couple", &crankshaft.couple)] {
            let name = match answer.crankshafts.len() {
                1 => name.to_owned(),
                _ => format!("{name} of crankshaft {}", index + 1),
            };
            rows.push(effect_row(name, effect));
        }
    }
    let columns = vec![
        Column::words("first order"),
        Column::numbers("least peak at", "%"),
        Column::numbers("leaves", "% of P"),
        Column::numbers("one plane at", "%"),
        Column::words("swings"),
        Column::numbers("or at", "%"),
        Column::words("swings"),
    ];
    (!rows.is_empty()).then(|| Table {
        id: "factor-common",
        title: "One factor for all throws: what it does to the whole crankshaft".to_owned(),
        note: "Rotating masses balanced in every throw. Leaves: peak of the first order over that which the reciprocating masses would \
               have all at once."
            .to_owned(),
        remark: String::new(),
        columns,
        rows,
    })
}

fn effect_row(name: String, effect: &FactorEffect) -> Vec<Cell> {
    let mut row = vec![Cell::text(name)];
    match effect.least_peak() {
        Some(best) => {
            row.extend([percent(Some(best)), percent(Some(effect.peak(best) / effect.per_share.norm()))]);
        }
        None => row.extend([Cell::text("any"), Cell::Empty]),
    }
    match effect.one_plane() {
        Some(pair) => {
            for plane in pair {
                row.extend([percent(Some(plane.share)), Cell::text(swing(plane.direction))]);
            }
        }
        None => row.extend([Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty]),
    }
    row
}

/// Direction in which a force swings, or the plane in which a couple rocks.
pub(super) fn swing(direction: f64) -> String {
    match direction.to_degrees() {
        d if d.abs() < 0.05 => "along x".to_owned(),
        d if (d.abs() - 90.0).abs() < 0.05 => "along y".to_owned(),
        d => format!("at {} deg", number::plain(d, 1)),
    }
}
