//! Torque, work, cyclic speed fluctuation and flywheel.

pub(crate) mod figures;
pub(crate) mod section;
pub(crate) mod tables;

pub use figures::{power_figure, ripple_figure, torque_figures};
pub use section::{TorqueInput, torque_section};
pub use tables::{
    cylinder_work_table, firing_table, flywheel_table, power_table, ripple_table, ripple_words, stroke_table,
    torque_csv, torque_extremes_table, torque_orders_table, torque_speeds_table, torque_table, torque_text,
};
