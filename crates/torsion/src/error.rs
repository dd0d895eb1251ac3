//! Why a chain or a request is refused.

use serde::Serialize;

/// Something about a chain that no chain has: all that were found are given at once.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ChainFault {
    /// Which station or shaft: "station 3 (throw 2)".
    pub place: String,
    /// What was needed and what was got.
    pub what: String,
    /// What to do.
    pub remedy: String,
}

impl std::fmt::Display for ChainFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}\nhint: {}", self.place, self.what, self.remedy)
    }
}

/// Why torsional vibration is not computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TorsionError {
    /// The chain cannot be; all faults at once.
    #[error("no torsional chain: {}", joined(.0))]
    Chain(Vec<ChainFault>),
    /// The engine does not say enough; all that is lacking at once.
    #[error("torsional vibration needs more of the engine: {}", joined(.0))]
    Needs(Vec<ChainFault>),
    /// A number outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// What it is, with its unit.
        quantity: &'static str,
        /// What it must be.
        needed: &'static str,
        /// What it is.
        got: f64,
    },
    /// A torque acts on a station that is not there, or has another number of orders than the others.
    #[error("{what} must be {needed}, got {got}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// What it must be.
        needed: String,
        /// What it is.
        got: usize,
    },
    /// There is no damper to tune.
    #[error("there is no damper to tune\nhint: give [damper] with its ring_inertia")]
    NoDamper,
    /// A periodic motion was not found.
    #[error(
        "no periodic motion at {:.1} rpm: {why}\nhint: above a strong resonance the motion may have no period of one cycle; take another speed, or more damping",
        .speed * 30.0 / std::f64::consts::PI
    )]
    NotPeriodic {
        /// Mean speed [rad/s].
        speed: f64,
        /// What failed.
        why: String,
    },
}

fn joined(faults: &[ChainFault]) -> String {
    faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}
