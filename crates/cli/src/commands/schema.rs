//! `lanchester schema`: the JSON Schema of the engine file.

use crate::arguments::SchemaArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure};
use crate::files::print;
use lanchester::model::{json_schema, reference_markdown};

pub fn run(arguments: &SchemaArguments) -> Result<u8, Failure> {
    print(&if arguments.markdown { reference_markdown() } else { json(&json_schema())? })?;
    Ok(DONE)
}
