//! `lanchester loads --cases`: the loads of every row of a table of cases.

use crate::arguments::LoadsArguments;
use crate::commands::{json, open};
use crate::failure::{DONE, Failure, WRONG_INPUT};
use crate::files::{not_there, print, read_bytes, write_result};
use crate::format::Format;
use crate::options::printed::Units;
use crate::requests::loads::load_request;
use lanchester::report::{Cell, Table};
use lanchester::{CaseCell, CaseFault, CaseRow, CaseTable, case_loads};
use lanchester_files::shown;
use lanchester_sheet::{self as sheet, read_csv, read_workbook, separator, workbook};
use std::path::Path;

/// Faults that are told; what follows them has often the same cause.
const MOST_FAULTS: usize = 50;

const HINT: &str = "a table of cases is CSV in UTF-8 or a workbook (.xlsx): keys of the engine file in its first row, such as rod.length [mm]";

pub fn run(arguments: &LoadsArguments, cases: &Path, colour: bool) -> Result<u8, Failure> {
    let output = arguments.output.as_deref();
    if let Some(path) = output.filter(|path| !matches!(ending(path).as_str(), "csv" | "xlsx")) {
        return Err(Failure::input(
            format_args!("the loads of cases are written as .csv or .xlsx, got {}", shown(path)),
            "give --output one of these endings",
        ));
    }
    if arguments.printed.brief {
        return Err(Failure::input(
            "--brief is of one engine, and --cases asks for a table of many",
            "leave --brief out",
        ));
    }
    if arguments.printed.units == Units::Us && output.is_some_and(|path| ending(path) == "xlsx") {
        return Err(Failure::input(
            "a workbook of cases is written in SI units, and --units us is asked for",
            "write the loads as .csv, or leave --units out",
        ));
    }
    // Said before all cases are computed.
    output.map_or(Ok(()), not_there)?;
    let request = load_request(&arguments.request)?;
    let opened = open(&arguments.file, colour)?;
    let told = |faults: Vec<CaseFault>| all_faults(cases, &faults);
    let (rows, decimal_commas) = rows(cases)?;
    let table = CaseTable::of(rows).map_err(told)?;
    let table = if decimal_commas { table.with_decimal_commas() } else { table };
    let found = case_loads(&opened.source.text, &table, &request).map_err(told)?;
    match output {
        Some(path) if ending(path) == "xlsx" => {
            let bytes = as_workbook(&found).map_err(|error| Failure::input(error, "write them as .csv"))?;
            write_result(path, &arguments.file, &bytes)?;
        }
        Some(path) => write_result(path, &arguments.file, &arguments.printed.csv(found.csv()))?,
        None => print(&match arguments.format {
            Format::Text => arguments.printed.words(found.text()),
            Format::Csv => arguments.printed.csv(found.csv()),
            Format::Json => json(&objects(&found))?,
        })?,
    }
    if let Some(path) = output {
        let cases = if table.len() == 1 { "1 case".to_owned() } else { format!("{} cases", table.len()) };
        eprintln!("loads of {cases} written into {}", shown(path));
    }
    Ok(DONE)
}

fn ending(path: &Path) -> String {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// The rows, and whether their numbers have decimal commas.
fn rows(path: &Path) -> Result<(Vec<CaseRow>, bool), Failure> {
    let bytes = read_bytes(path, HINT)?;
    let wrong = |error: &dyn std::fmt::Display| {
        Failure::input(format_args!("cannot read {}: {error}", shown(path)), HINT)
    };
    let (rows, decimal_commas) = match ending(path).as_str() {
        "xlsx" => (read_workbook(&bytes).map_err(|error| wrong(&error))?, false),
        _ => {
            let text = String::from_utf8(bytes).map_err(|error| {
                wrong(&format_args!("it is not UTF-8 text (byte {})", error.utf8_error().valid_up_to()))
            })?;
            // Where semicolons part the cells, the comma is left for the decimals.
            (read_csv(&text).map_err(|error| wrong(&error))?, separator(&text) == ';')
        }
    };
    let cell = |cell: sheet::Cell| match cell {
        sheet::Cell::Empty => CaseCell::Empty,
        sheet::Cell::Text(text) => CaseCell::Text(text),
        sheet::Cell::Number(number) => CaseCell::Number(number),
        sheet::Cell::Flag(flag) => CaseCell::Flag(flag),
        sheet::Cell::Unusable(words) => CaseCell::Unusable(words),
    };
    let row =
        |row: sheet::Row| CaseRow { number: row.number, cells: row.cells.into_iter().map(cell).collect() };
    Ok((rows.into_iter().map(row).collect(), decimal_commas))
}

/// All faults at once.
fn all_faults(path: &Path, faults: &[CaseFault]) -> Failure {
    let mut lines: Vec<String> =
        faults.iter().take(MOST_FAULTS).map(|fault| format!("error: {}: {fault}", shown(path))).collect();
    if faults.len() > MOST_FAULTS {
        lines.push(format!("error: and {} more", faults.len() - MOST_FAULTS));
    }
    lines.push(
        "hint: no case was computed; mend these cells, or empty them to keep what the engine file has".into(),
    );
    Failure { status: WRONG_INPUT, message: lines.join("\n") }
}

/// Heads with their units.
fn heads(table: &Table) -> Vec<String> {
    let head = |own: &lanchester::report::Column| match own.unit {
        "" => own.header.clone(),
        unit => format!("{} [{unit}]", own.header),
    };
    table.columns.iter().map(head).collect()
}

/// The number that a cell of a case holds as a text; none in a column of names.
fn number(head: &str, text: &str) -> Option<serde_json::Number> {
    if head == "name" {
        return None;
    }
    let whole = text.parse::<i64>().ok().map(serde_json::Number::from);
    whole.or_else(|| text.parse::<f64>().ok().and_then(serde_json::Number::from_f64))
}

fn as_workbook(table: &Table) -> Result<Vec<u8>, sheet::SheetError> {
    let heads = heads(table);
    let cell = |(cell, head): (&Cell, &String)| match cell {
        Cell::Text(text) | Cell::Formula { text, .. } => {
            match number(head, text).and_then(|number| number.as_f64()) {
                Some(number) => sheet::Cell::Number(number),
                None => sheet::Cell::Text(text.clone()),
            }
        }
        Cell::Number { value, .. } => sheet::Cell::Number(*value),
        Cell::Empty => sheet::Cell::Empty,
    };
    let row = |row: &Vec<Cell>| row.iter().zip(&heads).map(cell).collect();
    let rows: Vec<Vec<sheet::Cell>> = table.rows.iter().map(row).collect();
    workbook("loads", &heads, &rows)
}

/// A row an object, by its heads.
fn objects(table: &Table) -> Vec<serde_json::Map<String, serde_json::Value>> {
    let heads = heads(table);
    let value = |(cell, head): (&Cell, &String)| match cell {
        Cell::Text(text) | Cell::Formula { text, .. } => match number(head, text) {
            Some(number) => serde_json::Value::Number(number),
            None => serde_json::Value::from(text.clone()),
        },
        Cell::Number { value, .. } => serde_json::Value::from(*value),
        Cell::Empty => serde_json::Value::Null,
    };
    let row = |row: &Vec<Cell>| heads.iter().cloned().zip(row.iter().zip(&heads).map(value)).collect();
    table.rows.iter().map(row).collect()
}
