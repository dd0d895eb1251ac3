//! One question about many engines as a study in blocks: a row an engine.

use crate::blocks::{Blocks, Tabled};
use crate::failure::Failure;
use crate::from_python::value_of;
use crate::guard::{Watch, caught};
use crate::map::{Engines, engines_of, no_path, number_at, numbered};
use crate::native_engine::NativeEngine;
use crate::options::Options;
use crate::question::Run;
use crate::questions::question;
use crate::select::{Step, steps};
use lanchester::run::{Head, Study};
use lanchester::table::{Column, Rows, Values};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// Engines of a block.
pub const BLOCK: u64 = 16;

/// The question of a study as its tables keep it.
#[derive(Serialize)]
struct SavedCases {
    question: String,
    arguments: BTreeMap<String, Value>,
    /// Keys of the engine file that differ, in the order of the columns.
    keys: Vec<String>,
    /// Paths of the numbers that are kept.
    pick: Vec<String>,
    cases: usize,
    /// SHA-256 of all engines, or of all values of the keys.
    cases_sha256: String,
}

/// Why an engine has no answer.
#[derive(Debug)]
struct CaseError(Failure);

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

impl std::error::Error for CaseError {}

/// A question about many engines, cut into blocks of engines.
struct CaseStudy {
    engines: Engines,
    run: Run,
    pick: Vec<(String, Vec<Step>)>,
    /// Number of the first engine: a slice of a study counts on.
    start: usize,
    /// Keys whose column is of texts.
    texts: Vec<String>,
}

/// Where engines are a slice of those of a study.
#[derive(Default)]
pub struct Slice {
    /// Number of the first engine.
    pub start: usize,
    /// Keys whose column is of texts in the whole study; by the values where it is not given.
    pub texts: Option<Vec<String>>,
}

impl CaseStudy {
    fn places(&self, blocks: Range<u64>) -> Range<usize> {
        let at = |block: u64| block.saturating_mul(BLOCK).min(self.engines.count() as u64) as usize;
        at(blocks.start)..at(blocks.end)
    }

    /// The given columns with their values at these places: keys that differ, or the names of engines.
    fn given(&self, places: Range<usize>) -> Vec<(Column, Values)> {
        match &self.engines {
            Engines::Given(all) => {
                let names = all[places].iter().map(|own| own.engine().name.clone()).collect();
                vec![(Column::text("engine"), Values::Text(names))]
            }
            Engines::Changed { columns, .. } => {
                let column = |(key, values): &(String, Vec<Value>)| {
                    let own = &values[places.clone()];
                    if !self.texts.contains(key) {
                        let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
                        return (Column::real(key), Values::Real(own.iter().map(number).collect()));
                    }
                    let text = |value: &Value| match value {
                        Value::Null => String::new(),
                        Value::String(text) => text.clone(),
                        other => other.to_string(),
                    };
                    (Column::text(key), Values::Text(own.iter().map(text).collect()))
                };
                columns.iter().map(column).collect()
            }
        }
    }
}

impl Study for CaseStudy {
    type Kept = ();
    type Error = CaseError;

    fn blocks(&self) -> u64 {
        (self.engines.count() as u64).div_ceil(BLOCK)
    }

    fn cases(&self, blocks: Range<u64>) -> u128 {
        self.places(blocks).len() as u128
    }

    fn columns(&self) -> Vec<Column> {
        let given = self.given(0..0).into_iter().map(|(column, _)| column);
        std::iter::once(Column::whole("case"))
            .chain(given)
            .chain(self.pick.iter().map(|(name, _)| Column::real(name)))
            .collect()
    }

    fn nothing(&self) {}

    fn block(&self, number: u64) -> Result<((), Rows), CaseError> {
        let places = self.places(number..number + 1);
        let one = |place: usize| {
            let row = caught(|| {
                let data = (self.run)(&[self.engines.at(place)?], &Watch::default())?;
                self.pick.iter().map(|(_, path)| number_at(&data, path)).collect::<Result<Vec<f64>, _>>()
            });
            row.map_err(|failure| CaseError(numbered(failure, self.start + place)))
        };
        // In their order, so that the failure is that of the first engine that has one.
        let rows: Vec<_> = places.clone().into_par_iter().map(one).collect();
        let rows = rows.into_iter().collect::<Result<Vec<_>, _>>()?;
        let mut columns =
            vec![Values::Whole(places.clone().map(|place| (self.start + place) as i64).collect())];
        columns.extend(self.given(places).into_iter().map(|(_, values)| values));
        let picked = |place: usize| Values::Real(rows.iter().map(|row| row[place]).collect());
        columns.extend((0..self.pick.len()).map(picked));
        Ok(((), Rows::of(columns)))
    }

    fn join(&self, _: (), _: ()) -> Result<(), CaseError> {
        Ok(())
    }

    fn last_rows(&self, _: &()) -> Result<Option<Rows>, CaseError> {
        Ok(None)
    }
}

/// The study of a question about engines, or about one engine with `columns` of values by key; `pick` has the paths of the numbers that are kept.
/// Behind it the keys whose column is of texts.
///
/// # Errors
/// Where an argument cannot be used.
pub fn case_blocks(
    name: &str,
    engines: &[PyRef<'_, NativeEngine>],
    options: &Bound<'_, PyDict>,
    columns: Option<Bound<'_, PyDict>>,
    pick: Vec<String>,
    slice: Slice,
) -> Result<(Box<dyn Blocks>, Vec<String>), Failure> {
    let run = (question(name)?.read)(&Options::new(options.clone()))?;
    let engines = engines_of(engines, columns)?;
    if pick.is_empty() {
        return Err(Failure::option(
            "`pick` needs a path of a number that is kept of every engine",
            "write it like pick=\"total.peaks.force.max.value\"",
        ));
    }
    if engines.count() == 0 {
        return Err(Failure::option("there is no engine", "give one engine at least"));
    }
    let mut arguments = BTreeMap::new();
    for (key, value) in options {
        if !value.is_none() {
            let key: String = key.extract()?;
            let value = value_of(&value, &key, 1)?;
            arguments.insert(key, value);
        }
    }
    let (keys, engine, digest) = match &engines {
        Engines::Given(all) => {
            let mut hash = Sha256::new();
            for own in all {
                hash.update((own.text.len() as u64).to_le_bytes());
                hash.update(own.text.as_bytes());
            }
            let engine = if all.len() == 1 { all[0].text.clone() } else { String::new() };
            (Vec::new(), engine, hash.finalize())
        }
        Engines::Changed { base, columns, .. } => {
            let keys = columns.iter().map(|(key, _)| key.clone()).collect();
            let text =
                serde_json::to_string(columns).map_err(|error| Failure::Internal(error.to_string()))?;
            (keys, base.text.clone(), Sha256::digest(text.as_bytes()))
        }
    };
    let saved = SavedCases {
        question: name.to_owned(),
        arguments,
        keys,
        pick: pick.clone(),
        cases: engines.count(),
        cases_sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect(),
    };
    let head = Head::new("cases", &saved, &engine)?;
    let read = |path: String| steps(&path).map(|steps| (path.clone(), steps)).ok_or_else(|| no_path(&path));
    let pick = pick.into_iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let is_plain = |value: &Value| value.is_number() || value.is_null();
    let texts = slice.texts.unwrap_or_else(|| match &engines {
        Engines::Given(_) => Vec::new(),
        Engines::Changed { columns, .. } => {
            let texts = columns.iter().filter(|(_, values)| !values.iter().all(is_plain));
            texts.map(|(key, _)| key.clone()).collect()
        }
    });
    let study = CaseStudy { engines, run, pick, start: slice.start, texts: texts.clone() };
    let mut names: Vec<String> = study.columns().into_iter().map(|column| column.name).collect();
    names.sort();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(Failure::option(
            format_args!("two columns of the table are named `{}`", pair[0]),
            "name every path and key once, and pick no path that is named as a key",
        ));
    }
    let fail = |error: CaseError| error.0;
    Ok((Box::new(Tabled { study, head, fail, answer: Box::new(|_, ()| Ok(None)) }), texts))
}
