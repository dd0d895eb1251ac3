//! Why an engine has no torsional vibration.

use crate::pressure::error::GasError;
use lanchester_mechanism::TorqueError;
use lanchester_torsion::TorsionError;

/// Why there is no torsional vibration.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EngineTorsionError {
    /// The chain, or a number.
    #[error(transparent)]
    Torsion(#[from] TorsionError),
    /// No pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// No torque from them.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// A highest order out of range.
    #[error("the highest order must lie between 1 and 60, got {got}")]
    Order {
        /// As given.
        got: f64,
    },
    /// Torques of several crankshafts that repeat only after very long.
    #[error(
        "the torques of the crankshafts repeat only after more than {most} revolutions\nhint: use ratios with common denominators"
    )]
    Period {
        /// Most revolutions.
        most: u32,
    },
    /// Speeds that do not rise.
    #[error("the speeds must be above 0 and rise, got {got} rad/s after {before} rad/s")]
    Speeds {
        /// A speed.
        got: f64,
        /// The one before it.
        before: f64,
    },
}
