//! A mount in time: springs and dampers along fixed directions at a point of the block that moves.
//!
//! ```text
//! F = preload a_1 - SUM over directions k of ( K_k (a_k . delta) + C_k (a_k . delta') ) a_k         on the block
//! ```
//! `delta`: displacement of the mount's point from the position that the file describes; the directions `a_k` stand still.

use lanchester_model::Mount;
use nalgebra::{Matrix3, Vector3};

/// A mount with its spring.
#[derive(Debug, Clone, PartialEq)]
pub struct MountPlace {
    /// Name for tables.
    pub name: String,
    /// Its point on the block [m].
    pub at: Vector3<f64>,
    /// Stiffness in the axes of the frame [N/m].
    pub stiffness: Matrix3<f64>,
    /// Viscous damping in the axes of the frame [N s/m].
    pub damping: Matrix3<f64>,
    /// Force on the block in the position of the file [N].
    pub preload: Vector3<f64>,
    /// Whether the file gives it a loss factor or a table over frequency, which has no exact form in time.
    pub frequency_dependent: bool,
}

impl MountPlace {
    /// The mount, where the file gives its spring.
    pub(crate) fn new(mount: &Mount) -> Option<MountPlace> {
        let spring = mount.spring.as_ref()?;
        let axes = spring.axes.map(Vector3::from);
        let along = |values: [f64; 3]| -> Matrix3<f64> {
            (0..3).map(|k| values[k] * axes[k] * axes[k].transpose()).sum()
        };
        Some(MountPlace {
            name: mount.name.clone(),
            at: Vector3::new(mount.x, mount.y, mount.z),
            stiffness: along(spring.stiffness),
            damping: along(spring.damping),
            preload: spring.preload * axes[0],
            frequency_dependent: !spring.table.is_empty()
                || spring.loss_factor.iter().any(|loss| *loss != 0.0),
        })
    }

    /// Force on the block [N] for a displacement [m] and its rate [m/s], axes of the frame.
    pub fn force(&self, displacement: Vector3<f64>, rate: Vector3<f64>) -> Vector3<f64> {
        self.preload - self.stiffness * displacement - self.damping * rate
    }

    /// Energy stored for a displacement [J], 0 in the position of the file.
    pub fn energy(&self, displacement: Vector3<f64>) -> f64 {
        0.5 * displacement.dot(&(self.stiffness * displacement)) - self.preload.dot(&displacement)
    }
}
