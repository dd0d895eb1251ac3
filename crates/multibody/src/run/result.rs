//! What a run returns: plain data.

use crate::reactions::Reactions;
use crate::run::extremes::RunExtremes;
use crate::simulation::Tolerances;
use lanchester_numerics::{Outcome, Statistics};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const RUN_VERSION: u32 = 1;

/// A run with its samples.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Run {
    /// [`RUN_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// How it ended.
    pub outcome: RunOutcome,
    /// Time [s], crank angle [rad] and speed [rad/s] at its end.
    pub end: [f64; 3],
    /// Samples.
    pub samples: Samples,
    /// What happened on the way.
    pub events: Vec<Happened>,
    /// Works and energies.
    pub energy: EnergyLedger,
    /// The same over its last period, where the crank turns forward through a whole one and samples mark both its ends.
    pub last_period: Option<EnergyLedger>,
    /// Largest and smallest values over the whole run.
    pub extremes: RunExtremes,
    /// The same over its last period, where the crank turns forward through a whole one.
    pub last_period_extremes: Option<RunExtremes>,
    /// Where a starter that never let go could not turn the crank on.
    pub stall: Option<Stall>,
    /// What must be zero.
    pub audit: Audit,
    /// What it cost.
    pub cost: Cost,
    /// Tolerances of its steps by kind of state.
    pub tolerances: Tolerances,
}

impl Run {
    /// The run with every `every`-th of its samples, and the last.
    pub fn every(&self, every: usize) -> Run {
        Run {
            engine: self.engine.clone(),
            samples: self.samples.every(every),
            events: self.events.clone(),
            extremes: self.extremes.clone(),
            last_period_extremes: self.last_period_extremes.clone(),
            ..*self
        }
    }
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum RunOutcome {
    /// After its duration.
    Complete,
    /// An event stopped it.
    Stopped,
    /// The crank came to rest and friction holds it.
    AtRest {
        /// Crank angle [rad].
        theta: f64,
        /// Torque that gas, weight and starter still give there [N m].
        torque: f64,
        /// Torque by which friction and load can hold it [N m].
        held_by: f64,
    },
    /// Whoever watched it ended it: the samples so far are there.
    Cancelled,
    /// As many evaluations as are allowed: the samples so far are there.
    TooManyEvaluations,
    /// A quantity became no number, or the error could not be met by any step: the samples so far are there.
    Failed {
        /// What the integrator says.
        reason: Outcome,
        /// Crank angle [rad] of the last good state.
        theta: f64,
        /// Which quantity of the state became no number, where one did.
        quantity: Option<&'static str>,
    },
}

/// Where a starter could not turn the crank on: the farthest place at which it came to a halt. All torques are those on crankshaft 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Stall {
    /// Time [s].
    pub time: f64,
    /// Crank angle [rad].
    pub theta: f64,
    /// Torque of the starter [N m].
    pub starter: f64,
    /// Torque of gas, weight and driveline there [N m]; negative where they hold the crank back.
    pub others: f64,
    /// Torque by which friction and load hold it [N m].
    pub held_by: f64,
    /// What is missing to turn on from there [N m].
    pub missing: f64,
    /// Turns of the starter for one of the crank.
    pub ratio: f64,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunState {
    /// Time [s].
    pub time: f64,
    /// Crank angle of crankshaft 1 [rad].
    pub theta: f64,
    /// Its rate [rad/s].
    pub speed: f64,
}

/// One vector a quantity, one value a sample.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Samples {
    /// Time [s].
    pub time: Vec<f64>,
    /// Crank angle of crankshaft 1 relative to the block [rad].
    pub theta: Vec<f64>,
    /// Its rate [rad/s].
    pub speed: Vec<f64>,
    /// The rate of that [rad/s^2].
    pub acceleration: Vec<f64>,
    /// Torque of the gas on crankshaft 1 [N m].
    pub gas_torque: Vec<f64>,
    /// Torque of the load on the shaft that it sits on [N m].
    pub load_torque: Vec<f64>,
    /// Torque of the starter on crankshaft 1 [N m].
    pub starter_torque: Vec<f64>,
    /// Torque of dry friction on crankshaft 1 [N m].
    pub friction_torque: Vec<f64>,
    /// Torque of the friction of the pistons on crankshaft 1 [N m].
    pub piston_friction_torque: Vec<f64>,
    /// Torque from the ground on crankshaft 1 besides: over the angle, and of an imposed speed's drive [N m].
    pub outside_torque: Vec<f64>,
    /// Torque of the driveline on crankshaft 1 [N m].
    pub driveline_torque: Vec<f64>,
    /// Factor of the governor on the fired part of the gas, from 0 to 1; empty without one.
    pub governor: Vec<f64>,
    /// Angle [rad] and speed [rad/s] of the inertias of the driveline.
    pub driveline: Vec<Vec<[f64; 2]>>,
    /// Twist [rad] of the springs before them, and their torque with their dampers on the inertia behind each [N m]; 0 of an open clutch.
    pub driveline_springs: Vec<Vec<[f64; 2]>>,
    /// Where the block's origin is [m], axes of the frame; empty with a fixed block, as all of the block.
    pub position: Vec<[f64; 3]>,
    /// Turn of the block: unit quaternion `(w, x, y, z)`.
    pub orientation: Vec<[f64; 4]>,
    /// Velocity of its origin [m/s], block axes.
    pub velocity: Vec<[f64; 3]>,
    /// Its angular velocity [rad/s], block axes.
    pub spin: Vec<[f64; 3]>,
    /// Force of the block on every mount [N], axes of the frame.
    pub mounts: Vec<Vec<[f64; 3]>>,
    /// All reactions, where they were asked for.
    pub reactions: Vec<Reactions>,
}

/// Every `every`-th of a series of samples, and the last.
pub fn thinned<T: Clone>(series: &[T], every: usize) -> Vec<T> {
    let last = series.len().saturating_sub(1);
    let kept = series.iter().enumerate().filter(|(k, _)| k % every == 0 || *k == last);
    kept.map(|(_, value)| value.clone()).collect()
}

impl Samples {
    /// Every `every`-th of them, and the last.
    pub fn every(&self, every: usize) -> Samples {
        let every = every.max(1);
        let numbers = |series: &[f64]| thinned(series, every);
        Samples {
            time: numbers(&self.time),
            theta: numbers(&self.theta),
            speed: numbers(&self.speed),
            acceleration: numbers(&self.acceleration),
            gas_torque: numbers(&self.gas_torque),
            load_torque: numbers(&self.load_torque),
            starter_torque: numbers(&self.starter_torque),
            friction_torque: numbers(&self.friction_torque),
            piston_friction_torque: numbers(&self.piston_friction_torque),
            outside_torque: numbers(&self.outside_torque),
            driveline_torque: numbers(&self.driveline_torque),
            governor: numbers(&self.governor),
            driveline: thinned(&self.driveline, every),
            driveline_springs: thinned(&self.driveline_springs, every),
            position: thinned(&self.position, every),
            orientation: thinned(&self.orientation, every),
            velocity: thinned(&self.velocity, every),
            spin: thinned(&self.spin, every),
            mounts: thinned(&self.mounts, every),
            reactions: thinned(&self.reactions, every),
        }
    }

    /// Makes room for so many more of those that every run has, and of the reactions where they were asked for before.
    pub(crate) fn reserve(&mut self, more: usize) {
        for series in [
            &mut self.time,
            &mut self.theta,
            &mut self.speed,
            &mut self.acceleration,
            &mut self.gas_torque,
            &mut self.load_torque,
            &mut self.starter_torque,
            &mut self.friction_torque,
            &mut self.piston_friction_torque,
            &mut self.outside_torque,
            &mut self.driveline_torque,
        ] {
            series.reserve(more);
        }
        // What the first sample has, all have.
        fn alike<T>(series: &mut Vec<T>, more: usize) {
            if !series.is_empty() {
                series.reserve(more);
            }
        }
        alike(&mut self.governor, more);
        alike(&mut self.driveline, more);
        alike(&mut self.driveline_springs, more);
        alike(&mut self.position, more);
        alike(&mut self.orientation, more);
        alike(&mut self.velocity, more);
        alike(&mut self.spin, more);
        alike(&mut self.mounts, more);
        alike(&mut self.reactions, more);
    }
}

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Happened {
    /// What.
    pub what: Occasion,
    /// When [s].
    pub time: f64,
    /// At which crank angle [rad].
    pub theta: f64,
    /// At which speed [rad/s].
    pub speed: f64,
}

/// What may happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Occasion {
    /// An event of the list: its place there, from 0.
    Event {
        /// Place in the list.
        index: usize,
    },
    /// The starter let go.
    StarterOff,
    /// The crank came to a halt and turns back, or on.
    Reversed,
    /// The crank came to a halt and friction holds it.
    Held,
    /// It broke away from where friction held it.
    Released,
}

/// Energies at both ends and works between [J].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct EnergyLedger {
    /// Kinetic energy at the start and at the end.
    pub kinetic: [f64; 2],
    /// Of the mounts' springs.
    pub mounts: [f64; 2],
    /// Of gravity.
    pub gravity: [f64; 2],
    /// Of the driveline's springs.
    pub driveline: [f64; 2],
    /// Work of the gas on the pistons.
    pub gas: f64,
    /// Work of the load (negative where it takes).
    pub load: f64,
    /// Work of the starter.
    pub starter: f64,
    /// Work of dry friction.
    pub friction: f64,
    /// Work of the friction of the pistons.
    pub piston_friction: f64,
    /// Work of other torques from the ground and of the drive of an imposed speed.
    pub outside: f64,
    /// Work of the mounts' dampers.
    pub mount_damping: f64,
    /// Work of the driveline's dampers.
    pub driveline_damping: f64,
    /// What the first spring of the driveline loses as the clutch opens (negative): nothing holds its twist any more, and it comes to rest by itself.
    pub clutch: f64,
    /// Sum of the amounts of all works and of the largest energies stored.
    pub throughput: f64,
}

/// What must be zero but for the errors of the steps.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Audit {
    /// Largest of energy stored less works, over all samples, over the throughput.
    pub energy: f64,
    /// Largest departure of any loop from its rod length [m].
    pub loops: f64,
    /// Largest departure of the quaternion's size from 1.
    pub quaternion: f64,
    /// Largest change of linear momentum in space over its largest part, where nothing outside acts.
    pub linear_momentum: Option<f64>,
    /// Largest change of angular momentum in space over its largest part, where nothing outside acts.
    pub angular_momentum: Option<f64>,
}

/// Cost of a run.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Cost {
    /// Of the integrator.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
}

impl Cost {
    pub(crate) fn add(&mut self, statistics: Statistics) {
        self.steps += statistics.steps;
        self.rejected += statistics.rejected;
        self.evaluations += statistics.evaluations;
    }
}
