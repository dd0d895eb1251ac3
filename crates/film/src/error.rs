//! Why a bearing or a film is refused.

use serde::Serialize;

/// What keeps a film from being computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[non_exhaustive]
pub enum FilmError {
    /// A number lies outside what is possible.
    #[error("{quantity} must be {needed}, got {got}")]
    Number {
        /// What it is, with its unit.
        quantity: &'static str,
        /// What it must be.
        needed: &'static str,
        /// What it is.
        got: f64,
    },
    /// The clearance does not belong to this radius.
    #[error(
        "the diametral clearance is {:.1} um on a journal diameter of {:.3} mm, a ratio of {:.2e}: needed is {:.0e} to {:.0e} (common: 1e-3)\n\
         hint: give diametral_clearance as the difference of the diameters, some {:.0} um here, and check its unit",
        clearance * 2e6, radius * 2e3, clearance / radius, range[0], range[1], radius * 2e3
    )]
    Clearance {
        /// Radial clearance [m].
        clearance: f64,
        /// Radius of the journal [m].
        radius: f64,
        /// Accepted range of their ratio.
        range: [f64; 2],
    },
    /// The viscosity is not that of a lubricant.
    #[error(
        "the viscosity is {viscosity} Pa s: needed is {} to {} Pa s (engine oil at work: 0.003 to 0.05)\nhint: a kinematic viscosity times the \
         density is the dynamic one: 1 cSt at 850 kg/m3 is 0.85 mPa s",
        range[0], range[1]
    )]
    Viscosity {
        /// As given [Pa s].
        viscosity: f64,
        /// Accepted range [Pa s].
        range: [f64; 2],
    },
    /// The journal touches or crosses the shell.
    #[error(
        "the eccentricity is {ratio:.6} of the clearance (tilt included), so the film has no thickness left: needed is below 1; \
         lower the load or the tilt, or raise the clearance or the viscosity"
    )]
    Eccentricity {
        /// Largest eccentricity over the length, over the radial clearance.
        ratio: f64,
    },
    /// Grooves or holes leave no land.
    #[error(
        "grooves and holes cover the whole shell, so that no film is left: give each a range of angles or a width below the bearing's length"
    )]
    NoLand,
    /// A film needs relative motion.
    #[error(
        "the mean speed of journal and shell is {speed} rad/s and the load has no period: a film needs a speed above 0 [rpm]"
    )]
    NoSpeed {
        /// Mean angular speed [rad/s].
        speed: f64,
    },
    /// The load history is too short.
    #[error("a load over one period needs at least {needed} equally spaced samples, got {got}")]
    Samples {
        /// Fewest.
        needed: usize,
        /// As given.
        got: usize,
    },
}

/// Refuses what is no finite number in a range.
pub(crate) fn require(
    holds: bool,
    quantity: &'static str,
    needed: &'static str,
    got: f64,
) -> Result<(), FilmError> {
    if holds && got.is_finite() { Ok(()) } else { Err(FilmError::Number { quantity, needed, got }) }
}

/// Refuses an eccentricity that leaves no film, or is no number.
pub(crate) fn require_film(ratio: f64) -> Result<(), FilmError> {
    if ratio.is_finite() && ratio < 1.0 { Ok(()) } else { Err(FilmError::Eccentricity { ratio }) }
}
