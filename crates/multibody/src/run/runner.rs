//! A run in progress.

use crate::powered::Powered;
use crate::run::result::{Cost, Happened, RunState};

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
    pub step: Option<f64>,
    pub cost: Cost,
    pub happened: Vec<Happened>,
    pub scale: f64,
    pub watch: &'a dyn Fn(RunState) -> bool,
}
