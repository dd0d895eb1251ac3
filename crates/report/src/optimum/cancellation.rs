//! Exact cancellation in words and tables: what was to vanish, whether it does, and the proof.

use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::rounding::{below, clean};
use crate::kit::table::{Cell, Column, Table};
use lanchester_balance::{Answer, Cancellation, CancellationVerdict, CancelledOrder, Functional, OrderSense};
use lanchester_model::Engine;
use lanchester_task::{criterion_name, criterion_unit};

/// The verdict in a sentence or two.
pub(crate) fn cancellation_headline(engine: &Engine, answer: &Answer, cancellation: &Cancellation) -> String {
    let names: Vec<String> =
        cancellation.orders.iter().map(|o| criterion_name(&o.criterion, engine)).collect();
    let names = listed(&names);
    let verb = if cancellation.orders.len() == 1 { "vanishes" } else { "vanish" };
    match &cancellation.verdict {
        CancellationVerdict::Vanish { total, .. } if *total == 0.0 && answer.among_equals.is_empty() => {
            format!("{names} {verb} without any weight.")
        }
        CancellationVerdict::Vanish { total, least, is_mass, lightest }
            if !answer.among_equals.is_empty() =>
        {
            let (factor, unit) = total_unit(*is_mass);
            format!(
                "{names} {verb}. The weights have {} {unit} in all; the lightest that do it, whatever becomes of the rest, have {} {unit}, no others less than {} {unit}.",
                number::short(factor * total, 6),
                number::short(factor * least, 6),
                number::short(factor * lightest.value, 6)
            )
        }
        CancellationVerdict::Vanish { total, is_mass, lightest, .. } => {
            let (factor, unit) = total_unit(*is_mass);
            format!(
                "{names} {verb}. The lightest weights that do it have {} {unit} in all; no others have less than {} {unit}.",
                number::short(factor * total, 6),
                number::short(factor * lightest.value, 6)
            )
        }
        CancellationVerdict::CannotVanish { obstructions } => {
            let together = if cancellation.orders.len() == 1 { "" } else { " together" };
            let left: Vec<String> = cancellation
                .orders
                .iter()
                .map(|o| {
                    let unit = criterion_unit(&o.criterion);
                    let left = shown(engine, o, o.left);
                    format!("{} {} {unit}", criterion_name(&o.criterion, engine), number::short(left, 5))
                })
                .collect();
            let verdict = match obstructions.is_empty() {
                true => format!("Whether {names} can vanish{together} is open"),
                false => format!("{names} cannot vanish{together}"),
            };
            let reason = format!("{verdict}: {}", outcome_reason(answer));
            format!("{reason}. The weights below leave the least: {}.", left.join(", then "))
        }
    }
}

fn outcome_reason(answer: &Answer) -> &str {
    match &answer.outcome {
        lanchester_balance::Outcome::Stopped { reason, .. }
        | lanchester_balance::Outcome::CannotVanish { reason } => reason,
        _ => "",
    }
}

/// Every order: without the devices, with the answer, and the least that it could have alone.
pub fn cancelled_orders_table(engine: &Engine, cancellation: &Cancellation) -> Table {
    let orders = &cancellation.orders;
    let vanish = matches!(cancellation.verdict, CancellationVerdict::Vanish { .. });
    let cells = |of: fn(&CancelledOrder) -> f64| -> Vec<Cell> {
        orders
            .iter()
            .map(|o| {
                let decimals = number::decimals(o.without.max(o.left), 5);
                Cell::Number { value: shown(engine, o, of(o)), decimals }
            })
            .collect()
    };
    let mut columns = vec![
        (
            Column::words("order"),
            orders.iter().map(|o| Cell::text(criterion_name(&o.criterion, engine))).collect(),
        ),
        (Column::words("unit"), orders.iter().map(|o| Cell::text(criterion_unit(&o.criterion))).collect()),
        (Column::numbers("without", ""), cells(|o| o.without)),
        (Column::numbers("left", ""), cells(|o| o.left)),
    ];
    if !vanish {
        columns.push((Column::numbers("least alone", ""), cells(|o| o.least_alone)));
    }
    let remark = if vanish {
        "Recomputed from the engine with the weights fitted."
    } else {
        "Left: least of the first, then of the second, and so on; least alone: if nothing else is asked for."
    };
    Table::of_columns("cancelled-orders", "What had to vanish", remark, columns)
}

/// The combinations of orders that prove the verdict; `None` where nothing needs proof.
pub fn cancellation_proof_table(engine: &Engine, cancellation: &Cancellation) -> Option<Table> {
    let (functionals, remark): (Vec<(&Functional, f64, &str)>, String) = match &cancellation.verdict {
        CancellationVerdict::Vanish { is_mass, lightest, .. } => {
            let (factor, unit) = total_unit(*is_mass);
            let remark = format!(
                "The shares add up to {} {unit}; no weight brings more of it than its own amount.",
                number::short(factor * lightest.value, 6)
            );
            (vec![(lightest, factor, unit)], remark)
        }
        CancellationVerdict::CannotVanish { obstructions } => (
            obstructions.iter().map(|o| (&o.functional, 1.0, "")).collect(),
            "The shares of each sum add up to 1, and no amount of any device changes that.".to_owned(),
        ),
    };
    let mut rows: Vec<[Cell; 6]> = Vec::new();
    let several = functionals.len() > 1;
    for (index, (functional, factor, unit)) in functionals.iter().enumerate() {
        let number = if several { format!("{}", index + 1) } else { String::new() };
        for term in &functional.terms {
            let load_unit = criterion_unit(&term.criterion);
            let per =
                if unit.is_empty() { format!("1/({load_unit})") } else { format!("{unit}/({load_unit})") };
            let share = -(term.factor.conj() * term.amount).re * factor;
            rows.push([
                Cell::text(number.clone()),
                Cell::text(format!("{}{}", criterion_name(&term.criterion, engine), sense_words(term.sense))),
                Cell::text(format!("{} {per}", number::short(term.factor.norm() * factor, 5))),
                Cell::Number { value: number::phase_degrees(term.factor.arg()), decimals: 2 },
                Cell::text(format!("{} {load_unit}", number::short(term.amount.norm(), 5))),
                Cell::number(share, 5),
            ]);
        }
        for (name, charge) in &functional.charges {
            rows.push([
                Cell::text(number.clone()),
                Cell::text(format!("`{name}` at its largest")),
                Cell::Empty,
                Cell::Empty,
                Cell::Empty,
                Cell::number(-charge * factor, 5),
            ]);
        }
    }
    if rows.is_empty() {
        return None;
    }
    let unit = functionals[0].2;
    let mut columns = vec![
        Column::words("sum"),
        Column::words("part"),
        Column::words("factor"),
        Column::numbers("turned", "deg"),
        Column::words("without devices"),
        Column::numbers("share", unit),
    ];
    if !several {
        columns.remove(0);
    }
    let columns = columns
        .into_iter()
        .enumerate()
        .map(|(place, column)| {
            let place = if several { place } else { place + 1 };
            (column, rows.iter().map(|row| row[place].clone()).collect())
        })
        .collect();
    let mut table = Table::of_columns("cancellation-proof", "The proof", "", columns);
    table.remark = remark;
    Some(table)
}

/// A value of an order, or 0 where it is rounding beside that order without the devices, or beside all moving masses.
fn shown(engine: &Engine, order: &CancelledOrder, value: f64) -> f64 {
    let masses = Magnitude::of_masses(engine).noise_of_unit(criterion_unit(&order.criterion));
    clean(value, masses.max(below(order.without)))
}

fn total_unit(is_mass: bool) -> (f64, &'static str) {
    if is_mass { (1e3, "g") } else { (1e6, "g mm") }
}

fn sense_words(sense: OrderSense) -> &'static str {
    match sense {
        OrderSense::Forward => ", with the crank",
        OrderSense::Backward => ", against the crank",
        OrderSense::Alternating => "",
    }
}

/// `a`, `a and b`, `a, b and c`.
fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
