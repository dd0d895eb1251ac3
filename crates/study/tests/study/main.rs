//! All tests of the crate.

mod agreement;
mod known_layouts;
mod scatter;
mod search;
mod sensitivity;
mod sensitivity_outputs;
mod support;
mod symmetry;
