//! What moves: linkages, the crank train at one speed, dead centres, order coefficients of the motion.

pub(crate) mod chamber;
pub(crate) mod drive;
pub(crate) mod linkage;
pub(crate) mod mechanism;
pub(crate) mod motion;
pub(crate) mod rod_place;
pub(crate) mod sampling;
pub(crate) mod series;
pub(crate) mod turned;

pub use mechanism::{Mechanism, Selection, firing_period};
pub use motion::motion;
pub use rod_place::{RodLinkage, RodPlace, RodReach};
pub use series::{exact_coefficients, series_coefficients};
