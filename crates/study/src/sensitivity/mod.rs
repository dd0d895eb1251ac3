//! Sensitivities: what matters most for the residual loads.
//!
//! [`sensitivity`] gives the exact derivatives of peaks and orders by every number of the engine, the outputs at both ends of the range
//! of each, and which part of the variance over all ranges comes from which.

mod derivative;
mod error;
mod input;
mod jet;
mod output;
mod sobol;
mod study;
mod train;

pub use derivative::{Slope, derivatives};
pub use error::SensitivityError;
pub use input::{Input, Measure, Quantity};
pub use output::{BlockLoad, Output};
pub use sobol::{Index, Sobol};
pub use study::{
    Amount, Effect, OutputSensitivity, SENSITIVITY_VERSION, Sensitivity, SensitivityRequest, VariedInput,
    sensitivity,
};
