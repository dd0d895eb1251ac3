//! `lanchester workshop external`: weights on damper and flywheel.

use super::crank_input::{crank, weights_in_planes};
use super::given_factor::bad;
use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::ExternalArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{external_tables, external_text};
use lanchester::task::option;
use lanchester::workshop::external_balance;

pub fn run(arguments: &ExternalArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let (planes, radii) = weights_in_planes(&arguments.planes)?;
    let keep = option::share(&arguments.keep, "--keep").map_err(bad)?;
    let crank = crank(&arguments.crank, colour)?;
    let answer = external_balance(&crank.engine, crank.crankshaft, &crank.bobweights, &planes, radii, keep)
        .map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => external_text(&answer),
        Format::Json => json(&answer)?,
        Format::Csv => external_tables(&answer).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}
