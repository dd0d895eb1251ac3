//! What a run is asked: start, drive, load, starter, governor, driveline, events. All in SI units and radians.

use crate::reactions::Guidance;
pub use lanchester_model::{
    Action, DrivelineInertia, Event, Governor, ImposedAgainst, LoadLaw, ReactsOn, RunLoad as Load, Starter,
    StateTolerances, TorqueOrder, When,
};
use serde::Serialize;

/// Standard acceleration of gravity [m/s^2].
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// A run, with defaults for all but its speed: [`Simulation::free`], [`Simulation::imposed`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Simulation {
    /// What sets the speed.
    pub drive: Drive,
    /// Speed at the start [rad/s]; of an imposed speed the profile counts.
    pub start_speed: f64,
    /// Crank angle at the start [rad].
    pub start_angle: f64,
    /// Where the block starts.
    pub block_start: BlockStart,
    /// How long it lasts.
    pub duration: Duration,
    /// Whether the block moves.
    pub block: BlockMotion,
    /// Acceleration of gravity [m/s^2]; 0: off.
    pub gravity: f64,
    /// Crank angle between two samples [rad]; with a profile of imposed speed the angle at the fastest speed between two of its points, and less elsewhere.
    pub step: f64,
    /// Places from one sample to the next at which the largest and smallest values of the run are looked for, the next sample among them.
    pub looks: usize,
    /// Relative tolerance of every step.
    pub tolerance: f64,
    /// Absolute tolerances by kind of state that differ from those that follow from `tolerance`.
    pub tolerances: StateTolerances,
    /// Which pin guides the rods.
    pub guidance: Guidance,
    /// Stiffness of the main bearings for the rule `springs`, by crankshaft and main [N/m]; empty: all alike.
    pub main_stiffness: Vec<Vec<f64>>,
    /// Whether all reactions are computed at every sample.
    pub reactions: bool,
    /// Torque on crankshaft 1 from the ground over its angle.
    pub torque: Vec<TorqueOrder>,
    /// What takes the power.
    pub load: Load,
    /// What starts the engine.
    pub starter: Option<Starter>,
    /// What holds its speed.
    pub governor: Option<Governor>,
    /// Dry friction of the crank train as a torque against the rotation of crankshaft 1 [N m].
    pub friction_torque: f64,
    /// What is added to that in proportion to the speed of crankshaft 1 [N m s/rad] and to its square [N m s^2/rad^2].
    pub friction_growth: [f64; 2],
    /// Viscous friction of every piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// Inertias behind the flywheel, in order; at most 8.
    pub driveline: Vec<DrivelineInertia>,
    /// What happens on the way; at most 64.
    pub events: Vec<Event>,
    /// Largest number of evaluations of the equations of motion.
    pub most_evaluations: u64,
    /// Largest number of samples.
    pub most_samples: u64,
}

impl Simulation {
    /// Free speed from `speed` [rad/s] for some revolutions, block fixed, no gravity, no load, samples every degree, tolerance 1e-9.
    pub fn free(speed: f64, revolutions: f64) -> Simulation {
        Simulation {
            drive: Drive::Free,
            start_speed: speed,
            start_angle: 0.0,
            block_start: BlockStart::Equilibrium,
            duration: Duration::Revolutions(revolutions),
            block: BlockMotion::Fixed,
            gravity: 0.0,
            step: std::f64::consts::PI / 180.0,
            looks: 1,
            tolerance: 1e-9,
            tolerances: StateTolerances::default(),
            guidance: Guidance::Crankpin,
            main_stiffness: Vec::new(),
            reactions: false,
            torque: Vec::new(),
            load: Load { law: LoadLaw::None, reacts_on: ReactsOn::Ground },
            starter: None,
            governor: None,
            friction_torque: 0.0,
            friction_growth: [0.0; 2],
            piston_damping: 0.0,
            driveline: Vec::new(),
            events: Vec::new(),
            most_evaluations: 10_000_000,
            most_samples: 1_000_000,
        }
    }

    /// A constant speed [rad/s] relative to the block, otherwise as [`Simulation::free`].
    pub fn imposed(speed: f64, revolutions: f64) -> Simulation {
        let drive = Drive::Imposed { profile: vec![[0.0, speed]], against: ImposedAgainst::Block };
        Simulation { drive, ..Simulation::free(speed, revolutions) }
    }
}

impl Simulation {
    /// Friction of the crank train at a speed of crankshaft 1 [rad/s], as a torque against the rotation [N m].
    pub fn friction(&self, speed: f64) -> f64 {
        let (size, [linear, square]) = (speed.abs(), self.friction_growth);
        self.friction_torque + size * (linear + size * square)
    }

    /// Tolerances by kind of state, where speeds are measured against `speed` [rad/s] and energies against `energy` [J].
    pub fn tolerances_at(&self, speed: f64, energy: f64) -> Tolerances {
        let (all, own) = (self.tolerance, &self.tolerances);
        Tolerances {
            relative: all,
            angle: own.angle.unwrap_or(all),
            speed: own.speed.unwrap_or(all * speed),
            // Micrometres and microradians, and their rates, are what a block moves by.
            displacement: own.displacement.unwrap_or(1e-3 * all),
            turn: own.turn.unwrap_or(2e-3 * all),
            velocity: own.velocity.unwrap_or(0.1 * all),
            spin: own.spin.unwrap_or(0.1 * all),
            energy: own.energy.unwrap_or(all * energy),
        }
    }
}

/// Tolerances of a run's steps. The error of each component is measured against its absolute tolerance and `relative` times its size; the root
/// mean square of all stays below a half of 1 over the root of their number, so that no component has more error than its tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Tolerances {
    /// Relative, of every component.
    pub relative: f64,
    /// Of the angles of crank and driveline [rad].
    pub angle: f64,
    /// Of their speeds [rad/s].
    pub speed: f64,
    /// Of the place of the block and of the dashpots of its mounts [m].
    pub displacement: f64,
    /// Of the turn of the block [rad].
    pub turn: f64,
    /// Of its velocity [m/s].
    pub velocity: f64,
    /// Of its angular velocity [rad/s].
    pub spin: f64,
    /// Of works [J].
    pub energy: f64,
}

/// What sets the speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Drive {
    /// The torques.
    Free,
    /// A drive from the ground that takes whatever torque it needs.
    Imposed {
        /// Time [s] and speed [rad/s], rising in time, straight between; constant before and behind.
        profile: Vec<[f64; 2]>,
        /// Whose speed it is.
        against: ImposedAgainst,
    },
}

/// Where the block starts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum BlockStart {
    /// At rest under weight and the mean torque of the load, pistons where they are at the start.
    Equilibrium,
    /// At rest in the position of the file.
    AsDrawn,
    /// In the position of the file with velocity [m/s] and angular velocity [rad/s], block axes.
    Moving {
        /// Velocity of the origin.
        velocity: [f64; 3],
        /// Angular velocity.
        spin: [f64; 3],
    },
}

/// How long a run lasts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum Duration {
    /// Revolutions of crankshaft 1.
    Revolutions(f64),
    /// Seconds.
    Time(f64),
}

/// Whether the block moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum BlockMotion {
    /// It stands still.
    Fixed,
    /// It stands on the mounts of the file.
    Mounts,
    /// It floats: no mount acts.
    Floating,
}

/// Torque of a load against the rotation at `speed` [rad/s] and `angle` [rad] of the shaft that it sits on [N m], with the sign of the speed;
/// what depends on the angle acts against positive rotation at any speed.
pub fn load_torque(law: &LoadLaw, speed: f64, angle: f64) -> f64 {
    let size = speed.abs();
    let amount = match law {
        LoadLaw::None => 0.0,
        LoadLaw::Constant(torque) => *torque,
        LoadLaw::Viscous { torque, at } => torque * (size / at),
        LoadLaw::Quadratic { torque, at } => torque * (size / at).powi(2),
        LoadLaw::Power { power, least_speed } => power / size.max(*least_speed),
        LoadLaw::Table(points) => straight(points, size),
        LoadLaw::Angle { .. } | LoadLaw::Map { .. } => return law.at_angle(angle, speed).unwrap_or(0.0),
    };
    amount * if speed < 0.0 { -1.0 } else { 1.0 }
}

/// Torque by which a load holds its shaft at standstill, as dry friction does [N m].
pub(crate) fn holding_torque(law: &LoadLaw) -> f64 {
    match law {
        law if law.is_over_angle() => 0.0,
        law => load_torque(law, f64::MIN_POSITIVE, 0.0),
    }
}

/// Speed above which the crank angle is the independent variable, and the one above which it becomes it again [rad/s].
pub(crate) const FAST: [f64; 2] = [5.0, 6.0];

/// Value at `x` on straight lines through points that rise; constant beyond them, 0 without points.
pub(crate) fn straight(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] <= x);
    match (after.checked_sub(1).and_then(|k| points.get(k)), points.get(after)) {
        (Some([x0, y0]), Some([x1, y1])) => y0 + (x - x0) / (x1 - x0) * (y1 - y0),
        (Some([_, y]), None) | (None, Some([_, y])) => *y,
        (None, None) => 0.0,
    }
}
