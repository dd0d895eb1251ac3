//! The engine file: from TOML text to a validated, immutable [`Engine`] in SI units.
#![forbid(unsafe_code)]

mod engine;
mod firing;
mod layout;
mod ratio;

pub use engine::*;
pub use ratio::Ratio;
