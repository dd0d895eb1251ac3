//! Gas on the pistons, with the derivative by one input (book, eq. 32.5 and 32.6).
//!
//! ```text
//! f = ( c p(a) - c_c p_c(a) ) pi/4 B^2    a = |n| (theta - theta_f) - d        T = -SUM f s'/W
//! ```
//! `c` and `c_c` are 1, the factors on the pressures, `d` is 0, the angle by which they come later; `s'` the rate of the travel. A pressure may jump: on either side of its jumps it goes on as the
//! piece that it is there, so that the window of angles in which it is read is given.

use super::quantity::Quantity;
use super::train::{RodMotion, Train};
use num_dual::Dual64;
use std::f64::consts::PI;

/// How far from the ends of a window pressures are read [rad].
const INSIDE: f64 = 1e-9;

/// Angles since firing between which the pressures of one cylinder are smooth [rad].
pub(super) type Window = [f64; 2];

impl Train<'_> {
    /// Angle that the crankshaft of cylinder `index` has turned since firing [rad], in its sense.
    pub fn own_angle(&self, index: usize, theta: Dual64) -> Dual64 {
        (theta - self.firing[index]) * self.prepared.gas[index].rate
    }

    /// Force of the gas on the piston of cylinder `index` towards the crank [N]; 0 where gas does not count.
    pub fn gas_force(&self, index: usize, theta: Dual64, windows: &[Window]) -> Dual64 {
        let Some(gas) = self.prepared.gas.get(index) else { return Dual64::new(0.0, 0.0) };
        let [from, to] = windows[index];
        let own = self.own_angle(index, theta);
        let within = own.re.min(to - INSIDE).max(from + INSIDE);
        let beyond = own - within;
        let [cylinder, crankcase] = [&gas.pressures.cylinder, &gas.pressures.crankcase]
            .map(|curve| beyond * curve.slope(within) + curve.at(within));
        let factor = self.of(Quantity::GasPressure, index, 1.0);
        let beneath = self.of(Quantity::CrankcasePressure, index, 1.0);
        let bore = self.of(Quantity::Bore, index, self.engine.cylinders[index].bore.unwrap_or(0.0));
        (factor * cylinder - beneath * crankcase) * bore * bore * (PI / 4.0)
    }

    /// Torque of the gas at crankshaft 1 [N m].
    pub fn gas_torque(&self, theta: Dual64, windows: &[Window]) -> Dual64 {
        self.gas_torque_of(&self.rods(theta), theta, windows)
    }

    /// Torque of the gas on the pistons of these rods at crankshaft 1 [N m]: the power of its forces over the speed.
    pub fn gas_torque_of(&self, rods: &[RodMotion], theta: Dual64, windows: &[Window]) -> Dual64 {
        let power = |index: usize| -self.gas_force(index, theta, windows) * rods[index].travel.v1;
        (0..self.prepared.gas.len()).map(power).sum::<Dual64>() / self.speed
    }

    /// Torque at crankshaft 1 of all loads that count [N m].
    pub fn torque(&self, theta: Dual64, windows: &[Window]) -> Dual64 {
        let rods = self.rods(theta);
        self.loads_of(theta, &rods).torque + self.gas_torque_of(&rods, theta, windows)
    }
}
