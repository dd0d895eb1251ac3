//! What balancing answers: plain data, SI units and radians, the same for every front end.

use crate::cancellation::answer::Cancellation;
use crate::settings::{BalanceSettings, StopCause};
use lanchester_task::{BalanceTask, CatalogueHole, Criterion};
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const ANSWER_VERSION: u32 = 1;

/// The best that can be done with the given devices.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Answer {
    /// [`ANSWER_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 at which loads are judged [rad/s]: the highest of the engine, where all of them are largest.
    pub speed: f64,
    /// Where forces of inertia at mounts with springs are judged: the speeds that decide [rad/s], and where the largest of them stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mount_speeds: Option<JudgedSpeeds>,
    /// The same of forces at mounts with gas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mount_gas_speeds: Option<JudgedSpeeds>,
    /// Where main-bearing loads with gas are judged: the speeds that decide [rad/s], and where the largest of them stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gas_speeds: Option<JudgedSpeeds>,
    /// What was asked.
    pub task: BalanceTask,
    /// Whether there is an optimum, and if not, why.
    pub outcome: Outcome,
    /// How it was found.
    pub method: Method,
    /// How far the search went, where it was one over choices.
    pub settings: BalanceSettings,
    /// Every free weight. Empty where there is no optimum.
    pub weights: Vec<FoundWeight>,
    /// Where the free shafts stand.
    pub shafts: Vec<FoundShaft>,
    /// Every free inertia.
    pub inertias: Vec<FoundInertia>,
    /// What each stage reached, with its proof.
    pub stages: Vec<FoundStage>,
    /// What decided among answers that the stages leave equal: of force and couple what no stage names, then the roll
    /// moment if an inertia or the axis of a shaft is free (unless a stage asks for the least weights), then, if a weight on a
    /// crankshaft is free, the root mean square of all main-bearing loads, the largest of them and the bending moment, each
    /// without degrading the previous ones. Empty where nothing was left open. Among what is still equal the answer is the lightest.
    pub among_equals: Vec<FoundStage>,
    /// What each limit costs.
    pub limits: Vec<FoundLimit>,
    /// Criteria before and after: force, couple, roll moment, root mean square of all main-bearing loads, the largest of them
    /// and the bending moment always, then those that the task names. Empty where no answer was found.
    pub effects: Vec<Effect>,
    /// Where orders had to vanish exactly: whether they do, and the proof.
    pub cancellation: Option<Cancellation>,
    /// Weights on webs whose largest amount is what fits there: the optimum is one within these bounds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub web_bounds: Vec<WebBound>,
}

/// What fits on a web.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WebBound {
    /// Name of the weight.
    pub name: String,
    /// The web, counted from 1 through all throws.
    pub web: usize,
    /// The largest unbalance that it can have there [kg m].
    pub bound: f64,
    /// What bounds it: the ranges of its shapes, or what is in the way.
    pub by: String,
}

/// Whether there is an optimum.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Outcome {
    /// Found and proved within the gap of every stage.
    Optimal,
    /// The limits cannot hold together.
    Infeasible {
        /// How far every limit must be relaxed together, as a factor of it, until they can just be reached; above 1.
        relaxation: f64,
        /// The smallest value that each limited criterion can reach if the other limits are dropped, in the order of
        /// the task's limits.
        closest: Vec<f64>,
        /// The reason in words, with numbers and units.
        reason: String,
    },
    /// Orders that had to vanish cannot, whatever the free devices; the weights given leave the least of the first, then
    /// of the second, and so on. The proof stands in [`Answer::cancellation`].
    CannotVanish {
        /// The reason in words, with numbers and units.
        reason: String,
    },
    /// The search stopped before its gap was closed; what is given is feasible and the gaps stand. Without stages: no
    /// feasible point was found.
    Stopped {
        /// Why, in words.
        reason: String,
        /// Why.
        cause: StopCause,
    },
}

/// Speeds at which loads were judged that a higher speed need not raise: forces at mounts with springs, loads with gas.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct JudgedSpeeds {
    /// Speeds of crankshaft 1 [rad/s] that hold the proof: over a range the ends, the resonances, some between and the worst of every round.
    pub judged: Vec<f64>,
    /// What loads at each of them are multiplied by before the largest counts; empty where nothing is.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub weights: Vec<f64>,
    /// Speed [rad/s] at which the first of these criteria, times the weight of its speed, is largest with what was found.
    pub worst: f64,
    /// By how much a speed between passes the value, at most, as a share of it: what the search over the range left.
    pub excess: f64,
    /// Whether the whole range of the engine counts.
    pub range: bool,
}

/// How an optimum was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Method {
    /// One convex programme: every device is free, bounded, on a line of phase or tied.
    Convex {
        /// Cone programmes solved until the angles were refined.
        solves: usize,
    },
    /// Branch and bound around convex programmes: free positions, given or least amounts, on/off choices.
    BranchAndBound {
        /// Branch-and-bound nodes examined.
        nodes: usize,
        /// Cone programmes solved.
        solves: usize,
    },
}

/// A free weight of the answer.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundWeight {
    /// Its name in the task.
    pub name: String,
    /// Its unbalance [kg m]: modulus = amount, argument = direction at `theta = 0` in the engine's frame.
    #[schemars(with = "[f64; 2]")]
    pub unbalance: Complex64,
    /// Its plane [m].
    pub z: f64,
    /// Its mass [kg], where the task gives its radius.
    pub mass: Option<f64>,
    /// The hole that it is, where the task gives drills: opposite to its direction if it stays empty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hole: Option<CatalogueHole>,
    /// Whether it is used.
    pub used: bool,
}

/// A free shaft of the answer.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundShaft {
    /// Its name in the task.
    pub name: String,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Whether it is used.
    pub used: bool,
}

/// A free inertia of the answer.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundInertia {
    /// Its name in the task.
    pub name: String,
    /// Its inertia [kg m^2]; 0 if it is not used.
    pub inertia: f64,
    /// The share of the crank train's roll moment that is left with it.
    pub roll_share: f64,
}

/// What a stage reached, and the proof that nothing better exists.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundStage {
    /// The sum of weight times criterion, its true value over the continuous cycle.
    pub value: f64,
    /// No choice of these devices that holds the limits goes below this.
    pub lower_bound: f64,
    /// `value - lower_bound`, without what later stages took of what this one gives up.
    pub gap: f64,
    /// What it gives up for later stages, if anything.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub give_up: Option<StageGiveUp>,
    /// The value of this stage if no earlier one gave up anything, where one does: the difference is what that gains.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub without_give_up: Option<f64>,
    /// SI unit of the value: that of the criterion, or `1` for a weighted sum, whose terms are shares of given values.
    pub unit: String,
    /// Each term's criterion and true value.
    pub terms: Vec<(Criterion, f64)>,
    /// Weight of each term: 1 for a criterion that is minimised alone.
    pub term_weights: Vec<f64>,
    /// The parts of the cycle that hold the optimum up; none where the stage vanishes.
    pub active: Vec<Active>,
}

/// What a stage gives up for later ones.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StageGiveUp {
    /// The least value that the stage reached by itself, in its unit; its proof is about this one.
    pub least: f64,
    /// The value that later stages had to keep, in its unit.
    pub most: f64,
    /// How far they raised it, in its unit.
    pub used: f64,
}

/// A crank angle at which a criterion stands at its peak and holds the optimum up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Active {
    /// Which criterion.
    pub criterion: Criterion,
    /// Crank angle [rad].
    pub theta: f64,
    /// Speed of crankshaft 1 [rad/s], where the criterion is judged at several: with gas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Its share of the proof: the multipliers of a criterion add up to its weight in the stage (to the shadow price of the
    /// limit for a limited one).
    pub multiplier: f64,
}

impl FoundStage {
    /// Whether several criteria are added, each as a share of the value given for it.
    pub fn is_weighted_sum(&self) -> bool {
        !matches!(self.term_weights[..], [1.0])
    }
}

/// On which side of its value a limit lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LimitSide {
    /// No more than the value.
    AtMost,
    /// No less than the value.
    AtLeast,
    /// The value itself.
    Given,
}

/// A limit of the answer.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FoundLimit {
    /// What is limited: a criterion, the largest, least or given amount of a weight, the largest inertia.
    pub what: String,
    /// Its criterion, if it is one.
    pub criterion: Option<Criterion>,
    /// On which side of its value it lies.
    pub side: LimitSide,
    /// SI unit of the limit and of what was reached.
    pub unit: String,
    /// The limit, in SI units.
    pub most: f64,
    /// What was reached.
    pub value: f64,
    /// Shadow price: how much the first stage that this limit holds up would fall if the limit were relaxed by one SI unit: a
    /// largest value made larger, a least one smaller, e.g. N per kg m; 0 for a limit that is not active. Of a given amount it is
    /// that of a smaller one, negative where a larger one helps. Of a choice that was searched for it is the price with that
    /// choice kept: devices used, places, directions of given and least amounts.
    pub price: f64,
    /// Unit of the price, such as `N per kg m`; `1 per N m` for a weighted sum; empty for a limit that is not active.
    pub price_unit: String,
    /// The stage that the price belongs to, by index.
    pub stage: Option<usize>,
}

/// A criterion before and after.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Effect {
    /// Which.
    pub criterion: Criterion,
    /// Without the free weights (those that they replace left out) [SI unit].
    pub without: f64,
    /// As the engine file stands [SI unit].
    pub before: f64,
    /// With the answer [SI unit].
    pub after: f64,
}
