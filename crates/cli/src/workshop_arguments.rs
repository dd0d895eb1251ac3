//! The command line of `lanchester workshop`.

mod crank;

pub use crank::{FactorArguments, GivenFactor};

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
    /// Balance factor of every throw by every definition, and the first-order force that it leaves.
    #[command(
        after_help = "Examples:\n  lanchester workshop factor single.toml\n  lanchester workshop factor single.toml --reciprocating-share 60%\n  \
                            lanchester workshop factor single.toml --bobweight '512 g' --oil '12 g'\n  \
                            lanchester workshop factor single.toml --least-peak --figure ellipse.svg"
    )]
    Factor(FactorArguments),
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
