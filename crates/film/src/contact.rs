//! Contact of the surfaces' roughness below some three times its height, so that overload ends on a floor.
//!
//! ```text
//! p = K E 4.4086e-5 (4 - h/sigma)^6.804,  h < 4 sigma        F = -INT p n R L da
//! ```
//! Source: Greenwood, Tripp, Proc. IMechE 185 (1970) 625; power-law fit of their F_(5/2) as widely used in engine bearings.

use crate::bearing::JournalBearing;

/// K E: pattern of the asperities 0.003 times 115 GPa, steel on a bearing alloy; typical.
const STIFFNESS: f64 = 0.003 * 115e9;
const INTERVALS: usize = 32;

/// Size of the contact force [N] on the journal, against the eccentricity, at this eccentricity ratio; `roughness` is the composite height sigma [m].
pub fn contact_force(bearing: &JournalBearing, roughness: f64, ratio: f64) -> f64 {
    let reach = 4.0 * roughness / bearing.clearance;
    if roughness <= 0.0 || 1.0 - ratio >= reach {
        return 0.0;
    }
    let edge = ((1.0 - reach) / ratio).clamp(-1.0, 1.0).acos();
    let pressure = |a: f64| {
        let over = (4.0 - (1.0 - ratio * a.cos()) * bearing.clearance / roughness).max(0.0);
        STIFFNESS * 4.4086e-5 * over.powf(6.804) * a.cos()
    };
    let step = edge / INTERVALS as f64;
    let inner: f64 = (1..INTERVALS).map(|k| pressure(k as f64 * step)).sum();
    2.0 * bearing.radius * bearing.length * step * (0.5 * (pressure(0.0) + pressure(edge)) + inner)
}
