//! Why a question of the workshop cannot be answered.

use lanchester_mechanism::LoadError;

/// A question of the workshop that has no meaning.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WorkshopError {
    /// The engine's own loads cannot be computed.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// A number is not possible.
    #[error("{quantity} of {part} must be {needed}, got {got}\nhint: {hint}")]
    Number {
        /// Which number, with its unit.
        quantity: &'static str,
        /// Whose.
        part: String,
        /// What is possible.
        needed: String,
        /// What was given.
        got: f64,
        /// What to do.
        hint: &'static str,
    },
    /// A throw, crankshaft or weight that is not there, or cannot be used so.
    #[error("{what}\nhint: {hint}")]
    Impossible {
        /// What was needed and what was got.
        what: String,
        /// What to do.
        hint: &'static str,
    },
    /// The sheet does not say something that is needed.
    #[error("{needed} is needed for {purpose}\nhint: {hint}")]
    Missing {
        /// What is missing.
        needed: String,
        /// What for.
        purpose: &'static str,
        /// What to add.
        hint: &'static str,
    },
}

impl WorkshopError {
    pub(crate) fn missing(
        needed: impl Into<String>,
        purpose: &'static str,
        hint: &'static str,
    ) -> WorkshopError {
        WorkshopError::Missing { needed: needed.into(), purpose, hint }
    }
}
