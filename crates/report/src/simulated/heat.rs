//! Heat of the last period of a run.

use serde::Serialize;

/// Heat of the computed cycles of all cylinders in one period, at its mean speed [J].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct PeriodHeat {
    /// Mean speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Energy of the fuel.
    pub fuel: f64,
    /// What of it does not burn.
    pub unburned: f64,
    /// Heat to the walls.
    pub walls: f64,
    /// What the exhaust carries away, less what the intake brings.
    pub exhaust: f64,
    /// Work on the pistons in cycles at this speed: that of the run differs by what its speed varies.
    pub indicated: f64,
}

impl PeriodHeat {
    /// Parts of the fuel beside the work, by name.
    pub(crate) fn losses(&self) -> [(&'static str, f64); 3] {
        [("not burned", self.unburned), ("walls", self.walls), ("exhaust", self.exhaust)]
    }
}
