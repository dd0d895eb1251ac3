//! `lanchester balance`: the best weights and shafts, their proof and their price, written back if asked for.

use crate::arguments::{BalanceArguments, BalanceMethod, BalanceTable};
use crate::balance_request::balance_task;
use crate::commands::found::{csv, loads_of, put_into_file, refused};
use crate::commands::{json, open, published, search, sweep};
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_result};
use crate::format::Format;
use lanchester::balance::{Answer, Outcome, fitted, optimise};
use lanchester::report::{balance_text, headline, optimum_figures};
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
