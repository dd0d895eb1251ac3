//! `lanchester workshop drill`: which holes to drill, and what they leave.

use super::sheet::open;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::DrillArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{drilling_tables, drilling_text};
use lanchester::workshop::drilling;

pub fn run(arguments: &DrillArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let sheet = open(&arguments.sheet, colour)?;
    let drilling = drilling(&sheet).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => drilling_text(&drilling),
        Format::Json => json(&drilling)?,
        Format::Csv => drilling_tables(&drilling).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(if drilling.holds { DONE } else { NOT_AS_EXPECTED })
}
