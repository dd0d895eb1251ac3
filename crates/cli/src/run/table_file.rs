//! Tables as files: whole or not at all.

use super::head::{held_of, says_nothing};
use crate::failure::Failure;
use lanchester::run::{Held, numbered};
use lanchester::table::{Column, Form, Rows, SEAL, TableError, TableReader, TableWriter, Values, csv_seal};
use lanchester_files::{NewFile, Over, PutError, shown};
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
            format_args!("a table is written as .parquet or .csv, got {}", shown(path)),
            "give the file one of these endings",
        )),
    }
}

/// Opens a table in Parquet, its footer verified, and its rows as they are read.
pub fn open(path: &Path) -> Result<TableReader<File>, Failure> {
    let file = File::open(path).map_err(|error| cannot_read(path, error.into()))?;
    TableReader::open(file).map_err(|error| cannot_read(path, error))
}

pub fn cannot_read(path: &Path, error: TableError) -> Failure {
    let hint = match error {
        TableError::Altered { .. }
        | TableError::AlteredFooter
        | TableError::AlteredText
        | TableError::Unsealed => "run again what made it, into another file",
        _ => "give a table that lanchester has written to its end",
    };
    Failure::input(format_args!("cannot read {}: {error}", shown(path)), hint)
}

/// Rows that are not what was written: with the blocks that the file holds, which its footer tells.
pub fn cannot_read_rows(path: &Path, held: &Held, error: TableError) -> Failure {
    let TableError::Altered { .. } = error else { return cannot_read(path, error) };
    let blocks = numbered(&held.blocks, held.of);
    Failure::input(
        format_args!("cannot read {}, which holds {blocks}: {error}", shown(path)),
        "remove it and run again what made it; nothing else is lost",
    )
}

pub fn cannot_write(path: &Path, error: impl std::fmt::Display) -> Failure {
    Failure::input(
        format_args!("cannot write {}: {error}", shown(path)),
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
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name, or remove it first",
        )
    };
    match form(path)? {
        Form::Parquet => {
            let file = File::open(path).map_err(|error| cannot_read(path, error.into()))?;
            match TableReader::open(file) {
                Ok(reader) => {
                    let held = held_of(&reader, path)?;
                    reader.verify().map_err(|error| cannot_read_rows(path, &held, error))?;
                    Ok(Some(held))
                }
                Err(error @ (TableError::AlteredFooter | TableError::Unsealed)) => {
                    Err(cannot_read(path, error))
                }
                Err(_) => Err(unknown()),
            }
        }
        Form::Csv => {
            let text = fs::read_to_string(beside(path, ".json")).map_err(|_| unknown())?;
            let mut entries: BTreeMap<String, String> = serde_json::from_str(&text).map_err(|_| unknown())?;
            let kept = entries.remove(SEAL).ok_or_else(|| cannot_read(path, TableError::Unsealed))?;
            let rest: Vec<_> = entries.clone().into_iter().collect();
            let found = File::open(path).map_err(TableError::from).and_then(|file| csv_seal(file, &rest));
            if found.map_err(|error| cannot_read(path, error))? != kept {
                return Err(cannot_read(path, TableError::AlteredText));
            }
            Held::found(|key| entries.get(key).cloned()).map(Some).ok_or_else(|| says_nothing(path))
        }
    }
}

/// Writes curves: a column of words, then columns of numbers, as rows; over nothing that is there.
pub fn save(
    path: &Path,
    form: Form,
    (heads, rows): (Vec<String>, Vec<(String, Vec<f64>)>),
) -> Result<(), Failure> {
    if fs::metadata(path).is_ok_and(|there| there.is_file()) {
        return Err(Failure::input(
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name, or remove it first",
        ));
    }
    let name = |head: &String| {
        let parts: Vec<&str> =
            head.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty()).collect();
        parts.join("_")
    };
    let mut names = heads.iter().map(name);
    let columns: Vec<Column> =
        names.next().map(Column::text).into_iter().chain(names.map(Column::real)).collect();
    let mut values = vec![Values::Text(rows.iter().map(|(name, _)| name.clone()).collect())];
    values.extend((1..columns.len()).map(|k| Values::Real(rows.iter().map(|(_, row)| row[k - 1]).collect())));
    write(path, form, &columns, &[], |writer| {
        writer.push(Rows::of(values)).map_err(|error| cannot_write(path, error))
    })
}

/// Writes a table: what `fill` pushes, then the metadata and the hash, into the footer or, for CSV, into a file `TABLE.json` beside it.
pub fn write(
    path: &Path,
    form: Form,
    columns: &[Column],
    metadata: &[(String, String)],
    fill: impl FnOnce(&mut TableWriter<&File>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    // The metadata in the order in which they are read back.
    let mut entries: BTreeMap<_, _> = metadata.iter().cloned().collect();
    let in_order: Vec<_> = entries.clone().into_iter().collect();
    let whole = |file: &File| {
        let table = |error: TableError| cannot_write(path, error);
        let mut writer = TableWriter::new(form, file, columns).map_err(table)?;
        fill(&mut writer)?;
        writer.finish(if form == Form::Csv { &in_order } else { metadata }).map_err(table)
    };
    let put = |error: PutError| cannot_write(path, error);
    // A pipe or a device is written as it is; a file is put in its place when it is whole.
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        let file = File::create(path).map_err(|error| cannot_write(path, error))?;
        return whole(&file).map(drop);
    }
    let file = NewFile::beside(path, Over::Anything).map_err(put)?;
    entries.insert(SEAL.to_owned(), whole(file.file())?);
    if form == Form::Csv {
        let beside = NewFile::beside(&beside(path, ".json"), Over::Anything).map_err(put)?;
        let text = serde_json::to_vec_pretty(&entries).map_err(Failure::own)?;
        beside.file().write_all(&text).map_err(|error| cannot_write(path, error))?;
        beside.put().map_err(put)?;
    }
    file.put().map_err(put)
}
