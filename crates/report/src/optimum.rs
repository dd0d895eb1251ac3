//! What balancing found, its proof, and what it does to the engine.

pub(crate) mod assignment;
pub(crate) mod before_after;
pub(crate) mod cancellation;
pub(crate) mod consequence_figures;
pub(crate) mod consequence_tables;
pub(crate) mod consequence_text;
pub(crate) mod durable;
pub(crate) mod effect_noise;
pub(crate) mod figures;
pub(crate) mod give_up;
pub(crate) mod robust;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod text;

pub use assignment::{assignment_table, assignment_text};
pub use before_after::before_and_after_in_short;
pub use cancellation::{cancellation_proof_table, cancelled_orders_table};
pub use consequence_figures::consequence_figures;
pub use consequence_tables::consequences_table;
pub use consequence_text::consequence_words;
pub use durable::{durability_table, durability_text, durability_words, durable_weights_table, moved_words};
pub use figures::optimum_figures;
pub use robust::{robust_tables, robust_text};
pub use section::{OptimumInput, optimum_section};
pub use tables::{
    effects_table, found_inertias_table, found_shafts_table, found_weights_table, limits_table, stages_table,
    web_bounds_table,
};
pub use text::{balance_text, equals_words, headline, search_state_words};
