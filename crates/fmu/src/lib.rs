//! The binary within the functional mock-up units that Lanchester exports (FMI 2.0 and 3.0, co-simulation).
//!
//! One library serves both standards, both models and every engine: it reads the engine file among the resources of its unit by the ordinary reader and
//! computes [`loads`] by the ordinary closed form, or the [`crank_train`] at free speed by the ordinary simulation. [`instance`] is a model that is stepped
//! through, in safe Rust; [`fmi2`] and [`fmi3`] are the functions that the standards ask for, by their C names; [`handle`] is all that is between.
//!
//! Nothing that a program calls may end it: every function answers bad pointers, bad order, bad numbers and panics with the error status
//! of its standard, and says why through the logger that it was handed.

pub mod crank_train;
pub mod fmi2;
pub mod fmi3;
pub mod handle;
pub mod instance;
pub mod loads;
pub mod phase;
pub mod unit;
