//! All that an engine file asks.

use crate::balance_task::BalanceTask;
use crate::shaft_weight_task::ShaftWeightTask;
use crate::shape_task::ShapeTask;
use crate::stress_task::StressTask;
use crate::tolerance::Tolerance;
use lanchester_model::SimulationInput;
use serde::Serialize;

/// What an engine file asks of the engine that it describes; nothing by default.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Tasks {
    /// Shapes among which counterweights are to be found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shape_task: Option<ShapeTask>,
    /// A run in time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub simulation: Option<Box<SimulationInput>>,
    /// What the engine's parts may be off, from engine to engine of a production; empty if the file does not say.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tolerances: Vec<Tolerance>,
    /// Shapes among which the weights of balance shafts are to be found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shaft_weight_task: Option<ShaftWeightTask>,
    /// What may be done to balance it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balance: Option<BalanceTask>,
    /// Mesh and static cases of the crankshafts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stress: Option<StressTask>,
}
