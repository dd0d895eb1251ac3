//! The infinitely long bearing (Sommerfeld): no flow along the axis.
//!
//! ```text
//! d/da(H^3 dP/da) = -v.n        dP/dg = [ (v_t (eps + cos g) - d v_r sin g)(1 + eps cos g) + C (1 + eps cos g)^2 ] / d^5
//! C = -3 eps v_t/(2 + eps^2)    (P returns to itself)
//! ```
//! P = 0 on the line of the largest film. Source: Sommerfeld, Z. Math. Phys. 50 (1904) 97; integrals derived here.

use crate::bearing::{JournalBearing, JournalMotion};
use crate::check_viscosity;
use crate::error::{FilmError, require_film};
use crate::plane::{self, Plane, dot, quarter};
use std::f64::consts::PI;

/// Intervals over Sommerfeld's angle for the half film, whose edge lies anywhere.
const INTERVALS: usize = 4096;

/// Force of the long film on the journal [N]: the full film, or (`cut`) its positive part with p = 0 on the line of the largest film.
///
/// # Errors
/// [`FilmError`] for a bearing or viscosity out of range, [`FilmError::Eccentricity`] at 1 and above.
pub fn long_bearing_force(
    bearing: &JournalBearing,
    viscosity: f64,
    motion: &JournalMotion,
    cut: bool,
) -> Result<Plane, FilmError> {
    bearing.check()?;
    check_viscosity(viscosity)?;
    let (along, size) = plane::direction(motion.eccentricity);
    let ratio = size / bearing.clearance;
    require_film(ratio)?;
    let v = motion.closing();
    let across = quarter(along);
    let v = [dot(v, along), dot(v, across)];
    let [radial, tangential] = if cut { half_integrals(ratio, v) } else { full_integrals(ratio, v) };
    let scale = -bearing.force_scale(viscosity);
    Ok([0, 1].map(|k| scale * (radial * along[k] + tangential * across[k])))
}

/// INT P n da of the full film: `pi v_r/(1 - eps^2)^(3/2)` and `2 pi v_t/((2 + eps^2) sqrt(1 - eps^2))`.
fn full_integrals(ratio: f64, v: Plane) -> Plane {
    let d = (1.0 - ratio * ratio).sqrt();
    [PI * v[0] / d.powi(3), 2.0 * PI * v[1] / ((2.0 + ratio * ratio) * d)]
}

/// P(g) for P(pi) = 0, times d^5.
fn pressure(ratio: f64, d: f64, v: Plane, g: f64) -> f64 {
    let constant = -3.0 * ratio * v[1] / (2.0 + ratio * ratio);
    // Primitives of 1, cos g and cos^2 g over g; the terms in g itself cancel by the choice of C.
    let (sin, cos) = g.sin_cos();
    let squeeze = d * v[0] * (cos + 1.0 + 0.5 * ratio * (cos * cos - 1.0));
    let ring = v[1] * ((1.0 + ratio * ratio) * sin + 0.5 * ratio * sin * cos)
        + constant * (2.0 * ratio * sin + 0.5 * ratio * ratio * sin * cos);
    squeeze + ring
}

fn half_integrals(ratio: f64, v: Plane) -> Plane {
    let d = (1.0 - ratio * ratio).sqrt();
    let mut sum = [0.0, 0.0];
    for i in 0..INTERVALS {
        let g = 2.0 * PI * (i as f64 + 0.5) / INTERVALS as f64;
        let p = pressure(ratio, d, v, g).max(0.0) / d.powi(5);
        let (sin, cos) = g.sin_cos();
        let turn = 1.0 + ratio * cos;
        let weight = p * d / (turn * turn);
        sum = [sum[0] + weight * (ratio + cos), sum[1] + weight * d * sin];
    }
    sum.map(|part| part * 2.0 * PI / INTERVALS as f64)
}

/// Load per length that the full long film carries under a steady load [N/m], the journal turning at `speed` [rad/s].
///
/// ```text
/// W/L = 12 pi mu w R (R/c)^2 eps / ((2 + eps^2) sqrt(1 - eps^2))        attitude 90 deg
/// ```
pub fn sommerfeld_load(bearing: &JournalBearing, viscosity: f64, speed: f64, ratio: f64) -> f64 {
    12.0 * PI * viscosity * speed * bearing.radius * (bearing.radius / bearing.clearance).powi(2) * ratio
        / ((2.0 + ratio * ratio) * (1.0 - ratio * ratio).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_film_is_the_integral_of_its_pressure_and_sommerfelds_load() {
        let bearing = JournalBearing::new(0.05, 0.2, 1e-4).expect("plausible");
        for (ratio, v) in [(0.3, [1.0, 0.0]), (0.6, [0.0, 1.0]), (0.9, [0.4, -0.8])] {
            let d = f64::sqrt(1.0 - ratio * ratio);
            let mut sum = [0.0, 0.0];
            for i in 0..INTERVALS {
                let g = 2.0 * PI * (i as f64 + 0.5) / INTERVALS as f64;
                let (sin, cos) = g.sin_cos();
                let turn = 1.0 + ratio * cos;
                let weight =
                    pressure(ratio, d, v, g) / d.powi(4) / (turn * turn) * 2.0 * PI / INTERVALS as f64;
                sum = [sum[0] + weight * (ratio + cos), sum[1] + weight * d * sin];
            }
            let closed = full_integrals(ratio, v);
            for k in 0..2 {
                assert!((sum[k] - closed[k]).abs() < 1e-9 * plane::length(closed), "{sum:?} {closed:?}");
            }
            let motion = JournalMotion {
                eccentricity: [ratio * 1e-4, 0.0],
                entrainment: 50.0,
                ..JournalMotion::default()
            };
            let force = long_bearing_force(&bearing, 0.02, &motion, false).expect("a film");
            let load = sommerfeld_load(&bearing, 0.02, 100.0, ratio) * bearing.length;
            assert!(
                (force[1] / load - 1.0).abs() < 1e-12 && force[0].abs() < 1e-9 * load,
                "{force:?} {load}"
            );
        }
    }
}
