//! The command line of `lanchester workshop`.

mod crank;

pub use crank::{
    BobweightArguments, CrankArguments, CrankInput, ExternalArguments, FactorArguments, GivenFactor,
    InternalArguments,
};

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// `workshop`
#[derive(Debug, Args)]
pub struct WorkshopArguments {
    /// What to do.
    #[command(subcommand)]
    pub command: WorkshopCommand,
}

/// The commands of the workshop. One is made in the life of the program: its size does not matter.
#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant)]
pub enum WorkshopCommand {
    /// Balance factor of every throw by every definition, and the first-order force that it leaves.
    #[command(
        after_help = "Examples:\n  lanchester workshop factor single.toml\n  lanchester workshop factor single.toml --reciprocating-share 60%\n  \
                            lanchester workshop factor single.toml --bobweight '512 g' --oil '12 g'\n  \
                            lanchester workshop factor single.toml --least-peak --figure ellipse.svg"
    )]
    Factor(FactorArguments),
    /// Bobweight of every crankpin from weighed parts, the share that is right for the layout, and how far the crank is
    /// then from the optimum.
    #[command(
        after_help = "Examples:\n  lanchester workshop bobweight v8-sheet.toml\n  lanchester workshop bobweight v8-sheet.toml --format csv > bobweights.csv\n\n\
                            A sheet that names an `engine` is compared with the best two weights at the ends of its crank."
    )]
    Bobweight(BobweightArguments),
    /// Static, couple and dynamic unbalance of a crank that carries its bobweights; tilt of its principal axis.
    #[command(
        after_help = "Examples:\n  lanchester workshop crank v8.toml\n  lanchester workshop crank v8.toml --planes 'front=-180 mm, rear=200 mm' --bobweight '1712 g'\n  \
                            lanchester workshop crank v8.toml --sheet v8-sheet.toml\n\n\
                            A sheet gives the bobweights ([parts]), two planes ([[plane]] with z) and the crank as a body ([rotor] with mass, centre,\n\
                            transverse_inertia and polar_inertia); options go before it."
    )]
    Crank(CrankArguments),
    /// Weights that damper and flywheel must carry where the counterweights inside are too light.
    #[command(
        after_help = "Examples:\n  lanchester workshop external v8.toml --planes 'damper=-290 mm, flywheel=330 mm'\n  \
                            lanchester workshop external v8.toml --planes 'damper=-290 mm, flywheel=330 mm' --keep 70%"
    )]
    External(ExternalArguments),
    /// Tungsten slugs, axes parallel to the shaft, that take over from weights on damper and flywheel.
    #[command(after_help = "Examples:\n  lanchester workshop internal slugs.toml\n\n\
                            Exit status 1 where the counterweights have not enough room.")]
    Internal(InternalArguments),
    /// Where to add or remove how much: from vibration with trial weights, or from a balancing machine's display.
    #[command(
        after_help = "Examples:\n  lanchester workshop correct rotor.toml\n  lanchester workshop correct rotor.toml --figure vibration.svg\n  \
                            lanchester workshop correct rotor.toml --format csv > corrections.csv\n\n\
                            Exit status 1 where a vibration limit or the balance grade of the sheet does not hold yet."
    )]
    Correct(CorrectArguments),
    /// Which holes to drill for the correction, how deep, and what they leave.
    #[command(
        after_help = "Examples:\n  lanchester workshop drill crank.toml\n  lanchester workshop drill crank.toml --format json\n\n\
                            Exit status 1 where the balance grade is not kept with these holes; without a grade, where they \
                            cannot take away what is wanted."
    )]
    Drill(DrillArguments),
    /// Permissible residual unbalance of a balance quality grade, allotted to bearings and correction planes.
    #[command(
        after_help = "Examples:\n  lanchester workshop grade rotor.toml\n  lanchester workshop grade rotor.toml --format json\n\n\
                            Exit status 1 where the measured unbalance is more than the grade allows."
    )]
    Grade(GradeArguments),
    /// Which of the weighed pistons and rods belongs into which cylinder, so that the first order is least.
    #[command(
        after_help = "Examples:\n  lanchester workshop assign four.toml --pistons '401.2 g, 399.8 g, 400.5 g, 400.9 g'\n  \
                            lanchester workshop assign four.toml --big-ends '452 g, 455 g, 450 g, 451 g' --small-ends '160 g, 162 g, 161 g, 160 g'\n\n\
                            Up to eight cylinders all assignments are gone through; beyond, a bound tells what could be left to gain."
    )]
    Assign(AssignArguments),
}

/// `workshop assign`
#[derive(Debug, Args)]
pub struct AssignArguments {
    /// Engine file: the masses of its own pistons and rods count where none are weighed.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Masses of the pistons with pin, rings and clips, one for each cylinder, separated by commas.
    #[arg(long, value_name = "MASSES")]
    pub pistons: Option<String>,
    /// Masses of the rods at their big ends, rod by rod.
    #[arg(long, value_name = "MASSES")]
    pub big_ends: Option<String>,
    /// Masses of the rods at their small ends, in the same order.
    #[arg(long, value_name = "MASSES")]
    pub small_ends: Option<String>,
    /// A couple counts as its forces over this length; default: the distance of the outer mounts along the crank, else of the outer
    /// cylinders.
    #[arg(long, value_name = "LENGTH")]
    pub lever: Option<String>,
    /// Speed of crankshaft 1, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop correct`
#[derive(Debug, Args)]
pub struct CorrectArguments {
    /// Workshop sheet; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Draw the vibration vectors and the corrections into this SVG file.
    #[arg(long, value_name = "SVG")]
    pub figure: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop drill`
#[derive(Debug, Args)]
pub struct DrillArguments {
    /// Workshop sheet; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop grade`
#[derive(Debug, Args)]
pub struct GradeArguments {
    /// Workshop sheet; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}
