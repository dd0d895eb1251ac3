//! What a table says of its own making, in the words of the command line.

use crate::failure::{Failure, WRONG_INPUT};
use lanchester::run::{HeadError, Held};
use lanchester::table::{Source, TableReader};
use lanchester_files::shown;
use std::path::Path;

/// What a table holds.
pub fn held_of<R: Source + 'static>(reader: &TableReader<R>, path: &Path) -> Result<Held, Failure> {
    Held::of(reader).ok_or_else(|| says_nothing(path))
}

/// A table that does not say what it holds.
pub fn says_nothing(path: &Path) -> Failure {
    Failure::input(
        format_args!("{} does not say what it holds: lanchester has not written it", shown(path)),
        "choose another name, or remove it first",
    )
}

impl From<HeadError> for Failure {
    fn from(error: HeadError) -> Failure {
        match error {
            HeadError::Kept(_) => Failure { status: WRONG_INPUT, message: format!("error: {error}") },
            _ => Failure::own(error),
        }
    }
}
