//! Why there is no answer, and the Python exception that says it.

use lanchester::file::{Diagnostic, render};
use lanchester::units::BadQuantity;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::fmt;

/// The code of an argument that cannot be used.
const ARGUMENT: &str = "Argument";

/// Why there is no answer.
#[derive(Debug)]
pub enum Failure {
    /// The engine file has mistakes.
    Mistakes {
        /// What messages call the file.
        name: String,
        /// Its text.
        text: String,
        /// Its mistakes and warnings.
        diagnostics: Vec<Diagnostic>,
    },
    /// What is asked for cannot be done.
    Refused {
        /// What was needed and what was got.
        message: String,
        /// What to do.
        hint: Option<String>,
        /// Type and variant of the error, such as `LoadError.Speed`; [`ARGUMENT`] for an argument that cannot be used.
        code: String,
    },
    /// The user has pressed Ctrl-C, or a signal handler has raised.
    Interrupted(PyErr),
    /// Something that should not happen.
    Internal(String),
}

impl Failure {
    /// An option that cannot be used: `message` says what was needed and what was got, `hint` what to do.
    pub fn option(message: impl fmt::Display, hint: impl fmt::Display) -> Failure {
        Failure::Refused { message: message.to_string(), hint: Some(hint.to_string()), code: ARGUMENT.into() }
    }

    /// An error of the facade in its own words; its hint stands behind `hint: `.
    pub fn refused<E: fmt::Display + fmt::Debug>(error: E) -> Failure {
        let text = error.to_string();
        let (message, hint) = match text.split_once("\nhint: ") {
            Some((message, hint)) => (message.to_owned(), Some(hint.to_owned())),
            None => (text, None),
        };
        let of = std::any::type_name::<E>().rsplit("::").next().unwrap_or_default();
        let variant: String = format!("{error:?}").chars().take_while(|c| c.is_alphanumeric()).collect();
        let code =
            if variant.is_empty() || variant == of { of.to_owned() } else { format!("{of}.{variant}") };
        Failure::Refused { message, hint, code }
    }
}

impl From<BadQuantity> for Failure {
    fn from(bad: BadQuantity) -> Failure {
        let code = format!("{ARGUMENT}.Quantity");
        Failure::Refused { message: bad.message, hint: Some(bad.hint), code }
    }
}

impl From<PyErr> for Failure {
    fn from(error: PyErr) -> Failure {
        Failure::Interrupted(error)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> PyErr {
        Python::attach(|py| exception(py, failure).unwrap_or_else(|error| error))
    }
}

/// The exception of `lanchester.errors` that says it.
fn exception(py: Python<'_>, failure: Failure) -> PyResult<PyErr> {
    let make = |class: &str, arguments: Bound<'_, PyDict>| {
        let class = py.import("lanchester.errors")?.getattr(class)?;
        Ok(PyErr::from_value(class.call((), Some(&arguments))?))
    };
    let arguments = PyDict::new(py);
    match failure {
        Failure::Interrupted(error) => Ok(error),
        Failure::Mistakes { name, text, diagnostics } => {
            arguments.set_item("text", render(&diagnostics, &name, &text, false))?;
            arguments.set_item("diagnostics", self::diagnostics(py, &text, &diagnostics)?)?;
            make("EngineFileError", arguments)
        }
        Failure::Refused { message, hint, code } => {
            arguments.set_item("message", message)?;
            arguments.set_item("hint", hint)?;
            arguments.set_item("code", code)?;
            make("RequestError", arguments)
        }
        Failure::Internal(message) => {
            arguments.set_item("message", message)?;
            make("InternalError", arguments)
        }
    }
}

/// Diagnostics as objects of `lanchester.errors.Diagnostic`.
pub fn diagnostics<'py>(
    py: Python<'py>,
    text: &str,
    diagnostics: &[Diagnostic],
) -> PyResult<Bound<'py, PyList>> {
    let class = py.import("lanchester.errors")?.getattr("Diagnostic")?;
    let list = PyList::empty(py);
    for own in diagnostics {
        let arguments = PyDict::new(py);
        let severity = match own.severity {
            lanchester::file::Severity::Error => "error",
            lanchester::file::Severity::Warning => "warning",
        };
        arguments.set_item("severity", severity)?;
        arguments.set_item("code", own.code)?;
        arguments.set_item("message", &own.message)?;
        arguments.set_item("line", own.line)?;
        arguments.set_item("column", own.column)?;
        arguments.set_item("place", text.get(own.span.clone()).unwrap_or_default())?;
        arguments.set_item("label", &own.label)?;
        arguments.set_item("hint", own.hint.as_deref())?;
        list.append(class.call((), Some(&arguments))?)?;
    }
    Ok(list)
}
