//! A table of the file, and what its keys say.

use crate::schema::{Key, Kind, Table};
use lanchester_model::Ratio;
use lanchester_units::Dimension;
use std::cell::Cell;
use std::ops::Range;

/// Place in the text, in bytes.
pub(crate) type Span = Range<usize>;

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spot<T> {
    pub(crate) value: T,
    pub(crate) span: Span,
}

/// A criterion as it stands in the file, and the value beside it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Term {
    pub(crate) name: Spot<String>,
    /// A quantity as text (a bare number lacks its unit); `None` if nothing stands beside the criterion.
    pub(crate) amount: Option<Spot<String>>,
}

/// What a key of a table says.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Field<T> {
    /// The key is not there.
    Absent,
    /// It is there, and its mistake is already reported.
    Bad,
    Given(Spot<T>),
}

impl<T> Field<T> {
    /// The value; `default` if the key is not there; `None` if it is bad.
    pub(crate) fn or(self, default: T) -> Option<T> {
        match self {
            Field::Absent => Some(default),
            Field::Bad => None,
            Field::Given(spot) => Some(spot.value),
        }
    }

    /// The value, if there is a good one.
    pub(crate) fn given(self) -> Option<T> {
        match self {
            Field::Given(spot) => Some(spot.value),
            _ => None,
        }
    }

    pub(crate) fn is_bad(&self) -> bool {
        matches!(self, Field::Bad)
    }
}

/// A table of the file.
#[derive(Debug)]
pub(crate) struct Section {
    pub(super) table: &'static Table,
    /// Its header, or the whole of an inline table.
    pub(crate) span: Span,
    pub(super) entries: Vec<Entry>,
}

#[derive(Debug)]
pub(super) struct Entry {
    pub(super) key: &'static Key,
    pub(super) key_span: Span,
    pub(super) span: Span,
    pub(super) value: Value,
    pub(super) used: Cell<bool>,
}

#[derive(Debug)]
pub(super) enum Value {
    Bad,
    Flag(bool),
    Text(String),
    Word(&'static str),
    Whole(i64),
    Number(f64),
    Ratio(Ratio),
    Truth(bool),
    Terms(Vec<Term>),
    Stages(Vec<Spot<Vec<Term>>>),
    Wholes(Vec<Spot<i64>>),
    Numbers(Vec<Spot<f64>>),
    Texts(Vec<Spot<String>>),
    Table(Section),
    Tables(Vec<Section>),
}

impl Section {
    /// A table with nothing but this value.
    pub(super) fn of_one(table: &'static Table, key: &'static Key, span: Span, value: Value) -> Section {
        let entry = Entry { key, key_span: span.clone(), span: span.clone(), value, used: Cell::new(false) };
        Section { table, span, entries: vec![entry] }
    }

    /// `[rod]`, for messages.
    pub(crate) fn title(&self) -> &'static str {
        self.table.title()
    }

    /// `name = value` as an example of the key, for hints.
    pub(crate) fn example(&self, name: &str) -> String {
        self.table
            .key(name)
            .map_or(String::new(), |key| format!("for example {} = {}", key.name, key.example))
    }

    /// What the key measures, if it holds a quantity.
    pub(crate) fn dimension(&self, name: &str) -> Option<Dimension> {
        match self.table.key(name)?.kind {
            Kind::Quantity(dimension, _)
            | Kind::Quantities(dimension, _)
            | Kind::QuantityOrPair(dimension, _)
            | Kind::QuantityOrThree(dimension, _)
            | Kind::QuantityOrWord(dimension, ..) => Some(dimension),
            Kind::Share | Kind::ShareOrPair | Kind::ShareOrThree => Some(Dimension::Share),
            _ => None,
        }
    }

    /// Whether there is such a key, given or not.
    pub(crate) fn knows(&self, name: &str) -> bool {
        self.table.key(name).is_some()
    }

    /// How many tables the key may hold.
    pub(crate) fn limit(&self, name: &str) -> Option<usize> {
        match self.table.key(name)?.kind {
            Kind::Tables(_, most) | Kind::ValuesOrTables(_, most) => Some(most),
            _ => None,
        }
    }

    /// Whether the key is there, good or bad.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.entry(name).is_some()
    }

    /// Place of the key; the header if it is not there.
    pub(crate) fn key_span(&self, name: &str) -> Span {
        self.entry(name).map_or(self.span.clone(), |entry| entry.key_span.clone())
    }

    /// Place of the value; the header if it is not there.
    pub(crate) fn value_span(&self, name: &str) -> Span {
        self.entry(name).map_or(self.span.clone(), |entry| entry.span.clone())
    }

    pub(crate) fn number(&self, name: &str) -> Field<f64> {
        self.field(name, |value| if let Value::Number(number) = value { Some(*number) } else { None })
    }

    pub(crate) fn numbers(&self, name: &str) -> Field<Vec<Spot<f64>>> {
        self.field(
            name,
            |value| if let Value::Numbers(numbers) = value { Some(numbers.clone()) } else { None },
        )
    }

    pub(crate) fn whole(&self, name: &str) -> Field<i64> {
        self.field(name, |value| if let Value::Whole(number) = value { Some(*number) } else { None })
    }

    pub(crate) fn wholes(&self, name: &str) -> Field<Vec<Spot<i64>>> {
        self.field(
            name,
            |value| if let Value::Wholes(numbers) = value { Some(numbers.clone()) } else { None },
        )
    }

    pub(crate) fn ratio(&self, name: &str) -> Field<Ratio> {
        self.field(name, |value| if let Value::Ratio(ratio) = value { Some(*ratio) } else { None })
    }

    pub(crate) fn truth(&self, name: &str) -> Field<bool> {
        self.field(name, |value| if let Value::Truth(truth) = value { Some(*truth) } else { None })
    }

    /// Criteria and the value of each.
    pub(crate) fn terms(&self, name: &str) -> Field<&[Term]> {
        self.field(name, |value| if let Value::Terms(terms) = value { Some(terms.as_slice()) } else { None })
    }

    /// Quantities whose dimension only the reader knows.
    pub(crate) fn texts(&self, name: &str) -> Field<&[Spot<String>]> {
        self.field(name, |value| if let Value::Texts(texts) = value { Some(texts.as_slice()) } else { None })
    }

    /// Criteria, or tables of them.
    pub(crate) fn stages(&self, name: &str) -> Field<&[Spot<Vec<Term>>]> {
        self.field(
            name,
            |value| if let Value::Stages(stages) = value { Some(stages.as_slice()) } else { None },
        )
    }

    pub(crate) fn word(&self, name: &str) -> Field<&'static str> {
        self.field(name, |value| if let Value::Word(word) = value { Some(*word) } else { None })
    }

    pub(crate) fn flag(&self, name: &str) -> Field<bool> {
        self.field(name, |value| if let Value::Flag(flag) = value { Some(*flag) } else { None })
    }

    pub(crate) fn text(&self, name: &str) -> Field<String> {
        self.field(name, |value| if let Value::Text(text) = value { Some(text.clone()) } else { None })
    }

    pub(crate) fn table(&self, name: &str) -> Field<&Section> {
        self.field(name, |value| if let Value::Table(section) = value { Some(section) } else { None })
    }

    /// `Absent` is an empty list here.
    pub(crate) fn tables(&self, name: &str) -> Field<&[Section]> {
        self.field(
            name,
            |value| if let Value::Tables(sections) = value { Some(sections.as_slice()) } else { None },
        )
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        debug_assert!(self.table.key(name).is_some(), "{} has no key {name}", self.title());
        self.entries.iter().find(|entry| entry.key.name == name)
    }

    fn field<'a, T>(&'a self, name: &str, get: impl Fn(&'a Value) -> Option<T>) -> Field<T> {
        let Some(entry) = self.entry(name) else { return Field::Absent };
        entry.used.set(true);
        match get(&entry.value) {
            Some(value) => Field::Given(Spot { value, span: entry.span.clone() }),
            None => Field::Bad,
        }
    }

    /// Keys that nobody asked for, in this table and below: path of keys, place.
    pub(crate) fn unused(&self) -> Vec<(String, Span)> {
        let mut found = Vec::new();
        self.collect_unused("", &mut found);
        found
    }

    fn collect_unused(&self, path: &str, found: &mut Vec<(String, Span)>) {
        for entry in &self.entries {
            let path = if path.is_empty() {
                entry.key.name.to_string()
            } else {
                format!("{path}.{}", entry.key.name)
            };
            match &entry.value {
                _ if !entry.used.get() => found.push((path, entry.key_span.clone())),
                Value::Table(section) => section.collect_unused(&path, found),
                Value::Tables(sections) => {
                    for section in sections {
                        section.collect_unused(&path, found);
                    }
                }
                _ => {}
            }
        }
    }
}
