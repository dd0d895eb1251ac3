//! An answer with other weights.

use crate::answer::Answer;
use num_complex::Complex64;

/// The answer with other unbalances of its weights.
pub(super) fn moved(answer: &Answer, unbalances: &[Complex64]) -> Answer {
    let mut moved = answer.clone();
    for ((found, free), unbalance) in moved.weights.iter_mut().zip(&answer.task.weights).zip(unbalances) {
        if found.unbalance != *unbalance {
            found.unbalance = *unbalance;
            found.used = unbalance.norm() > 0.0;
            found.mass = free.radius.map(|radius| unbalance.norm() / radius);
        }
    }
    moved
}
