//! An engine at one speed with the gas of its file, for sensitivities.

use crate::inertias::known_inertia;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::OuterTorque;
use lanchester_model::Engine;
use lanchester_study::sensitivity::{Amount, Measure, Quantity};
use lanchester_study::sensitivity::{Needs, OperatingPoint, Weights};
use lanchester_task::option::{self, BadQuantity};

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

/// Reads `rod length = 10 %`: a quantity, and how far it goes either way. `name` is what the front end calls the option.
///
/// # Errors
/// Where there is no such quantity, or the amount is not of its dimension.
///
/// ```
/// use lanchester::study::sensitivity::Amount;
/// let (quantity, amount) = lanchester::sensitivity_amount("rod  length = 10 %", "vary")?;
/// assert_eq!((quantity.name(), amount), ("rod length", Amount::Share(0.1)));
/// assert!(lanchester::sensitivity_amount("rod length = 2 kg", "vary").is_err());
/// # Ok::<(), lanchester::task::option::BadQuantity>(())
/// ```
pub fn sensitivity_amount(text: &str, name: &str) -> Result<(Quantity, Amount), BadQuantity> {
    let Some((quantity, value)) = text.split_once('=') else {
        return Err(BadQuantity {
            message: format!("`{name}` needs a quantity and how far it goes, got \"{text}\""),
            hint: "write it like \"rod length = 10 %\" or \"throw angle = 0.5 deg\"".to_owned(),
        });
    };
    let words = quantity.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some(quantity) = Quantity::all().find(|quantity| quantity.name() == words) else {
        let names: Vec<&str> = Quantity::all().map(Quantity::name).collect();
        return Err(BadQuantity {
            message: format!("unknown quantity \"{words}\" for `{name}`"),
            hint: format!("it knows {}", names.join(", ")),
        });
    };
    if value.trim_end().ends_with('%') {
        return Ok((quantity, Amount::Share(option::share(value, &words)?)));
    }
    let read = match quantity.measure() {
        Measure::Mass | Measure::BodyMass => option::mass,
        Measure::Length | Measure::Place => option::length,
        Measure::Angle => option::angle,
        Measure::Unbalance => option::unbalance,
        Measure::Inertia | Measure::BodyInertia => option::inertia,
        Measure::Speed => option::speed,
        Measure::Factor => option::share,
    };
    Ok((quantity, Amount::Absolute(read(value, &words)?)))
}
