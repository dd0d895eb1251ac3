//! The text of an engine file: its lines, and values as they stand in them.

use lanchester_model::{Ratio, angle};
use lanchester_units::{Dimension, exact_text, neighbours, text_that};
use std::f64::consts::TAU;
use std::fmt::Write;

/// An engine file as it grows.
#[derive(Default)]
pub(super) struct File {
    pub(super) text: String,
}

impl File {
    pub(super) fn comment(&mut self, comment: &str) {
        self.line(&format!("# {comment}"));
    }

    pub(super) fn header(&mut self, header: &str, comment: &str) {
        self.line("");
        self.line(&if comment.is_empty() { header.to_string() } else { format!("{header}  # {comment}") });
    }

    pub(super) fn entry(&mut self, key: &str, value: &str) {
        self.line(&format!("{key} = {value}"));
    }

    pub(super) fn entry_with_comment(&mut self, key: &str, value: &str, comment: &str) {
        self.line(&format!("{key} = {value}  # {comment}"));
    }

    pub(super) fn entry_unless_zero(&mut self, key: &str, value: f64, dimension: Dimension) {
        if value != 0.0 {
            self.entry(key, &quantity(value, dimension));
        }
    }

    pub(super) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }
}

pub(crate) fn quantity(value: f64, dimension: Dimension) -> String {
    format!("\"{}\"", exact_text(value, dimension))
}

/// The angle from which the reader makes the same `direction`, counted from `zero`.
pub(super) fn turn_between(zero: f64, direction: f64) -> String {
    let fits = |turn: f64| angle::direction(zero + turn) == direction;
    // Sums of some pairs of doubles miss every other double: a turn less is finer.
    let turn = direction - zero;
    let guess = [turn, turn - TAU, turn + TAU]
        .into_iter()
        .find(|guess| neighbours(*guess).into_iter().any(fits))
        .unwrap_or(turn);
    format!("\"{}\"", text_that(guess, Dimension::Angle, fits))
}

pub(crate) fn ratio(ratio: Ratio) -> String {
    if ratio.denominator() == 1 { ratio.to_string() } else { format!("\"{ratio}\"") }
}

/// A TOML basic string.
pub(crate) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '\r' => out.push_str("\\r"),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
