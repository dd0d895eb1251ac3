//! Why a search is refused.

use crate::explore::choice::Choice;
use lanchester_mechanism::LoadError;

/// Why a search is refused, or stopped.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExploreError {
    /// A number lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// Which number.
        quantity: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was asked for.
        got: f64,
    },
    /// A choice without a value leaves no case.
    #[error("the search space is empty: {} has no value\nhint: give at least one value", choice.name())]
    EmptyChoice {
        /// The choice.
        choice: Choice,
    },
    /// A choice has the same value twice: every case would count twice.
    #[error("{} has the value at place {place} twice\nhint: leave one of them out", choice.name())]
    RepeatedValue {
        /// The choice.
        choice: Choice,
        /// Place of the second of them in the list, from 1.
        place: usize,
    },
    /// The number of cylinders does not fit the banks.
    #[error("{banks} banks need a multiple of {banks} cylinders, from {banks} to {most}, got {got}")]
    Cylinders {
        /// Banks.
        banks: usize,
        /// Most cylinders.
        most: usize,
        /// Cylinders asked for.
        got: usize,
    },
    /// A counterweight pattern names more or fewer webs than the crank has.
    #[error(
        "counterweight pattern {place} must say for each of the {needed} webs whether it has a weight, got {got}"
    )]
    Webs {
        /// Place of the pattern in its list, from 1.
        place: usize,
        /// Webs of the crank.
        needed: usize,
        /// Webs in the pattern.
        got: usize,
    },
    /// More cases than may be looked at.
    #[error(
        "the search space has {size} cases, more than the {most} that may be looked at: {} alone makes {count} of \
         them\nhint: give that choice fewer values, or allow more cases", choice.name()
    )]
    TooLarge {
        /// Number of cases: exact up to 3.4e38, else a power of ten.
        size: String,
        /// Most cases allowed.
        most: u128,
        /// The choice with the most values.
        choice: Choice,
        /// Its number of values.
        count: String,
    },
    /// Nothing to judge by.
    #[error("a search needs at least one objective, got none")]
    NoObjective,
    /// An objective or constraint about firing where firing is not part of the search.
    #[error("{what} needs the firing orders in the search space\nhint: let the space include them")]
    FiringLeftOut {
        /// The objective or constraint in words.
        what: String,
    },
    /// A constraint on sizes that the search leaves as they are.
    #[error(
        "{what} needs pins and planes that are searched, and {engine} keeps its own in all layouts\nhint: leave this \
         constraint out"
    )]
    FixedPins {
        /// The constraint in words.
        what: String,
        /// Name of the engine.
        engine: String,
    },
    /// More Pareto-optimal layouts than are kept.
    #[error(
        "more than {most} layouts are on the front\nhint: ask for fewer objectives or a coarser resolution, or allow \
         a larger front"
    )]
    FrontTooLarge {
        /// Most that are kept.
        most: usize,
    },
    /// A case number beyond the space.
    #[error("the cases are numbered from 0 to {last}, got {got}")]
    NoSuchCase {
        /// Last case.
        last: u128,
        /// Number asked for.
        got: u128,
    },
    /// Part `k` of `n` with `k` not from 1 to `n`.
    #[error("part must be from 1 to the number of parts, got {part} of {parts}")]
    Part {
        /// Part asked for.
        part: u64,
        /// Number of parts.
        parts: u64,
    },
    /// Results of another search, or of the same cases twice.
    #[error("these results cannot be merged: {reason}")]
    Merge {
        /// Why.
        reason: &'static str,
    },
    /// More layouts whose films or safeties would have to be computed than may be.
    #[error(
        "films and safeties of more than {most} layouts would have to be computed\nhint: search a smaller space, ask for other limits first, or allow more"
    )]
    TooManyMeasured {
        /// Most that may be measured.
        most: u64,
    },
    /// A limit on films or safeties where nobody tells them.
    #[error(
        "a limit on oil films or safeties needs the engine whose bearings the layouts have, got a search without one"
    )]
    NoMeter,
    /// The parts make no engine whose loads can be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
}
