//! What a rod does to its pins and its piston to the wall: gas, and the inertia of piston and rod.
//!
//! The block feels of a piston `F u = -m s'' u` alone, because the cylinder wall takes the side thrust that the crankpin
//! gives. The crankpin feels both. From the balance of moments of the rod about the crankpin (wall force `N v` on the
//! piston, couple `J beta''` of what the two-mass rod misses of its inertia; `q`, `W` as in [`crate::linkage`]):
//!
//! ```text
//! plain rod:        R = F u + N v,                    N = -(q F + J beta'') / W
//! articulated rod:  P as R above, on the knuckle pin K; the master rod hands it on to the crankpin A with the thrust
//!                   of its own piston:
//!                   R = P - m (K'' - A'') + N v_m,    N = -Im( conj(K - A) (P - m K'') ) / W_m
//! ```
//! | symbol | name                                                            | unit |
//! |--------|-----------------------------------------------------------------|------|
//! | F      | inertia of piston and small end, and gas, along the cylinder axis `u` | N    |
//! | R      | force of the rod on the crankpin, without its big-end mass      | N    |
//! | m      | big-end mass of an articulated rod, at its knuckle pin `K`      | kg   |
//! | W_m    | distance from crankpin to the master's piston pin along `u_m`   | m    |
//!
//! Along the crank axis `P` and `m K''` stand in the plane of the articulated rod, whose offset from the master's plane the master rod hands to the
//! crankpin as a couple; the thrust `N v_m` passes from the wall through the master's piston pin to the crankpin in the plane of the *master*.
//! Only so do the forces on the block keep their balance of moments about x and y.
//!
//! The big-end mass itself counts with the rotating parts at the crankpin, as everywhere; no play, no friction. The rod bears on
//! the piston pin with `X = (m_p s'' + f) u - N v`, with the piston's own mass `m_p`, the gas force `f` towards the crank, and `N`
//! of the piston in all: the master's takes what its articulated rods bring.

use crate::train::drive::Linkage;
use crate::train::linkage::Slider;
use crate::train::mechanism::Piston;
use num_complex::Complex64;

/// A piston with its rod and where its crankpin is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RodForce {
    piston: Piston,
    linkage: Linkage,
    /// `e^{i b}` of the cylinder (of the master's cylinder) axis.
    along: Complex64,
}

/// Forces of one rod and its piston at one angle [N].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RodLoads {
    /// `R`: on the crankpin in the engine's frame, without big-end masses.
    pub crankpin: Complex64,
    /// What of `crankpin` acts in the plane of the master: the thrust that an articulated rod gives to its master's piston, in the engine's frame.
    pub in_master_plane: Complex64,
    /// Of an articulated rod: on the knuckle pin in the engine's frame, with its big-end mass.
    pub knuckle: Complex64,
    /// `N`: wall on the own piston along `v`.
    pub thrust: f64,
    /// Of an articulated rod: wall on the master's piston along its `v`, from this rod.
    pub master_thrust: f64,
    /// `s''` in the unit of the own crank angle [m].
    pub acceleration: f64,
}

impl RodLoads {
    /// Force on the crankpin [N] in the rod's own plane, and in that of its master.
    pub fn by_plane(&self) -> [Complex64; 2] {
        [self.crankpin - self.in_master_plane, self.in_master_plane]
    }
}

/// Where the big end stands beside the line of the piston pin, and how far the piston pin stands from it along that line.
fn plain(slider: &Slider, phi: f64) -> (f64, f64) {
    let beside = slider.radius * phi.sin() - slider.offset;
    (beside, reach(slider.length, beside))
}

fn reach(length: f64, beside: f64) -> f64 {
    ((length - beside) * (length + beside)).sqrt()
}

impl RodForce {
    /// Of `piston`, whose axis (or whose master's) has the direction `axis` [rad].
    pub fn new(piston: Piston, linkage: Linkage, axis: f64) -> RodForce {
        RodForce { piston, linkage, along: Complex64::cis(axis) }
    }

    /// Force on the crankpin [N] at crank angle `theta` of crankshaft 1 [rad], in the engine's frame, without gas: in the rod's own plane, and in
    /// that of its master.
    pub fn by_plane(&self, theta: f64) -> [Complex64; 2] {
        self.loads(theta, 0.0).by_plane()
    }

    /// All its forces at crank angle `theta` of crankshaft 1 [rad] with the gas force `gas` [N] towards the crank.
    pub fn loads(&self, theta: f64, gas: f64) -> RodLoads {
        let piston = &self.piston;
        let phi = piston.ratio.value() * theta + piston.phase;
        let motion = piston.drive.motion(phi);
        let acceleration = motion.stroke.travel[2];
        let along = -piston.mass * acceleration - gas;
        let couple = piston.inertia * motion.stroke.swing[1];
        let thrust = |beside: f64, reach: f64| -(beside * along + couple) / reach;
        match &self.linkage {
            Linkage::Plain(slider) => {
                let (beside, reach) = plain(slider, phi);
                let thrust = thrust(beside, reach);
                let crankpin = Complex64::new(along, thrust) * self.along;
                let in_master_plane = Complex64::ZERO;
                RodLoads {
                    crankpin,
                    in_master_plane,
                    knuckle: crankpin,
                    thrust,
                    master_thrust: 0.0,
                    acceleration,
                }
            }
            Linkage::Articulated(articulated) => {
                // Where the pins stand is exact, also where their accelerations are truncated.
                let pins = articulated.knuckle(Complex64::cis(phi));
                let (_, beside) = articulated.big_end(&pins);
                let thrust = thrust(beside[0], reach(articulated.length, beside[0]));
                let on_knuckle = Complex64::new(along, thrust) * articulated.turn.conj();
                let mass = piston.knuckle.as_ref().map_or(0.0, |knuckle| knuckle.mass);
                let moving = motion.knuckle.as_ref().unwrap_or(&pins);
                let [pin, knuckle] = [moving.crankpin[2], moving.knuckle[2]];
                let lever = pins.knuckle[0] - pins.crankpin[0];
                let (_, master_reach) = plain(&articulated.master, phi);
                let with_end = on_knuckle - mass * knuckle;
                let master_thrust = -(lever.conj() * with_end).im / master_reach;
                let in_master_plane = Complex64::new(0.0, master_thrust) * self.along;
                RodLoads {
                    crankpin: (with_end + mass * pin) * self.along + in_master_plane,
                    in_master_plane,
                    knuckle: with_end * self.along,
                    thrust,
                    master_thrust,
                    acceleration,
                }
            }
        }
    }
}
