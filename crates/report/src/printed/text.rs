//! Texts of reports: sentences with tables between them.

use super::layout::{converted_table, table_at};
use super::sentence::sentence;

/// A text of a report in units of the United States: sentences and tables. Every number keeps the digits that it has.
pub fn text_in_us_units(text: &str) -> String {
    let lines: Vec<&str> = text.split('\n').collect();
    let mut out: Vec<String> = Vec::with_capacity(lines.len());
    let (mut sentences, mut line) = (Vec::new(), 0);
    let tell = |sentences: &mut Vec<&str>, out: &mut Vec<String>| {
        if !sentences.is_empty() {
            out.push(sentence(&sentences.join("\n")));
            sentences.clear();
        }
    };
    while line < lines.len() {
        match table_at(&lines[line..]) {
            Some(table) => {
                tell(&mut sentences, &mut out);
                line += table.lines;
                out.extend(converted_table(&table));
            }
            None => {
                sentences.push(lines[line]);
                line += 1;
            }
        }
    }
    tell(&mut sentences, &mut out);
    out.join("\n")
}
