//! Loads on the block of a run, as every rung returns them.

use crate::run::result::Samples;
use lanchester_results::Trace;
use std::ops::Range;

impl Samples {
    /// What the crank train exerts on the block over the crank angle at the samples of `range`: forces and couples about the origin in block
    /// axes, roll moment, and the torque that it delivers at crankshaft 1. Empty where the run has no reactions.
    pub fn block_loads(&self, range: Range<usize>) -> Trace {
        let Some(reactions) = self.reactions.get(range.clone()) else { return Trace::default() };
        let of = |value: fn(&crate::Reactions) -> f64| reactions.iter().map(value).collect();
        Trace {
            theta: self.theta[range].to_vec(),
            force_x: of(|all| all.on_block.force[0]),
            force_y: of(|all| all.on_block.force[1]),
            couple_x: of(|all| all.on_block.moment[0]),
            couple_y: of(|all| all.on_block.moment[1]),
            roll_moment: of(|all| all.on_block.moment[2]),
            shaft_torque: of(|all| all.shaft_torque),
        }
    }
}
