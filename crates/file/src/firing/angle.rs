//! Angles of a cycle.

use lanchester_numerics::within_period;
use std::f64::consts::TAU;

/// Two crank angles closer than this [rad] are one.
pub(super) const SAME: f64 = 1e-6;

/// The angle in [0, period); an angle that misses the period by rounding is 0.
pub(crate) fn turn(angle: f64, period: f64) -> f64 {
    within_period(angle, period, 1e-9)
}

/// The angle in [0, 2 pi), where angles that differ by no more than [`SAME`] count as one.
pub(super) fn whole(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if turned < SAME || TAU - turned < SAME { 0.0 } else { turned }
}
