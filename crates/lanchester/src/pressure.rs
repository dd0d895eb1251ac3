//! The gas of an engine for every room that asks for it: traces, cycles, over speed and in time.

pub(crate) mod cycles;
pub(crate) mod cylinders;
pub(crate) mod error;
pub(crate) mod measured;
pub(crate) mod over_speed;
pub(crate) mod simulated;

pub use cycles::cycle_results;
pub use cylinders::{ComputedCycle, CylinderCycle, GAS_REPORT_VERSION, GasReport, cylinder_gas, trace_names};
pub use error::GasError;
pub use measured::TraceFile;
pub use over_speed::optimised;
pub use simulated::GivenGas;
