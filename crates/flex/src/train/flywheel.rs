//! A flywheel that turns freely under a constant load.
//!
//! Its angle is that of the mean speed and a deviation `d`; `T` is the torque of the flywheel on the crankshaft, `i` the crankshaft's speed over that of crankshaft 1:
//!
//! ```text
//! theta = w t + d    J_f d'' = T_L - i T                                                                    (book, eq. 51.12)
//! d'_0 <- d'_0 - (d_1 - d_0)/t_P + (d'_1 - d'_0)/2    T_L <- T_L - (J_f + J_t) (d'_1 - d'_0)/t_P            (book, eq. 51.13)
//! ```
//! The second line is the start of the next cycle of duration `t_P`: it leaves nothing where the train is rigid and of constant inertia `J_t`.

use crate::FlexError;
use serde::Serialize;

/// Swing of a free speed over its mean below which it hardly swings: changes and tolerances are shares of no less.
pub(super) const HARDLY: f64 = 1e-6;

/// A flywheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeFlywheel {
    /// Inertia of all that turns rigidly with the flywheel's end of crankshaft 1 [kg m^2], the crank train left out.
    pub inertia: f64,
    /// Mean inertia of the crank train about [kg m^2]: it does not change the answer, only the way to it.
    pub train: f64,
    /// Change of the speed from cycle to cycle over its swing that counts as none.
    pub change: f64,
}

/// How a free flywheel turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FreeSpeed {
    /// Constant torque of the load on the flywheel [N m], positive in the sense of crankshaft 1: an engine that drives has a negative one.
    pub load: f64,
    /// Change of the speed over the last cycle over its swing.
    pub change: f64,
}

impl FreeFlywheel {
    /// Refuses inertias that are none.
    pub(crate) fn check(&self) -> Result<(), FlexError> {
        let inertias = [("inertia of the flywheel", self.inertia), ("inertia of the train", self.train)];
        match inertias.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
            None => Ok(()),
            Some((name, got)) => Err(FlexError::Number {
                quantity: format!("{name} [kg m^2]"),
                needed: "above 0".to_owned(),
                got,
                hint: "give the inertia of the flywheel",
            }),
        }
    }

    /// Inertia of all [kg m^2].
    pub(crate) fn whole(&self) -> f64 {
        self.inertia + self.train
    }

    /// Rate of the deviation [rad/s] and load [N m] with which the next cycle begins, from those and the deviation [rad] at both ends of one of this duration [s].
    pub(crate) fn next(&self, start: [f64; 3], end: [f64; 3], duration: f64) -> [f64; 2] {
        let [angle, rate] = [0, 1].map(|k| end[k] - start[k]);
        [start[1] - angle / duration + 0.5 * rate, start[2] - self.whole() * rate / duration]
    }

    /// Change of the speed over such a cycle [rad/s]: of its ends, or of its mean from the one that is wanted.
    pub(crate) fn change_of_speed(start: [f64; 3], end: [f64; 3], duration: f64) -> f64 {
        (end[1] - start[1]).abs().max((end[0] - start[0]).abs() / duration)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_train_of_constant_inertia_is_at_its_goal_after_one_cycle() {
        let wheel = FreeFlywheel { inertia: 0.02, train: 0.005, change: 1e-3 };
        let duration = 0.03;
        // The gas drives with 40 N m.
        let cycle = |rate: f64, load: f64| {
            let mean = (40.0 + load) / wheel.whole();
            [rate * duration + 0.5 * mean * duration * duration, rate + mean * duration, load]
        };
        let wrong = [0.0, 3.0, -31.0];
        let [rate, load] = wheel.next(wrong, cycle(wrong[1], wrong[2]), duration);
        assert!(rate.abs() < 1e-12 && (load + 40.0).abs() < 1e-12, "{rate} {load}");
        let change = FreeFlywheel::change_of_speed([0.0, 0.0, -40.0], cycle(0.0, -40.0), duration);
        assert_eq!(change, 0.0);
    }

    #[test]
    fn inertias_that_are_none_are_refused() {
        for (inertia, train) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)] {
            assert!(FreeFlywheel { inertia, train, change: 1e-3 }.check().is_err(), "{inertia} {train}");
        }
    }
}
