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
//! `J` is what two end masses miss of a rod's inertia, `psi` its direction. The angle is a dual number too: where a load is looked at an
//! angle that moves with the input, such as that of a jump of the pressure, it carries the rate at which it moves.

use super::follow::{Weights, rotating, throw_of};
use super::input::Input;
use super::over_time::{OverTime, circle, constant, known, times};
use super::prepared::{PistonGas, Prepared};
use super::quantity::Quantity;
use lanchester_model::{Engine, Ratio, RodJoint};
use lanchester_task::Varied;
use num_dual::{Dual64, DualNum};

/// Loads at one angle, each with its derivative by the input.
#[derive(Debug, Clone, Copy)]
pub(super) struct DualLoads {
    /// Force on the block along x and y [N].
    pub force: [Dual64; 2],
    /// Couple on the block about x and y through the origin [N m].
    pub couple: [Dual64; 2],
    /// Roll moment of inertia [N m].
    pub roll: Dual64,
    /// Torque of inertia at crankshaft 1 [N m], at constant speed.
    pub torque: Dual64,
}

/// Vector in the plane across the crank.
pub(super) type Vector = [Dual64; 2];

/// Point in the plane across the crank, over time.
pub(super) type Place = [OverTime; 2];

/// Towards which side of the nominal input is differentiated, where the sides differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Up,
    Down,
}

impl Side {
    /// 1 or -1.
    pub fn sign(self) -> f64 {
        match self {
            Side::Up => 1.0,
            Side::Down => -1.0,
        }
    }
}

/// An engine and the input by which is differentiated.
pub(super) struct Train<'a> {
    pub prepared: &'a Prepared<'a>,
    pub engine: &'a Engine,
    pub speed: Dual64,
    pub side: Side,
    /// Derivative of the factor by which planes stretch.
    stretch: f64,
    input: Input,
    /// Directions of the axes of the cylinders.
    axes: Vec<Vector>,
    /// `theta` [rad] from which the pressures of the cylinders count, where gas counts: their firing top dead centres.
    pub firing: Vec<Dual64>,
}

/// A rod and its piston at one angle.
pub(super) struct RodMotion {
    /// Lower pin: the crankpin, or the knuckle pin of an articulated rod.
    pub big_end: Place,
    /// Piston pin.
    pub pin: Place,
    /// Place in the piston beside its pin, on the cylinder axis.
    pub piston: Place,
    /// Piston pin along the cylinder axis.
    pub travel: OverTime,
    /// Direction of the cylinder axis.
    pub axis: Vector,
    /// Rate and second derivative of the rod's direction.
    pub spin: [Dual64; 2],
    /// Big end, small end, what they miss of the inertia, piston.
    pub masses: [Dual64; 4],
    /// Plane of the cylinder.
    pub z: Dual64,
}

/// What is summed over masses and rods.
struct Sums {
    force: Vector,
    couple: Vector,
    power: Dual64,
    torque: Dual64,
}

impl Sums {
    /// A mass [kg], or an unbalance [kg m] at a radius of 1 m, at `place` in the plane `z`.
    fn mass(&mut self, mass: Dual64, [x, y]: Place, z: Dual64) {
        let force = [-mass * x.v2, -mass * y.v2];
        self.force = [self.force[0] + force[0], self.force[1] + force[1]];
        self.couple = [self.couple[0] - z * force[1], self.couple[1] + z * force[0]];
        self.power += mass * (x.v1 * x.v2 + y.v1 * y.v2);
        self.torque += mass * (x.re * y.v2 - y.re * x.v2);
    }

    /// What two end masses miss of a rod's moment of inertia.
    fn rod(&mut self, inertia: Dual64, [rate, bend]: [Dual64; 2]) {
        self.power += inertia * rate * bend;
        self.torque += inertia * bend;
    }
}

impl<'a> Train<'a> {
    pub fn new(prepared: &'a Prepared<'a>, input: Input, side: Side) -> Train<'a> {
        let engine = &prepared.point.engine;
        let eps = if input.quantity == Quantity::Speed { 1.0 } else { 0.0 };
        let spacing = engine.spacing().filter(|_| input.quantity == Quantity::Spacing);
        let stretch = spacing.map_or(0.0, |spacing| 1.0 / spacing);
        let speed = Dual64::new(prepared.point.speed, eps);
        let (axes, firing) = (Vec::new(), Vec::new());
        let mut train = Train { prepared, engine, speed, side, stretch, input, axes, firing };
        train.axes = (0..engine.cylinders.len()).map(|index| train.axis(index)).collect();
        let firing = |(index, gas): (usize, &PistonGas<'_>)| {
            train.top(index, gas.firing) + train.of(Quantity::PressureDelay, index, 0.0) / gas.rate
        };
        train.firing = prepared.gas.iter().enumerate().map(firing).collect();
        train
    }

    /// A number of part `index`, whose quantity is `quantity`.
    pub fn of(&self, quantity: Quantity, index: usize, value: f64) -> Dual64 {
        let is_input = self.input.quantity == quantity && self.input.is_of(index);
        Dual64::new(value, if is_input { 1.0 } else { 0.0 })
    }

    /// A plane of the crank train, `along` of which stretches with the spacing [m].
    pub fn plane(&self, own: Dual64, along: f64) -> Dual64 {
        own + Dual64::new(0.0, self.stretch * along)
    }

    pub fn part(&self, varied: Varied, index: usize, value: f64) -> Dual64 {
        self.of(Quantity::Part(varied), index, value)
    }

    /// A mass or an unbalance, where inertia counts.
    fn weighed(&self, mass: Dual64) -> Dual64 {
        if self.prepared.has_inertia { mass } else { known(0.0) }
    }

    /// The top dead centre near `theta` [rad]: where the piston has no rate (book, eq. 32.5).
    fn top(&self, index: usize, theta: f64) -> Dual64 {
        let pistons = self.engine.chamber_pistons(index);
        if pistons.len() == 1 {
            let travel = self.rod(known(theta), index).travel;
            return Dual64::new(theta, -travel.v1.eps * self.speed.re / travel.v2.re);
        }
        // The chamber that pistons share: where the sum of areas times travels is highest. The bores move it too.
        let terms = pistons.iter().map(|&piston| {
            let bore = self.of(Quantity::Bore, piston, self.engine.cylinders[piston].bore.unwrap_or(1.0));
            let travel = self.rod(known(theta), piston).travel;
            ((bore * bore * travel.v1).eps, bore.re * bore.re * travel.v2.re)
        });
        let (rate, bend) = terms.fold((0.0, 0.0), |sum, term| (sum.0 + term.0, sum.1 + term.1));
        Dual64::new(theta, -rate * self.speed.re / bend)
    }

    /// Direction of what turns at `ratio`, at the angle `own` of its shaft where crankshaft 1 stands at `theta`.
    fn circle(&self, ratio: Ratio, theta: Dual64, own: Dual64) -> Place {
        circle(own + theta * ratio.value(), self.speed * ratio.value())
    }

    /// Loads of inertia where crankshaft 1 stands at `theta` [rad].
    pub fn loads(&self, theta: Dual64) -> DualLoads {
        self.loads_of(theta, &self.rods(theta))
    }

    /// Rods and pistons where crankshaft 1 stands at `theta` [rad].
    pub fn rods(&self, theta: Dual64) -> Vec<RodMotion> {
        (0..self.engine.cylinders.len()).map(|index| self.rod(theta, index)).collect()
    }

    /// Loads of inertia of these rods and what turns.
    pub fn loads_of(&self, theta: Dual64, rods: &[RodMotion]) -> DualLoads {
        let zero = known(0.0);
        let mut sums = Sums { force: [zero; 2], couple: [zero; 2], power: zero, torque: zero };
        for turning in self.turning_on_cranks(theta, |_, _| true) {
            sums.mass(turning.unbalance, beside(turning.axis, turning.direction), turning.z);
        }
        self.add_shafts(theta, &mut sums);
        for rod in rods {
            let [big, small, inertia, piston] = rod.masses;
            sums.mass(big, rod.big_end, rod.z);
            sums.mass(small, rod.pin, rod.z);
            sums.mass(piston, rod.piston, rod.z);
            sums.rod(inertia, rod.spin);
        }
        let torque = -sums.power / self.speed;
        DualLoads { force: sums.force, couple: sums.couple, roll: -torque - sums.torque, torque }
    }

    /// Throws themselves and counterweights, those on a crankshaft and in a plane that are wanted.
    pub fn turning_on_cranks(&self, theta: Dual64, wanted: impl Fn(usize, Dual64) -> bool) -> Vec<Turning> {
        let engine = self.engine;
        let turning = |crankshaft: usize, angle: Dual64, unbalance: Dual64, z: Dual64| {
            let ratio = engine.crankshafts[crankshaft].ratio;
            wanted(crankshaft, z).then(|| Turning {
                crankshaft,
                axis: self.crankshaft_axis(crankshaft),
                direction: self.circle(ratio, theta, angle + self.phase(crankshaft)),
                unbalance: self.weighed(unbalance),
                z,
            })
        };
        let throws = engine.throws.iter().enumerate().filter_map(|(index, throw)| {
            let angle = self.part(Varied::ThrowAngle, index, throw.angle);
            let unbalance = self.part(Varied::ThrowUnbalance, index, throw.unbalance);
            let z = self.of(Quantity::ThrowPlane, index, throw.unbalance_plane());
            turning(throw.crankshaft, angle, unbalance, self.plane(z, throw.z))
        });
        let weights = engine.counterweights.iter().enumerate().filter_map(|(index, weight)| {
            let mut angle = self.part(Varied::CounterweightAngle, index, weight.angle);
            let mut unbalance = self.part(Varied::CounterweightUnbalance, index, weight.unbalance);
            if self.prepared.point.weights == Weights::Follow {
                let (factor, turned) = self.followed(index);
                (angle, unbalance) = (angle + turned, unbalance * factor);
            }
            let z = self.plane(self.of(Quantity::CounterweightPlane, index, weight.z), weight.z);
            turning(weight.crankshaft, angle, unbalance, z)
        });
        throws.chain(weights).collect()
    }

    /// Factor on the unbalance of counterweight `index` and the angle [rad] by which it turns.
    fn followed(&self, index: usize) -> (Dual64, Dual64) {
        let engine = self.engine;
        let unchanged = (known(1.0), known(0.0));
        let Some(throw) = throw_of(engine, &engine.counterweights[index]) else { return unchanged };
        let nominal = rotating(engine, throw);
        if nominal <= 0.0 {
            return unchanged;
        }
        let own = &engine.throws[throw];
        let big_ends =
            (0..engine.cylinders.len()).filter(|&cylinder| engine.cylinders[cylinder].throw == throw);
        let big_ends = big_ends.map(|cylinder| self.rod_masses(cylinder)[0]).fold(known(0.0), |a, b| a + b);
        let now = self.part(Varied::ThrowUnbalance, throw, own.unbalance)
            + self.of(Quantity::Part(Varied::CrankRadius), throw, own.radius) * big_ends;
        (now / nominal, self.part(Varied::ThrowAngle, throw, 0.0))
    }

    fn add_shafts(&self, theta: Dual64, sums: &mut Sums) {
        let mut number = 0;
        for (index, shaft) in self.engine.shafts.iter().enumerate() {
            let axis = [self.of(Quantity::ShaftX, index, shaft.x), self.of(Quantity::ShaftY, index, shaft.y)];
            for weight in &shaft.weights {
                let phase = self.part(Varied::ShaftPhase, index, weight.phase);
                let unbalance = self.part(Varied::ShaftUnbalance, number, weight.unbalance);
                let z = self.of(Quantity::ShaftWeightPlane, number, weight.z);
                let direction = self.circle(shaft.ratio, theta, phase);
                sums.mass(self.weighed(unbalance), beside(axis, direction), z);
                number += 1;
            }
        }
    }

    /// Rod ends and inertia of cylinder `index`, whether inertia counts or not: big end, small end, what they miss.
    pub fn rod_masses(&self, index: usize) -> [Dual64; 3] {
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

    /// Axis of a crankshaft.
    fn crankshaft_axis(&self, crankshaft: usize) -> Vector {
        let crank = &self.engine.crankshafts[crankshaft];
        [
            self.of(Quantity::CrankshaftX, crankshaft, crank.x),
            self.of(Quantity::CrankshaftY, crankshaft, crank.y),
        ]
    }

    /// Angle of a crankshaft where the first stands at 0.
    pub fn phase(&self, crankshaft: usize) -> Dual64 {
        self.of(Quantity::CrankshaftPhase, crankshaft, self.engine.crankshafts[crankshaft].phase)
    }

    /// Axis of the crankshaft of cylinder `index`.
    pub fn crank_axis(&self, index: usize) -> Vector {
        self.crankshaft_axis(self.engine.throws[self.engine.cylinders[index].throw].crankshaft)
    }

    /// Crankpin of a throw.
    fn crankpin(&self, theta: Dual64, throw: usize) -> Place {
        let own = &self.engine.throws[throw];
        let ratio = self.engine.crankshafts[own.crankshaft].ratio;
        let radius = self.part(Varied::CrankRadius, throw, own.radius);
        let angle = self.part(Varied::ThrowAngle, throw, own.angle) + self.phase(own.crankshaft);
        let [x, y] = self.circle(ratio, theta, angle);
        beside(self.crankshaft_axis(own.crankshaft), [times(x, radius), times(y, radius)])
    }

    /// Direction of the axis of cylinder `index`.
    fn axis(&self, index: usize) -> Vector {
        let axis = self.part(Varied::CylinderAngle, index, self.engine.cylinders[index].angle);
        [axis.cos(), axis.sin()]
    }

    /// Travel of the piston pin of cylinder `index`, whose rod's big end stands at `big_end`; the pin, and a place beside it in its piston.
    fn piston(&self, index: usize, big_end: Place) -> (OverTime, [Place; 2]) {
        let cylinder = &self.engine.cylinders[index];
        let centre = self.crank_axis(index);
        let [along, across] = self.axes[index];
        let length = self.part(Varied::RodLength, index, cylinder.rod.length);
        let line = self.part(Varied::Offset, index, cylinder.offset);
        let net = line + self.of(Quantity::PinOffset, index, cylinder.pin_offset);
        // In the frame of the cylinder: u along its axis, v = i u.
        let centre = centre.map(constant);
        let [x, y] = [big_end[0] - centre[0], big_end[1] - centre[1]];
        let (p, q) = (times(x, along) + times(y, across), times(y, along) - times(x, across) - constant(net));
        let travel = p + (constant(length * length) - q * q).sqrt();
        let [travel_x, travel_y] = [times(travel, along), times(travel, across)];
        let place = |offset: Dual64| {
            let [x, y] = [constant(offset * across), constant(offset * along)];
            [travel_x + centre[0] - x, travel_y + centre[1] + y]
        };
        (travel, [place(net), place(line)])
    }

    /// Lower pin of the rod of cylinder `index`.
    fn big_end(&self, theta: Dual64, index: usize) -> Place {
        let cylinder = &self.engine.cylinders[index];
        let crankpin = self.crankpin(theta, cylinder.throw);
        let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = cylinder.rod.joint else {
            return crankpin;
        };
        // K = A + (knuckle radius/master length) e^{i knuckle angle} (B - A)
        let (_, [pin, _]) = self.piston(master, crankpin);
        let length = self.part(Varied::RodLength, master, self.engine.cylinders[master].rod.length);
        let [dx, dy] = [pin[0] - crankpin[0], pin[1] - crankpin[1]];
        let share = self.of(Quantity::KnuckleRadius, index, knuckle_radius) / length;
        let angle = self.of(Quantity::KnuckleAngle, index, knuckle_angle);
        let [re, im] = [share * angle.cos(), share * angle.sin()];
        [crankpin[0] + times(dx, re) - times(dy, im), crankpin[1] + times(dx, im) + times(dy, re)]
    }

    /// Rod and piston of cylinder `index` where crankshaft 1 stands at `theta` [rad].
    pub fn rod(&self, theta: Dual64, index: usize) -> RodMotion {
        let cylinder = &self.engine.cylinders[index];
        let along = self.plane(self.part(Varied::CylinderPlane, index, cylinder.z), cylinder.z);
        let big_end = self.big_end(theta, index);
        let (travel, [pin, piston]) = self.piston(index, big_end);
        let length = self.part(Varied::RodLength, index, cylinder.rod.length);
        let [dx, dy] = [pin[0] - big_end[0], pin[1] - big_end[1]];
        let square = length * length;
        let spin = [(dx.re * dy.v1 - dy.re * dx.v1) / square, (dx.re * dy.v2 - dy.re * dx.v2) / square];
        let [big, small, inertia] = self.rod_masses(index);
        let piston_mass = self.part(Varied::PistonMass, index, cylinder.piston_mass);
        let masses = [big, small, inertia, piston_mass].map(|mass| self.weighed(mass));
        RodMotion { big_end, pin, piston, travel, axis: self.axes[index], spin, masses, z: along }
    }
}

/// An unbalance that turns with a crankshaft.
pub(super) struct Turning {
    pub crankshaft: usize,
    pub axis: Vector,
    pub direction: Place,
    pub unbalance: Dual64,
    pub z: Dual64,
}

/// A place beside an axis.
fn beside(axis: Vector, [x, y]: Place) -> Place {
    [x + constant(axis[0]), y + constant(axis[1])]
}
