//! The command line of `lanchester export`.

use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;

/// `export`
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// In which format.
    #[command(subcommand)]
    pub command: ExportCommand,
}

/// Formats of `export`.
#[derive(Debug, Subcommand)]
pub enum ExportCommand {
    /// Forces at mounts and main bearings by order and speed as Nastran bulk data: RLOAD1, TABLED1, DAREA, DLOAD, FREQ, GRID.
    #[command(after_help = "Examples:\n  lanchester export nastran four.toml --output four.bdf\n  \
                            lanchester export nastran four.toml --points mounts --speeds '700 rpm .. 6000 rpm by 100 rpm' --orders 6\n\n\
                            Every order is a load set that a subcase names by DLOAD and FREQUENCY; grid points stand in the frame of the \
                            engine (x up, z along the crankshaft).")]
    Nastran(BulkArguments),
    /// The same as a universal file: datasets 164 (units), 2411 (nodes) and 58 (an order function over speed a node, direction and order).
    #[command(after_help = "Examples:\n  lanchester export universal four.toml --output four.unv")]
    Universal(ForcesArguments),
    /// Loads over one period at constant speed as CSV or Parquet: time, crank angle, shaking force, couple, roll moment, torque, gas pressure, mounts, main bearings.
    #[command(after_help = "Examples:\n  lanchester export history four.toml --output four.parquet\n  \
                            lanchester export history four.toml --speed '3000 rpm' --samples 3600 --output four.csv")]
    History(HistoryArguments),
    /// The crank train as a script for Exudyn, a multibody program: run, it compares its loads with ours.
    #[command(
        after_help = "Examples:\n  lanchester export exudyn four.toml --output four.py && pip install exudyn && python four.py"
    )]
    Exudyn(ScriptArguments),
    /// The loads, or the crank train at free speed, as a functional mock-up unit (FMI 2.0 or 3.0, co-simulation) for Simulink, Modelica tools, FMPy and others.
    #[command(after_help = "Examples:\n  lanchester export fmu four.toml --output four.fmu\n  \
                            lanchester export fmu four.toml --fmi 3 --output four.fmu\n  \
                            lanchester export fmu generator.toml --model crank-train --output generator.fmu\n\n\
                            loads: inputs are speed [rad/s], held over a step, and gas on or off; outputs are crank angle, shaking force, couple, \
                            roll moment, torque, and the forces on the mounts that the file gives, all as at that speed for good.\n\
                            crank-train: inputs are load torque [N m] and fuel, held over a step; outputs are crank angle, speed, torques, motion of the \
                            block and forces on the mounts, as `simulate` computes them at free speed, with the events of the file.\n\n\
                            The unit holds the engine file and a binary for this platform.")]
    Fmu(UnitArguments),
}

/// Which model `export fmu` writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum UnitModel {
    /// The loads of the closed form at a speed that is given.
    Loads,
    /// The crank train in time at free speed, as `simulate` runs it.
    CrankTrain,
}

/// `export fmu`
#[derive(Debug, Args)]
pub struct UnitArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What the unit computes.
    #[arg(long, value_enum, default_value_t = UnitModel::Loads)]
    pub model: UnitModel,
    /// Version of the standard: 2, which nearly every program reads, or 3.
    #[arg(long, value_name = "VERSION", default_value_t = 2, value_parser = clap::value_parser!(u8).range(2..=3))]
    pub fmi: u8,
    /// The unit, `.fmu`; never overwrites.
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
}

/// `export nastran`, `export universal`
#[derive(Debug, Args)]
pub struct ForcesArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Which points are loaded.
    #[arg(long, value_enum, default_value_t = PointsOption::All)]
    pub points: PointsOption,
    /// Speeds of crankshaft 1, a list or a range, instead of the file's: `700 rpm .. 6000 rpm by 100 rpm`.
    #[arg(long, value_name = "SPEEDS", conflicts_with = "steps")]
    pub speeds: Option<String>,
    /// How many speeds, from the lowest to the highest of the file.
    #[arg(long, value_name = "N", default_value_t = 31, value_parser = clap::value_parser!(u32).range(2..=2000))]
    pub steps: u32,
    /// Highest order.
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub orders: u32,
    /// Leave out the gas that the file gives.
    #[arg(long)]
    pub inertia_only: bool,
    /// Number of the first mount's node; main bearings count from a thousand more.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=90_000_000))]
    pub first_node: u32,
    /// The file, `-` for standard output; never overwrites.
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,
}

/// `export nastran`
#[derive(Debug, Args)]
pub struct BulkArguments {
    #[command(flatten)]
    pub forces: ForcesArguments,
    /// Number of the first load set: DLOAD and FREQ of each order, then RLOAD1 and DAREA.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=90_000_000))]
    pub first_set: u32,
    /// Number of the first table (TABLED1); default: behind the last set.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=90_000_000))]
    pub first_table: Option<u32>,
}

/// Which points are loaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PointsOption {
    /// Mounts and main bearings, as far as the file gives them.
    All,
    /// The mounts.
    Mounts,
    /// The main bearings.
    Bearings,
}

/// `export history`
#[derive(Debug, Args)]
pub struct HistoryArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Angles a revolution.
    #[arg(long, value_name = "ANGLES", default_value_t = 720, value_parser = clap::value_parser!(u32).range(8..=100_000))]
    pub samples: u32,
    /// The table, `.csv` or `.parquet`.
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
}

/// `export exudyn`
#[derive(Debug, Args)]
pub struct ScriptArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// The script, `-` for standard output; never overwrites.
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,
}
