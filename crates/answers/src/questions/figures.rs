//! Pictures: the report, its figures, the engine in space.

use crate::api::{Api, Made};
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{EngineText, engine, engine_file};
use crate::state::Studio;
use lanchester::file::{EngineFile, read};
use lanchester::mechanism::{InternalRequest, LoadRequest};
use lanchester::{EngineReport, Scene, is_running, provenance, scene};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A report.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ReportQuestion {
    /// The engine file.
    text: String,
    /// Its name, for the report.
    name: String,
}

/// A figure of the report.
#[derive(Debug, Serialize, JsonSchema)]
struct FigureSvg {
    /// Name for files.
    id: String,
    title: String,
    caption: String,
    /// A file of its own.
    svg: String,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/scene", "The engine as moving bodies, for a view in 3-D.", in_space)
        .post("/api/figures", "All figures of the report: `lanchester report --figures`.", figures)
        .file("/api/report", "The report: `lanchester report`.", "text/html; charset=utf-8", report)
}

fn in_space(_: &Asker, question: EngineText) -> Result<Scene, Problem> {
    Ok(scene(&engine(&question.text)?))
}

fn report_of<'a>(studio: &Studio, file: &'a EngineFile, text: &str) -> Result<EngineReport<'a>, Problem> {
    let traces = match is_running(file) {
        true => studio.traces(&file.engine),
        false => Ok(Vec::new()),
    };
    let traces = traces.as_deref().map_err(|problem| problem.message.clone());
    let warnings = read(text).diagnostics;
    let request = LoadRequest::default();
    let internal = InternalRequest { samples: request.samples, ..InternalRequest::default() };
    EngineReport::new(file, &request, &internal, traces, &warnings).map_err(Problem::refused)
}

/// With the torques of its files; a report without them says what it leaves out.
fn torques_of(asker: &Asker, file: EngineFile) -> EngineFile {
    asker.studio.with_torques(file.clone()).unwrap_or(file)
}

fn figures(asker: &Asker, question: EngineText) -> Result<Vec<FigureSvg>, Problem> {
    let file = torques_of(asker, engine_file(&question.text)?);
    let figures = report_of(asker.studio, &file, &question.text)?.figures();
    let svg = |figure: &lanchester::report::Figure| FigureSvg {
        id: figure.id.clone(),
        title: figure.title.clone(),
        caption: figure.caption.clone(),
        svg: figure.svg(),
    };
    Ok(figures.iter().map(svg).collect())
}

fn report(asker: &Asker, question: ReportQuestion) -> Result<Made, Problem> {
    let file = torques_of(asker, engine_file(&question.text)?);
    let report = report_of(asker.studio, &file, &question.text)?;
    let request = LoadRequest::default();
    let provenance =
        provenance(&asker.studio.program, &question.name, &question.text, &report.loads, &request);
    Ok(Made { kind: "text/html; charset=utf-8", bytes: report.page(&provenance).into_bytes() })
}
