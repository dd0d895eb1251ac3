//! What a balance quality grade allows, as tables.

use super::mass::{on_rotor, rotor_degrees};
use crate::kit::number;
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table};
use lanchester_workshop::Grade;
use num_complex::Complex64;

/// What is said where only the bearings could judge.
pub(super) const COUPLE: &str = "\nthe couple is not judged, though the resultant is within the grade: add centre and supports to [rotor], which give each bearing its share\n";

/// Shares of the bearings and of the correction planes; empty ones are left out.
pub fn grade_tables(grade: &Grade) -> Vec<Table> {
    let row = |name: String, z: f64, permissible: f64, measured: Option<Complex64>, kept: Option<bool>| {
        let mut row = vec![Cell::text(name), Cell::number(1e3 * z, 5), Cell::number(1e6 * permissible, 4)];
        match measured {
            Some(measured) => {
                row.extend(on_rotor(measured, below(permissible)));
                row.push(Cell::text(verdict(kept)));
            }
            None => row.extend([Cell::Empty, Cell::Empty, Cell::Empty]),
        }
        row
    };
    let table = |id, title: &str, note: &str, head: &str, rows: Vec<Vec<Cell>>| {
        let columns = vec![
            Column::words(head),
            Column::numbers("z", "mm"),
            Column::numbers("permissible", "g mm"),
            Column::numbers("measured", "g mm"),
            Column::numbers("at", "deg"),
            Column::words("verdict"),
        ];
        let note = note.to_owned();
        Table { id, title: title.to_owned(), note, remark: String::new(), columns, rows }
    };
    let bearings = grade.bearings.iter().enumerate().map(|(k, bearing)| {
        let name = if k == 0 { "first" } else { "second" };
        row(name.to_owned(), bearing.z, bearing.permissible, bearing.measured, bearing.kept)
    });
    let planes = grade
        .planes
        .iter()
        .map(|plane| row(plane.name.clone(), plane.z, plane.permissible, plane.measured, plane.kept));
    let tables = [
        table(
            "grade-bearings",
            "Bearings",
            "Each may carry what the whole permissible unbalance would put on it from the centre of mass, but no less than 30 % \
             of it, and no more than 70 % (130 % beside an overhung centre of mass).",
            "bearing",
            bearings.collect(),
        ),
        table(
            "grade-planes",
            "Correction planes",
            "With no more than this left in every plane, at whatever angles, both bearings keep their shares.",
            "plane",
            planes.collect(),
        ),
    ];
    tables.into_iter().filter(|table| !table.rows.is_empty()).collect()
}

/// The grade for a terminal.
pub fn grade_text(grade: &Grade) -> String {
    let rpm = number::rpm(grade.speed);
    let mut out = format!(
        "{}: G {} at {} rpm, {} kg\n\npermissible residual unbalance  {} g mm\npermissible eccentricity        {} um\n",
        grade.name,
        plain(1e3 * grade.grade, 4),
        plain(rpm, 5),
        plain(grade.mass, 5),
        plain(1e6 * grade.permissible, 4),
        plain(1e6 * grade.eccentricity, 4),
    );
    if let Some(resultant) = grade.resultant {
        let at = number::plain(rotor_degrees(resultant.arg(), 1), 1);
        out += &format!(
            "resultant of what is measured   {} g mm at {at} deg\n",
            plain(1e6 * resultant.norm(), 4)
        );
    }
    for table in grade_tables(grade) {
        out += "\n";
        out += &table.text();
    }
    out += match grade.kept {
        Some(true) => "\nthe grade is kept\n",
        Some(false) => "\nthe grade is not kept\n",
        None if grade.resultant.is_some() => COUPLE,
        None => {
            "\nnothing is measured yet: add [[display]], or [[run]] with trial weights in planes whose z is given, for a verdict\n"
        }
    };
    out
}

fn verdict(kept: Option<bool>) -> &'static str {
    match kept {
        Some(true) => "kept",
        Some(false) => "exceeded",
        None => "",
    }
}

/// A number with about `significant` digits, without zeros at its end, in ASCII.
pub(super) fn plain(value: f64, significant: i32) -> String {
    let text = number::plain(value, number::decimals(value.abs(), significant));
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
