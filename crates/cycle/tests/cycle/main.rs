//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod balance;
mod ideal;
mod support;
mod torque;
mod trace;
mod zone;
