//! A periodic motion as a result.

use serde::Serialize;

/// The periodic motion, or what was found instead.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "GraphPeriodicMotion")]
pub struct PeriodicMotion {
    /// How Newton ended.
    pub outcome: PeriodicEnd,
    /// Length of the period [s]; of the last trial where none closes.
    pub period: f64,
    /// Largest change over one period, over the size of its state.
    pub residual: f64,
    /// Newton's iterations.
    pub iterations: usize,
    /// Multipliers by falling size: real and imaginary part.
    pub multipliers: Vec<[f64; 2]>,
    /// What happened where no periodic motion was found.
    pub instead: Option<String>,
}

/// How the search for a periodic motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "GraphPeriodicEnd")]
pub enum PeriodicEnd {
    /// Found: small departures from it die out.
    Stable,
    /// Found: some departures stay, for example of the speed under a load that does not depend on it.
    Neutral,
    /// Found: small departures from it grow.
    Unstable,
    /// Not found: the run shows the last trial, which does not close.
    NotFound,
}

impl PeriodicMotion {
    pub(crate) fn not_found(period: f64, instead: String) -> PeriodicMotion {
        PeriodicMotion {
            outcome: PeriodicEnd::NotFound,
            period,
            residual: f64::INFINITY,
            iterations: 0,
            multipliers: Vec::new(),
            instead: Some(instead),
        }
    }
}
