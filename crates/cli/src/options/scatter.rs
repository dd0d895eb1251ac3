//! The command line of `lanchester scatter`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use crate::options::run::RunArguments;
use clap::Args;
use std::path::PathBuf;

/// `scatter`
#[derive(Debug, Args)]
pub struct ScatterArguments {
    /// Engine file with a section [tolerances].
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of the crankshaft, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Engines that are drawn.
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    pub samples: u64,
    /// Seed of the draws: the same seed draws the same engines.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Leave the peaks over all orders out: orders 1 and 2 alone are drawn several times faster.
    #[arg(long)]
    pub orders_only: bool,
    /// What the production should keep: `couple order 1 = 4 N m`, `force = 200 N`. May be given several times.
    #[arg(long, value_name = "LIMIT")]
    pub limit: Vec<String>,
    /// Capability with which a limit is met, by percentiles; default: 1.33.
    #[arg(long, value_name = "NUMBER", requires = "limit")]
    pub capability: Option<f64>,
    /// The table of drawn engines.
    #[command(flatten)]
    pub run: RunArguments,
    /// Write the distributions as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}
