//! What the gas gives a run on average, and what friction takes of it.

use lanchester_mechanism::{CylinderGas, GasTrain, Lever, TorqueError, TorqueRequest, torque};
use lanchester_model::{Engine, LoadLaw};
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

/// Begins the note on a load that nobody gave.
pub(crate) const CHOSEN_LOAD: &str = "Load:";

/// The load of a run where nobody gives one: what takes the mean `torque` of crankshaft 1 [N m] at `speed` [rad/s], at the end of a driveline that turns `ratio`
/// times as fast. It is constant; of a periodic motion it rises in proportion to the speed: beside a constant one what the dampers of the mounts take would leave
/// no speed at which drive and load are in balance. Told in `notes`.
pub(crate) fn chosen_load(
    torque: f64,
    speed: f64,
    ratio: f64,
    is_periodic: bool,
    notes: &mut Vec<String>,
) -> LoadLaw {
    let (own, at) = (torque / ratio, speed * ratio);
    let rpm = speed * 30.0 / PI;
    if is_periodic && own > 0.0 {
        notes.push(format!(
            "{CHOSEN_LOAD} {own:.4} N m, the mean that the engine gives at {rpm:.0} rpm, and in proportion to the speed."
        ));
        return LoadLaw::Viscous { torque: own, at };
    }
    notes.push(format!(
        "{CHOSEN_LOAD} {own:.4} N m, constant, the mean that the engine gives at {rpm:.0} rpm."
    ));
    LoadLaw::Constant(own)
}
