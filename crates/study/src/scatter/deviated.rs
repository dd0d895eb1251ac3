//! Engines with drawn deviations, as engines: for whoever wants more of a sample than its outputs.

use crate::scatter::tolerance::Variable;
use lanchester_model::{Engine, Fault};
use lanchester_task::{Tolerance, Varied};

/// The engine with these deviations, one for each variable; an unbalance below 0 is one on the other side.
///
/// # Errors
/// As [`Engine::new`], where no engine has such deviations.
pub(crate) fn deviated(
    engine: &Engine,
    tolerances: &[Tolerance],
    variables: &[Variable],
    deviations: &[f64],
) -> Result<Engine, Vec<Fault>> {
    let mut moved = engine.clone().into_parts();
    let weights: Vec<(usize, usize)> = engine
        .shafts
        .iter()
        .enumerate()
        .flat_map(|(shaft, own)| (0..own.weights.len()).map(move |weight| (shaft, weight)))
        .collect();
    for (variable, &by) in variables.iter().zip(deviations) {
        let quantity = tolerances[variable.tolerance].quantity;
        let parts = match variable.part {
            Some(part) => part..part + 1,
            None => 0..quantity.parts(engine),
        };
        for part in parts {
            match quantity {
                Varied::PistonMass => moved.cylinders[part].piston_mass += by,
                Varied::BigEndMass => moved.cylinders[part].rod.big_end_mass += by,
                Varied::SmallEndMass => moved.cylinders[part].rod.small_end_mass += by,
                Varied::RodCentre => {
                    let nominal = &engine.cylinders[part].rod;
                    let shift = by * nominal.mass() / nominal.length;
                    let rod = &mut moved.cylinders[part].rod;
                    rod.small_end_mass += shift;
                    rod.big_end_mass -= shift;
                }
                Varied::RodLength => moved.cylinders[part].rod.length += by,
                Varied::CrankRadius => moved.throws[part].radius += by,
                Varied::ThrowAngle => moved.throws[part].angle += by,
                Varied::ThrowUnbalance => moved.throws[part].unbalance += by,
                Varied::Offset => moved.cylinders[part].offset += by,
                Varied::CylinderPlane => moved.cylinders[part].z += by,
                Varied::CylinderAngle => moved.cylinders[part].angle += by,
                Varied::CounterweightUnbalance => moved.counterweights[part].unbalance += by,
                Varied::CounterweightAngle => moved.counterweights[part].angle += by,
                Varied::ShaftUnbalance => {
                    let (shaft, weight) = weights[part];
                    moved.shafts[shaft].weights[weight].unbalance += by;
                }
                Varied::ShaftPhase => {
                    moved.shafts[part].weights.iter_mut().for_each(|weight| weight.phase += by);
                }
            }
        }
    }
    moved.turn_negative_weights();
    Engine::new(moved)
}
