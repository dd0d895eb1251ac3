//! `lanchester counterweight import`: the outline of a counterweight from a drawing.

use crate::commands::{json, open};
use crate::failure::{DONE, Failure};
use crate::files::{print, read_bytes};
use crate::format::Format;
use crate::options::counterweight::{Encloses, ImportArguments};
use crate::put_back::PutBack;
use lanchester::geometry::drawing::DrawingOptions;
use lanchester::model::CounterweightForm;
use lanchester::report::csv_text;
use lanchester::task::option;
use lanchester::{DrawingKind, ImportedOutline, OutlineImport, OutlineImportError, import_outline};
use lanchester_files::shown;

pub fn run(arguments: &ImportArguments, colour: bool) -> Result<u8, Failure> {
    arguments.printed.check(arguments.format == Format::Text)?;
    let opened = open(&arguments.file, colour)?;
    let import = asked(arguments)?;
    let drawing = read_bytes(&arguments.drawing, "give the path of a DXF or SVG file")?;
    let (after, imported) =
        import_outline(&opened.file.engine, &drawing, &import).map_err(|error| match error {
            OutlineImportError::NoPlate => Failure::input(
                "an outline needs a thickness and a density, and neither the weight nor [crank.body] has them",
                "add --thickness '20 mm' --density '7850 kg/m3'",
            ),
            error => Failure::refused(error),
        })?;
    let put_back =
        PutBack { path: &arguments.file, write: arguments.write, dry_run: arguments.dry_run, what: "shapes" };
    if put_back.run(&opened, &after, colour)? {
        return Ok(DONE);
    }
    let said = match arguments.format {
        Format::Text => text(&imported),
        Format::Json => json(&imported)?,
        Format::Csv => format!(
            "weight,mass [kg],unbalance [kg m],swept radius [m]\n{},{},{},{}\n",
            csv_text(&imported.weight),
            imported.properties.mass,
            imported.properties.unbalance.norm(),
            imported.part.outline().swept_radius()
        ),
    };
    print(&arguments.printed.said(arguments.format, said))?;
    Ok(DONE)
}

fn text(imported: &ImportedOutline) -> String {
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

fn asked(arguments: &ImportArguments) -> Result<OutlineImport, Failure> {
    let length = |text: &str, option: &str| option::length(text, option).map_err(Failure::from);
    let name = arguments.drawing.file_name().map(|name| name.to_string_lossy().into_owned());
    let kind = DrawingKind::of_name(&name.unwrap_or_default()).ok_or_else(|| {
        Failure::input(
            format_args!("a drawing must end in dxf or svg, got {}", shown(&arguments.drawing)),
            "save it as one of the two in the CAD program",
        )
    })?;
    let unit = arguments.unit.as_ref().map(|unit| length(&format!("1 {unit}"), "--unit")).transpose()?;
    let thickness = arguments.thickness.as_ref().map(|text| length(text, "--thickness")).transpose()?;
    let density = arguments.density.as_ref().map(|text| option::density(text, "--density")).transpose()?;
    Ok(OutlineImport {
        weight: arguments.weight.clone(),
        kind,
        form: match arguments.encloses {
            Encloses::Counterweight => CounterweightForm::Counterweight,
            Encloses::Web => CounterweightForm::Web,
        },
        thickness,
        density,
        options: DrawingOptions {
            unit,
            gap: length(&arguments.gap, "--gap")?,
            leave_out: arguments.leave_out.clone(),
        },
    })
}
