//! The pressure traces that an engine file names: read from its folder.

use crate::failure::Failure;
use crate::files::read_bytes;
use lanchester::model::Engine;
use lanchester::{TraceFile, trace_names};
use std::path::Path;

/// The files of pressure that the engine asks for, from the folder of its own file (standard input: from the working folder).
pub fn trace_files(engine: &Engine, engine_file: &Path) -> Result<Vec<TraceFile>, Failure> {
    let folder = engine_file.parent().unwrap_or(Path::new(""));
    trace_names(engine)
        .into_iter()
        .map(|name| {
            let hint = "[gas] names it: give its place from the folder of the engine file";
            let bytes = read_bytes(&folder.join(name), hint)?;
            let text = String::from_utf8(bytes).map_err(|error| {
                Failure::input(
                    format_args!("{name} is not UTF-8 text (byte {})", error.utf8_error().valid_up_to()),
                    "save the pressures as CSV in UTF-8",
                )
            })?;
            Ok(TraceFile { name: name.to_string(), text })
        })
        .collect()
}
