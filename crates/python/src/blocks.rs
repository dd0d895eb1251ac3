//! Studies cut into blocks, each with its rows: a stretch of blocks becomes a table, tables become one.
//!
//! What is written is what `lanchester` writes with `--save` and `--part`, to the last byte ([decision
//! 17](../../docs/decisions/0017-long-runs-and-their-tables.md)).

use crate::answer::{Answer, Data};
use crate::cases::{Slice, case_blocks};
use crate::failure::Failure;
use crate::guard::{Watch, unlocked, waited_for};
use crate::native_engine::NativeEngine;
use crate::options::Options;
use crate::questions;
use lanchester::run::{Head, HeadError, Held, Study, numbered, part, stretch};
use lanchester::table::{Form, Rows, TableError, TableReader, TableWriter};
use lanchester_files::{NewFile, Over, open_regular, shown};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

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

fn open(path: &Path) -> Result<TableReader<File>, Failure> {
    let file = open_regular(path).map_err(|error| cannot_read(path, &error.into()))?;
    TableReader::open(file).map_err(|error| cannot_read(path, &error))
}

fn held_of(reader: &TableReader<File>, path: &Path) -> Result<Held, Failure> {
    Held::of(reader).ok_or_else(|| {
        Failure::option(
            format_args!("{} does not say what it holds: lanchester has not written it", shown(path)),
            "choose another folder, or remove it first",
        )
    })
}

fn cannot_read(path: &Path, error: &TableError) -> Failure {
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

/// A study in blocks as Python holds it.
#[pyclass(frozen, name = "Study", module = "lanchester._native")]
pub struct NativeStudy {
    blocks: Arc<dyn Blocks>,
    texts: Vec<String>,
}

#[pymethods]
impl NativeStudy {
    /// Number of blocks.
    #[getter]
    fn blocks(&self) -> u64 {
        self.blocks.blocks()
    }

    /// Number of cases.
    #[getter]
    fn cases(&self) -> u128 {
        self.blocks.cases()
    }

    /// What all tables of the study have alike: study, version, request, engine.
    fn head<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        head_of(py, self.blocks.head())
    }

    /// Of a study of engines that differ in keys: the keys whose column is of texts.
    #[getter]
    fn texts(&self) -> Vec<String> {
        self.texts.clone()
    }

    /// The blocks of part `number` (from 1) of `parts`.
    fn part(&self, number: u64, parts: u64) -> Option<(u64, u64)> {
        part(self.blocks.blocks(), number, parts).map(|blocks| (blocks.start, blocks.end))
    }

    /// The table of a stretch of blocks as Parquet.
    fn table<'py>(&self, py: Python<'py>, first: u64, end: u64) -> PyResult<Bound<'py, PyBytes>> {
        let of = self.blocks.blocks();
        if first >= end || end > of {
            let message = format!("blocks {first} to {end} are none of the {of} blocks of the study");
            return Err(Failure::option(message, "they are counted from 0, the end excluded").into());
        }
        let blocks = self.blocks.clone();
        let bytes = waited_for(py, move |watch| blocks.table(first..end, None, watch))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The table of all these engines as blocks `first` to `end` of the study of `of` blocks that `head` tells of.
    fn slice<'py>(
        &self,
        py: Python<'py>,
        head: &Bound<'py, PyDict>,
        first: u64,
        end: u64,
        of: u64,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let own = self.blocks.blocks();
        if first.checked_add(own) != Some(end) || end > of {
            let message = format!("{own} blocks of engines are not blocks {first} to {end} of {of}");
            return Err(Failure::option(message, "give the engines of these blocks").into());
        }
        let text = |key: &str| -> PyResult<String> {
            head.get_item(key)?.ok_or_else(|| Failure::Internal(format!("a head without {key}")))?.extract()
        };
        let head = Head {
            study: text("study")?,
            version: text("version")?,
            request: text("request")?,
            engine: text("engine")?,
        };
        let blocks = self.blocks.clone();
        let told = Some((head, first..end, of));
        let bytes = waited_for(py, move |watch| blocks.table(0..own, told, watch))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The answer of the study from the tables of all its blocks; with `whole` these become one table there.
    #[pyo3(signature = (tables, whole=None))]
    fn join(&self, py: Python<'_>, tables: Vec<PathBuf>, whole: Option<PathBuf>) -> PyResult<Option<Answer>> {
        let blocks = self.blocks.clone();
        let found = waited_for(py, move |_| blocks.join(&tables, whole.as_deref()))?;
        Ok(found.map(Answer::from))
    }
}

/// A study in blocks: of layouts (`explore`), of production (`scatter`), or any other question about many engines, of which `pick` names the
/// numbers that are kept; `start` and `texts` where they are a slice of the engines of a study.
#[pyfunction]
#[pyo3(signature = (name, engines, options, columns=None, pick=None, start=0, texts=None))]
pub fn study(
    name: &str,
    engines: Vec<PyRef<'_, NativeEngine>>,
    options: Bound<'_, PyDict>,
    columns: Option<Bound<'_, PyDict>>,
    pick: Option<Vec<String>>,
    start: usize,
    texts: Option<Vec<String>>,
) -> PyResult<NativeStudy> {
    let found = match (&pick, engines.as_slice()) {
        (None, [engine]) => questions::blocks(name, &Options::new(options.clone()), &engine.prepared)?,
        _ => None,
    };
    let (found, texts) = match found {
        Some(found) => (found, Vec::new()),
        None => {
            let slice = Slice { start, texts };
            case_blocks(name, &engines, &options, columns, pick.unwrap_or_default(), slice)?
        }
    };
    Ok(NativeStudy { blocks: found.into(), texts })
}

/// What a table of a study holds, every byte of it verified: study, version, request, engine, first block, end, blocks of the study.
#[pyfunction]
pub fn held(py: Python<'_>, path: PathBuf) -> PyResult<(Bound<'_, PyDict>, u64, u64, u64)> {
    let held = unlocked(py, || {
        let reader = open(&path)?;
        reader.verify().map_err(|error| cannot_read(&path, &error))?;
        held_of(&reader, &path)
    })?;
    Ok((head_of(py, &held.head)?, held.blocks.start, held.blocks.end, held.of))
}

fn head_of<'py>(py: Python<'py>, head: &Head) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    found.set_item("study", &head.study)?;
    found.set_item("version", &head.version)?;
    found.set_item("request", &head.request)?;
    found.set_item("engine", &head.engine)?;
    Ok(found)
}
