//! What the graph of an engine is to hold. All in SI units and radians.

use crate::curve::Curve;
use serde::Serialize;

/// What the graph of an engine holds beside its crank train.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EngineRequest {
    /// What sets the speed.
    pub drive: EngineDrive,
    /// Speed of crankshaft 1 relative to the block at the start, or imposed [rad/s].
    pub speed: f64,
    /// Crank angle at the start [rad].
    pub start_angle: f64,
    /// How the block moves.
    pub block: EngineBlock,
    /// Whether its mounts act.
    pub mounts: bool,
    /// Pose and motion of the block at the start.
    pub start: EngineStart,
    /// Acceleration of gravity [m/s^2]; 0: off.
    pub gravity: f64,
    /// Polar inertia of every crankshaft with its flywheel, without rods [kg m^2].
    pub crankshaft_inertia: Vec<f64>,
    /// Polar inertia of every balance shaft [kg m^2].
    pub shaft_inertia: Vec<f64>,
    /// Pressure in every cylinder less that under its piston [Pa] over the angle that its crankshaft turned since it fired [rad]; empty: no gas.
    #[serde(skip)]
    pub pressures: Vec<Curve>,
    /// Dry friction of the crank train against the rotation of crankshaft 1 [N m].
    pub friction_torque: f64,
    /// Viscous friction of every piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// What takes the power.
    pub load: EngineLoad,
    /// Duration of the simulation [s].
    pub duration: f64,
    /// Its samples.
    pub samples: usize,
    /// Its relative tolerance.
    pub tolerance: f64,
}

impl EngineRequest {
    /// Free speed from `speed` [rad/s] for `revolutions`, block fixed, nothing but the crank train, inertia unknown.
    pub fn free(speed: f64, revolutions: f64) -> EngineRequest {
        EngineRequest {
            drive: EngineDrive::Free,
            speed,
            start_angle: 0.0,
            block: EngineBlock::Fixed,
            mounts: false,
            start: EngineStart::default(),
            gravity: 0.0,
            crankshaft_inertia: Vec::new(),
            shaft_inertia: Vec::new(),
            pressures: Vec::new(),
            friction_torque: 0.0,
            piston_damping: 0.0,
            load: EngineLoad { torque: LoadTorque::None, reacts_on_block: false },
            duration: revolutions * std::f64::consts::TAU / speed,
            samples: 720,
            tolerance: 1e-9,
        }
    }
}

/// What sets the speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EngineDrive {
    /// The torques.
    Free,
    /// A source of flow between block and crank.
    Imposed,
}

/// How the block moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EngineBlock {
    /// It stands still.
    Fixed,
    /// In the plane across the crank: x, y and roll.
    Plane,
    /// In space.
    Space,
}

/// Pose and motion of the block at the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EngineStart {
    /// Where its origin is [m], axes of the ground; 0 in the position of the file.
    pub position: [f64; 3],
    /// Its turn as a unit quaternion, real part first.
    pub orientation: [f64; 4],
    /// Velocity of its origin [m/s], block axes.
    pub velocity: [f64; 3],
    /// Angular velocity [rad/s], block axes.
    pub spin: [f64; 3],
}

impl Default for EngineStart {
    fn default() -> EngineStart {
        EngineStart {
            position: [0.0; 3],
            orientation: [1.0, 0.0, 0.0, 0.0],
            velocity: [0.0; 3],
            spin: [0.0; 3],
        }
    }
}

/// What takes the power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EngineLoad {
    /// Its torque against the rotation.
    pub torque: LoadTorque,
    /// Whether it is bolted to the block; otherwise it acts from the ground.
    pub reacts_on_block: bool,
}

/// Torque of a load over the speed of the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LoadTorque {
    /// None.
    None,
    /// The same at every speed [N m].
    Constant(f64),
    /// Proportional to speed [N m s].
    Viscous(f64),
    /// Proportional to its square [N m s^2].
    Quadratic(f64),
}

/// Why an engine has no graph of the kind that was asked for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum EngineGraphError {
    /// Nothing gives crankshaft 1 an inertia.
    NoInertia,
    /// The file has no block.
    NoBlock,
    /// A mount has no stiffness, or one that depends on frequency.
    Mount {
        /// Its name.
        mount: String,
    },
    /// The parts in the block weigh more than it, or leave it no inertia.
    BlockTooSmall {
        /// What is left of its mass [kg].
        mass: f64,
        /// The smallest of what is left of its moments of inertia [kg m^2].
        inertia: f64,
    },
    /// As many pressures as cylinders are needed.
    Pressures {
        /// Cylinders.
        needed: usize,
        /// Pressures.
        got: usize,
    },
    /// A cylinder with pressure has no bore or no firing.
    Chamber {
        /// Its number, from 1.
        cylinder: usize,
    },
}

impl std::fmt::Display for EngineGraphError {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            EngineGraphError::NoInertia => write!(
                formatter,
                "crankshaft 1 has no moment of inertia, so that its speed cannot be free: give [flywheel] inertia or [crank.body]"
            ),
            EngineGraphError::NoBlock => {
                write!(formatter, "the block cannot move: the file has no [block] with mass and inertia")
            }
            EngineGraphError::Mount { mount } => write!(
                formatter,
                "mount `{mount}` needs a stiffness and viscous damping, without loss factor or table over frequency"
            ),
            EngineGraphError::BlockTooSmall { mass, inertia } => write!(
                formatter,
                "[block] is smaller than the parts in it: a mass of {mass} kg and an inertia of {inertia} kg m2 are left"
            ),
            EngineGraphError::Pressures { needed, got } => {
                write!(formatter, "every cylinder needs its pressure: {needed} cylinders, {got} pressures")
            }
            EngineGraphError::Chamber { cylinder } => {
                write!(formatter, "cylinder {cylinder} needs a bore and a firing angle for its gas")
            }
        }
    }
}

impl std::error::Error for EngineGraphError {}
