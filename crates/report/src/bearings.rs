//! Loads of pistons, pins and bearings, and what bends the crankshaft.

pub(crate) mod bending;
pub(crate) mod film_figures;
pub(crate) mod film_map;
pub(crate) mod film_name;
pub(crate) mod films;
pub(crate) mod internal_figure;
pub(crate) mod internal_noise;
pub(crate) mod internal_tables;
pub(crate) mod section;
pub(crate) mod tables;

pub use bending::bending_section;
pub use film_figures::{film_figures, films_over_speed_figure};
pub use films::{
    FilmsInput, films_csv, films_over_speed_table, films_section, films_table, films_text, shaft_runs_table,
};
pub use internal_figure::internal_figures;
pub use internal_tables::{internal_csv, internal_table, internal_text, mains_table};
pub use section::{BearingsInput, bearings_section};
pub use tables::{
    BearingSizes, bearing_figures, bearing_parts_table, bearings_csv, bearings_text, main_bearings_table,
    rod_bearings_tables,
};
