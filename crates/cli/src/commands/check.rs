//! `lanchester check`: every mistake of the files given.

use crate::arguments::CheckArguments;
use crate::commands::json;
use crate::failure::{DONE, Failure, WRONG_INPUT};
use crate::files::{print, read_source};
use crate::format::Format;
use lanchester::model::{Diagnostic, Severity, read, render};
use serde::Serialize;

/// What is known of one file.
#[derive(Serialize)]
struct Checked {
    file: String,
    valid: bool,
    /// Name of the engine, where the file is valid.
    engine: Option<String>,
    diagnostics: Vec<Diagnostic>,
}

pub fn run(arguments: &CheckArguments, colour: bool) -> Result<u8, Failure> {
    let mut checked = Vec::new();
    let mut status = DONE;
    for path in &arguments.files {
        let source = match read_source(path) {
            Ok(source) => source,
            // One unreadable file must not hide the mistakes of the others.
            Err(failure) => {
                eprintln!("{}", failure.message);
                status = failure.status;
                continue;
            }
        };
        let reading = read(&source.text);
        if arguments.format == Format::Text && !reading.diagnostics.is_empty() {
            eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
        }
        if reading.engine.is_none() {
            status = WRONG_INPUT;
        }
        checked.push(Checked {
            file: source.name,
            valid: reading.engine.is_some(),
            engine: reading.engine.map(|engine| engine.name),
            diagnostics: reading.diagnostics,
        });
    }
    print(&match arguments.format {
        Format::Text => text(&checked),
        Format::Json => json(&checked)?,
        Format::Csv => csv(&checked),
    })?;
    Ok(status)
}

fn text(checked: &[Checked]) -> String {
    let mut out = String::new();
    for file in checked {
        let errors =
            file.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count();
        let warnings = file.diagnostics.len() - errors;
        let verdict = match &file.engine {
            Some(engine) => format!("valid: {engine}"),
            None => format!("{errors} {}", if errors == 1 { "mistake" } else { "mistakes" }),
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
                quoted(&file.file),
                diagnostic.code,
                diagnostic.line,
                diagnostic.column,
                quoted(&diagnostic.message),
                quoted(diagnostic.hint.as_deref().unwrap_or_default()),
            );
        }
    }
    out
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
