//! The command line of `lanchester torsion`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `torsion`
#[derive(Debug, Args)]
pub struct TorsionArguments {
    /// Engine file with a flywheel and the sizes of its crankshaft or its stiffnesses in [torsion]; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Speeds of crankshaft 1, rising: a list with commas, or a range like `600 rpm .. 3000 rpm by 25 rpm`; default: 201 over the range of the file.
    #[arg(long, value_name = "SPEEDS")]
    pub speeds: Option<String>,
    /// Highest order; default: that of [torsion], else 12.
    #[arg(long, value_name = "ORDER")]
    pub highest_order: Option<f64>,
    /// Leave the gas of the file out.
    #[arg(long)]
    pub inertia_only: bool,
    /// Find the best setting of the damper: of a viscous one its damping, of rubber its stiffness, or as named.
    #[arg(long, value_enum, value_name = "WHAT")]
    pub tune: Option<TuneOption>,
    /// What the best setting is to keep small.
    #[arg(long, value_enum, default_value_t = AimOption::Twist, requires = "tune")]
    pub aim: AimOption,
    /// Check the sum of orders in the time domain at this speed, with the inertia of rods and pistons as it varies.
    #[arg(long, value_name = "SPEED")]
    pub check: Option<String>,
    /// Where the stiffness of throws comes from: Ker Wilson's lengths, or a mesh of the crankshaft with its journals free to move aside or with their middles held.
    /// Both of a mesh are told, and Ker Wilson's beside them. What [torsion] gives stays.
    #[arg(long, value_enum, default_value_t = StiffnessOption::KerWilson)]
    pub throws: StiffnessOption,
    /// With `--throws free` or `held`: size of the elements, with its unit; default: 10 mm.
    #[arg(long, value_name = "LENGTH")]
    pub size: Option<String>,
    /// With `--throws free` or `held`: most memory that matrix and factor may take, such as `4 GiB`.
    #[arg(long, value_name = "SIZE", default_value = "8 GiB")]
    pub memory: String,
    /// Write the figures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// One table alone, as text or CSV.
    #[arg(long, value_enum)]
    pub table: Option<TorsionTable>,
    /// Form of the output; CSV is everything over speed, or the table asked for.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// Where the stiffness of throws comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StiffnessOption {
    /// Ker Wilson's lengths.
    KerWilson,
    /// Finite elements, journals free to move aside.
    Free,
    /// Finite elements, middles of the journals on the axis.
    Held,
}

/// What of the damper is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TuneOption {
    /// Damping of a viscous damper, stiffness of a rubber one.
    Damper,
    /// The viscous damping.
    Damping,
    /// The stiffness.
    Stiffness,
    /// Damping and stiffness.
    Both,
}

/// What the damper keeps small over the speed range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum AimOption {
    /// Twist between nose and flywheel.
    Twist,
    /// Largest nominal shear stress of the crankshaft.
    Stress,
}

/// A table of `torsion`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TorsionTable {
    /// Inertias with their parts.
    Inertias,
    /// Stiffness, damping and section of every shaft.
    Shafts,
    /// Both stiffnesses of every throw by finite elements, with `--throws`.
    Throws,
    /// Natural frequencies and shapes without damping.
    Modes,
    /// Natural frequencies with damping.
    DampedModes,
    /// Holzer's tables at the first natural frequencies.
    Holzer,
    /// Speeds at which orders meet natural frequencies.
    Criticals,
    /// Vector sums of the star of each order.
    Stars,
    /// Largest torque and stress of every shaft.
    Torques,
    /// Torque of every shaft by order at its peak.
    Orders,
    /// Twist, torques, stress and damper over speed.
    Speeds,
    /// Twist between nose and flywheel by order over speed.
    TwistOrders,
    /// The damper.
    Damper,
    /// The curve of the tuning; with `--tune`.
    Tuning,
    /// Orders, time domain and varying inertia; with `--check`.
    Time,
}
