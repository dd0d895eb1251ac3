//! Counterweights, crankshafts and balance shafts as files for CAD.

use crate::failure::Failure;
use lanchester::chosen_parts;
use lanchester::geometry::export::{PartFormat, part_file};
use lanchester::model::Engine;

/// Which parts, and how fine.
pub struct SolidsRequest {
    /// Names of counterweights; empty: the crankshaft with all of them.
    pub weights: Vec<String>,
    /// Names of balance shafts; empty: those around the first crankshaft.
    pub shafts: Vec<String>,
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// Largest distance between a true arc and its facets [m]; `None`: 0.01 mm.
    pub facet: Option<f64>,
}

/// The content of a file whose name ends in `ending`.
///
/// # Errors
/// Where there are no such parts, they have no shape, or the format cannot hold them.
pub fn solids_file(engine: &Engine, ending: &str, asked: &SolidsRequest) -> Result<Vec<u8>, Failure> {
    if !asked.shafts.is_empty() && (!asked.weights.is_empty() || asked.crankshaft > 0) {
        return Err(Failure::option(
            "`shaft` is asked for together with `weight` or `crankshaft`",
            "balance shafts stand alone: leave out the others",
        ));
    }
    if asked.crankshaft > 0 && !asked.weights.is_empty() {
        return Err(Failure::option(
            "`weight` is asked for together with `crankshaft`",
            "the name of a counterweight says on which crankshaft it is: leave out `crankshaft`",
        ));
    }
    let format = PartFormat::of_ending(ending).ok_or_else(|| {
        Failure::option(
            format_args!("the name of the file must end in step, stl, glb, dxf or svg, got \"{ending}\""),
            "the ending says what is written",
        )
    })?;
    if asked.facet.is_some() && !format.has_facets() {
        return Err(Failure::option(
            "`facet` is the error of facets, which STL and glTF alone have",
            "leave it out, or write a file that ends in stl or glb",
        ));
    }
    let parts =
        chosen_parts(engine, asked.crankshaft, &asked.weights, &asked.shafts).map_err(Failure::refused)?;
    let facet = asked.facet.unwrap_or(PartFormat::FACET);
    part_file(format, &engine.name, &parts, facet).map_err(Failure::refused)
}
