//! Pressure along the axis of a bearing as a sum of polynomials that vanish at both ends.
//!
//! ```text
//! f_k(z) = (L_(k+1) - L_(k-1)) / sqrt(2 (2k + 1))     f_k' = sqrt((2k + 1)/2) L_k     INT f_j' f_k' dz = 1 for j = k, else 0
//! ```
//! with Legendre's polynomials L over z from -1 to 1, half the length being 1.

use lanchester_numerics::{GAUSS_16, unit_points};
use std::sync::OnceLock;

/// Functions along the axis.
pub(crate) const SHAPES: usize = 6;
/// Points along the axis at which a pressure is seen.
pub(crate) const POINTS: usize = 16;

/// One number a function.
pub(crate) type Line = [f64; SHAPES];
/// One number a pair of functions.
pub(crate) type Block = [Line; SHAPES];

/// Functions at points, and integrals of their products.
#[derive(Debug)]
pub(crate) struct Axial {
    /// Place and weight of each point; the weights add up to 2.
    pub points: [(f64, f64); POINTS],
    /// The functions at each point.
    pub values: [Line; POINTS],
    /// INT z^m f_j f_k dz for m = 0 to 3.
    pub around: [Block; 4],
    /// INT z^m f_j' f_k' dz.
    pub along: [Block; 4],
    /// INT z^m f_k dz for m = 0 and 1.
    pub means: [Line; 2],
}

/// The functions, computed once.
pub(crate) fn axial() -> &'static Axial {
    static AXIAL: OnceLock<Axial> = OnceLock::new();
    AXIAL.get_or_init(Axial::new)
}

impl Axial {
    fn new() -> Axial {
        let mut own = Axial {
            points: [(0.0, 0.0); POINTS],
            values: [[0.0; SHAPES]; POINTS],
            around: [[[0.0; SHAPES]; SHAPES]; 4],
            along: [[[0.0; SHAPES]; SHAPES]; 4],
            means: [[0.0; SHAPES]; 2],
        };
        // The points are exact for all these products: degree 2 (SHAPES + 1) + 3 = 17.
        for (q, (at, share)) in unit_points(&GAUSS_16).enumerate() {
            let (z, weight) = (2.0 * at - 1.0, 2.0 * share);
            let (value, slope) = shapes(z);
            own.points[q] = (z, weight);
            own.values[q] = value;
            for j in 0..SHAPES {
                for m in 0..2 {
                    own.means[m][j] += weight * z.powi(m as i32) * value[j];
                }
                for k in 0..SHAPES {
                    for m in 0..4 {
                        let power = weight * z.powi(m as i32);
                        own.around[m][j][k] += power * value[j] * value[k];
                        own.along[m][j][k] += power * slope[j] * slope[k];
                    }
                }
            }
        }
        own
    }
}

/// The functions and their slopes at `z`.
fn shapes(z: f64) -> (Line, Line) {
    let mut legendre = [1.0; SHAPES + 2];
    legendre[1] = z;
    for k in 1..=SHAPES {
        let n = k as f64;
        legendre[k + 1] = ((2.0 * n + 1.0) * z * legendre[k] - n * legendre[k - 1]) / (n + 1.0);
    }
    let of = |value: &dyn Fn(usize, f64) -> f64| std::array::from_fn(|k| value(k + 1, 2.0 * k as f64 + 3.0));
    (
        of(&|k, odd| (legendre[k + 1] - legendre[k - 1]) / (2.0 * odd).sqrt()),
        of(&|k, odd| (0.5 * odd).sqrt() * legendre[k]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_vanish_at_the_ends_and_their_slopes_are_orthonormal() {
        for end in [-1.0, 1.0] {
            assert!(shapes(end).0.iter().all(|value| value.abs() < 1e-14));
        }
        let (step, z) = (1e-6, 0.37);
        for k in 0..SHAPES {
            let slope = (shapes(z + step).0[k] - shapes(z - step).0[k]) / (2.0 * step);
            assert!((slope - shapes(z).1[k]).abs() < 1e-8);
            for j in 0..SHAPES {
                let unit = f64::from(u8::from(j == k));
                assert!((axial().along[0][j][k] - unit).abs() < 1e-13);
            }
        }
        // INT f_1 dz of f_1 = (z^2 - 1) sqrt(3/8).
        assert!((axial().means[0][0] + 4.0 / 3.0 * 0.375f64.sqrt()).abs() < 1e-14);
    }
}
