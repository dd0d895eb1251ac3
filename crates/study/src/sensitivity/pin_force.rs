//! Forces of rods on their pins and of pistons on their walls, by Newton's law for rod and piston (book, eq. 32.7).
//!
//! ```text
//! piston:   m_p w_p'' = X - f u + N v                              X: rod on the piston pin, N: wall on the piston along v
//! rod:      m_A A'' + m_B B'' = -X - R + SUM R_s                   R: rod on its lower pin, R_s: articulated rods on their knuckles
//! about A:  d x m_B B'' + J psi'' = -d x X + SUM (K_s - A) x R_s   d = B - A
//! ```

use super::gas_force::Window;
use super::train::{RodMotion, Train, Vector};
use lanchester_model::RodJoint;
use num_dual::Dual64;

/// Forces of one rod and its piston at one angle [N].
#[derive(Debug, Clone, Copy)]
pub(super) struct PinForces {
    /// Wall on the piston along `v`.
    pub thrust: Dual64,
    /// Rod on the piston pin, x and y.
    pub piston_pin: Vector,
    /// Rod on its lower pin, x and y.
    pub lower_pin: Vector,
    /// What the crankpin feels in the plane of this cylinder because of it, x and y.
    pub on_crank: Vector,
}

fn cross(a: Vector, b: Vector) -> Dual64 {
    a[0] * b[1] - a[1] * b[0]
}

fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

fn times(a: Vector, factor: Dual64) -> Vector {
    [a[0] * factor, a[1] * factor]
}

impl RodMotion {
    /// Direction across the cylinder axis.
    fn across(&self) -> Vector {
        [-self.axis[1], self.axis[0]]
    }

    /// Piston pin from the lower pin.
    fn rod(&self) -> Vector {
        [0, 1].map(|k| self.pin[k].re - self.big_end[k].re)
    }

    /// Forces of this rod with nothing on its knuckles.
    fn alone(&self, gas: Dual64) -> PinForces {
        let [big, small, inertia, piston] = self.masses;
        let (rod, across) = (self.rod(), self.across());
        // What the piston needs but for the wall.
        let held = plus([0, 1].map(|k| self.piston[k].v2 * piston), times(self.axis, gas));
        let small_end = [0, 1].map(|k| self.pin[k].v2 * small);
        let moment = cross(rod, plus(held, small_end)) + inertia * self.spin[1];
        let thrust = moment / cross(rod, across);
        let piston_pin = plus(held, times(across, -thrust));
        let lower_pin = [0, 1].map(|k| -(piston_pin[k] + small_end[k] + self.big_end[k].v2 * big));
        PinForces { thrust, piston_pin, lower_pin, on_crank: lower_pin }
    }

    /// Thrust on this piston by the force `on_knuckle` at `knuckle`.
    fn thrust_by(&self, knuckle: Vector, on_knuckle: Vector) -> Dual64 {
        let arm = [0, 1].map(|k| knuckle[k] - self.big_end[k].re);
        -cross(arm, on_knuckle) / cross(self.rod(), self.across())
    }
}

impl Train<'_> {
    /// Forces of the rods and pistons that are wanted, where crankshaft 1 stands at `theta` [rad].
    pub fn pin_forces(
        &self,
        theta: Dual64,
        windows: &[Window],
        wanted: impl Fn(usize) -> bool,
    ) -> Vec<(usize, PinForces)> {
        let alone = |index: usize| {
            let motion = self.rod(theta, index);
            let forces = motion.alone(self.gas_force(index, theta, windows));
            (motion, forces)
        };
        let master = |index: usize| match self.engine.cylinders[index].rod.joint {
            RodJoint::Articulated { master, .. } => Some(master),
            _ => None,
        };
        let is_needed = |index: usize| wanted(index) || master(index).is_some_and(&wanted);
        let mut rods: Vec<Option<(RodMotion, PinForces)>> =
            (0..self.engine.cylinders.len()).map(|index| is_needed(index).then(|| alone(index))).collect();
        for index in 0..rods.len() {
            let Some(master) = master(index).filter(|master| wanted(*master)) else { continue };
            let Some((articulated, of_articulated)) = &rods[index] else { continue };
            let (knuckle, on_knuckle) = (articulated.big_end.map(|along| along.re), of_articulated.lower_pin);
            let Some((motion, own)) = &mut rods[master] else { continue };
            let thrust = motion.thrust_by(knuckle, on_knuckle);
            let by_wall = times(motion.across(), thrust);
            // The thrust passes from the wall through the master's piston pin to the crankpin in the master's plane.
            own.on_crank = plus(own.on_crank, by_wall);
            own.thrust += thrust;
            own.piston_pin = plus(own.piston_pin, times(by_wall, Dual64::new(-1.0, 0.0)));
            own.lower_pin = plus(own.lower_pin, plus(on_knuckle, by_wall));
        }
        let found = rods.into_iter().enumerate().filter(|(index, _)| wanted(*index));
        found.filter_map(|(index, rod)| Some((index, rod?.1))).collect()
    }

    /// Forces of rod `index` and its piston where crankshaft 1 stands at `theta` [rad].
    pub fn pin_force(&self, index: usize, theta: Dual64, windows: &[Window]) -> PinForces {
        let found = self.pin_forces(theta, windows, |own| own == index);
        found.first().expect("invariant: the rod that is wanted is found").1
    }
}
