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

/// A row for every order up to `max_order`, whole and in fractions of `turns`, of two traces: closed form, simulation.
pub(crate) fn order_rows(
    (name, unit): (&str, &str),
    traces: [&[Complex64]; 2],
    turns: f64,
    max_order: u32,
    scale: f64,
    bar: f64,
) -> Vec<CrossRow> {
    let count = (f64::from(max_order) * turns).round() as u32;
    let rows = (0..=count).filter_map(|k| {
        let order = f64::from(k) / turns;
        let [closed, ours] = traces.map(|trace| two_sided(trace, turns, order));
        let size = |parts: [Complex64; 2]| parts[0].norm() + parts[1].norm();
        let off = size([ours[0] - closed[0], ours[1] - closed[1]]);
        let listed = size(closed).max(size(ours)) > LISTED * scale;
        listed.then(|| CrossRow::held(name, unit, Some(order), [size(closed), size(ours), off, scale], bar))
    });
    rows.collect()
}

/// Complex mean of `e^{-i order theta}` times `count` real values over `turns` revolutions: half the amplitude of that order.
pub(crate) fn order_of(values: impl Iterator<Item = f64>, count: usize, turns: f64, order: f64) -> Complex64 {
    let step = order * TAU * turns / count as f64;
    let terms = values.enumerate().map(|(k, value)| value * Complex64::cis(-step * k as f64));
    terms.sum::<Complex64>() / count as f64
}
