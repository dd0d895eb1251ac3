//! The loads as plain text.

use crate::kit::number;
use crate::loads::findings::findings_table;
use crate::loads::tables as load_tables;
use lanchester_mechanism::Loads;
use std::fmt::Write;

const WIDTH: usize = 96;

/// Diagnosis and tables as aligned plain text, without colour.
pub fn loads_text(loads: &Loads) -> String {
    let mut out = String::with_capacity(8192);
    let rpm = number::terminal(number::rpm(loads.speed), 0);
    let _ = writeln!(out, "{} at {rpm} rpm", loads.engine);
    let [x, y, z] = loads.reference.map(|v| number::terminal(1e3 * v, 1));
    let _ = writeln!(out, "Motion: {}. Couples about x = {x}, y = {y}, z = {z} mm.\n", loads.kinematics);
    push_wrapped(&mut out, "", &loads.diagnosis.summary);
    push_wrapped(&mut out, "", &loads.diagnosis.roll);
    let mut tables = Vec::new();
    if !loads.diagnosis.findings.is_empty() {
        tables.push(findings_table(loads));
    }
    tables.extend([
        load_tables::peaks_table(loads),
        load_tables::force_orders_table(loads),
        load_tables::couple_orders_table(loads),
        load_tables::roll_orders_table(loads),
        load_tables::parts_table(loads),
        load_tables::cylinders_table(loads),
        load_tables::motion_table(loads),
    ]);
    tables.extend(load_tables::articulation_table(loads));
    tables.extend(load_tables::rod_inertia_table(loads));
    for table in tables {
        out.push('\n');
        out.push_str(&table.text());
    }
    out
}

/// A paragraph broken at spaces, the first line behind `bullet`, the others indented below it.
pub(crate) fn push_wrapped(out: &mut String, bullet: &str, text: &str) {
    let indent = bullet.chars().count();
    let mut column = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if column == 0 {
            out.push_str(bullet);
            column = indent;
        } else if column + 1 + length > WIDTH {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            column = indent;
        } else {
            out.push(' ');
            column += 1;
        }
        out.push_str(word);
        column += length;
    }
    if column > 0 {
        out.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use crate::sample;

    #[test]
    fn snap_twin() {
        insta::assert_snapshot!(super::loads_text(&sample::loads(&sample::twin())));
    }

    #[test]
    fn paragraphs_break_before_the_margin() {
        let mut out = String::new();
        super::push_wrapped(&mut out, "  - ", &"second order ".repeat(20));
        assert!(out.lines().all(|l| l.chars().count() <= super::WIDTH), "{out}");
        assert!(out.lines().skip(1).all(|l| l.starts_with("    s") || l.starts_with("    o")), "{out}");
    }
}
