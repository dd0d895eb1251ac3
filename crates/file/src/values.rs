//! An engine file from plain values, as a program holds them: maps, lists, texts and numbers.

use crate::expanded::quoted;
use crate::schema::{FILE, Kind, Table};
use crate::workshop::SHEET;
use lanchester_units::{Dimension, exact_text};
use serde_json::{Map, Value};
use std::fmt::Write;

/// The text of an engine file with these keys; what is `null` is left out. Whether it makes an engine is for
/// [`read`](crate::read) to tell.
///
/// ```
/// let values = serde_json::json!({ "mount": [{ "x": "0 m" }], "name": "twin", "rod": { "length": "120 mm" } });
/// let text = lanchester_file::values_text(values.as_object().expect("it is an object"));
/// assert_eq!(text, "name = \"twin\"\n\n[[mount]]\nx = \"0 m\"\n\n[rod]\nlength = \"120 mm\"\n");
/// ```
pub fn values_text(values: &Map<String, Value>) -> String {
    let mut out = String::new();
    write_table(&mut out, "", values);
    out
}

fn write_table(out: &mut String, path: &str, values: &Map<String, Value>) {
    let tables = |value: &Value| {
        let all_tables = |list: &Vec<Value>| !list.is_empty() && list.iter().all(Value::is_object);
        value.is_object() || value.as_array().is_some_and(all_tables)
    };
    for (key, value) in values.iter().filter(|(_, value)| !value.is_null() && !tables(value)) {
        let _ = writeln!(out, "{} = {}", key_text(key), inline(value));
    }
    let below = |key: &String| match path {
        "" => key_text(key),
        _ => format!("{path}.{}", key_text(key)),
    };
    for (key, value) in values.iter().filter(|(_, value)| tables(value)) {
        let path = below(key);
        let mut block = |header: String, values: &Map<String, Value>| {
            if !out.is_empty() {
                out.push('\n');
            }
            let _ = writeln!(out, "{header}");
            write_table(out, &path, values);
        };
        match value {
            Value::Object(values) => block(format!("[{path}]"), values),
            _ => {
                for entry in value.as_array().into_iter().flatten().filter_map(Value::as_object) {
                    block(format!("[[{path}]]"), entry);
                }
            }
        }
    }
}

fn key_text(key: &str) -> String {
    let is_bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if is_bare { key.to_owned() } else { quoted(key) }
}

fn inline(value: &Value) -> String {
    match value {
        Value::String(text) => quoted(text),
        Value::Array(list) => format!("[{}]", list.iter().map(inline).collect::<Vec<_>>().join(", ")),
        Value::Object(keys) => {
            let keys = keys.iter().filter(|(_, value)| !value.is_null());
            let keys: Vec<String> =
                keys.map(|(key, value)| format!("{} = {}", key_text(key), inline(value))).collect();
            if keys.is_empty() { "{}".into() } else { format!("{{ {} }}", keys.join(", ")) }
        }
        other => other.to_string(),
    }
}

/// `value` of the key at `path` (`crank.stroke`, `cylinder[1].piston`; empty for the whole file) with every bare number of a key that
/// is a quantity as a text with its SI unit, which reads back as the same number. Keys that the file does not know stay as they are.
///
/// ```
/// let value = lanchester_file::si_value("crank.stroke", serde_json::json!(0.0795));
/// assert_eq!(value, serde_json::json!("79.5 mm"));
/// ```
pub fn si_value(path: &str, value: Value) -> Value {
    let keys = path.split('.').map(|key| key.split('[').next().unwrap_or(key)).filter(|key| !key.is_empty());
    let mut kind = Kind::Table(&FILE);
    for name in keys {
        let found = table_of(kind).and_then(|table| table.key(name));
        match found {
            Some(key) => kind = key.kind,
            None => return value,
        }
    }
    with_units(kind, value)
}

/// The same for the keys of a workshop sheet.
///
/// ```
/// let values = lanchester_file::si_sheet(serde_json::json!({ "rotor": { "mass": 12.0 } }));
/// assert_eq!(values, serde_json::json!({ "rotor": { "mass": "12 kg" } }));
/// ```
pub fn si_sheet(values: Value) -> Value {
    with_units(Kind::Table(&SHEET), values)
}

fn table_of(kind: Kind) -> Option<&'static Table> {
    match kind {
        Kind::Table(table) | Kind::Tables(table, _) | Kind::ValuesOrTables(table, _) => Some(table),
        _ => None,
    }
}

fn with_units(kind: Kind, value: Value) -> Value {
    match (kind, value) {
        (_, Value::Object(keys)) => {
            let Some(table) = table_of(kind) else { return Value::Object(keys) };
            let own = keys.into_iter().map(|(name, value)| {
                let value = match table.key(&name) {
                    Some(key) => with_units(key.kind, value),
                    None => value,
                };
                (name, value)
            });
            Value::Object(own.collect())
        }
        (_, Value::Array(list)) => list.into_iter().map(|value| with_units(kind, value)).collect(),
        (Kind::ValuesOrTables(table, _), value) => match table.keys.first() {
            Some(key) => with_units(key.kind, value),
            None => value,
        },
        (
            Kind::Quantity(dimension, _)
            | Kind::Quantities(dimension, _)
            | Kind::QuantityOrPair(dimension, _)
            | Kind::QuantityOrThree(dimension, _)
            | Kind::QuantityOrWord(dimension, _, _),
            Value::Number(number),
        ) if dimension != Dimension::Share => match number.as_f64() {
            Some(number) => Value::String(exact_text(number, dimension)),
            None => Value::Number(number),
        },
        (_, value) => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{file_entries, read, templates};
    use serde_json::json;

    #[test]
    fn numbers_get_the_unit_of_their_key_and_nothing_else_does() {
        let of = |value: Value| si_value("", value);
        let given = json!({
            "name": "A", "speed": [83.0, 628.0], "crank": { "stroke": 0.08 },
            "cylinder": [{ "piston": { "mass": 0.3 } }], "layout": { "cylinders": 3 }, "unknown": 3.5,
        });
        let found = of(given);
        assert_eq!(found["cylinder"][0]["piston"]["mass"], json!("0.3 kg"));
        assert_eq!(found["crank"]["stroke"], json!("80 mm"));
        assert_eq!((&found["layout"]["cylinders"], &found["unknown"]), (&json!(3), &json!(3.5)));
        let texts = found["speed"].as_array().unwrap();
        for (text, value) in texts.iter().zip([83.0, 628.0]) {
            let text = text.as_str().unwrap();
            assert_eq!(lanchester_units::parse(text, Dimension::Speed, "speed").unwrap(), value);
        }
        assert_eq!(si_value("cylinder[2].piston.mass", json!(0.25)), json!("0.25 kg"));
    }

    #[test]
    fn a_text_of_values_reads_as_the_file_that_they_come_from() {
        for template in templates() {
            let values = values_of(template.text);
            let text = values_text(&values);
            let (one, other) = (read(template.text), read(&text));
            assert_eq!(one.file, other.file, "{}\n{text}", template.name);
        }
    }

    /// The values of a text as a tree.
    fn values_of(text: &str) -> Map<String, Value> {
        let mut root = json!({});
        for entry in file_entries(text) {
            let mut here = &mut root;
            for step in entry.path.split('.') {
                let (key, index) = match step.split_once('[') {
                    Some((key, index)) => (key, index.trim_end_matches(']').parse::<usize>().ok()),
                    None => (step, None),
                };
                let key = key.trim_matches('"');
                here = &mut here[key];
                if let Some(index) = index {
                    if here.is_null() {
                        *here = json!([]);
                    }
                    let list = here.as_array_mut().unwrap();
                    while list.len() <= index {
                        list.push(json!({}));
                    }
                    here = &mut list[index];
                }
            }
            *here = entry.value;
        }
        root.as_object().cloned().unwrap()
    }
}
