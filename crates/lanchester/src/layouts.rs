//! Layouts of the engine of a file: the space of a search, its rows, what is adopted.

pub(crate) mod choices;
pub(crate) mod films;
pub(crate) mod kept_cylinders;
pub(crate) mod layout_parts;
pub(crate) mod own;
pub(crate) mod search;
pub(crate) mod space;
pub(crate) mod space_error;
pub(crate) mod study;

pub use choices::{LayoutChoices, own_pattern};
pub use films::layout_meter;
pub use search::{LayoutSearchError, adopted_layout, given_engine, layout_name};
pub use space::{LayoutSpace, layout_space};
pub use space_error::{LayoutSize, LayoutSpaceError};
pub use study::{LayoutRows, LayoutStudy, SavedSearch};
