//! `lanchester validate`: printed against computed.

use crate::arguments::ValidateArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::print;
use crate::format::Format;
use lanchester_validation::{csv, markdown, text, validate};

pub fn run(arguments: &ValidateArguments) -> Result<u8, Failure> {
    let validation = validate(arguments.filter.as_deref());
    if validation.sources.is_empty() {
        return Err(Failure::input(
            format_args!("no source or table contains `{}`", arguments.filter.as_deref().unwrap_or_default()),
            "`lanchester validate` without a filter lists all of them",
        ));
    }
    print(&match arguments.format {
        _ if arguments.markdown => markdown(&validation),
        Format::Text => text(&validation, arguments.verbose),
        Format::Json => json(&validation)?,
        Format::Csv => csv(&validation),
    })?;
    Ok(if validation.passed() { DONE } else { NOT_AS_EXPECTED })
}
