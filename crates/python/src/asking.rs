//! Asking a question from Python.

use crate::answer::Answer;
use crate::failure::Failure;
use crate::guard::{Watch, unlocked, waited_for};
use crate::native_engine::NativeEngine;
use crate::native_sheet::NativeSheet;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::How;
use crate::questions::{question, sheet_question};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use std::time::Instant;

/// The answer to a question about several engines.
#[pyfunction]
pub fn ask_all(
    py: Python<'_>,
    name: &str,
    engines: Vec<PyRef<'_, NativeEngine>>,
    options: Bound<'_, PyDict>,
) -> PyResult<Answer> {
    let engines: Vec<Arc<Prepared>> = engines.iter().map(|engine| engine.prepared.clone()).collect();
    answer(py, name, &engines, options)
}

fn answer(
    py: Python<'_>,
    name: &str,
    engines: &[Arc<Prepared>],
    options: Bound<'_, PyDict>,
) -> PyResult<Answer> {
    let question = question(name)?;
    let run = (question.read)(&Options::new(options))?;
    let found = match question.how {
        How::Short => unlocked(py, || run(engines, &Watch::default()))?,
        How::Long => {
            let engines = engines.to_vec();
            waited_for(py, move |watch| run(&engines, watch))?
        }
    };
    Ok(found.into())
}

/// The answer to a question about a workshop sheet.
#[pyfunction]
pub fn ask_sheet(py: Python<'_>, name: &str, sheet: PyRef<'_, NativeSheet>) -> PyResult<Answer> {
    let (question, read) = (sheet_question(name)?, sheet.read.clone());
    Ok(unlocked(py, || (question.run)(&read))?.into())
}

/// Seconds of one answer without Python: what the cost of a call is compared with.
#[pyfunction]
pub fn kernel_time(
    py: Python<'_>,
    engine: PyRef<'_, NativeEngine>,
    name: &str,
    options: Bound<'_, PyDict>,
    repeats: u32,
) -> PyResult<f64> {
    let run = (question(name)?.read)(&Options::new(options))?;
    let engines = [engine.prepared.clone()];
    Ok(unlocked(py, || {
        let began = Instant::now();
        for _ in 0..repeats {
            std::hint::black_box(run(&engines, &Watch::default())?);
        }
        Ok(began.elapsed().as_secs_f64() / f64::from(repeats.max(1)))
    })?)
}

/// Panics where a computation would, for the test that no panic crosses.
#[pyfunction]
pub fn panics(py: Python<'_>) -> PyResult<()> {
    Ok(unlocked(py, || -> Result<(), Failure> { panic!("a panic for the test") })?)
}

/// The schemas of all results: definitions, and the name of that of every question.
#[pyfunction]
pub fn schemas(py: Python<'_>) -> PyResult<Py<PyAny>> {
    let (definitions, names) = crate::questions::schemas();
    let found = PyDict::new(py);
    found.set_item("definitions", definitions.to_string())?;
    found.set_item("questions", names)?;
    Ok(found.into_any().unbind())
}
