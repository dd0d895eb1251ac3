//! Published methods beside the true optimum, and what figures of sources are drawn with.

pub(crate) mod bars;
pub(crate) mod crank_curve;
pub(crate) mod curves;
pub(crate) mod swept;
pub(crate) mod tables;
pub(crate) mod text;
pub(crate) mod vectors;

pub use bars::PublishedBars;
pub use crank_curve::crank_curve;
pub use curves::{Abscissa, PointsAs, PublishedCurve, PublishedCurves};
pub use swept::{sweep_steps_table, swept_table, swept_text};
pub use tables::{
    equilibrium_table, method_effects_table, method_numbers_table, method_orders_table, method_weights_table,
};
pub use text::{method_source, method_text, residual_noise};
pub use vectors::PublishedVectors;
