//! Why there is no cycle.

use lanchester_mechanism::LoadError;
use lanchester_results::CurveError;

/// Why there is no cycle.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CycleError {
    /// A linkage does not turn.
    #[error(transparent)]
    Linkage(#[from] LoadError),
    /// A pressure is no curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// Gas needs a bore.
    #[error("cylinder {cylinder} needs a bore\nhint: add bore = \"79.5 mm\" to [piston] or to the cylinder")]
    NoBore {
        /// Cylinder number, from 1.
        cylinder: usize,
    },
    /// A number is impossible.
    #[error("{quantity} must be {needed}, got {got}\nhint: {hint}")]
    Number {
        /// Which number, with its unit.
        quantity: &'static str,
        /// What is possible.
        needed: String,
        /// What it was.
        got: f64,
        /// What to do.
        hint: &'static str,
    },
    /// A single zone was asked for as an ideal cycle.
    #[error("a single zone is no ideal cycle\nhint: it is computed at a speed")]
    NotIdeal,
    /// An open valve meets the piston.
    #[error(
        "the {valve} valve meets the piston: they overlap by {overlap:.3} mm at {angle:.1} deg after firing top dead centre\nhint: less lift, other timing, or a deeper pocket (piston_clearance)"
    )]
    ValveMeetsPiston {
        /// Which.
        valve: &'static str,
        /// By how much [mm].
        overlap: f64,
        /// Where [deg].
        angle: f64,
    },
    /// The differential equations cannot be solved.
    #[error(
        "the cycle cannot be integrated beyond {angle:.3} deg: {reason}\nhint: check areas, pressures and speed"
    )]
    Integration {
        /// Where it began to fail [deg].
        angle: f64,
        /// What the solver says.
        reason: String,
    },
}
