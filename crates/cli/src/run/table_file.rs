//! Tables as files: whole or not at all.

use super::head::Held;
use crate::failure::Failure;
use lanchester::table::{Column, Form, TableError, TableReader, TableWriter};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The form that the ending of a name asks for.
pub fn form(path: &Path) -> Result<Form, Failure> {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("parquet") => Ok(Form::Parquet),
        Some("csv") => Ok(Form::Csv),
        _ => Err(Failure::input(
            format_args!("a table is written as .parquet or .csv, got {}", path.display()),
            "give the file one of these endings",
        )),
    }
}

/// Opens a table in Parquet.
pub fn open(path: &Path) -> Result<TableReader<File>, Failure> {
    let file = File::open(path).map_err(|error| cannot_read(path, error.into()))?;
    TableReader::open(file).map_err(|error| cannot_read(path, error))
}

pub fn cannot_read(path: &Path, error: TableError) -> Failure {
    Failure::input(
        format_args!("cannot read {}: {error}", path.display()),
        "give a table that lanchester has written to its end",
    )
}

pub fn cannot_write(path: &Path, error: impl std::fmt::Display) -> Failure {
    Failure::input(
        format_args!("cannot write {}: {error}", path.display()),
        "is the disk full, or the folder missing? what is done stays as it is, and the same command goes on from there",
    )
}

/// A name with something behind it.
pub fn beside(path: &Path, end: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(end);
    PathBuf::from(name)
}

/// What stands in the place of a table; `None` where nothing does, or what has no content of its own (a pipe).
pub fn held(path: &Path) -> Result<Option<Held>, Failure> {
    if !fs::metadata(path).is_ok_and(|file| file.is_file()) {
        return Ok(None);
    }
    let unknown = || {
        Failure::input(
            format_args!("{} exists and is not overwritten", path.display()),
            "choose another name, or remove it first",
        )
    };
    match form(path)? {
        Form::Parquet => {
            let reader = open(path).map_err(|_| unknown())?;
            Held::of(&reader, path).map(Some)
        }
        Form::Csv => {
            let text = fs::read_to_string(beside(path, ".json")).map_err(|_| unknown())?;
            let entries: BTreeMap<String, String> = serde_json::from_str(&text).map_err(|_| unknown())?;
            Held::found(|key| entries.get(key).cloned(), path).map(Some)
        }
    }
}

/// Writes a table: what `fill` pushes, then the metadata, into the footer or, for CSV, into a file `TABLE.json` beside it.
pub fn write(
    path: &Path,
    form: Form,
    columns: &[Column],
    metadata: &[(String, String)],
    fill: impl FnOnce(&mut TableWriter<&File>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    // A pipe or a device is written as it is; a file is put in its place when it is whole.
    let is_file = fs::metadata(path).map_or(true, |file| file.is_file());
    let target = if is_file { beside(path, ".new") } else { path.to_owned() };
    let outcome = File::create(&target).map_err(|error| cannot_write(path, error)).and_then(|file| {
        let table = |error: TableError| cannot_write(path, error);
        let mut writer = TableWriter::new(form, &file, columns).map_err(table)?;
        fill(&mut writer)?;
        writer.finish(metadata).map_err(table)?;
        let put = || {
            if is_file {
                file.sync_all()?;
                if form == Form::Csv {
                    let entries: BTreeMap<_, _> = metadata.iter().cloned().collect();
                    let mut beside = File::create(beside(path, ".json"))?;
                    beside.write_all(&serde_json::to_vec_pretty(&entries)?)?;
                }
                fs::rename(&target, path)?;
            }
            Ok(())
        };
        put().map_err(|error: std::io::Error| cannot_write(path, error))
    });
    if outcome.is_err() && is_file {
        // What could not be put in place is of no use; if it cannot be removed either, the first error says enough.
        let _ = fs::remove_file(&target);
    }
    outcome
}
