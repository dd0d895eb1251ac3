//! Sensitivities of an engine: exact derivatives, one input at a time over ranges, and shares of the variance over all ranges.

use super::derivative::derivatives;
use super::error::SensitivityError;
use super::follow::Weights;
use super::input::{Amount, Input};
use super::operating_point::OperatingPoint;
use super::output::Output;
use super::quantity::{Measure, Quantity};
use super::slope::Slope;
use super::sobol::{Sobol, sobol};
use super::value::{possible, values};
use rayon::prelude::*;
use serde::Serialize;

/// Version of [`Sensitivity`]; raised when a field changes its meaning or goes.
pub const SENSITIVITY_VERSION: u32 = 3;

/// What to vary, and what is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct SensitivityRequest {
    /// Outputs.
    pub outputs: Vec<Output>,
    /// Whether every part varies by itself, or all parts of a kind together.
    pub each: bool,
    /// How far quantities go that do not go as far as usual ([`Amount::standard`]).
    pub amounts: Vec<(Quantity, Amount)>,
    /// Whether only the quantities of `amounts` vary.
    pub only: bool,
    /// Draws and seed for the shares of the variance; `None`: none.
    pub sobol: Option<[u64; 2]>,
}

impl Default for SensitivityRequest {
    /// Peaks of the loads on the block by all quantities, all parts of a kind together, without shares of the variance.
    fn default() -> SensitivityRequest {
        SensitivityRequest {
            outputs: Output::peaks(),
            each: false,
            amounts: Vec::new(),
            only: false,
            sobol: None,
        }
    }
}

/// An input, and how far it goes.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct VariedInput {
    /// Which.
    #[serde(flatten)]
    pub input: Input,
    /// Its nominal value, where all of its parts have the same, in its SI unit.
    pub nominal: Option<f64>,
    /// How far it goes either way, in its SI unit.
    pub half_width: f64,
}

/// An output with an input at one end of its range and at the other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Effect {
    /// Derivative at the nominal engine.
    pub slope: Slope,
    /// Output with the input at its lower end; `None` if no engine is there.
    pub below: Option<f64>,
    /// Output with the input at its upper end.
    pub above: Option<f64>,
}

/// Sensitivities of one output.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OutputSensitivity {
    /// Which.
    #[serde(flatten)]
    pub output: Output,
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// Of the nominal engine.
    pub nominal: f64,
    /// By input.
    pub effects: Vec<Effect>,
}

/// Sensitivities of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sensitivity {
    /// [`SENSITIVITY_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// What the counterweights do while throws and masses vary.
    pub weights: Weights,
    /// How many counterweights there are.
    pub counterweights: usize,
    /// What varies.
    pub inputs: Vec<VariedInput>,
    /// By output.
    pub outputs: Vec<OutputSensitivity>,
    /// Shares of the variance over all ranges at once.
    pub sobol: Option<Sobol>,
}

/// The sensitivities of an engine at an operating point.
///
/// # Errors
/// [`SensitivityError`] where the loads cannot be computed, or the request is impossible.
///
/// # Example
/// ```
/// use lanchester_study::sensitivity::{OperatingPoint, SensitivityRequest, sensitivity};
///
/// let template = lanchester_file::template("single").expect("it is in the gallery");
/// let engine = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
/// let point = OperatingPoint::of_inertia(engine, 400.0);
/// let found = sensitivity(&point, &SensitivityRequest::default())?;
/// let (force, speed) = (&found.outputs[0], &found.inputs[0]);
/// // Forces grow with the square of the speed.
/// let exact = 2.0 * force.nominal / found.speed;
/// assert!((force.effects[0].slope.up - exact).abs() < 1e-9 * exact && speed.nominal == Some(found.speed));
/// # Ok::<(), lanchester_study::sensitivity::SensitivityError>(())
/// ```
pub fn sensitivity(
    point: &OperatingPoint,
    request: &SensitivityRequest,
) -> Result<Sensitivity, SensitivityError> {
    sensitivity_watched(point, request, &|| true)
}

/// [`sensitivity`] that is given up where `goes_on` says no: it is asked before each draw for the shares of the variance.
///
/// # Errors
/// Those of [`sensitivity`], and [`SensitivityError::Stopped`].
pub fn sensitivity_watched(
    point: &OperatingPoint,
    request: &SensitivityRequest,
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<Sensitivity, SensitivityError> {
    if request.outputs.is_empty() {
        return Err(SensitivityError::NoOutput);
    }
    request.outputs.iter().try_for_each(|output| output.check(point))?;
    let inputs = varied(point, request)?;
    let list: Vec<Input> = inputs.iter().map(|varied| varied.input).collect();
    let nominal = values(point, &request.outputs)?;
    let slopes = derivatives(point, &request.outputs, &list)?;
    let ends: Vec<[Option<Vec<f64>>; 2]> = inputs
        .par_iter()
        .map(|varied| {
            [-varied.half_width, varied.half_width].map(|deviation| {
                let mut own = point.clone();
                varied.input.deviate(&mut own, deviation).ok()?;
                possible(&own, &request.outputs)
            })
        })
        .collect();
    let of_output = |(place, (output, nominal)): (usize, (&Output, f64))| {
        let effect = |(slope, [below, above]): (&Slope, &[Option<Vec<f64>>; 2])| Effect {
            slope: *slope,
            below: below.as_ref().map(|values| values[place]),
            above: above.as_ref().map(|values| values[place]),
        };
        OutputSensitivity {
            output: *output,
            name: output.name(&point.engine),
            unit: output.output(&point.engine).unit(),
            nominal,
            effects: slopes[place].iter().zip(&ends).map(effect).collect(),
        }
    };
    let ranges: Vec<(Input, f64)> = inputs.iter().map(|varied| (varied.input, varied.half_width)).collect();
    let shares = match request.sobol {
        None => None,
        Some([samples, _]) if !(16..=10_000_000).contains(&samples) => {
            return Err(SensitivityError::Samples { got: samples });
        }
        Some(draws) => Some(sobol(point, &request.outputs, &ranges, draws, goes_on)),
    };
    if shares.is_some() && !goes_on() {
        return Err(SensitivityError::Stopped);
    }
    if shares.as_ref().is_some_and(|shares| shares.impossible == shares.samples) {
        return Err(SensitivityError::NoEngine);
    }
    Ok(Sensitivity {
        version: SENSITIVITY_VERSION,
        engine: point.engine.name.clone(),
        speed: point.speed,
        weights: point.weights,
        counterweights: point.engine.counterweights.len(),
        outputs: request.outputs.iter().zip(nominal).enumerate().map(of_output).collect(),
        inputs,
        sobol: shares,
    })
}

/// The inputs, and how far each goes.
fn varied(
    point: &OperatingPoint,
    request: &SensitivityRequest,
) -> Result<Vec<VariedInput>, SensitivityError> {
    let needs = Output::needs_of(&request.outputs);
    for (quantity, amount) in &request.amounts {
        let (Amount::Share(size) | Amount::Absolute(size)) = amount;
        if !(*size > 0.0 && size.is_finite()) {
            return Err(SensitivityError::Amount { quantity: quantity.name(), got: *size });
        }
        if quantity.parts(point).is_empty() {
            return Err(SensitivityError::NoSuchPart { quantity: quantity.name() });
        }
    }
    let all = if request.each { Input::single(point) } else { Input::common(point) };
    let mut found = Vec::new();
    for input in all {
        let given = request.amounts.iter().rfind(|(quantity, _)| *quantity == input.quantity);
        let is_idle = request.only || !input.quantity.matters_to(needs);
        if is_idle && given.is_none() {
            continue;
        }
        let nominal = input.nominal(point);
        let amount = given.map_or(Amount::standard(input.quantity.measure()), |(_, amount)| *amount);
        let half_width = match (amount, nominal) {
            (Amount::Absolute(amount), _) => amount,
            (Amount::Share(share), Some(nominal)) if nominal != 0.0 => share * nominal.abs(),
            // What is 0, or differs from part to part, has no share that is one number.
            (Amount::Share(_), _) if given.is_some() => {
                return Err(SensitivityError::NoSize { quantity: input.quantity.name() });
            }
            (Amount::Share(_), _) => continue,
        };
        if input.quantity.measure() == Measure::Factor && half_width >= 1.0 {
            return Err(SensitivityError::Factor {
                quantity: input.quantity.name(),
                got: 100.0 * half_width,
            });
        }
        found.push(VariedInput { input, nominal, half_width });
    }
    if found.is_empty() {
        return Err(SensitivityError::NoInput);
    }
    Ok(found)
}
