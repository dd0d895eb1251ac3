//! Weights on the crank webs as a choice of the search.

use serde::{Deserialize, Serialize};

/// Weights on the crank webs, by what they answer.
///
/// The weight of a web stands opposite the throws of its group and has half of `rotating` times the rotating unbalance
/// (crank and big ends) and `reciprocating` times the reciprocating mass times crank radius of the group: 1 and 0 on all
/// webs balance each throw in itself, 0.5 and 0 half of it, 1 and 0.5 are a balance factor of 50 %.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CounterweightPattern {
    /// What the user calls it.
    pub name: String,
    /// Share of the rotating unbalance.
    pub rotating: f64,
    /// Share of the reciprocating mass.
    pub reciprocating: f64,
    /// Whether each web has its weight, from the free end, two webs a group; `None`: all have.
    pub webs: Option<Vec<bool>>,
}
