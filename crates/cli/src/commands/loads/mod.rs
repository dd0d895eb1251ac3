//! `lanchester loads`: what shakes the engine.

mod cases;

use crate::arguments::{LoadsArguments, LoadsTable};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::requests::loads::{internal_request, load_request};
use lanchester::mechanism::{InternalMoments, LoadRequest, Loads, internal_cases, loads};
use lanchester::report::{
    internal_csv, internal_text, loads_brief, loads_text, motion_csv, orders_csv, trace_csv,
};
use serde::Serialize;

/// Angles a revolution of the shear forces and bending moments in JSON, at every plane of every crankshaft in both models.
const ANGLES: usize = 72;

/// Loads with what they do inside the crankshafts.
#[derive(Serialize)]
struct LoadsWithInternal<'a> {
    #[serde(flatten)]
    loads: &'a Loads,
    /// The case asked for, then those to compare it with.
    internal: &'a [InternalMoments],
}

pub fn run(arguments: &LoadsArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    arguments.printed.check(arguments.format == Format::Text)?;
    if let Some(cases) = &arguments.cases {
        return cases::run(arguments, cases, colour);
    }
    let samples = arguments.samples as usize;
    let request = LoadRequest { samples, ..load_request(&arguments.request)? };
    let opened = open(&arguments.file, colour)?;
    let loads = loads(&opened.file.engine, &request).map_err(refused)?;
    let internal = internal_request(&arguments.request, samples.min(ANGLES))?;
    let internal = internal_cases(&opened.file.engine, &internal).map_err(refused)?;
    let printed = &arguments.printed;
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => printed.text(
            || loads_text(&loads) + &internal_text(&opened.file.engine, &internal),
            || loads_brief(&loads),
        ),
        (Format::Json, _) => json(&LoadsWithInternal { loads: &loads, internal: &internal })?,
        (Format::Csv, Some(LoadsTable::Internal)) => {
            printed.csv(internal_csv(&opened.file.engine, &internal))
        }
        (Format::Csv, Some(LoadsTable::Trace)) => printed.csv(trace_csv(&loads)),
        (Format::Csv, Some(LoadsTable::Motion)) => printed.csv(motion_csv(&loads)),
        (Format::Csv, _) => printed.csv(orders_csv(&loads)),
    })?;
    Ok(DONE)
}
