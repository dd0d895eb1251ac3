//! The section of the report on the engine's own data.

use crate::engine::tables::{masses_table, throws_table, weights_table};
use crate::kit::section::Section;
use lanchester_model::Engine;

/// Masses, throws and weights of an engine, as a section of a report.
pub fn engine_section(engine: &Engine) -> Section {
    Section::new("data", "Engine data", "The engine in numbers")
        .tables([masses_table(engine), throws_table(engine)].into_iter().chain(weights_table(engine)))
}
