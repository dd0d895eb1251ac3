//! Mass matrix and bias of the equations of motion, by Kane: `M(theta) nu' + h(theta, nu) = Q`.
//!
//! ```text
//! nu = (v, Omega, w)          v, Omega: of the block, in block axes;  w: of crankshaft 1 relative to the block
//! body at c, spin sigma:      velocity      v + Omega x c + c' w
//!                             spin          Omega + sigma' w z
//!                             acceleration  v' + Omega' x c + c' w'  +  a_0,   a_0 = Omega x v + Omega x (Omega x c) + 2 Omega x c' w + c'' w^2
//!                             angular       Omega' + sigma' w' z  +  alpha_0,  alpha_0 = sigma'' w^2 z + Omega x sigma' w z
//! M = SUM J^T D J             h = SUM J^T ( m a_0 ; I alpha_0 + spin x I spin )
//! ```
//! A rotor enters by its first moment `S = SUM U e`, its product `P = SUM U z e` and its polar inertia `J` alone; with `L(x) = Omega x (Omega x x)
//! + 2 w Omega x x' + w^2 x''`, `A` its axis:
//!
//! ```text
//! force   L(S)                              torque on w   S'.(Omega x v + Omega x (Omega x A)) + P'.(Omega x (Omega x z))
//! moment  A x L(S) + z x L(P) + S x (Omega x v + Omega x (Omega x A)) + P x (Omega x (Omega x z)) + J (Omega_z + rho w) Omega x z
//! ```

use crate::block_body::in_plane;
use crate::motion::Motion;
use crate::place::{Place, dot};
use crate::plane_sums::PlaneSums;
use crate::train::Train;
use nalgebra::Vector3;
use num_complex::Complex64;

/// Seven equations of motion of block and crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equations {
    /// Mass matrix, symmetric.
    pub mass: [[f64; 7]; 7],
    /// Bias: inertia loads at `nu' = 0`.
    pub bias: [f64; 7],
}

/// The crank alone: inertia and half its derivative by theta.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankInertia {
    /// `M_ww` [kg m^2].
    pub inertia: f64,
    /// `h_w / w^2` [kg m^2].
    pub bias: f64,
}

impl Train {
    /// Inertia of the crank train as seen at crankshaft 1 in a block at rest.
    pub fn crank_inertia(&self, places: &[Place]) -> CrankInertia {
        let mut inertia: f64 =
            self.rotors.iter().map(|rotor| rotor.inertia * rotor.ratio * rotor.ratio).sum();
        let mut bias = 0.0;
        for (place, cylinder) in places.iter().zip(&self.cylinders) {
            let rod = place.on_rod(cylinder.rod.centre);
            let [_, s1, s2] = place.travel;
            let [sigma1, sigma2] = place.swing;
            inertia += cylinder.piston_mass * s1 * s1
                + cylinder.rod.mass * rod[1].norm_sqr()
                + cylinder.rod.inertia * sigma1 * sigma1;
            bias += cylinder.piston_mass * s1 * s2
                + cylinder.rod.mass * dot(rod[1], rod[2])
                + cylinder.rod.inertia * sigma1 * sigma2;
        }
        CrankInertia { inertia, bias }
    }

    /// Mass times place of all that moves in the block, with the block's own body where it has one [kg m].
    pub fn first_moment(&self, theta: f64, places: &[Place]) -> Vector3<f64> {
        let mut sum = self.block.map_or_else(Vector3::zeros, |block| block.first_moment);
        sum += PlaneSums::new(self, places).first_moment();
        for rotor in &self.rotors {
            sum += in_plane(rotor.first_moment * Complex64::cis(rotor.ratio * theta), 0.0);
        }
        sum
    }

    /// The seven equations at `motion`, with the block's own body where it has one.
    pub fn equations(&self, motion: &Motion, places: &[Place]) -> Equations {
        let (omega, w) = (&motion.spin, motion.speed);
        let mut sums = PlaneSums::new(self, places);
        let turn = Complex64::cis(motion.theta);
        for rotor in &self.rotors {
            sums.add_rotor(rotor, motion.theta, turn);
        }
        let (mut mass, mut first, mut inertia) = (sums.mass, sums.first_moment(), sums.inertia());
        if let Some(block) = &self.block {
            mass += block.mass;
            first += block.first_moment;
            inertia += block.inertia;
        }
        let turning = omega.cross(&motion.velocity);
        let (force, moment, torque) = sums.bias((mass, &first, &inertia), omega, w, &turning);
        let [drift, swing] = sums.columns();
        let [x, y, z] = [first.x, first.y, first.z];
        // m a = m v' - (m c) x Omega' and its transpose.
        let mass = [
            [mass, 0.0, 0.0, 0.0, z, -y, drift.x],
            [0.0, mass, 0.0, -z, 0.0, x, drift.y],
            [0.0, 0.0, mass, y, -x, 0.0, drift.z],
            [0.0, -z, y, inertia[(0, 0)], inertia[(0, 1)], inertia[(0, 2)], swing.x],
            [z, 0.0, -x, inertia[(1, 0)], inertia[(1, 1)], inertia[(1, 2)], swing.y],
            [-y, x, 0.0, inertia[(2, 0)], inertia[(2, 1)], inertia[(2, 2)], swing.z],
            [drift.x, drift.y, drift.z, swing.x, swing.y, swing.z, sums.crank()],
        ];
        Equations { mass, bias: [force.x, force.y, force.z, moment.x, moment.y, moment.z, torque] }
    }
}
