//! A layout that is kept.

use serde::{Deserialize, Serialize};

/// A layout that is kept: on the front, or among the first of the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Candidate {
    /// Number of the case in its space; of equal ones the lowest.
    pub case: u128,
    /// Its objectives in the order of the request, in SI units.
    pub values: Vec<f64>,
    /// The objectives in whole steps of their resolution: what is compared.
    pub steps: Vec<i64>,
    /// Cases with the same steps, this one included.
    pub alike: u128,
}
