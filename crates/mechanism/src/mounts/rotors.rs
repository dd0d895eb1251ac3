//! What turns in the block: angular momentum of all rotors relative to it, and what that does to its motion (book, eq. 27.12, 27.13).
//!
//! ```text
//! J_rel = SUM over rotors of rho J            rho: speed over that of crankshaft 1        h = J_rel w z       z turns with the block
//! momentum of block and rotors about the centre       I phi' + h              I: the whole block with its rotors held fast
//! h' = J_rel w phi' x z                        the couple -h' on the block: ( -J_rel w phi_y', +J_rel w phi_x', 0 )
//! ```
//! In roll, a drive that keeps the speed relative to the block constant turns every rotor on as the block rolls. It takes the torque for it from the ground,
//! `SUM rho J phi_z''` by virtual work at crankshaft 1, and the block is spared as much: `(I_zz - J_rel) phi_z'' = M_z`.

use crate::mounts::rotor_effects::RotorEffects;
use crate::mounts::spring::Complex6x6;
use crate::mounts::system::MountSystem;
use num_complex::Complex64;

impl MountSystem {
    /// The same with this angular momentum of the rotors over the speed [kg m^2] in place of that of the file; 0 leaves it out.
    #[must_use]
    pub fn with_rotors(mut self, about_z: f64) -> MountSystem {
        self.rotors = about_z;
        self
    }

    /// The same with these of the rotors' effects.
    #[must_use]
    pub fn with_effects(mut self, effects: RotorEffects) -> MountSystem {
        self.effects = effects;
        self
    }

    /// Angular momentum of the rotors over the speed of crankshaft 1 [kg m^2].
    pub fn rotors(&self) -> f64 {
        self.rotors
    }

    /// Adds what the rotors do at this speed [rad/s] to the dynamic stiffness at an angular frequency [rad/s].
    pub(crate) fn add_rotors(&self, matrix: &mut Complex6x6, frequency: f64, speed: f64) {
        if self.effects.couple {
            let gyroscopic = Complex64::new(0.0, frequency * speed * self.rotors);
            matrix[(3, 4)] += gyroscopic;
            matrix[(4, 3)] -= gyroscopic;
        }
        if self.effects.roll {
            matrix[(5, 5)] += frequency * frequency * self.rotors;
        }
    }
}
