//! Every published number that Lanchester can compute, printed against computed.
//!
//! `validation/<source>/` holds what a source prints, table by table, with the engine files that its numbers belong
//! to. Each number is computed the whole way: the text of the engine file, changed where the table changes the
//! engine, is read, its loads are computed in the source's convention, and one quantity is taken from them. The
//! verdict is then held against the expected one, so that a number that the source prints wrongly is checked as
//! strictly as a right one: its row names what is correct, and ours must equal that.
//!
//! Rounding rule: ours *matches* when it lies within half a unit of the last printed digit.
//!
//! ```
//! let validation = lanchester::validate::validate(Some("Table 4"));
//! assert!(validation.passed());
//! ```

mod case;
mod files;
mod fitting;
mod gas;
mod method;
mod mount;
mod quantity;
mod render;
mod shape;
mod source;
#[cfg(test)]
mod tests;
mod verdict;

pub use render::{csv, markdown, text};
pub use verdict::Verdict;

use case::Bench;
use files::Source;
use quantity::{Key, Value};
use serde::Serialize;
use source::{Cell, Comparison, Edit, KinematicsName, Over, Row, Table};
use verdict::Printed;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const VALIDATION_VERSION: u32 = 1;

/// Published numbers against ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Validation {
    /// [`VALIDATION_VERSION`].
    pub version: u32,
    /// By source.
    pub sources: Vec<SourceResult>,
}

/// The numbers of one source.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SourceResult {
    /// Its folder in `validation/`.
    pub key: String,
    /// What it is called here.
    pub title: String,
    /// Author, title, place, year.
    pub citation: String,
    /// Its tables.
    pub tables: Vec<TableResult>,
    /// What it prints and this version does not compute.
    pub deferred: Vec<Deferred>,
}

/// The numbers of one table, or of the running text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableResult {
    /// "Table 4", "Text".
    pub table: String,
    /// What it is about.
    pub title: String,
    /// One a printed number.
    pub rows: Vec<RowResult>,
}

/// One printed number against ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RowResult {
    /// Section of the running text.
    pub section: Option<String>,
    /// Column of the table.
    pub column: Option<String>,
    /// What the number is.
    pub quantity: String,
    /// Its unit; empty for a ratio.
    pub unit: String,
    /// As printed.
    pub printed: String,
    /// Ours with two more digits than printed.
    pub ours: String,
    /// Ours unrounded, where it is a number.
    pub value: Option<f64>,
    /// How the two agree.
    pub verdict: Verdict,
    /// How they should.
    pub expected: Verdict,
    /// Whether the verdict is the expected one and ours equals [`RowResult::correct`].
    pub ok: bool,
    /// What ours must equal to its digits where the printed number is not plainly right.
    pub correct: Option<String>,
    /// Why the printed number is not plainly right.
    pub reason: Option<String>,
    /// Engine, changes, motion and quantity that ours comes from.
    pub how: String,
}

/// What a source prints and this version does not compute.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Deferred {
    /// Which numbers.
    pub what: String,
    /// Why.
    pub reason: String,
}

/// How many rows have which verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Counts {
    /// All rows.
    pub rows: usize,
    /// [`Verdict::Match`].
    pub matches: usize,
    /// [`Verdict::MatchWithRoundedInput`].
    pub rounded: usize,
    /// [`Verdict::MatchWithUnprintedInput`].
    pub unprinted: usize,
    /// [`Verdict::MatchWithSyntheticInput`].
    pub synthetic: usize,
    /// [`Verdict::Close`].
    pub close: usize,
    /// [`Verdict::Differs`] and [`Verdict::NotComputed`].
    pub differs: usize,
    /// Rows that are not as expected.
    pub unexpected: usize,
}

impl Validation {
    /// Whether there is a row and every row is as expected.
    pub fn passed(&self) -> bool {
        let counts = self.counts();
        counts.rows > 0 && counts.unexpected == 0
    }

    /// Rows by verdict.
    pub fn counts(&self) -> Counts {
        Counts::of(self.sources.iter().flat_map(|s| &s.tables).flat_map(|t| &t.rows))
    }
}

impl Counts {
    /// Counts of some rows.
    pub fn of<'a>(rows: impl IntoIterator<Item = &'a RowResult>) -> Counts {
        let mut counts = Counts::default();
        for row in rows {
            counts.rows += 1;
            counts.unexpected += usize::from(!row.ok);
            *match row.verdict {
                Verdict::Match => &mut counts.matches,
                Verdict::MatchWithRoundedInput => &mut counts.rounded,
                Verdict::MatchWithUnprintedInput => &mut counts.unprinted,
                Verdict::MatchWithSyntheticInput => &mut counts.synthetic,
                Verdict::Close => &mut counts.close,
                Verdict::Differs | Verdict::NotComputed => &mut counts.differs,
            } += 1;
        }
        counts
    }
}

/// Computes every published number, or those of the sources and tables that `filter` names.
///
/// A filter keeps the tables whose "source table" (for instance "twin-cylinder-thesis Table 4") holds it, upper and
/// lower case alike; a filter that ends in a digit does not keep a longer number (Table 40, Table 4.2). A filter that keeps nothing gives
/// no rows, and a validation without rows has not passed.
pub fn validate(filter: Option<&str>) -> Validation {
    let mut bench = Bench::default();
    let sources = files::sources()
        .into_iter()
        .filter_map(|source| {
            let tables: Vec<TableResult> = source
                .tables
                .iter()
                .filter(|table| filter.is_none_or(|f| keeps(f, &format!("{} {}", source.key, table.table))))
                .map(|table| validate_table(&mut bench, &source, table))
                .collect();
            (!tables.is_empty()).then(|| SourceResult {
                key: source.key.clone(),
                title: source.title.clone(),
                citation: source.citation.clone(),
                tables,
                deferred: source.deferred.clone(),
            })
        })
        .collect();
    Validation { version: VALIDATION_VERSION, sources }
}

fn keeps(filter: &str, name: &str) -> bool {
    let (filter, name) = (filter.to_lowercase(), name.to_lowercase());
    let ends_in_digit = filter.ends_with(|c: char| c.is_ascii_digit());
    name.match_indices(&filter).any(|(at, _)| {
        let next = name[at + filter.len()..].chars().next();
        !(ends_in_digit && next.is_some_and(|c| c == '.' || c.is_ascii_digit()))
    })
}

fn validate_table(bench: &mut Bench, source: &Source, table: &Table) -> TableResult {
    let mut rows = Vec::new();
    for row in &table.rows {
        for (at, cell) in row.printed.cells().iter().enumerate() {
            let column = table.columns.get(at);
            let place = Place { source, table, row, column_edits: column.map_or(&[], |c| &c.with) };
            let engine =
                column.and_then(|c| c.engine.as_ref()).or(row.engine.as_ref()).unwrap_or(&table.engine);
            rows.push(RowResult {
                column: column.map(|c| c.name.clone()),
                ..validate_cell(bench, &place, engine, cell)
            });
        }
    }
    TableResult { table: table.table.clone(), title: table.title.clone(), rows }
}

/// Where a cell stands.
struct Place<'a> {
    source: &'a Source,
    table: &'a Table,
    row: &'a Row,
    column_edits: &'a [Edit],
}

fn validate_cell(bench: &mut Bench, place: &Place, engine: &[Edit], cell: &Cell) -> RowResult {
    let row = place.row;
    let printed = Printed::read(cell.text(), cell.place());
    let plain = ours(bench, place, engine, &[]);
    let mut matches_with = |input: &[Edit]| {
        !input.is_empty() && ours(bench, place, engine, input).is_ok_and(|value| printed.agrees(&value))
    };
    let verdict = match &plain {
        Err(_) => Verdict::NotComputed,
        Ok(value) if printed.agrees(value) => {
            let is_synthetic = row.synthetic.unwrap_or(place.table.synthetic);
            if is_synthetic { Verdict::MatchWithSyntheticInput } else { Verdict::Match }
        }
        Ok(_) if matches_with(cell.rounded()) => Verdict::MatchWithRoundedInput,
        Ok(_) if matches_with(cell.unprinted()) => Verdict::MatchWithUnprintedInput,
        Ok(value) if printed.is_close(value) => Verdict::Close,
        Ok(_) => Verdict::Differs,
    };
    let is_correct = |correct: &str| plain.as_ref().is_ok_and(|v| Printed::read(correct, None).agrees(v));
    let expected = cell.expected();
    RowResult {
        section: row.section.clone(),
        column: None,
        quantity: row.quantity.clone(),
        unit: row.unit.clone(),
        printed: cell.text().to_string(),
        ours: match &plain {
            Ok(value) => printed.show(value),
            Err(why) => why.clone(),
        },
        value: plain.as_ref().ok().and_then(|value| value.number()),
        verdict,
        expected,
        ok: verdict == expected && cell.correct().is_none_or(is_correct),
        correct: cell.correct().map(str::to_string),
        reason: cell.reason().map(str::to_string),
        how: describe(place, engine),
    }
}

/// Our value of a cell with further changes of its engine.
fn ours(bench: &mut Bench, place: &Place, engine: &[Edit], further: &[Edit]) -> Result<Value, String> {
    let Place { source, row, column_edits, .. } = *place;
    let key = Key::parse(&row.key)?;
    let edits = [engine, column_edits, &row.with, further].concat();
    let kinematics = row.kinematics.unwrap_or(source.kinematics);
    let about = row.about.as_deref();
    let run = bench.run(source, &edits, kinematics, about)?;
    let value = match row.comparison {
        None => key.of(&run)?,
        Some(comparison) => {
            let none = Over::default();
            let over = row.over.as_ref().unwrap_or(&none);
            let edits = [over.engine.as_deref().unwrap_or(engine), &over.with, further].concat();
            let reference = bench.run(source, &edits, over.kinematics.unwrap_or(kinematics), about)?;
            let reference_key = Key::parse(over.key.as_deref().unwrap_or(&row.key))?;
            Value::Number(comparison.of((&key, &run), (&reference_key, &reference))?)
        }
    };
    let divisor: f64 = row.divided_by.values().product();
    Ok(match value {
        Value::Number(number) => Value::Number(number / divisor),
        words => words,
    })
}

/// Engine, changes, motion and quantity in one line.
fn describe(place: &Place, engine: &[Edit]) -> String {
    let Place { source, row, column_edits, table } = place;
    let kinematics = |k: KinematicsName| k.kinematics().name();
    let edits = [engine, column_edits, &row.with].concat();
    let engine = edits.iter().map(Edit::to_string).collect::<Vec<_>>().join(", ");
    let mut how =
        format!("{engine}; {}; {}", kinematics(row.kinematics.unwrap_or(source.kinematics)), row.key);
    if let Some(about) = &row.about {
        how += &format!(" about the {about}");
    }
    if let Some(comparison) = row.comparison {
        how += &format!(", {}", Comparison::name(comparison));
        let names = |edits: &[Edit]| edits.iter().map(Edit::to_string).collect::<Vec<_>>();
        let over: Vec<String> = row.over.as_ref().map_or_else(Vec::new, |over| {
            let engine = over.engine.as_deref().map_or_else(Vec::new, names);
            let kinematics = over.kinematics.map(kinematics);
            over.key.clone().into_iter().chain(engine).chain(names(&over.with)).chain(kinematics).collect()
        });
        how += " over ";
        how += &if over.is_empty() { "the unchanged engine".to_string() } else { over.join(", ") };
    }
    for (what, number) in &row.divided_by {
        how += &format!(", divided by {what} {number}");
    }
    if let Some(more) = &table.how {
        how += &format!(". {more}");
    }
    how
}
