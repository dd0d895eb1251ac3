//! What a run is asked: start, drive, load, starter, governor, driveline, events. All in SI units and radians.

use crate::reactions::Guidance;
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
    /// Crank angle between two samples [rad].
    pub step: f64,
    /// Relative tolerance of every step.
    pub tolerance: f64,
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
    /// Viscous friction of every piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// Inertias behind the flywheel, in order; at most 8.
    pub driveline: Vec<DrivelineInertia>,
    /// What happens on the way; at most 64.
    pub events: Vec<Event>,
    /// Largest number of evaluations of the equations of motion.
    pub most_evaluations: u64,
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
            tolerance: 1e-9,
            guidance: Guidance::Crankpin,
            main_stiffness: Vec::new(),
            reactions: false,
            torque: Vec::new(),
            load: Load { law: LoadLaw::None, reacts_on: ReactsOn::Ground },
            starter: None,
            governor: None,
            friction_torque: 0.0,
            piston_damping: 0.0,
            driveline: Vec::new(),
            events: Vec::new(),
            most_evaluations: 10_000_000,
        }
    }

    /// A constant speed [rad/s] relative to the block, otherwise as [`Simulation::free`].
    pub fn imposed(speed: f64, revolutions: f64) -> Simulation {
        let drive = Drive::Imposed { profile: vec![[0.0, speed]], against: ImposedAgainst::Block };
        Simulation { drive, ..Simulation::free(speed, revolutions) }
    }
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

/// Against what an imposed speed counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum ImposedAgainst {
    /// Relative to the block.
    Block,
    /// Absolute: it differs by the block's roll.
    Ground,
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

/// One order of a torque over the crank angle: `sin sin(order theta) + cos cos(order theta)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TorqueOrder {
    /// Its order.
    pub order: f64,
    /// Factor of the sine [N m].
    pub sin: f64,
    /// Factor of the cosine [N m].
    pub cos: f64,
}

/// Where the reaction to a torque goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum ReactsOn {
    /// The ground: the block does not feel it.
    Ground,
    /// The block, as of a machine that is bolted to it.
    Block,
}

/// What takes the power, at the end of the driveline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Load {
    /// Its torque, against the rotation.
    pub law: LoadLaw,
    /// Where its reaction goes.
    pub reacts_on: ReactsOn,
}

/// Torque of a load over the speed w of the shaft that it sits on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum LoadLaw {
    /// None.
    None,
    /// The same at every speed [N m]; like dry friction it holds at standstill.
    Constant(f64),
    /// `factor w` [N m s].
    Viscous(f64),
    /// `factor w |w|` [N m s^2].
    Quadratic(f64),
    /// A constant power [W]; below `least_speed` [rad/s] the torque stays what it is there.
    Power {
        /// Power [W].
        power: f64,
        /// Speed below which the torque is constant [rad/s].
        least_speed: f64,
    },
    /// Torque [N m] at speeds [rad/s] that rise, straight between, constant beyond.
    Table(Vec<[f64; 2]>),
}

impl LoadLaw {
    /// Torque against the rotation at `speed` [rad/s] [N m], with the sign of the speed.
    pub fn torque(&self, speed: f64) -> f64 {
        let size = speed.abs();
        let amount = match self {
            LoadLaw::None => 0.0,
            LoadLaw::Constant(torque) => *torque,
            LoadLaw::Viscous(factor) => factor * size,
            LoadLaw::Quadratic(factor) => factor * size * size,
            LoadLaw::Power { power, least_speed } => power / size.max(*least_speed),
            LoadLaw::Table(points) => straight(points, size),
        };
        amount * if speed < 0.0 { -1.0 } else { 1.0 }
    }
}

/// Value at `x` on straight lines through points that rise; constant beyond them, 0 without points.
pub(crate) fn straight(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] <= x);
    match (after.checked_sub(1).and_then(|k| points.get(k)), points.get(after)) {
        (Some([x0, y0]), Some([x1, y1])) => y0 + (x - x0) / (x1 - x0) * (y1 - y0),
        (Some([_, y]), None) | (None, Some([_, y])) => *y,
        (None, None) => 0.0,
    }
}

/// A starter: `torque = stall (1 - ratio w / free_speed)` times its ratio on crankshaft 1, until a speed is reached.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Starter {
    /// Torque of the starter at standstill [N m].
    pub stall_torque: f64,
    /// Speed of the starter without torque [rad/s].
    pub free_speed: f64,
    /// Speed of the starter over that of crankshaft 1.
    pub ratio: f64,
    /// Speed of crankshaft 1 at which it lets go [rad/s].
    pub until: f64,
    /// Where its reaction goes.
    pub reacts_on: ReactsOn,
}

/// A governor: the fired part of the gas is multiplied by `u`, from 0 to 1.
///
/// ```text
/// e = w_0 (1 - droop u) - w         u_c = gain e + integral INTEGRAL of e, held within 0 and 1       delay u' = u_c - u
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Governor {
    /// Speed without load [rad/s].
    pub speed: f64,
    /// Proportional gain [s/rad].
    pub gain: f64,
    /// Integral gain [1/rad].
    pub integral: f64,
    /// Drop of the speed from no load to full load, as a share.
    pub droop: f64,
    /// Time constant of the actuator [s].
    pub delay: f64,
    /// `u` at the start.
    pub start: f64,
}

/// An inertia behind the flywheel on a torsional spring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DrivelineInertia {
    /// Moment of inertia about its axis [kg m^2].
    pub inertia: f64,
    /// Stiffness of the spring before it [N m/rad].
    pub stiffness: f64,
    /// Damping of that spring [N m s/rad].
    pub damping: f64,
    /// Its speed over that of what is before it.
    pub ratio: f64,
}

/// Something that happens on the way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// When.
    pub when: When,
    /// What.
    pub action: Action,
}

/// When an event happens: the first time after the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum When {
    /// At a time [s].
    Time(f64),
    /// At a crank angle from the start [rad].
    Angle(f64),
    /// When the speed rises through this [rad/s].
    SpeedRises(f64),
    /// When the speed falls through this [rad/s].
    SpeedFalls(f64),
}

/// What an event does.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Action {
    /// The cylinder with this index fires no more.
    Misfire(usize),
    /// All cylinders: factor on the fired part of the gas, from 0 to 1.
    Fuel(f64),
    /// Another load torque law.
    Load(LoadLaw),
    /// The spring before the first inertia of the driveline carries no more.
    ClutchOpen,
    /// The run ends.
    Stop,
}
