//! What the tests of several crates share: comparisons that say why their tolerance, engines of the gallery, made by hand and drawn at
//! random. For tests alone: no crate depends on it but for its tests.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod close;
#[cfg(feature = "engines")]
pub mod gallery;
#[cfg(feature = "engines")]
pub mod hand_made;
#[cfg(feature = "engines")]
pub mod random;

pub use close::{Number, Within, assert_close, close};
