//! `lanchester workshop`: balancing a real crank or engine from measurements.

mod assign;
mod bobweight;
mod correct;
mod crank;
mod crank_input;
mod drill;
mod external;
mod factor;
mod given_factor;
mod grade;
mod internal;

use crate::failure::Failure;
use crate::files::read_source;
use crate::options::workshop::{WorkshopArguments, WorkshopCommand};
use lanchester::file::render;
use lanchester::file::workshop::read_sheet;
use lanchester::task::workshop::Sheet;
use std::path::Path;

pub fn run(arguments: &WorkshopArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        WorkshopCommand::Factor(arguments) => factor::run(arguments, colour),
        WorkshopCommand::Bobweight(arguments) => bobweight::run(arguments, colour),
        WorkshopCommand::Crank(arguments) => crank::run(arguments, colour),
        WorkshopCommand::External(arguments) => external::run(arguments, colour),
        WorkshopCommand::Internal(arguments) => internal::run(arguments, colour),
        WorkshopCommand::Correct(arguments) => correct::run(arguments, colour),
        WorkshopCommand::Drill(arguments) => drill::run(arguments, colour),
        WorkshopCommand::Assign(arguments) => assign::run(arguments, colour),
        WorkshopCommand::Grade(arguments) => grade::run(arguments, colour),
    }
}

/// Read a workshop sheet: mistakes and warnings go to standard error.
fn open(path: &Path, colour: bool) -> Result<Sheet, Failure> {
    let source = read_source(path)?;
    let reading = read_sheet(&source.text);
    if !reading.diagnostics.is_empty() {
        eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
    }
    match reading.sheet {
        Some(sheet) => Ok(sheet),
        None => Err(Failure::diagnosed()),
    }
}
