//! Rows as CSV (RFC 4180): numbers in the fewest digits that read back to the same value.

use crate::column::{Column, Rows, Values};
use std::fmt::Write as _;
use std::io::{self, Write};

/// A word, quoted where needed; an apostrophe stands before one that a spreadsheet would take for a formula (`csv_text` of the report
/// is the same rule).
fn push_word(line: &mut String, word: &str) {
    let is_formula = word.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let guard = if is_formula && !word.parse::<f64>().is_ok_and(f64::is_finite) { "'" } else { "" };
    if word.contains([',', '"', '\n', '\r']) {
        line.push('"');
        line.push_str(guard);
        line.push_str(&word.replace('"', "\"\""));
        line.push('"');
    } else {
        line.push_str(guard);
        line.push_str(word);
    }
}

/// The head.
pub(crate) fn write_head(sink: &mut impl Write, columns: &[Column]) -> io::Result<()> {
    let mut line = String::new();
    for (k, column) in columns.iter().enumerate() {
        line.push_str(if k > 0 { "," } else { "" });
        push_word(&mut line, &column.name);
    }
    line.push_str("\r\n");
    sink.write_all(line.as_bytes())
}

/// The rows.
pub(crate) fn write_rows(sink: &mut impl Write, rows: &Rows) -> io::Result<()> {
    let mut lines = String::with_capacity(32 * rows.len() * rows.columns().len());
    for row in 0..rows.len() {
        for (k, column) in rows.columns().iter().enumerate() {
            lines.push_str(if k > 0 { "," } else { "" });
            match column {
                Values::Whole(values) => {
                    let _ = write!(lines, "{}", values[row]);
                }
                // Nothing where there is no number.
                Values::Real(values) if values[row].is_finite() => {
                    // Adding 0 turns -0 into 0.
                    let _ = write!(lines, "{}", values[row] + 0.0);
                }
                Values::Real(_) => {}
                Values::Text(values) => push_word(&mut lines, &values[row]),
            }
        }
        lines.push_str("\r\n");
    }
    sink.write_all(lines.as_bytes())
}
