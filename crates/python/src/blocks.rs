//! Studies cut into blocks, each with its rows: a stretch of blocks becomes a table, tables become one.
//!
//! What is written is what `lanchester` writes with `--save` and `--part`, to the last byte ([decision
//! 17](../../docs/decisions/0017-long-runs-and-their-tables.md)).

use crate::answer::Data;
use crate::failure::Failure;
use crate::guard::Watch;
use lanchester::run::{Head, HeadError, Held, Study, numbered, stretch};
use lanchester::table::{Form, Rows, TableError, TableReader, TableWriter};
use lanchester_files::{NewFile, Over, open_regular, shown};
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Blocks for each thread between two looks whether somebody waits.
const BLOCKS_PER_THREAD: u64 = 4;

/// A study in blocks whose type is forgotten.
pub trait Blocks: Send + Sync {
    /// Number of blocks.
    fn blocks(&self) -> u64;

    /// Number of cases.
    fn cases(&self) -> u128;

    /// What all its tables have alike.
    fn head(&self) -> &Head;

    /// The table of a stretch of blocks, as Parquet; `told` is what it says of itself where these are blocks of a larger study.
    ///
    /// # Errors
    /// Where a block cannot be computed.
    fn table(&self, blocks: Range<u64>, told: Option<Told>, watch: &Watch) -> Result<Vec<u8>, Failure>;

    /// The answer of the whole study from the tables of all its blocks, in any order; with `whole`, these become one table there.
    ///
    /// # Errors
    /// Where they are not all tables of this study, or one is damaged.
    fn join(&self, tables: &[PathBuf], whole: Option<&Path>) -> Result<Option<Data>, Failure>;
}

/// What a table says of itself: head, blocks, blocks of the whole study.
pub type Told = (Head, Range<u64>, u64);

/// The answer of a study from what is kept of all its blocks.
pub type Answered<S> = Box<dyn Fn(&S, &<S as Study>::Kept) -> Result<Option<Data>, Failure> + Send + Sync>;

/// A study with what its tables say of it.
pub struct Tabled<S: Study> {
    /// The study.
    pub study: S,
    /// What its tables have alike.
    pub head: Head,
    /// Its error in the words of Python.
    pub fail: fn(S::Error) -> Failure,
    /// Its answer.
    pub answer: Answered<S>,
}

impl<S: Study + Send> Tabled<S> {
    fn metadata(&self, blocks: Range<u64>, kept: &S::Kept) -> Result<Vec<(String, String)>, Failure> {
        Ok(self.head.metadata(blocks, self.study.blocks(), kept)?)
    }

    /// The tables with what they hold, in the order of their blocks: all of this study, each block once.
    fn whole(&self, tables: &[PathBuf]) -> Result<Vec<(PathBuf, Held)>, Failure> {
        let mut all = Vec::with_capacity(tables.len());
        for path in tables {
            let held = held_of(&open(path)?, path)?;
            if held.head != self.head || held.of != self.study.blocks() {
                return Err(Failure::option(
                    format_args!("{} is no part of this study", shown(path)),
                    "parts have one engine file, the same arguments and one version of lanchester",
                ));
            }
            all.push((path.clone(), held));
        }
        all.sort_by_key(|(_, held)| (held.blocks.start, held.blocks.end));
        let mut next = 0;
        for (path, held) in &all {
            if held.blocks.start < next {
                return Err(Failure::option(
                    format_args!("{} holds blocks that another part holds too", shown(path)),
                    "name every part once",
                ));
            }
            if held.blocks.start > next {
                return Err(missing(&(next..held.blocks.start), self.study.blocks()));
            }
            next = held.blocks.end;
        }
        match next == self.study.blocks() {
            true => Ok(all),
            false => Err(missing(&(next..self.study.blocks()), self.study.blocks())),
        }
    }
}

fn missing(blocks: &Range<u64>, of: u64) -> Failure {
    Failure::option(
        format_args!("{} are in none of the tables", numbered(blocks, of)),
        "run the study to its end: what is done is not computed again",
    )
}

impl<S: Study + Send> Blocks for Tabled<S> {
    fn blocks(&self) -> u64 {
        self.study.blocks()
    }

    fn cases(&self) -> u128 {
        self.study.cases(0..self.study.blocks())
    }

    fn head(&self) -> &Head {
        &self.head
    }

    fn table(&self, blocks: Range<u64>, told: Option<Told>, watch: &Watch) -> Result<Vec<u8>, Failure> {
        let study = &self.study;
        let columns = study.columns();
        let (mut kept, mut rows) = (study.nothing(), Rows::empty(&columns));
        let batch = BLOCKS_PER_THREAD * rayon::current_num_threads() as u64;
        let mut next = blocks.start;
        while next < blocks.end && watch.goes_on() {
            let end = blocks.end.min(next + batch);
            let (more, found) = stretch(study, next..end).map_err(self.fail)?;
            kept = study.join(kept, more).map_err(self.fail)?;
            rows.append(found);
            next = end;
        }
        let rows = study.last_rows(&kept).map_err(self.fail)?.unwrap_or(rows);
        let mut bytes = Vec::new();
        let mut writer = TableWriter::new(Form::Parquet, &mut bytes, &columns).map_err(Failure::refused)?;
        writer.push(rows).map_err(Failure::refused)?;
        let metadata = match told {
            Some((head, blocks, of)) => head.metadata(blocks, of, &kept)?,
            None => self.metadata(blocks, &kept)?,
        };
        writer.finish(&metadata).map_err(Failure::refused)?;
        Ok(bytes)
    }

    fn join(&self, tables: &[PathBuf], whole: Option<&Path>) -> Result<Option<Data>, Failure> {
        let study = &self.study;
        let all = self.whole(tables)?;
        let mut kept = study.nothing();
        for (_, held) in &all {
            kept = study.join(kept, held.kept()?).map_err(self.fail)?;
        }
        if let Some(path) = whole {
            let put = |error: &dyn std::fmt::Display| cannot_write(path, error);
            let columns = study.columns();
            let file = NewFile::beside(path, Over::Nothing).map_err(|error| put(&error))?;
            let mut writer =
                TableWriter::new(Form::Parquet, file.file(), &columns).map_err(|error| put(&error))?;
            match study.last_rows(&kept).map_err(self.fail)? {
                Some(rows) => writer.push(rows).map_err(|error| put(&error))?,
                None => {
                    for (table, _) in &all {
                        let mut reader = open(table)?;
                        while let Some(rows) =
                            reader.next(&columns).map_err(|error| cannot_read(table, &error))?
                        {
                            writer.push(rows).map_err(|error| put(&error))?;
                        }
                    }
                }
            }
            writer.finish(&self.metadata(0..study.blocks(), &kept)?).map_err(|error| put(&error))?;
            file.put().map_err(|error| put(&error))?;
        }
        (self.answer)(study, &kept)
    }
}

impl From<HeadError> for Failure {
    fn from(error: HeadError) -> Failure {
        match error {
            HeadError::Kept(_) => Failure::refused(error),
            other => Failure::Internal(other.to_string()),
        }
    }
}

/// Opens a table, its footer verified.
///
/// # Errors
/// Where it is none, or damaged.
pub fn open(path: &Path) -> Result<TableReader<File>, Failure> {
    let file = open_regular(path).map_err(|error| cannot_read(path, &error.into()))?;
    TableReader::open(file).map_err(|error| cannot_read(path, &error))
}

/// What a table holds.
///
/// # Errors
/// Where it does not say so.
pub fn held_of(reader: &TableReader<File>, path: &Path) -> Result<Held, Failure> {
    Held::of(reader).ok_or_else(|| {
        Failure::option(
            format_args!("{} does not say what it holds: lanchester has not written it", shown(path)),
            "choose another folder, or remove it first",
        )
    })
}

/// Why a table cannot be read.
pub fn cannot_read(path: &Path, error: &TableError) -> Failure {
    Failure::option(
        format_args!("cannot read {}: {error}", shown(path)),
        "remove it: the same study computes its blocks again, and no others",
    )
}

fn cannot_write(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::option(
        format_args!("cannot write {}: {error}", shown(path)),
        "choose another name; what is done stays as it is",
    )
}
