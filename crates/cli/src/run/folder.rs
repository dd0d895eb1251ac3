//! What a run has done so far: a folder of small tables, each a stretch of blocks, whole or not there.

use super::head::held_of;
use super::table_file;
use crate::failure::Failure;
use lanchester::run::{Head, Held, numbered};
use lanchester::table::{Column, Form, Rows, TableError, TableReader};
use lanchester_files::shown;
use serde::Serialize;
use std::fs::{self, File, TryLockError};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The folder of a run, which no other run may use meanwhile.
pub struct Folder {
    path: PathBuf,
    blocks: Range<u64>,
    of: u64,
    /// What is done, in order.
    done: Vec<Range<u64>>,
    _lock: File,
}

impl Folder {
    /// Opens the folder beside `table`, or makes it.
    pub fn open(table: &Path, head: &Head, blocks: Range<u64>, of: u64) -> Result<Folder, Failure> {
        let path = table_file::beside(table, ".run");
        let cannot = |error: std::io::Error| {
            Failure::input(format_args!("cannot write {}: {error}", shown(&path)), "choose another place")
        };
        fs::create_dir_all(&path).map_err(cannot)?;
        let lock = File::create(path.join("lock")).map_err(cannot)?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(Failure::input(
                    format_args!("another run is at work on {}", shown(&path)),
                    "wait for it, or choose another name for the table",
                ));
            }
            Err(TryLockError::Error(error)) => return Err(cannot(error)),
        }
        let mut folder = Folder { path, blocks, of, done: Vec::new(), _lock: lock };
        let mut next = folder.blocks.start;
        for table in folder.tables()? {
            let held = held(&table, of)?;
            let fits = next <= held.blocks.start
                && held.blocks.start < held.blocks.end
                && held.blocks.end <= folder.blocks.end;
            if held.head != *head || !fits || held.of != folder.of {
                return Err(Failure::input(
                    format_args!("{} holds what another run has begun", shown(&folder.path)),
                    "run that one to its end, choose another name for the table, or remove the folder",
                ));
            }
            next = held.blocks.end;
            folder.done.push(held.blocks);
        }
        Ok(folder)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The blocks that were done when it was opened, in order.
    pub fn done(&self) -> &[Range<u64>] {
        &self.done
    }

    /// The blocks that were not.
    pub fn missing(&self) -> Vec<Range<u64>> {
        let starts = std::iter::once(self.blocks.start).chain(self.done.iter().map(|done| done.end));
        let ends = self.done.iter().map(|done| done.start).chain(std::iter::once(self.blocks.end));
        starts.zip(ends).map(|(start, end)| start..end).filter(|gap| !gap.is_empty()).collect()
    }

    /// The tables that are done, in the order of their blocks.
    pub fn tables(&self) -> Result<Vec<PathBuf>, Failure> {
        let cannot = |error: std::io::Error| {
            Failure::input(format_args!("cannot read {}: {error}", shown(&self.path)), "may it be read?")
        };
        let mut tables = Vec::new();
        for entry in fs::read_dir(&self.path).map_err(cannot)? {
            let path = entry.map_err(cannot)?.path();
            if path.extension().is_some_and(|ending| ending == "parquet") {
                tables.push(path);
            }
        }
        // The names are numbers of one length.
        tables.sort();
        Ok(tables)
    }

    /// Puts what a stretch of blocks gave onto the disk.
    pub fn put(
        &self,
        head: &Head,
        columns: &[Column],
        blocks: Range<u64>,
        kept: &impl Serialize,
        rows: Rows,
    ) -> Result<(), Failure> {
        let path = self.path.join(format!("{:020}-{:020}.parquet", blocks.start, blocks.end));
        let metadata = head.metadata(blocks, self.of, kept)?;
        table_file::write(&path, Form::Parquet, columns, &metadata, |writer| {
            writer.push(rows).map_err(|error| table_file::cannot_write(&path, error))
        })
    }

    /// Removes the folder once its table stands.
    pub fn remove(self) -> Result<(), Failure> {
        fs::remove_dir_all(&self.path).map_err(|error| {
            Failure::input(
                format_args!("the table stands, but {} cannot be removed: {error}", shown(&self.path)),
                "remove it by hand",
            )
        })
    }
}

/// What a table of the folder holds, every byte of it verified.
fn held(table: &Path, of: u64) -> Result<Held, Failure> {
    let file = File::open(table).map_err(TableError::from);
    let verified = file.and_then(TableReader::open).and_then(|reader| reader.verify().map(|()| reader));
    verified.map_err(|error| damaged(table, of, error)).and_then(|reader| held_of(&reader, table))
}

/// A table of the folder that is not what was written: its blocks by its name, which is outside of it.
fn damaged(table: &Path, of: u64, error: TableError) -> Failure {
    let name = table.file_stem().unwrap_or_default().to_string_lossy();
    let range =
        name.split_once('-').and_then(|(start, end)| Some(start.parse().ok()?..end.parse::<u64>().ok()?));
    let blocks = range.map_or_else(|| "blocks".to_owned(), |range: Range<u64>| numbered(&range, of));
    Failure::input(
        format_args!("{blocks} cannot be read from {}: {error}", shown(table)),
        "remove this file: the same command computes its blocks again, and no others",
    )
}
