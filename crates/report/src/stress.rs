//! The flexible crankshaft: static stress, natural modes.

pub(crate) mod body;
pub(crate) mod modes;
pub(crate) mod statics;

pub use body::{CrankSheet, StressMaterial};
pub use modes::{CrankModes, MODES_VERSION, modes_csv, modes_text};
pub use statics::{
    PinForces, STATIC_STRESS_VERSION, StaticStress, StressCase, static_stress_csv, static_stress_text,
};
