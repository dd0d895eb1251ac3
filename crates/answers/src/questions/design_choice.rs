//! Which counterweight is designed, for what, among which shapes.

use crate::problem::Problem;
use lanchester::CounterweightRequest;
use lanchester::geometry::{Objective, ShapeTask};
use lanchester::task::Tasks;
use schemars::JsonSchema;
use serde::Deserialize;

/// What is made small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Aim {
    Mass,
    #[serde(alias = "swept radius")]
    SweptRadius,
    Inertia,
    Thickness,
}

impl From<Aim> for Objective {
    fn from(aim: Aim) -> Objective {
        match aim {
            Aim::Mass => Objective::Mass,
            Aim::SweptRadius => Objective::SweptRadius,
            Aim::Inertia => Objective::Inertia,
            Aim::Thickness => Objective::Thickness,
        }
    }
}

/// The shapes of the file's `[counterweight_design]`.
pub(crate) fn shape_task(tasks: &Tasks, aim: Option<Aim>) -> Result<ShapeTask, Problem> {
    let task = tasks.shape_task.ok_or_else(|| {
        Problem::refused(
            "the shapes to search are not given\nhint: add a section [counterweight_design] with ranges of the dimensions",
        )
    })?;
    Ok(ShapeTask { minimise: aim.map_or(task.minimise, Objective::from), ..task })
}

pub(crate) fn design_request(
    tasks: &Tasks,
    weights: Vec<String>,
    aim: Option<Aim>,
) -> Result<CounterweightRequest, Problem> {
    Ok(CounterweightRequest { weights, unbalance: None, task: shape_task(tasks, aim)?, evolution: None })
}
