//! One question about many engines at once, on all processors.

use crate::answer::{Answer, Data};
use crate::failure::Failure;
use crate::from_python::{Changes, value_of};
use crate::guard::{Watch, caught, waited_for};
use crate::native_engine::NativeEngine;
use crate::options::Options;
use crate::prepared::Prepared;
use crate::question::Run;
use crate::questions::question;
use crate::select::{Step, steps};
use crate::to_python::{array, numbers};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use rayon::prelude::*;
use serde_json::Value;
use std::sync::Arc;

/// Engines of one look for Ctrl-C.
const BLOCK: usize = 256;

/// The engines of a call.
pub enum Engines {
    /// These.
    Given(Vec<Arc<Prepared>>),
    /// One, with other values: by path, one value an engine.
    Changed { base: Arc<Prepared>, columns: Vec<(String, Vec<Value>)>, count: usize },
}

impl Engines {
    /// How many.
    pub fn count(&self) -> usize {
        match self {
            Engines::Given(all) => all.len(),
            Engines::Changed { count, .. } => *count,
        }
    }

    /// The engine at a place.
    ///
    /// # Errors
    /// Where the changed text is no engine.
    pub fn at(&self, place: usize) -> Result<Arc<Prepared>, Failure> {
        match self {
            Engines::Given(all) => Ok(all[place].clone()),
            Engines::Changed { base, columns, .. } => {
                // What is not given stays as the engine has it.
                let given = columns.iter().filter(|(_, values)| !values[place].is_null());
                let changes = given.fold(Changes::none(), |changes, (path, values)| {
                    changes.and(path, values[place].clone())
                });
                base.with_text(changes.apply(&base.text)?)
            }
        }
    }
}

/// The answers to the question `name` about every engine. With `pick`, one array of numbers for each path; without, the answers.
///
/// `engines` are the engines, or one engine with `columns`: a dictionary from keys of its file to arrays.
#[pyfunction]
#[pyo3(signature = (name, engines, options, columns=None, pick=None))]
pub fn map(
    py: Python<'_>,
    name: &str,
    engines: Vec<PyRef<'_, NativeEngine>>,
    options: Bound<'_, PyDict>,
    columns: Option<Bound<'_, PyDict>>,
    pick: Option<Vec<String>>,
) -> PyResult<Py<PyAny>> {
    let question = question(name)?;
    let run = (question.read)(&Options::new(options))?;
    let all = engines_of(&engines, columns)?;
    let count = all.count();
    match pick {
        None => {
            let answers = waited_for(py, move |watch| each(&all, &run, watch, Ok))?;
            let list = PyList::empty(py);
            for data in answers {
                list.append(Answer::from(data).into_py_any(py)?)?;
            }
            Ok(list.into_any().unbind())
        }
        Some(names) => {
            let paths = names.iter().map(|path| steps(path).ok_or_else(|| no_path(path)));
            let paths: Vec<Vec<Step>> = paths.collect::<Result<_, _>>()?;
            let width = paths.len();
            let rows = waited_for(py, move |watch| {
                each(&all, &run, watch, |data| {
                    paths.iter().map(|path| number_at(&data, path)).collect::<Result<Vec<f64>, Failure>>()
                })
            })?;
            let found = PyDict::new(py);
            for (place, name) in names.iter().enumerate().take(width) {
                let column: Vec<f64> = rows.iter().map(|row| row[place]).collect();
                found.set_item(name, array(py, vec![count], column)?)?;
            }
            Ok(found.into_any().unbind())
        }
    }
}

/// The number of an answer at the end of a path.
///
/// # Errors
/// Where there is none.
pub fn number_at(data: &Data, path: &[Step]) -> Result<f64, Failure> {
    data.number(path).map_err(|error| {
        Failure::option(
            format_args!("`{}`: {error}", text_of(path)),
            "`to_dict()` of one result shows what there is",
        )
    })
}

/// A text that is no path.
pub fn no_path(path: &str) -> Failure {
    Failure::option(
        format_args!("`{path}` is no path"),
        "paths are written like `total.peaks.force.max.value`",
    )
}

fn text_of(path: &[Step]) -> String {
    path.iter().fold(String::new(), |text, step| match step {
        Step::Key(key) if text.is_empty() => key.clone(),
        Step::Key(key) => format!("{text}.{key}"),
        Step::Index(index) => format!("{text}[{index}]"),
    })
}

/// The engines of a call: these, or one with other values by key.
///
/// # Errors
/// Where the columns have not one value for each engine.
pub fn engines_of(
    engines: &[PyRef<'_, NativeEngine>],
    columns: Option<Bound<'_, PyDict>>,
) -> Result<Engines, Failure> {
    let Some(columns) = columns else {
        return Ok(Engines::Given(engines.iter().map(|engine| engine.prepared.clone()).collect()));
    };
    let [base] = engines else {
        return Err(Failure::Internal("columns need one engine".into()));
    };
    let mut read: Vec<(String, Vec<Value>)> = Vec::new();
    for (path, values) in &columns {
        let path: String = path.extract()?;
        let values = column(&values, &path)?;
        read.push((path, values));
    }
    let count = read.first().map_or(0, |(_, values)| values.len());
    if let Some((path, values)) = read.iter().find(|(_, values)| values.len() != count) {
        return Err(Failure::option(
            format_args!("`{path}` has {} values, `{}` has {count}", values.len(), read[0].0),
            "every key needs one value for each engine",
        ));
    }
    Ok(Engines::Changed { base: base.prepared.clone(), columns: read, count })
}

/// The values of a column: an array of numbers, or a list of whatever an engine file holds.
fn column(values: &Bound<'_, PyAny>, path: &str) -> Result<Vec<Value>, Failure> {
    if !values.hasattr("dtype")? {
        let entries = values.try_iter()?.enumerate();
        return entries.map(|(place, entry)| value_of(&entry?, &format!("{path}[{place}]"), 1)).collect();
    }
    let numbers = numbers(values)?.ok_or_else(|| {
        Failure::option(
            format_args!("`{path}` needs numbers in one row"),
            "give a list or an array of one dimension",
        )
    })?;
    let value = |number: f64| match serde_json::Number::from_f64(number) {
        Some(number) => Ok(Value::Number(number)),
        None => Err(Failure::option(
            format_args!("`{path}` needs finite numbers, got {number}"),
            "leave such rows out",
        )),
    };
    numbers.into_iter().map(value).collect()
}

/// Every answer in the order of the engines, or the failure of the first engine that has one.
fn each<T: Send>(
    engines: &Engines,
    run: &Run,
    watch: &Watch,
    make: impl Fn(Data) -> Result<T, Failure> + Sync,
) -> Result<Vec<T>, Failure> {
    let count = engines.count();
    let mut found = Vec::with_capacity(count);
    for start in (0..count).step_by(BLOCK) {
        if !watch.goes_on() {
            break;
        }
        let block: Vec<_> = (start..count.min(start + BLOCK))
            .into_par_iter()
            .map(|place| {
                // Of a run that takes seconds no other is begun for nobody.
                if !watch.goes_on() {
                    return Ok(None);
                }
                caught(|| make(run(&[engines.at(place)?], watch)?))
                    .map(Some)
                    .map_err(|failure| numbered(failure, place))
            })
            .collect();
        for answer in block {
            match answer? {
                Some(answer) => found.push(answer),
                None => return Ok(found),
            }
        }
    }
    Ok(found)
}

/// The failure with the place of its engine, from 0.
pub fn numbered(failure: Failure, place: usize) -> Failure {
    match failure {
        Failure::Refused { message, hint, code } => {
            Failure::Refused { message: format!("engine {place}: {message}"), hint, code }
        }
        Failure::Mistakes { name, text, diagnostics } => {
            Failure::Mistakes { name: format!("engine {place} ({name})"), text, diagnostics }
        }
        other => other,
    }
}
