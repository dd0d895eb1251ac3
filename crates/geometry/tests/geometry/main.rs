//! All tests of the crate.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support {
    pub mod hand_made;
    pub mod random_chamfer;
    pub mod random_crank;
    pub mod random_design;
    pub mod random_part;
    pub mod random_web;
    pub mod sample_parts;
    pub mod step_reader;
}
mod clearance;
mod crank_elements;
mod crankshaft;
mod design;
mod drawing_bores;
mod drawing_dxf;
mod drawing_svg;
mod envelope;
mod evolution;
mod export_chamfer;
mod export_mesh;
mod export_samples;
mod export_step;
#[path = "../../../shape/tests/shape/support/random_outline.rs"]
mod random_outline;
mod shaft_solids;
mod shaft_weight;
