//! Decimal commas of tables of cases.

use lanchester::{CaseCell, CaseTable};
use pyo3::prelude::*;

/// The cells of a column of a table whose cells are parted by semicolons, as [`CaseTable::put_points`] reads them: each with what is wrong with it.
#[pyfunction]
pub fn decimal_points(key: &str, has_unit: bool, cells: Vec<String>) -> Vec<(String, Option<String>)> {
    let mut cells: Vec<CaseCell> = cells.into_iter().map(CaseCell::Text).collect();
    CaseTable::put_points(key, has_unit, cells.iter_mut());
    let told = |cell| match cell {
        CaseCell::Text(text) => (text, None),
        CaseCell::Unusable(words) => (String::new(), Some(words)),
        CaseCell::Empty | CaseCell::Number(_) | CaseCell::Flag(_) => (String::new(), None),
    };
    cells.into_iter().map(told).collect()
}
