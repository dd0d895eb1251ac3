//! Loads of the two bearings of a balance shaft.
//!
//! The weights turn with the shaft at a constant rate, so that each bearing carries a force of constant amount that
//! turns with it. Gravity and the forces of the teeth are left out.
//!
//! ```text
//! A + B = SUM w_s^2 U_k        z_a A + z_b B = SUM z_k w_s^2 U_k
//! ```

use num_complex::Complex64;

/// Amounts of the forces [N] on the bearings in the planes `bearings` [m], of weights `(z, U)` turning at `speed`
/// [rad/s].
pub(crate) fn bearing_loads(weights: &[(f64, Complex64)], bearings: [f64; 2], speed: f64) -> [f64; 2] {
    let [front, rear] = bearings;
    let share = |lever: &dyn Fn(f64) -> f64| {
        let sum: Complex64 = weights.iter().map(|(z, unbalance)| unbalance * lever(*z)).sum();
        speed * speed * sum.norm() / (rear - front)
    };
    [share(&|z| rear - z), share(&|z| z - front)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_weight_is_shared_and_opposed_weights_make_a_couple() {
        let u = Complex64::from_polar(0.02, 0.7);
        let [front, rear] = bearing_loads(&[(0.01, u)], [-0.03, 0.05], 100.0);
        assert!((front + rear - 200.0).abs() < 1e-12 && (front - rear).abs() < 1e-12);
        let [front, rear] = bearing_loads(&[(-0.04, u), (0.04, -u)], [-0.06, 0.06], 100.0);
        // The couple 200 N x 80 mm over 120 mm.
        assert!((front - 200.0 * 0.08 / 0.12).abs() < 1e-12 && (front - rear).abs() < 1e-12);
    }
}
