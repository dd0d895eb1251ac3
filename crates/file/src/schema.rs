//! Every key of the engine file in one table: it drives the reading, the messages about unknown keys, the JSON
//! Schema and the reference.

mod json;
mod key_tables;
mod keys;
mod reference;

pub use json::{SCHEMA_ID, json_schema, sheet_schema};
pub use key_tables::{KeyInfo, KeyTable, key_tables};
pub(crate) use keys::{FILE, key, quantity};
pub use reference::{reference_markdown, sheet_reference_markdown};

pub(crate) use lanchester_units::Bound;
use lanchester_units::Dimension;

/// A table of the file and its keys.
#[derive(Debug)]
pub(crate) struct Table {
    /// As the file writes it: `[rod]`, `[[cylinder]]`; empty for the file itself.
    pub(crate) header: &'static str,
    /// What it describes.
    pub(crate) doc: &'static str,
    pub(crate) keys: &'static [Key],
}

impl Table {
    pub(crate) fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// `[rod]`, or `the file` for the root.
    pub(crate) fn title(&self) -> &'static str {
        if self.header.is_empty() { "the file" } else { self.header }
    }

    /// Every table below this one and itself, each once, in the order of the reference.
    pub(crate) fn all(&'static self) -> Vec<&'static Table> {
        let mut tables: Vec<&'static Table> = vec![self];
        for key in self.keys {
            if let Kind::Table(table) | Kind::Tables(table, _) | Kind::ValuesOrTables(table, _) = key.kind {
                for table in table.all() {
                    if !tables.iter().any(|known| std::ptr::eq(*known, table)) {
                        tables.push(table);
                    }
                }
            }
        }
        tables
    }
}

/// A key of a table.
#[derive(Debug)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) need: Need,
    /// One or two sentences.
    pub(crate) doc: &'static str,
    /// A value as it stands in a file.
    pub(crate) example: &'static str,
    /// Layout types for which the key means something; empty for all.
    pub(crate) layouts: &'static [&'static str],
}

/// Whether a key must be given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    Required,
    Optional,
}

/// What a key holds.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Kind {
    /// `true` or `false`.
    Flag,
    /// Text of at most so many characters.
    Text(usize),
    /// A whole number within bounds.
    Whole(i64, i64),
    /// A list of whole numbers within bounds.
    Wholes(i64, i64),
    /// One of a few whole numbers.
    WholeChoice(&'static [i64]),
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// A quantity with its unit.
    Quantity(Dimension, Bound),
    /// A list of quantities.
    Quantities(Dimension, Bound),
    /// A quantity, or a list of two.
    QuantityOrPair(Dimension, Bound),
    /// A quantity, or a list of three, one for each direction.
    QuantityOrThree(Dimension, Bound),
    /// A quantity with its unit, or the word that stands for one that is found.
    QuantityOrWord(Dimension, Bound, &'static str),
    /// `"50 %"` or a bare fraction.
    Share,
    /// A share, or a list of two.
    ShareOrPair,
    /// A share, or a list of three, one for each direction.
    ShareOrThree,
    /// A list of three bare numbers, not all 0.
    Direction,
    /// A bare number.
    Number(Bound),
    /// `true` or `false`.
    Truth,
    /// A list of criteria, or of tables of criteria and the value of each that counts as much as the others'.
    Stages,
    /// A mass or an unbalance, or a list of them.
    Amounts,
    /// A list of criteria that are one order of a load each.
    Orders,
    /// A list of films and safeties.
    Durabilities,
    /// Films and safeties, each with its smallest value.
    AtLeast,
    /// A table of criteria and the largest value of each.
    Limits,
    /// A table of criteria and the share or amount of each that later stages may give up.
    GiveUps,
    /// A whole number or a fraction such as `"1/2"`, not 0.
    Ratio,
    /// The order of a harmonic: a number of 0 or more, or a fraction such as `"1/2"`.
    Order,
    /// A table.
    Table(&'static Table),
    /// Tables, at most so many.
    Tables(&'static Table, usize),
    /// A list of tables, at most so many, each of which may be the value of its first key alone.
    ValuesOrTables(&'static Table, usize),
}

impl Kind {
    /// What is due, for messages: "a length with its unit", "a whole number".
    pub(crate) fn wanted(self) -> String {
        match self {
            Kind::Flag => "true or false".into(),
            Kind::Text(_) => "a text".into(),
            Kind::Whole(..) => "a whole number".into(),
            Kind::WholeChoice(choices) => {
                let names: Vec<String> = choices.iter().map(i64::to_string).collect();
                lanchester_units::one_of(names.iter().map(String::as_str))
            }
            Kind::Wholes(..) => "a list of whole numbers".into(),
            Kind::Choice(words) => {
                format!("one of the words {}", lanchester_units::one_of(words.iter().copied()))
            }
            Kind::Quantity(dimension, _) => format!("{} with its unit", dimension.with_article()),
            Kind::Quantities(dimension, _) => {
                format!("a list, each entry {} with its unit", dimension.with_article())
            }
            Kind::QuantityOrPair(dimension, _) => {
                format!("{} with its unit, or a list of the lowest and the highest", dimension.with_article())
            }
            Kind::QuantityOrThree(dimension, _) => {
                format!("{} with its unit, or a list of three", dimension.with_article())
            }
            Kind::QuantityOrWord(dimension, _, word) => {
                format!("{} with its unit, or \"{word}\"", dimension.with_article())
            }
            Kind::Share => "a share such as \"50 %\"".into(),
            Kind::ShareOrPair => "a share such as \"50 %\", or a list of the least and the most".into(),
            Kind::ShareOrThree => "a share such as 0.1 or \"10 %\", or a list of three".into(),
            Kind::Direction => "a direction: a list of three bare numbers".into(),
            Kind::Number(_) => "a bare number".into(),
            Kind::Truth => "true or false".into(),
            Kind::Stages => "a list of criteria".into(),
            Kind::Amounts => "a mass or an unbalance with its unit, or a list of them".into(),
            Kind::Orders => "a list of orders of loads".into(),
            Kind::Durabilities => "a list of films and safeties".into(),
            Kind::AtLeast => "a table of films and safeties and their smallest values".into(),
            Kind::Limits => "a table of criteria and their largest values".into(),
            Kind::GiveUps => "a table of criteria and what each may give up".into(),
            Kind::Order => "a number of 0 or more, or a fraction such as \"1/2\"".into(),
            Kind::Ratio => "a speed ratio such as -1, 2 or \"1/2\"".into(),
            Kind::Table(_) => "a table".into(),
            Kind::Tables(..) => "a list of tables".into(),
            Kind::ValuesOrTables(table, _) => {
                let value = table.keys.first().map_or_else(String::new, |key| key.kind.wanted());
                format!("a list, each entry {value} or a table")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workshop::SHEET;

    #[test]
    fn every_example_is_a_value_of_its_kind() {
        for table in FILE.all().into_iter().chain(SHEET.all()) {
            for key in table.keys {
                let text = format!("{} = {}", key.name, key.example);
                let arena = toml_spanner::Arena::new();
                let document = toml_spanner::parse(&text, &arena).unwrap_or_else(|e| panic!("{text}: {e:?}"));
                if let (Kind::Quantity(dimension, _), Some(example)) = (key.kind, document[key.name].as_str())
                {
                    assert!(lanchester_units::parse(example, dimension, key.name).is_ok(), "{text}");
                } else {
                    assert!(!matches!(key.kind, Kind::Quantity(..)), "{text}");
                }
            }
        }
    }

    #[test]
    fn keys_are_unique_and_documented() {
        for table in FILE.all().into_iter().chain(SHEET.all()) {
            for (place, key) in table.keys.iter().enumerate() {
                assert!(table.keys[..place].iter().all(|other| other.name != key.name), "{}", key.name);
                assert!(key.doc.ends_with('.') && !key.example.is_empty(), "{}", key.name);
            }
        }
    }
}
