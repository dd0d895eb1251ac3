//! Counterweights that follow their throw, or stay as they are.
//!
//! ```text
//! U_c = U_c0 R / R_0        R = U_throw + r SUM of big-end masses        angle_c = angle_c0 + (angle_throw - angle_throw0)
//! ```
//! A counterweight that follows keeps its share of the rotating unbalance R of its throw and its direction from it. What it takes of the
//! reciprocating masses is part of its amount, and follows R too.

use lanchester_model::{Counterweight, EngineParts};
use serde::Serialize;

/// What counterweights do while throws and masses vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Weights {
    /// They stay as they are: those of a crankshaft that is made.
    #[default]
    Fixed,
    /// They keep their share of their throw's rotating unbalance and their direction from it: those of a crankshaft that is designed.
    Follow,
}

/// The throw that a counterweight answers: the nearest on its crankshaft.
pub(super) fn throw_of(engine: &EngineParts, weight: &Counterweight) -> Option<usize> {
    let own = (0..engine.throws.len()).filter(|&throw| engine.throws[throw].crankshaft == weight.crankshaft);
    let distance = |throw: &usize| (engine.throws[*throw].z - weight.z).abs();
    own.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Rotating unbalance of a throw and the big ends on its pin [kg m].
pub(super) fn rotating(engine: &EngineParts, throw: usize) -> f64 {
    let own = &engine.throws[throw];
    let big_ends = engine.cylinders.iter().filter(|cylinder| cylinder.throw == throw);
    own.unbalance + own.radius * big_ends.map(|cylinder| cylinder.rod.big_end_mass).sum::<f64>()
}

/// Takes the counterweights of `engine` after their throws, which were those of `before`.
pub(super) fn follow(before: &EngineParts, engine: &mut EngineParts) {
    for index in 0..engine.counterweights.len() {
        let Some(throw) = throw_of(before, &before.counterweights[index]) else { continue };
        let nominal = rotating(before, throw);
        if nominal <= 0.0 {
            continue;
        }
        let factor = rotating(engine, throw) / nominal;
        let turned = engine.throws[throw].angle - before.throws[throw].angle;
        let weight = &mut engine.counterweights[index];
        weight.unbalance *= factor;
        weight.angle += turned;
    }
}
