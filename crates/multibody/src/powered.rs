//! The whole right-hand side of a run: from time and state to rates and powers.
//!
//! Unknown accelerations are those of block, crank and driveline; works of everything that gives or takes energy are integrated beside the states.

mod governor;
mod history;
mod works;

use crate::dynamics::{CrankInertia, Equations};
use crate::gas_pressure::GasPressure;
use crate::loads::Loads;
use crate::maxwell::MOST_BRANCHES;
use crate::motion::Motion;
use crate::place::Place;
use crate::simulation::{
    BlockMotion, Drive, ImposedAgainst, LoadLaw, ReactsOn, Simulation, holding_torque, load_torque, straight,
};
use crate::symmetric::{self, MOST, Matrix};
use crate::train::Train;
pub(crate) use governor::governor_now;
pub(crate) use history::History;
use nalgebra::{Matrix3, Vector3};
use std::cell::RefCell;
use std::rc::Rc;
pub(crate) use works::*;

/// Places of the parts of a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Layout {
    pub links: usize,
    pub moving: bool,
    pub governed: bool,
    /// Whether the actuator of the governor lags.
    pub lagged: bool,
    /// Branches of all mounts.
    pub branches: usize,
    /// Works that can be other than 0: these alone are integrated.
    pub counted: [bool; WORKS],
}

impl Layout {
    pub fn link(self, index: usize) -> usize {
        2 + 2 * index
    }

    pub fn pose(self) -> usize {
        2 + 2 * self.links
    }

    pub fn governor(self) -> usize {
        self.pose() + if self.moving { 13 } else { 0 }
    }

    pub fn relaxing(self) -> usize {
        self.governor() + usize::from(self.governed) + usize::from(self.lagged)
    }

    pub fn works(self) -> usize {
        self.relaxing() + self.branches
    }

    pub fn dimension(self) -> usize {
        self.works() + self.counted.iter().filter(|counted| **counted).count()
    }

    /// What a component of a state is, in words.
    pub fn name(self, component: usize) -> &'static str {
        match component {
            0 => "crank angle",
            1 => "speed of the crank",
            _ if component < self.pose() => "motion of the driveline",
            _ if component < self.governor() => "motion of the block",
            _ if component < self.relaxing() => "governor",
            _ if component < self.works() => "force of a mount",
            _ => "energy of gas, load, friction or dampers",
        }
    }

    /// The works of a state, by their names.
    pub fn all_works(self, state: &[f64]) -> [f64; WORKS] {
        let mut own = state[self.works()..].iter();
        self.counted.map(|counted| if counted { own.next().copied().unwrap_or(0.0) } else { 0.0 })
    }

    /// Row of the crank among the accelerations.
    pub fn crank(self) -> usize {
        if self.moving { 6 } else { 0 }
    }

    /// Number of accelerations.
    pub fn freedoms(self) -> usize {
        1 + self.links + if self.moving { 6 } else { 0 }
    }
}

/// What holds between two events.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Conditions {
    /// Share of the fired part of the gas, by cylinder.
    pub fired: Vec<f64>,
    /// Cylinders that fire no more, whatever the fuel.
    pub misfires: Vec<bool>,
    pub load: LoadLaw,
    /// Torque from outside on the shaft of the load besides, against positive rotation whatever the speed [N m].
    pub demand: f64,
    /// Factor from outside on the fired part of the gas, from 0 to 1.
    pub fuel: f64,
    pub starter: bool,
    pub clutch_open: bool,
    /// What the spring of the clutch has lost as it opened [J], negative.
    pub clutch_work: f64,
    /// Sense in which the crank turns or is about to: dry friction acts against it.
    pub sense: f64,
    /// Dry friction holds the crank.
    pub held: bool,
    /// Crank angles between which no pressure has a kink.
    pub window: [f64; 2],
    /// Times between which the profile of an imposed speed has no knot.
    pub times: [f64; 2],
    /// Times between which the command of a governor with a dead time does not jump, one dead time before now.
    pub delayed: [f64; 2],
}

/// A mount at one instant, axes of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MountNow {
    /// On the block [N].
    pub force: Vector3<f64>,
    /// From the block's origin to its point on the block [m].
    pub arm: Vector3<f64>,
    /// Of that point [m].
    pub displacement: Vector3<f64>,
    /// Power that its dampers take [W].
    pub lost: f64,
}

/// Torques and accelerations at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Torques {
    pub gas: f64,
    pub load: f64,
    pub starter: f64,
    pub friction: f64,
    pub piston_friction: f64,
    pub outside: f64,
    pub driveline: f64,
    pub rates: [f64; 7],
}

/// The engine with all that acts on it.
pub(crate) struct Powered<'a> {
    pub train: &'a Train,
    pub gas: Option<&'a dyn GasPressure>,
    pub simulation: &'a Simulation,
    pub layout: Layout,
    pub conditions: Conditions,
    pub places: Vec<Place>,
    /// Gas force on every piston towards the crank [N].
    pub forces: Vec<f64>,
    pub torques: Torques,
    /// Of the last evaluation where the block moves.
    pub equations: Option<Equations>,
    /// Torque that keeps the crank from turning where it is held, or at its imposed speed [N m].
    pub holding: f64,
    /// Commands of a governor with a dead time.
    pub history: Option<Rc<RefCell<History>>>,
}

/// What block and crank have without a driveline.
enum Own {
    /// Forces on the seven speeds; their equations are at hand.
    Block([f64; 7]),
    /// Inertia and torque of the crank in a block at rest.
    Crank { inertia: f64, torque: f64 },
}

/// What drives crank and driveline besides.
struct Driven {
    /// Acceleration of the crank where it is given, and whether it is absolute.
    given: Option<(f64, bool)>,
    /// Whether that drive stands on the ground.
    from_ground: bool,
    /// Torque of the load.
    load: f64,
    /// Whether the load stands on the ground.
    load_ground: bool,
}

/// Angle from a kink of the pressure within which the pressure is that inside [rad].
const BESIDE: f64 = 1e-12;

impl<'a> Powered<'a> {
    /// Motion of block and crank of a state whose angle is `theta`.
    pub fn motion(&self, theta: f64, state: &[f64]) -> Motion {
        let mut motion = Motion::fixed(theta, state[1]);
        if self.layout.moving {
            let own = &state[self.layout.pose()..self.layout.pose() + 13];
            motion.position = Vector3::new(own[0], own[1], own[2]);
            motion.orientation = [own[3], own[4], own[5], own[6]];
            motion.velocity = Vector3::new(own[7], own[8], own[9]);
            motion.spin = Vector3::new(own[10], own[11], own[12]);
        }
        motion
    }

    /// Acceleration of gravity in the axes of the frame [m/s^2].
    pub fn gravity(&self) -> Vector3<f64> {
        self.simulation.gravity * Vector3::from(self.train.gravity)
    }

    /// Whether mounts act.
    pub fn on_mounts(&self) -> bool {
        self.layout.moving && self.simulation.block == BlockMotion::Mounts
    }

    /// What every mount does without its branches.
    pub fn mounts(&self, motion: &Motion) -> impl Iterator<Item = MountNow> + '_ {
        self.mounts_turned(motion, motion.rotation())
    }

    /// The same with the turn of the block.
    #[inline]
    fn mounts_turned(&self, motion: &Motion, rotation: Matrix3<f64>) -> impl Iterator<Item = MountNow> + '_ {
        let position = motion.position;
        let (velocity, spin) = (rotation * motion.velocity, rotation * motion.spin);
        let mounts = if self.on_mounts() { &self.train.mounts[..] } else { &[] };
        mounts.iter().map(move |mount| {
            let arm = rotation * mount.at;
            let displacement = position + (arm - mount.at);
            let rate = velocity + spin.cross(&arm);
            let damping = mount.damping * rate;
            let force = mount.preload - mount.stiffness * displacement - damping;
            MountNow { force, arm, displacement, lost: damping.dot(&rate) }
        })
    }

    /// What the branches of every mount do in a state: force on the block [N], energy stored [J] and power lost [W]; rates of their dashpots into `rates`.
    pub fn branches(
        &self,
        motion: &Motion,
        state: &[f64],
        mut rates: impl FnMut(usize, f64),
    ) -> Vec<(Vector3<f64>, f64, f64)> {
        let mut at = self.layout.relaxing();
        let mut own = [0.0; 3 * MOST_BRANCHES];
        let each = self.train.mounts.iter().zip(self.mounts(motion)).map(|(mount, now)| {
            let count = mount.branches();
            let done = mount.relax(now.displacement, &state[at..at + count], &mut own);
            (0..count).for_each(|k| rates(at + k, own[k]));
            at += count;
            done
        });
        each.collect()
    }

    /// Force of the block on every mount [N], axes of the frame.
    pub fn mount_forces(&self, motion: &Motion, state: &[f64]) -> Vec<[f64; 3]> {
        let mut forces: Vec<Vector3<f64>> = self.mounts(motion).map(|now| -now.force).collect();
        if self.layout.branches > 0 {
            let branches = self.branches(motion, state, |_, _| ());
            forces.iter_mut().zip(branches).for_each(|(force, (on_block, ..))| *force -= on_block);
        }
        forces.into_iter().map(Into::into).collect()
    }

    /// Largest torque by which friction and load can hold the crank at standstill [N m].
    pub fn dry_torque(&self) -> f64 {
        let load = if self.layout.links == 0 { holding_torque(&self.conditions.load) } else { 0.0 };
        self.simulation.friction_torque + load
    }

    /// Gas forces at `theta` into `forces`.
    fn set_gas(&mut self, theta: f64, speed: f64, throttle: f64) {
        self.forces.resize(self.train.cylinders.len(), 0.0);
        let Some(gas) = self.gas else { return };
        let [low, high] = self.conditions.window;
        let theta = if high > low { theta.clamp(low + BESIDE, high - BESIDE) } else { theta };
        let speed = speed.abs();
        for (index, cylinder) in self.train.cylinders.iter().enumerate() {
            let own = self.train.own_angle(index, theta);
            let fired = self.conditions.fired[index] * throttle;
            let mut pressure = gas.pressure(index, own, speed);
            if fired != 1.0 {
                let motored = gas.motored(index, own, speed);
                pressure = motored + fired * (pressure - motored);
            }
            self.forces[index] = pressure * cylinder.area.unwrap_or(0.0);
        }
    }

    /// Imposed speed and its rate at time `t`, where it is imposed.
    pub fn imposed(&self, t: f64) -> Option<([f64; 2], ImposedAgainst)> {
        let Drive::Imposed { profile, against } = &self.simulation.drive else { return None };
        let [low, high] = self.conditions.times;
        let margin = (1e-9 * (high - low)).min(1e-9);
        let inside = if margin > 0.0 { t.clamp(low + margin, high - margin) } else { t };
        let after = profile.partition_point(|point| point[0] <= inside);
        let rate = match (after.checked_sub(1).and_then(|k| profile.get(k)), profile.get(after)) {
            (Some([t0, w0]), Some([t1, w1])) => (w1 - w0) / (t1 - t0),
            _ => 0.0,
        };
        Some(([straight(profile, t), rate], *against))
    }

    /// Rates by time of a state at crank angle `theta` and time `t`; component 0 is the angle's. Rates are no numbers where the equations have no solution.
    pub fn rates(&mut self, t: f64, theta: f64, state: &[f64], rates: &mut [f64]) {
        let layout = self.layout;
        let simulation = self.simulation;
        let speed = state[1];
        let mut places = std::mem::take(&mut self.places);
        self.train.places_into(theta, &mut places);
        let governor = self.governor_now(t, state);
        let throttle = governor.map_or(1.0, |governor| governor.factor) * self.conditions.fuel;
        self.set_gas(theta, speed, throttle);
        let motion = self.motion(theta, state);
        let spin_z = motion.spin.z;

        // Torques: those that the ground gives to crankshaft 1 or to the end of the driveline, and those that the block gives.
        let [gas, rubbing] =
            self.train.piston_torque(&places, speed, &self.forces, simulation.piston_damping);
        let over_angle = simulation.torque.iter().map(|order| {
            let (sin, cos) = (order.order * theta).sin_cos();
            order.sin * sin + order.cos * cos
        });
        let over_angle: f64 = over_angle.sum();
        let starter = match (&simulation.starter, self.conditions.starter) {
            (Some(starter), true) => {
                let free = 1.0 - starter.ratio * speed / starter.free_speed;
                starter.ratio * starter.stall_torque * free.max(0.0)
            }
            _ => 0.0,
        };
        let starter_ground =
            matches!(&simulation.starter, Some(starter) if starter.reacts_on == ReactsOn::Ground);
        let load_ground = simulation.load.reacts_on == ReactsOn::Ground;
        let ends = layout.links.checked_sub(1).map(|last| state[layout.link(last) + 1]);
        let end_speed = ends.unwrap_or(speed) + if load_ground { spin_z } else { 0.0 };
        // At standstill dry loads act against the motion to come.
        let turning = if ends.is_none() && end_speed * self.conditions.sense <= 0.0 {
            f64::MIN_POSITIVE * self.conditions.sense
        } else {
            end_speed
        };
        // Held by dry friction the crank feels neither it nor a load of its own: what they must give is found below.
        let held = self.conditions.held;
        let angle = layout.links.checked_sub(1).map_or(theta, |last| state[layout.link(last)]);
        let over_angle_alone = self.conditions.load.is_over_angle();
        let of_law = if held && ends.is_none() && !over_angle_alone {
            0.0
        } else {
            load_torque(&self.conditions.load, turning, angle)
        };
        let load = -of_law - self.conditions.demand;
        let friction = if held { 0.0 } else { -simulation.friction(speed) * self.conditions.sense };
        let mut outer = over_angle + if starter_ground { starter } else { 0.0 };
        let mut inner = friction + if starter_ground { 0.0 } else { starter };
        if layout.links == 0 {
            *(if load_ground { &mut outer } else { &mut inner }) += load;
        }

        let mut damped = 0.0;
        let rotation = if layout.moving { motion.rotation() } else { Matrix3::identity() };
        let own = if layout.moving {
            let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
            if self.on_mounts() {
                for mount in self.mounts_turned(&motion, rotation) {
                    force += mount.force;
                    moment += mount.arm.cross(&mount.force);
                    damped -= mount.lost;
                }
                if layout.branches > 0 {
                    let branches = self.branches(&motion, state, |at, rate| rates[at] = rate);
                    for (mount, (on_block, _, lost)) in self.train.mounts.iter().zip(branches) {
                        force += on_block;
                        moment += (rotation * mount.at).cross(&on_block);
                        damped -= lost;
                    }
                }
            }
            self.equations = Some(self.train.equations(&motion, &places));
            let loads = Loads {
                gas: &self.forces,
                gravity: rotation.tr_mul(&self.gravity()),
                piston_damping: simulation.piston_damping,
                force: rotation.tr_mul(&force),
                moment: rotation.tr_mul(&moment),
                outer_torque: outer,
                inner_torque: inner,
            };
            let equations = self.equations.as_ref();
            Own::Block(equations.map_or([f64::NAN; 7], |equations| {
                self.train.generalised_forces(equations, &places, speed, &loads)
            }))
        } else {
            let CrankInertia { inertia, bias } = self.train.crank_inertia(&places);
            let weight = if simulation.gravity == 0.0 { 0.0 } else { self.weight_torque(theta, &places) };
            Own::Crank { inertia, torque: gas + rubbing + outer + inner - bias * speed * speed + weight }
        };
        let imposed = self.imposed(t);
        let mut outside = over_angle;
        let given = match (imposed, self.conditions.held) {
            (Some(([_, rate], against)), _) => Some((rate, against == ImposedAgainst::Ground)),
            (None, true) => Some((0.0, false)),
            (None, false) => None,
        };
        let driven = Driven { given, from_ground: imposed.is_some(), load, load_ground };
        let mut rhs = [0.0; MOST];
        let solved = match (layout.links, layout.moving) {
            (0, false) => self.solve::<1>(&own, state, &motion, &driven, &mut rhs),
            (0, true) => self.solve::<7>(&own, state, &motion, &driven, &mut rhs),
            _ => self.solve::<MOST>(&own, state, &motion, &driven, &mut rhs),
        };
        let (drive, [spring_torque, driveline_damped]) = solved.unwrap_or_default();
        if solved.is_none() {
            rates.fill(f64::NAN);
            self.places = places;
            return;
        }
        if imposed.is_some() {
            outside += drive;
        }
        self.holding = drive;

        // The dashpots of the mounts have theirs already.
        rates[..layout.relaxing()].fill(0.0);
        let crank = layout.crank();
        rates[0] = speed;
        rates[1] = rhs[crank];
        for link in 0..layout.links {
            rates[layout.link(link)] = state[layout.link(link) + 1];
            rates[layout.link(link) + 1] = rhs[crank + 1 + link];
        }
        let mut seven = [0.0; 7];
        seven[6] = rhs[crank];
        if layout.moving {
            seven[..6].copy_from_slice(&rhs[..6]);
            let at = layout.pose();
            let velocity = rotation * motion.velocity;
            rates[at..at + 3].copy_from_slice(velocity.as_slice());
            rates[at + 3..at + 7].copy_from_slice(&motion.orientation_rate());
            rates[at + 7..at + 13].copy_from_slice(&rhs[..6]);
        }
        if let Some(governor) = governor {
            let at = layout.governor();
            rates[at] = governor.sum_rate;
            if layout.lagged {
                rates[at + 1] = governor.rate;
            }
        }
        let absolute = speed + spin_z;
        let mut works = [0.0; WORKS];
        works[GAS] = gas * speed;
        works[LOAD] = load * end_speed;
        works[STARTER] = starter * if starter_ground { absolute } else { speed };
        works[FRICTION] = friction * speed;
        works[PISTON_FRICTION] = rubbing * speed;
        works[OUTSIDE] = outside * absolute;
        works[MOUNT_DAMPING] = damped;
        works[DRIVELINE_DAMPING] = driveline_damped;
        let counted =
            works.into_iter().zip(layout.counted).filter_map(|(work, counted)| counted.then_some(work));
        rates[layout.works()..].iter_mut().zip(counted).for_each(|(rate, work)| *rate = work);
        self.torques = Torques {
            gas,
            load,
            starter,
            friction,
            piston_friction: rubbing,
            outside,
            driveline: spring_torque,
            rates: seven,
        };
        self.places = places;
    }

    /// Accelerations of block, crank and driveline into `rates`; torque of the drive, torque of the first spring of the driveline on the crank and power of its
    /// dampers. `N`: the freedoms, or at least as many.
    fn solve<const N: usize>(
        &self,
        own: &Own,
        state: &[f64],
        motion: &Motion,
        driven: &Driven,
        rates: &mut [f64; MOST],
    ) -> Option<(f64, [f64; 2])> {
        let layout = self.layout;
        if let (Own::Block(forces), 0, None) = (own, layout.links, driven.given) {
            rates[..7].copy_from_slice(&self.equations.as_ref()?.accelerations(forces)?);
            return Some((0.0, [0.0; 2]));
        }
        let size = if N == MOST { layout.freedoms() } else { N };
        let mut matrix: Matrix<N> = [[0.0; N]; N];
        let mut rhs = [0.0; N];
        match own {
            Own::Block(forces) => {
                let equations = self.equations.as_ref()?;
                for i in 0..7 {
                    matrix[i][..7].copy_from_slice(&equations.mass[i]);
                    rhs[i] = forces[i] - equations.bias[i];
                }
            }
            Own::Crank { inertia, torque } => (matrix[0][0], rhs[0]) = (*inertia, *torque),
        }
        let driveline = if layout.links > 0 {
            self.add_driveline(&mut matrix, &mut rhs, state, motion, driven)
        } else {
            [0.0; 2]
        };
        let drive = match driven.given {
            None => symmetric::solve(&mut matrix, &mut rhs, size).map(|()| 0.0),
            Some((rate, absolute)) => symmetric::solve_given(
                &mut matrix,
                &mut rhs,
                size,
                layout.crank(),
                rate,
                driven.from_ground,
                absolute,
            ),
        }?;
        rates[..N].copy_from_slice(&rhs);
        Some((drive, driveline))
    }

    /// Torque of the weight on crankshaft 1 with the block fixed [N m].
    fn weight_torque(&self, theta: f64, places: &[Place]) -> f64 {
        let g = num_complex::Complex64::new(self.gravity().x, self.gravity().y);
        let pistons = places.iter().zip(&self.train.cylinders).map(|(place, cylinder)| {
            let rod = place.on_rod(cylinder.rod.centre)[1];
            let moment = cylinder.piston_mass * place.travel[1] * cylinder.axis + cylinder.rod.mass * rod;
            crate::place::dot(g, moment)
        });
        let rotors = self.train.rotors.iter().map(|rotor| {
            let turn =
                num_complex::Complex64::cis(rotor.ratio * theta) * num_complex::Complex64::I * rotor.ratio;
            crate::place::dot(g, rotor.first_moment * turn)
        });
        pistons.sum::<f64>() + rotors.sum::<f64>()
    }

    /// Twist of every spring of the driveline [rad] and its torque with its damper on the inertia behind it [N m]; 0 of an open clutch.
    pub fn springs(&self, motion: &Motion, state: &[f64]) -> Vec<[f64; 2]> {
        let mut before = [motion.theta, motion.speed];
        let links = self.simulation.driveline.iter().enumerate().map(|(index, link)| {
            let own = [state[self.layout.link(index)], state[self.layout.link(index) + 1]];
            let twist = [0, 1].map(|k| link.ratio * before[k] - own[k]);
            before = own;
            let is_open = index == 0 && self.conditions.clutch_open;
            if is_open { [0.0; 2] } else { [twist[0], link.stiffness * twist[0] + link.damping * twist[1]] }
        });
        links.collect()
    }

    /// Adds the driveline; returns the torque of its first spring on the crank and the power of its dampers.
    fn add_driveline<const N: usize>(
        &self,
        matrix: &mut Matrix<N>,
        rhs: &mut [f64; N],
        state: &[f64],
        motion: &Motion,
        driven: &Driven,
    ) -> [f64; 2] {
        let layout = self.layout;
        let crank = layout.crank();
        let (mut before, mut before_row) = ([motion.theta, motion.speed], crank);
        let mut result = [0.0; 2];
        for (index, link) in self.simulation.driveline.iter().enumerate() {
            let row = crank + 1 + index;
            let own = [state[layout.link(index)], state[layout.link(index) + 1]];
            matrix[row][row] += link.inertia;
            if layout.moving {
                matrix[5][5] += link.inertia;
                matrix[5][row] += link.inertia;
                matrix[row][5] += link.inertia;
                let gyroscopic = link.inertia * (motion.spin.z + own[1]) * motion.spin.cross(&Vector3::z());
                for k in 0..3 {
                    rhs[3 + k] -= gyroscopic[k];
                }
            }
            if index > 0 || !self.conditions.clutch_open {
                let twist = [0, 1].map(|k| link.ratio * before[k] - own[k]);
                let torque = link.stiffness * twist[0] + link.damping * twist[1];
                rhs[row] += torque;
                rhs[before_row] -= link.ratio * torque;
                result[1] -= link.damping * twist[1] * twist[1];
                if index == 0 {
                    result[0] = -link.ratio * torque;
                }
            }
            if index + 1 == layout.links {
                rhs[row] += driven.load;
                if layout.moving && driven.load_ground {
                    rhs[5] += driven.load;
                }
            }
            (before, before_row) = (own, row);
        }
        result
    }

    /// Energy stored [J]: kinetic, of mounts, of gravity, of the driveline's springs.
    pub fn energy(&mut self, theta: f64, state: &[f64]) -> [f64; 4] {
        let mut places = std::mem::take(&mut self.places);
        self.train.places_into(theta, &mut places);
        if self.layout.moving {
            self.equations = Some(self.train.equations(&self.motion(theta, state), &places));
        }
        self.places = places;
        self.energy_here(theta, state)
    }

    /// The same at the state of the last evaluation.
    pub fn energy_here(&self, theta: f64, state: &[f64]) -> [f64; 4] {
        let layout = self.layout;
        let motion = self.motion(theta, state);
        let gravity = self.gravity();
        let rotation = if layout.moving { motion.rotation() } else { Matrix3::identity() };
        let (mut kinetic, lift) = match &self.equations {
            Some(equations) if layout.moving => {
                let first = Vector3::new(equations.mass[1][5], equations.mass[2][3], equations.mass[0][4]);
                let centre = equations.mass[0][0] * motion.position + rotation * first;
                (equations.kinetic_energy(&motion.speeds()), -gravity.dot(&centre))
            }
            _ => {
                let inertia = self.train.crank_inertia(&self.places).inertia;
                let weighs = self.simulation.gravity != 0.0;
                let lift =
                    if weighs { -gravity.dot(&self.train.first_moment(theta, &self.places)) } else { 0.0 };
                (0.5 * inertia * motion.speed * motion.speed, lift)
            }
        };
        let mut sprung = 0.0;
        if self.on_mounts() {
            for (mount, now) in self.train.mounts.iter().zip(self.mounts_turned(&motion, rotation)) {
                sprung += mount.energy(now.displacement);
            }
            if layout.branches > 0 {
                sprung +=
                    self.branches(&motion, state, |_, _| ()).iter().map(|(_, stored, _)| stored).sum::<f64>();
            }
        }
        let mut twisted = 0.0;
        let mut before = theta;
        for (index, link) in self.simulation.driveline.iter().enumerate() {
            let own = [state[layout.link(index)], state[layout.link(index) + 1]];
            kinetic += 0.5 * link.inertia * (motion.spin.z + own[1]).powi(2);
            if index > 0 || !self.conditions.clutch_open {
                twisted += 0.5 * link.stiffness * (link.ratio * before - own[0]).powi(2);
            }
            before = own[0];
        }
        [kinetic, sprung, lift, twisted]
    }
}
