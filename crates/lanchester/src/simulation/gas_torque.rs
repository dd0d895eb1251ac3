//! What the gas gives a run on average, and what friction takes of it.

use lanchester_mechanism::{CylinderGas, GasTrain, Lever, TorqueError, TorqueRequest, torque};
use lanchester_model::{Engine, Friction, LoadLaw};
use std::f64::consts::PI;

/// Mean torque of the gas at `speed` [rad/s], and of friction as a torque what is constant [N m], what goes with the speed [N m s/rad] and with its square
/// [N m s^2/rad^2]: by its mean effective pressure with the highest pressure at this speed.
///
/// # Errors
/// [`TorqueError`] where the file lacks something that the torque of the gas needs.
pub(crate) fn mean_and_friction(
    engine: &Engine,
    gas: &[CylinderGas],
    speed: f64,
) -> Result<(f64, [f64; 3]), TorqueError> {
    let mean = GasTrain::new(engine, gas, Lever::Exact)?.mean_torques().iter().sum();
    let Some(friction) = engine.friction else { return Ok((mean, [0.0; 3])) };
    let request = TorqueRequest { speed: Some(speed), samples: 4, max_order: 1, ..TorqueRequest::default() };
    let indicated = torque(engine, gas, &request)?.indicated;
    let taken = |part: Friction| indicated.torque - indicated.brake(&part, speed).torque;
    let only = |speed, speed_squared| Friction::ChenFlynn {
        constant: 0.0,
        peak_pressure: 0.0,
        speed,
        speed_squared,
    };
    Ok((
        mean,
        match friction {
            Friction::Given { .. } => [taken(friction).max(0.0), 0.0, 0.0],
            Friction::ChenFlynn { constant, peak_pressure, speed: linear, speed_squared } => {
                let still = Friction::ChenFlynn { constant, peak_pressure, speed: 0.0, speed_squared: 0.0 };
                [
                    taken(still).max(0.0),
                    (taken(only(linear, 0.0)) / speed).max(0.0),
                    (taken(only(0.0, speed_squared)) / (speed * speed)).max(0.0),
                ]
            }
        },
    ))
}

/// What a run says of the friction whose parts [`mean_and_friction`] gave.
pub(crate) fn friction_note(parts: [f64; 3], speed: f64) -> String {
    let at = friction_at(parts, speed);
    match parts {
        [_, 0.0, 0.0] => format!("Friction: {at:.4} N m at every speed, its mean effective pressure."),
        [still, ..] => format!(
            "Friction: {at:.4} N m at {:.0} rpm, its mean effective pressure there; it follows the speed, from {still:.4} N m at standstill.",
            speed * 30.0 / PI
        ),
    }
}

/// Friction at `speed` [rad/s] from its parts of [`mean_and_friction`] [N m].
pub(crate) fn friction_at([still, linear, square]: [f64; 3], speed: f64) -> f64 {
    still + speed * (linear + speed * square)
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
