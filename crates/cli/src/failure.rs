//! How a command ends other than well, and the exit status that tells it.

use lanchester::model::option::BadQuantity;
use std::fmt;
use std::process::ExitCode;

/// Exit status: done.
pub const DONE: u8 = 0;
/// Exit status: done, but a requested limit is not met or a validation verdict is not the expected one.
pub const NOT_AS_EXPECTED: u8 = 1;
/// Exit status: the input is wrong.
pub const WRONG_INPUT: u8 = 2;
/// Exit status: our own fault.
pub const OWN_FAULT: u8 = 3;

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

    /// What is asked for cannot be done: `error` says why, with its own hint where there is one.
    pub fn refused(error: impl fmt::Display) -> Failure {
        Failure { status: WRONG_INPUT, message: format!("error: {error}") }
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
