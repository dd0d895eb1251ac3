//! The engine as a bond graph: its drawing, causality, equations, energy and curves.

pub(crate) mod picture;
pub(crate) mod section;

pub use section::{BOND_GRAPH_VERSION, BondGraphResult, bond_graph_section};
