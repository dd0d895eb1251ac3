//! What acts on block and crank besides inertia, and the accelerations that follow.
//!
//! ```text
//! M nu' = Q - h      Q = ( F + m g ;  N + m c x g + T z ;  g . SUM m c' - SUM (f s' + c s'^2 w) + T + T_i )
//! ```
//! | symbol | name                                                                  | unit |
//! |--------|-----------------------------------------------------------------------|------|
//! | F, N   | force and moment about the origin on the block, block axes            | N, N m |
//! | f, c   | gas force on a piston towards the crank; viscous friction             | N, N s/m |
//! | T, T_i | torque on crankshaft 1 from the ground; from the block                | N m  |
//!
//! The angular velocity of crankshaft 1 in space is `Omega_z + w`: what the ground does to it enters both rows, what the block does the last alone.

use crate::dynamics::Equations;
use crate::place::Place;
use crate::symmetric;
use crate::train::Train;
use nalgebra::Vector3;

/// Loads on block and crank at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loads<'a> {
    /// Gas force on every piston towards the crank [N].
    pub gas: &'a [f64],
    /// Acceleration of gravity in block axes [m/s^2].
    pub gravity: Vector3<f64>,
    /// Viscous friction of a piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// Force on the block, as of its mounts, block axes [N].
    pub force: Vector3<f64>,
    /// Moment on the block about its origin, block axes [N m].
    pub moment: Vector3<f64>,
    /// Torque on crankshaft 1 from the ground [N m].
    pub outer_torque: f64,
    /// Torque on crankshaft 1 from the block [N m].
    pub inner_torque: f64,
}

impl<'a> Loads<'a> {
    /// Gas forces alone.
    pub fn gas(gas: &'a [f64]) -> Loads<'a> {
        let zero = Vector3::zeros();
        Loads {
            gas,
            gravity: zero,
            piston_damping: 0.0,
            force: zero,
            moment: zero,
            outer_torque: 0.0,
            inner_torque: 0.0,
        }
    }
}

impl Train {
    /// Torque of gas and piston friction on crankshaft 1 [N m] at `speed`.
    pub fn piston_torque(&self, places: &[Place], speed: f64, gas: &[f64], damping: f64) -> [f64; 2] {
        let mut torque = [0.0; 2];
        for (place, force) in places.iter().zip(gas) {
            let rate = place.travel[1];
            torque[0] -= force * rate;
            torque[1] -= damping * rate * rate * speed;
        }
        torque
    }

    /// Forces on the seven speeds.
    pub fn generalised_forces(
        &self,
        equations: &Equations,
        places: &[Place],
        speed: f64,
        loads: &Loads<'_>,
    ) -> [f64; 7] {
        let [gas, damping] = self.piston_torque(places, speed, loads.gas, loads.piston_damping);
        let own = [loads.force, loads.moment + loads.outer_torque * Vector3::z()];
        let mut forces = [0.0; 7];
        for k in 0..3 {
            forces[k] = own[0][k];
            forces[3 + k] = own[1][k];
        }
        forces[6] = gas + damping + loads.outer_torque + loads.inner_torque;
        // Weight acts as if the frame accelerated upwards.
        for (force, row) in forces.iter_mut().zip(&equations.mass) {
            *force += row[0] * loads.gravity.x + row[1] * loads.gravity.y + row[2] * loads.gravity.z;
        }
        forces
    }
}

impl Equations {
    /// Rates of the seven speeds under `forces`; `None` where the mass matrix is not positive definite.
    pub fn accelerations(&self, forces: &[f64; 7]) -> Option<[f64; 7]> {
        // The rows of the origin's acceleration are `m a + B alpha = f`: what is left for `alpha` has the matrix `A - B^T B / m`.
        let own: [f64; 7] = std::array::from_fn(|i| forces[i] - self.bias[i]);
        let mass = self.mass[0][0];
        if mass.is_nan() || mass <= 0.0 {
            return None;
        }
        let by_mass = 1.0 / mass;
        let mut matrix = [[0.0; 4]; 4];
        let mut turns = [0.0; 4];
        for i in 0..4 {
            let row = &self.mass[3 + i];
            let over_mass = [row[0] * by_mass, row[1] * by_mass, row[2] * by_mass];
            for j in 0..=i {
                let other = &self.mass[3 + j];
                matrix[i][j] = row[3 + j]
                    - (over_mass[0] * other[0] + over_mass[1] * other[1] + over_mass[2] * other[2]);
            }
            turns[i] = own[3 + i] - (over_mass[0] * own[0] + over_mass[1] * own[1] + over_mass[2] * own[2]);
        }
        symmetric::solve(&mut matrix, &mut turns, 4)?;
        let mut rates = [0.0; 7];
        for k in 0..3 {
            let carried: f64 = (0..4).map(|j| self.mass[k][3 + j] * turns[j]).sum();
            rates[k] = (own[k] - carried) * by_mass;
        }
        rates[3..].copy_from_slice(&turns);
        Some(rates)
    }

    /// Kinetic energy at these speeds [J].
    pub fn kinetic_energy(&self, speeds: &[f64; 7]) -> f64 {
        0.5 * self.momenta(speeds).iter().zip(speeds).map(|(p, v)| p * v).sum::<f64>()
    }

    /// Momenta of the seven speeds: linear, angular about the block's origin, and of the crank.
    pub fn momenta(&self, speeds: &[f64; 7]) -> [f64; 7] {
        self.mass.map(|row| row.iter().zip(speeds).map(|(m, v)| m * v).sum())
    }
}
