//! The crank train as point masses and rods, with the derivative of everything by one input.
//!
//! Forward differentiation twice over: positions become accelerations by their derivatives by time, and all of them carry their
//! derivative by the input. What the loads are is said by momentum and energy alone, apart from the formulas of `mechanism`:
//!
//! ```text
//! F = -SUM m w''        M_x + i M_y = i SUM z F        w = x + i y of a mass, z its plane
//! M_z = (dE/dt)/W - dL/dt        dE/dt = SUM m (x' x'' + y' y'') + SUM J psi' psi''        (book, eq. 32.1)
//!                                dL/dt = SUM m (x y'' - y x'') + SUM J psi''
//! ```
//! `J` is what two end masses miss of a rod's inertia, `psi` its direction.

use super::input::{Input, Quantity};
use super::jet::{Jet, known};
use lanchester_model::{Engine, Ratio, RodJoint, Varied};
use num_dual::{Dual64, DualNum};

/// Loads on the block at one angle, each with its derivative by the input.
#[derive(Debug, Clone, Copy)]
pub(super) struct DualLoads {
    /// Force along x and y [N].
    pub force: [Dual64; 2],
    /// Couple about x and y through the origin [N m].
    pub couple: [Dual64; 2],
    /// Roll moment [N m].
    pub roll: Dual64,
}

/// Point in the plane across the crank.
type Place = [Jet; 2];

/// An engine and the input by which is differentiated.
pub(super) struct Train<'a> {
    engine: &'a Engine,
    speed: Dual64,
    /// Derivative of the factor by which planes stretch.
    stretch: f64,
    input: Input,
}

/// What is summed over masses and rods.
struct Sums {
    force: [Dual64; 2],
    couple: [Dual64; 2],
    power: Dual64,
    torque: Dual64,
}

impl Sums {
    /// A mass [kg], or an unbalance [kg m] at a radius of 1 m, at `place` in the plane `z`.
    fn mass(&mut self, mass: Dual64, [x, y]: Place, z: Dual64) {
        let force = [-mass * x.bend, -mass * y.bend];
        self.force = [self.force[0] + force[0], self.force[1] + force[1]];
        self.couple = [self.couple[0] - z * force[1], self.couple[1] + z * force[0]];
        self.power += mass * (x.rate * x.bend + y.rate * y.bend);
        self.torque += mass * (x.value * y.bend - y.value * x.bend);
    }

    /// A rod from one place to another at the distance `length`, with the moment of inertia `inertia` beside its end masses.
    fn rod(&mut self, inertia: Dual64, [from, to]: [Place; 2], length: Dual64) {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let square = length * length;
        let rate = (dx.value * dy.rate - dy.value * dx.rate) / square;
        let bend = (dx.value * dy.bend - dy.value * dx.bend) / square;
        self.power += inertia * rate * bend;
        self.torque += inertia * bend;
    }
}

impl<'a> Train<'a> {
    pub fn new(engine: &'a Engine, speed: f64, input: Input) -> Train<'a> {
        let eps = if input.quantity == Quantity::Speed { 1.0 } else { 0.0 };
        let spacing = engine.spacing().filter(|_| input.quantity == Quantity::Spacing);
        let stretch = spacing.map_or(0.0, |spacing| 1.0 / spacing);
        Train { engine, speed: Dual64::new(speed, eps), stretch, input }
    }

    /// A number of part `index`, whose quantity is `quantity`.
    fn of(&self, quantity: Quantity, index: usize, value: f64) -> Dual64 {
        let is_input = self.input.quantity == quantity && self.input.is_of(index);
        Dual64::new(value, if is_input { 1.0 } else { 0.0 })
    }

    /// A plane of the crank train, `along` of which stretches with the spacing [m].
    fn plane(&self, own: Dual64, along: f64) -> Dual64 {
        own + Dual64::new(0.0, self.stretch * along)
    }

    fn part(&self, varied: Varied, index: usize, value: f64) -> Dual64 {
        self.of(Quantity::Part(varied), index, value)
    }

    /// Direction of what turns at `ratio`, at the angle `own` of its shaft where crankshaft 1 stands at `theta`.
    fn circle(&self, ratio: Ratio, theta: f64, own: Dual64) -> [Jet; 2] {
        Jet::circle(own + ratio.value() * theta, self.speed * ratio.value())
    }

    /// Loads where crankshaft 1 stands at `theta` [rad].
    pub fn loads(&self, theta: f64) -> DualLoads {
        let zero = known(0.0);
        let mut sums = Sums { force: [zero; 2], couple: [zero; 2], power: zero, torque: zero };
        self.add_turning(theta, &mut sums);
        for index in 0..self.engine.cylinders.len() {
            self.add_cylinder(theta, index, &mut sums);
        }
        DualLoads { force: sums.force, couple: sums.couple, roll: sums.power / self.speed - sums.torque }
    }

    fn add_turning(&self, theta: f64, sums: &mut Sums) {
        let engine = self.engine;
        for (index, throw) in engine.throws.iter().enumerate() {
            let crank = &engine.crankshafts[throw.crankshaft];
            let angle = self.part(Varied::ThrowAngle, index, throw.angle) + crank.phase;
            let unbalance = self.part(Varied::ThrowUnbalance, index, throw.unbalance);
            let z = self.of(Quantity::ThrowPlane, index, throw.unbalance_plane());
            let z = self.plane(z, throw.z);
            let turning = self.circle(crank.ratio, theta, angle);
            sums.mass(unbalance, beside([known(crank.x), known(crank.y)], turning), z);
        }
        for (index, weight) in engine.counterweights.iter().enumerate() {
            let crank = &engine.crankshafts[weight.crankshaft];
            let angle = self.part(Varied::CounterweightAngle, index, weight.angle) + crank.phase;
            let unbalance = self.part(Varied::CounterweightUnbalance, index, weight.unbalance);
            let z = self.plane(self.of(Quantity::CounterweightPlane, index, weight.z), weight.z);
            let turning = self.circle(crank.ratio, theta, angle);
            sums.mass(unbalance, beside([known(crank.x), known(crank.y)], turning), z);
        }
        let mut number = 0;
        for (index, shaft) in engine.shafts.iter().enumerate() {
            let axis = [self.of(Quantity::ShaftX, index, shaft.x), self.of(Quantity::ShaftY, index, shaft.y)];
            for weight in &shaft.weights {
                let phase = self.part(Varied::ShaftPhase, index, weight.phase);
                let unbalance = self.part(Varied::ShaftUnbalance, number, weight.unbalance);
                let z = self.of(Quantity::ShaftWeightPlane, number, weight.z);
                sums.mass(unbalance, beside(axis, self.circle(shaft.ratio, theta, phase)), z);
                number += 1;
            }
        }
    }

    /// Rod ends and inertia of cylinder `index`: big end, small end, what they miss.
    fn rod_masses(&self, index: usize) -> [Dual64; 3] {
        let rod = &self.engine.cylinders[index].rod;
        let length = self.part(Varied::RodLength, index, rod.length);
        let moved = self.part(Varied::RodCentre, index, 0.0) * rod.mass() / length;
        let big = self.part(Varied::BigEndMass, index, rod.big_end_mass) - moved;
        let small = self.part(Varied::SmallEndMass, index, rod.small_end_mass) + moved;
        let Some(inertia) = rod.inertia else { return [big, small, known(0.0)] };
        let mass = big + small;
        if mass.re <= 0.0 {
            return [big, small, self.of(Quantity::RodInertia, index, inertia)];
        }
        // Two masses on a rod: m_A a^2 + m_B b^2 = m_A m_B l^2/m.
        let ends = big * small * length * length / mass;
        [big, small, self.of(Quantity::RodInertia, index, inertia) - ends]
    }

    /// Crankpin of a throw.
    fn crankpin(&self, theta: f64, throw: usize) -> Place {
        let own = &self.engine.throws[throw];
        let crank = &self.engine.crankshafts[own.crankshaft];
        let radius = self.part(Varied::CrankRadius, throw, own.radius);
        let angle = self.part(Varied::ThrowAngle, throw, own.angle) + crank.phase;
        let [x, y] = self.circle(crank.ratio, theta, angle);
        beside([known(crank.x), known(crank.y)], [x * radius, y * radius])
    }

    /// Piston pin of cylinder `index`, whose rod's big end stands at `big_end`, and a place beside the pin in its piston.
    fn piston(&self, index: usize, big_end: Place) -> [Place; 2] {
        let cylinder = &self.engine.cylinders[index];
        let crank = &self.engine.crankshafts[self.engine.throws[cylinder.throw].crankshaft];
        let axis = self.part(Varied::CylinderAngle, index, cylinder.angle);
        let (along, across) = (axis.cos(), axis.sin());
        let length = self.part(Varied::RodLength, index, cylinder.rod.length);
        let line = self.part(Varied::Offset, index, cylinder.offset);
        let net = line + self.of(Quantity::PinOffset, index, cylinder.pin_offset);
        // In the frame of the cylinder: u along its axis, v = i u.
        let [x, y] = [big_end[0] - Jet::constant(known(crank.x)), big_end[1] - Jet::constant(known(crank.y))];
        let (p, q) = (x * along + y * across, y * along - x * across - Jet::constant(net));
        let travel = p + (Jet::constant(length * length) - q * q).sqrt();
        let place = |offset: Dual64| {
            [
                travel * along + Jet::constant(known(crank.x) - offset * across),
                travel * across + Jet::constant(known(crank.y) + offset * along),
            ]
        };
        [place(net), place(line)]
    }

    fn add_cylinder(&self, theta: f64, index: usize, sums: &mut Sums) {
        let cylinder = &self.engine.cylinders[index];
        let z = self.plane(self.part(Varied::CylinderPlane, index, cylinder.z), cylinder.z);
        let crankpin = self.crankpin(theta, cylinder.throw);
        let big_end = match cylinder.rod.joint {
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
                // K = A + (knuckle radius/master length) e^{i knuckle angle} (B - A)
                let [pin, _] = self.piston(master, crankpin);
                let length = self.part(Varied::RodLength, master, self.engine.cylinders[master].rod.length);
                let [dx, dy] = [pin[0] - crankpin[0], pin[1] - crankpin[1]];
                let (sin, cos) = knuckle_angle.sin_cos();
                let [re, im] = [known(knuckle_radius * cos) / length, known(knuckle_radius * sin) / length];
                [crankpin[0] + dx * re - dy * im, crankpin[1] + dx * im + dy * re]
            }
            RodJoint::Crankpin | RodJoint::Fork | RodJoint::Blade => crankpin,
        };
        let [big, small, inertia] = self.rod_masses(index);
        let [pin, piston] = self.piston(index, big_end);
        sums.mass(big, big_end, z);
        sums.mass(small, pin, z);
        sums.mass(self.part(Varied::PistonMass, index, cylinder.piston_mass), piston, z);
        let length = self.part(Varied::RodLength, index, cylinder.rod.length);
        sums.rod(inertia, [big_end, pin], length);
    }
}

/// A place beside an axis.
fn beside(axis: [Dual64; 2], [x, y]: [Jet; 2]) -> Place {
    [x + Jet::constant(axis[0]), y + Jet::constant(axis[1])]
}
