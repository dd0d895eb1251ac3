//! Spur gears by which crankshaft 1 drives another shaft: the force along the line of action.
//!
//! ```text
//! |ratio| = r_1 / r_2     r_1 + r_2 = a, the distance of the axes     e: from the driven axis to that of crankshaft 1
//! F = (T / r_2) i e - (|T| / r_2) tan(alpha) e                        on the driven wheel at the pitch point, T its torque
//! ```
//! The radial part presses the wheels apart whichever flank bears: `|F| = |T| / (r_2 cos alpha)`. Without play, friction, and meshing of single teeth.

use crate::block_body::in_plane;
use crate::error::MultibodyError;
use crate::train::Train;
use nalgebra::Vector3;

/// Teeth of a driven shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mesh {
    /// Pressure angle [rad].
    pub pressure_angle: f64,
    /// Middle plane of the teeth [m].
    pub z: f64,
}

/// Largest pressure angle [rad].
const STEEPEST: f64 = std::f64::consts::FRAC_PI_4;

impl Train {
    /// The shaft called `name` is driven by external teeth with this pressure angle [rad] in the plane `z` [m].
    ///
    /// # Errors
    /// [`MultibodyError::NoMesh`] where it cannot be.
    pub fn set_mesh(&mut self, name: &str, pressure_angle: f64, z: f64) -> Result<(), MultibodyError> {
        let refused =
            |reason: &str| MultibodyError::NoMesh { shaft: name.to_owned(), reason: reason.to_owned() };
        if !((0.0..=STEEPEST).contains(&pressure_angle) && z.is_finite()) {
            return Err(refused("the pressure angle must lie between 0 and 45 deg"));
        }
        let Some(index) = self.rotors.iter().skip(1).position(|rotor| rotor.name == name) else {
            let others: Vec<&str> = self.rotors.iter().skip(1).map(|rotor| rotor.name.as_str()).collect();
            return Err(refused(&match others.is_empty() {
                true => "the engine has no shaft besides crankshaft 1".to_owned(),
                false => format!("no driven shaft has this name: there are {}", others.join(", ")),
            }));
        };
        let axis = self.rotors[0].axis;
        let rotor = &mut self.rotors[index + 1];
        if rotor.ratio >= 0.0 {
            return Err(refused("external gears turn in opposite senses, and its ratio is not negative"));
        }
        if (axis - rotor.axis).norm() == 0.0 {
            return Err(refused("its axis is that of crankshaft 1"));
        }
        rotor.mesh = Some(Mesh { pressure_angle, z });
        Ok(())
    }

    /// Force on the driven wheel of rotor `index` under the torque that its teeth give it [N].
    pub(crate) fn mesh_force(&self, index: usize, mesh: Mesh, torque: f64) -> Vector3<f64> {
        let rotor = &self.rotors[index];
        let line = self.rotors[0].axis - rotor.axis;
        let (distance, size) = (line.norm(), rotor.ratio.abs());
        let along = line / distance;
        let tangential = torque * (1.0 + size) / distance;
        let apart = tangential.abs() * mesh.pressure_angle.tan();
        in_plane(along * num_complex::Complex64::new(-apart, tangential), 0.0)
    }
}
