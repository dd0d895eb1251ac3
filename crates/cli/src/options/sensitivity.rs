//! The command line of `lanchester sensitivity`.

use crate::format::Format;
use crate::options::printed::BriefArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `sensitivity`
#[derive(Debug, Args)]
pub struct SensitivityArguments {
    /// Engine file.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// What it does something to: the peak of `force`, `couple`, `roll moment`, `torque`, `main bearing 1`, `crankpin 1`, `piston pin 1`, `side thrust 1`
    /// or `mount force NAME` (without a number or name: the largest of all), or `excess energy`, `speed fluctuation`, `bending moment`; behind it `order 2` or `mean`, before it `gas` or
    /// `inertia` where these alone count. May be given several times; default: force, couple and roll moment.
    #[arg(long, value_name = "OUTPUT")]
    pub output: Vec<String>,
    /// How far a quantity goes either way: `rod length = 10 %`, `throw angle = 0.5 deg`. May be given several times; default: 1 % of
    /// sizes and factors, 1 mm of places, 1 deg of directions.
    #[arg(long, value_name = "QUANTITY")]
    pub vary: Vec<String>,
    /// Vary nothing but what --vary names.
    #[arg(long, requires = "vary")]
    pub only: bool,
    /// Vary every part by itself instead of all parts of a kind together.
    #[arg(long)]
    pub each: bool,
    /// What counterweights do while throws and masses vary.
    #[arg(long, value_enum, default_value_t = WeightsOption::Fixed)]
    pub weights: WeightsOption,
    /// Tell shares of the variance too (Sobol's indices), with all quantities anywhere within their ranges, from so many draws.
    #[arg(long, value_name = "DRAWS")]
    pub sobol: Option<u64>,
    /// Seed of the draws; default: 1.
    #[arg(long, value_name = "N", requires = "sobol")]
    pub seed: Option<u64>,
    /// Write the tornado charts as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How a text is printed.
    #[command(flatten)]
    pub printed: BriefArguments,
}

/// What counterweights do while throws and masses vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum WeightsOption {
    /// They stay as they are: of a crankshaft that is made.
    Fixed,
    /// They keep their share of their throw's rotating unbalance, and their direction from it: of a crankshaft that is designed.
    Follow,
}
