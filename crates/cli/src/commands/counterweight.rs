//! `lanchester counterweight`: counterweights as real parts.

mod check;
mod design;
mod designed_counterweights;
mod designed_shaft_weights;
mod export;
mod front;
mod import;

use crate::failure::Failure;
use crate::files::write_result;
use crate::options::counterweight::{CounterweightArguments, CounterweightCommand};
use lanchester::geometry::clearance::{RadialEnvelope, SweptRoom};
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

/// What the wanted clearance leaves: the envelope over the cycle, and the circle that keeps clear whatever the shape.
fn room_words(room: Option<&SweptRoom>, envelope: Option<&RadialEnvelope>) -> Option<String> {
    let (Some(envelope), Some(limit)) = (envelope, envelope.and_then(|envelope| envelope.limit)) else {
        return None;
    };
    let [least, most] =
        [envelope.smallest(), envelope.largest()].map(|radius| format!("{:.2} mm", 1e3 * radius));
    let radii = if least == most { least } else { format!("{least} to {most}, depending on the direction,") };
    // Where the circle bounds the shape, it is told once.
    let round =
        room.filter(|room| !(envelope.is_round() && envelope.smallest() == room.radius)).map(|room| {
            let limit = obstacle_name(room.limit);
            format!("; {:.2} mm whatever the shape, by {limit}", 1e3 * room.radius)
        });
    Some(format!(
        "over the cycle a radius of {radii} keeps {:.2} mm of clearance, bounded first by {}{}.",
        1e3 * envelope.least,
        obstacle_name(limit),
        round.unwrap_or_default()
    ))
}

/// Draws the counterweights and the weights of balance shafts of an engine into the folder, those of one shape once.
fn draw(engine: &Engine, folder: &Path, file: &Path) -> Result<(), Failure> {
    for figure in counterweight_drawings(engine).into_iter().chain(shaft_weight_drawings(engine)) {
        write_result(&folder.join(format!("{}.svg", figure.id)), file, &figure.svg())?;
    }
    Ok(())
}
