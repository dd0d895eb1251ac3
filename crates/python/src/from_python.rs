//! Plain values of Python as an engine file, and as changes of one.

use crate::failure::Failure;
use crate::options::{kind, number};
use lanchester::file::{Edit, edit, file_entries, si_sheet, si_value, values_text};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyDict, PyInt, PyString};
use serde_json::{Map, Value};

/// Deepest nesting of values; an engine file has a handful.
const DEEPEST: usize = 16;

/// The text of the engine file that holds these values.
///
/// # Errors
/// Where a value is none that a file can hold.
pub fn file_text(values: &Bound<'_, PyDict>) -> Result<String, Failure> {
    let values = si_value("", Value::Object(object(values, "", 0)?));
    Ok(values.as_object().map(values_text).unwrap_or_default())
}

/// The text of the workshop sheet that holds these values.
///
/// # Errors
/// Where a value is none that a sheet can hold.
pub fn sheet_text(values: &Bound<'_, PyDict>) -> Result<String, Failure> {
    let values = si_sheet(Value::Object(object(values, "", 0)?));
    Ok(values.as_object().map(values_text).unwrap_or_default())
}

fn object(values: &Bound<'_, PyDict>, path: &str, depth: usize) -> Result<Map<String, Value>, Failure> {
    let mut found = Map::new();
    for (key, value) in values {
        let key: String = key.extract().map_err(|_| {
            Failure::option(
                format_args!("keys are texts, got {} in `{path}`", kind(&key)),
                "write {\"crank\": {\"stroke\": \"80 mm\"}}",
            )
        })?;
        let below = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        found.insert(key, value_of(&value, &below, depth + 1)?);
    }
    Ok(found)
}

/// A value of Python as a value of a file; `None` is `null`.
///
/// # Errors
/// Where no file can hold it.
pub fn value_of(value: &Bound<'_, PyAny>, path: &str, depth: usize) -> Result<Value, Failure> {
    let refuse = |got: String| {
        Failure::option(
            format_args!("`{path}` needs a text, a number, True or False, a list or a dictionary, got {got}"),
            "quantities are floats in SI units, or texts with units such as \"80 mm\"",
        )
    };
    if depth > DEEPEST {
        return Err(refuse("values nested deeper than an engine file is".into()));
    }
    if value.is_none() {
        return Ok(Value::Null);
    }
    if let Ok(flag) = value.cast::<PyBool>() {
        return Ok(Value::Bool(flag.is_true()));
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Value::String(text.to_cow()?.into_owned()));
    }
    if let Ok(values) = value.cast::<PyDict>() {
        return Ok(Value::Object(object(values, path, depth)?));
    }
    // Lists, tuples and arrays.
    if value.hasattr("__len__")?
        && let Ok(entries) = value.try_iter()
    {
        let entries = entries.enumerate();
        let read = entries.map(|(place, entry)| value_of(&entry?, &format!("{path}[{place}]"), depth + 1));
        return match value.is_instance_of::<PyBytes>() {
            true => Err(refuse(kind(value))),
            false => read.collect(),
        };
    }
    let is_whole = value.is_instance_of::<PyInt>() || value.hasattr("__index__")?;
    if is_whole && let Ok(whole) = value.extract::<i64>() {
        return Ok(Value::from(whole));
    }
    match number(value) {
        Some(number) => serde_json::Number::from_f64(number)
            .map(Value::Number)
            .ok_or_else(|| refuse(format!("the number {number}"))),
        None => Err(refuse(kind(value))),
    }
}

/// Changes of keys.
pub struct Changes(Vec<(String, Value)>);

impl Changes {
    /// From paths or names of tables to values: `{"crank.stroke": 0.08, "rod": {"length": "140 mm"}}`.
    ///
    /// # Errors
    /// Where a value is none that a file can hold.
    pub fn read(changes: &Bound<'_, PyDict>) -> Result<Changes, Failure> {
        let read = object(changes, "", 0)?;
        Ok(Changes(read.into_iter().map(|(path, value)| (path.clone(), si_value(&path, value))).collect()))
    }

    /// No change.
    pub fn none() -> Changes {
        Changes(Vec::new())
    }

    /// Adds a change.
    pub fn and(mut self, path: &str, value: Value) -> Changes {
        self.0.push((path.to_owned(), si_value(path, value)));
        self
    }

    /// The text with the changes; comments and order are preserved.
    ///
    /// # Errors
    /// Where a path leads nowhere.
    pub fn apply(&self, text: &str) -> Result<String, Failure> {
        let mut text = text.to_owned();
        for (path, value) in &self.0 {
            let mut edits = Vec::new();
            match value {
                // A list of tables takes the place of the one that is there, entry by entry.
                Value::Array(tables) if !tables.is_empty() && tables.iter().all(Value::is_object) => {
                    edits.push(Edit { path: path.clone(), value: Value::Null });
                    let new = tables.iter().enumerate();
                    edits.extend(new.map(|(place, table)| Edit {
                        path: format!("{path}[{place}]"),
                        value: table.clone(),
                    }));
                }
                // Of an empty list nothing stays.
                Value::Array(list) if list.is_empty() && is_list_of_tables(&text, path) => {
                    edits.push(Edit { path: path.clone(), value: Value::Null });
                }
                _ => edits.push(Edit { path: path.clone(), value: value.clone() }),
            }
            text = edit(&text, &edits).map_err(Failure::refused)?;
        }
        Ok(text)
    }
}

fn is_list_of_tables(text: &str, path: &str) -> bool {
    let first = format!("{path}[0].");
    file_entries(text).iter().any(|entry| entry.path.starts_with(&first))
}
