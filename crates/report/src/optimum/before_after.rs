//! What an answer does, every quantity once: its criteria and what else its weights change, as one table.

use crate::kit::number;
use crate::kit::rounding::clean;
use crate::kit::table::{Cell, Column, Table};
use crate::optimum::consequence_tables::{part_name, shown};
use crate::optimum::effect_noise::effect_noise;
use crate::optimum::tables::{effects_table, factor, shown_unit};
use lanchester_balance::{Affected, AffectedPart, Answer, Change, Consequence, Consequences, Effect};
use lanchester_model::Engine;
use lanchester_task::{Criterion, Load, Mains, criterion_name};

/// Digits of the largest number of a row.
const DIGITS: i32 = 5;

/// Smallest share of a row's numbers that is a change.
const CHANGE: f64 = 1e-6;

/// A row of the table, in the unit that is shown.
struct Row {
    quantity: String,
    at: String,
    unit: &'static str,
    /// Without the free weights, where that is known.
    without: Option<f64>,
    before: f64,
    after: f64,
    change: Change,
    /// Whether a change in per cent says something.
    in_shares: bool,
}

/// One table of what the answer does: the criteria first, then what its weights change beside them. Without `consequences` the
/// criteria alone; none where no answer was found.
pub(crate) fn before_and_after_table(
    engine: &Engine,
    answer: &Answer,
    consequences: Option<&Consequences>,
) -> Option<Table> {
    let Some(consequences) = consequences else {
        return (!answer.effects.is_empty()).then(|| effects_table(engine, answer));
    };
    let mut told: Vec<usize> = Vec::new();
    let mut rows: Vec<Row> = Vec::new();
    for effect in &answer.effects {
        let same = place_of(engine, answer, consequences, &effect.criterion);
        told.extend(same);
        rows.push(effect_row(engine, answer, effect, same.map(|place| &consequences.rows[place])));
    }
    let several = consequences.bending.len() > 1;
    let others = consequences.rows.iter().enumerate().filter(|(place, _)| !told.contains(place));
    let others: Vec<&Consequence> = others.map(|(_, row)| row).collect();
    let all = others.len();
    let shown_rows: Vec<&Consequence> =
        others.into_iter().filter(|row| row.before != 0.0 || row.after != 0.0).collect();
    let omitted = shown_rows.len() < all;
    rows.extend(shown_rows.into_iter().map(|row| consequence_row(engine, row, several)));
    let rpm = number::terminal(number::rpm(consequences.speed), 0);
    let mut table = Table::of_columns(
        "before-and-after",
        "Before and after",
        format!(
            "Inertia at {rpm} rpm and peaks over the continuous cycle, unless the name says otherwise; without: without the free weights. \
             Main bearings throw by throw; bending of the crankshaft as a free beam under what turns with it. Balance rate: share \
             of the rotating unbalance between two main bearings that the counterweights there answer; worse is farther from 100 %."
        ),
        columns(&rows),
    );
    if omitted {
        table.remark = "All-zero rows omitted.".to_owned();
    }
    Some(table)
}

/// Quantities of the whole engine, for a first page.
const IN_SHORT: [&str; 8] = [
    "force",
    "couple",
    "roll moment",
    "mount force",
    "main-bearing load",
    "bending moment",
    "counterweight mass",
    "balance-shaft unbalance",
];

/// The same of the engine as a whole alone: force, couple, roll moment, mounts, the most loaded main bearing, bending, and
/// what the weights come to.
pub fn before_and_after_in_short(
    engine: &Engine,
    answer: &Answer,
    consequences: Option<&Consequences>,
) -> Option<Table> {
    let mut table = before_and_after_table(engine, answer, consequences)?;
    table.id = "summary-before-and-after";
    table.note =
        "Inertia at the highest speed, peaks over the cycle, unless the name says otherwise.".to_owned();
    table.remark = String::new();
    table.rows.retain(|row| {
        let quantity = matches!(&row[0], Cell::Text(name) if IN_SHORT.contains(&name.as_str()));
        let engine = !matches!(&row[1], Cell::Text(at) if at.starts_with("main "));
        let nothing = row.iter().all(|cell| !matches!(cell, Cell::Number { value, .. } if *value != 0.0));
        quantity && engine && !nothing
    });
    (!table.rows.is_empty()).then_some(table)
}

fn columns(rows: &[Row]) -> Vec<(Column, Vec<Cell>)> {
    let decimals = |row: &Row| {
        let largest = row.without.unwrap_or(0.0).abs().max(row.before.abs()).max(row.after.abs());
        number::decimals(largest, DIGITS)
    };
    let cells = |of: fn(&Row) -> Option<f64>| -> Vec<Cell> {
        let cell =
            |row: &Row| of(row).map_or(Cell::Empty, |value| Cell::Number { value, decimals: decimals(row) });
        rows.iter().map(cell).collect()
    };
    let change = |row: &Row| match row.before {
        0.0 => Cell::Empty,
        _ if !row.in_shares => Cell::Empty,
        before => Cell::Number { value: 100.0 * (row.after / before - 1.0), decimals: 1 },
    };
    let mark = |row: &Row| match row.change {
        Change::Worse => Cell::text("worse"),
        Change::Better => Cell::text("better"),
        Change::Unchanged => Cell::Empty,
    };
    vec![
        (Column::words("quantity"), rows.iter().map(|row| Cell::text(&row.quantity)).collect()),
        (Column::words("at"), rows.iter().map(|row| Cell::text(&row.at)).collect()),
        (Column::words("unit"), rows.iter().map(|row| Cell::text(row.unit)).collect()),
        (Column::numbers("without", ""), cells(|row| row.without)),
        (Column::numbers("before", ""), cells(|row| Some(row.before))),
        (Column::numbers("after", ""), cells(|row| Some(row.after))),
        (Column::numbers("change", "%"), rows.iter().map(change).collect()),
        (Column::words("mark"), rows.iter().map(mark).collect()),
    ]
}

/// The consequence that says the same as a criterion, if there is one.
fn place_of(
    engine: &Engine,
    answer: &Answer,
    consequences: &Consequences,
    criterion: &Criterion,
) -> Option<usize> {
    let number = |quantity: Affected, number: usize| {
        let own = consequences.rows.iter().enumerate().filter(|(_, row)| row.quantity == quantity);
        own.map(|(place, _)| place).nth(number)
    };
    let over_the_range = answer.task.speeds.is_empty() || !engine.is_on_springs();
    match criterion {
        Criterion::Peak(Load::Force) => number(Affected::Force, 0),
        Criterion::Peak(Load::Couple) => number(Affected::Couple, 0),
        Criterion::Peak(Load::RollMoment) => number(Affected::RollMoment, 0),
        Criterion::Peak(Load::LargestMountForce) if over_the_range => number(Affected::MountForce, 0),
        Criterion::Peak(Load::MainLoad(main)) => number(Affected::MainLoadPeak, *main),
        Criterion::MainRms(Mains::One(main)) => number(Affected::MainLoadRms, *main),
        Criterion::Peak(Load::BendingMoment) => consequences.rows.iter().position(|row| {
            row.quantity == Affected::BendingMoment && row.part == AffectedPart::Crankshaft { crankshaft: 1 }
        }),
        _ => None,
    }
}

fn effect_row(engine: &Engine, answer: &Answer, effect: &Effect, same: Option<&Consequence>) -> Row {
    let noise = effect_noise(engine, &answer.effects, &effect.criterion);
    let factor = factor(&effect.criterion);
    let cleaned = |value: f64| factor * clean(value, noise);
    let [before, after] = [effect.before, effect.after].map(cleaned);
    let rise = after - before;
    let change = match rise {
        _ if rise.abs() <= CHANGE * before.abs().max(after.abs()) => Change::Unchanged,
        rise if rise > 0.0 => Change::Worse,
        _ => Change::Better,
    };
    let at = match effect.criterion {
        Criterion::Peak(Load::LargestMainLoad) => "largest",
        Criterion::MainRms(Mains::All) => "all together",
        Criterion::Peak(load) | Criterion::Order(load, _)
            if load.is_at_mounts() && engine.is_on_springs() && !answer.task.speeds.is_empty() =>
        {
            "given speeds"
        }
        _ => "",
    };
    Row {
        quantity: criterion_name(&effect.criterion, engine),
        at: at.to_owned(),
        unit: shown_unit(&effect.criterion),
        without: Some(cleaned(effect.without)),
        before,
        after,
        change: same.map_or(change, |row| row.change),
        in_shares: true,
    }
}

fn consequence_row(engine: &Engine, row: &Consequence, several: bool) -> Row {
    let (factor, unit) = shown(row.quantity);
    let at = match row.quantity {
        Affected::MountForce if engine.is_on_springs() => "all speeds".to_owned(),
        _ => part_name(&row.part, several),
    };
    Row {
        quantity: row.quantity.name().to_owned(),
        at,
        unit,
        without: None,
        before: factor * row.before,
        after: factor * row.after,
        change: row.change,
        // A balance rate is a share already.
        in_shares: row.quantity != Affected::BalanceRate,
    }
}
