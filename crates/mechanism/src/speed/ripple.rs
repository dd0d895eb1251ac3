//! Inertia of the crank train and the speed within the cycle, as results.

use lanchester_results::Extremes;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const FLYWHEEL_VERSION: u32 = 2;

/// What turns, beside what pistons and rods bring.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct TurningInertia {
    /// Flywheel with clutch, and whatever turns rigidly with crankshaft 1 [kg m^2].
    pub flywheel: f64,
    /// All crankshafts with their counterweights, as seen at crankshaft 1 [kg m^2]; without the rods.
    pub crankshaft: f64,
}

/// Inertia of the crank train seen at crankshaft 1 [kg m^2].
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TrainInertia {
    /// Flywheel and crankshafts as given.
    pub given: TurningInertia,
    /// Balance shafts and gears whose inertia is known, each times its speed ratio squared.
    pub geared: f64,
    /// Big ends of the rods at their crankpins.
    pub big_ends: f64,
    /// Mean over the cycle of pistons, small ends and what the rods' swing adds.
    pub reciprocating_mean: f64,
    /// All of it over the period of the torque, at `theta`.
    pub total: Vec<f64>,
    /// Mean of all of it.
    pub mean: f64,
    /// Its extremes over the samples.
    pub extremes: Extremes,
}

/// Speed over the period, at one mean speed.
///
/// Without gas the load is 0 and the energy stays: the inertia of pistons and rods alone makes the speed swing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SpeedRipple {
    /// [`FLYWHEEL_VERSION`].
    pub version: u32,
    /// Mean speed [rad/s]: angle over time.
    pub mean_speed: f64,
    /// Mean torque of the load [N m]: that of the gas and of the torque over the angle that the file gives.
    pub load: f64,
    /// Period [rad] of crankshaft 1.
    pub period: f64,
    /// Crank angle [rad], from 0, one period, end point excluded.
    pub theta: Vec<f64>,
    /// Speed [rad/s].
    pub speed: Vec<f64>,
    /// Its extremes over the continuous angle.
    pub extremes: Extremes,
    /// Fluctuation `(w_max - w_min) / w_mean` [1].
    pub fluctuation: f64,
    /// Fluctuation by the formula of eq. (25.4): largest excess energy at constant speed over `J w^2`, with the mean inertia.
    pub simple_fluctuation: f64,
    /// Largest excess energy at constant speed [J], gas and inertia.
    pub excess: f64,
    /// Largest size of the angular acceleration [rad/s^2], among the samples.
    pub acceleration: f64,
    /// The inertia that it turns.
    pub inertia: TrainInertia,
}
