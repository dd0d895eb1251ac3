//! Contact of the surfaces' roughness below some three times its height, so that overload ends on a floor.
//!
//! ```text
//! p = K E 4.4086e-5 (4 - h/sigma)^6.804,  h < 4 sigma        F = -INT p n R L da
//! ```
//! Source: Greenwood, Tripp, Proc. IMechE 185 (1970) 625; power-law fit of their F_(5/2) as widely used in engine bearings.

use crate::bearing::JournalBearing;
use crate::plane::{Plane, add, direction};
use lanchester_numerics::{GAUSS_8, unit_points};

/// K E: pattern of the asperities 0.003 times 115 GPa, steel on a bearing alloy; typical.
const STIFFNESS: f64 = 0.003 * 115e9;
const INTERVALS: usize = 32;

/// Size of the contact force [N] on the journal, against the eccentricity, at this eccentricity ratio; `roughness` is the composite height sigma [m].
pub fn contact_force(bearing: &JournalBearing, roughness: f64, ratio: f64) -> f64 {
    contact_with_slope(bearing, roughness, ratio).0
}

/// The same with its derivative by the eccentricity ratio [N].
pub fn contact_with_slope(bearing: &JournalBearing, roughness: f64, ratio: f64) -> (f64, f64) {
    let reach = 4.0 * roughness / bearing.clearance;
    if roughness <= 0.0 || 1.0 - ratio >= reach {
        return (0.0, 0.0);
    }
    let edge = ((1.0 - reach) / ratio).clamp(-1.0, 1.0).acos();
    let depth = bearing.clearance / roughness;
    // Pressure and its derivative, both along the line of centres; at the edge both vanish.
    let pressure = |a: f64| {
        let cos = a.cos();
        let over = (4.0 - (1.0 - ratio * cos) * depth).max(0.0);
        let power = STIFFNESS * 4.4086e-5 * over.powf(5.804) * cos;
        [power * over, power * 6.804 * depth * cos]
    };
    let step = edge / INTERVALS as f64;
    let (first, last) = (pressure(0.0), pressure(edge));
    let scale = 2.0 * bearing.radius * bearing.length * step;
    let sum = |k: usize| {
        let inner: f64 = (1..INTERVALS).map(|i| pressure(i as f64 * step)[k]).sum();
        scale * (0.5 * (first[k] + last[k]) + inner)
    };
    (sum(0), sum(1))
}

/// Force [N] of the contact of a tilted journal, and what works with the displacement [m] of its end by tilt, with derivatives: eccentricity and tilt over the
/// clearance as in [`crate::TiltedMotion`], the force as in [`crate::TiltedImpedance`].
pub fn tilted_contact(
    bearing: &JournalBearing,
    roughness: f64,
    eccentricity: Plane,
    tilt: Plane,
) -> ([f64; 4], [[f64; 4]; 4]) {
    let (mut force, mut by_place) = ([0.0; 4], [[0.0; 4]; 4]);
    for (at, weight) in unit_points(&GAUSS_8) {
        let z = 2.0 * at - 1.0;
        let (n, ratio) = direction(add(eccentricity, z, tilt));
        let (size, slope) = contact_with_slope(bearing, roughness, ratio);
        if size == 0.0 {
            continue;
        }
        for (i, force) in force.iter_mut().enumerate() {
            let own = weight * if i < 2 { 1.0 } else { z };
            *force -= own * size * n[i % 2];
            for (j, entry) in by_place[i].iter_mut().enumerate() {
                let along = n[i % 2] * n[j % 2];
                let across = f64::from(u8::from(i % 2 == j % 2)) - along;
                let lever = if j < 2 { 1.0 } else { z };
                *entry -= own * lever * (slope * along + size / ratio * across);
            }
        }
    }
    (force, by_place)
}
