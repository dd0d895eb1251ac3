//! What tolerances of the parts do to residual forces and couples in production.

use super::turn::{SoFar, Turn, turn};
use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use crate::questions::results::positive;
use lanchester::report::{tighten_words, tolerance_name};
use lanchester::study::scatter::{ScatterOptions, ScatterStudy, Scattering, scatter_study_of};
use lanchester::task::option;
use lanchester::{SampleStudy, SavedScatter};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most engines that are drawn for a window.
const MOST_SAMPLES: u64 = 10_000_000;

/// An engine with tolerances, and what is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ScatterQuestion {
    /// The engine file.
    text: String,
    /// Speed of the crankshaft [rad/s]; the highest of the engine where it is left out.
    #[serde(default)]
    speed: Option<f64>,
    /// Engines that are drawn.
    samples: u64,
    /// Seed of the draws.
    seed: u64,
    /// Leave the peaks over all orders out, which is faster.
    #[serde(default)]
    orders_only: bool,
    /// Limits as `--limit` takes them.
    #[serde(default)]
    limits: Vec<String>,
    /// Capability with which a limit is met; 1.33 where it is left out.
    #[serde(default)]
    capability: Option<f64>,
    /// Where the turn before ended; nothing for the first one.
    #[serde(default)]
    so_far: Option<SoFar>,
}

/// A turn of the draws, with the answer where it was the last one.
#[derive(Debug, Serialize, JsonSchema)]
struct ScatterTurn {
    #[serde(flatten)]
    turn: Turn,
    /// What was found.
    found: Option<ScatterFound>,
}

/// Production scatter of an engine.
#[derive(Debug, Serialize, JsonSchema)]
struct ScatterFound {
    /// As `lanchester scatter --format json` prints it.
    study: ScatterStudy,
    /// Names of the outputs, in their order, and their SI units.
    outputs: Vec<ScatterOutput>,
    /// Tolerances in words, in their order.
    tolerances: Vec<String>,
    /// What to tighten first, output by output.
    tighten: Vec<String>,
}

/// An output of the scatter.
#[derive(Debug, Serialize, JsonSchema)]
struct ScatterOutput {
    /// Its name.
    name: String,
    /// Its SI unit.
    unit: &'static str,
}

pub(super) fn questions(api: Api) -> Api {
    api.post("/api/scatter", "A turn of the production scatter: `lanchester scatter`.", scattered)
}

fn scattered(asker: &Asker, question: ScatterQuestion) -> Result<ScatterTurn, Problem> {
    if !(1..=MOST_SAMPLES).contains(&question.samples) {
        return Err(Problem::refused(format!(
            "a window draws 1 to {MOST_SAMPLES} engines, got {}\nhint: `lanchester scatter` draws any number",
            question.samples
        )));
    }
    let file = engine_file(&question.text)?;
    let saved = SavedScatter {
        speed: positive(question.speed)?,
        samples: question.samples,
        seed: question.seed,
        orders_only: question.orders_only,
        limits: question.limits,
        capability: question.capability.unwrap_or(ScatterOptions::default().capability),
    };
    let limit = |text: &String| option::limit(text, &file.engine, "limit").map_err(Problem::quantity);
    let options = saved.options(saved.limits.iter().map(limit).collect::<Result<_, _>>()?);
    let request = options.request(&file.engine, &file.tasks.tolerances).map_err(Problem::refused)?;
    let scattering = Scattering::new(request).map_err(Problem::refused)?;
    let study = SampleStudy { scattering, keeps_samples: false };
    let (turn, whole) = turn(asker, &study, question.so_far)?;
    let found = match whole {
        None => None,
        Some(tally) => {
            scatter_study_of(&study.scattering, &tally, saved.capability).map_err(Problem::refused)?
        }
    };
    Ok(ScatterTurn { turn, found: found.map(shown) })
}

fn shown(study: ScatterStudy) -> ScatterFound {
    let outputs = study.scatter.outputs.iter();
    let outputs = outputs.map(|own| ScatterOutput { name: own.output.name(), unit: own.output.unit() });
    ScatterFound {
        outputs: outputs.collect(),
        tolerances: study.tolerances.iter().map(tolerance_name).collect(),
        tighten: tighten_words(&study),
        study,
    }
}
