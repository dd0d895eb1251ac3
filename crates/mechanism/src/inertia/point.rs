//! Loads at one crank angle with their derivatives: what extremes are refined on.

use crate::train::mechanism::{Mechanism, Piston, Rotor};
use lanchester_results::Components;
use num_complex::Complex64;

/// Loads at one angle and their derivatives by `theta`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Point {
    /// Loads.
    pub value: Components,
    /// Their derivatives by the angle of crankshaft 1 [N/rad], [N m/rad].
    pub slope: Components,
}

/// Adds a force, a couple, a roll moment and a torque.
fn add(to: &mut Components, force: Complex64, couple: Complex64, roll: f64, torque: f64) {
    to.force_x += force.re;
    to.force_y += force.im;
    to.couple_x += couple.re;
    to.couple_y += couple.im;
    to.roll_moment += roll - torque;
    to.shaft_torque += torque;
}

impl Mechanism {
    /// Loads at crank angle `theta` [rad].
    pub fn components(&self, theta: f64) -> Components {
        self.point(theta).value
    }

    /// Loads and their derivatives at crank angle `theta` [rad].
    pub(crate) fn point(&self, theta: f64) -> Point {
        let mut point = Point::default();
        for rotor in &self.rotors {
            rotor.add_to(&mut point, theta);
        }
        for piston in &self.pistons {
            piston.add_to(&mut point, theta);
        }
        point
    }
}

impl Rotor {
    fn add_to(&self, point: &mut Point, theta: f64) {
        let rate = self.ratio.value();
        let turn = Complex64::cis(rate * theta);
        let [force, couple, roll] = [self.force, self.couple, self.roll].map(|c| c * turn);
        add(&mut point.value, force, couple, roll.im, 0.0);
        let by_theta = Complex64::new(0.0, rate);
        add(&mut point.slope, by_theta * force, by_theta * couple, rate * roll.re, 0.0);
    }
}

impl Piston {
    fn add_to(&self, point: &mut Point, theta: f64) {
        let rate = self.ratio.value();
        let phi = rate * theta + self.phase;
        let motion = self.drive.motion(phi);
        let [_, s1, s2, s3] = motion.stroke.travel;
        let [k, k1, k2] = motion.stroke.swing;
        let torque = -rate * (self.mass * s1 * s2 + self.inertia * k * k1);
        let roll = self.inertia * k1 - self.roll * s2;
        add(&mut point.value, -self.force * s2, -self.couple * s2, roll, torque);
        let torque = -rate * (self.mass * (s2 * s2 + s1 * s3) + self.inertia * (k1 * k1 + k * k2));
        let roll = self.inertia * k2 - self.roll * s3;
        add(&mut point.slope, -rate * self.force * s3, -rate * self.couple * s3, rate * roll, rate * torque);

        let (Some(mass), Some(motion)) = (&self.knuckle, &motion.knuckle) else { return };
        let (a, b) = (&motion.crankpin, &motion.knuckle);
        let excess = a[2] - b[2];
        // Im(conj(K) K'') is the moment of the pin's own acceleration about the crankshaft's axis.
        let own = -mass.mass * (b[0].conj() * b[2]).im;
        let torque = -rate * mass.mass * (b[1].conj() * b[2]).re;
        let roll = (mass.roll * excess).im + own;
        add(&mut point.value, mass.force * excess, mass.couple * excess, roll, torque);
        let excess = a[3] - b[3];
        let own = -mass.mass * (b[1].conj() * b[2] + b[0].conj() * b[3]).im;
        let torque = -rate * mass.mass * (b[2].norm_sqr() + (b[1].conj() * b[3]).re);
        let roll = (mass.roll * excess).im + own;
        let (force, couple) = (rate * mass.force * excess, rate * mass.couple * excess);
        add(&mut point.slope, force, couple, rate * roll, rate * torque);
    }
}
