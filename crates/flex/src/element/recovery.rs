//! Stress within an element.

use super::matrices::gradients;
use super::quadrature::recovery_weights;
use super::{ElementKind, local_coordinates, shape_values};
use crate::Material;
use serde::{Deserialize, Serialize};
use std::ops::{Add, Mul};

/// A stress tensor [Pa]: xx, yy, zz, xy, yz, zx; tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Stress(pub [f64; 6]);

impl Stress {
    /// Equivalent stress of von Mises [Pa].
    ///
    /// ```text
    /// s_v = sqrt(((s_x - s_y)^2 + (s_y - s_z)^2 + (s_z - s_x)^2)/2 + 3 (t_xy^2 + t_yz^2 + t_zx^2))        (book, eq. 43.4)
    /// ```
    pub fn von_mises(&self) -> f64 {
        let [x, y, z, xy, yz, zx] = self.0;
        let normal = (x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2);
        (normal / 2.0 + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
    }

    /// Principal stresses [Pa], the largest first.
    pub fn principal(&self) -> [f64; 3] {
        let [x, y, z, xy, yz, zx] = self.0;
        let mean = (x + y + z) / 3.0;
        let (a, b, c) = (x - mean, y - mean, z - mean);
        let squares = (a * a + b * b + c * c) / 2.0 + xy * xy + yz * yz + zx * zx;
        if squares == 0.0 {
            return [mean; 3];
        }
        let third = a * (b * c - yz * yz) - xy * (xy * c - yz * zx) + zx * (xy * yz - b * zx);
        let radius = (squares / 3.0).sqrt();
        let angle = (third / (2.0 * radius.powi(3))).clamp(-1.0, 1.0).acos() / 3.0;
        let turn = std::f64::consts::TAU / 3.0;
        let value = |k: f64| mean + 2.0 * radius * (angle + k * turn).cos();
        [value(0.0), value(2.0), value(1.0)]
    }

    /// The principal stress of the largest size, with its sign [Pa].
    pub fn dominant(&self) -> f64 {
        let [first, _, third] = self.principal();
        if first.abs() >= third.abs() { first } else { third }
    }
}

impl Add for Stress {
    type Output = Stress;
    fn add(self, other: Stress) -> Stress {
        Stress(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Mul<f64> for Stress {
    type Output = Stress;
    fn mul(self, factor: f64) -> Stress {
        Stress(self.0.map(|value| value * factor))
    }
}

/// Stress at a point of the element's own coordinates, from the displacements of its nodes [m].
pub fn stress_at(
    kind: ElementKind,
    nodes: &[[f64; 3]],
    displacements: &[[f64; 3]],
    material: &Material,
    at: [f64; 3],
) -> Stress {
    let (_, g) = gradients(nodes, &shape_values(kind, at));
    let mut slope = [[0.0; 3]; 3];
    for (node, u) in displacements.iter().enumerate() {
        for a in 0..3 {
            for b in 0..3 {
                slope[a][b] += u[a] * g[node][b];
            }
        }
    }
    let [lambda, mu] = material.lame();
    let dilation = lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
    let normal = |a: usize| dilation + 2.0 * mu * slope[a][a];
    let shear = |a: usize, b: usize| mu * (slope[a][b] + slope[b][a]);
    Stress([normal(0), normal(1), normal(2), shear(0, 1), shear(1, 2), shear(2, 0)])
}

/// For each node the weights of the stresses at the element's superconvergent points.
pub fn extrapolation(kind: ElementKind) -> Vec<Vec<f64>> {
    (0..kind.nodes()).map(|node| recovery_weights(kind, local_coordinates(kind, node))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_stresses_are_roots_and_keep_the_trace() {
        let stress = Stress([120.0, -40.0, 65.0, 33.0, -21.0, 14.0]);
        let [a, b, c] = stress.principal();
        assert!(a >= b && b >= c);
        assert!((a + b + c - 145.0).abs() < 1e-10);
        let pairs = ((a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2)) / 2.0;
        assert!((pairs.sqrt() - stress.von_mises()).abs() < 1e-10);
        let [x, y, z, xy, yz, zx] = stress.0;
        for s in [a, b, c] {
            let (x, y, z) = (x - s, y - s, z - s);
            let determinant = x * (y * z - yz * yz) - xy * (xy * z - yz * zx) + zx * (xy * yz - y * zx);
            assert!(determinant.abs() < 1e-7, "{determinant}");
        }
    }
}
