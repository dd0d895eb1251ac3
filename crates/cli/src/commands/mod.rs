//! One file a command; each returns its exit status.

pub mod balance;
pub mod bearings;
pub mod bondgraph;
pub mod check;
pub mod compare;
pub mod complete;
pub mod counterweight;
pub mod crosscheck;
pub mod explore;
pub mod export;
pub mod licences;
pub mod loads;
pub mod merge;
pub mod mounts;
pub mod new;
pub mod report;
pub mod scatter;
pub mod schema;
pub mod sensitivity;
pub mod shell;
pub mod show;
pub mod simulate;
pub mod stress;
pub mod studio;
pub mod torque;
pub mod torsion;
pub mod validate;
pub mod workshop;

use crate::failure::Failure;
use crate::files::{Source, read_source};
use crate::trace_files::read_torques;
use lanchester::file::{Diagnostic, EngineFile, read, render};
use lanchester::mechanism::LoadError;
use std::path::Path;

/// An engine file with the text it was read from.
pub struct Opened {
    pub source: Source,
    pub file: EngineFile,
    pub warnings: Vec<Diagnostic>,
}

/// Read an engine file for a command that needs the engine: mistakes and warnings go to standard error.
pub fn open(path: &Path, colour: bool) -> Result<Opened, Failure> {
    let source = read_source(path)?;
    let reading = read(&source.text);
    if !reading.diagnostics.is_empty() {
        eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
    }
    match reading.file {
        Some(mut file) => {
            read_torques(&mut file, path)?;
            Ok(Opened { source, file, warnings: reading.diagnostics })
        }
        None => Err(Failure::diagnosed()),
    }
}

/// Pretty JSON with a trailing newline.
pub fn json(value: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value).map(|text| text + "\n").map_err(Failure::own)
}

/// A calculation that cannot be done as asked.
pub fn refused(error: LoadError) -> Failure {
    match error {
        // The numbers of a request come from options.
        LoadError::Request { .. } => {
            Failure::input(error, "`lanchester loads --help` tells what each option means")
        }
        _ => Failure::refused(error),
    }
}
