//! What the weights that balancing found weigh as real parts.

use crate::parts::design::{CounterweightRequest, design_counterweights, stands_on_a_web};
use crate::parts::error::CounterweightError;
use crate::parts::shaft_weights::design_shaft_weights;
use lanchester_balance::Answer;
use lanchester_geometry::{DesignOutcome, ShaftWeightOutcome};
use lanchester_model::Engine;
use lanchester_task::{Seat, Tasks};
use serde::Serialize;

/// A found weight as a part.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WeightAsPart {
    /// Its name.
    pub name: String,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// What it weighs with its centre at the radius that the task gives [kg], where it gives one.
    pub at_radius: Option<f64>,
    /// What the best shape weighs [kg], a counterweight beyond its web as it is; none where no shape of the ranges has the unbalance.
    pub mass: Option<f64>,
}

/// Share of the largest found weight below which one is rounding.
const NOTHING: f64 = 1e-9;

/// The found weights as parts: the best shapes of `tasks` for those on webs, and for those on balance shafts. Weights elsewhere are left out.
///
/// `fitted` is the engine with the answer.
///
/// # Errors
/// As [`design_counterweights`] and [`design_shaft_weights`].
pub fn weights_as_parts(
    answer: &Answer,
    fitted: &Engine,
    tasks: &Tasks,
) -> Result<Vec<WeightAsPart>, CounterweightError> {
    let found = answer.task.weights.iter().zip(&answer.weights);
    let found: Vec<_> = found.filter(|(_, found)| found.used).collect();
    // What the solver leaves of a weight that is not needed is no weight.
    let largest = found.iter().map(|(_, found)| found.unbalance.norm()).fold(0.0, f64::max);
    let is_weight = |unbalance: f64| unbalance > NOTHING * largest;
    let mut parts = Vec::new();
    if let Some(task) = tasks.shape_task {
        let on_webs = found.iter().filter(|(free, found)| {
            matches!(free.seat, Seat::Crankshaft(_))
                && is_weight(found.unbalance.norm())
                && fitted
                    .counterweights
                    .iter()
                    .any(|weight| weight.name == found.name && stands_on_a_web(fitted, weight))
        });
        let on_webs: Vec<_> = on_webs.map(|(_, found)| *found).collect();
        if !on_webs.is_empty() {
            let weights = on_webs.iter().map(|found| found.name.clone()).collect();
            let request = CounterweightRequest { weights, unbalance: None, task, evolution: None };
            for weight in design_counterweights(fitted, &request)?.weights {
                let found = on_webs.iter().find(|found| found.name == weight.name);
                let mass = match &weight.outcome {
                    DesignOutcome::Found(best) => Some(best.design.mass),
                    DesignOutcome::Infeasible(_) => None,
                };
                let at_radius = found.and_then(|found| found.mass);
                parts.push(WeightAsPart { name: weight.name, unbalance: weight.duty, at_radius, mass });
            }
        }
    }
    if let Some(task) = &tasks.shaft_weight_task {
        for (number, free) in answer.task.shafts.iter().enumerate() {
            let Some(shaft) = fitted.shafts.iter().position(|shaft| shaft.name == free.name) else {
                continue;
            };
            // The weights of a fitted shaft are those of the answer that are used, in their order.
            let own = answer.task.weights.iter().zip(&answer.weights);
            let own: Vec<_> =
                own.filter(|(free, found)| free.seat == Seat::Shaft(number) && found.used).collect();
            let weights = &fitted.shafts[shaft].weights;
            let places: Vec<_> = (0..weights.len())
                .filter(|index| is_weight(weights[*index].unbalance))
                .map(|index| (shaft, index))
                .collect();
            for weight in design_shaft_weights(fitted, task, &places)?.weights {
                let at_radius = own.get(weight.place.1).and_then(|(_, found)| found.mass);
                let mass = match weight.outcome {
                    ShaftWeightOutcome::Best(design) => Some(design.mass),
                    ShaftWeightOutcome::Infeasible { .. } => None,
                };
                parts.push(WeightAsPart { name: weight.name, unbalance: weight.duty, at_radius, mass });
            }
        }
    }
    Ok(parts)
}
