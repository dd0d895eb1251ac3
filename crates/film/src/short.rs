//! The short bearing (Ocvirk) in closed form: axial flow alone carries the oil away.
//!
//! ```text
//! d/dz(h^3 dp/dz) = -12 mu v.n      p = (6 mu v.n / h^3)(L^2/4 - z^2)      F = -mu R L^3 INT (v.n) n / h^3 da
//! ```
//! With Sommerfeld's angle g, 1 - eps cos a = d^2/(1 + eps cos g), d = sqrt(1 - eps^2), the integrand is a polynomial in cos g and sin g:
//! `(v.n) n h^-3 da = (|w| cos(g - g*) + eps w_r)(eps + cos g, d sin g) dg / (c^3 d^5)` along and across e, with w = (v_r, d v_t) = |w|(cos g*, sin g*).
//! The film closes for |g - g*| < acos(-eps w_r/|w|): the half film has closed integrals for every velocity, steady or not.
//! Source of the equation: Ocvirk, NACA TN 2808 (1952); Booker, J. Basic Eng. 87 (1965) 537; the integrals are derived here.

use crate::bearing::{JournalBearing, JournalMotion};
use crate::error::{FilmError, require_film};
use crate::plane::{Plane, dot, quarter};
use crate::{check_viscosity, plane};
use std::f64::consts::PI;

/// Force of the short film on the journal [N], with the full film (`cut` false) or its positive half (`cut` true).
///
/// # Errors
/// [`FilmError`] for a bearing or viscosity out of range, [`FilmError::Eccentricity`] at 1 and above.
pub fn short_bearing_force(
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
    let [radial, tangential] = short_integrals(ratio, [dot(v, along), dot(v, across)], cut);
    let scale = -viscosity * bearing.radius * bearing.length.powi(3) / bearing.clearance.powi(3);
    Ok([0, 1].map(|k| scale * (radial * along[k] + tangential * across[k])))
}

/// INT (v.n) n / H^3 da, radial and tangential, for the eccentricity ratio and the velocity along and across it.
pub(crate) fn short_integrals(ratio: f64, v: Plane, cut: bool) -> Plane {
    let d = (1.0 - ratio * ratio).sqrt();
    let w = [v[0], d * v[1]];
    let size = plane::length(w);
    if size == 0.0 {
        return [0.0, 0.0];
    }
    let [cos, sin] = [w[0] / size, w[1] / size];
    let offset = ratio * w[0];
    let (half, sine, product) = if cut {
        let edge = (-offset / size).clamp(-1.0, 1.0);
        let half = edge.acos();
        let sine = (1.0 - edge * edge).sqrt();
        (half, sine, sine * edge)
    } else {
        (PI, 0.0, 0.0)
    };
    let first = size * (half + product) + 2.0 * offset * sine;
    let radial = ratio * (2.0 * size * sine + 2.0 * offset * half) + cos * first;
    let tangential = d * sin * first;
    [radial / d.powi(5), tangential / d.powi(5)]
}

/// Load that a short half film carries under a steady load [N] (Ocvirk), for a speed of entrainment w/2 of a journal that turns at w [rad/s].
///
/// ```text
/// W = mu w R L^3 eps sqrt(pi^2 (1 - eps^2) + 16 eps^2) / (4 c^2 (1 - eps^2)^2)
/// ```
pub fn ocvirk_load(bearing: &JournalBearing, viscosity: f64, speed: f64, ratio: f64) -> f64 {
    let rest = 1.0 - ratio * ratio;
    viscosity
        * speed
        * bearing.radius
        * bearing.length.powi(3)
        * ratio
        * (PI * PI * rest + 16.0 * ratio * ratio).sqrt()
        / (4.0 * bearing.clearance.powi(2) * rest * rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_integrals_equal_quadrature() {
        for (ratio, v) in [(0.0, [1.0, 0.3]), (0.4, [-0.7, 0.2]), (0.9, [0.1, -1.0]), (0.97, [-1.0, 0.01])] {
            for cut in [false, true] {
                let count = 400_000;
                let mut sum = [0.0, 0.0];
                for i in 0..count {
                    let a = 2.0 * PI * (f64::from(i) + 0.5) / f64::from(count);
                    let n = [a.cos(), a.sin()];
                    let closing = dot(v, n);
                    if cut && closing <= 0.0 {
                        continue;
                    }
                    let weight = closing / (1.0 - ratio * n[0]).powi(3) * 2.0 * PI / f64::from(count);
                    sum = [sum[0] + weight * n[0], sum[1] + weight * n[1]];
                }
                let ours = short_integrals(ratio, v, cut);
                let size = plane::length(sum);
                for k in 0..2 {
                    assert!((ours[k] - sum[k]).abs() < 1e-7 * size, "{ratio} {v:?} {cut}: {ours:?} {sum:?}");
                }
            }
        }
    }

    #[test]
    fn steady_half_film_is_ocvirks() {
        let bearing = JournalBearing::new(0.05, 0.03, 1e-4).expect("plausible");
        for ratio in [0.1, 0.5, 0.9] {
            let motion = JournalMotion {
                eccentricity: [ratio * 1e-4, 0.0],
                entrainment: 50.0,
                sliding: 100.0,
                ..JournalMotion::default()
            };
            let force = short_bearing_force(&bearing, 0.1, &motion, true).expect("a film");
            let load = ocvirk_load(&bearing, 0.1, 100.0, ratio);
            assert!((plane::length(force) / load - 1.0).abs() < 1e-12);
            // tan phi = pi sqrt(1 - eps^2)/(4 eps); the journal moves in the sense of rotation from the load, so the force has +y.
            let tangent = force[1] / -force[0];
            assert!((tangent - PI * (1.0 - ratio * ratio).sqrt() / (4.0 * ratio)).abs() < 1e-12);
        }
    }
}
