//! What matters most: loads with each number of the engine at either end of a range.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use crate::questions::results::positive;
use lanchester::mechanism::OuterTorque;
use lanchester::operating_point;
use lanchester::report::{input_name, input_range};
use lanchester::study::sensitivity::{Output, SensitivityRequest, Weights, sensitivity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An engine at a speed, and what is looked at.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SensitivityQuestion {
    /// The engine file.
    text: String,
    /// Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Outputs as `lanchester sensitivity --output` takes them; peaks of force, couple and roll moment where there are none.
    #[serde(default)]
    outputs: Vec<String>,
    /// Whether every part varies by itself, or all parts of a kind together.
    #[serde(default)]
    each: bool,
    /// Whether counterweights follow the masses of their throws, or stay as they are.
    #[serde(default)]
    weights_follow: bool,
}

/// Loads with each number of the engine at either end of a range.
#[derive(Debug, Serialize, JsonSchema)]
struct SensitivityAnswer {
    /// Speed of crankshaft 1 [rad/s].
    speed: f64,
    /// What varies.
    inputs: Vec<VariedNumber>,
    /// What is looked at.
    outputs: Vec<OutputRange>,
    /// What the user should know of the gas.
    warnings: Vec<String>,
}

/// A number of the engine that varies.
#[derive(Debug, Serialize, JsonSchema)]
struct VariedNumber {
    /// What it is.
    name: String,
    /// Its nominal value and how far it goes either way, in words with a unit.
    range: String,
}

/// An output over all ranges.
#[derive(Debug, Serialize, JsonSchema)]
struct OutputRange {
    /// Which.
    name: String,
    /// Its SI unit.
    unit: &'static str,
    /// Of the nominal engine, in that unit.
    nominal: f64,
    /// With each input at its lower and at its upper end, in the order of the inputs; `null` if no engine is there.
    ends: Vec<[Option<f64>; 2]>,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/sensitivity", "What matters most: `lanchester sensitivity`.", sensitive)
}

fn sensitive(asker: &Asker, question: SensitivityQuestion) -> Result<SensitivityAnswer, Problem> {
    let file = asker.studio.with_torques(engine_file(&question.text)?)?;
    let engine = file.engine;
    let named = |text: &String| Output::named(text, &engine).map_err(Problem::refused);
    let mut outputs: Vec<Output> = question.outputs.iter().map(named).collect::<Result<_, Problem>>()?;
    if outputs.is_empty() {
        outputs = Output::peaks();
    }
    let needs = Output::needs_of(&outputs);
    let traces = if needs.gas { asker.studio.traces(&engine)? } else { Vec::new() };
    let speed = positive(question.speed)?.unwrap_or(engine.speed.highest);
    let (mut point, warnings) = operating_point(&engine, &traces, speed, needs).map_err(Problem::refused)?;
    point.outer = OuterTorque::of(file.tasks.simulation.as_deref()).map_err(Problem::refused)?;
    point.weights = if question.weights_follow { Weights::Follow } else { Weights::Fixed };
    let request = SensitivityRequest { outputs, each: question.each, ..SensitivityRequest::default() };
    let found = sensitivity(&point, &request).map_err(Problem::refused)?;
    let varied = |varied| VariedNumber { name: input_name(varied), range: input_range(varied) };
    let ranges = found.outputs.into_iter().map(|own| OutputRange {
        name: own.name,
        unit: own.unit,
        nominal: own.nominal,
        ends: own.effects.iter().map(|effect| [effect.below, effect.above]).collect(),
    });
    Ok(SensitivityAnswer {
        speed: found.speed,
        inputs: found.inputs.iter().map(varied).collect(),
        outputs: ranges.collect(),
        warnings,
    })
}
