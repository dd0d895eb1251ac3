//! An engine without what a task takes over, and with what was found.

use crate::answer::Answer;
use lanchester_model::{BalanceShaft, Counterweight, Engine, EngineParts, ShaftWeight};
use lanchester_task::{BalanceTask, Criterion, Seat};

/// The engine without the counterweights and shafts that have the names of free weights and shafts.
pub fn bare(engine: &Engine, task: &BalanceTask) -> Engine {
    let change = |parts: &mut EngineParts| {
        parts.counterweights.retain(|old| !replaces(task, &old.name));
        parts.shafts.retain(|old| task.shafts.iter().all(|shaft| shaft.name != old.name));
    };
    engine.with(change).expect("invariant: an engine with fewer weights is one")
}

/// Whether a free weight on a crankshaft has this name.
pub(crate) fn replaces(task: &BalanceTask, name: &str) -> bool {
    task.weights.iter().any(|w| matches!(w.seat, Seat::Crankshaft(_)) && w.name == name)
}

/// Mass [kg] or unbalance [kg m] of what the task takes over from the engine.
///
/// Masses are those of old weights on crankshafts at the radius of the new one; old shafts count with the radius of
/// the first weight on the new shaft.
pub(crate) fn taken_over(engine: &Engine, task: &BalanceTask, criterion: Criterion) -> f64 {
    let per_amount = |radius: Option<f64>| match criterion {
        Criterion::AddedMass => radius.map_or(0.0, |r| 1.0 / r),
        _ => 1.0,
    };
    let mut sum = 0.0;
    for old in &engine.counterweights {
        let new = task.weights.iter().find(|w| matches!(w.seat, Seat::Crankshaft(_)) && w.name == old.name);
        sum += new.map_or(0.0, |new| old.unbalance * per_amount(new.radius));
    }
    for old in &engine.shafts {
        let Some(index) = task.shafts.iter().position(|s| s.name == old.name) else { continue };
        let first = task.weights.iter().find(|w| w.seat == Seat::Shaft(index));
        let amount: f64 = old.weights.iter().map(|w| w.unbalance).sum();
        sum += amount * per_amount(first.and_then(|w| w.radius));
    }
    sum
}

/// The engine with the weights and shafts of `answer` in place of those with the same names.
///
/// Weights that are not used are left out, and shafts without weights. A direction that is a round one but for what
/// the solver leaves uncertain (3e-9 rad) becomes it: 180 deg, not 180.00000008. An engine for which there is no
/// answer comes back as it was.
pub fn fitted(engine: &Engine, answer: &Answer) -> Engine {
    if answer.weights.is_empty() {
        return engine.clone();
    }
    let task = &answer.task;
    let mut fitted = bare(engine, task).into_parts();
    let mut shafts: Vec<BalanceShaft> = task
        .shafts
        .iter()
        .zip(&answer.shafts)
        .map(|(free, found)| BalanceShaft {
            name: free.name.clone(),
            ratio: free.ratio,
            x: found.x,
            y: found.y,
            weights: Vec::new(),
            inertia: None,
        })
        .collect();
    for (free, found) in task.weights.iter().zip(&answer.weights).filter(|(_, found)| found.used) {
        let (unbalance, phase) = (found.unbalance.norm(), round_direction(found.unbalance.arg()));
        match free.seat {
            Seat::Crankshaft(crankshaft) => fitted.counterweights.push(Counterweight {
                name: found.name.clone(),
                crankshaft,
                z: found.z,
                unbalance,
                angle: phase - engine.crankshafts[crankshaft].phase,
                part: None,
            }),
            Seat::Shaft(shaft) => shafts[shaft].weights.push(ShaftWeight::new(found.z, unbalance, phase)),
        }
    }
    fitted.shafts.extend(shafts.into_iter().filter(|shaft| !shaft.weights.is_empty()));
    Engine::new(fitted).expect("invariant: amounts that are found are finite, and no name is there twice")
}

/// What the directions of found weights are uncertain by [rad]: the conic solver closes its gap to about 1e-9.
const DIRECTION: f64 = 3e-9;

/// The direction [rad], or the whole thousandth of a degree that it cannot be told from.
fn round_direction(direction: f64) -> f64 {
    let thousandths = (direction.to_degrees() * 1e3).round();
    let round = (thousandths / 1e3).to_radians();
    if (round - direction).abs() > DIRECTION {
        return direction;
    }
    // The half turn has one name.
    if thousandths == -180_000.0 { -round } else { round }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn round_directions_lose_what_the_solver_leaves() {
        assert_eq!(round_direction(PI - 1.4e-9), PI);
        assert_eq!(round_direction(-PI + 1.4e-9), PI);
        assert_eq!(round_direction(1e-10), 0.0);
        assert_eq!(round_direction(12.345_f64.to_radians() + 1e-9), 12.345_f64.to_radians());
        let own = 12.345_3_f64.to_radians();
        assert_eq!(round_direction(own), own);
    }
}
