//! Loads over one period.

use crate::result::Trace;
use crate::train::Mechanism;

impl Mechanism {
    /// Loads at `samples` equally spaced angles of every revolution, over one period from `theta = 0`.
    pub fn trace(&self, samples: usize) -> Trace {
        let count = samples * self.revolutions as usize;
        let mut trace = Trace::default();
        for j in 0..count {
            let theta = self.period() * j as f64 / count as f64;
            let point = self.components(theta);
            trace.theta.push(theta);
            trace.force_x.push(point.force_x);
            trace.force_y.push(point.force_y);
            trace.couple_x.push(point.couple_x);
            trace.couple_y.push(point.couple_y);
            trace.roll_moment.push(point.roll_moment);
            trace.shaft_torque.push(point.shaft_torque);
        }
        trace
    }
}
