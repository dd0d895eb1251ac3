//! `lanchester balance`: the best weights and shafts, their proof and their price, written back if asked for.

use crate::arguments::{BalanceArguments, BalanceTable, Format};
use crate::balance_request::balance_task;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED, WRONG_INPUT};
use crate::files::print;
use lanchester::balance::{Answer, BalanceError, Outcome, fitted, optimise};
use lanchester::mechanism::{LoadRequest, loads};
use lanchester::model::Engine;
use lanchester::report::{balance_text, effects_table, found_weights_table, limits_table, stages_table};

pub fn run(arguments: &BalanceArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.engine;
    let task = balance_task(engine, arguments)?;
    let answer = optimise(engine, &task).map_err(refused)?;
    let after = fitted(engine, &answer);
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => balance_text(engine, &answer, &left(&after)?),
        (Format::Json, _) => json(&answer)?,
        (Format::Csv, table) => csv(engine, &answer, table.unwrap_or(BalanceTable::Weights)),
    })?;
    Ok(if answer.outcome == Outcome::Optimal { DONE } else { NOT_AS_EXPECTED })
}

/// What still shakes the engine.
fn left(engine: &Engine) -> Result<String, Failure> {
    let loads = loads(engine, &LoadRequest::default()).map_err(super::refused)?;
    Ok(loads.diagnosis.summary)
}

fn csv(engine: &Engine, answer: &Answer, table: BalanceTable) -> String {
    match table {
        BalanceTable::Weights => found_weights_table(answer).csv(),
        BalanceTable::Effects => effects_table(engine, answer).csv(),
        BalanceTable::Stages => stages_table(engine, answer).csv(),
        BalanceTable::Limits => limits_table(engine, answer).map_or(String::new(), |table| table.csv()),
    }
}

fn refused(error: BalanceError) -> Failure {
    Failure { status: WRONG_INPUT, message: format!("error: {error}") }
}
