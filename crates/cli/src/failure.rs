//! How a command ends other than well, and the exit status that tells it.

use crate::remedies::remedy;
use lanchester::task::option::BadQuantity;
use std::any::Any;
use std::fmt;
use std::process::ExitCode;

/// Exit status: done.
pub const DONE: u8 = 0;
/// Exit status: done, but the answer is not what was asked for; [`exit_statuses`] says in which cases.
pub const NOT_AS_EXPECTED: u8 = 1;
/// Exit status: the input is wrong.
pub const WRONG_INPUT: u8 = 2;
/// Exit status: internal error.
pub const OWN_FAULT: u8 = 3;

/// Every exit status with its meaning, for the help of the program.
pub fn exit_statuses() -> String {
    let meanings = [
        (DONE, "done"),
        (
            NOT_AS_EXPECTED,
            "done, but a limit is not met or cannot be met, an order cannot vanish, a search or a run was\n     \
             stopped before its end, nothing was left to judge, a measurement is in doubt, or a verdict of\n     \
             `validate` is not the expected one",
        ),
        (WRONG_INPUT, "the input is wrong; the message says what fixes it"),
        (OWN_FAULT, "internal error: please report it"),
    ];
    let lines: Vec<String> =
        meanings.iter().map(|(status, meaning)| format!("  {status}  {meaning}")).collect();
    format!("Exit status:\n{}", lines.join("\n"))
}

/// Why a command did not do what it was asked for.
#[derive(Debug)]
pub struct Failure {
    /// Exit status.
    pub status: u8,
    /// What is said on standard error, without a trailing newline; may be empty where all has been said.
    pub message: String,
}

impl Failure {
    /// The input is wrong: `message` says what was needed, `hint` what to do.
    pub fn input(message: impl fmt::Display, hint: impl fmt::Display) -> Failure {
        Failure { status: WRONG_INPUT, message: format!("error: {message}\nhint: {hint}") }
    }

    /// What is asked for cannot be done: `error` says why, with its own hint where there is one, and [`remedy`] which option or
    /// command mends it.
    pub fn refused<E: fmt::Display + Any>(error: E) -> Failure {
        let mends = remedy(&error).map(|mends| format!("\nhint: {mends}")).unwrap_or_default();
        Failure { status: WRONG_INPUT, message: format!("error: {error}{mends}") }
    }

    /// The input is wrong and its diagnostics have been printed.
    pub fn diagnosed() -> Failure {
        Failure { status: WRONG_INPUT, message: String::new() }
    }

    /// Something that should not happen.
    pub fn own(message: impl fmt::Display) -> Failure {
        Failure {
            status: OWN_FAULT,
            message: format!(
                "error: {message}\nhint: this is a fault of lanchester itself, please report it"
            ),
        }
    }

    /// The status for the operating system.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.status)
    }
}

impl From<BadQuantity> for Failure {
    fn from(bad: BadQuantity) -> Failure {
        Failure::input(&bad.message, &bad.hint)
    }
}
