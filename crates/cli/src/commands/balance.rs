//! `lanchester balance`: the best weights and shafts, their proof and their price, written back if asked for.

use crate::arguments::{BalanceArguments, BalanceMethod, BalanceTable, Format};
use crate::balance_request::balance_task;
use crate::commands::{Opened, json, open, published, search, sweep};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED, WRONG_INPUT};
use crate::files::{print, rewrite, write_result};
use lanchester::balance::{Answer, BalanceError, Outcome, fitted, optimise};
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::{Engine, WriteBackError, difference, render, write_back};
use lanchester::report::{
    balance_text, cancellation_proof_table, cancelled_orders_table, effects_table, found_weights_table,
    headline, limits_table, optimum_figures, stages_table,
};
use std::path::Path;

pub fn run(arguments: &BalanceArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    if arguments.write && arguments.file == Path::new("-") {
        return Err(Failure::input(
            "--write needs a file, got standard input",
            "give the path of the engine file",
        ));
    }
    if arguments.search.search {
        return search::run(arguments, colour);
    }
    sweep::check(arguments)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.engine;
    if published::asked_for(arguments)? {
        let answer = published::fit(engine, arguments)?;
        return match put_into_file(&opened, arguments, &answer.fitted, colour)? {
            true => Ok(DONE),
            false => published::tell(&opened, arguments, &answer),
        };
    }
    if arguments.method == BalanceMethod::Sweep {
        return sweep::run(arguments, &opened, colour);
    }
    let task = balance_task(engine, arguments)?;
    if matches!(arguments.table, Some(BalanceTable::Orders | BalanceTable::Proof)) && task.cancel.is_empty() {
        return Err(Failure::input(
            "this table tells of orders that must vanish, and none is asked for",
            "give --cancel, or take another --table",
        ));
    }
    let answer = optimise(engine, &task).map_err(refused)?;
    let found = !matches!(answer.outcome, Outcome::Infeasible { .. });
    let after = fitted(engine, &answer);
    let loads_after = loads_of(&after)?;
    if let Some(folder) = &arguments.figures
        && found
    {
        let before = loads_of(engine)?;
        let of_answer = optimum_figures(engine, &answer, &before, &after, &loads_after);
        for figure in of_answer.into_iter().chain(sweep::curve(&after, &answer)) {
            write_result(&folder.join(format!("{}.svg", figure.id)), &arguments.file, &figure.svg())?;
        }
    }
    if found && put_into_file(&opened, arguments, &after, colour)? {
        return Ok(status(&answer));
    }
    if status(&answer) != DONE && arguments.format != Format::Text {
        eprintln!("{}", headline(engine, &answer));
    }
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => balance_text(engine, &answer, &loads_after.diagnosis.summary),
        (Format::Json, _) => json(&answer)?,
        (Format::Csv, table) => csv(engine, &answer, table),
    })?;
    Ok(status(&answer))
}

fn status(answer: &Answer) -> u8 {
    if answer.outcome == Outcome::Optimal { DONE } else { NOT_AS_EXPECTED }
}

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
