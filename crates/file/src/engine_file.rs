//! What an engine file says: an engine, and what is asked of it.

use lanchester_model::Engine;
use lanchester_task::Tasks;
use serde::Serialize;

/// An engine file as data.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct EngineFile {
    /// The physical engine.
    #[serde(flatten)]
    pub engine: Engine,
    /// What is asked of it.
    #[serde(flatten)]
    pub tasks: Tasks,
}

impl From<Engine> for EngineFile {
    /// An engine of which nothing is asked.
    fn from(engine: Engine) -> EngineFile {
        EngineFile { engine, tasks: Tasks::default() }
    }
}
