//! The block as a rigid body.

use crate::error::MultibodyError;
use lanchester_model::Block;
use nalgebra::{Matrix3, Vector3};

/// A rigid body by its moments about the origin, block axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlockBody {
    /// Mass [kg].
    pub mass: f64,
    /// Mass times centre [kg m].
    pub first_moment: Vector3<f64>,
    /// Inertia tensor about the origin [kg m^2].
    pub inertia: Matrix3<f64>,
}

/// Inertia tensor of a point mass.
pub(crate) fn point_inertia(mass: f64, at: Vector3<f64>) -> Matrix3<f64> {
    mass * (Matrix3::identity() * at.norm_squared() - at * at.transpose())
}

impl BlockBody {
    /// The block of the file with everything that it holds.
    pub(crate) fn whole(block: &Block) -> BlockBody {
        let rows = block.tensor();
        let centre = Vector3::from(block.centre);
        let own = Matrix3::from_fn(|i, j| rows[i][j]);
        BlockBody {
            mass: block.mass,
            first_moment: block.mass * centre,
            inertia: own + point_inertia(block.mass, centre),
        }
    }

    /// Refuses what is no body.
    pub(crate) fn check(&self, part: &str) -> Result<(), MultibodyError> {
        let fault =
            |quantity, got| Err(MultibodyError::BlockTooSmall { part: part.to_owned(), quantity, got });
        if !(self.mass > 0.0 && self.mass.is_finite()) {
            return fault("a mass [kg]", self.mass);
        }
        let centre = self.first_moment / self.mass;
        let own = self.inertia - point_inertia(self.mass, centre);
        let least = own.symmetric_eigenvalues().min();
        if least > 0.0 { Ok(()) } else { fault("a moment of inertia [kg m^2]", least) }
    }
}
