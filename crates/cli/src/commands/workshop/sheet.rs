//! The workshop sheet of a command.

use crate::failure::Failure;
use crate::files::read_source;
use lanchester::file::render;
use lanchester::file::workshop::read_sheet;
use lanchester::task::workshop::Sheet;
use std::path::Path;

/// Reads a workshop sheet: mistakes and warnings go to standard error.
pub(super) fn open(path: &Path, colour: bool) -> Result<Sheet, Failure> {
    let source = read_source(path)?;
    let reading = read_sheet(&source.text);
    if !reading.diagnostics.is_empty() {
        eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
    }
    match reading.sheet {
        Some(sheet) => Ok(sheet),
        None => Err(Failure::diagnosed()),
    }
}
