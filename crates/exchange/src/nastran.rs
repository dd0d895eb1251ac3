//! Nastran bulk data: frequency-dependent loads (`RLOAD1`) with their tables (`TABLED1`).
//!
//! ```text
//! {P(f)} = {A} [ C(f) + i D(f) ]          A = 1 (DAREA), C and D: TABLED1 over the frequency [Hz]
//! f = n w / 2 pi                           one frequency a speed: an order is a line through the Campbell diagram
//! ```
//! (MSC Nastran Quick Reference Guide, entries RLOAD1, TABLED1, DAREA, DLOAD, FREQ.) Large fields hold all digits that sixteen columns have.

use crate::force_table::{ForceTable, wrap};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Numbers that the entries of a deck count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FirstNumbers {
    /// Of `DLOAD`, `FREQ`, `RLOAD1` and `DAREA`.
    pub set: u32,
    /// Of `TABLED1`; behind the sets where it is not given.
    pub table: Option<u32>,
}

impl FirstNumbers {
    /// Sets from here on, and tables behind them.
    pub fn from(set: u32) -> FirstNumbers {
        FirstNumbers { set, table: None }
    }
}

/// The forces as bulk data: a load set an order, which a subcase names by DLOAD and FREQUENCY.
///
/// Every order has `DLOAD`, `FREQ`; every point and component `DAREA`, `RLOAD1` and two `TABLED1`. Components that are 0 at all speeds are left out.
pub fn nastran(table: &ForceTable, first: FirstNumbers) -> String {
    let mut out = String::new();
    let comment = |out: &mut String, text: &str| {
        for line in text.lines().flat_map(|line| wrap(line, 70)) {
            let _ = writeln!(out, "$ {line}");
        }
    };
    comment(&mut out, &table.title);
    table.notes.iter().for_each(|note| comment(&mut out, note));
    comment(&mut out, "Units: N, m, Hz. f(t) = Re(P e^{i 2 pi f t}), t = 0 at crank angle 0.");
    comment(&mut out, "Outside its frequencies a TABLED1 is extrapolated: ask for those of the FREQ.");
    let loaded = |forces: &[[num_complex::Complex64; 3]], axis: usize| {
        forces.iter().any(|force| force[axis].norm_sqr() != 0.0)
    };
    let components = table.orders.iter().flat_map(|own| &own.forces);
    let components: usize =
        components.map(|forces| (0..3).filter(|axis| loaded(forces, *axis)).count()).sum();
    // Sets: one an order, then RLOAD1 and DAREA of every component.
    let mut next = first.set.max(1);
    let mut next_table =
        first.table.unwrap_or(next + table.orders.len() as u32 + 2 * components as u32).max(1);
    let mut number = || {
        next += 1;
        next - 1
    };
    let mut table_number = || {
        next_table += 1;
        next_table - 1
    };
    let sets: Vec<u32> = table.orders.iter().map(|_| number()).collect();
    for (set, own) in sets.iter().zip(&table.orders) {
        comment(&mut out, &format!("subcase of order {}: DLOAD = {set}, FREQUENCY = {set}", own.order));
    }
    for point in &table.points {
        comment(&mut out, &point.name);
        // Blank: the basic coordinate system.
        let [x, y, z] = point.position.map(large);
        let _ = writeln!(out, "GRID*   {:>16}{:>16}{x:>16}{y:>16}\n*       {z:>16}", point.id, "");
    }
    for (set, own) in sets.iter().zip(&table.orders) {
        comment(&mut out, &format!("order {}", own.order));
        let frequencies: Vec<String> =
            table.speeds.iter().map(|speed| large(own.order * speed / TAU)).collect();
        fields(&mut out, "FREQ", &[set.to_string()], &frequencies);
        let mut loads = Vec::new();
        for (point, forces) in table.points.iter().zip(&own.forces) {
            for axis in 0..3 {
                if !loaded(forces, axis) {
                    continue;
                }
                let (load, area) = (number(), number());
                let (real, imaginary) = (table_number(), table_number());
                let _ = writeln!(
                    out,
                    "DAREA*  {area:>16}{:>16}{:>16}{:>16}\n*\nRLOAD1* {load:>16}{area:>16}{:>16}{:>16}\n*       {real:>16}{imaginary:>16}{:>16}",
                    point.id,
                    axis + 1,
                    "1.0",
                    "",
                    "",
                    "LOAD"
                );
                for (id, part) in [(real, 0), (imaginary, 1)] {
                    let value = |force: &[num_complex::Complex64; 3]| match part {
                        0 => force[axis].re,
                        _ => force[axis].im,
                    };
                    let pairs = frequencies.iter().zip(forces);
                    let mut data: Vec<String> =
                        pairs.flat_map(|(f, force)| [f.clone(), large(value(force))]).collect();
                    data.push("ENDT".to_owned());
                    // Both axes linear: three blank fields behind the two of the head.
                    let head = [id.to_string(), "LINEAR".to_owned(), "LINEAR".to_owned()];
                    let blanks = vec![String::new(); 5];
                    fields(&mut out, "TABLED1", &head, &[blanks, data].concat());
                }
                loads.push(load);
            }
        }
        let sums: Vec<String> = loads.iter().flat_map(|load| ["1.0".to_owned(), load.to_string()]).collect();
        if !sums.is_empty() {
            fields(&mut out, "DLOAD", &[set.to_string(), "1.0".to_owned()], &sums);
        }
    }
    out
}

/// An entry in large fields, four a line.
fn fields(out: &mut String, name: &str, head: &[String], data: &[String]) {
    let all: Vec<&String> = head.iter().chain(data).collect();
    for (line, chunk) in all.chunks(4).enumerate() {
        let start = if line == 0 { format!("{name}*") } else { "*".to_owned() };
        let _ = write!(out, "{start:<8}");
        for field in chunk {
            let _ = write!(out, "{field:>16}");
        }
        out.push('\n');
    }
    // An entry of large fields has lines in pairs.
    if all.len().div_ceil(4) % 2 == 1 {
        out.push_str("*\n");
    }
}

/// A number in sixteen columns, with as many digits as they hold.
fn large(value: f64) -> String {
    let fits = (1..=12).rev().map(|digits| format!("{value:.digits$E}")).find(|text| text.len() <= 16);
    fits.unwrap_or_else(|| format!("{value:.1E}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_fill_their_columns_and_keep_their_digits() {
        for value in [0.0, 1.0, -1.0, 123456.789012345, -9.87654321e-12, 4.2e-105, -1e300] {
            let text = large(value);
            assert!(text.len() <= 16 && text.contains('.'), "{text}");
            let back: f64 = text.parse().expect("a number");
            assert!((back - value).abs() <= 1e-8 * value.abs(), "{value} became {text}");
        }
    }
}
