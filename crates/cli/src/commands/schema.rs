//! `lanchester schema`: the JSON Schema of the engine file or of the workshop sheet.

use crate::arguments::SchemaArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::print;
use lanchester::cycle::trace_codes;
use lanchester::file::{json_schema, reference_markdown, sheet_reference_markdown, sheet_schema};
use lanchester_validation::suite_schema;

pub fn run(arguments: &SchemaArguments) -> Result<u8, Failure> {
    if arguments.suite {
        print(&json(&suite_schema())?)?;
        return Ok(DONE);
    }
    print(&match (arguments.sheet, arguments.markdown) {
        (false, false) => json(&json_schema())?,
        (false, true) => reference_markdown() + &of_traces(),
        (true, false) => json(&sheet_schema())?,
        (true, true) => sheet_reference_markdown(),
    })?;
    Ok(DONE)
}

/// What may be wrong with a file of pressures, which an engine file names.
fn of_traces() -> String {
    let codes = trace_codes().iter().map(|(code, meaning)| format!("| {code} | {meaning} |\n"));
    format!(
        "\n## Diagnostics of files of pressures\n\n| code | says |\n|---|---|\n{}",
        codes.collect::<String>()
    )
}
