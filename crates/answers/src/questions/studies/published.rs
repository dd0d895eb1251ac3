//! Published balancing methods, each beside the proved optimum of its own devices.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{EngineText, engine};
use lanchester::mechanism::{LoadRequest, total_loads};
use lanchester::{MethodLoad, MethodLoads, MethodResult, published_methods};
use schemars::JsonSchema;
use serde::Serialize;

/// What published methods leave of the loads of an engine, at its highest speed.
#[derive(Debug, Serialize, JsonSchema)]
struct PublishedAnswer {
    /// Speed of crankshaft 1 [rad/s].
    speed: f64,
    /// The engine as it is.
    own: MethodLoads,
    /// The methods.
    methods: Vec<MethodResult>,
}

pub(super) fn questions(api: Api) -> Api {
    api.post(
        "/api/published",
        "Published methods: `lanchester balance --method`, `compare --arrangements`.",
        published,
    )
}

fn published(_: &Asker, question: EngineText) -> Result<PublishedAnswer, Problem> {
    let engine = engine(&question.text)?;
    let peaks = total_loads(&engine, &LoadRequest::default()).map_err(Problem::refused)?.peaks;
    let as_it_is = |method: f64| MethodLoad { method, optimum: None };
    let own =
        MethodLoads { force: as_it_is(peaks.force.max.value), couple: as_it_is(peaks.couple.max.value) };
    Ok(PublishedAnswer { speed: engine.speed.highest, own, methods: published_methods(&engine) })
}
