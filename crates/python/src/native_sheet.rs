//! A workshop sheet as Python holds it.

use crate::failure::{Failure, diagnostics};
use crate::from_python::sheet_text;
use crate::guard::unlocked;
use crate::prepared::{Prepared, sheet_file_text};
use lanchester::file::Diagnostic;
use lanchester::file::workshop::read_sheet;
use lanchester::model::Engine;
use lanchester::task::workshop::Sheet;
use lanchester_files::shown;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A workshop sheet that was read.
#[derive(Debug)]
pub struct ReadSheet {
    /// Its text.
    text: String,
    /// Where the engine file is that it names; `None` for a text without a place.
    folder: Option<PathBuf>,
    /// It.
    pub sheet: Sheet,
    /// Warnings of the reader.
    warnings: Vec<Diagnostic>,
}

impl ReadSheet {
    fn of_text(text: String, name: String, folder: Option<PathBuf>) -> Result<ReadSheet, Failure> {
        let reading = read_sheet(&text);
        match reading.sheet {
            Some(sheet) => Ok(ReadSheet { text, folder, sheet, warnings: reading.diagnostics }),
            None => Err(Failure::Mistakes { name, text, diagnostics: reading.diagnostics }),
        }
    }

    /// The engine that it names.
    ///
    /// # Errors
    /// Where its file cannot be read or has mistakes.
    pub fn engine(&self) -> Result<Option<Engine>, Failure> {
        let Some(name) = &self.sheet.engine else { return Ok(None) };
        let folder = self.folder.as_ref().ok_or_else(|| {
            Failure::option(
                format_args!(
                    "the sheet names the engine file {name}, and the sheet comes from a text without a folder"
                ),
                "give `folder=`, or read the sheet from its file",
            )
        })?;
        Ok(Some(Prepared::read(&folder.join(name))?.file.engine))
    }
}

/// A workshop sheet that was read.
#[pyclass(frozen, name = "Sheet", module = "lanchester._native")]
pub struct NativeSheet {
    /// It.
    pub read: Arc<ReadSheet>,
}

#[pymethods]
impl NativeSheet {
    /// Reads a file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<NativeSheet> {
        let read = unlocked(py, || {
            let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
            ReadSheet::of_text(sheet_file_text(&path)?, shown(&path), Some(folder))
        })?;
        Ok(NativeSheet { read: Arc::new(read) })
    }

    /// Reads a text.
    #[staticmethod]
    #[pyo3(signature = (text, name, folder=None))]
    fn of_text(py: Python<'_>, text: String, name: String, folder: Option<PathBuf>) -> PyResult<NativeSheet> {
        Ok(NativeSheet { read: Arc::new(unlocked(py, || ReadSheet::of_text(text, name, folder))?) })
    }

    /// Makes one of plain values, numbers being SI.
    #[staticmethod]
    #[pyo3(signature = (values, folder=None))]
    fn of_values(
        py: Python<'_>,
        values: &Bound<'_, PyDict>,
        folder: Option<PathBuf>,
    ) -> PyResult<NativeSheet> {
        let text = sheet_text(values)?;
        NativeSheet::of_text(py, text, "<sheet from values>".into(), folder)
    }

    /// Its text.
    #[getter]
    fn text(&self) -> &str {
        &self.read.text
    }

    /// Where the engine file is that it names; `None` for a text without a place.
    #[getter]
    fn folder(&self) -> Option<PathBuf> {
        self.read.folder.clone()
    }

    /// What is balanced.
    #[getter]
    fn name(&self) -> &str {
        &self.read.sheet.name
    }

    /// Warnings of its reader.
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        diagnostics(py, &self.read.text, &self.read.warnings)
    }
}
