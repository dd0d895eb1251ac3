//! What is differentiated: an engine at one speed, under its gas.

use super::follow::Weights;
use lanchester_mechanism::{CylinderGas, KnownInertia, OuterTorque};
use lanchester_model::Engine;

/// An engine at one speed with the pressures on its pistons.
///
/// The pressures are functions of the angle since each cylinder's firing top dead centre. They stay what they are when an input goes; only
/// the top dead centre that they count from moves with the linkage.
#[derive(Debug, Clone, PartialEq)]
pub struct OperatingPoint {
    /// The engine.
    pub engine: Engine,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Pressures of every cylinder at that speed; `None` where the file says nothing of gas, or no output needs it.
    pub gas: Option<Vec<CylinderGas>>,
    /// Flywheel and crankshafts, for the fluctuation of the speed and for the block on its mounts.
    pub turning: KnownInertia,
    /// Torques on crankshaft 1 over its angle beside those of gas and inertia, for the fluctuation of the speed.
    pub outer: OuterTorque,
    /// What the counterweights do while throws and masses vary.
    pub weights: Weights,
}

impl OperatingPoint {
    /// An engine without gas and flywheel.
    pub fn of_inertia(engine: Engine, speed: f64) -> OperatingPoint {
        OperatingPoint {
            engine,
            speed,
            gas: None,
            turning: KnownInertia::default(),
            outer: OuterTorque::default(),
            weights: Weights::Fixed,
        }
    }
}
