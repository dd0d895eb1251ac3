//! What the table files of `validation/` hold.

use crate::verdict::Verdict;
use lanchester::mechanism::Kinematics;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

/// A table file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Table {
    pub table: String,
    pub title: String,
    /// How the source computed it, where that is not plain.
    #[serde(default)]
    pub how: Option<String>,
    /// Engine file, then changes.
    pub engine: Vec<Edit>,
    /// Whether its numbers come from an input that was fitted to them.
    #[serde(default)]
    pub synthetic: bool,
    /// Places of changes whose printed values are rounded themselves: results for all that rounds to them are computed.
    #[serde(default)]
    pub rounded_inputs: Vec<String>,
    #[serde(default)]
    pub columns: Vec<Column>,
    pub rows: Vec<Row>,
}

/// A column: another engine, or changes of the table's.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Column {
    pub name: String,
    #[serde(default)]
    pub engine: Option<Vec<Edit>>,
    #[serde(default)]
    pub with: Vec<Edit>,
}

/// A quantity with its printed number, or one for each column.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Row {
    #[serde(default)]
    pub section: Option<String>,
    pub quantity: String,
    pub unit: String,
    /// Which of our quantities it is.
    pub key: String,
    #[serde(default)]
    pub engine: Option<Vec<Edit>>,
    #[serde(default)]
    pub with: Vec<Edit>,
    #[serde(default)]
    pub kinematics: Option<KinematicsName>,
    /// Whether it comes from an input that was fitted to it; as the table says unless given.
    #[serde(default)]
    pub synthetic: Option<bool>,
    /// The verdict of those of its numbers that state none.
    #[serde(default)]
    pub expected: Option<Verdict>,
    /// Why, for those of its numbers that give no reason.
    #[serde(default)]
    pub reason: Option<String>,
    /// Point that couples are about, if not the origin.
    #[serde(default)]
    pub about: Option<String>,
    /// Percentage of what: the row compares two values.
    #[serde(default, rename = "as")]
    pub comparison: Option<Comparison>,
    /// What it is compared with; the engine without changes unless given.
    #[serde(default)]
    pub over: Option<Over>,
    /// Named numbers (SI) that our quantity is divided by.
    #[serde(default)]
    pub divided_by: BTreeMap<String, f64>,
    pub printed: PrintedCells,
}

/// What a row is compared with.
#[derive(Debug, Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(crate) struct Over {
    #[serde(default)]
    pub engine: Option<Vec<Edit>>,
    #[serde(default)]
    pub with: Vec<Edit>,
    #[serde(default)]
    pub kinematics: Option<KinematicsName>,
    #[serde(default)]
    pub key: Option<String>,
}

/// How two values are compared, in per cent.
#[derive(Debug, Deserialize, Clone, Copy)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Comparison {
    /// 100 (value/reference - 1).
    Increase,
    /// 100 (1 - value/reference).
    Decrease,
    /// 100 |value/reference - 1|.
    Error,
    /// 100 value/reference.
    Ratio,
    /// 100 times the mean of |value/reference - 1| over the angles of a trace.
    #[serde(rename = "mean error")]
    MeanError,
}

impl Comparison {
    /// Name for a description.
    pub fn name(self) -> &'static str {
        match self {
            Comparison::Increase => "increase",
            Comparison::Decrease => "decrease",
            Comparison::Error => "error",
            Comparison::Ratio => "ratio",
            Comparison::MeanError => "mean error",
        }
    }
}

/// One printed number or one for each column.
#[derive(Deserialize)]
#[serde(untagged)]
pub(crate) enum PrintedCells {
    Columns(Vec<Cell>),
    One(Cell),
}

impl PrintedCells {
    pub fn cells(&self) -> &[Cell] {
        match self {
            PrintedCells::Columns(cells) => cells,
            PrintedCells::One(cell) => std::slice::from_ref(cell),
        }
    }
}

/// A printed number that ours matches, or one with something to say about it.
#[derive(Deserialize)]
#[serde(untagged)]
pub(crate) enum Cell {
    Plain(String),
    Explained(Explained),
}

/// A printed number with a verdict other than a match, or with something to say about it.
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(crate) struct Explained {
    text: String,
    #[serde(default)]
    expected: Option<Verdict>,
    /// What ours must equal to its digits.
    #[serde(default)]
    correct: Option<String>,
    /// Ours less the printed number, where ours comes from an input that was fitted to it.
    #[serde(default)]
    residual: Option<String>,
    /// An intermediate result as the source rounds and prints it.
    #[serde(default)]
    rounded: Vec<Edit>,
    /// An assumption that was looked for to give the printed number.
    #[serde(default)]
    assumed: Vec<Edit>,
    /// The error of the source that gives the printed number.
    #[serde(default)]
    wrong: Vec<Edit>,
    #[serde(default)]
    reason: Option<String>,
}

impl Cell {
    fn explained(&self) -> Option<&Explained> {
        match self {
            Cell::Plain(_) => None,
            Cell::Explained(explained) => Some(explained),
        }
    }

    pub fn text(&self) -> &str {
        match self {
            Cell::Plain(text) => text,
            Cell::Explained(explained) => &explained.text,
        }
    }

    /// The verdict that it states itself.
    pub fn stated(&self) -> Option<Verdict> {
        self.explained().and_then(|e| e.expected)
    }

    pub fn expected(&self) -> Verdict {
        self.stated().unwrap_or(Verdict::Match)
    }

    pub fn correct(&self) -> Option<&str> {
        self.explained().and_then(|e| e.correct.as_deref())
    }

    pub fn reason(&self) -> Option<&str> {
        self.explained().and_then(|e| e.reason.as_deref())
    }

    pub fn residual(&self) -> Option<&str> {
        self.explained().and_then(|e| e.residual.as_deref())
    }

    pub fn rounded(&self) -> &[Edit] {
        self.explained().map_or(&[], |e| &e.rounded)
    }

    pub fn assumed(&self) -> &[Edit] {
        self.explained().map_or(&[], |e| &e.assumed)
    }

    pub fn wrong(&self) -> &[Edit] {
        self.explained().map_or(&[], |e| &e.wrong)
    }
}

#[cfg(test)]
impl Cell {
    fn change(&mut self) -> &mut Explained {
        if let Cell::Plain(text) = self {
            *self = Cell::Explained(Explained { text: std::mem::take(text), ..Explained::default() });
        }
        let Cell::Explained(explained) = self else { unreachable!("made above") };
        explained
    }

    pub fn set_text(&mut self, text: String) {
        self.change().text = text;
    }

    pub fn set_correct(&mut self, correct: Option<String>) {
        self.change().correct = correct;
    }

    pub fn set_expected(&mut self, expected: Verdict) {
        self.change().expected = Some(expected);
    }
}

/// An engine file, a named change of the source, or a change written out.
#[derive(Debug, Deserialize, Clone)]
#[serde(untagged)]
pub(crate) enum Edit {
    Named(String),
    Written(Change),
}

/// New values by "section.key" (none: the line goes), sections that go, and under "append" lines for the end.
pub(crate) type Change = BTreeMap<String, NewValue>;

/// What a change puts in a place.
#[derive(Debug, Deserialize, Clone)]
#[serde(untagged)]
pub(crate) enum NewValue {
    Gone(()),
    Text(String),
    Lines(Vec<String>),
}

impl fmt::Display for Edit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Edit::Named(name) => f.write_str(name),
            Edit::Written(change) => {
                let words: Vec<String> = change
                    .iter()
                    .map(|(key, value)| match value {
                        NewValue::Gone(()) => format!("no {key}"),
                        NewValue::Text(text) => format!("{key} {text}"),
                        NewValue::Lines(lines) => lines.join(" "),
                    })
                    .collect();
                f.write_str(&words.join(", "))
            }
        }
    }
}

/// Motion as the data files name it.
#[derive(Debug, Deserialize, Clone, Copy)]
#[serde(untagged)]
pub(crate) enum KinematicsName {
    Series { orders: u32, powers: u32 },
    Named(ExactName),
}

/// The one motion that has a name.
#[derive(Debug, Deserialize, Clone, Copy)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ExactName {
    Exact,
}

impl KinematicsName {
    pub fn kinematics(self) -> Kinematics {
        match self {
            KinematicsName::Series { orders, powers } => {
                Kinematics::PowerSeries { max_order: orders, max_power: powers }
            }
            KinematicsName::Named(ExactName::Exact) => Kinematics::Exact,
        }
    }
}
