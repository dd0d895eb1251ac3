//! The program as its user meets it: output, messages, exit status, files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bad_runs;
mod balance;
mod balance_speeds;
mod bond_graph;
mod compare;
mod consequences;
mod counterweight;
mod crank_workshop;
mod damaged_runs;
mod engine;
mod exit_status;
mod explore;
mod flexible;
mod methods;
mod mounts;
mod program;
mod runs;
mod scatter;
mod scatter_runs;
mod search;
mod search_limits;
mod sensitivity;
mod shaft_weights;
mod simulate;
mod studio;
mod sweep;
mod torque;
mod written_files;
