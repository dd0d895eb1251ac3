//! Fatigue strength of a place after UR M53.

/// Least radius that the formula takes [m].
const LEAST_RADIUS: f64 = 0.002;

/// Alternating equivalent stress that a place endures [Pa].
///
/// ```text
/// sigma_DW = K (0.42 sigma_B + 39.3) (0.264 + 1.073 D^-0.2 + (785 - sigma_B)/4900 + (196/sigma_B) sqrt(1/R_X))   (49.9)
/// in mm and N/mm2; R_X not below 2 mm
/// ```
/// `forging` K, `tensile_strength` sigma_B [Pa], `diameter` of pin or journal D [m], `radius` R_X of the fillet or half the oil bore [m].
pub fn fatigue_strength(forging: f64, tensile_strength: f64, diameter: f64, radius: f64) -> f64 {
    let tensile = 1e-6 * tensile_strength;
    let (d, r) = (1e3 * diameter, 1e3 * radius.max(LEAST_RADIUS));
    let size = 0.264 + 1.073 * d.powf(-0.2) + (785.0 - tensile) / 4900.0 + 196.0 / tensile * (1.0 / r).sqrt();
    1e6 * forging * (0.42 * tensile + 39.3) * size
}

/// Radius R_X that stands for an oil bore of this diameter [m].
pub fn oil_bore_radius(diameter: f64) -> f64 {
    0.5 * diameter
}
