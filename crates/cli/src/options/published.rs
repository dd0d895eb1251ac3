//! The options of the published methods of `balance`.

use clap::{Args, ValueEnum};

/// Shafts of the matrix method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MatrixShafts {
    /// First and second order.
    Both,
    /// First order alone.
    First,
    /// Second order alone.
    Second,
    /// None.
    None,
}

/// Choices of a published method.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Published methods")]
pub struct PublishedArguments {
    /// matrix: webs with a counterweight, 1 or 0 for each from the free end; default: all.
    #[arg(long, value_name = "PATTERN")]
    pub webs: Option<String>,
    /// matrix: counterweight offset angle, from the line of its throw; default: the one that leaves the least.
    #[arg(long, value_name = "ANGLE")]
    pub alpha: Option<String>,
    /// matrix: distance of the counterweights' centre of gravity from the crank axis; default: the crank radius.
    #[arg(long, value_name = "LENGTH")]
    pub counterweight_radius: Option<String>,
    /// matrix: which pairs of balance shafts; default: both.
    #[arg(long, value_enum)]
    pub shafts: Option<MatrixShafts>,
    /// matrix: no first-order shaft that turns with the crank; heavier counterweights take its share.
    #[arg(long)]
    pub first_on_crank: bool,
    /// matrix: distance of the shaft weights' centre of gravity from their axis; default: that of the counterweights.
    #[arg(long, value_name = "LENGTH")]
    pub shaft_radius: Option<String>,
    /// matrix, half: distance of the two weights of a shaft; default: that of the outermost throws.
    #[arg(long, value_name = "LENGTH")]
    pub shaft_length: Option<String>,
    /// matrix, half: distance of the shafts from the crank axis, along y to both sides, twice as far for the second order
    /// of the matrix method; default: 100 mm.
    #[arg(long, value_name = "LENGTH")]
    pub shaft_distance: Option<String>,
    /// half: share of the reciprocating masses that the counterweights take; default: the rule of the engine, or 50 %.
    #[arg(long, value_name = "SHARE")]
    pub balance_factor: Option<String>,
    /// matrix, half: with what the source prints wrongly: the V engine's shafts, the phase of the three's balancer.
    #[arg(long, conflicts_with = "balance_factor")]
    pub as_printed: bool,
    /// sweep: step of the unbalance; default: 1e-5 kg m, more for a much larger engine.
    #[arg(long, value_name = "UNBALANCE")]
    pub step: Option<String>,
    /// sweep: equally spaced angles a revolution at which the load is looked at; default: 360.
    #[arg(long, value_name = "ANGLES", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub grid: Option<u32>,
    /// sweep: motion of the pistons, as for `loads`; the thesis has `power:4:5`.
    #[arg(long, value_name = "SERIES")]
    pub series: Option<String>,
}
