//! The commands of the workshop that are about a crank, its counterweights and its bobweights.

use crate::arguments::Format;
use clap::Args;
use std::path::PathBuf;

/// A balance factor by one of its definitions; none: the counterweights of the file.
#[derive(Debug, Clone, Args)]
#[group(multiple = false)]
pub struct GivenFactor {
    /// Share of the reciprocating mass that the counterweight takes beyond the rotating mass, as motorcycle shops
    /// count it; V8 shops: 100 % of the rotating and this share of the reciprocating mass.
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true)]
    pub reciprocating_share: Option<String>,
    /// The same with the oil of --oil counted as rotating.
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true, requires = "oil")]
    pub wet_share: Option<String>,
    /// Share of rotating and reciprocating mass together.
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true)]
    pub total_share: Option<String>,
    /// Mass at each crankpin that brings the crank to rest.
    #[arg(long, value_name = "MASS")]
    pub bobweight: Option<String>,
    /// That mass over all masses at the pin: big ends and reciprocating.
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true)]
    pub bobweight_share: Option<String>,
    /// The counterweight's part opposite each throw, mass times radius.
    #[arg(long, value_name = "UNBALANCE")]
    pub counterweight: Option<String>,
    /// First-order force along the cylinders over that across them; 1 is a circle.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
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
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub angle: Option<String>,
    /// Draw the primary ellipse into this SVG file.
    #[arg(long, value_name = "SVG")]
    pub figure: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}
