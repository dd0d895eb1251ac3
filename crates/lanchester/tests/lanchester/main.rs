//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bearing_films;
mod bond_graph_changes;
mod bond_graph_engine;
mod bond_graph_joints;
mod bond_graph_periodic;
mod chamber;
#[path = "../../../../fuzz/checks.rs"]
mod checks;
mod clearance;
mod corpus;
mod crank_cycle;
mod crank_train_unit;
mod crankshaft;
mod crosscheck;
mod crosscheck_layouts;
mod durability;
mod gallery;
mod graph_report;
mod main_loads_with_gas;
mod mounts_with_gas;
mod optima;
mod pressure;
mod scene;
mod simulated_runs;
mod torsion;
mod web_shapes;
mod what_fits;
