//! Many engines: comparison, sensitivities, production scatter.

pub(crate) mod comparison;
pub(crate) mod scatter_figures;
pub(crate) mod scatter_tables;
pub(crate) mod sensitivity_tables;

pub use comparison::{
    comparison_figure, comparison_table, comparison_text, equal_words, ranking_words, relative_table,
    unmeasured_words,
};
pub use scatter_figures::scatter_figure;
pub use scatter_tables::{
    scatter_limit_table, scatter_table, scatter_text, tighten_words, tolerance_name, tolerance_table,
};
pub use sensitivity_tables::{
    input_name, input_range, measure_unit, sensitivity_csv, sensitivity_tables, sensitivity_text,
};
