//! `lanchester loads`: what shakes the engine.

use crate::arguments::{Format, LoadsArguments, LoadsTable};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::request::load_request;
use lanchester::mechanism::loads;
use lanchester::report::{loads_text, motion_csv, orders_csv, trace_csv};

pub fn run(arguments: &LoadsArguments, colour: bool) -> Result<u8, Failure> {
    if arguments.table.is_some() && arguments.format != Format::Csv {
        return Err(Failure::input(
            "--table chooses what --format csv writes",
            "add --format csv, or leave --table out",
        ));
    }
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let loads = loads(&opened.engine, &request).map_err(refused)?;
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => loads_text(&loads),
        (Format::Json, _) => json(&loads)?,
        (Format::Csv, Some(LoadsTable::Trace)) => trace_csv(&loads),
        (Format::Csv, Some(LoadsTable::Motion)) => motion_csv(&loads),
        (Format::Csv, _) => orders_csv(&loads),
    })?;
    Ok(DONE)
}
