//! The engine as a bond graph: its drawing, causality, equations, energy and curves.

pub(crate) mod figures;
pub(crate) mod picture;
pub(crate) mod section;

pub use figures::bond_graph_figures;
pub use section::{BOND_GRAPH_VERSION, BondGraphResult, bond_graph_section, causality_tables};
