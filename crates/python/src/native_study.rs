//! Studies in blocks as Python holds them.

use crate::answer::Answer;
use crate::blocks::{Blocks, cannot_read, held_of, open};
use crate::cases::{Slice, case_blocks};
use crate::failure::Failure;
use crate::guard::{unlocked, waited_for};
use crate::native_engine::NativeEngine;
use crate::options::Options;
use crate::questions;
use lanchester::run::{Head, part};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::path::PathBuf;
use std::sync::Arc;

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
