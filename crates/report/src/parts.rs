//! Counterweights, weights of balance shafts and the crankshaft as real parts.

pub(crate) mod clearance_plot;
pub(crate) mod counterweight_drawing;
pub(crate) mod counterweight_tables;
pub(crate) mod crankshaft_tables;
pub(crate) mod front_plot;
pub(crate) mod section;
pub(crate) mod shaft_weight_drawing;
pub(crate) mod shaft_weight_tables;

pub use clearance_plot::clearance_plot;
pub use counterweight_drawing::{DrawnCounterweight, counterweight_drawing};
pub use counterweight_tables::{
    DesignedShape, designed_dimensions_table, designed_properties_table, front_designs_table,
    nearest_limits_table, objective_name, objective_words,
};
pub use crankshaft_tables::{
    clearance_words, clearances_table, counterweight_parts_table, crank_body_words, crank_sections_table,
    obstacle_name,
};
pub use front_plot::front_plot;
pub use section::{CrankshaftInput, counterweight_drawings, crankshaft_section};
pub use shaft_weight_drawing::shaft_weight_drawings;
pub use shaft_weight_tables::{
    DesignedShaftShape, designed_shaft_weights_table, nearest_shaft_limits_table, shaft_aim_words,
    shaft_weight_parts_table, swept_overlap_words,
};
