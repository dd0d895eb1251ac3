//! An engine at one speed with the gas of its file, for sensitivities.

use crate::inertias::known_inertia;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::OuterTorque;
use lanchester_model::Engine;
use lanchester_study::sensitivity::{Needs, OperatingPoint, Weights};

/// `engine` at a speed of crankshaft 1 [rad/s] with what is needed of its gas, flywheel and crankshafts; and what the user should know
/// of the gas. Torques over the angle are the caller's to add. `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`GasError`] where the pressures are needed and the file gives some that cannot be computed. A file that says nothing of gas makes a point
/// without.
pub fn operating_point(
    engine: &Engine,
    traces: &[TraceFile],
    speed: f64,
    needs: Needs,
) -> Result<(OperatingPoint, Vec<String>), GasError> {
    let report = match engine.gas.is_some() && needs.gas {
        true => Some(cylinder_gas(engine, traces, speed)?),
        false => None,
    };
    let (gas, warnings) = report.map(|report| (report.cylinders, report.warnings)).unzip();
    let turning = known_inertia(engine);
    let outer = OuterTorque::default();
    let point =
        OperatingPoint { engine: engine.clone(), speed, gas, turning, outer, weights: Weights::Fixed };
    Ok((point, warnings.unwrap_or_default()))
}
