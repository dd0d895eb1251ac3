//! How far a search over choices goes, and what whoever asked is told and says meanwhile.

use crate::error::BalanceError;
use lanchester_task::Stage;
use serde::Serialize;

/// The gap to which a convex programme is solved, relative to the larger of its optimum and a millionth of what it is without
/// the devices.
pub(crate) const PROMISED_GAP: f64 = 1e-8;

/// The widest gap that may be asked for.
const WIDEST_GAP: f64 = 0.5;

/// How far a search over choices goes: places to be found, given and least amounts, devices that may be left out. A task that is
/// one convex programme is always solved to a gap of 1e-8.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BalanceSettings {
    /// The search for a stage ends at this gap between the best value and its bound, relative to the larger of the value and a
    /// millionth of the stage without the devices: 1e-8 to 0.5. Later stages may use up what it leaves.
    pub gap: f64,
    /// Most branch-and-bound nodes examined for one stage, 1 or more.
    pub max_nodes: usize,
    /// Longest time of the whole search [s], above 0; none: no limit. Kept by the caller's clock: see [`BalanceSettings::next`].
    pub time_limit: Option<f64>,
}

impl Default for BalanceSettings {
    fn default() -> BalanceSettings {
        BalanceSettings { gap: PROMISED_GAP, max_nodes: 2000, time_limit: None }
    }
}

impl BalanceSettings {
    /// What to answer a search after `elapsed` seconds by the caller's clock.
    pub fn next(&self, elapsed: f64) -> Next {
        match self.time_limit {
            Some(limit) if elapsed >= limit => Next::Stop(StopCause::TimeLimit),
            _ => Next::Continue,
        }
    }

    /// Refuses what is outside its range.
    ///
    /// # Errors
    /// [`BalanceError::Setting`].
    pub fn check(&self) -> Result<(), BalanceError> {
        let refuse = |setting, needed, got: f64| Err(BalanceError::Setting { setting, needed, got });
        if !(PROMISED_GAP..=WIDEST_GAP).contains(&self.gap) {
            return refuse("gap", "from 1e-8 to 0.5 of the value", self.gap);
        }
        if self.max_nodes == 0 {
            return refuse("largest number of nodes", "1 or more", 0.0);
        }
        match self.time_limit {
            Some(limit) if !(limit.is_finite() && limit > 0.0) => {
                refuse("time limit", "more than 0 s", limit)
            }
            _ => Ok(()),
        }
    }

    /// The gap as a multiple of the one that every convex programme is solved to.
    pub(crate) fn looseness(&self) -> f64 {
        (self.gap / PROMISED_GAP).max(1.0)
    }
}

/// Why a search ended before its gap was closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StopCause {
    /// [`BalanceSettings::max_nodes`] were examined.
    MaxNodes,
    /// [`BalanceSettings::time_limit`] has passed.
    TimeLimit,
    /// Whoever asked wants the best so far.
    Cancelled,
    /// Rounding lets no more be proved.
    Rounding,
}

/// What a search does next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Next {
    /// Goes on.
    Continue,
    /// Ends with the best so far and its bound.
    Stop(StopCause),
    /// Ends without an answer ([`BalanceError::BrokenOff`]): nobody waits for it.
    Abandon,
}

/// Where a search stands, before each of its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchState<'a> {
    /// The stage that is searched; none where it is searched how far limits that cannot hold must be relaxed.
    pub stage: Option<&'a Stage>,
    /// Its number among the stages, from 0.
    pub index: usize,
    /// How many stages there are, those that only decide among equals included.
    pub stages: usize,
    /// The best value so far, if any choice was found that holds the limits: SI unit of the stage.
    pub value: Option<f64>,
    /// Nothing that is allowed goes below this.
    pub bound: f64,
    /// Nodes examined, all stages together.
    pub nodes: usize,
}

/// Asked before each node of a search.
pub(crate) type Watch<'a> = dyn Fn(&SearchState<'_>) -> Next + 'a;
