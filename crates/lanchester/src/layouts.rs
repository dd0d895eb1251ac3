//! Layouts of the engine of a file: the space of a search, its rows, what is adopted.

pub(crate) mod films;
pub(crate) mod kept_cylinders;
pub(crate) mod own;
pub(crate) mod search;
pub(crate) mod space;
pub(crate) mod study;

pub use films::layout_meter;
pub use search::{LayoutSearchError, adopted_layout, given_engine, layout_name};
pub use space::{LayoutChoices, LayoutSize, LayoutSpace, LayoutSpaceError, layout_space, own_pattern};
pub use study::{LayoutRows, LayoutStudy, SavedSearch};
