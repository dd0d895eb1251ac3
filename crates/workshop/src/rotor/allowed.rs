//! A weight among the angles that may be used.

use lanchester_task::workshop::Allowed;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Angles nearer than this are one [rad].
const SAME: f64 = 1e-9;

/// Whether the angle may be used.
pub(crate) fn is_allowed(allowed: &Allowed, angle: f64) -> bool {
    match allowed {
        Allowed::Any => true,
        Allowed::Some { angles, sectors } => {
            let near = |other: f64| {
                let turn = (angle - other).rem_euclid(TAU);
                turn.min(TAU - turn) <= SAME
            };
            angles.iter().copied().any(near)
                || sectors.iter().any(|[from, to]| {
                    near(*from) || near(*to) || (angle - from).rem_euclid(TAU) <= (to - from).rem_euclid(TAU)
                })
        }
    }
}

/// Angle and amount of the weights at allowed angles that together come nearest to `wanted`: itself where its angle is
/// allowed, else the nearest allowed angles to either side.
///
/// ```text
/// A_1 = U sin d_2/sin(d_1 + d_2)        A_2 = U sin d_1/sin(d_1 + d_2)        d_1 + d_2 < pi
/// ```
/// Where the allowed angles leave a gap of half a turn or more, no weights add up to it: the nearer angle takes
/// `U cos d`, which leaves the least, or nothing is better than any weight.
pub(crate) fn split(wanted: Complex64, allowed: &Allowed) -> Vec<(f64, f64)> {
    let (amount, angle) = (wanted.norm(), wanted.arg().rem_euclid(TAU));
    if amount == 0.0 {
        return Vec::new();
    }
    let Allowed::Some { angles, sectors } = allowed else { return vec![(angle, amount)] };
    if is_allowed(allowed, angle) {
        return vec![(angle, amount)];
    }
    let ends = || angles.iter().copied().chain(sectors.iter().flatten().copied());
    let distance = |turn: &dyn Fn(f64) -> f64| {
        ends().map(|end| (turn(end), end)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((PI, angle + PI))
    };
    let (below, lower) = distance(&|end| (angle - end).rem_euclid(TAU));
    let (above, upper) = distance(&|end| (end - angle).rem_euclid(TAU));
    if below + above < PI - SAME {
        let sine = (below + above).sin();
        return vec![(lower, amount * above.sin() / sine), (upper, amount * below.sin() / sine)];
    }
    let (near, end) = if below < above { (below, lower) } else { (above, upper) };
    if near < FRAC_PI_2 { vec![(end, amount * near.cos())] } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some(degrees: &[f64], sectors: &[[f64; 2]]) -> Allowed {
        Allowed::Some {
            angles: degrees.iter().map(|d| d.to_radians()).collect(),
            sectors: sectors.iter().map(|ends| ends.map(f64::to_radians)).collect(),
        }
    }

    fn sum(parts: &[(f64, f64)]) -> Complex64 {
        parts.iter().map(|(angle, amount)| Complex64::from_polar(*amount, *angle)).sum()
    }

    #[test]
    fn two_nearest_holes_add_up() {
        let holes: Vec<f64> = (0..12).map(|k| 30.0 * f64::from(k)).collect();
        for degrees in [1.0f64, 44.0, 215.5, 359.0] {
            let wanted = Complex64::from_polar(2e-4, degrees.to_radians());
            let parts = split(wanted, &some(&holes, &[]));
            assert_eq!(parts.len(), 2);
            assert!((sum(&parts) - wanted).norm() < 1e-18, "{degrees}");
            assert!(parts.iter().all(|(_, amount)| *amount > 0.0));
        }
        assert_eq!(split(Complex64::from_polar(1.0, 30f64.to_radians()), &some(&holes, &[])).len(), 1);
    }

    #[test]
    fn sectors_over_zero_and_gaps() {
        let sector = some(&[], &[[350.0, 20.0]]);
        assert!(is_allowed(&sector, 0.1) && is_allowed(&sector, -0.1) && !is_allowed(&sector, 1.0));
        let wanted = Complex64::from_polar(1.0, 80f64.to_radians());
        let parts = split(wanted, &sector);
        // One way out of the gap is 60 degrees, the other 90: the projection on the nearer end leaves the least.
        assert_eq!(parts.len(), 1);
        assert!((parts[0].1 - 60f64.to_radians().cos()).abs() < 1e-12);
        let left = wanted - sum(&parts);
        for other in [0.99, 1.01] {
            assert!((wanted - sum(&[(parts[0].0, parts[0].1 * other)])).norm() > left.norm());
        }
        assert!(split(Complex64::from_polar(1.0, PI), &sector).is_empty());
    }
}
