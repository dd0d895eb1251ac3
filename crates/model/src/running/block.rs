//! The engine as one rigid body on elastic mounts.

use serde::Serialize;

/// The body that stands on the mounts: the file's `[block]`.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Block {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m], x, y, z from the origin.
    pub centre: [f64; 3],
    /// Moments of inertia about the centre, axes of the frame [kg m^2]: `I_xx`, `I_yy`, `I_zz`.
    pub inertia: [f64; 3],
    /// Products of inertia about the centre [kg m^2]: `P_xy = SUM x y dm`, `P_yz`, `P_zx`. The elements off the diagonal
    /// of the inertia tensor are their negatives.
    pub products: [f64; 3],
    /// Whether mass, centre and inertia hold the pistons and rods.
    pub moving_parts: MovingParts,
    /// Direction of gravity, a unit vector in the frame.
    pub gravity: [f64; 3],
    /// Mean torque that engine and gearbox deliver to the driveline [N m], as a vector in the frame; the block feels its
    /// opposite.
    pub driveline_torque: [f64; 3],
}

/// Whether the numbers of a [`Block`] hold the pistons and rods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MovingParts {
    /// They do: the engine was weighed whole.
    Included,
    /// They do not: pistons and rods are added with the mean of their places over a revolution. Crankshafts and balance
    /// shafts are part of the numbers in either case.
    Added,
}

/// Why no body has the moments and products of inertia of a [`Block`].
#[derive(Debug, Clone, PartialEq)]
pub enum InertiaFault {
    /// A moment of inertia is not positive: its axis.
    NotPositive(usize),
    /// A moment of inertia is larger than the other two together: its axis.
    Triangle(usize),
    /// A product of inertia is larger than the body allows: its place in `products`, and the largest amount [kg m^2].
    Product(usize, f64),
    /// The three products of inertia contradict one another.
    Products,
}

/// Rounding that the inequalities are given, as a share.
const ROUNDING: f64 = 1e-12;

impl Block {
    /// The inertia tensor about the centre [kg m^2].
    pub fn tensor(&self) -> [[f64; 3]; 3] {
        let [xx, yy, zz] = self.inertia;
        let [xy, yz, zx] = self.products;
        [[xx, -xy, -zx], [-xy, yy, -yz], [-zx, -yz, zz]]
    }

    /// Why no body has this inertia, if none has (book, eq. 27.3).
    ///
    /// The second moments `S_ij = SUM x_i x_j dm` of a body are a positive semidefinite matrix. Its diagonal is
    /// `S_xx = (I_yy + I_zz - I_xx) / 2`, the rest are the products; all principal minors must not be negative.
    pub fn inertia_fault(&self) -> Option<InertiaFault> {
        if let Some(axis) = self.inertia.iter().position(|&i| !(i > 0.0 && i.is_finite())) {
            return Some(InertiaFault::NotPositive(axis));
        }
        let half = 0.5 * self.inertia.iter().sum::<f64>();
        let second = self.inertia.map(|i| half - i);
        let slack = ROUNDING * half;
        if let Some(axis) = second.iter().position(|&s| s < -slack) {
            return Some(InertiaFault::Triangle(axis));
        }
        let second = second.map(|s| s.max(0.0));
        for (k, &product) in self.products.iter().enumerate() {
            let most = (second[k] * second[(k + 1) % 3]).sqrt();
            // Not finite counts as too large.
            if product.abs() <= most + slack {
                continue;
            }
            return Some(InertiaFault::Product(k, most));
        }
        let [a, b, c] = second;
        let [ab, bc, ca] = self.products;
        let determinant = a * b * c + 2.0 * ab * bc * ca - a * bc * bc - b * ca * ca - c * ab * ab;
        (determinant < -slack * half * half).then_some(InertiaFault::Products)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(inertia: [f64; 3], products: [f64; 3]) -> Block {
        Block {
            mass: 100.0,
            centre: [0.0; 3],
            inertia,
            products,
            moving_parts: MovingParts::Included,
            gravity: [-1.0, 0.0, 0.0],
            driveline_torque: [0.0; 3],
        }
    }

    #[test]
    fn inertia_is_that_of_some_body_or_refused() {
        assert_eq!(block([5.0, 4.0, 3.0], [0.1, -0.2, 0.3]).inertia_fault(), None);
        // A rod along z and a plate across it lie on the border.
        assert_eq!(block([2.0, 1.0, 1.0], [0.0; 3]).inertia_fault(), None);
        assert_eq!(block([2.1, 1.0, 1.0], [0.0; 3]).inertia_fault(), Some(InertiaFault::Triangle(0)));
        assert_eq!(block([2.0, 0.0, 1.0], [0.0; 3]).inertia_fault(), Some(InertiaFault::NotPositive(1)));
        // S = 1, 2, 3: the product of y and z is at most sqrt 6.
        let found = block([5.0, 4.0, 3.0], [0.0, 2.5, 0.0]).inertia_fault();
        assert_eq!(found, Some(InertiaFault::Product(1, 6.0f64.sqrt())));
        assert_eq!(block([2.0; 3], [-0.9; 3]).inertia_fault(), Some(InertiaFault::Products));
        assert_eq!(block([2.0; 3], [0.9; 3]).inertia_fault(), None);
        assert_eq!(block([2.0; 3], [f64::NAN; 3]).inertia_fault(), Some(InertiaFault::Product(0, 1.0)));
    }

    #[test]
    fn two_masses_have_the_tensor_of_the_definition() {
        // 1 kg at (1, 2, 3) and at its opposite: I = SUM m (r^2 E - r r^T).
        let got = block([26.0, 20.0, 10.0], [4.0, 12.0, 6.0]);
        assert_eq!(got.tensor(), [[26.0, -4.0, -6.0], [-4.0, 20.0, -12.0], [-6.0, -12.0, 10.0]]);
        assert_eq!(got.inertia_fault(), None);
    }
}
