//! The engine as Python holds it.

use crate::failure::{Failure, diagnostics};
use crate::from_python::{self, Changes};
use crate::guard::unlocked;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::solids::{SolidsRequest, solids_file};
use lanchester::file::{CompleteError, EngineKind, TypicalSection, complete, expanded, template, templates};
use lanchester::model::Engine;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};
use std::path::PathBuf;
use std::sync::Arc;

/// A completed engine, the sections that were inserted, and those that the engine cannot have, each with its reason.
type Completed = (NativeEngine, Vec<&'static str>, Vec<(&'static str, String)>);

/// An engine file that was read.
#[pyclass(frozen, name = "Engine", module = "lanchester._native")]
pub struct NativeEngine {
    /// It.
    pub prepared: Arc<Prepared>,
}

impl From<Arc<Prepared>> for NativeEngine {
    fn from(prepared: Arc<Prepared>) -> NativeEngine {
        NativeEngine { prepared }
    }
}

#[pymethods]
impl NativeEngine {
    /// Reads a file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<NativeEngine> {
        Ok(Arc::new(unlocked(py, || Prepared::read(&path))?).into())
    }

    /// Reads a text.
    #[staticmethod]
    #[pyo3(signature = (text, name, folder=None))]
    fn of_text(
        py: Python<'_>,
        text: String,
        name: String,
        folder: Option<PathBuf>,
    ) -> PyResult<NativeEngine> {
        Ok(Arc::new(unlocked(py, || Prepared::of_text(text, name, folder))?).into())
    }

    /// Makes one of plain values, numbers being SI.
    #[staticmethod]
    #[pyo3(signature = (values, folder=None))]
    fn of_values(
        py: Python<'_>,
        values: &Bound<'_, PyDict>,
        folder: Option<PathBuf>,
    ) -> PyResult<NativeEngine> {
        let text = from_python::file_text(values)?;
        NativeEngine::of_text(py, text, "<engine from values>".into(), folder)
    }

    /// The names of the gallery with their titles.
    #[staticmethod]
    fn templates() -> Vec<(&'static str, &'static str)> {
        templates().iter().map(|own| (own.name, own.title)).collect()
    }

    /// One of the gallery.
    #[staticmethod]
    fn template(py: Python<'_>, name: &str) -> PyResult<NativeEngine> {
        let found = template(name).ok_or_else(|| {
            let near = lanchester::file::nearest_template(name)
                .map(|near| format!("did you mean \"{}\"? ", near.name));
            Failure::option(
                format_args!("the gallery has no engine \"{name}\""),
                format_args!("{}`Engine.templates()` lists all", near.unwrap_or_default()),
            )
        })?;
        NativeEngine::of_text(py, found.text.to_owned(), format!("{name}.toml"), None)
    }

    /// A copy with other values of keys.
    fn with_changes(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<NativeEngine> {
        let changes = Changes::read(changes)?;
        let own = &self.prepared;
        Ok(unlocked(py, || own.with_text(changes.apply(&own.text)?))?.into())
    }

    /// A copy with typical values for these sections, all that are missing where none is named; and what it cannot have.
    fn completed(&self, py: Python<'_>, sections: Vec<String>, kind: Option<&str>) -> PyResult<Completed> {
        let list =
            |words: Vec<&str>| words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        let section = |word: &String| {
            TypicalSection::of_word(word).ok_or_else(|| {
                let all = TypicalSection::ALL.map(TypicalSection::word).to_vec();
                Failure::option(
                    format_args!("there are no typical values for \"{word}\""),
                    format_args!("take one of {}", list(all)),
                )
            })
        };
        let sections = sections.iter().map(section).collect::<Result<Vec<TypicalSection>, Failure>>()?;
        let of_kind = |word: &str| {
            EngineKind::of_word(word).ok_or_else(|| {
                let all = EngineKind::ALL.map(EngineKind::word).to_vec();
                Failure::option(
                    format_args!("there is no kind of engine \"{word}\""),
                    format_args!("take one of {}", list(all)),
                )
            })
        };
        let kind = kind.map(of_kind).transpose()?;
        let own = &self.prepared;
        let done = unlocked(py, || {
            let done = complete(&own.text, &sections, kind).map_err(|error| match error {
                CompleteError::Unfit { text, diagnostics, .. } => {
                    Failure::Mistakes { name: "the completed file".into(), text, diagnostics }
                }
                CompleteError::File(diagnostics) => {
                    Failure::Mistakes { name: own.name.clone(), text: own.text.clone(), diagnostics }
                }
                other => Failure::refused(other),
            })?;
            if let Some(left) = done.left_out.iter().find(|left| sections.contains(&left.section)) {
                return Err(Failure::option(
                    format_args!("{} cannot be had for this engine: {}", left.section, left.why),
                    "leave it out",
                ));
            }
            Ok((own.with_text(done.text.clone())?, done))
        })?;
        let (prepared, done) = done;
        let added = done.added.iter().map(|section| section.word()).collect();
        let left_out = done.left_out.iter().map(|left| (left.section.word(), left.why.clone())).collect();
        Ok((prepared.into(), added, left_out))
    }

    /// Its text.
    #[getter]
    fn text(&self) -> &str {
        &self.prepared.text
    }

    /// Where files are that it names; `None` for a text without a place.
    #[getter]
    fn folder(&self) -> Option<PathBuf> {
        self.prepared.folder.clone()
    }

    /// What messages call its file.
    #[getter]
    fn file_name(&self) -> &str {
        &self.prepared.name
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.prepared.engine().name
    }

    /// The general form of its file.
    fn expanded(&self, py: Python<'_>) -> PyResult<String> {
        Ok(unlocked(py, || Ok(expanded(&self.prepared.file)))?)
    }

    /// Its counterweights, crankshaft or balance shafts as a file of solids or an outline: `ending` says which.
    fn solids<'py>(
        &self,
        py: Python<'py>,
        ending: &str,
        options: Bound<'py, PyDict>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let options = Options::new(options);
        let engine = self.prepared.engine();
        let last = engine.crankshafts.len().saturating_sub(1) as u64;
        let asked = SolidsRequest {
            weights: options.texts("weight")?,
            shafts: options.texts("shaft")?,
            crankshaft: options.whole("crankshaft", 0, last)?.unwrap_or(0) as usize,
            facet: options.length("facet")?,
        };
        Ok(PyBytes::new(py, &unlocked(py, || solids_file(engine, ending, &asked))?))
    }

    /// Warnings of its reader.
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        diagnostics(py, &self.prepared.text, &self.prepared.warnings)
    }

    /// Lowest and highest speed [rad/s], number of cylinders, and a drawing as SVG.
    fn summary(&self, py: Python<'_>) -> PyResult<(f64, f64, usize, String)> {
        let engine: &Engine = self.prepared.engine();
        let drawing = unlocked(py, || Ok(lanchester::report::drawing(engine).svg()))?;
        Ok((engine.speed.lowest, engine.speed.highest, engine.cylinders.len(), drawing))
    }

    /// Whether it is the same file.
    fn __eq__(&self, other: &NativeEngine) -> bool {
        let (one, other) = (&self.prepared, &other.prepared);
        Arc::ptr_eq(one, other) || (one.text == other.text && one.folder == other.folder)
    }

    /// Of its text.
    fn __hash__(&self) -> u64 {
        lanchester::fnv1a(self.prepared.text.as_bytes())
    }
}
