//! `lanchester counterweight export`: CAD files and outlines.

use crate::commands::open;
use crate::failure::{DONE, Failure};
use crate::files::write_result;
use crate::options::counterweight::ExportArguments;
use lanchester::geometry::export::{PartFormat, PlacedPart, part_file};
use lanchester::model::Engine;
use lanchester::task::option;
use lanchester::{check_counterweights, chosen_parts};
use lanchester_files::shown;

pub fn run(arguments: &ExportArguments, colour: bool) -> Result<u8, Failure> {
    let opened = open(&arguments.file, colour)?;
    let crankshaft = arguments.crankshaft.wrapping_sub(1);
    if crankshaft >= opened.file.engine.crankshafts.len() {
        let count = opened.file.engine.crankshafts.len();
        return Err(Failure::input(
            format_args!("--crankshaft needs a number from 1 to {count}, got {}", arguments.crankshaft),
            "leave it out for the first one",
        ));
    }
    let engine = &opened.file.engine;
    let parts =
        chosen_parts(engine, crankshaft, &arguments.weight, &arguments.shaft).map_err(Failure::refused)?;
    let ending = arguments.output.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let format = PartFormat::of_ending(ending).ok_or_else(|| {
        Failure::input(
            format_args!("--output must end in step, stl, glb, dxf or svg, got {}", shown(&arguments.output)),
            "the ending says what is written",
        )
    })?;
    let content =
        part_file(format, &engine.name, &parts, facet(arguments, format)?).map_err(Failure::refused)?;
    write_result(&arguments.output, &arguments.file, &content)?;
    let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
    eprintln!("{} written: {}", shown(&arguments.output), names.join(", "));
    if !format.is_outline() {
        eprint!("{}", masses(engine, &parts));
    }
    Ok(DONE)
}

/// What exported counterweights weigh, where that is more than what they add to the crankshaft.
fn masses(engine: &Engine, parts: &[PlacedPart]) -> String {
    let mut told = String::new();
    for weight in check_counterweights(engine).map(|checked| checked.counterweights).unwrap_or_default() {
        if !parts.iter().any(|part| part.name == weight.name) || weight.part_mass - weight.mass < 1e-9 {
            continue;
        }
        told += &format!(
            "{}: {:.1} g as a solid, which holds the web's disc and flank that it covers; {:.1} g are beyond the web as it is\n",
            weight.name,
            1e3 * weight.part_mass,
            1e3 * weight.mass
        );
    }
    told
}

/// Largest error of facets [m].
fn facet(arguments: &ExportArguments, format: PartFormat) -> Result<f64, Failure> {
    let Some(text) = &arguments.facet else { return Ok(PartFormat::FACET) };
    if !format.has_facets() {
        return Err(Failure::input(
            "--facet is the error of facets, which STL and glTF alone have",
            "leave it out, or write a file that ends in stl or glb",
        ));
    }
    Ok(option::length(text, "--facet")?)
}
