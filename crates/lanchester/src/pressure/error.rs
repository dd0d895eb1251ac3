//! Why an engine has no pressures.

use lanchester_cycle::{CycleError, TraceError};
use lanchester_results::CurveError;

/// Why there are no pressures.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GasError {
    /// The engine file says nothing of gas.
    #[error("the engine file says nothing of the gas\nhint: add [gas] with [[gas.trace]] or [gas.cycle]")]
    NoGas,
    /// A speed at which nothing turns.
    #[error("gas needs a speed above 0, got {got} rad/s")]
    Speed {
        /// The speed [rad/s].
        got: f64,
    },
    /// A file that the engine file names was not given.
    #[error("the pressures of {name} are missing\nhint: [gas] names this file")]
    MissingTrace {
        /// Its name.
        name: String,
    },
    /// A file of pressures is refused.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The cycle cannot be.
    #[error(transparent)]
    Cycle(#[from] CycleError),
}

impl From<CurveError> for GasError {
    fn from(error: CurveError) -> GasError {
        GasError::Cycle(error.into())
    }
}
