//! What the gas gives a run on average, and what friction takes of it.

use lanchester_mechanism::{CylinderGas, GasTrain, Lever, TorqueError, TorqueRequest, torque};
use lanchester_model::Engine;
use std::f64::consts::PI;

/// Mean torque of the gas at `speed` [rad/s], and friction as a constant torque: that of its mean effective pressure at this speed, as far as the gas gives
/// it [N m]; friction is told in `notes`.
///
/// # Errors
/// [`TorqueError`] where the file lacks something that the torque of the gas needs.
pub(crate) fn mean_and_friction(
    engine: &Engine,
    gas: &[CylinderGas],
    speed: f64,
    notes: &mut Vec<String>,
) -> Result<[f64; 2], TorqueError> {
    let mean = GasTrain::new(engine, gas, Lever::Exact)?.mean_torques().iter().sum();
    let Some(friction) = engine.friction else { return Ok([mean, 0.0]) };
    let request = TorqueRequest { speed: Some(speed), samples: 4, max_order: 1, ..TorqueRequest::default() };
    let indicated = torque(engine, gas, &request)?.indicated;
    let taken = (indicated.torque - indicated.brake(&friction, speed).torque).max(0.0);
    notes.push(format!(
        "Friction: {taken:.4} N m, its mean effective pressure at {:.0} rpm as a constant torque.",
        speed * 30.0 / PI
    ));
    Ok([mean, taken])
}
