//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support {
    pub mod written;
}
mod any_file;
mod bad;
mod balance;
mod crank_body;
mod edit;
mod engines;
mod examples;
mod mounts;
mod parts;
mod schema;
mod shaft_parts;
mod simulation;
mod stress;
mod write_back;
