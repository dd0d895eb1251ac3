//! What other weights do to the engine, as a table.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table};
use lanchester_balance::{Affected, AffectedPart, Change, Consequence, Consequences};

/// Digits of the larger one of a row.
const DIGITS: i32 = 4;

/// Every quantity before and after, marked where it got worse.
pub fn consequences_table(consequences: &Consequences) -> Table {
    let several = consequences.bending.len() > 1;
    let rows: Vec<&Consequence> =
        consequences.rows.iter().filter(|row| row.before != 0.0 || row.after != 0.0).collect();
    let cells = |of: fn(&Consequence) -> f64| -> Vec<Cell> {
        let cell = |row: &&Consequence| {
            let factor = shown(row.quantity).0;
            let decimals = number::decimals(factor * row.before.abs().max(row.after.abs()), DIGITS);
            Cell::Number { value: factor * of(row), decimals }
        };
        rows.iter().map(cell).collect()
    };
    // A balance rate is a share already.
    let change = |row: &&Consequence| match (row.quantity, row.before) {
        (Affected::BalanceRate, _) | (_, 0.0) => Cell::Empty,
        (_, before) => Cell::Number { value: 100.0 * (row.after / before - 1.0), decimals: 1 },
    };
    let mark = |row: &&Consequence| match row.change {
        Change::Worse => Cell::text("worse"),
        Change::Better => Cell::text("better"),
        Change::Unchanged => Cell::Empty,
    };
    let rpm = number::terminal(number::rpm(consequences.speed), 0);
    let mut table = Table::of_columns(
        "consequences",
        "Before and after",
        format!(
            "Inertia at {rpm} rpm, peaks over the continuous cycle. Main bearings throw by throw; bending of the crankshaft as a \
             free beam under what turns with it. Balance rate: share of the rotating unbalance between two main bearings that the \
             counterweights there answer; worse is farther from 100 %."
        ),
        vec![
            (Column::words("quantity"), rows.iter().map(|row| Cell::text(row.quantity.name())).collect()),
            (Column::words("at"), rows.iter().map(|row| Cell::text(part_name(&row.part, several))).collect()),
            (Column::words("unit"), rows.iter().map(|row| Cell::text(shown(row.quantity).1)).collect()),
            (Column::numbers("before", ""), cells(|row| row.before)),
            (Column::numbers("after", ""), cells(|row| row.after)),
            (Column::numbers("change", "%"), rows.iter().map(change).collect()),
            (Column::words("mark"), rows.iter().map(mark).collect()),
        ],
    );
    if rows.len() < consequences.rows.len() {
        table.remark = "All-zero rows omitted.".to_owned();
    }
    table
}

/// Factor and unit in which a quantity is shown.
pub(crate) fn shown(quantity: Affected) -> (f64, &'static str) {
    match quantity.unit() {
        "kg m" => (1e6, "g mm"),
        "kg" => (1e3, "g"),
        "1" => (100.0, "%"),
        unit => (1.0, unit),
    }
}

/// "main 3", "bay 2-3", nothing for the whole engine; with the crankshaft where there are several.
pub(crate) fn part_name(part: &AffectedPart, several: bool) -> String {
    let (crankshaft, name) = match *part {
        AffectedPart::Engine => return String::new(),
        AffectedPart::Crankshaft { crankshaft } => (crankshaft, String::new()),
        AffectedPart::Main { crankshaft, main, .. } => (crankshaft, format!("main {main}")),
        AffectedPart::Bay { crankshaft, bay, .. } => (crankshaft, format!("mains {bay}\u{2013}{}", bay + 1)),
    };
    match (several, name.is_empty()) {
        (false, _) => name,
        (true, true) => format!("crankshaft {crankshaft}"),
        (true, false) => format!("crankshaft {crankshaft}, {name}"),
    }
}
