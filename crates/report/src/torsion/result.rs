//! Torsional vibration of an engine as a result.

use lanchester_torsion::{
    BALANCED, Campbell, ChainEnergy, CrankChain, DampedMode, HolzerTable, Mode, OrderStar, Sweep, TunedDamper,
};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const TORSION_VERSION: u32 = 1;

/// Torsional vibration of an engine over its speed range.
///
/// Linear, about a mean speed that does not change: mean inertia of the moving masses, their torque at constant speed beside that of the gas. Amplitudes
/// are half of largest less least value, those by order moduli.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorsionResult {
    /// [`TORSION_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// The chain, and where its numbers come from.
    pub crank: CrankChain,
    /// Where the pressures come from, in words; `None`: no gas acts.
    pub gas: Option<String>,
    /// Stiffness of throws by finite elements, where it was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub meshed: Vec<MeshedThrow>,
    /// Undamped modes; of pendulums at the highest speed.
    pub modes: Vec<Mode>,
    /// Damped modes at the highest speed.
    pub damped: Vec<DampedMode>,
    /// Holzer's table at each of the first natural frequencies.
    pub holzer: Vec<HolzerTable>,
    /// Orders and natural frequencies over speed, with the speeds at which they meet.
    pub campbell: Campbell,
    /// Star of each order; empty where the file gives no firing.
    pub stars: Vec<OrderStar>,
    /// Forced vibration over speed.
    pub sweep: Sweep,
    /// The best setting of the damper, where it was asked for.
    pub tuned: Option<TunedDamper>,
    /// The check in the time domain, where it was asked for.
    pub time: Option<TimeCheck>,
    /// Limits of the file.
    pub limits: Vec<TorsionLimit>,
    /// What was assumed and left out.
    pub notes: Vec<String>,
}

/// Torsional stiffness of a throw by finite elements, between the middles of its journals.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MeshedThrow {
    /// Number of the throw, from 1.
    pub throw: usize,
    /// With journals that may move aside [N m/rad].
    pub free: f64,
    /// With journals whose middles stay on the axis [N m/rad].
    pub held: f64,
    /// Whether the chain has that of held journals.
    pub is_held: bool,
}

impl MeshedThrow {
    /// Index of the throw, and the stiffness that the chain has [N m/rad].
    pub fn taken(&self) -> (usize, f64) {
        (self.throw - 1, if self.is_held { self.held } else { self.free })
    }
}

/// A limit, and what is reached.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorsionLimit {
    /// What is limited.
    pub quantity: LimitedQuantity,
    /// Allowed amplitude [rad] or [Pa].
    pub allowed: f64,
    /// Largest amplitude over speed [rad] or [Pa].
    pub found: f64,
    /// Speed of crankshaft 1 at which it is found [rad/s].
    pub speed: f64,
    /// Whether what is found can be trusted: not where pendulums swing beyond the linear theory.
    pub is_known: bool,
}

/// What a limit is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LimitedQuantity {
    /// Twist between nose and flywheel [rad].
    Twist,
    /// Vibratory shear stress, nominal [Pa].
    Stress,
}

impl TorsionLimit {
    /// Whether it is kept, as far as that is known.
    pub fn is_kept(&self) -> bool {
        self.is_known && self.found <= self.allowed
    }
}

/// Periodic motion in the time domain beside the sum of orders, at one speed. Loss factors count as viscous dampers of the same loss at one frequency, in all three.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TimeCheck {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Angular frequency at which loss factors and viscous dampers are equal [rad/s].
    pub frequency: f64,
    /// Amplitudes by the sum of orders.
    pub orders: TimeAmplitudes,
    /// Amplitudes of the same linear equations in the time domain.
    pub linear: TimeAmplitudes,
    /// Amplitudes with the inertia as it varies over the angle, torques over the true angle of each throw.
    pub varying: TimeAmplitudes,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
}

/// Amplitudes of torques and twist.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TimeAmplitudes {
    /// Torque of each shaft [N m].
    pub torques: Vec<f64>,
    /// Twist between nose and flywheel [rad].
    pub twist: f64,
    /// In time: work and energy over the period.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy: Option<ChainEnergy>,
    /// In time: missing energy over the turnover.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_error: Option<f64>,
}

impl TimeCheck {
    /// Largest missing energy over the turnover of both motions in time.
    pub fn energy_error(&self) -> f64 {
        [&self.linear, &self.varying].into_iter().filter_map(|own| own.energy_error).fold(0.0, f64::max)
    }

    /// Whether both balance to 1e-4.
    pub fn is_balanced(&self) -> bool {
        let mut errors = [&self.linear, &self.varying].into_iter().filter_map(|own| own.energy_error);
        errors.all(|error| error <= BALANCED)
    }
}

impl TorsionResult {
    /// Largest vibratory shear stress of all shafts of known section at each speed [Pa].
    pub fn stresses(&self) -> Vec<f64> {
        let known = || self.sweep.shafts.iter().filter_map(|shaft| Some((shaft, shaft.stress_rate?)));
        let at = |index: usize| known().map(|(shaft, rate)| shaft.total[index] * rate).fold(0.0, f64::max);
        (0..self.sweep.speeds.len()).map(at).collect()
    }

    /// Whether all limits are kept.
    pub fn is_within(&self) -> bool {
        self.limits.iter().all(TorsionLimit::is_kept)
    }
}
