//! What a run has done so far: a folder of small tables, each a stretch of blocks, whole or not there.

use super::head::{Head, Held};
use super::table_file;
use crate::failure::Failure;
use lanchester::table::{Column, Form, Rows};
use serde::Serialize;
use std::fs::{self, File, TryLockError};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The folder of a run, which no other run may use meanwhile.
pub struct Folder {
    path: PathBuf,
    blocks: Range<u64>,
    of: u64,
    next: u64,
    _lock: File,
}

impl Folder {
    /// Opens the folder beside `table`, or makes it.
    pub fn open(table: &Path, head: &Head, blocks: Range<u64>, of: u64) -> Result<Folder, Failure> {
        let path = table_file::beside(table, ".run");
        let cannot = |error: std::io::Error| {
            Failure::input(format_args!("cannot write {}: {error}", path.display()), "choose another place")
        };
        fs::create_dir_all(&path).map_err(cannot)?;
        let lock = File::create(path.join("lock")).map_err(cannot)?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(Failure::input(
                    format_args!("another run is at work on {}", path.display()),
                    "wait for it, or choose another name for the table",
                ));
            }
            Err(TryLockError::Error(error)) => return Err(cannot(error)),
        }
        let mut folder = Folder { next: blocks.start, path, blocks, of, _lock: lock };
        for table in folder.tables()? {
            let held = Held::of(&table_file::open(&table)?, &table)?;
            if held.head != *head || held.blocks.start != folder.next || held.of != folder.of {
                return Err(Failure::input(
                    format_args!("{} holds what another run has begun", folder.path.display()),
                    "run that one to its end, choose another name for the table, or remove the folder",
                ));
            }
            folder.next = held.blocks.end;
        }
        Ok(folder)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The first block that is not yet done.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// The tables that are done, in the order of their blocks.
    pub fn tables(&self) -> Result<Vec<PathBuf>, Failure> {
        let cannot = |error: std::io::Error| {
            Failure::input(format_args!("cannot read {}: {error}", self.path.display()), "may it be read?")
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
        let path = self.path.join(format!("{:020}.parquet", blocks.start));
        let metadata = head.metadata(blocks, self.of, kept)?;
        table_file::write(&path, Form::Parquet, columns, &metadata, |writer| {
            writer.push(rows).map_err(|error| table_file::cannot_write(&path, error))
        })
    }

    /// Removes the folder once its table stands.
    pub fn remove(self) -> Result<(), Failure> {
        debug_assert!(self.next <= self.blocks.end);
        fs::remove_dir_all(&self.path).map_err(|error| {
            Failure::input(
                format_args!("the table stands, but {} cannot be removed: {error}", self.path.display()),
                "remove it by hand",
            )
        })
    }
}
