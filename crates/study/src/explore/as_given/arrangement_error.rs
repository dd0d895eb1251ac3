//! Why the cylinders of an engine cannot stay where they are in a search.

use lanchester_mechanism::LoadError;
use lanchester_model::Ratio;

/// Why an engine makes no arrangement of cylinders that a search can keep.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ArrangementError {
    /// A geared crankshaft at another speed: its orders and its firings are not those of crankshaft 1.
    #[error(
        "crankshaft {crankshaft} must turn at the speed of crankshaft 1, with it or against it (ratio 1 or -1), got ratio {ratio}"
    )]
    Ratio {
        /// Number of the crankshaft, from 1.
        crankshaft: usize,
        /// Its ratio.
        ratio: Ratio,
    },
    /// A throw whose angle nothing is known to follow.
    #[error("every throw must drive a cylinder, got none on throw {throw}")]
    IdleThrow {
        /// Number of the throw, from 1.
        throw: usize,
    },
    /// Its linkages do not turn.
    #[error(transparent)]
    Load(#[from] LoadError),
}
