//! `lanchester balance --robust`: the best weights for engines within their tolerances.

use crate::arguments::BalanceArguments;
use crate::commands::balance::found::{consequences, put_into_file};
use crate::commands::{Opened, json};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use lanchester::balance::fitted;
use lanchester::report::robust_text;
use lanchester::task::BalanceTask;
use lanchester::{RobustOptions, robust_balance};

pub fn run(
    opened: &Opened,
    arguments: &BalanceArguments,
    task: &BalanceTask,
    options: &RobustOptions,
    colour: bool,
) -> Result<u8, Failure> {
    if arguments.format == Format::Csv {
        return Err(Failure::input("--robust has no table as CSV", "take --format json, or text"));
    }
    let engine = &opened.file.engine;
    let found =
        robust_balance(engine, &opened.file.tasks.tolerances, task, options).map_err(Failure::refused)?;
    let after = fitted(engine, &found.answer);
    let effect = consequences(engine, &after, Some(task))?;
    if put_into_file(opened, arguments, &after, Some(&effect), colour)? {
        return Ok(DONE);
    }
    print(&match arguments.format {
        Format::Json => json(&found)?,
        _ => arguments.printed.led(robust_text(engine, &found)),
    })?;
    Ok(DONE)
}
