//! The graph file: TOML text to a description.

use crate::description::{Description, Entry, Text};
use crate::mistake::Mistakes;
use std::ops::Range;
use toml_spanner::{Item, Table, Value};

/// Bytes of the longest file that is read.
const LONGEST: usize = 1024 * 1024;

/// Whether a TOML text is a graph file: it has a table of elements.
pub fn is_graph_file(text: &str) -> bool {
    text.lines().any(|line| {
        let line = line.trim();
        line == "[elements]" || line.starts_with("[elements.") || line.starts_with("elements ")
    })
}

/// Reads the text; mistakes of form are noted, what can be read is.
pub(crate) fn read(text: &str, mistakes: &mut Mistakes) -> Description {
    let mut description = Description::new("graph");
    if text.len() > LONGEST {
        let message = format!("the file has {} bytes, more than the {LONGEST} that it may have", text.len());
        mistakes.push("E1715", &(0..0), message, "check that this is the right file");
        return description;
    }
    let arena = toml_spanner::Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    for error in document.errors() {
        let message = format!("the text is no TOML: {}", error.message(text));
        mistakes.push("E1701", &error.span().range(), message, "mend the syntax here");
    }
    for (key, item) in document.table() {
        let place = span(item);
        match (key.name, item.value()) {
            ("name", Value::String(name)) => description.name = name.to_string(),
            ("note" | "version", _) => {}
            ("parameters", Value::Table(table)) => description.parameters = texts(table, mistakes),
            ("elements", Value::Table(table)) => description.elements = entries(table, mistakes),
            ("signals", Value::Table(table)) => description.signals = entries(table, mistakes),
            ("simulation", Value::Table(table)) => description.simulation = texts(table, mistakes),
            ("bonds", Value::Table(table)) => {
                for (key, item) in table {
                    match (key.name, item.value()) {
                        ("list", Value::Array(list)) => {
                            for bond in list.iter() {
                                match bond.as_str() {
                                    Some(bond_text) => description
                                        .bonds
                                        .push(Text { text: bond_text.to_owned(), span: span(bond) }),
                                    None => mistakes.push(
                                        "E1701",
                                        &span(bond),
                                        "a bond is a text",
                                        "write it as \"from > to\"",
                                    ),
                                }
                            }
                        }
                        _ => mistakes.push(
                            "E1702",
                            &span(item),
                            format!("[bonds] has no key `{}`", key.name),
                            "it has the key `list` alone: list = [\"from > to\", ...]",
                        ),
                    }
                }
            }
            ("name" | "parameters" | "elements" | "signals" | "simulation" | "bonds", _) => mistakes.push(
                "E1701",
                &place,
                format!("`{}` has a value of another kind", key.name),
                if key.name == "name" { "name is a text" } else { "write it as a table" },
            ),
            (other, _) => mistakes.push(
                "E1702",
                &place,
                format!("a graph file has no `{other}`"),
                "it has name, note, [parameters], [elements], [signals], [bonds] and [simulation]",
            ),
        }
    }
    description
}

fn span(item: &Item<'_>) -> Range<usize> {
    item.span().range()
}

/// Keys with a text each; numbers are taken as they stand.
fn texts(table: &Table<'_>, mistakes: &mut Mistakes) -> Vec<(Text, Text)> {
    let mut found = Vec::new();
    for (key, item) in table {
        let place = span(item);
        let text = match item.value() {
            Value::String(text) => text.to_string(),
            Value::Integer(_) | Value::Float(_) => match item.as_f64() {
                Some(number) => format!("{number:?}"),
                None => continue,
            },
            Value::Array(list) if list.iter().all(|item| item.as_str().is_some()) => {
                list.iter().filter_map(Item::as_str).collect::<Vec<_>>().join(" ; ")
            }
            Value::Array(rows) if rows.iter().all(|row| row_text(row).is_some()) => {
                rows.iter().filter_map(row_text).collect::<Vec<_>>().join(" | ")
            }
            _ => {
                mistakes.push(
                    "E1701",
                    &place,
                    format!("`{}` needs a text with a quantity or an expression", key.name),
                    "for example \"0.05 kg m2\" or \"m*g\"",
                );
                continue;
            }
        };
        let key = Text { text: key.name.to_owned(), span: key.span.range() };
        found.push((key, Text { text, span: place }));
    }
    found
}

/// The texts of a row of a matrix.
fn row_text(row: &Item<'_>) -> Option<String> {
    let entries = row.as_array()?;
    let texts: Option<Vec<&str>> = entries.iter().map(Item::as_str).collect();
    texts.filter(|texts| !texts.is_empty()).map(|texts| texts.join(" ; "))
}

fn entries(table: &Table<'_>, mistakes: &mut Mistakes) -> Vec<Entry> {
    let mut found = Vec::new();
    for (key, item) in table {
        let place = span(item);
        let name = Text { text: key.name.to_owned(), span: key.span.range() };
        match item.value() {
            Value::Table(table) => found.push(Entry { name, keys: texts(table, mistakes) }),
            Value::String(text) => {
                let value = Text { text: text.to_string(), span: place };
                found.push(Entry { name, keys: vec![("value".into(), value)] });
            }
            _ => mistakes.push(
                "E1701",
                &place,
                format!("`{}` needs a table", key.name),
                "for example { kind = \"I\", inertia = \"2 kg\" }",
            ),
        }
    }
    found
}
