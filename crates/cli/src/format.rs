//! The form of the output.

use clap::ValueEnum;

/// The form of the output on stdout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// Every field of the result, SI units and radians.
    Json,
    /// Tables for a spreadsheet.
    Csv,
}
