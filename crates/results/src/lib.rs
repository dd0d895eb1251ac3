//! Neutral results: what every rung of the ladder and every study speaks of, in one vocabulary.
//!
//! An [`Output`] is a number of an engine: a quantity, of a part, over the cycle. Balancing, layouts, sensitivities and production
//! scatter name what they judge by it, and the words are the same everywhere.
//!
//! ```
//! use lanchester_results::{Output, Quantity, Size};
//!
//! let output: Output = "forward couple order 1/2".parse()?;
//! assert_eq!((output.quantity, output.size), (Quantity::Couple, Size::Order(0.5)));
//! assert_eq!(output.unit(), "N m");
//! assert_eq!(output.title(), "forward couple of order 0.5");
//! assert_eq!(output.to_string(), "forward couple order 1/2");
//! # Ok::<(), lanchester_results::OutputError>(())
//! ```
#![forbid(unsafe_code)]

mod output;
mod quantity;

pub use output::{Axis, Counted, LARGEST_ORDER, Output, OutputError, Place, Sense, Size, order_text};
pub use quantity::Quantity;
