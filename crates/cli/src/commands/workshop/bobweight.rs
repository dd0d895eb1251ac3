//! `lanchester workshop bobweight`: bobweights from weighed parts.

use super::sheet::open as open_sheet;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::BobweightArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{bobweight_tables, bobweight_text};
use lanchester::workshop::bobweight_answer;

pub fn run(arguments: &BobweightArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let sheet = open_sheet(&arguments.sheet, colour)?;
    let engine = match &sheet.engine {
        // The path counts from the sheet's own folder; that of standard input is the current one.
        Some(file) => {
            let folder = arguments.sheet.parent().unwrap_or(std::path::Path::new(""));
            Some(open(&folder.join(file), colour)?.file.engine)
        }
        None => None,
    };
    let answer = bobweight_answer(&sheet, engine.as_ref()).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => bobweight_text(&answer),
        Format::Json => json(&answer)?,
        Format::Csv => bobweight_tables(&answer).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}
