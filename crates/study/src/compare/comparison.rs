//! Engines side by side.

use crate::compare::compared::Compared;
use crate::compare::ranking::Ranking;
use crate::compare::similar::{Equal, Held};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const COMPARISON_VERSION: u32 = 1;

/// Engines side by side.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Comparison {
    /// [`COMPARISON_VERSION`].
    pub version: u32,
    /// In what they were made equal.
    pub equal: Equal,
    /// What they kept while they were.
    pub held: Held,
    /// The engine with which the others are compared, by its place.
    pub reference: usize,
    /// Share of its loads, devices and flywheel that the others are compared with [1].
    pub share: f64,
    /// Fluctuation of the speed that the flywheels keep at the lowest speed [1].
    pub fluctuation: f64,
    /// The engines in the order of the request.
    pub engines: Vec<Compared>,
    /// Their order by every criterion that all of them have.
    pub rankings: Vec<Ranking>,
    /// What the user should know.
    pub warnings: Vec<String>,
}
