//! A run in progress.

use crate::powered::Powered;
use crate::run::result::{Cost, Happened, RunState, Stall};
use crate::simulation::Duration;

/// Any time.
pub(crate) const ANY_TIME: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// A run in progress.
pub(crate) struct Runner<'a> {
    pub powered: Powered<'a>,
    /// Time, and state with the crank angle first.
    pub time: f64,
    pub state: Vec<f64>,
    /// Crank angles of kinks within one period, rising.
    pub kinks: Vec<f64>,
    pub period: f64,
    pub pending: Vec<bool>,
    /// Where it ends.
    pub until: Duration,
    /// Whether it goes on from call to call: no samples on the way, the integrator's step is kept, and rest is no end.
    pub is_stepped: bool,
    /// The next step as the integrator proposes it, and whether over the angle [rad] or time [s].
    pub step: Option<(bool, f64)>,
    pub cost: Cost,
    pub happened: Vec<Happened>,
    /// Where the starter could not turn the crank on.
    pub stall: Option<Stall>,
    pub scale: f64,
    pub watch: &'a dyn Fn(RunState) -> bool,
}
