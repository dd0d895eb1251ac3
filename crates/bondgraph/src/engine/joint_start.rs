//! Where compliant joints start: each spring holds what the ideal joint would carry, so that nothing rattles.
//!
//! Momentum balances outwards in, with the inertia forces of the graph with ideal joints at its start:
//!
//! ```text
//! piston along     F_u = m a.u - W.u - S             S: gas and friction along the cylinder
//! rod about A      d x F = (A - G) x (m a - W) - I alpha - SUM (K - A) x F_K
//! piston across    N = m a.v - W.v - F.v
//! rod              F_A = m a - W + F + SUM F_K
//! ```
//! | symbol | name                                                             | unit |
//! |--------|------------------------------------------------------------------|------|
//! | F      | force of the rod on the piston, at the pin                       | N    |
//! | F_A    | force of the crankpin (or knuckle pin) on the rod                | N    |
//! | F_K    | the same of an articulated rod at its knuckle pin K              | N    |
//! | N      | force of both contacts on the skirt, along v                     | N    |
//! | A, G   | lower eye and centre of the rod; d: from its lower to its upper eye | m |
//! | W      | weight                                                           | N    |

use super::Builder;
use super::joints::CompliantJoints;
use super::numbers::{self, Linkage, linkage, rate, rotation};
use super::request::EngineBlock;
use lanchester_model::RodJoint;
use num_complex::Complex64;
use std::collections::HashMap;

/// Start of rod, piston and joints of one cylinder; vectors in the axes of the block, from the axis of the crankshaft.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CylinderStart {
    /// Centre of the rod [m] and its velocity [m/s].
    pub(crate) rod: [[f64; 2]; 2],
    /// Angle of the rod from lower to upper eye [rad] and its rate [rad/s].
    pub(crate) turn: [f64; 2],
    /// Travel of the piston's centre [m] and its rate [m/s].
    pub(crate) travel: [f64; 2],
    /// Place of the piston's centre across its cylinder [m].
    pub(crate) across: f64,
    /// Tilt of the piston in its cylinder [rad].
    pub(crate) tilt: f64,
    /// Deflection of the lower joint along x and y [m].
    pub(crate) lower: [f64; 2],
    /// Deflection of the piston pin along and across the cylinder [m].
    pub(crate) pin: [f64; 2],
    /// Deflection of both contacts [m].
    pub(crate) contacts: [f64; 2],
}

/// Start of all free bodies.
#[derive(Debug, Clone, Default)]
pub(crate) struct JointStart {
    pub(crate) cylinders: Vec<CylinderStart>,
    /// Displacement of each crankshaft in its main bearings [m].
    pub(crate) crankshafts: Vec<[f64; 2]>,
}

/// Forces of one cylinder: on the piston at its pin, of the contacts, on the rod at its lower eye.
#[derive(Debug, Clone, Copy, Default)]
struct Forces {
    pin: [f64; 2],
    wall: f64,
    lower: [f64; 2],
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl Builder<'_> {
    /// Starts of all free bodies; `ideal` holds the efforts of the bonds of the graph with ideal joints, by their names, at the start.
    pub(crate) fn joint_start(&self, joints: &CompliantJoints, ideal: &HashMap<String, f64>) -> JointStart {
        let engine = self.engine;
        let count = engine.cylinders.len();
        let is_slave =
            |index: usize| matches!(engine.cylinders[index].rod.joint, RodJoint::Articulated { .. });
        let order: Vec<usize> = (0..count)
            .filter(|index| is_slave(*index))
            .chain((0..count).filter(|index| !is_slave(*index)))
            .collect();
        let mut forces = vec![Forces::default(); count];
        // Reaction of slaves on their master's rod: force, and moment about its lower eye.
        let mut on_master = vec![([0.0; 2], 0.0); count];
        let mut on_crank = self.own_forces(joints, ideal);
        for index in &order {
            let index = *index;
            let own = self.forces(index, on_master[index], ideal);
            forces[index] = own;
            let cylinder = &engine.cylinders[index];
            if let RodJoint::Articulated { master, .. } = cylinder.rod.joint {
                let (ours, theirs) = (self.start_linkage(index), self.start_linkage(master));
                let arm = [0, 1].map(|k| ours.lower_pin[k] - theirs.lower_pin[k]);
                on_master[master].0 = [0, 1].map(|k| on_master[master].0[k] + own.lower[k]);
                on_master[master].1 += cross(arm, own.lower);
            } else if let Some(force) = on_crank.get_mut(engine.throws[cylinder.throw].crankshaft) {
                *force = [0, 1].map(|k| force[k] - own.lower[k]);
            }
        }
        let crankshafts: Vec<[f64; 2]> = (0..engine.crankshafts.len())
            .map(|shaft| match joints.crankshafts.get(shaft) {
                Some(Some(_)) => on_crank[shaft].map(|force| force / joints.stiffness),
                _ => [0.0; 2],
            })
            .collect();
        let mut cylinders = vec![CylinderStart::default(); count];
        for index in order.iter().rev() {
            cylinders[*index] =
                self.cylinder_start(*index, joints, &forces[*index], &cylinders, &crankshafts);
        }
        JointStart { cylinders, crankshafts }
    }

    fn start_linkage(&self, index: usize) -> Linkage {
        linkage(self.engine, index, self.request.start_angle)
    }

    /// Force of its unbalance, weight and carriage by the block on each crankshaft [N].
    fn own_forces(&self, joints: &CompliantJoints, ideal: &HashMap<String, f64>) -> Vec<[f64; 2]> {
        let engine = self.engine;
        let weight = self.weight(1.0);
        let block = self.block_acceleration(ideal);
        let effort = ideal.get("crankshaft").copied().unwrap_or(0.0);
        let inertia = self.numbers.rotor_inertia[0];
        let turning = if inertia > 0.0 { effort / inertia - block.1[2] } else { 0.0 };
        (0..engine.crankshafts.len())
            .map(|index| {
                let shaft = &engine.crankshafts[index];
                let ratio = shaft.ratio.value();
                let turned = shaft.phase + ratio * self.request.start_angle;
                let throws = engine
                    .throws
                    .iter()
                    .filter(|throw| throw.crankshaft == index)
                    .map(|throw| throw.unbalance * Complex64::from_polar(1.0, turned + throw.angle));
                let weights = engine
                    .counterweights
                    .iter()
                    .filter(|weight| weight.crankshaft == index)
                    .map(|weight| Complex64::from_polar(weight.unbalance, turned + weight.angle));
                let unbalance: Complex64 = throws.chain(weights).sum();
                // -d^2/dt^2 of U e^(i phi).
                let load = unbalance * Complex64::new((ratio * self.request.speed).powi(2), -ratio * turning);
                let Some([mass, z]) = joints.crankshafts.get(index).copied().flatten() else {
                    return [load.re, load.im];
                };
                let arm = [0, 1, 2].map(|k| self.seen_from_centre(k, [shaft.x, shaft.y, z][k]));
                let (spin, (centre, angular)) = (self.request.start.spin, block);
                let (around, outwards) =
                    (numbers::cross(angular, arm), numbers::cross(spin, numbers::cross(spin, arm)));
                let carried =
                    [0, 1].map(|k| if self.moves() { centre[k] + around[k] + outwards[k] } else { 0.0 });
                [load.re + mass * (weight[0] - carried[0]), load.im + mass * (weight[1] - carried[1])]
            })
            .collect()
    }

    /// Acceleration of the block's centre [m/s^2], its part in the plane, and angular acceleration [rad/s^2], in its axes.
    fn block_acceleration(&self, ideal: &HashMap<String, f64>) -> ([f64; 2], [f64; 3]) {
        if !self.moves() || self.request.block == EngineBlock::Held {
            return ([0.0; 2], [0.0; 3]);
        }
        let effort = |name: &str| ideal.get(name).copied();
        let force = ["x", "y", "z"].map(|axis| effort(&format!("block_{axis}")).unwrap_or(0.0));
        let mass = self.numbers.block_mass;
        let moment = [("x", 1), ("y", 2), ("z", 3)].map(|(axis, port)| {
            effort(&format!("block_turn_{axis}")).or(effort(&format!("block_turn.{port}"))).unwrap_or(0.0)
        });
        let angular = match self.request.block {
            EngineBlock::Plane => [0.0, 0.0, moment[2] / self.numbers.block_inertia[2][2]],
            _ => numbers::apply(numbers::inverse(self.numbers.block_inertia), moment),
        };
        (self.in_block(force.map(|part| part / mass)), angular)
    }

    /// Weight of a mass in the axes of the block [N], its part in the plane.
    fn weight(&self, mass: f64) -> [f64; 2] {
        let [x, y, z] = self.numbers.gravity;
        self.in_block([x, y, z]).map(|part| mass * self.request.gravity * part)
    }

    /// The part in the plane of a vector of the ground's axes, in the axes of the block at the start.
    fn in_block(&self, vector: [f64; 3]) -> [f64; 2] {
        let turn = rotation(if self.moves() { self.request.start.orientation } else { [1.0, 0.0, 0.0, 0.0] });
        [0, 1].map(|k| (0..3).map(|i: usize| turn[i][k] * vector[i]).sum())
    }

    fn forces(
        &self,
        index: usize,
        (on_rod, moment): ([f64; 2], f64),
        ideal: &HashMap<String, f64>,
    ) -> Forces {
        let cylinder = &self.engine.cylinders[index];
        let numbers = self.numbers.cylinders[index];
        let k = index + 1;
        let effort = |name: String| ideal.get(&name).copied().unwrap_or(0.0);
        let vector =
            |stem: &str| self.in_block(["x", "y", "z"].map(|axis| effort(format!("{stem}{k}_{axis}"))));
        let linkage = self.start_linkage(index);
        let d = [0, 1].map(|i| linkage.piston_pin[i] - linkage.lower_pin[i]);
        let (sin, cos) = cylinder.angle.sin_cos();
        let (u, v) = ([cos, sin], [-sin, cos]);
        let (piston, rod) = (vector("piston"), vector("rod"));
        let (piston_weight, rod_weight) =
            (self.weight(cylinder.piston_mass), self.weight(cylinder.rod.mass()));
        let along = -effort(format!("slide{k}.2"));
        let pin_along = dot(piston, u) - dot(piston_weight, u) - along;
        // In space the rod's turn is that of one eye about the other.
        let turning = effort(format!("rod_turn{k}")) + cross(d, vector("rod_turn"));
        let net = [0, 1].map(|i| rod[i] - rod_weight[i]);
        let lower_arm = d.map(|part| -numbers.rod_centre * part);
        let about = cross(lower_arm, net) - turning - moment;
        let pin_across = (about + dot(d, v) * pin_along) / dot(d, u);
        let pin = [0, 1].map(|i| pin_along * u[i] + pin_across * v[i]);
        Forces {
            pin: [pin_along, pin_across],
            wall: dot(piston, v) - dot(piston_weight, v) - pin_across,
            lower: [0, 1].map(|i| net[i] + pin[i] + on_rod[i]),
        }
    }

    fn cylinder_start(
        &self,
        index: usize,
        joints: &CompliantJoints,
        forces: &Forces,
        others: &[CylinderStart],
        crankshafts: &[[f64; 2]],
    ) -> CylinderStart {
        let engine = self.engine;
        let cylinder = &engine.cylinders[index];
        let length = cylinder.rod.length;
        let linkage = self.start_linkage(index);
        let (pin_rate, travel_rate) = rate(engine, index, self.request.start_angle);
        let (sin, cos) = cylinder.angle.sin_cos();
        let (u, v) = ([cos, sin], [-sin, cos]);
        let pin_offset = cylinder.net_offset() - cylinder.offset;
        let apart = joints.contact_distance(engine, index);
        // Both contacts: their sum is the wall's force, their moment that of the pin's force about the piston's centre.
        let middle = joints.skirt_offset;
        let couple = 2.0 * (pin_offset * forces.pin[0] - middle * forces.wall) / apart;
        let contacts = [1.0, -1.0].map(|side| -0.5 * (forces.wall + side * couple) / joints.skirt_stiffness);
        let tilt = ((contacts[0] - contacts[1]) / apart).clamp(-1.0, 1.0).asin();
        let across = cylinder.offset + 0.5 * (contacts[0] + contacts[1]) - middle * tilt.sin();
        let lower = forces.lower.map(|force| -force / joints.stiffness);
        let pin = forces.pin.map(|force| force / joints.stiffness);
        let joint = match cylinder.rod.joint {
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
                let own = &others[master];
                let numbers = &self.numbers.cylinders[master];
                let reach = numbers.rod_centre * engine.cylinders[master].rod.length;
                let (along, knuckle) = (own.turn[0].sin_cos(), (own.turn[0] + knuckle_angle).sin_cos());
                [
                    own.rod[0][0] - reach * along.1 + knuckle_radius * knuckle.1,
                    own.rod[0][1] - reach * along.0 + knuckle_radius * knuckle.0,
                ]
            }
            _ => {
                let shift = crankshafts[engine.throws[cylinder.throw].crankshaft];
                [0, 1].map(|k| linkage.lower_pin[k] + shift[k])
            }
        };
        let eye = [0, 1].map(|k| joint[k] + lower[k]);
        let side = across + pin_offset * tilt.cos() + pin[1] - dot(eye, v);
        let reach = (length * length - side * side).max(0.0).sqrt();
        let travel = dot(eye, u) + reach - pin[0] + pin_offset * tilt.sin();
        let d = [0, 1].map(|k| reach * u[k] + side * v[k]);
        let share = self.numbers.cylinders[index].rod_centre;
        // Rates are those of ideal joints: deflections change slowly at first.
        let speed = self.request.speed;
        let rigid = [0, 1].map(|k| linkage.piston_pin[k] - linkage.lower_pin[k]);
        let d_rate = [0, 1].map(|k| travel_rate * u[k] - pin_rate[k]);
        CylinderStart {
            rod: [
                [0, 1].map(|k| eye[k] + share * d[k]),
                [0, 1].map(|k| speed * (pin_rate[k] + share * d_rate[k])),
            ],
            turn: [d[1].atan2(d[0]), speed * cross(rigid, d_rate) / (length * length)],
            travel: [travel, speed * travel_rate],
            across,
            tilt,
            lower,
            pin,
            contacts,
        }
    }

    /// Refuses an engine whose parts cannot move by themselves.
    pub(crate) fn check_joints(&self, joints: &CompliantJoints) -> Result<(), super::EngineGraphError> {
        if let Some(needed) = joints.fault() {
            return Err(super::EngineGraphError::Joints { cylinder: None, needed });
        }
        for (index, cylinder) in self.engine.cylinders.iter().enumerate() {
            let fault = |needed| Err(super::EngineGraphError::Joints { cylinder: Some(index + 1), needed });
            if cylinder.piston_mass <= 0.0 {
                return fault("a piston with a mass");
            }
            if cylinder.rod.mass() <= 0.0 || self.numbers.cylinders[index].rod_inertia <= 0.0 {
                return fault("a rod with mass and inertia");
            }
        }
        Ok(())
    }
}
