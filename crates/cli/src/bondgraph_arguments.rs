//! The command line of `lanchester bondgraph`.

use crate::format::Format;
use clap::{Args, ValueEnum};

/// `bondgraph`
#[derive(Debug, Args)]
pub struct BondgraphArguments {
    /// What to show, and the graph file (`-`: standard input): causality, equations, linear, simulate, audit, draw or export; without it
    /// causality and equations.
    #[arg(value_names = ["ACTION", "FILE"], required = true, num_args = 1..=2)]
    pub words: Vec<String>,
    /// How equations are written.
    #[arg(long, value_enum, default_value_t = NotationOption::Text)]
    pub notation: NotationOption,
    /// Which stores causality assigns first: `derivative` shows the dual, for study.
    #[arg(long, value_enum, default_value_t = PreferOption::Integral)]
    pub prefer: PreferOption,
    /// Duration of the simulation, with its unit; default: that of the file, else 1 s.
    #[arg(long = "for", value_name = "TIME")]
    pub duration: Option<String>,
    /// Samples of the simulation beside its start.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub samples: Option<u32>,
    /// Relative tolerance of the simulation, 1e-13 to 0.01.
    #[arg(long, value_name = "SHARE")]
    pub tolerance: Option<f64>,
    /// Method of the simulation; default: explicit, and implicit from where stiffness is measured.
    #[arg(long, value_enum)]
    pub method: Option<MethodOption>,
    /// Which text `export` writes.
    #[arg(long, value_enum, default_value_t = ExportOption::Modelica)]
    pub to: ExportOption,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// How equations are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum NotationOption {
    /// Plain text.
    Text,
    /// LaTeX.
    Latex,
}

/// Which stores causality assigns first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PreferOption {
    /// Stores become states.
    Integral,
    /// Stores follow.
    Derivative,
}

/// Methods of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MethodOption {
    /// DOP853, order 8.
    Explicit,
    /// Radau IIA, order 5.
    Implicit,
}

/// Texts for other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExportOption {
    /// One flat Modelica model.
    Modelica,
    /// GraphML.
    Graphml,
    /// Equations and causality as JSON.
    Json,
}
