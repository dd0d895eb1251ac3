//! Engines side by side, as they are or as similar engines of one displacement or one power.

mod compared;
mod ranking;
mod similar;

pub use compared::{COMPARISON_VERSION, Compared, ComparedTorque, Comparison, Leading};
pub use ranking::{Criterion, Place, Ranking};
pub use similar::{Equal, Held, Similar, SimilarError};
