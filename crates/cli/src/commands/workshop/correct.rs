//! `lanchester workshop correct`: where to add or remove how much.

use super::sheet::open;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::options::workshop::CorrectArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{correction_tables, correction_text, vibration_figure};
use lanchester::workshop::{NextStep, correction};

pub fn run(arguments: &CorrectArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let sheet = open(&arguments.sheet, colour)?;
    let correction = correction(&sheet).map_err(Failure::refused)?;
    if let Some(path) = &arguments.figure {
        let Some(figure) = vibration_figure(&sheet, &correction) else {
            return Err(Failure::input(
                "there is nothing to draw: no runs, and [rotor] does not say in which sense its marks count",
                "add marks = \"clockwise\" or \"anticlockwise\" to [rotor], or leave --figure out",
            ));
        };
        write_result(path, &arguments.sheet, &figure.svg())?;
    }
    let said = match arguments.format {
        Format::Text => correction_text(&correction),
        Format::Json => json(&correction)?,
        Format::Csv => correction_tables(&correction).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    let unsettled = correction.next == NextStep::Settle;
    Ok(if correction.holds == Some(false) || unsettled { NOT_AS_EXPECTED } else { DONE })
}
