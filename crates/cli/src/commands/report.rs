//! `lanchester report`: the page, and its figures as files.

use crate::arguments::ReportArguments;
use crate::commands::running::{Running, bearings_input, running, torque_input};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure};
use crate::files::{print, write_result};
use crate::format::Format;
use crate::provenance::provenance;
use crate::request::{internal_request, load_request};
use lanchester::balance::{Answer, fitted, optimise};
use lanchester::mechanism::{LoadRequest, Loads, internal_cases, loads};
use lanchester::model::{Diagnostic, Engine};
use lanchester::report::{
    ArrangementsInput, CrankshaftInput, OptimumInput, ReportInput, arrangements_report,
    bearings_section_figures, figures, internal_figures, mount_figures, optimum_figures, report,
    torque_section_figures,
};
use lanchester::{CounterweightCheck, arrangements, check_counterweights};
use std::path::{Path, PathBuf};

pub fn run(arguments: &ReportArguments, colour: bool) -> Result<u8, Failure> {
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let loads = loads(&opened.engine, &request).map_err(refused)?;
    let internal = internal_request(&arguments.request, request.samples)?;
    let internal = internal_cases(&opened.engine, &internal).map_err(refused)?;
    let mut warnings: Vec<String> = opened.warnings.iter().map(in_words).collect();
    let found = if arguments.all_arrangements { None } else { optimum(&opened.engine, &mut warnings)? };
    let provenance = provenance(&opened.source, &loads, &request);
    let checked = crankshaft(&opened.engine, &mut warnings);
    let running = if arguments.all_arrangements {
        Running::default()
    } else {
        running(&opened.engine, &arguments.file, loads.speed, &mut warnings)
    };
    let input = ReportInput {
        engine: &opened.engine,
        loads: &loads,
        internal: &internal,
        optimum: found.as_ref().map(Optimum::input),
        crankshaft: checked.as_ref().map(|checked| CrankshaftInput {
            bodies: &checked.crankshafts,
            clearances: checked.clearances.as_ref(),
            swept_overlaps: &checked.swept_overlaps,
        }),
        torque: running.torque.as_ref().map(torque_input),
        bearings: running.bearings.as_ref().map(|study| bearings_input(&opened.engine, study)),
        mounts: running.mounts.as_ref(),
        provenance: &provenance,
        warnings: &warnings,
    };
    let page = match arguments.all_arrangements {
        false => report(&input),
        true => arrangements_report(&ArrangementsInput {
            engine: &opened.engine,
            arrangements: &arrangements(&opened.engine, &request).map_err(Failure::refused)?,
            provenance: &provenance,
            warnings: &warnings,
        }),
    };
    let ending = if arguments.all_arrangements { "-arrangements.html" } else { ".html" };
    let output = arguments.output.clone().unwrap_or_else(|| default_output(&arguments.file, ending));
    if output == Path::new("-") {
        if let Some(folder) = &arguments.figures {
            write_figures(folder, &arguments.file, &input)?;
        }
        print(&page)?;
        return Ok(DONE);
    }
    write_result(&output, &arguments.file, &page)?;
    let mut written = vec![output];
    if let Some(folder) = &arguments.figures {
        written.extend(write_figures(folder, &arguments.file, &input)?);
    }
    print(&match arguments.format {
        Format::Text => listed("", &written),
        Format::Json => json(&serde_json::json!({ "written": written }))?,
        Format::Csv => listed("written\n", &written),
    })?;
    Ok(DONE)
}

/// What balancing found, with the loads before and after.
struct Optimum {
    answer: Answer,
    before: Loads,
    fitted: Engine,
    after: Loads,
}

impl Optimum {
    fn input(&self) -> OptimumInput<'_> {
        OptimumInput { answer: &self.answer, before: &self.before, fitted: &self.fitted, after: &self.after }
    }
}

/// What the section `[balance]` of the file asks, answered; a question without meaning is one more warning.
fn optimum(engine: &Engine, warnings: &mut Vec<String>) -> Result<Option<Optimum>, Failure> {
    let Some(task) = &engine.balance else { return Ok(None) };
    let answer = match optimise(engine, task) {
        Ok(answer) => answer,
        Err(error) => {
            eprintln!("warning: the section [balance] has no answer: {error}");
            warnings.push(format!("the section [balance] has no answer: {error}"));
            return Ok(None);
        }
    };
    let loads = |engine: &Engine| loads(engine, &LoadRequest::default()).map_err(refused);
    let fitted = fitted(engine, &answer);
    let (before, after) = (loads(engine)?, loads(&fitted)?);
    Ok(Some(Optimum { answer, before, fitted, after }))
}

/// The crankshaft as parts, where the file says something of it; what it leaves out is one more warning.
fn crankshaft(engine: &Engine, warnings: &mut Vec<String>) -> Option<CounterweightCheck> {
    let has_parts = engine.counterweights.iter().any(|weight| weight.part.is_some())
        || engine.shafts.iter().flat_map(|shaft| &shaft.weights).any(|weight| weight.part.is_some());
    if engine.crank_body.is_none() && !has_parts {
        return None;
    }
    match check_counterweights(engine) {
        Ok(checked) => Some(checked),
        Err(error) => {
            let message = format!("the crankshaft as parts is left out: {error}").replace("\nhint:", ";");
            eprintln!("warning: {message}");
            warnings.push(message);
            None
        }
    }
}

/// A warning of the engine file in one line.
fn in_words(warning: &Diagnostic) -> String {
    let hint = warning.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
    format!("line {}: {}{hint}", warning.line, warning.message)
}

fn listed(head: &str, written: &[PathBuf]) -> String {
    written.iter().fold(head.to_string(), |list, path| list + &path.display().to_string() + "\n")
}

fn write_figures(
    folder: &Path,
    engine_file: &Path,
    input: &ReportInput<'_>,
) -> Result<Vec<PathBuf>, Failure> {
    let internal = internal_figures(input.engine, input.internal);
    let of_optimum = |o: OptimumInput| optimum_figures(input.engine, o.answer, o.before, o.fitted, o.after);
    let optimum = input.optimum.map_or_else(Vec::new, of_optimum);
    let torque = input.torque.as_ref().map_or_else(Vec::new, torque_section_figures);
    let bearings = input.bearings.as_ref().map_or_else(Vec::new, bearings_section_figures);
    let mounts = input.mounts.map_or_else(Vec::new, |study| mount_figures(input.engine, study));
    figures(input.engine, input.loads)
        .iter()
        .chain(&internal)
        .chain(&optimum)
        .chain(&torque)
        .chain(&bearings)
        .chain(&mounts)
        .map(|figure| {
            let path = folder.join(format!("{}.svg", figure.id));
            write_result(&path, engine_file, &figure.svg())?;
            Ok(path)
        })
        .collect()
}

/// `engines/twin.toml` -> `twin.html` in the current folder; standard input -> `engine.html`.
fn default_output(file: &Path, ending: &str) -> PathBuf {
    let stem = file.file_stem().filter(|_| file != Path::new("-")).unwrap_or("engine".as_ref());
    let mut name = stem.to_os_string();
    name.push(ending);
    PathBuf::from(name)
}
