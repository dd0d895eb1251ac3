//! Why a balancing question cannot be answered.

use lanchester_mechanism::{LoadError, MountError, TorqueError};
use lanchester_model::Fault;

/// A question that has no meaning for this engine. A limit that nobody can reach is an [`crate::Outcome`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BalanceError {
    /// The engine's own loads cannot be computed.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// The block on its mounts cannot be computed.
    #[error(transparent)]
    Mounts(#[from] MountError),
    /// The loads of the main bearings cannot be computed.
    #[error(transparent)]
    Bearings(#[from] TorqueError),
    /// The pressures of the cylinders cannot be had.
    #[error("{reason}")]
    Gas {
        /// Why.
        reason: String,
    },
    /// Two free weights act in exactly the same way.
    #[error(
        "weights `{first}` and `{second}` act alike: same plane, axis and speed\nhint: leave one out, or tie them"
    )]
    Alike {
        /// Name of one.
        first: String,
        /// Name of the other.
        second: String,
    },
    /// Added mass is asked for, but a weight has no radius.
    #[error(
        "added mass needs the radius of every free weight, and `{weight}` has none\nhint: give its radius, or ask for added unbalance"
    )]
    NoRadius {
        /// Name of the weight.
        weight: String,
    },
    /// A criterion needs something that the engine file does not give.
    #[error("{criterion} needs {needed}\nhint: {hint}")]
    Missing {
        /// Which criterion.
        criterion: String,
        /// What it needs.
        needed: &'static str,
        /// What to do.
        hint: &'static str,
    },
    /// A choice that cannot be searched without a bound on the amount.
    #[error(
        "`{device}` has a free position or may be left out, so it needs a largest amount\nhint: give `most`"
    )]
    Unbounded {
        /// Name of the weight or shaft.
        device: String,
    },
    /// Two inertias at once: only the sum of what they do counts.
    #[error(
        "one counter-rotating inertia can be used at a time, and `{second}` is a second one\nhint: leave one out, or make them optional"
    )]
    OneInertia {
        /// Name of the second.
        second: String,
    },
    /// A number of the task is not possible.
    #[error("{quantity} of `{device}` must be {needed}, got {got}")]
    Number {
        /// Which number.
        quantity: &'static str,
        /// Whose.
        device: String,
        /// What is possible.
        needed: &'static str,
        /// What was given.
        got: f64,
    },
    /// A published method does not know such an engine.
    #[error("{method} needs {needed}, got {got}\nhint: {hint}")]
    Unsuited {
        /// Which method.
        method: &'static str,
        /// What it needs.
        needed: &'static str,
        /// What the engine or the choice is.
        got: String,
        /// What to do.
        hint: &'static str,
    },
    /// A setting of the search is outside its range.
    #[error("the {setting} must be {needed}, got {got}")]
    Setting {
        /// Which setting.
        setting: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was given.
        got: f64,
    },
    /// What is to be judged is no engine.
    #[error(transparent)]
    Engine(Fault),
    /// Whoever asked said that the answer is not wanted any more ([`crate::Next::Abandon`]).
    #[error("the search was cancelled\nhint: ask again for the whole of it")]
    BrokenOff,
}

impl BalanceError {
    /// The first of the faults of parts that make no valid engine.
    pub fn engine(faults: Vec<Fault>) -> BalanceError {
        BalanceError::Engine(Fault::first_of(faults))
    }
}

/// A criterion without what it needs.
pub(crate) fn missing(criterion: &str, needed: &'static str, hint: &'static str) -> BalanceError {
    BalanceError::Missing { criterion: criterion.to_string(), needed, hint }
}
