//! Angles, and whatever else repeats, moved by whole periods.

/// `angle` moved by whole periods into `[0, period)`; what misses the period by no more than `same` is 0.
///
/// ```
/// assert_eq!(lanchester_numerics::within_period(-1e-9, 360.0, 1e-6), 0.0);
/// assert_eq!(lanchester_numerics::within_period(370.0, 360.0, 1e-6), 10.0);
/// ```
pub fn within_period(angle: f64, period: f64, same: f64) -> f64 {
    let turned = angle.rem_euclid(period);
    // Adding 0 turns -0 into 0.
    if period - turned <= same { 0.0 } else { turned + 0.0 }
}

/// `angle` moved by whole periods into `[-period/2, period/2)`: of the difference of two angles, the way from one to the other that is
/// shorter, with its sign.
///
/// ```
/// assert_eq!(lanchester_numerics::about_zero(350.0, 360.0), -10.0);
/// assert_eq!(lanchester_numerics::about_zero(-190.0, 360.0), 170.0);
/// ```
pub fn about_zero(angle: f64, period: f64) -> f64 {
    (angle + 0.5 * period).rem_euclid(period) - 0.5 * period
}
