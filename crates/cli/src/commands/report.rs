//! `lanchester report`: the page, and its figures as files.

use crate::arguments::{Format, ReportArguments};
use crate::commands::{json, open, refused};
use crate::failure::{DONE, Failure, WRONG_INPUT};
use crate::files::{print, write_result};
use crate::provenance::provenance;
use crate::request::{internal_request, load_request};
use lanchester::arrangements;
use lanchester::mechanism::{internal_cases, loads};
use lanchester::model::Diagnostic;
use lanchester::report::{
    ArrangementsInput, ReportInput, arrangements_report, figures, internal_figures, report,
};
use std::path::{Path, PathBuf};

pub fn run(arguments: &ReportArguments, colour: bool) -> Result<u8, Failure> {
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let loads = loads(&opened.engine, &request).map_err(refused)?;
    let internal = internal_request(&arguments.request, request.samples)?;
    let internal = internal_cases(&opened.engine, &internal).map_err(refused)?;
    let warnings: Vec<String> = opened.warnings.iter().map(in_words).collect();
    let provenance = provenance(&opened.source, &loads, &request);
    let input = ReportInput {
        engine: &opened.engine,
        loads: &loads,
        internal: &internal,
        provenance: &provenance,
        warnings: &warnings,
    };
    let page = match arguments.all_arrangements {
        false => report(&input),
        true => arrangements_report(&ArrangementsInput {
            engine: &opened.engine,
            arrangements: &arrangements(&opened.engine, &request)
                .map_err(|error| Failure { status: WRONG_INPUT, message: format!("error: {error}") })?,
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
    figures(input.engine, input.loads)
        .iter()
        .chain(&internal)
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
