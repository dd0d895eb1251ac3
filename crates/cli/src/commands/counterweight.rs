//! `lanchester counterweight`: counterweights as real parts.

mod check;
mod design;
mod designed_counterweights;
mod designed_shaft_weights;
mod drawings;
mod export;
mod front;
mod import;
mod words;

use crate::failure::Failure;
use crate::options::counterweight::{CounterweightArguments, CounterweightCommand};

pub fn run(arguments: &CounterweightArguments, colour: bool) -> Result<u8, Failure> {
    match &arguments.command {
        CounterweightCommand::Design(arguments) => design::run(arguments, colour),
        CounterweightCommand::Front(arguments) => front::run(arguments, colour),
        CounterweightCommand::Check(arguments) => check::run(arguments, colour),
        CounterweightCommand::Export(arguments) => export::run(arguments, colour),
        CounterweightCommand::Import(arguments) => import::run(arguments, colour),
    }
}
