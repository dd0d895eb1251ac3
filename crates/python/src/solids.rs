//! Counterweights, crankshafts and balance shafts as files for CAD.

use crate::failure::Failure;
use lanchester::geometry::drawing::{part_dxf, part_svg};
use lanchester::geometry::export::{PlacedPart, StepHeader, glb, solids, step, stl};
use lanchester::model::Engine;
use lanchester::{crankshaft_parts, engine_parts, shaft_parts};

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
    let faceted = matches!(ending, "stl" | "glb");
    if asked.facet.is_some() && !faceted {
        return Err(Failure::option(
            "`facet` is the error of facets, which STL and glTF alone have",
            "leave it out, or write a file that ends in stl or glb",
        ));
    }
    let parts = if !asked.shafts.is_empty() {
        shaft_parts(engine, &asked.shafts).map_err(Failure::refused)?
    } else if asked.crankshaft > 0 || !asked.weights.is_empty() {
        crankshaft_parts(engine, asked.crankshaft, &asked.weights).map_err(Failure::refused)?
    } else {
        engine_parts(engine).map_err(Failure::refused)?
    };
    let facet = asked.facet.unwrap_or(1e-5);
    let bodies = || solids(&parts).map_err(Failure::refused);
    match ending {
        "step" | "stp" => {
            let header = StepHeader { title: engine.name.clone(), ..StepHeader::default() };
            Ok(step(&bodies()?, &header).into_bytes())
        }
        "stl" => stl(&bodies()?, facet).map_err(Failure::refused),
        "glb" => glb(&bodies()?, facet).map_err(Failure::refused),
        "dxf" => Ok(part_dxf(&one(&parts)?.part).map_err(Failure::refused)?.into_bytes()),
        "svg" => Ok(part_svg(&one(&parts)?.part).map_err(Failure::refused)?.into_bytes()),
        _ => Err(Failure::option(
            format_args!("the name of the file must end in step, stl, glb, dxf or svg, got \"{ending}\""),
            "the ending says what is written",
        )),
    }
}

/// The only part: an outline is that of one.
fn one(parts: &[PlacedPart]) -> Result<&PlacedPart, Failure> {
    match parts {
        [part] => Ok(part),
        _ => Err(Failure::option(
            format_args!("a drawing holds the outline of one part, got {}", parts.len()),
            "name one counterweight with `weight`, or one shaft of one weight with `shaft`",
        )),
    }
}
