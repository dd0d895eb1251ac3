//! Orders of two traces side by side.

use lanchester_report::CrossRow;
use lanchester_results::TwoSided;
use num_complex::Complex64;

/// Orders below this share of the scale are not listed: rounding.
const LISTED: f64 = 1e-9;

/// The larger of two amounts; what is not a number is the largest of all.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// A row for every order up to `max_order`, whole and in fractions of `turns`, of two traces: closed form, simulation.
pub(crate) fn order_rows(
    named: (&str, &str),
    [closed, ours]: [&[Complex64]; 2],
    turns: f64,
    max_order: u32,
    scale: f64,
    bar: f64,
) -> Vec<CrossRow> {
    largest_order_rows(named, &[[closed, ours]], turns, max_order, scale, bar)
}

/// The same of several parts of one kind: the largest of all of them.
pub(crate) fn largest_order_rows(
    (name, unit): (&str, &str),
    parts: &[[&[Complex64]; 2]],
    turns: f64,
    max_order: u32,
    scale: f64,
    bar: f64,
) -> Vec<CrossRow> {
    let count = (f64::from(max_order) * turns).round() as u32;
    let rows = (0..=count).filter_map(|k| {
        let order = f64::from(k) / turns;
        let mut largest = [0.0f64; 3];
        for traces in parts {
            let [closed, ours] = traces.map(|trace| TwoSided::of_samples(trace, 0.0, turns, order));
            let sizes = [closed.peak(), ours.peak(), (ours - closed).peak()];
            largest = std::array::from_fn(|k| larger(largest[k], sizes[k]));
        }
        let [closed, ours, off] = largest;
        // What is not a number is listed too.
        let is_rounding = larger(closed, ours) <= LISTED * scale;
        (!is_rounding).then(|| CrossRow::held(name, unit, Some(order), [closed, ours, off, scale], bar))
    });
    rows.collect()
}
