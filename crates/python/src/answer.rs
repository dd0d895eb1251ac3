//! The answer to a question: the result of the facade itself, of which Python sees what it asks for.

use crate::failure::Failure;
use crate::guard::unlocked;
use crate::native_engine::NativeEngine;
use crate::prepared::Prepared;
use crate::select::{Leaf, NoValue, Select, Step, steps};
use crate::to_python::{Converted, ToPython};
use lanchester::model::Engine;
use lanchester::report::{Cell, Figure, Part, Section, Table};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;
use pyo3::types::PyList;
use serde::Serialize;
use std::sync::Arc;

/// The engine with what a result has found, by the number of the choice, from 0.
pub type Adopted<T> = fn(&T, &Prepared, usize) -> Result<Arc<Prepared>, Failure>;

/// How a result is shown: the same words, tables and pictures as in every front end.
pub struct Shown<T> {
    /// The text of the command line.
    pub text: fn(&T, &Engine) -> String,
    /// Its tables.
    pub tables: fn(&T, &Engine) -> Vec<Table>,
    /// Its pictures.
    pub figures: fn(&T, &Engine) -> Vec<Figure>,
    /// A drawing as SVG with its name and title, where it is no figure of the report.
    pub drawing: fn(&T) -> Option<[String; 3]>,
    /// The engine with what was found.
    pub adopted: Option<Adopted<T>>,
    /// How many engines can be adopted; which of them have one, [`adopted`](Shown::adopted) says.
    pub choices: fn(&T) -> usize,
}

/// The tables of a chapter of the report.
pub fn tables_of(section: Section) -> Vec<Table> {
    let tables = |part| match part {
        Part::Tables(tables) => tables,
        _ => Vec::new(),
    };
    section.parts.into_iter().flat_map(tables).collect()
}

/// The pictures of a chapter of the report.
pub fn figures_of(section: Section) -> Vec<Figure> {
    let figures = |part| match part {
        Part::Figures(figures) | Part::Rows(figures) => figures,
        _ => Vec::new(),
    };
    section.parts.into_iter().flat_map(figures).collect()
}

impl<T> Default for Shown<T> {
    fn default() -> Self {
        Shown {
            text: |_, _| String::new(),
            tables: |_, _| Vec::new(),
            figures: |_, _| Vec::new(),
            drawing: |_| None,
            adopted: None,
            choices: |_| 1,
        }
    }
}

/// A result whose type is forgotten.
trait Told: Send + Sync {
    fn json(&self) -> Result<String, String>;
    fn convert(&self, py: Python<'_>, path: &[Step]) -> Result<Converted, NoValue>;
    fn number(&self, path: &[Step]) -> Result<f64, NoValue>;
    fn text(&self) -> String;
    fn tables(&self) -> Vec<Table>;
    fn figures(&self) -> Vec<[String; 3]>;
    fn choices(&self) -> Option<usize>;
    fn adopted(&self, number: usize) -> Result<Option<Arc<Prepared>>, Failure>;
}

struct Typed<T> {
    value: T,
    engine: Arc<Prepared>,
    shown: Shown<T>,
}

/// A result that is about no engine.
struct Alone<T> {
    value: T,
    shown: ShownAlone<T>,
}

/// How a result that is about no engine is shown.
pub struct ShownAlone<T> {
    /// The text of the command line.
    pub text: fn(&T) -> String,
    /// Its tables.
    pub tables: fn(&T) -> Vec<Table>,
    /// Its pictures, drawn when it was computed.
    pub figures: Vec<Figure>,
}

#[derive(Clone, Copy)]
struct AsPython<'py>(Python<'py>);

impl Leaf for AsPython<'_> {
    type Ok = Converted;

    fn leaf<T: Serialize + ?Sized>(self, value: &T) -> Result<Converted, String> {
        value.serialize(ToPython { py: self.0 }).map_err(|error| error.to_string())
    }

    fn content<T: Serialize + ?Sized>(self, value: &T, variant: &str) -> Result<Converted, String> {
        let whole = self.leaf(value)?.object(self.0);
        let content = whole.and_then(|whole| whole.bind(self.0).get_item(variant).map(Bound::unbind));
        content.map(Converted::Object).map_err(|error| error.to_string())
    }
}

#[derive(Clone, Copy)]
struct AsNumber;

impl Leaf for AsNumber {
    type Ok = f64;

    fn leaf<T: Serialize + ?Sized>(self, value: &T) -> Result<f64, String> {
        number_of(&serde_json::to_value(value).map_err(|error| error.to_string())?)
    }

    fn content<T: Serialize + ?Sized>(self, value: &T, variant: &str) -> Result<f64, String> {
        number_of(&serde_json::to_value(value).map_err(|error| error.to_string())?[variant])
    }
}

fn number_of(value: &serde_json::Value) -> Result<f64, String> {
    match value {
        serde_json::Value::Number(number) => number.as_f64().ok_or_else(|| "no number".into()),
        serde_json::Value::Bool(flag) => Ok(f64::from(u8::from(*flag))),
        // What is not known, and numbers that are none.
        serde_json::Value::Null => Ok(f64::NAN),
        serde_json::Value::String(_) => Err("it is a text, no number".into()),
        serde_json::Value::Array(list) => {
            Err(format!("it is a list of {}: an index such as [0] leads to a number", list.len()))
        }
        serde_json::Value::Object(keys) => {
            let names: Vec<&str> = keys.keys().map(String::as_str).collect();
            Err(format!("it is no number; below it there are {}", names.join(", ")))
        }
    }
}

fn json_of<T: Serialize>(value: &T) -> Result<String, String> {
    serde_json::to_string_pretty(value).map(|text| text + "\n").map_err(|error| error.to_string())
}

fn svg_of(own: Figure) -> [String; 3] {
    let svg = own.svg();
    [own.id, own.title, svg]
}

impl<T: Serialize + Send + Sync> Told for Alone<T> {
    fn json(&self) -> Result<String, String> {
        json_of(&self.value)
    }

    fn convert(&self, py: Python<'_>, path: &[Step]) -> Result<Converted, NoValue> {
        Select { path, leaf: AsPython(py) }.of(&self.value)
    }

    fn number(&self, path: &[Step]) -> Result<f64, NoValue> {
        Select { path, leaf: AsNumber }.of(&self.value)
    }

    fn text(&self) -> String {
        (self.shown.text)(&self.value)
    }

    fn tables(&self) -> Vec<Table> {
        (self.shown.tables)(&self.value)
    }

    fn figures(&self) -> Vec<[String; 3]> {
        self.shown.figures.iter().cloned().map(svg_of).collect()
    }

    fn choices(&self) -> Option<usize> {
        None
    }

    fn adopted(&self, _: usize) -> Result<Option<Arc<Prepared>>, Failure> {
        Ok(None)
    }
}

impl<T: Serialize + Send + Sync> Told for Typed<T> {
    fn json(&self) -> Result<String, String> {
        json_of(&self.value)
    }

    fn convert(&self, py: Python<'_>, path: &[Step]) -> Result<Converted, NoValue> {
        Select { path, leaf: AsPython(py) }.of(&self.value)
    }

    fn number(&self, path: &[Step]) -> Result<f64, NoValue> {
        Select { path, leaf: AsNumber }.of(&self.value)
    }

    fn text(&self) -> String {
        (self.shown.text)(&self.value, self.engine.engine())
    }

    fn tables(&self) -> Vec<Table> {
        (self.shown.tables)(&self.value, self.engine.engine())
    }

    fn figures(&self) -> Vec<[String; 3]> {
        let drawing = (self.shown.drawing)(&self.value);
        let figures = (self.shown.figures)(&self.value, self.engine.engine());
        drawing.into_iter().chain(figures.into_iter().map(svg_of)).collect()
    }

    fn choices(&self) -> Option<usize> {
        self.shown.adopted.map(|_| (self.shown.choices)(&self.value))
    }

    fn adopted(&self, number: usize) -> Result<Option<Arc<Prepared>>, Failure> {
        self.shown.adopted.map(|adopted| adopted(&self.value, &self.engine, number)).transpose()
    }
}

/// An answer as Rust holds it.
pub struct Data(Box<dyn Told>);

impl Data {
    /// A result of an engine.
    pub fn new<T: Serialize + Send + Sync + 'static>(
        value: T,
        engine: &Arc<Prepared>,
        shown: Shown<T>,
    ) -> Data {
        Data(Box::new(Typed { value, engine: engine.clone(), shown }))
    }

    /// A result that is about no engine.
    pub fn alone<T: Serialize + Send + Sync + 'static>(value: T, shown: ShownAlone<T>) -> Data {
        Data(Box::new(Alone { value, shown }))
    }

    /// The number at the end of a path.
    ///
    /// # Errors
    /// [`NoValue`] where the path leads to none.
    pub fn number(&self, path: &[Step]) -> Result<f64, NoValue> {
        self.0.number(path)
    }
}

/// The result of a question, held by Rust. `lanchester.results` gives it its type.
#[pyclass(frozen, module = "lanchester._native")]
pub struct Answer {
    data: Data,
}

impl From<Data> for Answer {
    fn from(data: Data) -> Answer {
        Answer { data }
    }
}

#[pymethods]
impl Answer {
    /// The field of this name, converted.
    fn field(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        let path = [Step::Key(name.to_owned())];
        self.at(py, &path)
    }

    /// What is at a path such as `total.orders[1].force_forward`.
    fn pick(&self, py: Python<'_>, path: &str) -> PyResult<Py<PyAny>> {
        self.at(py, &read_steps(path)?)
    }

    /// All of it as dictionaries and arrays.
    fn values(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.at(py, &[])
    }

    /// The JSON of the command line.
    fn json(&self, py: Python<'_>) -> PyResult<String> {
        Ok(unlocked(py, || self.data.0.json().map_err(Failure::Internal))?)
    }

    /// The text of the command line.
    fn text(&self, py: Python<'_>) -> PyResult<String> {
        Ok(unlocked(py, || Ok(self.data.0.text()))?)
    }

    /// The tables, each as (name, title, columns): columns are (header, unit, values).
    fn tables(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let tables = unlocked(py, || Ok(self.data.0.tables()))?;
        let list = PyList::empty(py);
        for table in tables {
            let columns = PyList::empty(py);
            for (place, column) in table.columns.iter().enumerate() {
                let cells = table.rows.iter().filter_map(|row| row.get(place));
                columns.append((&column.header, column.unit, cells_of(py, cells)?))?;
            }
            list.append((table.id, &table.title, columns, &table.note, &table.remark))?;
        }
        Ok(list.into_any().unbind())
    }

    /// The pictures, each as (name, title, SVG).
    fn figures(&self, py: Python<'_>) -> PyResult<Vec<(String, String, String)>> {
        let figures = unlocked(py, || Ok(self.data.0.figures()))?;
        Ok(figures.into_iter().map(|[name, title, svg]| (name, title, svg)).collect())
    }

    /// How many engines can be adopted, or `None` where this result finds nothing.
    fn choices(&self) -> Option<usize> {
        self.data.0.choices()
    }

    /// The engine with what was found, or `None` where this result finds nothing.
    fn adopted(&self, py: Python<'_>, number: usize) -> PyResult<Option<NativeEngine>> {
        let found = unlocked(py, || self.data.0.adopted(number))?;
        Ok(found.map(NativeEngine::from))
    }
}

impl Answer {
    fn at(&self, py: Python<'_>, path: &[Step]) -> PyResult<Py<PyAny>> {
        let found = self.data.0.convert(py, path);
        found.map_err(|error| PyAttributeError::new_err(error.to_string()))?.object(py)
    }
}

fn read_steps(path: &str) -> Result<Vec<Step>, Failure> {
    steps(path).ok_or_else(|| {
        let message = format!("`{path}` is no path");
        Failure::option(message, "paths are written like `total.orders[1].order`")
    })
}

/// The steps of a path: names as texts, places in lists as numbers.
#[pyfunction]
pub fn path_steps(py: Python<'_>, path: &str) -> PyResult<Vec<Py<PyAny>>> {
    let step = |step: Step| match step {
        Step::Key(key) => key.into_py_any(py),
        Step::Index(index) => index.into_py_any(py),
    };
    read_steps(path)?.into_iter().map(step).collect()
}

/// A column: an array where it is all numbers, NaN where there is none, else a list.
fn cells_of<'c>(py: Python<'_>, cells: impl Iterator<Item = &'c Cell>) -> PyResult<Py<PyAny>> {
    let cells: Vec<&Cell> = cells.collect();
    if cells.iter().any(|cell| matches!(cell, Cell::Text(_) | Cell::Formula { .. })) || cells.is_empty() {
        let list = PyList::empty(py);
        for cell in cells {
            match cell {
                Cell::Text(text) | Cell::Formula { text, .. } => list.append(text)?,
                Cell::Number { value, .. } => list.append(value)?,
                Cell::Empty => list.append(py.None())?,
            }
        }
        return Ok(list.into_any().unbind());
    }
    let numbers = cells.into_iter().map(|cell| match cell {
        Cell::Number { value, .. } => *value,
        _ => f64::NAN,
    });
    let numbers: Vec<f64> = numbers.collect();
    Converted::Floats(vec![numbers.len()], numbers).object(py)
}
