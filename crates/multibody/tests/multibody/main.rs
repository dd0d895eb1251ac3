//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod closed_form;
mod external;
mod extremes;
mod governor;
mod moving_block;
mod published;
mod referee;
mod runs;
mod squeezer;
mod stepper;
#[path = "../../../mechanism/tests/mechanism/support/mod.rs"]
mod support;
