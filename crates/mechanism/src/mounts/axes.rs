//! Lines and points of the block and its mounts: torque-roll axis, centre of stiffness.

use crate::mounts::result::{AxisLine, StiffnessCentre};
use crate::mounts::symmetric::symmetric_eigen;
use crate::mounts::system::MountSystem;
use nalgebra::{Matrix3, Vector3};

impl MountSystem {
    /// Line about which the free block turns under a torque about z.
    ///
    /// Its angular acceleration is `I^{-1} e_z`, its centre stays: the line through the centre in that direction.
    pub fn torque_roll_axis(&self) -> AxisLine {
        let inertia: Matrix3<f64> = self.mass.fixed_view::<3, 3>(3, 3).into_owned();
        let factors = inertia.cholesky().expect("invariant: the inertia of a body is positive definite");
        let direction = factors.solve(&Vector3::z()).normalize();
        AxisLine { point: self.body().centre, direction: direction.into() }
    }

    /// Centre of stiffness of the mounts at rest, with the principal directions of translation (book, eq. 27.8).
    ///
    /// ```text
    /// K = ( A  B ; B^T  D ) about the centre;  about a point r from it  B(r) = B + A [r]x
    /// B(r) symmetric:  ( tr(A) E - A ) r = -v,   [v]x = B - B^T
    /// ```
    pub fn stiffness_centre(&self) -> StiffnessCentre {
        let block =
            |i: usize, j: usize| -> Matrix3<f64> { self.stiffness.fixed_view::<3, 3>(i, j).into_owned() };
        let (translation, coupling, rotation) = (block(0, 0), block(0, 3), block(3, 3));
        let skew = coupling - coupling.transpose();
        let v = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]);
        let matrix = Matrix3::identity() * translation.trace() - translation;
        let factors =
            matrix.cholesky().expect("invariant: mounts that leave no free motion hold every translation");
        let offset = -factors.solve(&v);
        let cross = offset.cross_matrix();
        let left = coupling + translation * cross;
        // D(r) = D + B^T [r]x - [r]x B - [r]x A [r]x
        let about = rotation + coupling.transpose() * cross - cross * coupling - cross * translation * cross;
        let principal = symmetric_eigen(&translation);
        let largest = |m: &Matrix3<f64>| m.diagonal().amax();
        StiffnessCentre {
            point: (Vector3::from(self.body().centre) + offset).into(),
            stiffness: std::array::from_fn(|k| principal[k].0),
            directions: std::array::from_fn(|k| principal[k].1.into()),
            coupling: left.amax() / (largest(&translation) * largest(&about)).sqrt(),
        }
    }
}
