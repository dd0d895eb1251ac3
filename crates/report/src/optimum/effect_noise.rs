//! Below which value an effect of an answer is rounding: forces and moments beside all moving masses together, amounts of
//! weights beside the largest of their unit.

use crate::kit::magnitude::Magnitude;
use crate::kit::rounding::among;
use lanchester_balance::Effect;
use lanchester_model::Engine;
use lanchester_task::{Criterion, criterion_unit};

/// Below this a value of the criterion is rounding, in its SI unit; `effects`: all of the answer.
pub(crate) fn effect_noise(engine: &Engine, effects: &[Effect], criterion: &Criterion) -> f64 {
    let unit = criterion_unit(criterion);
    let alike = effects.iter().filter(|other| criterion_unit(&other.criterion) == unit);
    let own = among(alike.flat_map(|e| [e.without, e.before, e.after]));
    own.max(Magnitude::of_masses(engine).noise_of_unit(unit))
}
