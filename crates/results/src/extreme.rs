//! An extreme of a quantity over the period, and where it is.

use serde::Serialize;

/// An extreme and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Extreme {
    /// Value [N] or [N m].
    pub value: f64,
    /// Crank angle [rad] of the first place that attains it, in one period.
    pub theta: f64,
}

/// Largest and smallest value of one quantity over the period.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Extremes {
    /// Largest value.
    pub max: Extreme,
    /// Smallest value.
    pub min: Extreme,
}

impl Extremes {
    /// Largest absolute value.
    pub fn max_abs(&self) -> f64 {
        self.max.value.abs().max(self.min.value.abs())
    }

    /// Largest minus smallest value.
    pub fn range(&self) -> f64 {
        self.max.value - self.min.value
    }
}
