//! The published numbers as a reference suite that another program can run: inputs in SI, expected values with their
//! uncertainty, and where each comes from.

use crate::case::{Bench, sheet};
use crate::files::{Source, sources};
use crate::quantity::Key;
use crate::result::RowResult;
use crate::source::{Comparison, Edit, ExactName, KinematicsName};
use crate::verdict::{Printed, Verdict};
use crate::{CellAt, cells, validate_cell};
use lanchester::model::Engine;
use lanchester::task::workshop::Sheet;
use lanchester_data::TRACES;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Version of the suite's form; raised when a field changes its meaning or goes.
pub const SUITE_VERSION: u32 = 1;

/// Published numbers of piston engines with their inputs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Suite {
    /// "lanchester reference suite".
    pub format: &'static str,
    /// Version of the form; this is 1.
    pub version: u32,
    /// Version of the program that wrote it.
    pub program: &'static str,
    /// Licence of the suite; the numbers are those of their sources.
    pub licence: &'static str,
    /// Where the numbers were published.
    pub sources: Vec<SuiteSource>,
    /// Engines by the name that rows give: lengths [m], masses [kg], unbalances [kg m], angles [rad], speeds [rad/s].
    pub engines: BTreeMap<String, Engine>,
    /// Workshop sheets by the name that rows give, in SI.
    pub sheets: BTreeMap<String, Sheet>,
    /// Pressures over the cycle that engines name, as CSV text.
    pub traces: BTreeMap<&'static str, &'static str>,
    /// One a published number.
    pub rows: Vec<SuiteRow>,
}

/// A source of published numbers.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SuiteSource {
    /// Its key, as rows name it.
    pub key: String,
    /// What it is called.
    pub title: String,
    /// Author, title, place, year.
    pub citation: String,
}

/// Motion of the pistons that a number was computed with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum SuiteMotion {
    /// The exact slider crank.
    Exact,
    /// The literature's series of the acceleration.
    Series {
        /// Highest order kept.
        orders: u32,
        /// Highest power of the rod ratio r/l kept in each coefficient.
        powers: u32,
    },
}

/// A number as printed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SuiteNumber {
    /// As printed.
    pub text: String,
    /// Its value; `null` for a word.
    pub value: Option<f64>,
    /// Half a unit of its last digit; `null` for a word, which must be the same.
    pub uncertainty: Option<f64>,
}

/// What a value is compared with, in per cent.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SuiteComparison {
    /// "increase", "decrease", "error", "ratio" of the value over the reference, or "mean error" over the angle.
    pub as_what: &'static str,
    /// Quantity of the reference.
    pub key: String,
    /// Engine of the reference.
    pub engine: String,
    /// Its motion.
    pub motion: SuiteMotion,
}

/// One published number.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SuiteRow {
    /// Its name, that of no other row.
    pub id: String,
    /// Key of its source.
    pub source: String,
    /// Table of the source.
    pub table: String,
    /// Section of the running text.
    pub section: Option<String>,
    /// Column of the table.
    pub column: Option<String>,
    /// What it is, in the source's words.
    pub quantity: String,
    /// Unit of all its numbers; empty for a ratio.
    pub unit: String,
    /// Which quantity of the engine it is, in SI; the README of `validation/` lists the names.
    pub key: String,
    /// Numbers in SI that the quantity is divided by to give the unit of the row.
    pub divided_by: BTreeMap<String, f64>,
    /// The engine; `null` where the number belongs to none.
    pub engine: Option<String>,
    /// The workshop sheet, where it belongs to one.
    pub sheet: Option<String>,
    /// Motion of the pistons.
    pub motion: SuiteMotion,
    /// Equally spaced angles of a revolution, from 0, among which extremes are taken; `null`: true extremes.
    pub grid: Option<usize>,
    /// Point that couples are about [m]; `null` without an engine.
    pub about: Option<[f64; 3]>,
    /// What the value is compared with.
    pub comparison: Option<SuiteComparison>,
    /// As the source prints it.
    pub printed: SuiteNumber,
    /// What a right program gives: the printed number, or the correct one where the print is no match; `null` where that is
    /// unknown.
    pub expected: Option<SuiteNumber>,
    /// How ours stands to the printed number.
    pub verdict: Verdict,
    /// Why it is no match.
    pub reason: Option<String>,
    /// What gives the printed number instead: a rounded intermediate result, an assumption, or the error of the source.
    pub given_by: Option<String>,
    /// Ours, unrounded.
    pub ours: Option<f64>,
    /// Engine file, changes, motion and quantity in words; requests that no engine holds, such as cases of stress.
    pub how: String,
}

/// The whole suite, or the rows of the sources and tables that `filter` names, as in [`crate::validate`].
pub fn suite(filter: Option<&str>) -> Suite {
    suite_on(&mut Bench::default(), filter)
}

/// With what the bench has computed already.
pub(crate) fn suite_on(bench: &mut Bench, filter: Option<&str>) -> Suite {
    let mut writer = Writer { bench, engines: Named::new("engine"), sheets: Named::new("sheet") };
    let mut rows: Vec<SuiteRow> = Vec::new();
    let mut named = Vec::new();
    for source in sources() {
        let before = rows.len();
        for table in &source.tables {
            let name = format!("{} {}", source.key, table.table);
            if filter.is_none_or(|filter| crate::keeps(filter, &name)) {
                rows.extend(cells(&source, table).iter().map(|at| writer.row(at)));
            }
        }
        if rows.len() > before {
            let Source { key, title, citation, .. } = source;
            named.push(SuiteSource { key, title, citation });
        }
    }
    number(&mut rows);
    Suite {
        format: "lanchester reference suite",
        version: SUITE_VERSION,
        program: env!("CARGO_PKG_VERSION"),
        licence: env!("CARGO_PKG_LICENSE"),
        sources: named,
        engines: writer.engines.kept,
        sheets: writer.sheets.kept,
        traces: TRACES.into_iter().collect(),
        rows,
    }
}

/// The JSON Schema of the suite.
pub fn suite_schema() -> schemars::Schema {
    schemars::schema_for!(Suite)
}

/// Names that are the same get a number.
fn number(rows: &mut [SuiteRow]) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for row in rows {
        let count = seen.entry(row.id.clone()).or_default();
        *count += 1;
        if *count > 1 {
            row.id += &format!(" #{count}");
        }
    }
}

/// Values that rows name: each once.
struct Named<T> {
    word: &'static str,
    kept: BTreeMap<String, T>,
    /// Names by the text of the value.
    names: BTreeMap<String, String>,
}

impl<T: Serialize> Named<T> {
    fn new(word: &'static str) -> Named<T> {
        Named { word, kept: BTreeMap::new(), names: BTreeMap::new() }
    }

    fn name(&mut self, value: T) -> String {
        let text = serde_json::to_string(&value).expect("invariant: engines and sheets have a JSON form");
        let next = format!("{} {}", self.word, self.names.len() + 1);
        let name = self.names.entry(text).or_insert(next).clone();
        self.kept.entry(name.clone()).or_insert(value);
        name
    }
}

/// Writes rows, with what they name.
struct Writer<'a> {
    bench: &'a mut Bench,
    engines: Named<Engine>,
    sheets: Named<Sheet>,
}

impl Writer<'_> {
    fn row(&mut self, at: &CellAt) -> SuiteRow {
        let CellAt { place, engine, cell, column } = at;
        let (source, table, row) = (place.source, place.table, place.row);
        let result = validate_cell(self.bench, place, engine, cell);
        let motion = row.kinematics.unwrap_or(source.kinematics);
        let edits = [*engine, place.column_edits, &row.with].concat();
        let about = row.about.as_deref();
        let kind = Key::parse(&row.key).ok();
        let is_sheet = matches!(kind, Some(Key::Workshop(_)));
        let alone =
            |key: &Key| matches!(key, Key::Workshop(_) | Key::Mechanism(_) | Key::Film(_) | Key::Elastic(_));
        let of_engine = !kind.as_ref().is_some_and(alone);
        let engine_of_row = if of_engine { self.engine(source, &edits, motion, about) } else { None };
        let column = column.map(|column| column.name.clone());
        let parts = [
            Some(&source.key),
            Some(&table.table),
            row.section.as_ref(),
            Some(&row.quantity),
            column.as_ref(),
        ];
        SuiteRow {
            id: parts.into_iter().flatten().cloned().collect::<Vec<_>>().join("/"),
            source: source.key.clone(),
            table: table.table.clone(),
            section: row.section.clone(),
            column: column.clone(),
            quantity: row.quantity.clone(),
            unit: row.unit.clone(),
            key: row.key.clone(),
            divided_by: row.divided_by.clone(),
            sheet: if is_sheet { self.sheet(source, &edits) } else { None },
            motion: motion_of(motion),
            grid: source.grid,
            about: engine_of_row.as_ref().map(|(_, about)| *about),
            engine: engine_of_row.map(|(name, _)| name),
            comparison: self.comparison(at),
            printed: printed(&result.printed),
            expected: expected(&result),
            verdict: result.verdict,
            reason: result.reason,
            given_by: result.given_by,
            ours: result.value,
            how: result.how,
        }
    }

    /// Name of an engine after its changes, and the point that its couples are about.
    fn engine(
        &mut self,
        source: &Source,
        edits: &[Edit],
        motion: KinematicsName,
        about: Option<&str>,
    ) -> Option<(String, [f64; 3])> {
        let run = self.bench.run(source, edits, motion, about).ok()?;
        Some((self.engines.name(run.engine.clone()), run.loads.reference))
    }

    fn sheet(&mut self, source: &Source, edits: &[Edit]) -> Option<String> {
        sheet(source, edits).ok().map(|(sheet, _)| self.sheets.name(sheet))
    }

    fn comparison(&mut self, at: &CellAt) -> Option<SuiteComparison> {
        let CellAt { place, engine, .. } = at;
        let row = place.row;
        let comparison = row.comparison?;
        let over = row.over.as_ref();
        let engine = over.and_then(|over| over.engine.as_deref()).unwrap_or(engine);
        let edits = [engine, over.map_or(&[][..], |over| &over.with)].concat();
        let motion = over.and_then(|over| over.kinematics);
        let motion = motion.or(row.kinematics).unwrap_or(place.source.kinematics);
        let (name, _) = self.engine(place.source, &edits, motion, row.about.as_deref())?;
        Some(SuiteComparison {
            as_what: Comparison::name(comparison),
            key: over.and_then(|over| over.key.clone()).unwrap_or_else(|| row.key.clone()),
            engine: name,
            motion: motion_of(motion),
        })
    }
}

fn motion_of(name: KinematicsName) -> SuiteMotion {
    match name {
        KinematicsName::Series { orders, powers } => SuiteMotion::Series { orders, powers },
        KinematicsName::Named(ExactName::Exact) => SuiteMotion::Exact,
    }
}

fn printed(text: &str) -> SuiteNumber {
    let read = Printed::read(text);
    let value = match &read {
        Printed::Number { value, .. } => Some(*value),
        Printed::Word(_) => None,
    };
    SuiteNumber { text: text.to_string(), value, uncertainty: read.tolerance() }
}

/// The correct number where one is stated, the printed one where it is right.
fn expected(result: &RowResult) -> Option<SuiteNumber> {
    match (&result.correct, result.verdict) {
        (Some(correct), _) => Some(printed(correct)),
        (None, Verdict::Match | Verdict::InputItself) => Some(printed(&result.printed)),
        (None, _) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn rows_have_inputs_in_si_and_what_a_right_program_gives() {
        let suite = suite(Some("twin-cylinder-thesis Table 4"));
        let row = suite.rows.iter().find(|row| row.quantity == "Fx,max").unwrap();
        assert_eq!((row.id.as_str(), row.grid), ("twin-cylinder-thesis/Table 4/Fx,max", Some(360)));
        assert_eq!(row.motion, SuiteMotion::Series { orders: 4, powers: 5 });
        let expected = row.expected.as_ref().unwrap();
        assert_eq!((expected.value, expected.uncertainty), (Some(9535.49), Some(0.005)));
        let engine = &suite.engines[row.engine.as_ref().unwrap()];
        assert!((engine.throws[0].radius - 0.0432).abs() < 1e-12);
        // The print of this one is wrong.
        let wrong = suite.rows.iter().find(|row| row.quantity == "ΔFres").unwrap();
        assert_eq!(wrong.expected.as_ref().unwrap().text, "9501,92");
        assert!(wrong.verdict == Verdict::SourceWrong && wrong.reason.is_some());
    }

    #[test]
    fn names_are_those_of_one_row_and_of_things_that_are_there() {
        let suite = suite(Some("thesis"));
        let mut ids: Vec<&str> = suite.rows.iter().map(|row| row.id.as_str()).collect();
        ids.sort_unstable();
        assert!(ids.windows(2).all(|pair| pair[0] != pair[1]) && ids.len() > 1500, "{}", ids.len());
        for row in &suite.rows {
            let names = row.engine.iter().chain(row.comparison.as_ref().map(|own| &own.engine));
            assert!(names.clone().count() > 0, "{}", row.id);
            assert!(names.into_iter().all(|name| suite.engines.contains_key(name)), "{}", row.id);
            assert_eq!(row.expected.is_none(), row.verdict == Verdict::Residual, "{}", row.id);
        }
    }

    #[test]
    fn the_schema_is_fresh() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/suite.schema.json");
        let schema = serde_json::to_string_pretty(&suite_schema()).unwrap() + "\n";
        assert!(
            std::fs::read_to_string(file).unwrap() == schema,
            "validation/suite.schema.json is stale: write it with `cargo xtask generate`"
        );
    }
}
