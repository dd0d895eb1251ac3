//! `lanchester check`: every mistake of the files given.

use crate::arguments::CheckArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure, WRONG_INPUT};
use crate::files::{print, read_source, tell};
use crate::format::Format;
use crate::trace_files::{read_torques, trace_files};
use lanchester::file::{Diagnostic, Severity, read, render};
use lanchester::model::Engine;
use lanchester::report::csv_text;
use lanchester::{cylinder_gas, film_faults};
use serde::Serialize;
use std::path::Path;

/// What is known of one file.
#[derive(Serialize)]
struct Checked {
    file: String,
    valid: bool,
    /// Name of the engine, where the file is valid.
    engine: Option<String>,
    diagnostics: Vec<Diagnostic>,
    /// What is wrong or doubtful with the gas, which only its computation tells.
    gas: Vec<String>,
    /// What of clearances and oil no film can have.
    films: Vec<String>,
}

pub fn run(arguments: &CheckArguments, colour: bool) -> Result<u8, Failure> {
    let mut checked = Vec::new();
    let mut status = DONE;
    for path in &arguments.files {
        let source = match read_source(path) {
            Ok(source) => source,
            // One unreadable file must not hide the mistakes of the others.
            Err(failure) => {
                tell(failure.message);
                status = failure.status;
                continue;
            }
        };
        let reading = read(&source.text);
        if arguments.format == Format::Text && !reading.diagnostics.is_empty() {
            eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
        }
        if reading.file.is_none() {
            status = WRONG_INPUT;
        }
        let (mut gas, mut has_gas_error) = match &reading.file {
            Some(file) => gas(&file.engine, path),
            None => (Vec::new(), false),
        };
        if let Some(Err(failure)) = reading.file.clone().map(|mut file| read_torques(&mut file, path)) {
            gas.push(failure.message);
            has_gas_error = true;
        }
        if has_gas_error {
            status = WRONG_INPUT;
        }
        // What the reader has told of them has its place.
        let is_told = reading.diagnostics.iter().any(|told| told.code == "W1301");
        let films = reading
            .file
            .as_ref()
            .filter(|_| !is_told)
            .map_or_else(Vec::new, |file| film_faults(&file.engine));
        let films: Vec<String> = films.iter().map(|fault| format!("warning: {fault}")).collect();
        if arguments.format == Format::Text {
            for message in gas.iter().chain(&films) {
                tell(format_args!("{message}\n"));
            }
        }
        checked.push(Checked {
            file: source.name,
            valid: reading.file.is_some() && !has_gas_error,
            engine: reading.file.map(|file| file.engine.name.clone()),
            diagnostics: reading.diagnostics,
            gas,
            films,
        });
    }
    print(&match arguments.format {
        Format::Text => text(&checked),
        Format::Json => json(&checked)?,
        Format::Csv => csv(&checked),
    })?;
    Ok(status)
}

/// What is said of the gas at the highest speed, and whether it is a mistake.
fn gas(engine: &Engine, path: &Path) -> (Vec<String>, bool) {
    if engine.gas.is_none() {
        return (Vec::new(), false);
    }
    let report = trace_files(engine, path)
        .and_then(|traces| cylinder_gas(engine, &traces, engine.speed.highest).map_err(Failure::refused));
    match report {
        Ok(report) => (report.warnings.iter().map(|warning| format!("warning: {warning}")).collect(), false),
        Err(failure) => (vec![failure.message], true),
    }
}

fn text(checked: &[Checked]) -> String {
    let mut out = String::new();
    for file in checked {
        let errors =
            file.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count();
        let (errors, warnings) = match (file.valid, &file.engine) {
            (true, _) => (errors, file.diagnostics.len() - errors + file.gas.len() + file.films.len()),
            (false, Some(_)) => (file.gas.len(), file.diagnostics.len() + file.films.len()),
            (false, None) => (errors, file.diagnostics.len() - errors),
        };
        let verdict = match &file.engine {
            Some(engine) if file.valid => format!("valid: {engine}"),
            _ => format!("{errors} {}", if errors == 1 { "mistake" } else { "mistakes" }),
        };
        let warned = match warnings {
            0 => String::new(),
            1 => " (1 warning)".to_string(),
            more => format!(" ({more} warnings)"),
        };
        out += &format!("{}: {verdict}{warned}\n", file.file);
    }
    out
}

fn csv(checked: &[Checked]) -> String {
    let mut out = String::from("file,severity,code,line,column,message,hint\n");
    for file in checked {
        for diagnostic in &file.diagnostics {
            let severity = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
            out += &format!(
                "{},{severity},{},{},{},{},{}\n",
                csv_text(&file.file),
                diagnostic.code,
                diagnostic.line,
                diagnostic.column,
                csv_text(&diagnostic.message),
                csv_text(diagnostic.hint.as_deref().unwrap_or_default()),
            );
        }
        for message in file.gas.iter().chain(&file.films) {
            let (severity, words) = match message.strip_prefix("warning: ") {
                Some(words) => ("warning", words),
                None => ("error", message.as_str()),
            };
            let (words, hint) = words.split_once("\nhint: ").unwrap_or((words, ""));
            out +=
                &format!("{},{severity},,,,{},{}\n", csv_text(&file.file), csv_text(words), csv_text(hint));
        }
    }
    out
}
