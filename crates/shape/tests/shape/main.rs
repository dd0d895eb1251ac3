//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support {
    pub mod random_outline;
    pub mod strips;
}
mod counterweight_shape;
mod outline;
mod part;
mod shaft_weight_shape;
mod union;
