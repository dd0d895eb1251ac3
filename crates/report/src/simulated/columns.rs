//! How tables of a simulated run are made.

use crate::kit::table::{Cell, Column, Table};

/// A column of words, or of numbers where it has a unit.
pub(super) fn words(header: &str, unit: &'static str) -> Column {
    if unit.is_empty() { Column::words(header) } else { Column::numbers(header, unit) }
}

/// A table without a remark.
pub(super) fn table(
    id: &'static str,
    title: &str,
    note: &str,
    columns: Vec<Column>,
    rows: Vec<Vec<Cell>>,
) -> Table {
    Table { id, title: title.into(), note: note.into(), remark: String::new(), columns, rows }
}
