//! The commands of the workshop that are about a crank, its counterweights and its bobweights.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::Args;
use std::path::PathBuf;

/// A balance factor by one of its definitions; none: the counterweights of the file.
#[derive(Debug, Clone, Args)]
#[group(multiple = false)]
pub struct GivenFactor {
    /// Share of the reciprocating mass that the counterweight takes beyond the rotating mass, as motorcycle shops
    /// count it; V8 shops: 100 % of the rotating and this share of the reciprocating mass.
    #[arg(long, value_name = "SHARE")]
    pub reciprocating_share: Option<String>,
    /// The same with the oil of --oil counted as rotating.
    #[arg(long, value_name = "SHARE", requires = "oil")]
    pub wet_share: Option<String>,
    /// Share of rotating and reciprocating mass together.
    #[arg(long, value_name = "SHARE")]
    pub total_share: Option<String>,
    /// Mass at each crankpin that brings the crank to rest.
    #[arg(long, value_name = "MASS")]
    pub bobweight: Option<String>,
    /// That mass over all masses at the pin: big ends and reciprocating.
    #[arg(long, value_name = "SHARE")]
    pub bobweight_share: Option<String>,
    /// The counterweight's part opposite each throw, mass times radius.
    #[arg(long, value_name = "UNBALANCE")]
    pub counterweight: Option<String>,
    /// First-order force along the cylinders over that across them; 1 is a circle.
    #[arg(long, value_name = "NUMBER")]
    pub axis_ratio: Option<String>,
    /// The factor with the smallest peak of the first-order force.
    #[arg(long)]
    pub least_peak: bool,
}

/// `workshop factor`
#[derive(Debug, Args)]
pub struct FactorArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "ENGINE")]
    pub engine: PathBuf,
    /// The factor.
    #[command(flatten)]
    pub given: GivenFactor,
    /// Oil that fills each throw, as a mass at the crank radius.
    #[arg(long, value_name = "MASS")]
    pub oil: Option<String>,
    /// Direction of the counterweight from the throw; default: as built, or 180 deg.
    #[arg(long, value_name = "ANGLE")]
    pub angle: Option<String>,
    /// Draw the primary ellipse into this SVG file.
    #[arg(long, value_name = "SVG")]
    pub figure: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop bobweight`
#[derive(Debug, Args)]
pub struct BobweightArguments {
    /// Workshop sheet with [parts]; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// A crank and its bobweights.
#[derive(Debug, Args)]
pub struct CrankInput {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "ENGINE")]
    pub engine: PathBuf,
    /// What the bobweights stand for; default: those of the sheet, or 50 % of the reciprocating mass.
    #[command(flatten)]
    pub given: GivenFactor,
    /// Oil that fills each throw, as a mass at the crank radius.
    #[arg(long, value_name = "MASS")]
    pub oil: Option<String>,
    /// Workshop sheet of this crank.
    #[arg(long, value_name = "SHEET")]
    pub sheet: Option<PathBuf>,
    /// Number of the crankshaft.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub crankshaft: usize,
}

/// `workshop crank`
#[derive(Debug, Args)]
pub struct CrankArguments {
    /// The crank.
    #[command(flatten)]
    pub crank: CrankInput,
    /// Two planes, `name=z, name=z`; default: those of the sheet, or the outermost webs.
    #[arg(long, value_name = "PLANES")]
    pub planes: Option<String>,
    /// Draw what the crank carries along its length, and what is left, into this SVG file.
    #[arg(long, value_name = "FILE")]
    pub figure: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop external`
#[derive(Debug, Args)]
pub struct ExternalArguments {
    /// The crank.
    #[command(flatten)]
    pub crank: CrankInput,
    /// The two planes outside, `name=z, name=z`; with `name=z @ radius` the mass of the weight at that radius is told too.
    #[arg(long, value_name = "PLANES")]
    pub planes: String,
    /// Share of every counterweight of the file that stays.
    #[arg(long, value_name = "SHARE", default_value = "100%")]
    pub keep: String,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `workshop internal`
#[derive(Debug, Args)]
pub struct InternalArguments {
    /// Workshop sheet with [[external]], [slug] and two [[plane]]; `-` reads standard input.
    #[arg(value_name = "SHEET")]
    pub sheet: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}
