//! The command line of `lanchester complete`.

use clap::Args;
use clap::builder::PossibleValuesParser;
use lanchester::file::{EngineKind, TypicalSection};
use std::path::PathBuf;

/// `complete`
#[derive(Debug, Args)]
pub struct CompleteArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Section to complete; may be given several times. Default: all.
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(TypicalSection::ALL.map(TypicalSection::word)))]
    pub section: Vec<String>,
    /// Kind of engine that the values are typical of; default: what stroke, speeds, layout and gas of the file say.
    #[arg(long, value_name = "KIND", value_parser = PossibleValuesParser::new(EngineKind::ALL.map(EngineKind::word)))]
    pub kind: Option<String>,
    /// Write the completed text into the engine file; what it holds stays as it is.
    #[arg(long, conflicts_with_all = ["dry_run", "output"])]
    pub write: bool,
    /// Show what --write would change.
    #[arg(long, conflicts_with = "output")]
    pub dry_run: bool,
    /// Write to this file instead of standard output; never overwrites.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
}
