//! The program as its user meets it: output, messages, exit status, files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod balance;
mod engine;
mod program;
mod search;
mod sweep;
