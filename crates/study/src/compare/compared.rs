//! What a comparison tells of every engine.

use crate::compare::similar::Similar;
use lanchester_task::Measured;
use serde::Serialize;

/// One engine of a comparison, in the size in which it is compared.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Compared {
    /// Its name.
    pub engine: String,
    /// What it got in place of its own counterweights and shafts, in words.
    pub with: Option<String>,
    /// Its size over that of its file.
    pub similar: Similar,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Displacement [m^3], where all bores are known.
    pub displacement: Option<f64>,
    /// Largest resultant force of the moving masses on the block [N].
    pub force: f64,
    /// What most of the force is.
    pub force_leading: Option<Leading>,
    /// Largest resultant couple about the reference point [N m].
    pub couple: f64,
    /// What most of the couple is.
    pub couple_leading: Option<Leading>,
    /// Largest roll moment of the moving masses, either way [N m].
    pub roll_moment: f64,
    /// Largest force at any of its mounts [N]: of inertia and, where it is known, of gas, over the range of speeds on mounts with
    /// springs; of inertia alone, at the speed, on mounts without, which share what they can carry. `None` without mounts.
    pub mount_force: Option<f64>,
    /// Largest load of inertia on any main bearing over the cycle, throw by throw [N]; `None` for crankshafts without throws.
    pub main_load: Option<f64>,
    /// Smallest oil film of any main bearing over the cycle [m], the smaller of that at the lowest speed and at the speed of the comparison.
    pub main_film: Measured,
    /// The same of any big-end bearing [m].
    pub crankpin_film: Measured,
    /// Smallest safety of any fillet or oil bore by the formulas after UR M53 [1], at these speeds.
    pub rule_safety: Measured,
    /// Smallest safety of any fillet by finite elements [1], where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fillet_safety: Option<Measured>,
    /// Largest bending moment along any crankshaft as a free beam under what turns with it [N m].
    pub bending_moment: Option<f64>,
    /// Least and largest balance rate of any bay: share of the rotating unbalance between two main bearings that the counterweights
    /// there answer [1].
    pub balance_rate: Option<[f64; 2]>,
    /// Largest departure of a firing interval from the even one, over it, where firing is known.
    pub firing_unevenness: Option<f64>,
    /// Torque of gas and inertia, where the gas is known.
    pub torque: Option<ComparedTorque>,
    /// Unbalance of all counterweights [kg m].
    pub counterweights: f64,
    /// Number of balance shafts.
    pub shafts: usize,
    /// Unbalance of all weights of balance shafts [kg m].
    pub shaft_weights: f64,
    /// Mass of the counterweights and shaft weights that are parts [kg]; `None` where one of them is a number only.
    pub added_mass: Option<f64>,
}

/// The order that most of a load is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Leading {
    /// Order.
    pub order: f64,
    /// Largest resultant of this order alone, in the unit of the load.
    pub size: f64,
    /// Share of it that turns with the crank, from 0 to 1.
    pub forward: f64,
}

/// Torque of gas and inertia at the speed of the comparison, and the flywheel for the lowest speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ComparedTorque {
    /// Net indicated power [W].
    pub power: f64,
    /// Mean torque at crankshaft 1 [N m].
    pub mean: f64,
    /// Largest torque [N m].
    pub most: f64,
    /// Smallest torque [N m].
    pub least: f64,
    /// Largest excess energy [J].
    pub excess: f64,
    /// Excess energy over the work of one period: how uneven the torque is, whatever its size.
    pub excess_share: f64,
    /// Inertia by the formula for the fluctuation of the comparison at the lowest speed [kg m^2].
    pub inertia: f64,
    /// Flywheel that the true speed needs for it [kg m^2], of variable inertia; `None` where none keeps it.
    pub flywheel: Option<f64>,
}
