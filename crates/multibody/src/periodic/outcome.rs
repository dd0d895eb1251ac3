//! How the search for a periodic motion ended.

use serde::Serialize;

/// How far a motion was followed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Followed {
    /// Whole periods.
    pub periods: usize,
    /// Their time [s].
    pub time: f64,
    /// Speed of crankshaft 1 [rad/s] at the start, one period before the end, and at the end.
    pub speeds: [f64; 3],
    /// Whether the crank came to rest in the period behind them.
    pub came_to_rest: bool,
}

/// How the search for a periodic motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PeriodicOutcome {
    /// Found: small departures from it die out.
    Stable,
    /// Found: the load does not depend on the speed, so that departures of the speed stay.
    Neutral,
    /// Found: small departures from it grow.
    Unstable,
    /// Not found: the run shows the last period that was followed, which does not close, or how the crank came to rest.
    NotFound,
    /// Whoever watched the search ended it: the run is a period of the best trial so far, which need not close.
    Cancelled,
}
