//! Coefficients of Radau IIA with three stages, order 5.
//!
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, section IV.5 and IV.8; the
//! transformation is that of their program `radau5.f`. The tests derive all of it from the places of the stages.

/// Square root of six.
const S: f64 = 2.449489742783178;
/// First place, (4 - sqrt 6)/10.
pub(crate) const C1: f64 = (4.0 - S) / 10.0;
/// Second place, (4 + sqrt 6)/10.
pub(crate) const C2: f64 = (4.0 + S) / 10.0;
/// The real eigenvalue of the inverse Runge-Kutta matrix: 3 - 3^(1/3) + 3^(2/3).
pub(crate) const REAL: f64 = 3.637834252744496;
/// Real part of the pair: 3 + (3^(1/3) - 3^(2/3))/2.
pub(crate) const PAIR_RE: f64 = 2.6810828736277523;
/// Imaginary part of the pair: (3^(5/6) + 3^(7/6))/2, positive.
pub(crate) const PAIR_IM: f64 = 3.0504301992474105;
/// Transformation to the block form; its last row is (T31, 1, 0).
pub(crate) const T: [[f64; 3]; 3] = [
    [9.123239487089295e-2, -0.1412552950209542, -3.002919410514742e-2],
    [0.241717932707107, 0.20412935229379994, 0.3829421127572619],
    [0.966048182615093, 1.0, 0.0],
];
/// Its inverse.
pub(crate) const T_INVERSE: [[f64; 3]; 3] = [
    [4.325579890063155, 0.33919925181580987, 0.5417705399358749],
    [-4.178718591551905, -0.32768282076106237, 0.47662355450055044],
    [-0.5028726349457868, 2.571926949855605, -0.5960392048282249],
];
/// Weights of the error estimate for the increments.
pub(crate) const ERROR: [f64; 3] = [-(13.0 + 7.0 * S) / 3.0, (-13.0 + 7.0 * S) / 3.0, -1.0 / 3.0];

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrix of the collocation method with the places c: integrals of Lagrange's polynomials from 0 to each place.
    fn collocation() -> [[f64; 3]; 3] {
        let c = [C1, C2, 1.0];
        let mut a = [[0.0; 3]; 3];
        for j in 0..3 {
            let (d, e) = (c[(j + 1) % 3], c[(j + 2) % 3]);
            let scale = (c[j] - d) * (c[j] - e);
            for i in 0..3 {
                let x = c[i];
                a[i][j] = (x * x * x / 3.0 - (d + e) * x * x / 2.0 + d * e * x) / scale;
            }
        }
        a
    }

    #[test]
    fn transformation_brings_the_inverse_of_the_collocation_matrix_to_block_form() {
        let a = collocation();
        let block = [[REAL, 0.0, 0.0], [0.0, PAIR_RE, -PAIR_IM], [0.0, PAIR_IM, PAIR_RE]];
        for i in 0..3 {
            for j in 0..3 {
                let at: f64 =
                    (0..3).map(|k| a[i][k] * (0..3).map(|m| T[k][m] * block[m][j]).sum::<f64>()).sum();
                assert!((at - T[i][j]).abs() < 4e-15, "A T B - T [{i}][{j}] = {}", at - T[i][j]);
                let unit: f64 = (0..3).map(|k| T[i][k] * T_INVERSE[k][j]).sum();
                assert!((unit - f64::from(u8::from(i == j))).abs() < 4e-15, "T T^-1 [{i}][{j}] = {unit}");
            }
        }
    }

    #[test]
    fn quadrature_of_the_stages_has_order_five() {
        let weights = collocation()[2];
        for power in 0..5 {
            let sum: f64 = weights.iter().zip([C1, C2, 1.0]).map(|(w, c)| w * c.powi(power)).sum();
            assert!((sum - 1.0 / f64::from(power + 1)).abs() < 1e-15, "power {power}: {sum}");
        }
    }
}
