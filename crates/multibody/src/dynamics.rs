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
use crate::train::{Rotor, Train};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;

/// Seven equations of motion of block and crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equations {
    /// Mass matrix, symmetric.
    pub mass: [[f64; 7]; 7],
    /// Bias: inertia loads at `nu' = 0`.
    pub bias: [f64; 7],
}

/// Directions of a rotor's first moment and product at an angle, with their derivatives by theta.
pub(crate) struct TurnedRotor {
    pub first: [Vector3<f64>; 3],
    pub product: [Vector3<f64>; 3],
}

impl TurnedRotor {
    pub fn new(rotor: &Rotor, theta: f64) -> TurnedRotor {
        let turn = Complex64::cis(rotor.ratio * theta);
        let rates =
            [Complex64::ONE, Complex64::I * rotor.ratio, Complex64::new(-rotor.ratio * rotor.ratio, 0.0)];
        let turned = |moment: Complex64| rates.map(|rate| in_plane(moment * turn * rate, 0.0));
        TurnedRotor { first: turned(rotor.first_moment), product: turned(rotor.product) }
    }
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
        let mut sum = Sum::default();
        let (omega, w) = (motion.spin, motion.speed);
        let turning = omega.cross(&motion.velocity);
        if let Some(block) = &self.block {
            sum.mass = block.mass;
            sum.first = block.first_moment;
            sum.inertia = block.inertia;
            sum.force = block.mass * turning + omega.cross(&omega.cross(&block.first_moment));
            sum.moment = block.first_moment.cross(&turning) + omega.cross(&(block.inertia * omega));
        }
        let moving = PlaneSums::new(self, places);
        let (force, moment, torque) = moving.bias(omega, w, turning);
        let [drift, swing] = moving.columns();
        sum.mass += moving.mass;
        sum.first += moving.first_moment();
        sum.inertia += moving.inertia();
        (sum.drift, sum.swing, sum.crank) = (drift, swing, moving.crank());
        sum.force += force;
        sum.moment += moment;
        sum.torque += torque;
        for rotor in &self.rotors {
            sum.add_rotor(rotor, &TurnedRotor::new(rotor, motion.theta), omega, w, turning);
        }
        sum.equations()
    }
}

/// Sums over bodies.
#[derive(Default)]
struct Sum {
    mass: f64,
    first: Vector3<f64>,
    inertia: Matrix3<f64>,
    /// Column of `w`: linear, angular, and itself.
    drift: Vector3<f64>,
    swing: Vector3<f64>,
    crank: f64,
    force: Vector3<f64>,
    moment: Vector3<f64>,
    torque: f64,
}

impl Sum {
    fn add_rotor(
        &mut self,
        rotor: &Rotor,
        turned: &TurnedRotor,
        omega: Vector3<f64>,
        w: f64,
        turning: Vector3<f64>,
    ) {
        let z = Vector3::z();
        let axis = in_plane(rotor.axis, 0.0);
        let ([s, s1, s2], [p, p1, p2]) = (turned.first, turned.product);
        self.first += s;
        let both = 2.0 * axis.dot(&s);
        self.inertia += Matrix3::identity() * both - axis * s.transpose() - s * axis.transpose();
        self.inertia -= z * p.transpose() + p * z.transpose();
        self.inertia[(2, 2)] += rotor.inertia;
        self.drift += s1;
        self.swing += axis.cross(&s1) + z.cross(&p1) + rotor.ratio * rotor.inertia * z;
        self.crank += rotor.ratio * rotor.ratio * rotor.inertia;
        let bias = |x: Vector3<f64>, x1: Vector3<f64>, x2: Vector3<f64>| {
            omega.cross(&(omega.cross(&x) + 2.0 * w * x1)) + w * w * x2
        };
        let (first, product) = (bias(s, s1, s2), bias(p, p1, p2));
        let at_axis = turning + omega.cross(&omega.cross(&axis));
        let along = omega.cross(&omega.cross(&z));
        self.force += first;
        self.moment += axis.cross(&first) + z.cross(&product) + s.cross(&at_axis) + p.cross(&along);
        self.moment += rotor.inertia * (omega.z + rotor.ratio * w) * omega.cross(&z);
        self.torque += s1.dot(&at_axis) + p1.dot(&along);
    }

    fn equations(&self) -> Equations {
        let mut mass = [[0.0; 7]; 7];
        let mut bias = [0.0; 7];
        let [x, y, z] = [self.first.x, self.first.y, self.first.z];
        // m a = m v' - (m c) x Omega' and its transpose.
        let cross = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
        for i in 0..3 {
            mass[i][i] = self.mass;
            for j in 0..3 {
                mass[i][3 + j] = cross[i][j];
                mass[3 + j][i] = cross[i][j];
                mass[3 + i][3 + j] = self.inertia[(i, j)];
            }
            mass[i][6] = self.drift[i];
            mass[6][i] = self.drift[i];
            mass[3 + i][6] = self.swing[i];
            mass[6][3 + i] = self.swing[i];
            bias[i] = self.force[i];
            bias[3 + i] = self.moment[i];
        }
        mass[6][6] = self.crank;
        bias[6] = self.torque;
        Equations { mass, bias }
    }
}
