//! `lanchester show`: the expanded form and the drawing.

use crate::arguments::ShowArguments;
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use lanchester::file::{EngineFile, expanded};
use lanchester::inertias;
use lanchester::mechanism::{LoadRequest, Loads, loads};
use lanchester::model::{Engine, Rotation};
use lanchester::report::{articulation_table, drawing, inertia_table, motion_table, rod_inertia_table};

pub fn run(arguments: &ShowArguments, colour: bool) -> Result<u8, Failure> {
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    if let Some(path) = &arguments.drawing {
        write_result(path, &arguments.file, &drawing(engine).svg())?;
    }
    let request = LoadRequest { samples: 1, ..LoadRequest::default() };
    print(&match arguments.format {
        Format::Text => {
            let loads = loads(engine, &request).map_err(refused)?;
            // The table stands in comments, so that the whole output is an engine file again.
            let mut out = String::new();
            let text = format!("{}\n{}\n{}", frame(engine), motion(&loads), turning(&opened.file));
            for line in text.lines() {
                out += format!("# {line}").trim_end();
                out.push('\n');
            }
            out + "\n" + &expanded(&opened.file)
        }
        Format::Json => json(&opened.file)?,
        Format::Csv => motion_table(&loads(engine, &request).map_err(refused)?).csv(),
    })?;
    Ok(DONE)
}

/// Inertias of everything that turns.
fn turning(file: &EngineFile) -> String {
    let found = inertias(&file.engine, &file.tasks);
    let throws: Vec<_> =
        found.throws.iter().map(|own| (own.crankshaft, own.throw, own.mass, own.inertia)).collect();
    let driveline: Vec<_> = found.driveline.iter().map(|own| (own.ratio, own.inertia.value)).collect();
    inertia_table(&found.bodies, &throws, &driveline, &found.sum).text()
}

/// Dead centres of every cylinder, what articulated rods change, and what two-mass rods miss.
fn motion(loads: &Loads) -> String {
    let mut out = motion_table(loads).text();
    for table in [articulation_table(loads), rod_inertia_table(loads)].into_iter().flatten() {
        out.push('\n');
        out += &table.text();
    }
    out
}

/// The frame that all angles and places of the output refer to.
fn frame(engine: &Engine) -> String {
    let (sense, side) = match engine.rotation {
        Rotation::Clockwise => ("clockwise", "right"),
        Rotation::Reverse => ("anticlockwise", "left"),
    };
    format!(
        "Frame\n  z: crank axis, from the free end to the flywheel; origin in the reference plane\n  x: up, y: to the \
         {side}, seen from the free end; the crank turns {sense}, from +x to +y\n  theta = 0: throw 1 along +x; angles \
         of throws and cylinders count from +x towards +y\n"
    )
}
