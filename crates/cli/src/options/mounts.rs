//! Options of `lanchester mounts`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, ValueEnum};
use lanchester::mechanism::RotorEffects;
use std::path::PathBuf;

/// `mounts`
#[derive(Debug, Args)]
pub struct MountsArguments {
    /// Engine file with a section [block] and a stiffness in each [[mount]]; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// One speed of crankshaft 1, with its unit, instead of the file's range.
    #[arg(long, value_name = "SPEED", conflicts_with_all = ["speeds", "steps"])]
    pub speed: Option<String>,
    /// Speeds with commas between, instead of the file's range: `700 rpm, 1500 rpm, 3000 rpm`.
    #[arg(long, value_name = "SPEEDS", conflicts_with = "steps")]
    pub speeds: Option<String>,
    /// How many speeds, from the lowest to the highest of the file.
    #[arg(long, value_name = "N", default_value_t = 61, value_parser = clap::value_parser!(u32).range(2..=2000))]
    pub steps: u32,
    /// Highest order.
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub orders: u32,
    /// Point of the block whose motion is told, `x, y, z` with units; may be given several times.
    #[arg(long, value_name = "POINT")]
    pub point: Vec<String>,
    /// What acts of the crankshafts, flywheel and shafts that turn in the block, where their inertia is known.
    #[arg(long, value_enum, default_value_t = RotorOption::Both)]
    pub rotors: RotorOption,
    /// Leave out the gas that the file gives.
    #[arg(long)]
    pub inertia_only: bool,
    /// Write every figure as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Table written with `--format csv`; default: forces.
    #[arg(long, value_enum, requires = "format")]
    pub table: Option<MountsTable>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// What of the rotors acts on the motion of the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RotorOption {
    /// Their gyroscopic couple, and their inertia does not follow the roll.
    Both,
    /// The gyroscopic couple alone.
    Couple,
    /// That their inertia does not follow the roll alone.
    Roll,
    /// Neither: they are held fast in the block.
    None,
}

impl RotorOption {
    pub fn effects(self) -> RotorEffects {
        match self {
            RotorOption::Both => RotorEffects::BOTH,
            RotorOption::Couple => RotorEffects::COUPLE,
            RotorOption::Roll => RotorEffects::ROLL,
            RotorOption::None => RotorEffects::NONE,
        }
    }
}

/// Tables of `mounts --format csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MountsTable {
    /// Force at every mount by speed and order.
    Forces,
    /// Motion of the block's centre and of the points asked for, by speed and order.
    Motion,
    /// Frequencies, shapes and energy shares of the undamped modes.
    Modes,
}
