//! `lanchester workshop internal`: slugs that take over from weights outside.

use super::sheet::open as open_sheet;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::InternalArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{internal_tables, internal_text};
use lanchester::workshop::internal_balance;

pub fn run(arguments: &InternalArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let sheet = open_sheet(&arguments.sheet, colour)?;
    let answer = internal_balance(&sheet).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => internal_text(&answer),
        Format::Json => json(&answer)?,
        Format::Csv => internal_tables(&answer).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(if answer.reached { DONE } else { NOT_AS_EXPECTED })
}
