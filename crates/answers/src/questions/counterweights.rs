//! Counterweights as parts: the answers of `counterweight`.

use crate::api::{Api, Made};
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::design_choice::{Aim, design_request};
use crate::questions::reading::{EngineText, NewText, engine, engine_file};
use lanchester::file::{EngineFile, write_back};
use lanchester::geometry::drawing::DrawingOptions;
use lanchester::geometry::export::{PartFormat, part_file};
use lanchester::geometry::{Design, DesignOutcome};
use lanchester::model::{CounterweightForm, Engine};
use lanchester::task::option;
use lanchester::{
    CounterweightCheck, CounterweightDesigns, CounterweightFront, DrawingKind, ImportedOutline,
    OutlineImport, adopted, check_counterweights, chosen_parts, counterweight_front, design_counterweights,
    import_outline, with_counterweights,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Designs of a front.
const MOST_DESIGNS: usize = 200;

/// Which weights get the best shape.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DesignQuestion {
    /// The engine file.
    text: String,
    /// Names of the weights; none: all on webs.
    #[serde(default)]
    weights: Vec<String>,
    /// What is made small; as the file says where it is left out.
    #[serde(default)]
    minimise: Option<Aim>,
}

/// The best shapes.
#[derive(Debug, Serialize, JsonSchema)]
struct Designed {
    /// As `lanchester counterweight design --format json` prints it.
    designs: CounterweightDesigns,
    /// The engine file with the shapes; none where there is none.
    text: Option<String>,
}

/// The trade between two aims.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct FrontQuestion {
    /// The engine file.
    text: String,
    /// Name of the weight; without one all, if they have one duty.
    #[serde(default)]
    weight: Option<String>,
    /// What is made small; as the file says where it is left out.
    #[serde(default)]
    minimise: Option<Aim>,
    /// What it is traded for.
    against: Aim,
    /// How many designs, 2 to 200.
    count: usize,
}

/// A design of a front.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChosenDesign {
    /// The front that it stands on.
    front: FrontQuestion,
    /// Its number, from 1.
    choice: usize,
}

/// A drawing whose outline a weight gets.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ImportQuestion {
    /// The engine file.
    text: String,
    /// Name of the weight.
    weight: String,
    /// Name of the drawing's file: its ending tells the form, DXF or SVG.
    name: String,
    /// The drawing: SVG, or DXF as text.
    drawing: String,
    /// What the outline encloses.
    encloses: Encloses,
    /// Thickness with its unit; that of the present shape or of the webs where it is left out.
    #[serde(default)]
    thickness: Option<String>,
    /// Density with its unit; that of the present shape or of the crankshaft where it is left out.
    #[serde(default)]
    density: Option<String>,
    /// Unit of the drawing, where it does not say it: mm, cm, m, in.
    #[serde(default)]
    unit: Option<String>,
    /// Layers that are left out.
    #[serde(default)]
    leave_out: Vec<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Encloses {
    Counterweight,
    Web,
}

/// The outline of a drawing.
#[derive(Debug, Serialize, JsonSchema)]
struct Imported {
    /// As `lanchester counterweight import --format json` prints it.
    found: ImportedOutline,
    /// The engine file with the outline.
    text: String,
}

/// What is exported.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ExportQuestion {
    /// The engine file.
    text: String,
    /// The kind of file.
    format: Format,
    /// Name of one counterweight; without it the first crankshaft with the balance shafts around it.
    #[serde(default)]
    weight: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Format {
    Step,
    Stl,
    Glb,
    Dxf,
    Svg,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post(
        "/api/counterweight/check",
        "Crankshaft and counterweights as parts: `lanchester counterweight check`.",
        check,
    )
    .post(
        "/api/counterweight/design",
        "The best shapes with their proof: `lanchester counterweight design`.",
        design,
    )
    .post("/api/counterweight/front", "The trade between two aims: `lanchester counterweight front`.", front)
    .post("/api/counterweight/front/adopt", "The engine file with a design of a front.", adopt)
    .post(
        "/api/counterweight/import",
        "The outline of a drawing for a weight: `lanchester counterweight import`.",
        import,
    )
    .file(
        "/api/export",
        "A CAD file: `lanchester counterweight export`.",
        "application/octet-stream",
        export,
    )
}

fn check(_: &Asker, question: EngineText) -> Result<CounterweightCheck, Problem> {
    check_counterweights(&engine(&question.text)?).map_err(Problem::refused)
}

fn design(_: &Asker, question: DesignQuestion) -> Result<Designed, Problem> {
    let EngineFile { engine, tasks } = engine_file(&question.text)?;
    let request = design_request(&tasks, question.weights, question.minimise)?;
    let designs = design_counterweights(&engine, &request).map_err(Problem::refused)?;
    let found: Vec<(usize, Design)> = designs
        .weights
        .iter()
        .filter_map(|weight| match &weight.outcome {
            DesignOutcome::Found(best) => Some((weight.index, best.design)),
            DesignOutcome::Infeasible(_) => None,
        })
        .collect();
    let text = if found.is_empty() {
        None
    } else {
        Some(fitted(&question.text, &engine, &found, request.task.density)?)
    };
    Ok(Designed { designs, text })
}

/// The file with these designs.
fn fitted(text: &str, engine: &Engine, designs: &[(usize, Design)], density: f64) -> Result<String, Problem> {
    let after = with_counterweights(engine, designs, density).map_err(Problem::refused)?;
    write_back(text, &after).map_err(Problem::refused)
}

fn front(_: &Asker, question: FrontQuestion) -> Result<CounterweightFront, Problem> {
    let EngineFile { engine, tasks } = engine_file(&question.text)?;
    let request = design_request(&tasks, question.weight.clone().into_iter().collect(), question.minimise)?;
    counterweight_front(&engine, &request, question.against.into(), counted(&question)?)
        .map_err(Problem::refused)
}

fn counted(question: &FrontQuestion) -> Result<usize, Problem> {
    match question.count {
        count @ 2..=MOST_DESIGNS => Ok(count),
        count => Err(Problem::refused(format!(
            "a front has 2 to {MOST_DESIGNS} designs, got {count}\nhint: 20 show its shape"
        ))),
    }
}

fn adopt(_: &Asker, question: ChosenDesign) -> Result<NewText, Problem> {
    let ask = &question.front;
    let EngineFile { engine, tasks } = engine_file(&ask.text)?;
    let request = design_request(&tasks, ask.weight.clone().into_iter().collect(), ask.minimise)?;
    let found = counterweight_front(&engine, &request, ask.against.into(), counted(ask)?)
        .map_err(Problem::refused)?;
    let designs = &found.front.designs;
    let design = question.choice.checked_sub(1).and_then(|index| designs.get(index)).ok_or_else(|| {
        let count = designs.len();
        Problem::refused(format!(
            "a design needs its number, 1 to {count}, got {}\nhint: ask for the front again",
            question.choice
        ))
    })?;
    let adopted = adopted(&engine, &request, &found, design).map_err(Problem::refused)?;
    Ok(NewText { text: fitted(&ask.text, &engine, &adopted, request.task.density)? })
}

fn import(_: &Asker, question: ImportQuestion) -> Result<Imported, Problem> {
    let engine = engine(&question.text)?;
    let kind = DrawingKind::of_name(&question.name).ok_or_else(|| {
        Problem::refused(format!(
            "a drawing must end in dxf or svg, got \"{}\"\nhint: save it as one of the two in the CAD program",
            question.name
        ))
    })?;
    let length = |text: &String, name: &str| option::length(text, name).map_err(Problem::refused);
    let unit = question.unit.map(|unit| length(&format!("1 {unit}"), "unit of the drawing")).transpose()?;
    let density = question.density.map(|text| option::density(&text, "density")).transpose();
    let import = OutlineImport {
        weight: question.weight,
        kind,
        form: match question.encloses {
            Encloses::Counterweight => CounterweightForm::Counterweight,
            Encloses::Web => CounterweightForm::Web,
        },
        thickness: question.thickness.map(|text| length(&text, "thickness")).transpose()?,
        density: density.map_err(Problem::refused)?,
        options: DrawingOptions { unit, leave_out: question.leave_out, ..DrawingOptions::default() },
    };
    let (after, found) =
        import_outline(&engine, question.drawing.as_bytes(), &import).map_err(Problem::refused)?;
    Ok(Imported { text: write_back(&question.text, &after).map_err(Problem::refused)?, found })
}

fn export(_: &Asker, question: ExportQuestion) -> Result<Made, Problem> {
    let engine = engine(&question.text)?;
    let weights = question.weight.as_slice();
    let parts = chosen_parts(&engine, 0, weights, &[]).map_err(Problem::refused)?;
    let (kind, format) = match question.format {
        Format::Step => ("model/step", PartFormat::Step),
        Format::Stl => ("model/stl", PartFormat::Stl),
        Format::Glb => ("model/gltf-binary", PartFormat::Glb),
        Format::Dxf => ("image/vnd.dxf", PartFormat::Dxf),
        Format::Svg => ("image/svg+xml", PartFormat::Svg),
    };
    let bytes = part_file(format, &engine.name, &parts, PartFormat::FACET).map_err(Problem::refused)?;
    Ok(Made { kind, bytes })
}
