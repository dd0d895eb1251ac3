//! Why sensitivities are refused.

use lanchester_mechanism::LoadError;

/// Why sensitivities are refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SensitivityError {
    /// Nothing is asked for.
    #[error("a sensitivity needs at least one output, got none")]
    NoOutput,
    /// Nothing varies.
    #[error("nothing varies\nhint: name a quantity that the engine has, such as piston mass")]
    NoInput,
    /// A quantity that the engine does not have.
    #[error("the engine has no {quantity}\nhint: leave it out")]
    NoSuchPart {
        /// Its name.
        quantity: &'static str,
    },
    /// A share of nothing, or of sizes that differ.
    #[error(
        "the {quantity} has no size of which a share could be taken: it is 0, or differs from part to part\nhint: say how far it goes with its unit, or let each part vary by itself"
    )]
    NoSize {
        /// Its name.
        quantity: &'static str,
    },
    /// An amount that is none.
    #[error("the {quantity} must vary by a finite amount above 0, got {got}")]
    Amount {
        /// Its name.
        quantity: &'static str,
        /// The amount.
        got: f64,
    },
    /// Too few or too many draws.
    #[error("shares of the variance need from 16 to 10 000 000 draws, got {got}")]
    Samples {
        /// How many.
        got: u64,
    },
    /// Ranges without an engine.
    #[error(
        "no draw from the ranges is an engine: rods would be too short, or masses below nothing\nhint: make the ranges smaller"
    )]
    NoEngine,
    /// The loads cannot be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
}
