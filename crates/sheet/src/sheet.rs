//! Reading and writing of cells.

use calamine::{Data, Reader, Xlsx};
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, XlsxError};
use std::io::Cursor;

/// A cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// Words, without blanks at its ends.
    Text(String),
    /// A number.
    Number(f64),
    /// True or false.
    Flag(bool),
    /// What is no value: an error of the workbook, a date; in words.
    Unusable(String),
}

/// A row that is not empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its number as the program that made the table shows it, from 1.
    pub number: usize,
    /// Its cells, from the first column on.
    pub cells: Vec<Cell>,
}

/// Why cells cannot be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SheetError {
    /// Not CSV.
    #[error("row {row} is not CSV: {reason}")]
    Csv {
        /// Its number, from 1.
        row: u64,
        /// Why.
        reason: String,
    },
    /// Not a workbook, or a damaged one.
    #[error("not a workbook (xlsx) that can be read: {0}")]
    Workbook(String),
    /// More rows or columns than a sheet has, or text longer than a cell.
    #[error("a workbook cannot hold it: {0}")]
    Write(#[from] XlsxError),
}

/// What parts the cells of a CSV text: the semicolon of spreadsheets whose decimal sign is a comma, a tab, or a comma. It is the one that
/// its first row has most of, outside of quotes; ties go to the comma.
pub fn separator(text: &str) -> char {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text).trim_start();
    let mut quoted = false;
    let mut plain = text.chars().filter(|c| {
        quoted ^= *c == '"';
        !quoted
    });
    let head: String = plain.by_ref().take_while(|c| !matches!(c, '\n' | '\r')).collect();
    // The last of the largest.
    ['\t', ';', ','].into_iter().max_by_key(|own| head.matches(*own).count()).unwrap_or(',')
}

/// The rows of a CSV text (RFC 4180, with any [`separator`]); empty ones are left out.
///
/// # Errors
/// [`SheetError::Csv`].
pub fn read_csv(text: &str) -> Result<Vec<Row>, SheetError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let separator = separator(text) as u8;
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator)
        .from_reader(text.as_bytes());
    let mut rows = Vec::new();
    if let Some(row) = open_quote(text, char::from(separator)) {
        let reason =
            "a quotation mark opens a cell here and none closes it: close it, or leave it out".to_owned();
        return Err(SheetError::Csv { row, reason });
    }
    for record in reader.records() {
        let record = record.map_err(|error| SheetError::Csv {
            row: error.position().map_or(0, csv::Position::line),
            reason: error.to_string(),
        })?;
        // The reader says where it began to look: empty lines stand between there and the record.
        let number = record.position().map_or(0, |position| {
            let rest = text.as_bytes().get(position.byte() as usize..).unwrap_or_default();
            let empty = rest.iter().take_while(|byte| matches!(byte, b'\n' | b'\r'));
            position.line() as usize + empty.filter(|byte| **byte == b'\n').count()
        });
        let cells: Vec<Cell> = record.iter().map(text_cell).collect();
        if cells.iter().any(|cell| *cell != Cell::Empty) {
            rows.push(Row { number, cells });
        }
    }
    Ok(rows)
}

/// The line whose quotation mark is not closed: what stands behind it would be one cell.
fn open_quote(text: &str, separator: char) -> Option<u64> {
    let (mut line, mut opened, mut starts) = (1, None, true);
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match (c, opened) {
            ('"', None) if starts => opened = Some(line),
            // Two of them are one within a cell.
            ('"', Some(_)) if rest.next_if_eq(&'"').is_none() => opened = None,
            _ => {}
        }
        starts = opened.is_none() && (c == separator || matches!(c, '\n' | '\r'));
        line += u64::from(c == '\n');
    }
    opened
}

fn text_cell(text: &str) -> Cell {
    match text.trim() {
        "" => Cell::Empty,
        text => Cell::Text(text.to_owned()),
    }
}

/// The rows of the first sheet of a workbook (xlsx); empty ones are left out.
///
/// # Errors
/// [`SheetError::Workbook`].
pub fn read_workbook(bytes: &[u8]) -> Result<Vec<Row>, SheetError> {
    let wrong = |reason: &dyn std::fmt::Display| SheetError::Workbook(reason.to_string());
    let mut book = Xlsx::new(Cursor::new(bytes)).map_err(|error| wrong(&error))?;
    let range = book
        .worksheet_range_at(0)
        .ok_or_else(|| wrong(&"it has no sheet"))?
        .map_err(|error| wrong(&error))?;
    let formulas = formulas_without_results(&mut book, &range);
    let (first_row, first_column) = range.start().unwrap_or((0, 0));
    let cell = |data: &Data| match data {
        Data::Empty => Cell::Empty,
        Data::Int(number) => Cell::Number(*number as f64),
        Data::Float(number) => Cell::Number(*number),
        Data::String(text) => text_cell(text),
        Data::Bool(flag) => Cell::Flag(*flag),
        Data::Error(error) => Cell::Unusable(error.to_string()),
        other => Cell::Unusable(format!("the date or time {other}")),
    };
    let mut rows: Vec<Vec<Cell>> = vec![Vec::new(); first_row as usize];
    for row in range.rows() {
        // What stands left of the first used column is empty.
        let left = vec![Cell::Empty; first_column as usize];
        rows.push(left.into_iter().chain(row.iter().map(cell)).collect());
    }
    for (row, column, words) in formulas {
        rows.resize(rows.len().max(row + 1), Vec::new());
        let cells = &mut rows[row];
        cells.resize(cells.len().max(column + 1), Cell::Empty);
        cells[column] = Cell::Unusable(words);
    }
    let rows = rows.into_iter().enumerate().map(|(place, mut cells)| {
        let used = cells.iter().rposition(|cell| *cell != Cell::Empty).map_or(0, |last| last + 1);
        cells.truncate(used);
        Row { number: place + 1, cells }
    });
    Ok(rows.filter(|row| !row.cells.is_empty()).collect())
}

/// Row and column from 0 of the formulas of the first sheet whose results the workbook does not hold, each in words: the program that wrote it computes none,
/// and an empty cell would say something else.
fn formulas_without_results(
    book: &mut Xlsx<Cursor<&[u8]>>,
    values: &calamine::Range<Data>,
) -> Vec<(usize, usize, String)> {
    let sheet = book.sheet_names().first().cloned().unwrap_or_default();
    let Ok(formulas) = book.worksheet_formula(&sheet) else { return Vec::new() };
    let (first_row, first_column) = formulas.start().unwrap_or((0, 0));
    let mut found = Vec::new();
    for (row, column, formula) in formulas.used_cells() {
        let (row, column) = (first_row as usize + row, first_column as usize + column);
        let value = values.get_value((row as u32, column as u32));
        if matches!(value, None | Some(Data::Empty)) {
            let cell = format!("{}{}", column_letters(column), row + 1);
            found.push((
                row,
                column,
                format!(
                    "the formula ={formula} in cell {cell} of the sheet \"{sheet}\", whose result the workbook does not hold: \
                     open it in a spreadsheet program and save it there, or write the number"
                ),
            ));
        }
    }
    found
}

/// Letters of a column from 0, as spreadsheets count: A, ..., Z, AA.
fn column_letters(place: usize) -> String {
    let (mut letters, mut rest) = (String::new(), place + 1);
    while rest > 0 {
        letters.insert(0, char::from(b'A' + ((rest - 1) % 26) as u8));
        rest = (rest - 1) / 26;
    }
    letters
}

/// A workbook of one sheet with a row of heads, the same bytes whenever it is written.
///
/// # Errors
/// [`SheetError::Write`].
pub fn workbook(name: &str, heads: &[String], rows: &[Vec<Cell>]) -> Result<Vec<u8>, SheetError> {
    let mut book = Workbook::new();
    // Without it the bytes hold the time.
    let made = ExcelDateTime::from_ymd(2000, 1, 1)?;
    book.set_properties(&DocProperties::new().set_creation_datetime(&made));
    let sheet = book.add_worksheet();
    sheet.set_name(name)?;
    sheet.set_freeze_panes(1, 0)?;
    let bold = Format::new().set_bold();
    let place = |place: usize| u16::try_from(place).map_err(|_| XlsxError::RowColumnLimitError);
    for (column, head) in heads.iter().enumerate() {
        sheet.write_string_with_format(0, place(column)?, head, &bold)?;
        sheet.set_column_width(place(column)?, head.chars().count().clamp(8, 40) as f64 + 2.0)?;
    }
    for (row, cells) in rows.iter().enumerate() {
        let row = u32::try_from(row + 1).map_err(|_| XlsxError::RowColumnLimitError)?;
        for (column, cell) in cells.iter().enumerate() {
            let column = place(column)?;
            match cell {
                Cell::Number(number) if number.is_finite() => {
                    sheet.write_number(row, column, *number)?;
                }
                Cell::Empty | Cell::Number(_) => {}
                Cell::Text(text) | Cell::Unusable(text) => {
                    sheet.write_string(row, column, text)?;
                }
                Cell::Flag(flag) => {
                    sheet.write_boolean(row, column, *flag)?;
                }
            }
        }
    }
    Ok(book.save_to_buffer()?)
}
