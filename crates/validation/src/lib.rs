//! Every published number that Lanchester can compute, printed against computed.
//!
//! `validation/<source>/` holds what a source prints, table by table, with the engine files that its numbers belong
//! to. Each number is computed the whole way: the text of the engine file, changed where the table changes the
//! engine, is read, its loads are computed in the source's convention, and one quantity is taken from them. The
//! verdict is then held against the expected one, so that a number that the source prints wrongly is checked as
//! strictly as a right one: its row names what is correct, and ours must equal that.
//!
//! The tolerance of every number is half a unit of its last printed digit, and every row shows it. A *match* is ours
//! within it, from the printed inputs; whatever explains another number afterwards has a verdict of its own.
//!
//! ```
//! let validation = lanchester_validation::validate(Some("Table 4"));
//! assert!(validation.passed());
//! ```
#![forbid(unsafe_code)]

mod atlas;
mod case;
mod compared;
mod crank_cycle;
mod files;
mod fitting;
mod gas;
mod gas_run;
mod graph;
mod inputs;
mod method;
mod quantity;
mod render;
mod result;
mod rigid_run;
mod shape;
mod source;
mod standalone;
mod stress;
mod suite;
#[cfg(test)]
mod tests;
mod value;
mod verdict;
mod workshop;

pub use atlas::{
    Atlas, AtlasFigure, AtlasNumber, AtlasSource, FigureVerdict, atlas, atlas_markdown, atlas_page,
};
pub use render::{csv, markdown, text};
pub use result::{
    Counts, Deferred, RowResult, SourceResult, TableResult, VALIDATION_VERSION, Validation, VerdictCount,
};
pub use suite::{
    SUITE_VERSION, Suite, SuiteComparison, SuiteMotion, SuiteNumber, SuiteRow, SuiteSource, suite,
    suite_schema,
};
pub use verdict::Verdict;

use case::{Bench, sheet};
use files::Source;
use inputs::{corners, is_input};
use quantity::Key;
use rayon::prelude::*;
use source::{Cell, Column, Comparison, Edit, KinematicsName, Over, Row, Table};
use value::{Ours, Value};
use verdict::Printed;

/// Computes every published number, or those of the sources and tables that `filter` names.
///
/// A filter keeps the tables whose "source table" (for instance "twin-cylinder-thesis Table 4") holds it, upper and
/// lower case alike; a filter that ends in a digit does not keep a longer number (Table 40, Table 4.2). A filter that keeps nothing gives
/// no rows, and a validation without rows has not passed.
pub fn validate(filter: Option<&str>) -> Validation {
    // Sources share no engines.
    let sources = files::sources();
    gathered(
        sources
            .into_par_iter()
            .map(|source| validate_source(&mut Bench::default(), &source, filter))
            .collect(),
    )
}

/// With what the bench has computed already.
#[cfg(test)]
fn validate_on(bench: &mut Bench, filter: Option<&str>) -> Validation {
    gathered(files::sources().iter().map(|source| validate_source(bench, source, filter)).collect())
}

fn gathered(sources: Vec<SourceResult>) -> Validation {
    let sources: Vec<SourceResult> = sources.into_iter().filter(|source| !source.tables.is_empty()).collect();
    let counts = Counts::of(sources.iter().flat_map(|source| &source.tables).flat_map(|table| &table.rows));
    Validation { version: VALIDATION_VERSION, counts, sources }
}

/// The tables of a source that the filter keeps.
fn validate_source(bench: &mut Bench, source: &Source, filter: Option<&str>) -> SourceResult {
    let kept = |table: &&Table| filter.is_none_or(|f| keeps(f, &format!("{} {}", source.key, table.table)));
    SourceResult {
        key: source.key.clone(),
        title: source.title.clone(),
        citation: source.citation.clone(),
        tables: source.tables.iter().filter(kept).map(|table| validate_table(bench, source, table)).collect(),
        deferred: source.deferred.clone(),
    }
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
    let rows = validate_rows(bench, source, table, |_, _| true);
    TableResult { table: table.table.clone(), title: table.title.clone(), rows }
}

/// The cells of a table that are asked for, by row and column.
fn validate_rows(
    bench: &mut Bench,
    source: &Source,
    table: &Table,
    asked: impl Fn(&Row, Option<&Column>) -> bool,
) -> Vec<RowResult> {
    let cells = cells(source, table).into_iter().filter(|at| asked(at.place.row, at.column));
    let row = |at: CellAt| RowResult {
        column: at.column.map(|c| c.name.clone()),
        ..validate_cell(bench, &at.place, at.engine, at.cell)
    };
    cells.map(row).collect()
}

/// A cell with where it stands, its column and its engine.
struct CellAt<'a> {
    place: Place<'a>,
    column: Option<&'a Column>,
    engine: &'a [Edit],
    cell: &'a Cell,
}

/// All cells of a table, row by row.
fn cells<'a>(source: &'a Source, table: &'a Table) -> Vec<CellAt<'a>> {
    let of_row = |row: &'a Row| {
        row.printed.cells().iter().enumerate().map(move |(at, cell)| {
            let column = table.columns.get(at);
            let place = Place { source, table, row, column_edits: column.map_or(&[], |c| &c.with) };
            let own = column.and_then(|c| c.engine.as_ref()).or(row.engine.as_ref());
            CellAt { place, column, engine: own.unwrap_or(&table.engine), cell }
        })
    };
    table.rows.iter().flat_map(of_row).collect()
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
    let printed = Printed::read(cell.text());
    let plain = ours(bench, place, engine, &[]);
    let range = range(bench, place, engine);
    let expected = cell.stated().or(row.expected).unwrap_or(Verdict::Match);
    let (verdict, given_by) = match (&plain, &range) {
        (Err(_), _) | (_, Err(_)) => (Verdict::NotComputed, None),
        (Ok(found), Ok(range)) => judge(bench, place, engine, cell, found, *range),
    };
    let value = plain.as_ref().ok().map(|found| found.value);
    let is = |text: &str| value.is_some_and(|value| Printed::read(text).agrees(&value));
    let residual = value.and_then(|value| printed.residual(&value));
    let is_held = match (verdict, cell.correct(), cell.residual()) {
        (Verdict::Residual, _, Some(text)) => {
            residual.is_some_and(|residual| Printed::read(text).agrees(&Value::Number(residual)))
        }
        (Verdict::Residual, _, None) => false,
        (_, Some(correct), _) => is(correct),
        (Verdict::InputItself, None, _) => is(cell.text()),
        (_, None, _) => true,
    };
    let failed = plain.as_ref().err().or(range.as_ref().err());
    RowResult {
        section: row.section.clone(),
        column: None,
        quantity: row.quantity.clone(),
        unit: row.unit.clone(),
        printed: cell.text().to_string(),
        ours: match (failed, value) {
            (None, Some(value)) => printed.show(&value),
            (why, _) => why.cloned().unwrap_or_default(),
        },
        value: value.and_then(Value::number),
        tolerance: printed.tolerance(),
        range: range.ok().flatten(),
        residual,
        verdict,
        expected,
        ok: verdict == expected && is_held,
        correct: cell.correct().map(str::to_string),
        given_by,
        reason: cell.reason().or(row.reason.as_deref()).map(str::to_string),
        how: describe(place, engine),
    }
}

/// How ours stands to a printed number, and what gives the printed number if ours does not.
fn judge(
    bench: &mut Bench,
    place: &Place,
    engine: &[Edit],
    cell: &Cell,
    found: &Ours,
    range: Option<[f64; 2]>,
) -> (Verdict, Option<String>) {
    let printed = Printed::read(cell.text());
    let mut given = |edits: &[Edit]| {
        let agrees = !edits.is_empty()
            && ours(bench, place, engine, edits).is_ok_and(|found| printed.agrees(&found.value));
        agrees.then(|| edits.iter().map(Edit::to_string).collect::<Vec<_>>().join(", "))
    };
    let agrees = printed.agrees(&found.value);
    if found.is_input {
        return (Verdict::InputItself, None);
    }
    if place.row.synthetic.unwrap_or(place.table.synthetic) {
        return (Verdict::Residual, None);
    }
    if let Some(error) = given(cell.wrong()) {
        return (if agrees { Verdict::Accident } else { Verdict::SourceWrong }, Some(error));
    }
    if agrees {
        return (Verdict::Match, None);
    }
    if range.is_some_and(|range| printed.lies_between(range)) {
        return (Verdict::WithinRounding, None);
    }
    if let Some(intermediate) = given(cell.rounded()) {
        return (Verdict::RoundedIntermediate, Some(intermediate));
    }
    if let Some(assumption) = given(cell.assumed()) {
        return (Verdict::ExplainedAfterwards, Some(assumption));
    }
    // An explanation that is given must hold.
    let is_explained = [cell.wrong(), cell.rounded(), cell.assumed()].iter().any(|edits| !edits.is_empty());
    match cell.expected() {
        stated if stated.is_stated() && !is_explained => (stated, None),
        _ => (Verdict::Differs, None),
    }
}

/// Smallest and largest result over the corners of the box of inputs that round to the printed ones.
///
/// What lies between two results of a connected box is a result too, so that a number between them is one for some
/// inputs that round to the printed ones.
fn range(bench: &mut Bench, place: &Place, engine: &[Edit]) -> Result<Option<[f64; 2]>, String> {
    if place.table.rounded_inputs.is_empty() {
        return Ok(None);
    }
    let edits = [engine, place.column_edits, &place.row.with].concat();
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for corner in corners(&edits, &place.source.changes, &place.table.rounded_inputs)? {
        if let Value::Number(result) = ours(bench, place, engine, &[Edit::Written(corner)])?.value {
            range = [range[0].min(result), range[1].max(result)];
        }
    }
    Ok((range[0] <= range[1]).then_some(range))
}

/// Our value of a cell with further changes of its engine: computed once, for it does not depend on what is printed.
fn ours(bench: &mut Bench, place: &Place, engine: &[Edit], further: &[Edit]) -> Result<Ours, String> {
    let Place { source, row, column_edits, .. } = *place;
    let Row { key, with, about, kinematics, comparison, over, divided_by, .. } = row;
    let asked = (key, with, about, kinematics, comparison, over, divided_by);
    let id = format!("{:?}", (&source.key, engine, column_edits, further, asked));
    if let Some(known) = bench.values.get(&id) {
        return known.clone();
    }
    let found = computed(bench, place, engine, further);
    bench.values.insert(id, found.clone());
    found
}

/// The same, computed.
fn computed(bench: &mut Bench, place: &Place, engine: &[Edit], further: &[Edit]) -> Result<Ours, String> {
    let Place { source, row, column_edits, .. } = *place;
    let key = Key::parse(&row.key)?;
    let edits = [engine, column_edits, &row.with, further].concat();
    let divisor: f64 = row.divided_by.values().product();
    if let Key::Mechanism(key) = &key {
        return Ok(Ours { value: Value::Number(key.of()? / divisor), is_input: false });
    }
    if let Key::Film(key) = &key {
        return Ok(Ours { value: Value::Number(key.of()? / divisor), is_input: false });
    }
    if let Key::Elastic(key) = &key {
        return Ok(Ours { value: Value::Number(key.of()? / divisor), is_input: false });
    }
    if let Key::Workshop(key) = &key {
        let (sheet, inputs) = sheet(source, &edits)?;
        let number = key.of(&sheet)?;
        return Ok(Ours { value: Value::Number(number / divisor), is_input: is_input(number, &inputs) });
    }
    let kinematics = row.kinematics.unwrap_or(source.kinematics);
    let about = row.about.as_deref();
    let run = bench.run(source, &edits, kinematics, about)?;
    let mut is_input = key.number_of(&run).is_ok_and(|number| is_input(number, &run.inputs));
    let value = match row.comparison {
        None => key.of(&run)?,
        Some(comparison) => {
            let none = Over::default();
            let over = row.over.as_ref().unwrap_or(&none);
            let edits = [over.engine.as_deref().unwrap_or(engine), &over.with, further].concat();
            let reference = bench.run(source, &edits, over.kinematics.unwrap_or(kinematics), about)?;
            let reference_key = Key::parse(over.key.as_deref().unwrap_or(&row.key))?;
            // Two inputs compared are inputs still.
            let other = reference_key.number_of(&reference);
            is_input &= other.is_ok_and(|number| inputs::is_input(number, &reference.inputs));
            Value::Number(comparison.of((&key, &run), (&reference_key, &reference))?)
        }
    };
    let value = match value {
        Value::Number(number) => Value::Number(number / divisor),
        word => word,
    };
    Ok(Ours { value, is_input })
}

/// Engine, changes, motion and quantity in one line.
fn describe(place: &Place, engine: &[Edit]) -> String {
    let Place { source, row, column_edits, table } = place;
    let kinematics = |k: KinematicsName| k.kinematics().name();
    let edits = [engine, column_edits, &row.with].concat();
    let engine = edits.iter().map(Edit::to_string).collect::<Vec<_>>().join(", ");
    if ["squeezer ", "film ", "short bearing "].iter().any(|own| row.key.starts_with(own)) {
        return row.key.clone() + &table.how.as_ref().map_or_else(String::new, |how| format!(". {how}"));
    }
    if row.key.starts_with("workshop ") {
        return format!("{engine}; {}", row.key);
    }
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
