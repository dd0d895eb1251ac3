//! What both integrators share: the course between forced stops, the first step, norms.

use crate::{Outcome, Settings, System};

/// The places at which steps must end, in the sense of the run, the end last.
pub(crate) fn course(from: f64, end: f64, stops: &[f64]) -> Vec<f64> {
    let sense = if end >= from { 1.0 } else { -1.0 };
    let mut places: Vec<f64> =
        stops.iter().copied().filter(|s| sense * (s - from) > 0.0 && sense * (end - s) > 0.0).collect();
    places.sort_by(|a, b| (sense * a).total_cmp(&(sense * b)));
    places.push(end);
    places.dedup();
    places
}

/// Whether two places cannot be told apart by a step.
pub(crate) fn together(a: f64, b: f64) -> bool {
    (b - a).abs() <= 8.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// Root mean square of the components against their scales.
pub(crate) fn norm(settings: &Settings, values: &[f64], state: &[f64]) -> f64 {
    let sum: f64 = values
        .iter()
        .zip(state)
        .enumerate()
        .map(|(i, (value, y))| (value / settings.scale(i, y.abs())).powi(2))
        .sum();
    (sum / values.len().max(1) as f64).sqrt()
}

/// The first component that is no finite number.
pub(crate) fn infinite(values: &[f64]) -> Option<Outcome> {
    values.iter().position(|v| !v.is_finite()).map(|component| Outcome::NotFinite { component })
}

/// A first step whose error of order `order` will be near the tolerance. Source: Hairer, Norsett, Wanner I, section II.4.
pub(crate) fn first_step(
    system: &mut impl System,
    settings: &Settings,
    (t, limit): (f64, f64),
    y: &[f64],
    slope: &[f64],
    order: f64,
) -> f64 {
    let sense = (limit - t).signum();
    let longest = (limit - t).abs().min(settings.longest_step);
    let (size, rate) = (norm(settings, y, y), norm(settings, slope, y));
    let short = if size < 1e-5 || rate < 1e-5 { 1e-6 } else { 0.01 * size / rate };
    let short = short.min(longest);
    let ahead: Vec<f64> = y.iter().zip(slope).map(|(y, f)| y + sense * short * f).collect();
    let mut change = vec![0.0; y.len()];
    system.derivative(t + sense * short, &ahead, &mut change);
    change.iter_mut().zip(slope).for_each(|(c, f)| *c -= f);
    let curvature = norm(settings, &change, y) / short;
    let most = if curvature.is_finite() { curvature.max(rate) } else { rate };
    let long = if most <= 1e-15 { (1e-3 * short).max(1e-6) } else { (0.01 / most).powf(1.0 / order) };
    sense * (100.0 * short).min(long).min(longest)
}
