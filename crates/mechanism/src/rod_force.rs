//! What a rod does to its crankpin: the inertia of piston and rod, side thrust included.
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
//! | F      | inertia of piston and small end along the cylinder axis `u`     | N    |
//! | R      | force of the rod on the crankpin, without its big-end mass      | N    |
//! | m      | big-end mass of an articulated rod, at its knuckle pin `K`      | kg   |
//! | W_m    | distance from crankpin to the master's piston pin along `u_m`   | m    |
//!
//! The big-end mass itself counts with the rotating parts at the crankpin, as everywhere; no gas, no play, no friction.

use crate::drive::Linkage;
use crate::linkage::Slider;
use crate::train::Piston;
use num_complex::Complex64;

/// A piston with its rod and where its crankpin is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RodForce {
    piston: Piston,
    linkage: Linkage,
    /// `e^{i b}` of the cylinder (of the master's cylinder) axis.
    along: Complex64,
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

    /// Force on the crankpin [N] at crank angle `theta` of crankshaft 1 [rad], in the engine's frame.
    pub fn at(&self, theta: f64) -> Complex64 {
        let piston = &self.piston;
        let phi = piston.ratio.value() * theta + piston.phase;
        let motion = piston.drive.motion(phi);
        let inertia = -piston.mass * motion.stroke.travel[2];
        let couple = piston.inertia * motion.stroke.swing[2];
        let rod = |beside: f64, reach: f64| Complex64::new(inertia, -(beside * inertia + couple) / reach);
        match &self.linkage {
            Linkage::Plain(slider) => {
                let (beside, reach) = plain(slider, phi);
                rod(beside, reach) * self.along
            }
            Linkage::Articulated(articulated) => {
                // Where the pins stand is exact, also where their accelerations are truncated.
                let pins = articulated.knuckle(phi, articulated.master.stroke(phi).travel);
                let (_, beside) = articulated.big_end(&pins);
                let on_knuckle =
                    rod(beside[0], reach(articulated.length, beside[0])) * articulated.turn.conj();
                let mass = piston.knuckle.as_ref().map_or(0.0, |knuckle| knuckle.mass);
                let moving = motion.knuckle.as_ref().unwrap_or(&pins);
                let [pin, knuckle] = [moving.crankpin[2], moving.knuckle[2]];
                let lever = pins.knuckle[0] - pins.crankpin[0];
                let (_, master_reach) = plain(&articulated.master, phi);
                let thrust = -(lever.conj() * (on_knuckle - mass * knuckle)).im / master_reach;
                (on_knuckle + mass * (pin - knuckle) + Complex64::new(0.0, thrust)) * self.along
            }
        }
    }
}
