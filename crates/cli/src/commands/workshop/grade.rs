//! `lanchester workshop grade`: what a balance quality grade allows.

use super::sheet::open;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use crate::options::workshop::GradeArguments;
use lanchester::report::Table;
use lanchester::report::workshop::{grade_tables, grade_text};
use lanchester::workshop::grade;

pub fn run(arguments: &GradeArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let sheet = open(&arguments.sheet, colour)?;
    let grade = grade(&sheet).map_err(Failure::refused)?;
    let said = match arguments.format {
        Format::Text => grade_text(&grade),
        Format::Json => json(&grade)?,
        Format::Csv => grade_tables(&grade).iter().map(Table::csv).collect::<Vec<_>>().join("\r\n"),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(if grade.kept == Some(false) { NOT_AS_EXPECTED } else { DONE })
}
