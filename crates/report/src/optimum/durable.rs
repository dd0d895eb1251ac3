//! Films and safeties before, at the optimum and after a search for them.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, words};
use lanchester_balance::{Durable, DurableEnd, StopCause};
use lanchester_model::Engine;
use lanchester_task::Measured;

/// Digits of a number.
const DIGITS: i32 = 4;

/// Films and safeties that are known, before, at the optimum and after.
pub fn durability_table(durable: &Durable) -> Table {
    let known = |row: &&lanchester_balance::DurableRow| {
        [&row.before, &row.optimum, &row.after].iter().any(|one| one.value().is_some())
    };
    let rows: Vec<_> = durable.rows.iter().filter(known).collect();
    let shown = |unit: &str| if unit == "m" { (1e6, "um") } else { (1.0, "") };
    let cell = |measured: &Measured, unit: &str| match measured.value() {
        Some(value) => {
            let value = shown(unit).0 * value;
            Cell::Number { value, decimals: number::decimals(value, DIGITS) }
        }
        None => Cell::Empty,
    };
    let place = |measured: &Measured| match measured {
        Measured::Known { place, speed, .. } => {
            format!("{place}, {} rpm", number::terminal(number::rpm(*speed), 0))
        }
        Measured::Unknown(_) => String::new(),
    };
    let mut columns = vec![
        words("film or safety", rows.iter().map(|row| row.name.clone())),
        words("unit", rows.iter().map(|row| shown(&row.unit).1.to_owned())),
        (Column::numbers("before", ""), rows.iter().map(|row| cell(&row.before, &row.unit)).collect()),
        (Column::numbers("optimum", ""), rows.iter().map(|row| cell(&row.optimum, &row.unit)).collect()),
    ];
    if durable.is_moved() {
        columns.push((
            Column::numbers("searched", ""),
            rows.iter().map(|row| cell(&row.after, &row.unit)).collect(),
        ));
    }
    columns.push(words("smallest at", rows.iter().map(|row| place(&row.after))));
    let note = "Smallest over the cycle and the speeds that are judged: films quasi-static, by tables, under the loads of gas and inertia. Place and speed are those of the last number; at which speed others are smallest may differ. Safety \
                after UR M53 of fillets and oil bores, with the torsional vibration of the engine's chain. Weights on a crankshaft do not change the film of a crankpin, and \
                the safety after UR M53, which leaves mean stresses out, by their inertia alone.";
    let left_out = rows.iter().find_map(|row| match &row.after {
        Measured::Known { left_out, .. } if !left_out.is_empty() => {
            Some(format!(" {} leaves out {left_out}.", row.name))
        }
        _ => None,
    });
    Table::of_columns(
        "durability",
        "Films and safeties",
        note.to_owned() + &left_out.unwrap_or_default(),
        columns,
    )
}

/// Which weights are told and written where a search moved them; empty where none did.
pub fn moved_words(durable: &Durable) -> &'static str {
    match durable.is_moved() {
        true => {
            "That is the proved optimum. For films and safeties a local search then moved its weights: the weights, what they do and what is written are those \
             of the search."
        }
        false => "",
    }
}

/// The weights of a search; `None` where none was moved.
pub fn durable_weights_table(engine: &Engine, durable: &Durable) -> Option<Table> {
    if !durable.is_moved() {
        return None;
    }
    let used: Vec<_> = durable.weights.iter().filter(|weight| weight.used).collect();
    let number = |value: f64| Cell::Number { value, decimals: number::decimals(value, DIGITS) };
    let columns = vec![
        words("weight", used.iter().map(|weight| weight.name.clone())),
        (Column::numbers("z", "mm"), used.iter().map(|weight| number(1e3 * weight.z)).collect()),
        (
            Column::numbers("unbalance", "g mm"),
            used.iter().map(|weight| number(1e6 * weight.unbalance.norm())).collect(),
        ),
        (
            Column::numbers("direction", "deg"),
            used.iter()
                .map(|weight| Cell::Number { value: weight.unbalance.arg().to_degrees(), decimals: 2 })
                .collect(),
        ),
    ];
    let note = format!(
        "Found by a local search of {} engines from the proved optimum of {}: the best of what was tried, not a global optimum.",
        durable.evaluations, engine.name
    );
    Some(Table::of_columns("durable-weights", "Weights of the search", note, columns))
}

/// How the search ended, and which limits hold.
pub fn durability_words(durable: &Durable) -> String {
    let stages: Vec<String> = durable
        .stages
        .iter()
        .enumerate()
        .filter(|(_, stage)| stage.value > stage.optimum * (1.0 + 1e-6))
        .map(|(index, stage)| {
            let unit = if stage.unit == "1" { String::new() } else { format!(" {}", stage.unit) };
            format!(
                "stage {} from {}{unit} to {}{unit}, {}{unit} allowed",
                index + 1,
                terminal(stage.optimum),
                terminal(stage.value),
                terminal(stage.allowed)
            )
        })
        .collect();
    let raised = match stages.is_empty() {
        true => "no stage was raised".to_owned(),
        false => format!("raised: {}", stages.join("; ")),
    };
    let end = match &durable.end {
        DurableEnd::NotAsked => String::new(),
        DurableEnd::NotNeeded => {
            "The proved optimum holds every film and safety asked for: nothing was moved, and the proof holds for the limited problem too.".to_owned()
        }
        DurableEnd::Moved => format!(
            "A local search of {} engines moved the weights on the crankshaft; {raised}. No global optimum is claimed: films and safeties are not convex.",
            durable.evaluations
        ),
        DurableEnd::NothingBetter => format!(
            "A local search of {} engines found nothing better than the proved optimum. No global optimum is claimed: films and safeties are not convex.",
            durable.evaluations
        ),
        DurableEnd::Stopped { cause } => format!(
            "The local search was stopped after {} engines ({}); {raised}. No global optimum is claimed.",
            durable.evaluations,
            cause_words(*cause)
        ),
        DurableEnd::NoWeights { reason } => format!("Nothing was searched: {reason}."),
        DurableEnd::NotMeasured(why) => format!("Nothing was searched: {}; {}.", why.reason, why.remedy),
    };
    let limit = |limit: &lanchester_balance::DurableLimit| {
        let (factor, unit) = if limit.unit == "m" { (1e6, " um") } else { (1.0, "") };
        let least = format!("{}{unit}", terminal(factor * limit.least));
        match (limit.value, limit.is_met) {
            (Some(value), Some(true)) => {
                format!("{} at least {least}: holds, {}{unit}", limit.name, terminal(factor * value))
            }
            (Some(value), _) => {
                format!("{} at least {least}: NOT MET, {}{unit}", limit.name, terminal(factor * value))
            }
            (None, _) => format!("{} at least {least}: NOT KNOWN", limit.name),
        }
    };
    let lines = durable.limits.iter().map(limit);
    [end].into_iter().filter(|line| !line.is_empty()).chain(lines).collect::<Vec<_>>().join("\n")
}

fn cause_words(cause: StopCause) -> &'static str {
    match cause {
        StopCause::MaxNodes => "most evaluations",
        StopCause::TimeLimit => "time limit",
        StopCause::Cancelled => "cancelled",
        StopCause::Rounding => "rounding",
    }
}

fn terminal(value: f64) -> String {
    number::terminal(value, number::decimals(value, DIGITS))
}

/// All of it as text.
pub fn durability_text(engine: &Engine, durable: &Durable) -> String {
    let table = durability_table(durable).text();
    let weights = durable_weights_table(engine, durable)
        .map_or_else(String::new, |table| format!("\n{}", table.text()));
    let words = durability_words(durable);
    let words = if words.is_empty() { words } else { format!("\n{words}\n") };
    format!("{table}{weights}{words}")
}
