//! The command line of `lanchester workshop`.

use crate::arguments::Format;
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// `workshop`
#[derive(Debug, Args)]
pub struct WorkshopArguments {
    /// What to do.
    #[command(subcommand)]
    pub command: WorkshopCommand,
}

/// The commands of the workshop.
#[derive(Debug, Subcommand)]
pub enum WorkshopCommand {
    /// Permissible residual unbalance of a balance quality grade, allotted to bearings and correction planes.
    #[command(
        after_help = "Examples:\n  lanchester workshop grade rotor.toml\n  lanchester workshop grade rotor.toml --format json\n\n\
                            Exit status 1 where the measured unbalance is more than the grade allows."
    )]
    Grade(GradeArguments),
}

/// `workshop grade`
#[derive(Debug, Args)]
pub struct GradeArguments {
    /// Workshop sheet; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}
