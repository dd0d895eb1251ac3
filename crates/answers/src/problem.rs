//! What is told where a question has no answer.

use lanchester::file::Diagnostic;
use lanchester::task::option::BadQuantity;
use schemars::JsonSchema;
use serde::Serialize;

/// Why there is no answer: what was needed, what was got, and what to do.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Problem {
    /// What was needed and what was got.
    pub message: String,
    /// What to do.
    pub hint: Option<String>,
    /// The mistakes of the engine file, where they are the reason; places in UTF-16 units.
    pub diagnostics: Vec<Diagnostic>,
    /// How a file stands that was to be written over.
    pub found: Option<Found>,
    /// What kind of refusal this is.
    #[serde(skip)]
    pub status: Status,
}

/// Kinds of refusals, with the numbers that HTTP has for them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u16)]
pub enum Status {
    /// The question cannot be read.
    BadQuestion = 400,
    /// Whoever asks does not know the token.
    Unauthorised = 401,
    /// Whoever asks may not have this.
    Forbidden = 403,
    /// There is no such question.
    NoSuchQuestion = 404,
    /// The question did not come whole in time.
    Late = 408,
    /// Something newer stands in the way.
    Conflict = 409,
    /// The question is too long.
    TooLong = 413,
    /// The question is understood, and has no answer.
    Refused = 422,
    /// A mistake of this program.
    Broken = 500,
}

/// How a file stands on the disk, other than whoever saves it believes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Found {
    /// Another program changed it.
    Changed,
    /// Another program removed it.
    Removed,
    /// A new file was to be written, and there is one.
    Exists,
}

impl Problem {
    /// A refusal.
    pub fn new(status: Status, message: impl Into<String>, hint: impl Into<String>) -> Problem {
        Problem {
            message: message.into(),
            hint: Some(hint.into()),
            diagnostics: Vec::new(),
            found: None,
            status,
        }
    }

    /// A question that cannot be answered, in the words of an error of the facade: its hint stands behind `hint: `.
    pub(crate) fn refused(error: impl std::fmt::Display) -> Problem {
        let text = error.to_string();
        let (message, hint) = match text.split_once("\nhint: ") {
            Some((message, hint)) => (message.to_string(), Some(hint.to_string())),
            None => (text, None),
        };
        Problem { message, hint, diagnostics: Vec::new(), found: None, status: Status::Refused }
    }

    /// A quantity or a criterion that cannot be read.
    pub(crate) fn quantity(bad: BadQuantity) -> Problem {
        Problem { hint: Some(bad.hint), ..Problem::refused(bad.message) }
    }

    /// An engine file with mistakes.
    pub(crate) fn mistakes(diagnostics: Vec<Diagnostic>) -> Problem {
        let first = diagnostics.first().map_or("", |diagnostic| diagnostic.message.as_str());
        Problem {
            diagnostics: diagnostics.clone(),
            ..Problem::refused(format!("the engine file has mistakes: {first}"))
        }
    }
}

impl Problem {
    /// A graph file with mistakes.
    pub(crate) fn graph(diagnostics: Vec<Diagnostic>) -> Problem {
        let first = diagnostics.first().map_or("", |diagnostic| diagnostic.message.as_str());
        let message = format!("the graph has mistakes: {first}");
        Problem { diagnostics, ..Problem::refused(message) }
    }
}
