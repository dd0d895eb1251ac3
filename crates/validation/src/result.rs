//! Published numbers against ours, as they are told.

use crate::verdict::Verdict;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const VALIDATION_VERSION: u32 = 2;

/// Published numbers against ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Validation {
    /// [`VALIDATION_VERSION`].
    pub version: u32,
    /// Rows by verdict.
    pub counts: Counts,
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
    /// Half a unit of the last printed digit, in the unit of the row; `None` for a word, which must be the same.
    pub tolerance: Option<f64>,
    /// Smallest and largest result for all inputs that round to the printed ones, where they are rounded.
    pub range: Option<[f64; 2]>,
    /// Ours less the printed number, where both are numbers.
    pub residual: Option<f64>,
    /// How the two stand.
    pub verdict: Verdict,
    /// How they should.
    pub expected: Verdict,
    /// Whether the verdict is the expected one and ours equals [`RowResult::correct`].
    pub ok: bool,
    /// What ours must equal to its digits where the verdict is no match; `None` where it is unknown.
    pub correct: Option<String>,
    /// What gives the printed number: a rounded intermediate result, an assumption, or the error of the source.
    pub given_by: Option<String>,
    /// Why the verdict is no match.
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
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Counts {
    /// All rows.
    pub rows: usize,
    /// Rows of each verdict that some row has, in the order of [`Verdict::ALL`].
    pub verdicts: Vec<VerdictCount>,
    /// Rows that are not as expected.
    pub unexpected: usize,
}

/// Rows of one verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct VerdictCount {
    /// The verdict.
    pub verdict: Verdict,
    /// How many rows have it.
    pub rows: usize,
}

impl Validation {
    /// Whether there is a row and every row is as expected.
    pub fn passed(&self) -> bool {
        self.counts.rows > 0 && self.counts.unexpected == 0
    }
}

impl Counts {
    /// Counts of some rows.
    pub fn of<'a>(rows: impl IntoIterator<Item = &'a RowResult>) -> Counts {
        let rows: Vec<&RowResult> = rows.into_iter().collect();
        let of = |verdict| rows.iter().filter(|row| row.verdict == verdict).count();
        let verdicts = Verdict::ALL.map(|verdict| VerdictCount { verdict, rows: of(verdict) });
        Counts {
            rows: rows.len(),
            verdicts: verdicts.into_iter().filter(|count| count.rows > 0).collect(),
            unexpected: rows.iter().filter(|row| !row.ok).count(),
        }
    }

    /// Rows of a verdict.
    pub fn with(&self, verdict: Verdict) -> usize {
        self.verdicts.iter().find(|count| count.verdict == verdict).map_or(0, |count| count.rows)
    }
}
