//! The command line of `lanchester compare`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `compare`
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// Engine files, two or more; or one with --arrangements, --optimum or a file as --reference.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// The engine with which the others are compared: its number, from 1, in the order of the table; or an engine file of its own, which
    /// then stands first and as it is.
    #[arg(long, value_name = "N|FILE", default_value = "1")]
    pub reference: String,
    /// Share of the reference that the others are compared with, its line in the bars: `1/2` for twins beside half a four; default: all of it.
    #[arg(long, value_name = "SHARE")]
    pub share: Option<String>,
    /// Put every engine on two stiff mounts, so far apart along the crank, and compare the force at them: what forces and couples do
    /// together. Default: the mounts of each file.
    #[arg(long, value_name = "LENGTH")]
    pub mount_spacing: Option<String>,
    /// In what the engines are made equal to the reference, as similar engines of another size; default: in nothing.
    #[arg(long, value_enum)]
    pub equal: Option<EqualOption>,
    /// What a similar engine keeps.
    #[arg(long, value_enum, default_value_t = HeldOption::Speed, requires = "equal")]
    pub hold: HeldOption,
    /// Speed of crankshaft 1 of all engines, with its unit; default: the highest of each file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Compare arrangements of the twin-cylinder thesis, by their numbers, for every file: `1,2,4`, or `all`.
    #[arg(long, value_name = "NUMBERS")]
    pub arrangements: Option<String>,
    /// Compare every file with the best counterweights and shafts for its own task too.
    #[arg(long)]
    pub optimum: bool,
    /// Fluctuation of the speed that the flywheels keep at the lowest speed, highest minus lowest over mean; default: 2 %.
    #[arg(long, value_name = "SHARE")]
    pub fluctuation: Option<String>,
    /// Compare the smallest safety of the fillets by finite elements too, at the lowest speed and at that of the comparison: seconds to minutes an
    /// engine. Oil films of the bearings (some tenths of a second an engine) and the formulas after UR M53 (milliseconds, with torsional vibration tens of them) are compared in any case, where
    /// the files have [bearings.film] with clearances, and [crank.body] with fillets and [crank.material].
    #[arg(long)]
    pub finite_elements: bool,
    /// Write the bars as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// In what engines are made equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EqualOption {
    /// In displacement.
    Displacement,
    /// In net indicated power; without gas in all files at equal mean effective pressure.
    Power,
}

/// What a similar engine keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum HeldOption {
    /// Its speed.
    Speed,
    /// Its mean piston speed.
    PistonSpeed,
}
