//! Universal files: units (dataset 164), nodes (2411) and functions at nodes (58), an order function over speed for every order, node and
//! direction.
//!
//! Formats after the documentation of the Structural Dynamics Research Laboratory, University of Cincinnati: records of fixed columns, forces
//! as pairs of doubles (`E13.5, 2E20.12`: complex, double precision, uneven abscissa).

use crate::force_table::{ForceTable, fit};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Kinds of function and quantity of dataset 58.
const ORDER_FUNCTION: u32 = 27;
const COMPLEX_DOUBLE: u32 = 6;
const UNEVEN: u32 = 0;
const EXCITATION_FORCE: u32 = 13;
const SPEED: u32 = 19;
const ORDER: u32 = 20;

/// The forces as a universal file. The abscissa is the speed of crankshaft 1 [rpm], the z axis the order.
pub fn universal(table: &ForceTable) -> String {
    let mut out = String::new();
    dataset(&mut out, 164, |out| {
        let _ = writeln!(out, "{:>10}{:<20}{:>10}", 1, "SI: Meter (newton)", 2);
        let one = exponent(1.0, 17, 25).replace('E', "D");
        let _ = writeln!(out, "{one}{one}{one}\n{}", exponent(273.15, 17, 25).replace('E', "D"));
    });
    dataset(&mut out, 2411, |out| {
        for point in &table.points {
            let _ = writeln!(out, "{:>10}{:>10}{:>10}{:>10}", point.id, 0, 0, 11);
            for value in point.position {
                out.push_str(&exponent(value, 16, 25).replace('E', "D"));
            }
            out.push('\n');
        }
    });
    for own in &table.orders {
        for (point, forces) in table.points.iter().zip(&own.forces) {
            for axis in 0..3 {
                dataset(&mut out, 58, |out| {
                    let direction = ["+X", "+Y", "+Z"][axis];
                    // Five lines: what they have no room for ends in dots.
                    let [title] = fit::<1>(&table.title, 80);
                    let about = format!("force on {}, {direction}, order {}", point.name, own.order);
                    let ([about], [words, more]) = (fit::<1>(&about, 80), fit::<2>(&point.words, 80));
                    let sign = "f(t) = Re(F e^(i n w t)), t = 0 at crank angle 0";
                    let _ = match more.as_str() {
                        "" => writeln!(out, "{title}\n{about}\nNONE\n{words}\n{sign}"),
                        // The third is for a date, which no two runs would have the same.
                        more => writeln!(out, "{title}\n{about}\n{sign}\n{words}\n{more}"),
                    };
                    let _ = writeln!(
                        out,
                        "{ORDER_FUNCTION:>5}{:>10}{:>5}{:>10} {:<10}{:>10}{:>4} {:<10}{:>10}{:>4}",
                        0,
                        1,
                        0,
                        "NONE",
                        point.id,
                        axis + 1,
                        "NONE",
                        0,
                        0
                    );
                    let rpm = |speed: &f64| speed * 30.0 / PI;
                    let first = table.speeds.first().map_or(0.0, rpm);
                    let _ = writeln!(
                        out,
                        "{COMPLEX_DOUBLE:>10}{:>10}{UNEVEN:>10}{}{}{}",
                        table.speeds.len(),
                        exponent(first, 5, 13),
                        exponent(0.0, 5, 13),
                        exponent(own.order, 5, 13)
                    );
                    let mut axis_of = |kind: u32, force: u32, label: &str, unit: &str| {
                        let _ = writeln!(out, "{kind:>10}{:>5}{force:>5}{:>5} {label:<20} {unit:<20}", 0, 0);
                    };
                    axis_of(SPEED, 0, "Speed", "rpm");
                    axis_of(EXCITATION_FORCE, 1, "Force", "N");
                    axis_of(0, 0, "NONE", "NONE");
                    axis_of(ORDER, 0, "Order", "NONE");
                    for (speed, force) in table.speeds.iter().zip(forces) {
                        let [re, im] = [force[axis].re, force[axis].im].map(|value| exponent(value, 12, 20));
                        let _ = writeln!(out, "{}{re}{im}", exponent(rpm(speed), 5, 13));
                    }
                });
            }
        }
    }
    out
}

fn dataset(out: &mut String, number: u32, fill: impl FnOnce(&mut String)) {
    let _ = writeln!(out, "    -1\n{number:>6}");
    fill(out);
    out.push_str("    -1\n");
}

/// `1PEw.d` of Fortran: two digits of the exponent at least, with its sign.
fn exponent(value: f64, digits: usize, width: usize) -> String {
    let text = format!("{value:.digits$E}");
    let (number, power) = text.split_once('E').unwrap_or((&text, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    // What Fortran cannot write with two digits is nothing beside any force.
    if power < -99 {
        return exponent(0.0, digits, width);
    }
    format!("{:>width$}", format!("{number}E{power:+03}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_their_columns() {
        assert_eq!(exponent(-0.5, 5, 13), " -5.00000E-01");
        assert_eq!(exponent(6000.0, 12, 20), "  6.000000000000E+03");
        assert_eq!(exponent(1e-120, 5, 13), "  0.00000E+00");
    }
}
