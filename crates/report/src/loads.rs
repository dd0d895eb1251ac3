//! Shaking forces and moments: orders, peaks, parts, and how they come about.

pub(crate) mod component;
pub(crate) mod findings;
pub(crate) mod hodograph;
pub(crate) mod motion_plot;
pub(crate) mod over_angle;
pub(crate) mod sections;
pub(crate) mod share;
pub(crate) mod share_plot;
pub(crate) mod spectrum;
pub(crate) mod speed_table;
pub(crate) mod star;
pub(crate) mod story;
pub(crate) mod tables;
pub(crate) mod text;

pub use findings::findings_table;
pub use hodograph::{couple_hodograph, force_hodograph};
pub use motion_plot::motion_plot;
pub use over_angle::{over_angle, vanishing};
pub use sections::{loads_sections, motion_section};
pub use share_plot::share_plots;
pub use spectrum::{couple_spectrum, force_spectrum, roll_spectrum};
pub use speed_table::speed_table;
pub use star::{couple_stars, force_stars};
pub use story::{Told, story};
pub use tables::{
    articulation_table, couple_orders_table, cylinders_table, force_orders_table, motion_table, parts_table,
    peaks_in_short, peaks_table, rod_inertia_table, roll_orders_table,
};
pub use text::loads_text;
