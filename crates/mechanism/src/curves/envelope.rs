//! The largest size of a turning vector over the cycle, from equally spaced samples.
//!
//! Between samples the vector is the polynomial through the eight nearest of them: for order n at N angles a revolution
//! its error is below 1e-3 (2 pi n / N)^8 of that order, 1e-11 of the tenth order at 720 angles.

use crate::curves::extremes::refined_extremes;
use lanchester_results::Extreme;
use num_complex::Complex64;

/// Samples that a polynomial goes through.
const NODES: usize = 8;

/// Sizes that differ by less than this share over the whole cycle are one.
const CONSTANT: f64 = 1e-9;

/// Below this share of the scale a size is rounding.
const VANISHING: f64 = 1e-12;

/// Largest size of `samples` over the continuous angle of one period [rad]; `scale`: what it is measured against. One that
/// is the same at every angle, or vanishes, is said to lie at 0.
pub(crate) fn largest(samples: &[Complex64], period: f64, scale: f64) -> Extreme {
    let sizes: Vec<f64> = samples.iter().map(|s| s.norm()).collect();
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    if most - least <= CONSTANT * most || most <= VANISHING * scale || samples.len() < NODES {
        return Extreme { value: most, theta: 0.0 };
    }
    let step = period / samples.len() as f64;
    // Wide enough that rounding does not matter, narrow enough that curvature does not.
    let aside = 1e-3 * step;
    refined_extremes(&sizes, period, |theta| {
        let [before, here, after] = [-aside, 0.0, aside].map(|d| between(samples, (theta + d) / step));
        let slope = (here.conj() * (after - before)).re / (2.0 * aside);
        (here.norm(), slope)
    })
    .max
}

/// The vector at `place`, counted in samples, by Lagrange's polynomial through the nearest ones.
fn between(samples: &[Complex64], place: f64) -> Complex64 {
    let first = place.floor() as i64 - (NODES as i64 / 2 - 1);
    let local = place - first as f64;
    let mut sum = Complex64::ZERO;
    for k in 0..NODES {
        let weight: f64 = (0..NODES)
            .filter(|&other| other != k)
            .map(|other| (local - other as f64) / (k as f64 - other as f64))
            .product();
        let at = (first + k as i64).rem_euclid(samples.len() as i64) as usize;
        sum += weight * samples[at];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn the_largest_size_lies_between_samples() {
        // |3 e^{i t} + 2 e^{-i (t - 0.5)} + 0.1 e^{-5 i (t - 0.25)}| is 5.1 where all three point alike: t = 0.25.
        let vector = |t: f64| {
            let part = |size: f64, angle: f64| Complex64::from_polar(size, angle);
            part(3.0, t) + part(2.0, 0.5 - t) + part(0.1, 0.25 + 4.0 * (t - 0.25))
        };
        let samples: Vec<Complex64> = (0..720).map(|j| vector(TAU * f64::from(j) / 720.0)).collect();
        let found = largest(&samples, TAU, 5.0);
        assert!((found.value - 5.1).abs() < 1e-12, "{found:?}");
        assert!((found.theta - 0.25).abs() < 1e-6, "{found:?}");
    }

    #[test]
    fn what_only_turns_is_largest_everywhere() {
        let samples: Vec<Complex64> = (0..72).map(|j| Complex64::from_polar(3.0, f64::from(j))).collect();
        assert_eq!(
            largest(&samples, TAU, 3.0),
            Extreme { value: largest(&samples, TAU, 3.0).value, theta: 0.0 }
        );
        assert!((largest(&samples, TAU, 3.0).value - 3.0).abs() < 1e-14);
    }
}
