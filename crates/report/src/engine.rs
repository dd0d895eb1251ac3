//! The engine itself: its data and its drawings.

pub(crate) mod crank_strip;
pub(crate) mod crank_view;
pub(crate) mod drawing;
pub(crate) mod frame_sketch;
pub(crate) mod front_view;
pub(crate) mod inertias;
pub(crate) mod mechanism_sketch;
pub(crate) mod part_masses;
pub(crate) mod pose;
pub(crate) mod section;
pub(crate) mod side_view;
pub(crate) mod tables;

pub use crank_view::crank_view;
pub use drawing::drawing;
pub use frame_sketch::frame_sketch;
pub use front_view::front_view;
pub use inertias::inertia_table;
pub use part_masses::{PartMass, part_masses_table};
pub use section::engine_section;
pub use side_view::side_view;
pub use tables::{firing_order, main_data, masses_table, throws_table, weights_table};
