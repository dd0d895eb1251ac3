//! Published balancing methods, each beside the proved optimum of its own devices.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{EngineText, engine};
use lanchester::{MethodLoads, MethodResult, loads_as_it_is, published_methods};
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
    let own = loads_as_it_is(&engine).map_err(Problem::refused)?;
    Ok(PublishedAnswer { speed: engine.speed.highest, own, methods: published_methods(&engine) })
}
