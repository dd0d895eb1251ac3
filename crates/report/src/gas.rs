//! The gas in the cylinders over the cycle.

pub(crate) mod result;
pub(crate) mod tables;

pub use result::{CYCLE_RESULT_VERSION, CycleResult, CycleTrace, ExchangeResult};
pub use tables::{cycle_angle_table, cycle_figures, cycle_table};
