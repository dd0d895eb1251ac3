//! Neutral results: what every rung of the ladder and every study returns and speaks of, in one vocabulary.
//!
//! Every rung returns its loads as a [`Trace`] over the crank angle, as two-sided [`OrderLoads`], with [`Extremes`]; functions of the angle, such as
//! pressures, are a [`PeriodicCurve`]; what runs over time is a [`Series`]. No rung imports another one for them.
//!
//! An [`Output`] is a number of an engine: a quantity, of a part, over the cycle. Balancing, layouts, sensitivities and production
//! scatter name what they judge by it, and the words are the same everywhere.
//!
//! ```
//! use lanchester_results::{Output, Quantity, Size};
//!
//! let output: Output = "forward couple order 0.5".parse()?;
//! assert_eq!((output.quantity, output.size), (Quantity::Couple, Size::Order(0.5)));
//! assert_eq!(output.unit(), "N m");
//! assert_eq!(output.title(), "forward couple of order 0.5");
//! assert_eq!(output.to_string(), "forward couple order 0.5");
//! # Ok::<(), lanchester_results::OutputError>(())
//! ```
#![forbid(unsafe_code)]

mod curve;
mod extreme;
mod loads;
mod order;
mod output;
mod quantity;
mod series;
mod spline;

pub use curve::{CurveError, CurveSamples, End, PeriodicCurve};
pub use extreme::{Extreme, Extremes};
pub use loads::{Components, LoadSet, OrderLoads, Peaks, Trace};
pub use order::{TwoSided, amplitude, coefficient};
pub use output::{Axis, Counted, LARGEST_ORDER, Output, OutputError, Place, Sense, Size, order_text};
pub use quantity::Quantity;
pub use series::{Series, values_of};
