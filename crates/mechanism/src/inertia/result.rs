//! What a load calculation returns: plain data, the same for every front end.
//!
//! All in SI and radians. Components are those of the frame (book, "Conventions"): what the moving parts exert on
//! the block, couples about the reference point of [`Loads::reference`].

use crate::inertia::part::Part;
use lanchester_results::LoadSet;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const RESULT_VERSION: u32 = 1;

/// Motion of one cylinder, over the continuous angle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderMotion {
    /// Cylinder number, from 1.
    pub cylinder: usize,
    /// `theta` of its top dead centre [rad], in [0, 2 pi / |ratio|).
    pub top_dead_centre: f64,
    /// `theta` of its bottom dead centre [rad].
    pub bottom_dead_centre: f64,
    /// Stroke [m].
    pub stroke: f64,
    /// Distance of the piston pin from the crankshaft's axis along the cylinder at top dead centre [m].
    pub top: f64,
    /// Largest piston speed [m/s] at the speed of the loads.
    pub max_speed: f64,
    /// Largest piston acceleration away from the crankshaft [m/s^2] (at or near bottom dead centre).
    pub max_acceleration: f64,
    /// Largest piston acceleration towards the crankshaft [m/s^2], as a positive number (at or near top dead centre).
    pub max_deceleration: f64,
    /// Largest angle of the rod from the cylinder axis [rad].
    pub max_rod_angle: f64,
    /// Firing angle: its top dead centre, or that of the chamber that it shares, in the first working cycle of its own crankshaft
    /// [rad of crankshaft 1], where the file gives a firing.
    pub firing_angle: Option<f64>,
    /// The chamber that its piston shares with others: its firing angle is that of this chamber.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chamber: Option<ChamberMotion>,
    /// Residual inertia `m_A a^2 + m_B b^2 - I` of its rod [kg m^2]; 0 for a two-mass rod.
    pub residual_inertia: f64,
    /// For an articulated rod: largest swing of the knuckle pin's line off the cylinder axis, and how its stroke and
    /// dead centres depart from those of a plain rod of the master's kind.
    pub articulation: Option<Articulation>,
    /// Its motion over the period of the loads.
    pub trace: MotionTrace,
}

/// Motion of a piston and its rod over the crank angle, at the angles of the loads' [`Trace`].
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct MotionTrace {
    /// Crank angle of crankshaft 1 [rad], from 0, one period of the loads, end point excluded.
    pub theta: Vec<f64>,
    /// Distance `s` of the piston pin from the crankshaft's axis along the cylinder [m], always exact.
    pub position: Vec<f64>,
    /// Velocity of the piston away from the crankshaft [m/s], of the kinematics asked for.
    pub velocity: Vec<f64>,
    /// Acceleration of the piston away from the crankshaft [m/s^2], of the kinematics asked for.
    pub acceleration: Vec<f64>,
    /// Angle `beta` of the rod from the cylinder axis [rad], positive where its big end stands towards +v; always
    /// exact.
    pub rod_angle: Vec<f64>,
}

/// What an articulated rod changes.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Articulation {
    /// Number of the master's cylinder, from 1.
    pub master: usize,
    /// Slave reach [m]: the largest distance from the crankpin to the slave's piston pin over the cycle.
    pub max_reach: f64,
    /// The smallest such distance [m].
    pub min_reach: f64,
    /// Stroke minus the master's stroke [m].
    pub stroke_difference: f64,
    /// Angle of TDC minus the angle at which the crank points along the cylinder [rad].
    pub top_dead_centre_shift: f64,
}

/// The chamber that pistons share.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ChamberMotion {
    /// Numbers of its cylinders, from 1, rising.
    pub cylinders: Vec<usize>,
    /// Crank angle of crankshaft 1 at its top dead centre, where its volume is least [rad], in the first turn of its crankshafts.
    pub top_dead_centre: f64,
    /// Crank angle at its bottom dead centre, where its volume is largest [rad], in the first turn.
    pub bottom_dead_centre: f64,
    /// Largest less smallest volume [m^3]; without bores the same of the travels [m].
    pub swept: f64,
    /// What the pistons leave free below their own top dead centres where its volume is least [m^3]; 0 where they are all there at once.
    pub least: f64,
}

/// Loads of an engine at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Loads {
    /// [`RESULT_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Point that couples and roll moment are about [m]: x, y, z in the frame.
    pub reference: [f64; 3],
    /// Which motion was used: exact, or a truncated series.
    pub kinematics: String,
    /// Period of the loads [rad] of crankshaft 1: 2 pi times a whole number.
    pub period: f64,
    /// The whole engine.
    pub total: LoadSet,
    /// By kind of part, only the kinds that the engine has.
    pub parts: Vec<PartLoads>,
    /// By cylinder: its piston, rod and (shared among the rods of the throw) its share of the crank throw.
    pub cylinders: Vec<CylinderLoads>,
    /// Motion of every cylinder.
    pub motion: Vec<CylinderMotion>,
    /// What the spectrum means, in words.
    pub diagnosis: Diagnosis,
}

/// Loads of one kind of part.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PartLoads {
    /// Which.
    pub part: Part,
    /// Its loads.
    pub loads: LoadSet,
}

/// Loads of one cylinder.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderLoads {
    /// Cylinder number, from 1.
    pub cylinder: usize,
    /// Its loads.
    pub loads: LoadSet,
}

/// What is left to do about the loads, read off the two-sided spectrum.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Diagnosis {
    /// One finding a load that matters, in the order of the summary: both senses of a force or couple together, roll moments last.
    pub findings: Vec<Finding>,
    /// The forces and couples in one or two sentences.
    pub summary: String,
    /// The roll moment in a line of its own; empty where none matters.
    #[serde(default)]
    pub roll: String,
}

/// Whether a finding is about the force, the couple or the roll moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Resultant force [N].
    Force,
    /// Resultant couple [N m].
    Couple,
    /// Roll moment [N m].
    RollMoment,
}

/// Which way a load turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// With the crank.
    Forward,
    /// Against the crank.
    Backward,
    /// About z: no sense.
    None,
}

/// What can remove a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Remedy {
    /// Weights on the crankshaft.
    CrankWeights,
    /// A balance shaft at the order's speed and sense.
    BalanceShaft,
    /// Nothing of first or second order.
    NoneOfLowOrder,
    /// A couple of shafts at unequal heights, or a counter-rotating inertia.
    RollDevice,
}

/// One load of the spectrum, with its remedy.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Finding {
    /// Force, couple or roll moment.
    pub quantity: Quantity,
    /// Order.
    pub order: f64,
    /// Sense.
    pub sense: Sense,
    /// Amplitude [N] or [N m].
    pub amplitude: f64,
    /// What can remove it.
    pub remedy: Remedy,
    /// The finding as a sentence with numbers and units.
    pub text: String,
}
