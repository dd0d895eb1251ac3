//! Options of `lanchester simulate` and `lanchester crosscheck`.

use crate::format::Format;
use crate::options::printed::{BriefArguments, PrintedArguments};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `simulate`
#[derive(Debug, Args)]
pub struct SimulateArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// How long: `10 revolutions` or `2 s`; default: as the file says, else 10 revolutions.
    #[arg(long = "for", value_name = "DURATION", conflicts_with = "until")]
    pub duration: Option<String>,
    /// Search the periodic motion and show one period of it.
    #[arg(long, value_enum)]
    pub until: Option<Until>,
    /// Speed of crankshaft 1 at the start, with its unit; default: as the file says, else its highest speed.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// State at the start, with commas between: a crank angle, a speed, and `equilibrium` or `as drawn` for the block, such as `90 deg, 800 rpm, as drawn`; default: as the file says, else 0 deg, its
    /// highest speed, the block where its mounts carry weight and mean torque.
    #[arg(long, value_name = "STATE")]
    pub start: Option<String>,
    /// Keep this speed by a drive that takes whatever torque it needs.
    #[arg(long)]
    pub imposed: bool,
    /// Let the torques set the speed, where the file says otherwise.
    #[arg(long, conflicts_with = "imposed")]
    pub free: bool,
    /// Whether the block moves; default: on its mounts where the file gives them in a form that a run in time can use.
    #[arg(long, value_enum)]
    pub block: Option<BlockOption>,
    /// Torque of a constant load, with its unit, or `none`; default: as the file says, else with gas the mean that the engine gives at the start speed, of a periodic motion in proportion to the speed.
    #[arg(long, value_name = "TORQUE")]
    pub load: Option<String>,
    /// The load is bolted to the block, as a generator: its reaction goes there instead of to the ground.
    #[arg(long)]
    pub load_on_block: bool,
    /// Numbers of cylinders, with commas between, that fire no more after the first revolution.
    #[arg(long, value_name = "CYLINDERS", value_delimiter = ',')]
    pub misfire: Vec<usize>,
    /// Something that happens on the way, besides what the file says, as `[[simulation.event]]` has it, such as `3 revolutions: load 120 N m` or `speed falls to 900 rpm: fuel 0 %`; may be given several times.
    #[arg(long, value_name = "WHEN: WHAT")]
    pub event: Vec<String>,
    /// A point of the block, `x, y, z`, whose motion is shown; may be given several times.
    #[arg(long, value_name = "X, Y, Z")]
    pub point: Vec<String>,
    /// Leave out the gas of the file.
    #[arg(long)]
    pub inertia_only: bool,
    /// Leave out the weight.
    #[arg(long)]
    pub no_gravity: bool,
    /// Crank angle between samples, with its unit; default: as the file says, else 1 deg.
    #[arg(long, value_name = "ANGLE")]
    pub step: Option<String>,
    /// Relative tolerance of every step, from 1e-13 to 1e-2; default: as the file says, else 1e-9.
    #[arg(long, value_name = "TOLERANCE")]
    pub tolerance: Option<f64>,
    /// Let it take as long as it takes: no bound on evaluations and samples.
    #[arg(long)]
    pub long: bool,
    /// Write every figure as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Table written with `--format csv` or `--format parquet`; default: trace.
    #[arg(long, value_enum, requires = "format")]
    pub table: Option<SimulationTable>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = SimulationFormat::Text)]
    pub format: SimulationFormat,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// The form of a run on stdout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SimulationFormat {
    /// For people.
    Text,
    /// Every field of the result, SI units and radians.
    Json,
    /// Tables for a spreadsheet.
    Csv,
    /// The same tables as Apache Parquet, for Polars, DuckDB or pandas: redirect it into a file.
    Parquet,
}

/// What a run may be searched for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Until {
    /// The motion that repeats after one period.
    Periodic,
}

/// Whether the block moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BlockOption {
    /// It stands still.
    Fixed,
    /// It stands on its mounts.
    Mounts,
}

/// Tables of `simulate --format csv` and `--format parquet`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SimulationTable {
    /// Angle, speed, torques, block and mounts at every sample.
    Trace,
    /// Side thrust, pins, gears and main bearings at every sample.
    Reactions,
    /// Loads, torque, speed and motion of the block by order of the last period, real and imaginary parts.
    Orders,
    /// Largest and smallest values of the whole run, and of its last period.
    Extremes,
    /// Works and stored energies.
    Energy,
    /// Events.
    Events,
}

/// `crosscheck`
#[derive(Debug, Args)]
pub struct CrosscheckArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// One condition alone; may be given several times.
    #[arg(long, value_enum)]
    pub condition: Vec<ConditionOption>,
    /// Highest order listed.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u32).range(0..=64))]
    pub order: u32,
    /// Largest share of the largest amplitude of its kind by which a quantity may differ under condition A.
    #[arg(long, value_name = "SHARE")]
    pub bar: Option<f64>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How a text is printed.
    #[command(flatten)]
    pub printed: BriefArguments,
}

/// Conditions of `crosscheck`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ConditionOption {
    /// Imposed speed, fixed block, no gravity.
    A,
    /// Free speed, fixed block, constant load torque.
    B,
    /// Imposed speed, block on its mounts.
    C,
    /// Free speed, block on its mounts where the file gives them: the bond graph.
    D,
    /// Crankshaft by finite elements in rigid bearings, stiffened until it is rigid and as it is. Only where asked for: it meshes the crankshaft.
    E,
}
