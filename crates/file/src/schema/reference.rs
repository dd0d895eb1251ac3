//! The reference of the engine file for the book.

use super::{Bound, FILE, Key, Kind, Need, Table};
use crate::codes::{diagnostic_codes, diagnostic_families};
use crate::workshop::SHEET;
use lanchester_units::{Dimension, one_of};

/// Reference of the engine file as Markdown: every table, every key, every unit, every diagnostic.
pub fn reference_markdown() -> String {
    let mut out = tables(&FILE);
    out += "## Units\n\n| quantity | units |\n|---|---|\n";
    for dimension in Dimension::ALL {
        let units: Vec<String> = dimension.units().map(|unit| format!("`{}`", unit.name)).collect();
        out += &format!("| {} | {} |\n", dimension.name(), units.join(", "));
    }
    out += "\n## Diagnostics\n\nE is an error, W a warning. The first two digits name the family:\n\n| digits | family |\n|---|---|\n";
    for (digits, family) in diagnostic_families() {
        out += &format!("| {digits} | {family} |\n");
    }
    out += "\n| code | says |\n|---|---|\n";
    for (code, meaning) in diagnostic_codes() {
        out += &format!("| {code} | {meaning} |\n");
    }
    out
}

/// Reference of the workshop sheet as Markdown: every table and every key.
pub fn sheet_reference_markdown() -> String {
    tables(&SHEET)
}

fn tables(file: &'static Table) -> String {
    let mut out = String::new();
    for table in file.all() {
        let title = if table.header.is_empty() { "The file".into() } else { format!("`{}`", table.header) };
        out += &format!("## {title}\n\n{}\n\n", table.doc);
        out += "| key | holds | meaning | example |\n|---|---|---|---|\n";
        for key in table.keys {
            let need = if key.need == Need::Required { " (required)" } else { "" };
            out += &format!(
                "| `{}`{need} | {} | {} | `{}` |\n",
                key.name,
                holds(key.kind),
                meaning(key),
                key.example.replace('|', "\\|")
            );
        }
        out += "\n";
    }
    out
}

fn holds(kind: Kind) -> String {
    let bounded = |dimension: Dimension, bound| match bound {
        Bound::Any => dimension.name().to_string(),
        Bound::NotNegative => format!("{}, not negative", dimension.name()),
        Bound::Positive => format!("{}, positive", dimension.name()),
    };
    match kind {
        Kind::Flag => "`true` or `false`".into(),
        Kind::Text(most) => format!("text of at most {most} characters"),
        Kind::Whole(least, most) => format!("whole number from {least} to {most}"),
        Kind::Wholes(least, most) => format!("list of whole numbers from {least} to {most}"),
        Kind::WholeChoice(choices) => {
            let names: Vec<String> = choices.iter().map(|choice| format!("`{choice}`")).collect();
            one_of(names.iter().map(String::as_str))
        }
        Kind::Choice(words) => {
            let names: Vec<String> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
            one_of(names.iter().map(String::as_str))
        }
        Kind::Quantity(dimension, bound) => bounded(dimension, bound),
        Kind::Quantities(dimension, bound) => format!("list: {}", bounded(dimension, bound)),
        Kind::QuantityOrPair(dimension, bound) => format!("{}; one or two", bounded(dimension, bound)),
        Kind::QuantityOrThree(dimension, bound) => format!("{}; one or three", bounded(dimension, bound)),
        Kind::QuantityOrWord(dimension, bound, word) => {
            format!("{}, or `\"{word}\"`", bounded(dimension, bound))
        }
        Kind::Share => "share, or a bare fraction".into(),
        Kind::ShareOrPair => "share, or a bare fraction; one or two".into(),
        Kind::ShareOrThree => "share, or a bare fraction; one or three".into(),
        Kind::Direction => "list of three numbers".into(),
        Kind::Number(bound) => match bound {
            Bound::Any => "number".into(),
            Bound::NotNegative => "number, not negative".into(),
            Bound::Positive => "number, positive".into(),
        },
        Kind::Truth => "`true` or `false`".into(),
        Kind::Stages => "list of criteria".into(),
        Kind::Amounts => "mass or unbalance; one or a list".into(),
        Kind::Orders => "list of criteria, one order each".into(),
        Kind::Durabilities => "list of films and safeties".into(),
        Kind::AtLeast => "table of films and safeties".into(),
        Kind::Limits | Kind::GiveUps => "table of criteria".into(),
        Kind::Order => "number, not negative, or a fraction as text".into(),
        Kind::Ratio => "whole number, or a fraction as text".into(),
        Kind::Table(table) => format!("table `{}`", table.header),
        Kind::ValuesOrTables(table, most) => {
            let value = table.keys.first().map_or_else(String::new, |key| holds(key.kind));
            format!("list: {value}; or tables `{}`; at most {most}", table.header)
        }
        Kind::Tables(table, most) => format!("tables `{}`, at most {most}", table.header),
    }
}

fn meaning(key: &Key) -> String {
    if key.layouts.is_empty() {
        key.doc.to_string()
    } else {
        format!("{} For {}.", key.doc, one_of(key.layouts.iter().copied()).replace(" or ", " and "))
    }
}
