//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod branch;
mod cancellation;
mod consequences;
mod durable;
mod optimum;
mod which_arrangement;
