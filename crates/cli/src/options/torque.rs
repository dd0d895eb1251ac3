//! The command lines of `lanchester torque` and `lanchester bearings`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `torque`
#[derive(Debug, Args)]
pub struct TorqueArguments {
    /// Engine file with a section [gas]; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Speeds for the power curve, three or more, with commas between: `1000 rpm, 2000 rpm, 3000 rpm`.
    #[arg(long, value_name = "SPEEDS")]
    pub speeds: Option<String>,
    /// Lever of the piston forces.
    #[arg(long, value_enum, default_value_t = LeverOption::Exact)]
    pub lever: LeverOption,
    /// Highest order listed.
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub orders: u32,
    /// Angles a revolution of the traces in JSON and CSV.
    #[arg(long, value_name = "ANGLES", default_value_t = 360, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub samples: u32,
    /// Friction mean effective pressure, with its unit: gives brake torque and power; default: [friction] of the file.
    #[arg(long, value_name = "PRESSURE")]
    pub fmep: Option<String>,
    /// Inertia of the flywheel, with its unit; default: that of [flywheel].
    #[arg(long, value_name = "INERTIA")]
    pub flywheel: Option<String>,
    /// Inertia of the crankshafts with their counterweights, with its unit; default: that of [flywheel] or [crank.body].
    #[arg(long, value_name = "INERTIA")]
    pub crankshaft_inertia: Option<String>,
    /// Find the flywheel that keeps this fluctuation of the speed, highest minus lowest over mean, at the speeds of [flywheel] or at the lowest speed of the file.
    #[arg(long, value_name = "SHARE")]
    pub fluctuation: Option<String>,
    /// Write the figures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// One table alone, as text or CSV.
    #[arg(long, value_enum)]
    pub table: Option<TorqueTable>,
    /// Form of the output; CSV is everything over the crank angle, or the table asked for.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// A table of `torque`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TorqueTable {
    /// Numbers of the computed cycle: trapped mass, residual gas, efficiencies, heat to the walls, residuals.
    Cycle,
    /// The computed cycle over the angle: volume, pressure, temperature, mass, heat, flows.
    CycleAngle,
    /// Cyclic speed fluctuation, or why it is not known.
    SpeedRipple,
    /// Torque, power and energy at the speeds of `--speeds`.
    Speeds,
}

/// Lever of the piston forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LeverOption {
    /// That of the linkage: virtual work.
    Exact,
    /// r sin(theta), as in the twin-cylinder thesis (Louvigny 2008, eq. 22).
    Sine,
}

/// `bearings`
#[derive(Debug, Args)]
pub struct BearingsArguments {
    /// Engine file; `-` reads standard input. Without a section [gas] the loads are those of inertia alone.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speed of crankshaft 1, with its unit; default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Which loads count.
    #[arg(long, value_enum, default_value_t = PartOption::All)]
    pub part: PartOption,
    /// Angles a revolution of the traces in JSON and CSV.
    #[arg(long, value_name = "ANGLES", default_value_t = 360, value_parser = clap::value_parser!(u32).range(4..=100_000))]
    pub samples: u32,
    /// Oil films of main and big-end bearings instead: least film, pressure, friction, flow, temperature; models of cavitation side by side,
    /// default: that of the file, else gumbel.
    #[arg(long, value_enum, value_name = "MODELS", num_args = 0..=1, value_delimiter = ',')]
    pub film: Option<Vec<FilmOption>>,
    /// With `--film`: with the grooves of the file and their supply pressure. The film of a bearing with grooves is then solved at every instant, which takes
    /// seconds; `--film mass-conserving` asks for it too.
    #[arg(long, requires = "film")]
    pub grooves: bool,
    /// With `--film`: the crankshaft as a rigid body with its mass that floats in the films of its mains, which share its loads. Needs [crank.body].
    #[arg(long, requires = "film", conflicts_with = "grooves")]
    pub dynamic: bool,
    /// With `--film`: the least films at these speeds of crankshaft 1, a list or a range, like `1000 rpm .. 6000 rpm by 250 rpm`.
    #[arg(long, value_name = "SPEEDS", requires = "film", conflicts_with = "speed")]
    pub speeds: Option<String>,
    /// With `--film`: least film that is wanted of every bearing, model of cavitation and speed, with its unit.
    #[arg(long, value_name = "LENGTH", requires = "film")]
    pub least_film: Option<String>,
    /// Write polar diagrams as SVG files into this folder; with `--film` orbits and films, with `--speeds` the least films over speed.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output; CSV is everything over the crank angle.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// Model of cavitation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FilmOption {
    /// Negative pressures are kept.
    Full,
    /// Negative pressures of the full film are set to zero.
    Gumbel,
    /// Pressure and its slope vanish together.
    Reynolds,
    /// The oil is kept where the film has none too; for bearings with grooves.
    MassConserving,
}

/// Which loads count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PartOption {
    /// Gas and inertia.
    All,
    /// Gas alone.
    Gas,
    /// Inertia alone.
    Inertia,
}
