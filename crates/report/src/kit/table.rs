//! A small table: columns with units, numbers aligned right, rendered as text, HTML or CSV.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::rounding;
use crate::kit::svg::escape;
use std::fmt::Write;

/// Most rows of a table that is not broken over two sheets of paper.
const SHORT: usize = 12;
/// Least rows of a table beside which there is no other on paper.
const LONG: usize = 40;

/// A table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Name for links: lower case, digits and hyphens.
    pub id: &'static str,
    /// Title; `F_x` means an index.
    pub title: String,
    /// How to read it; may be empty.
    pub note: String,
    /// What it leaves out, said below it in every form; may be empty.
    pub remark: String,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows, each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
}

/// Head of a column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// What it holds; `F_x` means an index.
    pub header: String,
    /// Unit, empty where there is none.
    pub unit: &'static str,
    /// Numbers stand right, words left.
    pub numeric: bool,
}

/// A cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A number in the unit of its column, with the decimals that it is printed with.
    Number {
        /// Value, unrounded.
        value: f64,
        /// Decimals in print.
        decimals: usize,
    },
    /// A formula: as plain text, and as MathML for pages.
    Formula {
        /// In the terminal and in CSV.
        text: String,
        /// One MathML element, its names escaped.
        mathml: String,
    },
    /// Nothing to say.
    Empty,
}

impl Column {
    /// A column of words.
    pub fn words(header: impl Into<String>) -> Column {
        Column { header: header.into(), unit: "", numeric: false }
    }

    /// A column of numbers.
    pub fn numbers(header: impl Into<String>, unit: &'static str) -> Column {
        Column { header: header.into(), unit, numeric: true }
    }
}

/// Cells of one column, all with the decimals that give the largest of them `significant` digits; what is below
/// `noise` ([`rounding::below`] of the largest of their kind) is 0.
pub fn column_cells(values: impl IntoIterator<Item = f64>, significant: i32, noise: f64) -> Vec<Cell> {
    let values: Vec<f64> = values.into_iter().map(|v| rounding::clean(v, noise)).collect();
    let largest = values.iter().filter(|v| v.is_finite()).fold(0.0f64, |m, v| m.max(v.abs()));
    let decimals = number::decimals(largest, significant);
    values.into_iter().map(|value| Cell::Number { value, decimals }).collect()
}

/// Cells of a column that is a kind of its own, as [`column_cells`].
pub(crate) fn own_cells(values: impl IntoIterator<Item = f64>, significant: i32) -> Vec<Cell> {
    let values: Vec<f64> = values.into_iter().collect();
    let noise = rounding::among(values.iter().copied());
    column_cells(values, significant, noise)
}

/// A whole column of words.
pub(crate) fn words(header: &str, cells: impl Iterator<Item = String>) -> (Column, Vec<Cell>) {
    (Column::words(header), cells.map(Cell::Text).collect())
}

/// A whole column of numbers, as [`own_cells`].
pub(crate) fn numbers(
    header: &str,
    unit: &'static str,
    values: impl Iterator<Item = f64>,
    significant: i32,
) -> (Column, Vec<Cell>) {
    (Column::numbers(header, unit), own_cells(values, significant))
}

impl Cell {
    /// Words.
    pub fn text(text: impl Into<String>) -> Cell {
        Cell::Text(text.into())
    }

    /// A number with its own decimals: `significant` digits.
    pub fn number(value: f64, significant: i32) -> Cell {
        Cell::Number { value, decimals: number::decimals(value.abs(), significant) }
    }

    fn terminal(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            Cell::Number { value, decimals } => number::terminal(*value, *decimals),
            Cell::Formula { text, .. } => text.clone(),
            Cell::Empty => String::new(),
        }
    }
}

impl Table {
    /// A table from whole columns of cells, all of one length.
    pub fn of_columns(
        id: &'static str,
        title: impl Into<String>,
        note: impl Into<String>,
        columns: Vec<(Column, Vec<Cell>)>,
    ) -> Table {
        let count = columns.iter().map(|(_, cells)| cells.len()).min().unwrap_or(0);
        let mut rows: Vec<Vec<Cell>> = (0..count).map(|_| Vec::with_capacity(columns.len())).collect();
        let mut heads = Vec::with_capacity(columns.len());
        for (head, cells) in columns {
            heads.push(head);
            for (row, cell) in rows.iter_mut().zip(cells) {
                row.push(cell);
            }
        }
        Table { id, title: title.into(), note: note.into(), remark: String::new(), columns: heads, rows }
    }

    /// Leaves out the rows `keys` and says so.
    pub(crate) fn without(mut self, keys: &[usize], remark: String) -> Table {
        let mut index = 0;
        self.rows.retain(|_| {
            index += 1;
            !keys.contains(&(index - 1))
        });
        self.remark = remark;
        self
    }

    /// Aligned plain text for a terminal.
    pub fn text(&self) -> String {
        let heads: Vec<[&str; 2]> = self.columns.iter().map(|c| [c.header.as_str(), c.unit]).collect();
        let cells: Vec<Vec<String>> =
            self.rows.iter().map(|r| r.iter().map(Cell::terminal).collect()).collect();
        let widths: Vec<usize> = (0..self.columns.len())
            .map(|k| {
                let head = heads[k][0].chars().count().max(if heads[k][1].is_empty() {
                    0
                } else {
                    heads[k][1].chars().count() + 2
                });
                cells.iter().map(|r| r[k].chars().count()).fold(head, usize::max)
            })
            .collect();
        let mut out = String::with_capacity(128 * (self.rows.len() + 4));
        out.push_str(&self.title);
        out.push('\n');
        if self.rows.is_empty() {
            let _ = writeln!(out, "  {}", self.remark);
            return out;
        }
        let line = |out: &mut String, cell: &dyn Fn(usize) -> String| {
            let start = out.len();
            for (k, column) in self.columns.iter().enumerate() {
                let (text, width) = (cell(k), widths[k]);
                out.push_str("  ");
                let _ = if column.numeric {
                    write!(out, "{text:>width$}")
                } else {
                    write!(out, "{text:<width$}")
                };
            }
            let end = start + out[start..].trim_end().len();
            out.truncate(end);
            out.push('\n');
        };
        line(&mut out, &|k| heads[k][0].to_owned());
        if heads.iter().any(|h| !h[1].is_empty()) {
            line(&mut out, &|k| {
                if heads[k][1].is_empty() { String::new() } else { format!("[{}]", heads[k][1]) }
            });
        }
        line(&mut out, &|k| "-".repeat(widths[k]));
        for row in &cells {
            line(&mut out, &|k| row[k].clone());
        }
        if !self.remark.is_empty() {
            let _ = writeln!(out, "  {}", self.remark);
        }
        out
    }

    /// The same with its note below it.
    pub(crate) fn noted_text(&self) -> String {
        let mut out = self.text();
        push_wrapped(&mut out, "  ", &self.note);
        out
    }

    /// HTML; a wide table scrolls inside its own box.
    pub fn html(&self) -> String {
        let mut out = String::with_capacity(256 * (self.rows.len() + 2));
        let wide = if self.columns.len() > 7 { " wide" } else { "" };
        // On paper a short table stays together, and a long one has no other beside it.
        let length = match self.rows.len() {
            0..=SHORT => " short",
            rows if rows >= LONG => " long",
            _ => "",
        };
        let _ = write!(out, "<figure class=\"table{wide}{length}\" id=\"{}\">\n<figcaption><b>", self.id);
        push_rich(&mut out, &self.title);
        out.push_str("</b>");
        if !self.note.is_empty() {
            out.push(' ');
            push_rich(&mut out, &self.note);
        }
        if !self.remark.is_empty() {
            out.push(' ');
            push_rich(&mut out, &self.remark);
        }
        out.push_str("</figcaption>\n");
        if self.rows.is_empty() {
            out.push_str("</figure>\n");
            return out;
        }
        out.push_str("<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>");
        for column in &self.columns {
            out.push_str(if column.numeric {
                "<th scope=\"col\" class=\"n\">"
            } else {
                "<th scope=\"col\">"
            });
            push_rich(&mut out, &column.header);
            if !column.unit.is_empty() {
                let _ = write!(out, " <span class=\"unit\">{}</span>", column.unit.replace(' ', "\u{a0}"));
            }
            out.push_str("</th>");
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            out.push_str("<tr>");
            for (k, (cell, column)) in row.iter().zip(&self.columns).enumerate() {
                let (open, close) = match (k, column.numeric) {
                    (0, false) => ("<th scope=\"row\">", "</th>"),
                    (0, true) => ("<th scope=\"row\" class=\"n\">", "</th>"),
                    (_, false) => ("<td>", "</td>"),
                    (_, true) => ("<td class=\"n\">", "</td>"),
                };
                out.push_str(open);
                match cell {
                    Cell::Text(text) if k == 0 => push_rich(&mut out, text),
                    Cell::Text(text) => out.push_str(&escape(text)),
                    Cell::Number { value, decimals } => out.push_str(&number::fixed(*value, *decimals)),
                    Cell::Formula { mathml, .. } => out.push_str(mathml),
                    Cell::Empty => {}
                }
                out.push_str(close);
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div>\n</figure>\n");
        out
    }

    /// CSV (RFC 4180) with unrounded numbers; the unit stands in the head in brackets.
    pub fn csv(&self) -> String {
        let mut out = String::with_capacity(64 * (self.rows.len() + 1));
        let heads = self
            .columns
            .iter()
            .map(|c| if c.unit.is_empty() { c.header.clone() } else { format!("{} [{}]", c.header, c.unit) });
        push_csv_line(&mut out, heads);
        for row in &self.rows {
            push_csv_line(
                &mut out,
                row.iter().map(|cell| match cell {
                    Cell::Text(text) => text.clone(),
                    Cell::Number { value, .. } => csv_number(*value),
                    Cell::Formula { text, .. } => text.clone(),
                    Cell::Empty => String::new(),
                }),
            );
        }
        out
    }
}

/// A number for CSV: shortest text that reads back to the same value; empty where it is not finite.
pub(crate) fn csv_number(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    let value = if value == 0.0 { 0.0 } else { value };
    let text = format!("{value:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// One line of CSV, quoted where needed.
pub(crate) fn push_csv_line(out: &mut String, fields: impl IntoIterator<Item = String>) {
    for (k, field) in fields.into_iter().enumerate() {
        if k > 0 {
            out.push(',');
        }
        out.push_str(&csv_text(&field));
    }
    out.push_str("\r\n");
}

/// A word for CSV, quoted where needed. One that a spreadsheet would take for a formula gets an apostrophe before it; a number does not.
pub fn csv_text(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let is_number = text.parse::<f64>().is_ok_and(f64::is_finite);
    let guard = if is_formula && !is_number { "'" } else { "" };
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{guard}{}\"", text.replace('"', "\"\""))
    } else {
        format!("{guard}{text}")
    }
}

/// Escaped text with `F_x` as an index.
pub(crate) fn push_rich(out: &mut String, text: &str) {
    let mut rest = text;
    while let Some(at) = rest.find('_') {
        let index = rest[at + 1..].chars().next().filter(|c| c.is_alphanumeric());
        let Some(index) = index else { break };
        out.push_str(&escape(&rest[..at]));
        out.push_str("<sub>");
        out.push(index);
        out.push_str("</sub>");
        rest = &rest[at + 1 + index.len_utf8()..];
    }
    out.push_str(&escape(rest));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Table {
        Table::of_columns(
            "sample",
            "Sample F_x",
            "",
            vec![
                (Column::words("who"), vec![Cell::text("a, b"), Cell::text("<c>")]),
                (Column::numbers("force", "N"), own_cells([12345.678, -1e-13], 5)),
            ],
        )
    }

    #[test]
    fn snap_text() {
        // Groups of digits stand apart by a space at which no line breaks.
        insta::assert_snapshot!(sample().text().replace(number::NO_BREAK, "_"), @r"
        Sample F_x
          who    force
                   [N]
          ----  ------
          a, b  12_346
          <c>        0
        ");
    }

    #[test]
    fn csv_quotes_and_keeps_every_digit() {
        assert_eq!(sample().csv(), "who,force [N]\r\n\"a, b\",12345.678\r\n<c>,0\r\n");
        assert_eq!(csv_number(-0.0), "0");
        assert_eq!(csv_number(f64::NAN), "");
        assert_eq!(csv_number(1e-17), "1e-17");
    }

    #[test]
    fn no_word_of_csv_is_a_formula_and_numbers_stay_numbers() {
        let formula = "=HYPERLINK(\"http://evil.example\",\"a\")";
        assert_eq!(csv_text(formula), "\"'=HYPERLINK(\"\"http://evil.example\"\",\"\"a\"\")\"");
        for (word, guarded) in [
            ("+1 -1", "'+1 -1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("-cmd", "'-cmd"),
            ("\t=1", "'\t=1"),
            ("-1.5", "-1.5"),
            ("+2e-3", "+2e-3"),
            ("-inf", "'-inf"),
            ("web 1=2", "web 1=2"),
            ("", ""),
        ] {
            assert_eq!(csv_text(word), guarded);
        }
    }

    #[test]
    fn html_escapes() {
        let html = sample().html();
        assert!(
            html.contains("&lt;c&gt;") && html.contains("F<sub>x</sub>") && html.contains("12\u{202f}346"),
            "{html}"
        );
    }
}
