//! A description as the text of a graph file.

use crate::description::{Description, Entry, Text};
use std::fmt::Write;

/// The graph file of a description: reading it gives the description again.
pub fn graph_file(description: &Description) -> String {
    let mut out = format!("name = {}\n", quoted(&description.name));
    part(&mut out, "parameters", &description.parameters);
    for (name, curve) in &description.tables {
        let (pieces, end) = curve.pieces();
        let [x, y] = curve.units().map(|unit| quoted(&unit.base_text()));
        let _ = writeln!(out, "\n[tables.{}]", key(&name.text));
        let _ = writeln!(
            out,
            "x_unit = {x}\ny_unit = {y}\nperiodic = {}\nend = {end:?}\npieces = [",
            curve.is_periodic()
        );
        for (start, [a, b, c, d]) in pieces {
            let _ = writeln!(out, "    [{start:?}, {a:?}, {b:?}, {c:?}, {d:?}],");
        }
        out += "]\n";
    }
    for (title, entries) in [("elements", &description.elements), ("signals", &description.signals)] {
        if title == "elements" || !entries.is_empty() {
            let _ = writeln!(out, "\n[{title}]");
        }
        for entry in entries {
            let _ = writeln!(out, "{} = {}", key(&entry.name.text), inline(entry));
        }
    }
    let _ = writeln!(out, "\n[bonds]\nlist = [");
    for bond in &description.bonds {
        let _ = writeln!(out, "    {},", quoted(&bond.text));
    }
    out += "]\n";
    if !description.relax.is_empty() {
        out += "\n[relax]\n";
    }
    for entry in &description.relax {
        let _ = writeln!(out, "{} = {}", key(&entry.name.text), inline(entry));
    }
    for event in &description.events {
        let set: Vec<String> = event
            .set
            .iter()
            .map(|(state, value)| format!("{} = {}", key(&state.text), quoted(&value.text)))
            .collect();
        let _ = writeln!(out, "\n[[event]]\nwhen = {}", quoted(&event.when.text));
        if !set.is_empty() {
            let _ = writeln!(out, "set = {{ {} }}", set.join(", "));
        }
        if event.stop {
            out += "stop = true\n";
        }
    }
    part(&mut out, "simulation", &description.simulation);
    out
}

fn part(out: &mut String, title: &str, keys: &[(Text, Text)]) {
    if !keys.is_empty() {
        let _ = writeln!(out, "\n[{title}]");
    }
    for (name, value) in keys {
        let _ = writeln!(out, "{} = {}", key(&name.text), quoted(&value.text));
    }
}

fn inline(entry: &Entry) -> String {
    let keys: Vec<String> = entry
        .keys
        .iter()
        .map(|(name, value)| format!("{} = {}", key(&name.text), value_of(name, value)))
        .collect();
    format!("{{ {} }}", keys.join(", "))
}

/// A matrix is written as rows of texts, everything else as one text.
fn value_of(name: &Text, value: &Text) -> String {
    if name.text != "matrix" {
        return quoted(&value.text);
    }
    let row = |row: &str| {
        let entries: Vec<String> = row.split(';').map(|entry| quoted(entry.trim())).collect();
        format!("[{}]", entries.join(", "))
    };
    let rows: Vec<String> = value.text.split('|').map(row).collect();
    format!("[{}]", rows.join(", "))
}

/// A key, in quotes where a bare one would not do.
fn key(name: &str) -> String {
    let bare = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if bare { name.to_owned() } else { quoted(name) }
}

fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out += "\\\"",
            '\\' => out += "\\\\",
            c if (c as u32) < 0x20 || c as u32 == 0x7f => {
                let _ = write!(out, "\\u{:04X}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
