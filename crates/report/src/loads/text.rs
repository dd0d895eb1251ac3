//! The loads as plain text.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::loads::findings::findings_table;
use crate::loads::tables as load_tables;
use lanchester_mechanism::Loads;
use std::fmt::Write;

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

#[cfg(test)]
mod tests {
    use crate::sample;

    #[test]
    fn snap_twin() {
        insta::assert_snapshot!(super::loads_text(&sample::loads(&sample::twin())));
    }
}
