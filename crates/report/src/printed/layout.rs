//! Tables of a text: found by the line of dashes that every table has, their quantities converted, set anew.

use super::sentence::{Printed, number_at, sentence};
use crate::kit::number::{decimals, terminal};
use crate::kit::us_unit::{Us, us};

/// A table in a text.
pub(super) struct SetTable<'a> {
    /// Its lines in the text.
    pub lines: usize,
    /// Lines above the dashes, and rows, cell by cell.
    heads: Vec<Vec<&'a str>>,
    rows: Vec<Vec<&'a str>>,
    /// Whether the column stands right.
    right: Vec<bool>,
}

/// A column: from and to which letter it goes.
type Span = (usize, usize);

/// The table that begins with the first of `lines`, heads first.
pub(super) fn table_at<'a>(lines: &[&'a str]) -> Option<SetTable<'a>> {
    let dashes = (1..=2).find(|&k| lines.get(k).is_some_and(|line| spans(line).is_some()))?;
    // Two lines of heads only where the second is one of units; the title above is no head.
    let spans = spans(lines[dashes])?;
    let heads: Vec<Vec<&str>> =
        lines[..dashes].iter().map(|line| cells(line, &spans)).collect::<Option<_>>()?;
    if dashes == 2
        && !heads[1].iter().all(|cell| cell.is_empty() || cell.starts_with('[') && cell.ends_with(']'))
    {
        return None;
    }
    let rows: Vec<Vec<&str>> = lines[dashes + 1..]
        .iter()
        .take_while(|line| !line.trim().is_empty())
        .map_while(|line| cells(line, &spans))
        .collect();
    let stands_right = |k: usize| {
        let (mut left, mut right) = (true, true);
        for line in &lines[..=dashes + rows.len()] {
            let letters: Vec<char> = line.chars().collect();
            let (from, to) = spans[k];
            let first = letters.get(from).copied().unwrap_or(' ');
            let last = letters.get(to - 1).copied().unwrap_or(' ');
            let empty = letters.iter().skip(from).take(to - from).all(|letter| *letter == ' ');
            left &= empty || first != ' ';
            right &= empty || last != ' ';
        }
        right && (!left || rows.iter().all(|row| row[k].is_empty() || is_number(row[k])))
    };
    let right = (0..spans.len()).map(stands_right).collect();
    Some(SetTable { lines: dashes + 1 + rows.len(), heads, rows, right })
}

/// Columns of a line of dashes, as a table of a text has it: two spaces before each.
fn spans(line: &str) -> Option<Vec<Span>> {
    let body = line.strip_prefix("  ").filter(|body| body.starts_with('-'))?;
    let mut spans = Vec::new();
    let mut from = 2;
    for dashes in body.split("  ") {
        if dashes.is_empty() || !dashes.bytes().all(|b| b == b'-') {
            return None;
        }
        spans.push((from, from + dashes.len()));
        from += dashes.len() + 2;
    }
    Some(spans)
}

/// The cells of a line; none where letters stand between the columns: such a line is a sentence.
fn cells<'a>(line: &'a str, spans: &[Span]) -> Option<Vec<&'a str>> {
    let places: Vec<usize> = line.char_indices().map(|(at, _)| at).chain([line.len()]).collect();
    let count = places.len() - 1;
    let part = |from: usize, to: usize| &line[places[from.min(count)]..places[to.min(count)]];
    let mut end = 0;
    let mut found = Vec::with_capacity(spans.len());
    for &(from, to) in spans {
        if !part(end, from).trim().is_empty() {
            return None;
        }
        found.push(part(from, to).trim_matches(' '));
        end = to;
    }
    part(end, count).trim().is_empty().then_some(found)
}

fn is_number(cell: &str) -> bool {
    parsed(cell).is_some() || cell == "-"
}

fn parsed(cell: &str) -> Option<Printed> {
    number_at(cell, 0).filter(|number| number.to == cell.len())
}

/// The unit in brackets at the end of a head or of the name of a row.
fn bracketed(cell: &str) -> Option<(&str, &str)> {
    let (name, unit) = cell.strip_suffix(']')?.rsplit_once('[')?;
    Some((name, unit))
}

/// A head with its unit converted.
fn head(cell: &str) -> String {
    match bracketed(cell).and_then(|(name, unit)| Some((name, us(unit)?))) {
        Some((name, us)) => format!("{name}[{}]", us.unit),
        None => cell.to_owned(),
    }
}

/// The columns' own units, and those of the rows: from a column of units, or at the end of the rows' names.
struct Units {
    columns: Vec<Option<String>>,
    rows: Vec<Option<Us>>,
    /// The column of units.
    place: Option<usize>,
    /// Columns whose unit stands in a column of its own behind them: prices.
    apart: Vec<bool>,
}

/// Units of a table from its heads and rows.
fn units(heads: &[Vec<&str>], rows: &[Vec<&str>]) -> Units {
    let count = heads.first().map_or(0, Vec::len);
    let own = |k: usize| heads.iter().find_map(|line| bracketed(line[k])).map(|(_, unit)| unit.to_owned());
    let columns: Vec<Option<String>> = (0..count).map(own).collect();
    let place = (0..count).find(|&k| heads[0][k] == "unit");
    let apart =
        (0..count).map(|k| heads[0].get(k + 1).is_some_and(|next| next.starts_with("unit of"))).collect();
    let of_row = |row: &Vec<&str>| match place {
        Some(place) => us(row[place]),
        None => bracketed(row[0]).and_then(|(_, unit)| us(unit)),
    };
    Units { columns, rows: rows.iter().map(of_row).collect(), place, apart }
}

impl Units {
    /// The unit by which a cell is converted.
    fn of(&self, row: usize, column: usize) -> Option<Us> {
        match &self.columns[column] {
            Some(unit) => us(unit),
            None if self.apart[column] => None,
            None => self.rows[row],
        }
    }
}

/// Rows of cells with every quantity converted; `exact` says how a number is written that is converted, with the digits
/// that its column or its row shows.
pub(super) fn converted_cells(
    heads: &[Vec<&str>],
    rows: &[Vec<&str>],
    written: &dyn Fn(f64, usize) -> String,
) -> (Vec<Vec<String>>, Vec<Vec<String>>) {
    let units = units(heads, rows);
    let new_heads = heads.iter().map(|line| line.iter().map(|cell| head(cell)).collect()).collect();
    // Numbers of a column with one unit share its decimals, as numbers of a row with one unit do; where each has its own,
    // it keeps its own.
    let shared = |cells: &mut dyn Iterator<Item = (Printed, Us)>| {
        let (mut digits, mut largest) = (1, 0.0f64);
        let mut of_cells: Option<usize> = None;
        for (number, us) in cells {
            if number.value != 0.0 && *of_cells.get_or_insert(number.decimals) != number.decimals {
                return None;
            }
            digits = digits.max(number.significant());
            largest = largest.max(us.of(number.value).abs());
        }
        Some(decimals(largest, digits.clamp(3, 6)))
    };
    let own_decimals =
        |number: &Printed, us: &Us| decimals(us.of(number.value).abs(), number.significant().clamp(3, 6));
    let cell = |row: usize, column: usize| Some((parsed(rows[row][column])?, units.of(row, column)?));
    let count = heads.first().map_or(0, Vec::len);
    let column_decimals: Vec<Option<usize>> =
        (0..count).map(|k| shared(&mut (0..rows.len()).filter_map(|row| cell(row, k)))).collect();
    let new_rows = (0..rows.len())
        .map(|row| {
            let of_row = |column: &usize| units.columns[*column].is_none();
            let row_decimals = shared(&mut (0..count).filter(of_row).filter_map(|k| cell(row, k)));
            (0..count)
                .map(|column| {
                    let text = rows[row][column];
                    match cell(row, column) {
                        Some((number, us)) => {
                            let own = match of_row(&column) {
                                true => row_decimals,
                                false => column_decimals[column],
                            };
                            written(us.of(number.value), own.unwrap_or_else(|| own_decimals(&number, &us)))
                        }
                        None if units.place == Some(column) => {
                            us(text).map_or_else(|| text.to_owned(), |us| us.unit.to_owned())
                        }
                        None if column == 0 && bracketed(text).is_some() => head(text),
                        None if parsed(text).is_some() => text.to_owned(),
                        None => sentence(text),
                    }
                })
                .collect()
        })
        .collect();
    (new_heads, new_rows)
}

/// The lines of a table in units of the United States.
pub(super) fn converted_table(table: &SetTable) -> Vec<String> {
    let (heads, rows) = converted_cells(&table.heads, &table.rows, &terminal);
    let length = |cell: &String| cell.chars().count();
    let widths: Vec<usize> = (0..table.right.len())
        .map(|k| heads.iter().chain(&rows).map(|line| length(&line[k])).max().unwrap_or(0).max(1))
        .collect();
    let line = |cells: &[String]| {
        let set = cells.iter().zip(&widths).zip(&table.right).map(|((cell, &width), &right)| match right {
            true => format!("  {cell:>width$}"),
            false => format!("  {cell:<width$}"),
        });
        set.collect::<String>().trim_end_matches(' ').to_owned()
    };
    let dashes: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
    heads
        .iter()
        .map(|cells| line(cells))
        .chain([line(&dashes)])
        .chain(rows.iter().map(|cells| line(cells)))
        .collect()
}

#[cfg(test)]
mod tests {
    use crate::kit::table::{Cell, Column, Table, column_cells, own_cells};
    use crate::text_in_us_units;

    #[test]
    fn a_table_is_set_anew_with_its_sentences_around_it() {
        let words = |cells: [&str; 2]| cells.map(Cell::text).to_vec();
        let mut table = Table::of_columns(
            "sample",
            "Sample of 25.4 mm",
            "",
            vec![
                (Column::words("part"), words(["front 2, then", "rear"])),
                (Column::numbers("z", "mm"), own_cells([-254.0, 25.4], 4)),
                (Column::numbers("load", "N"), column_cells([16_733.0, 0.0], 5, 0.0)),
                (Column::numbers("speed", "rpm"), own_cells([6000.0, 750.0], 4)),
                (Column::words("what"), words(["8.14 kN of all", ""])),
            ],
        );
        table.remark = "All 2 rows, up to 10 N.".to_owned();
        let text = format!("Before: 1000 N.\n\n{}\nAfter.\n", table.text());
        assert_eq!(
            text_in_us_units(&text),
            "Before: 224.8 lbf.\n\nSample of 1.00 in\n  \
             part                z    load  speed  what\n                   \
             [in]   [lbf]  [rpm]\n  \
             -------------  ------  ------  -----  ---------------\n  \
             front 2, then  -10.00  3761.7   6000  1830 lbf of all\n  \
             rear             1.00       0    750\n  \
             All 2 rows, up to 2.25 lbf.\n\nAfter.\n"
        );
    }

    #[test]
    fn rows_may_have_units_of_their_own() {
        let words = |cells: [&str; 2]| cells.map(Cell::text).to_vec();
        let table = Table::of_columns(
            "rows",
            "Rows",
            "",
            vec![
                (Column::words("quantity"), words(["force", "turn"])),
                (Column::words("unit"), words(["N", "deg"])),
                (Column::numbers("before", ""), own_cells([1000.0, 30.0], 4)),
                (Column::numbers("change", "%"), own_cells([-50.0, 10.0], 3)),
            ],
        );
        let us = text_in_us_units(&table.text());
        assert!(
            us.contains("force     lbf    224.8   -50.0") && us.contains("turn      deg       30"),
            "{us}"
        );
    }
}
