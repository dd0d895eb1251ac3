//! All tests of the crate.

mod chamber;
#[path = "../../../../fuzz/checks.rs"]
mod checks;
mod clearance;
mod corpus;
mod main_loads_with_gas;
mod optima;
mod pressure;
mod scene;
mod web_shapes;
mod what_fits;
