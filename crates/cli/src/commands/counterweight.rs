//! `lanchester counterweight`: counterweights as real parts.

mod check;
mod design;
mod designed_counterweights;
mod designed_shaft_weights;
mod export;
mod front;
mod import;

use crate::counterweight_arguments::{CounterweightArguments, CounterweightCommand};
use crate::failure::Failure;
use crate::files::write_result;
use lanchester::geometry::clearance::SweptRoom;
use lanchester::model::Engine;
use lanchester::report::{counterweight_drawings, obstacle_name, shaft_weight_drawings};
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

/// What keeps clear of everything.
fn room_words(room: &SweptRoom) -> String {
    format!(
        "a swept radius up to {:.2} mm keeps {:.2} mm of clearance whatever the shape; first in the way is {}.",
        1e3 * room.radius,
        1e3 * room.least,
        obstacle_name(room.limit)
    )
}

/// Draws the counterweights and the weights of balance shafts of an engine into the folder, those of one shape once.
fn draw(engine: &Engine, folder: &Path, file: &Path) -> Result<(), Failure> {
    for figure in counterweight_drawings(engine).into_iter().chain(shaft_weight_drawings(engine)) {
        write_result(&folder.join(format!("{}.svg", figure.id)), file, &figure.svg())?;
    }
    Ok(())
}
