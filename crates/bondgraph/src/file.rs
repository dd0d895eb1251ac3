//! The graph file: TOML text to a description.

use crate::curve::Curve;
use crate::description::{Description, Entry, Happening, Text, Use};
use crate::mistake::Mistakes;
use crate::unit::Unit;
use std::cell::RefCell;
use std::ops::Range;
use toml_spanner::{Item, Table, Value};

/// Bytes of the longest file that is read.
const LONGEST: usize = 1024 * 1024;

/// Whether a TOML text is a graph file: it has a table of elements.
pub fn is_graph_file(text: &str) -> bool {
    text.lines().any(|line| {
        let line = line.trim();
        matches!(line, "[elements]" | "[bonds]" | "[[use]]")
            || line.starts_with("[elements.")
            || line.starts_with("elements ")
    })
}

/// Gives the text of another file by its name.
pub(crate) type LookUp<'a> = &'a dyn Fn(&str) -> Option<String>;

/// Reads the text; mistakes of form are noted, what can be read is. `look_up` gives the files of its tables.
pub(crate) fn read(text: &str, look_up: LookUp<'_>, mistakes: &mut Mistakes) -> Description {
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
            ("tables", Value::Table(table)) => description.tables = curves(table, look_up, mistakes),
            ("use", Value::Array(list)) => description.uses = list.iter().filter_map(|item| used(item, mistakes)).collect(),
            ("relax", Value::Table(table)) => description.relax = entries(table, mistakes),
            ("event", Value::Array(list)) => {
                description.events = list.iter().filter_map(|item| happening(item, mistakes)).collect();
            }
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
            ("name" | "parameters" | "elements" | "signals" | "simulation" | "tables" | "use" | "event" | "relax" | "bonds", _) => {
                mistakes.push(
                    "E1701",
                    &place,
                    format!("`{}` has a value of another kind", key.name),
                    if key.name == "name" { "name is a text" } else { "write it as a table" },
                )
            }
            (other, _) => mistakes.push(
                "E1702",
                &place,
                format!("a graph file has no `{other}`"),
                "it has name, note, [parameters], [tables], [[use]], [elements], [signals], [bonds], [relax], [[event]] and [simulation]",
            ),
        }
    }
    description
}

fn span(item: &Item<'_>) -> Range<usize> {
    item.span().range()
}

/// Names of the graphs that a file uses, and of the files of its tables.
pub fn used_graphs(text: &str) -> Vec<String> {
    let asked = RefCell::new(Vec::new());
    let look_up = |name: &str| {
        asked.borrow_mut().push(name.to_owned());
        None
    };
    let description = read(text, &look_up, &mut Mistakes::default());
    description.uses.into_iter().map(|used| used.graph.text).chain(asked.into_inner()).collect()
}

/// One `[[use]]`: `graph`, `as` and `parameters`.
fn used(item: &Item<'_>, mistakes: &mut Mistakes) -> Option<Use> {
    let hint = "write graph = \"spring.toml\" and as = \"left\", and parameters = { k = \"2 N/m\" } where they differ";
    let place = span(item);
    let Some(table) = item.as_table() else {
        mistakes.push("E1701", &place, "[[use]] needs a table", hint);
        return None;
    };
    let mut found = Use::default();
    for (key, item) in table {
        let text = item.as_str().map(|text| Text { text: text.to_owned(), span: span(item) });
        match (key.name, text, item.as_table()) {
            ("graph", Some(text), _) => found.graph = text,
            ("as", Some(text), _) => found.prefix = text,
            ("parameters", _, Some(table)) => found.parameters = texts(table, mistakes),
            _ => mistakes.push(
                "E1702",
                &span(item),
                format!("[[use]] has no `{}` of this form", key.name),
                hint,
            ),
        }
    }
    if found.graph.text.is_empty() || found.prefix.text.is_empty() {
        mistakes.push("E1709", &place, "[[use]] needs a graph and the prefix of its names", hint);
        return None;
    }
    Some(found)
}

/// One `[[event]]`: `when` and `set` or `stop`.
fn happening(item: &Item<'_>, mistakes: &mut Mistakes) -> Option<Happening> {
    let hint = "write when = \"-height\" and set = { \"ball.momentum\" = \"-0.8*ball.momentum\" }";
    let place = span(item);
    let Some(table) = item.as_table() else {
        mistakes.push("E1701", &place, "[[event]] needs a table", hint);
        return None;
    };
    let mut found = Happening::default();
    for (key, item) in table {
        match (key.name, item.as_str(), item.as_table()) {
            ("when", Some(text), _) => found.when = Text { text: text.to_owned(), span: span(item) },
            ("set", _, Some(table)) => found.set = texts(table, mistakes),
            ("stop", ..) if item.as_bool().is_some() => found.stop = item.as_bool() == Some(true),
            _ => {
                let message = format!("[[event]] has no `{}` of this form", key.name);
                mistakes.push("E1702", &span(item), message, hint);
            }
        }
    }
    if found.when.text.is_empty() || (found.set.is_empty() && !found.stop) {
        mistakes.push(
            "E1709",
            &place,
            "[[event]] needs a quantity that rises through zero, and what it sets or `stop = true`",
            hint,
        );
        return None;
    }
    Some(found)
}

/// Tables: straight lines through `points`, which may stand in a `file` of their own, or `pieces` of cubics up to `end`.
fn curves(table: &Table<'_>, look_up: LookUp<'_>, mistakes: &mut Mistakes) -> Vec<(Text, Curve)> {
    let mut found = Vec::new();
    for (key, item) in table {
        let name = Text { text: key.name.to_owned(), span: key.span.range() };
        let Some(table) = item.as_table() else {
            let message = format!("table `{}` needs points or pieces", key.name);
            mistakes.push("E1701", &span(item), message, "for example { points = [[0, 0], [1, 2]] }");
            continue;
        };
        let (mut rows, mut cubic, mut end, mut periodic) = (None, false, None, false);
        let mut units = [Unit::NONE; 2];
        for (key, item) in table {
            let unit = item.as_str().and_then(Unit::of_text);
            let good = match (key.name, item.value()) {
                ("file", Value::String(_)) => {
                    let file = item.as_str().unwrap_or_default();
                    let content = look_up(file);
                    rows = content.as_deref().and_then(two_columns);
                    if rows.is_none() {
                        let message = match content {
                            None => format!("there is no file `{file}`"),
                            Some(_) => format!("`{file}` is no table of two columns of numbers"),
                        };
                        let hint = "give its place from the folder of this file; every line is x,y, a line of names may be the first";
                        mistakes.push("E1702", &span(item), message, hint);
                        continue;
                    }
                    true
                }
                ("points", Value::Array(_)) => {
                    rows = numbers(item, 2);
                    rows.is_some()
                }
                ("pieces", Value::Array(_)) => {
                    (rows, cubic) = (numbers(item, 5), true);
                    rows.is_some()
                }
                ("end", _) => {
                    end = item.as_f64();
                    end.is_some()
                }
                ("periodic", Value::Boolean(value)) => {
                    periodic = *value;
                    true
                }
                ("x_unit" | "y_unit", _) => {
                    units[usize::from(key.name == "y_unit")] = unit.unwrap_or_default();
                    unit.is_some()
                }
                _ => false,
            };
            if !good {
                let message = format!("table `{}` has no `{}` of this form", name.text, key.name);
                let hint = "it has points = [[x, y], ...], file = \"points.csv\" or pieces = [[start, c0, c1, c2, c3], ...] with end, \
                            periodic = true, x_unit and y_unit as SI units";
                mistakes.push("E1702", &span(item), message, hint);
            }
        }
        let curve = rows.and_then(|rows: Vec<Vec<f64>>| match (cubic, end) {
            (true, Some(end)) => {
                let pieces: Vec<(f64, [f64; 4])> =
                    rows.iter().map(|row| (row[0], [row[1], row[2], row[3], row[4]])).collect();
                Curve::cubics(&pieces, end, periodic, units)
            }
            (true, None) => None,
            (false, _) => {
                let points: Vec<[f64; 2]> = rows.iter().map(|row| [row[0], row[1]]).collect();
                Curve::straight(&points, periodic, units)
            }
        });
        match curve {
            Some(curve) => found.push((name, curve)),
            None => mistakes.push(
                "E1709",
                &span(item),
                format!("table `{}` is no function", name.text),
                "give points or pieces whose x rise, pieces with their end, all numbers finite",
            ),
        }
    }
    found
}

/// Lines `x,y`; commas, semicolons or tabs part them, a first line of names and lines that begin with # are passed over.
fn two_columns(text: &str) -> Option<Vec<Vec<f64>>> {
    let mut rows = Vec::new();
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    for (index, line) in lines.enumerate() {
        let row: Result<Vec<f64>, _> = line.split([',', ';', '\t']).map(|part| part.trim().parse()).collect();
        match row {
            Ok(row) if row.len() == 2 => rows.push(row),
            Err(_) if index == 0 => {}
            _ => return None,
        }
    }
    Some(rows)
}

/// Rows of so many finite numbers.
fn numbers(item: &Item<'_>, count: usize) -> Option<Vec<Vec<f64>>> {
    let row = |item: &Item<'_>| -> Option<Vec<f64>> {
        let row: Option<Vec<f64>> = item.as_array()?.iter().map(Item::as_f64).collect();
        row.filter(|row| row.len() == count)
    };
    item.as_array()?.iter().map(row).collect()
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
