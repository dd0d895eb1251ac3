//! Sensitivities: what matters most for loads, torque, bearings and mounts.
//!
//! [`sensitivity`] gives the exact derivatives of peaks, means and orders by every number of the engine, the outputs at both ends of the
//! range of each, and which part of the variance over all ranges comes from which.

mod bending;
mod derivative;
mod energy;
mod error;
mod follow;
mod gas_force;
mod input;
mod mains;
mod mount_force;
mod operating_point;
mod output;
mod output_name;
mod over_time;
mod pin_force;
mod prepared;
mod quantity;
mod ripple;
mod slope;
mod sobol;
mod stretch;
mod study;
mod train;
mod value;
mod wave;

pub use derivative::derivatives;
pub use error::SensitivityError;
pub use follow::Weights;
pub use input::{Amount, Input};
pub use operating_point::OperatingPoint;
pub use output::{Needs, Output, Size, Target};
pub use quantity::{Axis, Direction, Measure, Quantity};
pub use slope::Slope;
pub use sobol::{Index, Sobol};
pub use study::{
    Effect, OutputSensitivity, SENSITIVITY_VERSION, Sensitivity, SensitivityRequest, VariedInput,
    sensitivity, sensitivity_watched,
};
