//! `lanchester counterweight export`: CAD files and outlines.

use crate::commands::open;
use crate::failure::{DONE, Failure};
use crate::files::write_result;
use crate::options::counterweight::ExportArguments;
use lanchester::geometry::drawing::{part_dxf, part_svg};
use lanchester::geometry::export::{PlacedPart, StepHeader, glb, solids, step, stl};
use lanchester::model::Engine;
use lanchester::task::option;
use lanchester::{check_counterweights, crankshaft_parts, engine_parts, shaft_parts};
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
    let parts = parts(&opened.file.engine, arguments, crankshaft)?;
    let ending = arguments.output.extension().and_then(|ending| ending.to_str());
    let ending = ending.unwrap_or_default().to_ascii_lowercase();
    let facet = facet(arguments, &ending)?;
    let solids = || solids(&parts).map_err(Failure::refused);
    let content = match ending.as_str() {
        "step" | "stp" => {
            let header = StepHeader { title: opened.file.engine.name.clone(), ..StepHeader::default() };
            step(&solids()?, &header).into_bytes()
        }
        "stl" => stl(&solids()?, facet).map_err(Failure::refused)?,
        "glb" => glb(&solids()?, facet).map_err(Failure::refused)?,
        "dxf" => part_dxf(&one(&parts)?.part).map_err(Failure::refused)?.into_bytes(),
        "svg" => part_svg(&one(&parts)?.part).map_err(Failure::refused)?.into_bytes(),
        _ => {
            return Err(Failure::input(
                format_args!(
                    "--output must end in step, stl, glb, dxf or svg, got {}",
                    shown(&arguments.output)
                ),
                "the ending says what is written",
            ));
        }
    };
    write_result(&arguments.output, &arguments.file, &content)?;
    let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
    eprintln!("{} written: {}", shown(&arguments.output), names.join(", "));
    if matches!(ending.as_str(), "step" | "stp" | "stl" | "glb") {
        eprint!("{}", masses(&opened.file.engine, &parts));
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

/// What is asked for: balance shafts alone, counterweights alone, or a crankshaft, the first one with the balance shafts around it.
fn parts(
    engine: &Engine,
    arguments: &ExportArguments,
    crankshaft: usize,
) -> Result<Vec<PlacedPart>, Failure> {
    if !arguments.shaft.is_empty() {
        return shaft_parts(engine, &arguments.shaft).map_err(Failure::refused);
    }
    if crankshaft > 0 || !arguments.weight.is_empty() {
        return crankshaft_parts(engine, crankshaft, &arguments.weight).map_err(Failure::refused);
    }
    engine_parts(engine).map_err(Failure::refused)
}

/// Largest error of facets [m].
fn facet(arguments: &ExportArguments, ending: &str) -> Result<f64, Failure> {
    let Some(text) = &arguments.facet else { return Ok(1e-5) };
    if !matches!(ending, "stl" | "glb") {
        return Err(Failure::input(
            "--facet is the error of facets, which STL and glTF alone have",
            "leave it out, or write a file that ends in stl or glb",
        ));
    }
    Ok(option::length(text, "--facet")?)
}

/// The only part: an outline is that of one.
fn one(parts: &[PlacedPart]) -> Result<&PlacedPart, Failure> {
    match parts {
        [part] => Ok(part),
        _ => Err(Failure::input(
            format_args!("a drawing holds the outline of one part, got {}", parts.len()),
            "name one counterweight with --weight, or one shaft of one weight with --shaft",
        )),
    }
}
