//! Results as tables, plots and pages: pure functions from data to text.
//!
//! Nothing here opens a file, asks the time or prints. Figures are SVG of our own (decision record 10): one
//! figure is a string that works in a page and as a file of its own, light and dark.
#![forbid(unsafe_code)]

mod arrangement;
mod arrangements_page;
mod assignment;
mod axis;
mod balance_plot;
mod balance_share;
mod balance_tables;
mod balance_text;
mod bearing_tables;
mod bearings_section;
mod before_after;
mod cancellation;
mod clearance_plot;
mod comparison;
mod component;
mod consequence_figures;
mod consequence_tables;
mod consequence_text;
mod counterweight_drawing;
mod counterweight_tables;
mod crank_curve;
mod crank_strip;
mod crank_view;
mod crankshaft_section;
mod crankshaft_tables;
mod crosscheck;
mod csv;
mod cycle_result;
mod cycle_tables;
mod dimension;
mod drawing;
mod energy_flow;
mod engine_tables;
mod figure;
mod findings_table;
mod frame_sketch;
mod front_plot;
mod front_view;
mod gallery;
mod give_up_text;
mod hodograph;
mod internal_figure;
mod internal_noise;
mod internal_tables;
mod layout_front;
mod layout_front_plot;
mod load_tables;
mod magnitude;
mod mechanism_sketch;
mod motion_plot;
mod mount_figures;
mod mount_shapes;
mod mount_tables;
mod mount_text;
mod number;
mod optimum_section;
mod over_angle;
mod page;
mod part_masses;
mod part_sheet;
mod plot;
mod polar;
mod pose;
mod published_tables;
mod published_text;
mod robust_text;
#[cfg(test)]
mod sample;
mod scatter_figures;
mod scatter_tables;
mod sensitivity_tables;
mod shaft_weight_drawing;
mod shaft_weight_tables;
mod share_plot;
mod side_view;
mod simulated_orders;
mod simulation;
mod simulation_section;
mod spectrum;
mod speed_table;
mod star;
mod story;
mod svg;
mod swept_text;
mod table;
mod terminal;
mod tornado;
mod torque_figures;
mod torque_section;
mod torque_tables;
mod view;
pub mod workshop;
mod xy_plot;

pub use arrangement::{
    arrangement_figure, arrangement_parts, arrangements_text, drive_sketches, front_table, narrowest_place,
};
pub use arrangements_page::{ArrangementResult, ArrangementsInput, arrangements_report};
pub use assignment::{assignment_table, assignment_text};
pub use balance_plot::optimum_figures;
pub use balance_tables::{
    effects_table, found_inertias_table, found_shafts_table, found_weights_table, limits_table, stages_table,
    web_bounds_table,
};
pub use balance_text::{balance_text, equals_words, headline, search_state_words};
pub use bearing_tables::{
    BearingSizes, bearing_figures, bearing_parts_table, bearings_csv, bearings_text, main_bearings_table,
    rod_bearings_tables,
};
pub use bearings_section::{BearingsInput, bearings_section_figures};
pub use cancellation::{cancellation_proof_table, cancelled_orders_table};
pub use clearance_plot::clearance_plot;
pub use comparison::{
    comparison_figure, comparison_table, comparison_text, equal_words, ranking_words, relative_table,
};
pub use consequence_figures::consequence_figures;
pub use consequence_tables::consequences_table;
pub use consequence_text::consequence_words;
pub use counterweight_drawing::{DrawnCounterweight, counterweight_drawing};
pub use counterweight_tables::{
    DesignedShape, designed_dimensions_table, designed_properties_table, front_designs_table,
    nearest_limits_table, objective_name, objective_words,
};
pub use crank_curve::crank_curve;
pub use crank_view::crank_view;
pub use crankshaft_section::{CrankshaftInput, counterweight_drawings};
pub use crankshaft_tables::{
    clearance_words, clearances_table, counterweight_parts_table, crank_body_words, crank_sections_table,
    obstacle_name,
};
pub use crosscheck::*;
pub use csv::{motion_csv, orders_csv, trace_csv};
pub use cycle_result::{CYCLE_RESULT_VERSION, CycleResult, CycleTrace, ExchangeResult};
pub use cycle_tables::{cycle_angle_table, cycle_figures, cycle_table};
pub use drawing::drawing;
pub use engine_tables::{firing_order, main_data, masses_table, throws_table, weights_table};
pub use figure::{Figure, Panel};
pub use findings_table::findings_table;
pub use frame_sketch::frame_sketch;
pub use front_plot::front_plot;
pub use front_view::front_view;
pub use hodograph::{couple_hodograph, force_hodograph};
pub use internal_figure::internal_figures;
pub use internal_tables::{internal_csv, internal_table, internal_text, mains_table};
pub use layout_front::{layout_front_table, layout_ranking_table, layout_search_text, layout_search_words};
pub use layout_front_plot::layout_front_figure;
pub use load_tables::{
    articulation_table, couple_orders_table, cylinders_table, force_orders_table, motion_table, parts_table,
    peaks_table, rod_inertia_table, roll_orders_table,
};
pub use motion_plot::motion_plot;
pub use mount_figures::mount_figures;
pub use mount_tables::{
    damped_modes_table, mount_axes_words, mount_modes_table, mount_orders_tables, mount_speeds_table,
    mount_tables, mounted_body_words, mounts_at_rest_table,
};
pub use mount_text::{mount_forces_csv, mount_modes_csv, mount_motion_csv, mount_remarks, mounts_text};
pub use optimum_section::OptimumInput;
pub use over_angle::{over_angle, vanishing};
pub use page::{Provenance, ReportInput, figures, report};
pub use part_masses::{PartMass, part_masses_table};
pub use published_tables::{
    equilibrium_table, method_effects_table, method_numbers_table, method_orders_table, method_weights_table,
};
pub use published_text::method_text;
pub use robust_text::robust_text;
pub use scatter_figures::scatter_figure;
pub use scatter_tables::{
    scatter_limit_table, scatter_table, scatter_text, tighten_words, tolerance_name, tolerance_table,
};
pub use sensitivity_tables::{
    input_name, measure_unit, sensitivity_csv, sensitivity_tables, sensitivity_text,
};
pub use shaft_weight_drawing::shaft_weight_drawings;
pub use shaft_weight_tables::{
    DesignedShaftShape, designed_shaft_weights_table, nearest_shaft_limits_table, shaft_aim_words,
    shaft_weight_parts_table, swept_overlap_words,
};
pub use share_plot::share_plots;
pub use side_view::side_view;
pub use simulated_orders::{SimulatedOrder, simulation_orders_csv};
pub use simulation::*;
pub use simulation_section::simulation_figures;
pub use spectrum::{couple_spectrum, force_spectrum, roll_spectrum};
pub use speed_table::speed_table;
pub use star::{couple_stars, force_stars};
pub use story::{Told, story};
pub use swept_text::{sweep_steps_table, swept_table, swept_text};
pub use table::{Cell, Column, Table, csv_text};
pub use terminal::loads_text;
pub use tornado::tornado_figure;
pub use torque_figures::{power_figure, ripple_figure, torque_figures};
pub use torque_section::{TorqueInput, torque_section_figures};
pub use torque_tables::{
    cylinder_work_table, firing_table, flywheel_table, power_table, ripple_table, ripple_words, stroke_table,
    torque_csv, torque_extremes_table, torque_orders_table, torque_speeds_table, torque_table, torque_text,
};
