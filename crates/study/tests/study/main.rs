//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod agreement;
mod as_given;
mod durability;
mod known_layouts;
mod scatter;
mod scatter_layouts;
mod search;
mod sensitivity;
mod sensitivity_outputs;
mod support;
mod symmetry;
