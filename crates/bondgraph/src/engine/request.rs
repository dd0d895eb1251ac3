//! What the graph of an engine is to hold. All in SI units and radians.

use super::joints::EngineJoints;
use crate::curve::Curve;
pub use lanchester_model::LoadLaw;
use lanchester_model::{Event, Governor};
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
    /// Joints of the crank train.
    pub joints: EngineJoints,
    /// Pose and motion of the block at the start; a block that is held still has none.
    pub start: EngineStart,
    /// Whether the block starts instead at rest where its mounts carry the weight, with the pistons as they are, and the reaction to a load
    /// from the ground; as drawn where they leave it a motion.
    pub equilibrium: bool,
    /// Acceleration of gravity [m/s^2]; 0: off.
    pub gravity: f64,
    /// Polar inertia of every crankshaft with its flywheel, without rods [kg m^2].
    pub crankshaft_inertia: Vec<f64>,
    /// Polar inertia of every balance shaft [kg m^2].
    pub shaft_inertia: Vec<f64>,
    /// Pressure in every cylinder less that under its piston [Pa] over the angle that its crankshaft turned since it fired [rad]; empty:
    /// no gas.
    #[serde(skip)]
    pub pressures: Vec<Curve>,
    /// The gas as states instead of pressures.
    #[serde(skip)]
    pub gas_states: Option<GasStates>,
    /// Dry friction of the crank train against the rotation of crankshaft 1 [N m].
    pub friction_torque: f64,
    /// What is added to that in proportion to the speed of crankshaft 1 [N m s/rad] and to its square [N m s^2/rad^2].
    pub friction_growth: [f64; 2],
    /// Viscous friction of every piston along its cylinder [N s/m].
    pub piston_damping: f64,
    /// What takes the power, at the end of the driveline.
    pub load: EngineLoad,
    /// Inertias behind the flywheel, in order.
    pub driveline: Vec<EngineLink>,
    /// What starts the engine.
    pub starter: Option<EngineStarter>,
    /// What holds the speed by a factor on the fired part of the gas; without gas it has nothing to act on.
    pub governor: Option<Governor>,
    /// What happens on the way.
    pub events: Vec<Event>,
    /// Torque from the ground on crankshaft 1 over its angle: order, factors of sine and cosine [N m].
    pub torque: Vec<[f64; 3]>,
    /// Time [s] and imposed speed [rad/s], straight between; fewer than two: `speed`.
    pub profile: Vec<[f64; 2]>,
    /// Whether an imposed speed counts against the ground instead of the block.
    pub against_ground: bool,
    /// Duration of the simulation [s].
    pub duration: f64,
    /// Whether one period of the periodic motion is looked for instead: the revolutions after which all stands as before.
    pub periodic: bool,
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
            joints: EngineJoints::Ideal,
            start: EngineStart::default(),
            equilibrium: false,
            gravity: 0.0,
            crankshaft_inertia: Vec::new(),
            shaft_inertia: Vec::new(),
            pressures: Vec::new(),
            gas_states: None,
            friction_torque: 0.0,
            friction_growth: [0.0; 2],
            piston_damping: 0.0,
            load: EngineLoad { torque: LoadLaw::None, reacts_on_block: false },
            driveline: Vec::new(),
            starter: None,
            governor: None,
            events: Vec::new(),
            torque: Vec::new(),
            profile: Vec::new(),
            against_ground: false,
            duration: revolutions * std::f64::consts::TAU / speed,
            periodic: false,
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
    /// A source of flow: its speed counts against the block, its torque comes from the ground.
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
    /// In space, held still by sources of flow: what they exert is the opposite of the loads of the crank train on it.
    Held,
}

impl EngineBlock {
    /// Whether it has six flows.
    pub(crate) fn is_spatial(self) -> bool {
        matches!(self, EngineBlock::Space | EngineBlock::Held)
    }
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

/// The gas of all cylinders as states: volume, mass and energy.
#[derive(Debug, Clone, PartialEq)]
pub struct GasStates {
    /// Gas constant [J/(kg K)].
    pub gas_constant: f64,
    /// Specific heat at constant volume [J/(kg K)].
    pub heat_capacity: f64,
    /// Largest volume over smallest.
    pub compression_ratio: f64,
    /// Pressure under the pistons [Pa].
    pub crankcase: f64,
    /// Pressure [Pa] and temperature [K] in every cylinder at the start.
    pub start: [f64; 2],
    /// Valve to the intake.
    pub intake: GasValve,
    /// Valve to the exhaust.
    pub exhaust: GasValve,
    /// Heat release by the angle since firing [J/rad]; with `heat_per_fresh` the share of it [1/rad].
    pub release: Option<Curve>,
    /// Heat that a kilogram of the fresh gas which the cylinder holds at its closing releases [J/kg]; `None`: the release says it.
    pub heat_per_fresh: Option<f64>,
    /// Angle since firing at which the cylinder closes [rad].
    pub closes: f64,
    /// Heat to crown, head and liner, whose temperatures are given.
    pub losses: Option<WallLaw>,
    /// A body of one temperature that takes heat by a conductance.
    pub walls: Option<GasWalls>,
}

/// Heat to walls of given temperatures.
#[derive(Debug, Clone, PartialEq)]
pub struct WallLaw {
    /// Heat transfer coefficient.
    pub coefficient: WallCoefficient,
    /// Factor on it.
    pub factor: f64,
    /// Temperatures of crown, head and liner [K].
    pub temperatures: [f64; 3],
    /// Areas of crown and head over that of the bore.
    pub areas: [f64; 2],
}

/// Whose heat transfer coefficient.
#[derive(Debug, Clone, PartialEq)]
pub enum WallCoefficient {
    /// Woschni's, with `c_1` [1] and `c_2` [m/(s K)] over the angle since firing.
    Woschni {
        /// Both factors.
        phases: Box<[Curve; 2]>,
    },
    /// Hohenberg's.
    Hohenberg,
    /// Over the angle since firing [W/(m^2 K)].
    Given(Curve),
}

/// A valve to a reservoir.
#[derive(Debug, Clone, PartialEq)]
pub struct GasValve {
    /// Pressure of the reservoir [Pa].
    pub pressure: f64,
    /// Its temperature [K].
    pub temperature: f64,
    /// Effective area over the angle since firing [m^2].
    pub area: Curve,
}

/// Heat from the gas to the engine's body and from there to the surroundings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GasWalls {
    /// Conductance from the gas of one cylinder to the body [W/K].
    pub gas_to_body: f64,
    /// Heat capacity of the body [J/K].
    pub body_capacity: f64,
    /// Conductance from the body to the surroundings [W/K].
    pub body_to_ambient: f64,
    /// Temperature of the surroundings [K].
    pub ambient: f64,
    /// Temperature of the body at the start [K].
    pub start: f64,
}

/// What takes the power.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EngineLoad {
    /// Its torque against the rotation.
    pub torque: LoadLaw,
    /// Whether it is bolted to the block; otherwise it acts from the ground.
    pub reacts_on_block: bool,
}

/// Torque of a load at a speed [rad/s] and angle [rad] of its shaft [N m], positive against positive rotation.
pub(crate) fn load_at(law: &LoadLaw, speed: f64, angle: f64) -> f64 {
    let size = speed.abs();
    let amount = match law {
        LoadLaw::None => 0.0,
        LoadLaw::Constant(torque) => *torque,
        LoadLaw::Viscous { torque, at } => torque / at * size,
        LoadLaw::Quadratic { torque, at } => torque / (at * at) * size * size,
        LoadLaw::Power { power, least_speed } => power / size.max(*least_speed),
        LoadLaw::Table(points) => {
            let after = points.partition_point(|point| point[0] <= size);
            match (after.checked_sub(1).and_then(|before| points.get(before)), points.get(after)) {
                (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (size - a[0]) / (b[0] - a[0]),
                (Some(only), None) | (None, Some(only)) => only[1],
                (None, None) => 0.0,
            }
        }
        LoadLaw::Angle { .. } | LoadLaw::Map { .. } => return law.at_angle(angle, speed).unwrap_or(0.0),
    };
    if speed < 0.0 { -amount } else { amount }
}

/// An inertia behind the flywheel on a torsional spring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EngineLink {
    /// Moment of inertia about its axis [kg m^2].
    pub inertia: f64,
    /// Stiffness of the spring before it [N m/rad].
    pub stiffness: f64,
    /// Damping of that spring [N m s/rad].
    pub damping: f64,
    /// Its speed over that of what is before it.
    pub ratio: f64,
}

/// A starter: its torque falls with speed and ends at a speed for good.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EngineStarter {
    /// Torque at standstill [N m].
    pub stall_torque: f64,
    /// Speed without torque [rad/s].
    pub free_speed: f64,
    /// Speed of the starter over that of crankshaft 1.
    pub ratio: f64,
    /// Speed of crankshaft 1 at which it lets go [rad/s].
    pub until: f64,
    /// Whether it is bolted to the block.
    pub reacts_on_block: bool,
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
    /// The gas of the file cannot become states.
    Gas {
        /// What it would need.
        needed: &'static str,
    },
    /// As many pressures as cylinders are needed.
    Pressures {
        /// Cylinders.
        needed: usize,
        /// Pressures.
        got: usize,
    },
    /// Compliant joints need bodies that can move by themselves, and numbers that make sense.
    Joints {
        /// Number of the cylinder, from 1; `None`: the joints' own numbers.
        cylinder: Option<usize>,
        /// What they need.
        needed: &'static str,
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
            EngineGraphError::Gas { needed } => write!(formatter, "gas as states needs {needed}"),
            EngineGraphError::Pressures { needed, got } => {
                write!(formatter, "every cylinder needs its pressure: {needed} cylinders, {got} pressures")
            }
            EngineGraphError::Joints { cylinder: Some(cylinder), needed } => {
                write!(
                    formatter,
                    "compliant joints need {needed} in cylinder {cylinder}; ideal joints do without"
                )
            }
            EngineGraphError::Joints { cylinder: None, needed } => {
                write!(formatter, "compliant joints need {needed}")
            }
            EngineGraphError::Chamber { cylinder } => {
                write!(formatter, "cylinder {cylinder} needs a bore and a firing angle for its gas")
            }
        }
    }
}

impl std::error::Error for EngineGraphError {}
