//! `lanchester counterweight import`: the outline of a counterweight from a drawing.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::files::{print, read_bytes};
use crate::format::Format;
use crate::options::counterweight::{Encloses, ImportArguments};
use crate::put_back::PutBack;
use lanchester::geometry::drawing::{Drawing, DrawingOptions, read_dxf, read_svg};
use lanchester::geometry::{MassProperties, Part, counterweight_properties};
use lanchester::model::{CounterweightForm, Engine};
use lanchester::report::csv_text;
use lanchester::task::option;
use lanchester::with_outline;
use lanchester_files::shown;
use serde::Serialize;

/// An outline that was read, and what it makes of its counterweight.
#[derive(Serialize)]
struct Imported<'a> {
    weight: &'a str,
    part: &'a Part,
    properties: MassProperties,
    left_out: Vec<String>,
}

pub fn run(arguments: &ImportArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let opened = open(&arguments.file, colour)?;
    let engine = &opened.file.engine;
    let drawing = drawing(arguments)?;
    let mut ignored: Vec<String> =
        drawing.ignored.iter().map(|ignored| format!("{}: {}", ignored.entity, ignored.why)).collect();
    ignored.extend(drawing.bores.iter().map(|bore| {
        format!(
            "bore of {:.3} mm at x {:.3}, y {:.3} mm: its depth and material are no part of an outline; add it to `inserts` of the shape",
            2e3 * bore.radius,
            1e3 * bore.centre.x,
            1e3 * bore.centre.y
        )
    }));
    let part = part(engine, arguments, drawing)?;
    let form = match arguments.encloses {
        Encloses::Counterweight => CounterweightForm::Counterweight,
        Encloses::Web => CounterweightForm::Web,
    };
    let after = with_outline(engine, &arguments.weight, form, part).map_err(Failure::refused)?;
    let put_back =
        PutBack { path: &arguments.file, write: arguments.write, dry_run: arguments.dry_run, what: "shapes" };
    if put_back.run(&opened, &after, colour)? {
        return Ok(DONE);
    }
    let fitted = after.counterweights.iter().find(|weight| weight.name == arguments.weight);
    let Some(part) = fitted.and_then(|weight| weight.part.as_ref()) else { return Ok(DONE) };
    let properties = counterweight_properties(&after, part).map_err(Failure::refused)?;
    let imported = Imported { weight: &arguments.weight, part: &part.part, properties, left_out: ignored };
    let said = match arguments.format {
        Format::Text => text(&imported),
        Format::Json => json(&imported)?,
        Format::Csv => format!(
            "weight,mass [kg],unbalance [kg m],swept radius [m]\n{},{},{},{}\n",
            csv_text(imported.weight),
            properties.mass,
            properties.unbalance.norm(),
            part.part.outline().swept_radius()
        ),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}

fn text(imported: &Imported<'_>) -> String {
    let outline = imported.part.outline();
    let [low, high] = outline.bounds();
    let mut out = format!(
        "{}: outline of {} edges with {} openings, {:.3} mm x {:.3} mm, swept radius {:.3} mm\n\
         mass {:.1} g, unbalance {:.4} kg mm, polar inertia {:.2} kg mm²\n",
        imported.weight,
        outline.outer().edges().len(),
        outline.holes().len(),
        1e3 * (high.x - low.x),
        1e3 * (high.y - low.y),
        1e3 * outline.swept_radius(),
        1e3 * imported.properties.mass,
        1e3 * imported.properties.unbalance.norm(),
        1e6 * imported.properties.polar_inertia(),
    );
    for left in &imported.left_out {
        out += &format!("left out: {left}\n");
    }
    out
}

fn drawing(arguments: &ImportArguments) -> Result<Drawing, Failure> {
    let length = |text: &str, option: &str| option::length(text, option).map_err(Failure::from);
    let unit = arguments.unit.as_ref().map(|unit| length(&format!("1 {unit}"), "--unit")).transpose()?;
    let options = DrawingOptions {
        unit,
        gap: length(&arguments.gap, "--gap")?,
        leave_out: arguments.leave_out.clone(),
    };
    let bytes = read_bytes(&arguments.drawing, "give the path of a DXF or SVG file")?;
    let ending = arguments.drawing.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    match ending.to_ascii_lowercase().as_str() {
        "dxf" => read_dxf(&bytes, &options).map_err(Failure::refused),
        "svg" => read_svg(&bytes, &options).map_err(Failure::refused),
        _ => Err(Failure::input(
            format_args!("a drawing must end in dxf or svg, got {}", shown(&arguments.drawing)),
            "save it as one of the two in the CAD program",
        )),
    }
}

/// The plate: thickness and density as asked for, else as the weight or the webs have them.
fn part(engine: &Engine, arguments: &ImportArguments, drawing: Drawing) -> Result<Part, Failure> {
    let now = engine.counterweights.iter().find(|weight| weight.name == arguments.weight);
    let now = now.and_then(|weight| weight.part.as_ref()).map(|part| &part.part);
    let body = engine.crank_body;
    let thickness = match &arguments.thickness {
        Some(text) => Some(option::length(text, "--thickness").map_err(Failure::from)?),
        None => now.map(Part::thickness).or(body.map(|body| body.web_thickness)),
    };
    let density = match &arguments.density {
        Some(text) => Some(option::density(text, "--density").map_err(Failure::from)?),
        None => now.map(Part::density).or(body.map(|body| body.density)),
    };
    let (Some(thickness), Some(density)) = (thickness, density) else {
        return Err(Failure::input(
            "an outline needs a thickness and a density, and neither the weight nor [crank.body] has them",
            "add --thickness '20 mm' --density '7850 kg/m3'",
        ));
    };
    Part::new(drawing.outline, thickness, density).map_err(Failure::refused)
}
