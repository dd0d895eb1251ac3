//! A balance factor from the options of the command line.

use crate::failure::Failure;
use crate::options::workshop::GivenFactor;
use lanchester::task::option::{self, BadQuantity};
use lanchester::workshop::FactorGiven;

/// What the options say of the factor.
pub fn given_factor(options: &GivenFactor) -> Result<FactorGiven, Failure> {
    let share = |text: &str, option| option::share(text, option).map_err(bad);
    Ok(match options {
        GivenFactor { reciprocating_share: Some(text), .. } => {
            FactorGiven::ReciprocatingShare(share(text, "--reciprocating-share")?)
        }
        GivenFactor { wet_share: Some(text), .. } => {
            FactorGiven::WetReciprocatingShare(share(text, "--wet-share")?)
        }
        GivenFactor { total_share: Some(text), .. } => FactorGiven::TotalShare(share(text, "--total-share")?),
        GivenFactor { bobweight_share: Some(text), .. } => {
            FactorGiven::BobweightShare(share(text, "--bobweight-share")?)
        }
        GivenFactor { bobweight: Some(text), .. } => {
            FactorGiven::Bobweight(option::mass(text, "--bobweight").map_err(bad)?)
        }
        GivenFactor { counterweight: Some(text), .. } => {
            FactorGiven::Counterweight(option::unbalance(text, "--counterweight").map_err(bad)?)
        }
        GivenFactor { axis_ratio: Some(text), .. } => {
            FactorGiven::AxisRatio(text.trim().parse().map_err(|_| {
                Failure::input(
                    format_args!("--axis-ratio needs a number, got `{text}`"),
                    "force along the cylinders over force across them, such as 1.5",
                )
            })?)
        }
        GivenFactor { least_peak: true, .. } => FactorGiven::LeastPeak,
        _ => FactorGiven::AsBuilt,
    })
}

/// A quantity of an option that is none.
pub fn bad(bad: BadQuantity) -> Failure {
    Failure::input(&bad.message, &bad.hint)
}
