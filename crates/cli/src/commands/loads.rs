//! `lanchester loads`: what shakes the engine.

use crate::arguments::{Format, LoadsArguments, LoadsTable};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::request::load_request;
use lanchester::mechanism::loads;
use lanchester::report::{loads_text, orders_csv, trace_csv};

pub fn run(arguments: &LoadsArguments, colour: bool) -> Result<u8, Failure> {
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let loads = loads(&opened.engine, &request).map_err(refused)?;
    print(&match (arguments.format, arguments.table) {
        (Format::Text, _) => loads_text(&loads),
        (Format::Json, _) => json(&loads)?,
        (Format::Csv, LoadsTable::Orders) => orders_csv(&loads),
        (Format::Csv, LoadsTable::Trace) => trace_csv(&loads),
    })?;
    Ok(DONE)
}
