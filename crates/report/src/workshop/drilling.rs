//! Holes to drill, as tables.

use super::correction::remarks_text;
use super::grade::{grade_tables, plain};
use super::mass::{on_rotor, rotor_angle};
use crate::kit::rounding::below;
use crate::kit::table::{Cell, Column, Table};
use lanchester_workshop::{Drilling, NextStep};

/// The holes of every plane, and what is left.
pub fn drilling_tables(drilling: &Drilling) -> Vec<Table> {
    let mut tables = vec![holes_table(drilling), left_table(drilling)];
    tables.retain(|table| !table.rows.is_empty());
    tables
}

/// The holes for a terminal.
pub fn drilling_text(drilling: &Drilling) -> String {
    let mut out = format!("{}\n", drilling.name);
    for table in drilling_tables(drilling) {
        out += "\n";
        out += &table.text();
    }
    for plane in drilling.planes.iter().filter(|plane| !plane.complete) {
        out += &format!(
            "\nthe search in plane {} was cut short: a better set of holes may exist\n",
            plane.plane
        );
    }
    out += &remarks_text(&drilling.correction.remarks);
    if let Some(grade) = &drilling.grade_after {
        out += &format!("\nG {} with these holes\n", plain(1e3 * grade.grade, 4));
        for table in grade_tables(grade) {
            out += "\n";
            out += &table.text();
        }
    }
    out += match (drilling.holds, &drilling.grade_after) {
        _ if drilling.correction.next == NextStep::Settle => {
            "\nnext: settle the doubts; until then the holes are not to be relied on\n"
        }
        (_, Some(grade)) if grade.kept.is_none() && grade.resultant.is_some() => super::grade::COUPLE,
        (true, Some(_)) => "\nthe grade is kept with these holes\n",
        (true, None) => "\nwhat is left is within the steps of depth\n",
        (false, Some(_)) => "\nthe grade is not kept with these holes\n",
        (false, None) => "\nthe holes cannot take away what is wanted: allow more or larger ones\n",
    };
    out
}

fn millimetres(length: f64, decimals: usize) -> Cell {
    Cell::Number { value: 1e3 * length, decimals }
}

fn holes_table(drilling: &Drilling) -> Table {
    let mut rows = Vec::new();
    for plane in &drilling.planes {
        for hole in &plane.holes {
            rows.push(vec![
                Cell::text(plane.plane.clone()),
                rotor_angle(hole.angle, 1),
                millimetres(hole.diameter, 1),
                millimetres(hole.depth, 2),
                millimetres(hole.tip, 2),
                Cell::Number { value: 1e3 * hole.mass, decimals: 2 },
                Cell::number(1e6 * hole.unbalance, 4),
            ]);
        }
    }
    Table {
        id: "holes",
        title: "Holes".to_owned(),
        note: "Depth counts from the surface to the end of the full diameter, tip to the tip of the drill."
            .to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("plane"),
            Column::numbers("at", "deg"),
            Column::numbers("diameter", "mm"),
            Column::numbers("depth", "mm"),
            Column::numbers("tip", "mm"),
            Column::numbers("mass", "g"),
            Column::numbers("unbalance", "g mm"),
        ],
        rows,
    }
}

fn left_table(drilling: &Drilling) -> Table {
    let rows = drilling.planes.iter().map(|plane| {
        let noise = below(plane.wanted.norm());
        let mut row = vec![Cell::text(plane.plane.clone())];
        row.extend(on_rotor(plane.wanted, 0.0));
        row.extend(on_rotor(plane.left, noise));
        row.push(Cell::number(1e6 * plane.tolerance, 3));
        row.push(Cell::text(if plane.kept { "within" } else { "more" }));
        row
    });
    Table {
        id: "left",
        title: "What is to be removed, and what the holes leave of it".to_owned(),
        note: "What may be left is the plane's share of the grade; without one, what a step of depth makes."
            .to_owned(),
        remark: String::new(),
        columns: vec![
            Column::words("plane"),
            Column::numbers("remove", "g mm"),
            Column::numbers("at", "deg"),
            Column::numbers("left", "g mm"),
            Column::numbers("at", "deg"),
            Column::numbers("allowed", "g mm"),
            Column::words("verdict"),
        ],
        rows: rows.collect(),
    }
}
