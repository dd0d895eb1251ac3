//! Files that questions open, save and name: whoever carries the questions has them.

use crate::problem::{Found, Problem, Status};
use schemars::JsonSchema;
use serde::Serialize;

/// An engine file may be this long [bytes]; a longer one is some other file.
pub const LONGEST_FILE: u64 = 4 << 20;

/// An engine file as it stands in the folder.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FileState {
    /// Its name in the folder.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Tells one text from another.
    pub revision: String,
}

impl FileState {
    /// A file with this text.
    pub fn new(name: &str, text: String) -> FileState {
        FileState { name: name.to_string(), revision: revision(&text), text }
    }
}

/// The files that can be opened, saved and named: one folder.
pub trait Files: Send + Sync {
    /// Where they stand, for people.
    fn place(&self) -> String;

    /// Names of the engine files, sorted.
    fn names(&self) -> Vec<String>;

    /// An engine file.
    ///
    /// # Errors
    /// A [`Problem`] where there is no such file, it cannot be read or is no text.
    fn open(&self, name: &str) -> Result<FileState, Problem>;

    /// Writes an engine file whole or not at all: over the text of the revision `over`, or a new one.
    ///
    /// # Errors
    /// A [`Problem`], with [`Problem::found`] where the file stands otherwise than `over` says.
    fn save(&self, name: &str, text: &str, over: Option<&str>) -> Result<FileState, Problem>;

    /// The text of a file beside the engine files that a section of one names; `by` is that section, for people.
    ///
    /// # Errors
    /// A [`Problem`] where there is no such file, it cannot be read or is no text.
    fn named(&self, name: &str, by: &str) -> Result<String, Problem>;
}

/// Tells one text from another.
pub fn revision(text: &str) -> String {
    format!("{:016x}", lanchester::fnv1a(text.as_bytes()))
}

/// Whether a plain name is one of an engine file.
pub fn is_engine_file(name: &str) -> bool {
    name.ends_with(".toml") && name.len() > ".toml".len() && !name.starts_with('.')
}

const KEEP_ONE: &str = "keep one of both, or save under another name";

impl Found {
    /// What is told of the file `name` that stands so.
    pub fn problem(self, name: &str) -> Problem {
        let (message, hint) = match self {
            Found::Exists => (format!("{name} exists already"), KEEP_ONE),
            Found::Changed => (format!("another program changed {name} since it was opened here"), KEEP_ONE),
            Found::Removed => (
                format!("another program removed {name} since it was opened here"),
                "save it anew, or under another name",
            ),
        };
        Problem { found: Some(self), ..Problem::new(Status::Conflict, message, hint) }
    }
}

/// Whether a file that now holds `there` may be replaced by one who saw the revision `over`, who saw none where it is `None`.
///
/// # Errors
/// A [`Problem`] that says how the file stands instead.
pub fn may_replace(name: &str, there: Option<&str>, over: Option<&str>) -> Result<(), Problem> {
    match (there, over) {
        (None, None) => Ok(()),
        (Some(text), Some(over)) if revision(text) == over => Ok(()),
        (Some(_), Some(_)) => Err(Found::Changed.problem(name)),
        (Some(_), None) => Err(Found::Exists.problem(name)),
        (None, Some(_)) => Err(Found::Removed.problem(name)),
    }
}

/// A file that is longer than it may be [bytes].
pub fn too_long(name: &str, longest: u64) -> Problem {
    let message = format!("{name} is longer than {} MiB", longest >> 20);
    Problem::new(Status::Refused, message, "is this the right file?")
}

/// The text of a file that was read.
///
/// # Errors
/// A [`Problem`] where it is no UTF-8.
pub fn text_of(name: &str, bytes: Vec<u8>) -> Result<String, Problem> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Problem::new(Status::Refused, format!("{name} is not UTF-8 text (byte {at})"), "save it as UTF-8")
    })
}
