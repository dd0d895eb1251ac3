//! Arrangements and layouts: what a search over them found.

pub(crate) mod arrangement;
pub(crate) mod front;
pub(crate) mod front_plot;
pub(crate) mod page;

pub use arrangement::{
    arrangement_figure, arrangement_parts, arrangements_text, drive_sketches, front_table, narrowest_place,
};
pub use front::{layout_front_table, layout_ranking_table, layout_search_text, layout_search_words};
pub use front_plot::layout_front_figure;
pub use page::{ArrangementResult, ArrangementsInput, arrangements_report};
