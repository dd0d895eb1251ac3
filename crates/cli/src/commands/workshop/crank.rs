//! `lanchester workshop crank`: unbalance of a crank with its bobweights.

use super::crank_input::crank;
use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::workshop::CrankArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{crank_figure, crank_tables, crank_text};
use lanchester::workshop::crank_unbalance;

pub fn run(arguments: &CrankArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let crank = crank(&arguments.crank, colour)?;
    let planes = crank.planes(arguments.planes.as_deref())?;
    let body = crank.body()?;
    let answer = crank_unbalance(&crank.engine, crank.crankshaft, &crank.bobweights, &planes, body)
        .map_err(Failure::refused)?;
    if let Some(path) = &arguments.figure {
        write_result(path, &arguments.crank.engine, &crank_figure(&answer).svg())?;
    }
    let said = match arguments.format {
        Format::Text => crank_text(&answer),
        Format::Json => json(&answer)?,
        Format::Csv => crank_tables(&answer).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}
