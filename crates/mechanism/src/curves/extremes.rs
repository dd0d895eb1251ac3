//! True extremes of a smooth periodic function over the continuous angle.
//!
//! A grid that resolves the function gives the candidates: every grid extreme that could, by its second difference,
//! still beat the best one. Each is bracketed by a change of sign of the derivative and refined there, so that an
//! extreme is found to the last digits in angle as well as in value.

use lanchester_numerics::illinois;
use lanchester_results::{Extreme, Extremes};
use std::f64::consts::TAU;

/// Values this close, relative to the range, tie: the first angle of them counts.
const TIE: f64 = 1e-13;

/// Extremes of `function` (value, derivative) over one turn, scanned at `count` angles.
pub(crate) fn extremes_over_turn(count: usize, function: impl Fn(f64) -> (f64, f64)) -> Extremes {
    let values: Vec<f64> = (0..count).map(|j| function(TAU * j as f64 / count as f64).0).collect();
    refined_extremes(&values, TAU, function)
}

/// Extremes of the sampled `values` alone.
pub(crate) fn grid_extremes(values: &[f64], period: f64) -> Extremes {
    let mut extremes = Extremes::default();
    for (j, &value) in values.iter().enumerate() {
        let here = Extreme { value, theta: period * j as f64 / values.len() as f64 };
        if j == 0 || value > extremes.max.value {
            extremes.max = here;
        }
        if j == 0 || value < extremes.min.value {
            extremes.min = here;
        }
    }
    extremes
}

/// Extremes over the continuous angle of a function with these `values` on an equally spaced grid of one period;
/// `function` returns value and derivative.
pub(crate) fn refined_extremes(
    values: &[f64],
    period: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> Extremes {
    let max = refined_maximum(values, period, 1.0, &function);
    let min = refined_maximum(values, period, -1.0, &function);
    Extremes { max, min: Extreme { value: -min.value, theta: min.theta } }
}

/// Largest value of `sign` times the function.
fn refined_maximum(values: &[f64], period: f64, sign: f64, function: &impl Fn(f64) -> (f64, f64)) -> Extreme {
    let count = values.len();
    let step = period / count as f64;
    let at = |j: usize| sign * values[j % count];
    let best = (0..count).map(at).fold(f64::NEG_INFINITY, f64::max);
    let range = best - (0..count).map(at).fold(f64::INFINITY, f64::min);
    let mut found: Option<Extreme> = None;
    for j in 0..count {
        let (before, here, after) = (at(j + count - 1), at(j), at(j + 1));
        // A parabola rises by an eighth of the second difference between grid points; half of it is ample where
        // the grid resolves the function.
        let reach = 0.5 * (2.0 * here - before - after).abs();
        if here < before || here < after || here + reach < best {
            continue;
        }
        let theta = bracketed(step, j, sign, function);
        let candidate = Extreme { value: sign * function(theta).0, theta: theta.rem_euclid(period) };
        let candidate =
            if candidate.value >= here { candidate } else { Extreme { value: here, theta: step * j as f64 } };
        let candidate = Extreme { theta: snapped(candidate.theta, period), ..candidate };
        found = Some(match found {
            None => candidate,
            Some(other) if candidate.value > other.value + TIE * range => candidate,
            Some(other) if candidate.value < other.value - TIE * range => other,
            Some(other) if candidate.theta < other.theta => candidate,
            Some(other) => other,
        });
    }
    found.unwrap_or(Extreme { value: best, theta: 0.0 })
}

/// The end of the period is its start.
fn snapped(theta: f64, period: f64) -> f64 {
    if theta < 1e-12 * period || theta > (1.0 - 1e-12) * period { 0.0 } else { theta }
}

/// Root of the derivative beside grid angle `j` where `sign` times the function has a maximum.
fn bracketed(step: f64, j: usize, sign: f64, function: &impl Fn(f64) -> (f64, f64)) -> f64 {
    let slope = |theta: f64| sign * function(theta).1;
    let middle = step * j as f64;
    let rising = slope(middle);
    if rising == 0.0 {
        return middle;
    }
    let other = if rising > 0.0 { middle + step } else { middle - step };
    let far = slope(other);
    if far == 0.0 || (far > 0.0) == (rising > 0.0) {
        // The function is flat to rounding here: the grid angle is as good as any.
        return middle;
    }
    illinois(middle, rising, other, far, 0.0, slope)
}
