//! What a computed cycle gives.

use super::state::{Contents, ThroughFlow};
use lanchester_results::PeriodicCurve;
use serde::Serialize;

/// A cycle of one cylinder by single-zone filling and emptying.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ZoneCycle {
    /// Absolute pressure [Pa] over the angle since firing top dead centre.
    #[serde(skip)]
    pub pressure: PeriodicCurve,
    /// Temperature of the gas [K] over the same angle.
    #[serde(skip)]
    pub temperature: PeriodicCurve,
    /// Mass of the gas [kg] over the same angle.
    #[serde(skip)]
    pub mass: PeriodicCurve,
    /// What has passed since the cylinder closed, over the same angle.
    #[serde(skip)]
    pub since_closing: SinceClosing,
    /// How it came to repeat itself.
    pub outcome: ZoneOutcome,
    /// Angle at which the cylinder closes [rad], negative: before firing.
    pub closing_angle: f64,
    /// What is in it then.
    pub trapped: Contents,
    /// Share of the trapped mass that is not fresh.
    pub residual_share: f64,
    /// Fresh mass taken in over that of the displaced volume at the state before the intake. For two strokes: delivery ratio.
    pub volumetric_efficiency: f64,
    /// Fresh mass trapped over fresh mass taken in.
    pub trapping_efficiency: f64,
    /// Heat of the fuel that is released in a cycle [J].
    pub heat: f64,
    /// What passes in a cycle.
    pub passed: ThroughFlow,
    /// Whether energy and mass close.
    pub balance: Balance,
    /// Net indicated work over the heat released (thermal efficiency); `None` where it is motored.
    pub indicated_efficiency: Option<f64>,
    /// Net indicated work over the energy of the fuel, what does not burn included (fuel conversion efficiency); `None` where it is motored.
    pub fuel_efficiency: Option<f64>,
}

/// What has passed since the cylinder closed, over the angle since firing top dead centre. At the closing angle each jumps back to 0; slopes are the rates
/// a radian.
#[derive(Debug, Clone, PartialEq)]
pub struct SinceClosing {
    /// Work of the gas on the pistons [J].
    pub work: PeriodicCurve,
    /// Heat to the walls [J].
    pub wall_heat: PeriodicCurve,
    /// Heat released [J].
    pub released: PeriodicCurve,
    /// Mass in from the intake and from the exhaust [kg].
    pub mass: [PeriodicCurve; 2],
    /// Enthalpy in with these masses [J].
    pub enthalpy: [PeriodicCurve; 2],
}

/// How a cycle came to repeat itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ZoneOutcome {
    /// Whether the last cycle repeats the one before it within the tolerance.
    pub converged: bool,
    /// Cycles run.
    pub cycles: usize,
    /// Largest change of pressure, mass or fresh mass from cycle to cycle, over their sizes.
    pub change: f64,
}

/// Whether energy and mass close over the last cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Balance {
    /// Gain of internal energy less heat, work and enthalpy [J].
    pub energy: f64,
    /// The same over the largest of what passes.
    pub energy_share: f64,
    /// Gain of mass less what came in [kg].
    pub mass: f64,
    /// The same over the trapped mass.
    pub mass_share: f64,
}
