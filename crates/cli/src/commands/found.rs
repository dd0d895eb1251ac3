//! What balancing found: as tables, and put into the engine file.

use crate::arguments::{BalanceArguments, BalanceTable};
use crate::commands::Opened;
use crate::failure::{Failure, WRONG_INPUT};
use crate::files::{print, rewrite};
use lanchester::balance::{Answer, BalanceError};
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::{Engine, WriteBackError, difference, render, write_back};
use lanchester::report::{
    cancellation_proof_table, cancelled_orders_table, effects_table, found_weights_table, limits_table,
    stages_table,
};

pub fn loads_of(engine: &Engine) -> Result<Loads, Failure> {
    loads(engine, &LoadRequest::default()).map_err(super::refused)
}

/// Does what `--write` and `--dry-run` ask: the file gets the weights and shafts of `after`, or the difference is shown
/// and all is said (`true`).
pub fn put_into_file(
    opened: &Opened,
    arguments: &BalanceArguments,
    after: &Engine,
    colour: bool,
) -> Result<bool, Failure> {
    if !(arguments.dry_run || arguments.write) {
        return Ok(false);
    }
    let (name, before) = (&opened.source.name, &opened.source.text);
    let text = write_back(before, after).map_err(|error| not_written(error, colour))?;
    let same = text == *before;
    if same {
        eprintln!("{name} already holds these weights");
    }
    if arguments.dry_run {
        print(&difference(before, &text, name))?;
        return Ok(true);
    }
    if !same {
        rewrite(&arguments.file, before, &text)?;
        eprintln!("weights written into {name}");
    }
    Ok(false)
}

fn not_written(error: WriteBackError, colour: bool) -> Failure {
    if let WriteBackError::Weights { text, diagnostics } = &error {
        eprint!("{}", render(diagnostics, "the file with its weights", text, colour));
    }
    Failure::input(error, "the file is as it was; the found weights stand in the output without --write")
}

pub fn csv(engine: &Engine, answer: &Answer, table: Option<BalanceTable>) -> String {
    match table.unwrap_or(BalanceTable::Weights) {
        BalanceTable::Weights => found_weights_table(answer).csv(),
        BalanceTable::Effects => effects_table(engine, answer).csv(),
        BalanceTable::Stages => stages_table(engine, answer).csv(),
        BalanceTable::Limits => limits_table(engine, answer).map_or(String::new(), |table| table.csv()),
        BalanceTable::Orders => {
            let table = answer.cancellation.as_ref().map(|c| cancelled_orders_table(engine, c));
            table.map_or(String::new(), |table| table.csv())
        }
        BalanceTable::Proof => {
            let table = answer.cancellation.as_ref().and_then(|c| cancellation_proof_table(engine, c));
            table.map_or(String::new(), |table| table.csv())
        }
    }
}

pub fn refused(error: BalanceError) -> Failure {
    Failure { status: WRONG_INPUT, message: format!("error: {error}") }
}
