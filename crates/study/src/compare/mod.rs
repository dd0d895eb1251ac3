//! Engines side by side, as they are or as similar engines of one displacement or one power.

mod compared;
mod comparison;
mod ranking;
mod similar;

pub use compared::{Compared, ComparedTorque, Leading};
pub use comparison::{COMPARISON_VERSION, Comparison};
pub use ranking::{Criterion, Place, Ranking};
pub use similar::{Equal, Held, Similar, SimilarError};
