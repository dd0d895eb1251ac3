//! The section of the report on what bends the crankshaft.

use crate::bearings::internal_figure::internal_figures;
use crate::bearings::internal_tables::{internal_table, mains_table};
use crate::kit::section::Section;
use lanchester_mechanism::InternalMoments;
use lanchester_model::Engine;

/// Shear and bending inside the crankshafts, as a section of a report; `None` where nothing bends.
pub fn bending_section(engine: &Engine, internal: &[InternalMoments]) -> Option<Section> {
    internal.first().filter(|case| !case.crankshafts.is_empty())?;
    let words = "What balances the engine as a whole may still bend its crankshaft and load its main bearings. All of it is \
                 statics without gas, the main bearings in line.";
    let section = Section::new("bending", "Crankshaft", "Inside the crankshaft")
        .words(words)
        .side_by_side(internal_figures(engine, internal))
        .tables([internal_table(engine, internal), mains_table(engine, internal)]);
    Some(section)
}
