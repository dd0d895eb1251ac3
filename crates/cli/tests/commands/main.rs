//! The program as its user meets it: output, messages, exit status, files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bad_simulations;
mod bond_graph;
mod compare;
mod complete;
mod counterweight;
mod engine;
mod examples_in_help;
mod exit_status;
mod explore;
mod export_unit;
mod flexible;
mod long_runs;
mod mounts;
mod optima;
mod printed;
mod program;
mod scatter;
mod sensitivity;
mod shell;
mod simulate;
mod simulate_more;
mod studio;
mod torque;
mod torsion;
mod workshop;
mod written_files;
