//! Functions of the crank angle: in cubic pieces, and what is read off them: extremes, peaks, means, envelopes.

pub(crate) mod curve;
pub(crate) mod envelope;
pub(crate) mod extreme;
pub(crate) mod extremes;
pub(crate) mod lanes;
pub(crate) mod spline;
pub(crate) mod true_mean;
pub(crate) mod true_peak;

pub use curve::{CurveError, End, PeriodicCurve};
pub use extreme::{Extreme, Extremes};
