//! Elements, meshes, solutions and decks of flexible crankshafts.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod benchmarks;
mod calculix;
mod calculix_crank;
mod carried;
mod crank;
mod crank_circles;
mod crank_kinds;
mod crank_parts;
mod elements;
mod films;
mod own_mesh;
mod reduction;
mod rings;
mod springs;
mod stepped_shaft;
mod submodel;
mod train;
