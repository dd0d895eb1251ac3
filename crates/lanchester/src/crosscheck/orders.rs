//! Orders of two traces side by side.

use lanchester_report::CrossRow;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Orders below this share of the scale are not listed: rounding.
const LISTED: f64 = 1e-9;

/// Amplitude of the order `n` over `turns` revolutions: part that turns forwards, part that turns backwards.
pub(crate) fn two_sided(trace: &[Complex64], turns: f64, order: f64) -> [Complex64; 2] {
    let count = trace.len() as f64;
    let by = |sign: f64| {
        let terms = trace
            .iter()
            .enumerate()
            .map(|(k, value)| value * Complex64::cis(-sign * order * TAU * turns * k as f64 / count));
        terms.sum::<Complex64>() / count
    };
    if order == 0.0 { [by(1.0), Complex64::ZERO] } else { [by(1.0), by(-1.0)] }
}

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
        let size = |sides: [Complex64; 2]| sides[0].norm() + sides[1].norm();
        let mut largest = [0.0f64; 3];
        for traces in parts {
            let [closed, ours] = traces.map(|trace| two_sided(trace, turns, order));
            let sizes = [size(closed), size(ours), size([ours[0] - closed[0], ours[1] - closed[1]])];
            largest = std::array::from_fn(|k| larger(largest[k], sizes[k]));
        }
        let [closed, ours, off] = largest;
        // What is not a number is listed too.
        let is_rounding = larger(closed, ours) <= LISTED * scale;
        (!is_rounding).then(|| CrossRow::held(name, unit, Some(order), [closed, ours, off, scale], bar))
    });
    rows.collect()
}

/// Complex mean of `e^{-i order theta}` times `count` real values over `turns` revolutions: half the amplitude of that order.
pub(crate) fn order_of(values: impl Iterator<Item = f64>, count: usize, turns: f64, order: f64) -> Complex64 {
    let step = order * TAU * turns / count as f64;
    let terms = values.enumerate().map(|(k, value)| value * Complex64::cis(-step * k as f64));
    terms.sum::<Complex64>() / count as f64
}
