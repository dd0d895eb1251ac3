//! `lanchester counterweight`: counterweights as real parts.

mod check;
mod design;
mod export;
mod front;
mod import;

use crate::commands::Opened;
use crate::counterweight_arguments::{CounterweightArguments, CounterweightCommand};
use crate::failure::{Failure, WRONG_INPUT};
use crate::files::{print, rewrite, write_result};
use lanchester::model::{Engine, WriteBackError, difference, render, write_back};
use lanchester::report::counterweight_drawings;
use std::fmt::Display;
use std::path::Path;

pub fn run(arguments: &CounterweightArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        CounterweightCommand::Design(arguments) => design::run(arguments, colour),
        CounterweightCommand::Front(arguments) => front::run(arguments, colour),
        CounterweightCommand::Check(arguments) => check::run(arguments, colour),
        CounterweightCommand::Export(arguments) => export::run(arguments, colour),
        CounterweightCommand::Import(arguments) => import::run(arguments, colour),
    }
}

/// Names of weights in a list: "web 1, web 2".
fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

/// An error of the facade with its own hint.
fn refused(error: impl Display) -> Failure {
    Failure { status: WRONG_INPUT, message: format!("error: {error}") }
}

/// Does what `--write` and `--dry-run` ask: the file gets the parts of `after`, or the difference is shown and all is
/// said (`true`).
fn put_into_file(
    opened: &Opened,
    path: &Path,
    [write, dry_run]: [bool; 2],
    after: &Engine,
    colour: bool,
) -> Result<bool, Failure> {
    if !(write || dry_run) {
        return Ok(false);
    }
    if path == Path::new("-") && write {
        return Err(Failure::input(
            "--write needs a file, got standard input",
            "give the path of the engine file",
        ));
    }
    let (name, before) = (&opened.source.name, &opened.source.text);
    let text = write_back(before, after).map_err(|error| {
        if let WriteBackError::Weights { text, diagnostics } = &error {
            eprint!("{}", render(diagnostics, "the file with its counterweights", text, colour));
        }
        Failure::input(error, "the file is as it was; the shapes stand in the output without --write")
    })?;
    if text == *before {
        eprintln!("{name} already holds these shapes");
    }
    if dry_run {
        print(&difference(before, &text, name))?;
        return Ok(true);
    }
    if text != *before {
        rewrite(path, before, &text)?;
        eprintln!("counterweights written into {name}");
    }
    Ok(false)
}

/// Draws the counterweights of an engine into the folder, those of one shape once.
fn draw(engine: &Engine, folder: &Path, file: &Path) -> Result<(), Failure> {
    for figure in counterweight_drawings(engine) {
        write_result(&folder.join(format!("{}.svg", figure.id)), file, &figure.svg())?;
    }
    Ok(())
}
