//! Every table and key of the engine file as data: what forms are made of.

use super::{FILE, Key, Kind, Need, Table};
use serde::Serialize;

/// A table of the engine file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct KeyTable {
    /// Where it stands: `crank`, `gas.cycle`, `cylinder[]` for the entries of a list; empty for the file itself.
    pub path: String,
    /// What it describes.
    pub doc: &'static str,
    /// Its keys.
    pub keys: Vec<KeyInfo>,
}

/// A key of the engine file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct KeyInfo {
    /// Its name.
    pub name: &'static str,
    /// One or two sentences.
    pub doc: &'static str,
    /// What is due, for messages: "a length with its unit".
    pub wanted: String,
    /// `text`, `flag`, `whole`, `number`, `choice`, `quantity`, `share`, `ratio`, `list`, `table` or `tables`; `quantities` where one
    /// quantity or several may stand.
    pub kind: &'static str,
    /// The words or numbers that may stand; empty for any.
    pub choices: Vec<String>,
    /// Whether it must be given.
    pub required: bool,
    /// Layout types for which it means something; empty for all.
    pub layouts: &'static [&'static str],
    /// A value as it stands in a file.
    pub example: &'static str,
}

/// All tables, each at every place where it may stand.
pub fn key_tables() -> Vec<KeyTable> {
    let mut found = Vec::new();
    collect(&FILE, String::new(), &mut found);
    found
}

fn collect(table: &'static Table, path: String, found: &mut Vec<KeyTable>) {
    found.push(KeyTable { path: path.clone(), doc: table.doc, keys: table.keys.iter().map(info).collect() });
    for key in table.keys {
        let below = if path.is_empty() { key.name.to_string() } else { format!("{path}.{}", key.name) };
        match key.kind {
            Kind::Table(table) => collect(table, below, found),
            Kind::Tables(table, _) | Kind::ValuesOrTables(table, _) => {
                collect(table, format!("{below}[]"), found)
            }
            _ => {}
        }
    }
}

fn info(key: &Key) -> KeyInfo {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_string()).collect();
    let (kind, choices) = match key.kind {
        Kind::Flag | Kind::Truth => ("flag", Vec::new()),
        Kind::Text(_) => ("text", Vec::new()),
        Kind::Whole(..) => ("whole", Vec::new()),
        Kind::WholeChoice(choices) => ("choice", choices.iter().map(i64::to_string).collect()),
        Kind::Choice(choices) => ("choice", words(choices)),
        Kind::Quantity(..) | Kind::QuantityOrWord(..) => ("quantity", Vec::new()),
        Kind::Quantities(..) | Kind::QuantityOrPair(..) | Kind::QuantityOrThree(..) => {
            ("quantities", Vec::new())
        }
        Kind::Share | Kind::ShareOrPair | Kind::ShareOrThree => ("share", Vec::new()),
        Kind::Number(_) | Kind::Order => ("number", Vec::new()),
        Kind::Ratio => ("ratio", Vec::new()),
        Kind::Wholes(..)
        | Kind::Direction
        | Kind::Amounts
        | Kind::Stages
        | Kind::Orders
        | Kind::Durabilities => ("list", Vec::new()),
        Kind::Limits | Kind::AtLeast | Kind::GiveUps | Kind::Table(_) => ("table", Vec::new()),
        Kind::Tables(..) => ("tables", Vec::new()),
        Kind::ValuesOrTables(..) => ("list", Vec::new()),
    };
    KeyInfo {
        name: key.name,
        doc: key.doc,
        wanted: key.kind.wanted(),
        kind,
        choices,
        required: key.need == Need::Required,
        layouts: key.layouts,
        example: key.example,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_has_its_place() {
        let tables = key_tables();
        let of = |path: &str| tables.iter().find(|table| table.path == path);
        assert!(of("").is_some_and(|root| root.keys.iter().any(|key| key.name == "speed" && key.required)));
        let stroke = of("crank").and_then(|crank| crank.keys.iter().find(|key| key.name == "stroke"));
        assert_eq!(
            stroke.map(|key| (key.kind, key.wanted.as_str())),
            Some(("quantity", "a length with its unit"))
        );
        assert!(
            of("counterweight[]").is_some() && of("gas.cycle").is_some() && of("cylinder[].piston").is_some()
        );
    }
}
