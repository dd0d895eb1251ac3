//! What the file says of a run in time: start, drive, load, starter, governor, driveline, events. Plain data; `None` and empty where it says nothing.

use super::load::{LoadLaw, ReactsOn, RunLoad};
use serde::Serialize;

/// What the file says of a run: `[simulation]`, `[load]`, `[starter]`, `[governor]`, `[[driveline]]` and `piston_damping` of `[friction]`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct SimulationInput {
    /// Whether the speed is imposed or free.
    pub speed: Option<SpeedKind>,
    /// Against what an imposed speed counts.
    pub imposed_against: Option<ImposedAgainst>,
    /// Time [s] and speed [rad/s] of an imposed speed, rising in time, straight between; empty: constant.
    pub imposed: Vec<[f64; 2]>,
    /// Speed of crankshaft 1 at the start [rad/s].
    pub start_speed: Option<f64>,
    /// Crank angle at the start [rad].
    pub start_angle: Option<f64>,
    /// Where the block starts.
    pub start_block: Option<StartOfBlock>,
    /// How long the run lasts.
    pub duration: Option<RunLength>,
    /// Whether the block moves on its mounts.
    pub block: Option<BlockKind>,
    /// Acceleration of gravity [m/s^2]; 0: off.
    pub gravity: Option<f64>,
    /// Whether the gas of the file acts.
    pub gas: Option<bool>,
    /// Whether the gas acts as states of volume, mass and energy: in the bond graph alone, elsewhere by its pressures.
    pub gas_states: bool,
    /// Crank angle between two samples [rad].
    pub step: Option<f64>,
    /// Relative tolerance of every step.
    pub tolerance: Option<f64>,
    /// Absolute tolerances by kind of state.
    pub tolerances: StateTolerances,
    /// Whether the crankshaft's first moments and inertia tensor are those of [crank.body]; `None` and `false`: those of the unbalances.
    pub crank_as_body: Option<bool>,
    /// Points of the block whose motion is asked for.
    pub points: Vec<NamedPoint>,
    /// Gears whose force acts along a line of action.
    pub meshes: Vec<GearMesh>,
    /// Which pin guides the rods along the crank axis.
    pub guidance: Option<RodGuidance>,
    /// How loads that rigid crankshafts leave open are shared by their main bearings.
    pub mains: Option<MainSharing>,
    /// Stiffness of the main bearings of crankshaft 1 for the rule `springs` [N/m]; empty: all alike.
    pub main_stiffness: Vec<f64>,
    /// Torque on crankshaft 1 over its angle, from the ground.
    pub torque: Vec<TorqueOrder>,
    /// The same from files, beside those.
    pub torque_files: Vec<TorqueFile>,
    /// What takes the power.
    pub load: Option<RunLoad>,
    /// What starts the engine.
    pub starter: Option<Starter>,
    /// What holds its speed.
    pub governor: Option<Governor>,
    /// Inertias behind the flywheel, in order.
    pub driveline: Vec<DrivelineInertia>,
    /// Viscous friction of every piston along its cylinder [N s/m].
    pub piston_damping: Option<f64>,
    /// What happens on the way.
    pub events: Vec<Event>,
}

impl SimulationInput {
    /// All orders of the torque on crankshaft 1: those of the list, then those of the files.
    ///
    /// # Errors
    /// [`UnreadTorque`] where a file has not been read.
    pub fn torque_orders(&self) -> Result<Vec<TorqueOrder>, UnreadTorque> {
        let mut orders = self.torque.clone();
        for named in &self.torque_files {
            let curve = named.curve.as_ref().ok_or_else(|| UnreadTorque { file: named.file.clone() })?;
            orders.extend(&curve.orders);
        }
        Ok(orders)
    }
}

/// Absolute tolerances of a run's steps by kind of state; `None`: it follows from the relative one.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct StateTolerances {
    /// Of the angles of crank and driveline [rad].
    pub angle: Option<f64>,
    /// Of their speeds [rad/s].
    pub speed: Option<f64>,
    /// Of the place of the block [m].
    pub displacement: Option<f64>,
    /// Of the turn of the block [rad].
    pub turn: Option<f64>,
    /// Of its velocity [m/s].
    pub velocity: Option<f64>,
    /// Of its angular velocity [rad/s].
    pub spin: Option<f64>,
    /// Of works [J].
    pub energy: Option<f64>,
}

/// A point of the block.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct NamedPoint {
    /// Its name.
    pub name: String,
    /// Where it is with the block as drawn [m].
    pub at: [f64; 3],
}

/// A pair of external spur gears by which crankshaft 1 drives a shaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GearMesh {
    /// Name of the crankshaft, balance shaft or gear that is driven.
    pub shaft: String,
    /// Pressure angle [rad].
    pub pressure_angle: f64,
    /// Middle plane of the teeth [m].
    pub z: f64,
}

/// A torque over the crank angle that stands in a file of its own.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueFile {
    /// Its name, from the folder of the engine file.
    pub file: String,
    /// Angle after which it repeats [rad]; `None`: as many whole revolutions as its angles span.
    pub period: Option<f64>,
    /// What was read from it.
    pub curve: Option<TorqueCurve>,
}

/// A torque over the crank angle as a sum of orders.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueCurve {
    /// Its orders.
    pub orders: Vec<TorqueOrder>,
    /// Largest difference between their sum and a sample, over the range of the samples.
    pub departure: f64,
}

/// A file of torque that the engine file names has not been read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the torque of {file} has not been read\nhint: [simulation] names this file")]
pub struct UnreadTorque {
    /// Its name.
    pub file: String,
}

/// What sets the speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpeedKind {
    /// The torques.
    Free,
    /// A drive that takes whatever torque it needs.
    Imposed,
}

/// Against what an imposed speed counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ImposedAgainst {
    /// Relative to the block.
    Block,
    /// Absolute: it differs by the block's roll.
    Ground,
}

/// Where the block starts, at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StartOfBlock {
    /// Where its mounts carry weight and mean torque.
    Equilibrium,
    /// In the position of the file.
    AsDrawn,
}

/// How long a run lasts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RunLength {
    /// Revolutions of crankshaft 1.
    Revolutions(f64),
    /// Seconds.
    Time(f64),
    /// One period of the motion that repeats.
    Periodic,
}

/// Whether the block moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BlockKind {
    /// It stands still.
    Fixed,
    /// It stands on its mounts.
    Mounts,
}

/// Which pin guides a rod along the crank axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RodGuidance {
    /// The crankpin.
    Crankpin,
    /// The piston pin.
    Piston,
}

/// How the main bearings of a crankshaft share what a rigid shaft on more than two leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MainSharing {
    /// The shaft cut at every main bearing.
    Cut,
    /// A rigid shaft on radial springs.
    Springs,
    /// A uniform continuous beam on rigid bearings.
    Beam,
}

/// One order of a torque over the crank angle: `sin sin(order theta) + cos cos(order theta)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueOrder {
    /// Its order.
    pub order: f64,
    /// Factor of the sine [N m].
    pub sin: f64,
    /// Factor of the cosine [N m].
    pub cos: f64,
}

/// A starter: `torque = stall (1 - ratio w / free_speed)` times its ratio on crankshaft 1, until a speed is reached.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
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
/// e = w_0 (1 - droop u) - w      u_c = gain (e + integral INTEGRAL of e dt), held within 0 and 1
/// lag u' = u_c(t - delay) - u    without lag: u = u_c(t - delay)
/// ```
/// The integral grows no more beyond the end of `u_c` towards which `e` drives it; over a hundredth there it fades out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Governor {
    /// Speed without load [rad/s].
    pub speed: f64,
    /// Proportional gain [s/rad].
    pub gain: f64,
    /// Integral part: reciprocal of the reset time [1/s].
    pub integral: f64,
    /// Drop of the speed from no load to full load, as a share.
    pub droop: f64,
    /// Dead time: what it commands reaches the gas so much later [s]; before that, the factor is that of the start.
    pub delay: f64,
    /// Time constant of the actuator, a lag of first order behind the dead time [s].
    pub lag: f64,
    /// `u` at the start.
    pub start: f64,
}

/// An inertia behind the flywheel on a torsional spring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Event {
    /// When.
    pub when: When,
    /// What.
    pub action: Action,
}

/// When an event happens: the first time after the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
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
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
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
