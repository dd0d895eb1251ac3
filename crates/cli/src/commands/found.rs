//! What balancing found: as tables, and put into the engine file.

use crate::arguments::{BalanceArguments, BalanceTable};
use crate::commands::Opened;
use crate::commands::put_back::PutBack;
use crate::failure::Failure;
use lanchester::balance::Answer;
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::Engine;
use lanchester::report::{
    cancellation_proof_table, cancelled_orders_table, effects_table, found_weights_table, limits_table,
    stages_table,
};

pub fn loads_of(engine: &Engine) -> Result<Loads, Failure> {
    loads(engine, &LoadRequest::default()).map_err(super::refused)
}

/// Does what `--write` and `--dry-run` of `balance` ask ([`PutBack`]).
pub fn put_into_file(
    opened: &Opened,
    arguments: &BalanceArguments,
    after: &Engine,
    colour: bool,
) -> Result<bool, Failure> {
    let BalanceArguments { file, write, dry_run, .. } = arguments;
    PutBack { path: file, write: *write, dry_run: *dry_run, what: "weights" }.run(opened, after, colour)
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
