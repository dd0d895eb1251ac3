//! Tables of typical values as text.

use lanchester_units::Dimension;

/// A table with its comment, and a comment behind every value.
pub(super) struct Block {
    header: String,
    comment: String,
    lines: Vec<(String, String)>,
}

impl Block {
    /// `header` in its brackets; `comment` says what the table is scaled from.
    pub(super) fn new(header: &str, comment: impl Into<String>) -> Block {
        Block { header: header.to_string(), comment: comment.into(), lines: Vec::new() }
    }

    /// A key with its value as TOML.
    pub(super) fn line(mut self, key: &str, value: impl AsRef<str>, comment: &str) -> Block {
        self.lines.push((format!("{key} = {}", value.as_ref()), comment.to_string()));
        self
    }

    pub(super) fn text(&self, end: &str) -> String {
        let mut out = String::new();
        if !self.comment.is_empty() {
            out += &format!("# Typical values: {}{end}", self.comment);
        }
        out += &format!("{}{end}", self.header);
        let width = self.lines.iter().map(|(line, _)| line.chars().count()).filter(|w| *w <= 48).max();
        for (line, comment) in &self.lines {
            match comment.is_empty() {
                true => out += &format!("{line}{end}"),
                false => out += &format!("{line:width$}  # {comment}{end}", width = width.unwrap_or(0)),
            }
        }
        out
    }
}

/// A number with at most `digits` significant digits, without zeros behind.
pub(super) fn number(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_string();
    }
    let size = value.abs().log10().floor() as i32;
    let places = digits - 1 - size;
    let unit = 10_f64.powi(places);
    let rounded = (value * unit).round() / unit;
    let text = format!("{rounded:.*}", places.max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => text,
    }
}

/// A quantity in quotes: the value in this unit of so many SI units, with `digits` significant digits.
pub(super) fn quantity(value: f64, unit: &str, size: f64, digits: i32) -> String {
    format!("\"{} {unit}\"", number(value / size, digits))
}

/// A length [m] in mm, to three digits but no finer than a tenth of a millimetre.
pub(super) fn mm(length: f64) -> String {
    let tenths = (length * 1e4).round() / 10.0;
    let text = match tenths.abs() >= 100.0 {
        true => format!("{:.0}", tenths.round()),
        false => format!("{tenths:.1}").trim_end_matches(".0").to_string(),
    };
    let text = if text == "-0" { "0".to_string() } else { text };
    format!("\"{text} mm\"")
}

/// The length [m] that [`mm`] writes.
pub(super) fn as_written(length: f64) -> f64 {
    let text = mm(length);
    lanchester_units::parse(text.trim_matches('"'), Dimension::Length, "length").unwrap_or(length)
}

/// A list of values that are TOML already.
pub(super) fn list(values: &[String]) -> String {
    format!("[{}]", values.join(", "))
}
