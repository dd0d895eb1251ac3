//! How a run ended, and what it cost.

use serde::{Deserialize, Serialize};

/// How a run ended. `t` and `y` of the run hold the last good state in every case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Outcome {
    /// The end was reached.
    Reached,
    /// An event function changed its sign; the state is the one just behind it.
    Event {
        /// Which event function.
        index: usize,
        /// Whether it became positive.
        rising: bool,
    },
    /// The observer asked to stop.
    Stopped,
    /// As many evaluations as are allowed.
    TooManyEvaluations {
        /// The limit.
        limit: u64,
    },
    /// The error cannot be met by any step that the machine can tell from zero: a singularity or a jump.
    StepTooSmall {
        /// The step that was tried last.
        step: f64,
    },
    /// A derivative is no finite number, however short the step.
    NotFinite {
        /// The first such component.
        component: usize,
    },
    /// The problem is stiff: steps are bounded by stability, not by accuracy. Only where the settings ask for the test.
    Stiff {
        /// Step times measured spectral radius.
        step_times_rate: f64,
    },
    /// Newton's iteration has no regular matrix, however short the step: the mass matrix and the Jacobian are singular together.
    Singular,
}

/// What runs have cost so far.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of `f`, those for differences included.
    pub evaluations: u64,
    /// Jacobians.
    pub jacobians: u64,
    /// Factorisations of Newton's matrices.
    pub factorisations: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Located events.
    pub events: u64,
}
