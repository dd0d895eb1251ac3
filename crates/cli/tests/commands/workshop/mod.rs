//! Balancing from measurements.

mod bad_runs;
mod crank;
