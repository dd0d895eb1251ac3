//! The flywheel: the file's `[flywheel]`.

use serde::Serialize;

/// What turns with crankshaft 1 beside the crank train, and how evenly it is to turn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Flywheel {
    /// Moment of inertia about the crank axis, clutch and all that turns rigidly with crankshaft 1 included [kg m^2].
    pub inertia: Option<f64>,
    /// Inertia of the crankshafts with their counterweights, as seen at crankshaft 1, without rods [kg m^2]; `None`: that of the
    /// crank's body, where the file gives one.
    pub crankshaft_inertia: Option<f64>,
    /// Fluctuation that is allowed, `(w_max - w_min) / w_mean` [1], between 0 and 2.
    pub fluctuation: Option<f64>,
    /// Speeds of crankshaft 1 [rad/s] at which the ripple is listed and the fluctuation is to be kept; empty: the lowest and the
    /// highest speed of the engine, the fluctuation at the lowest.
    pub speeds: Vec<f64>,
}
