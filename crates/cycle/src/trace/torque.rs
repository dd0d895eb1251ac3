//! A torque over the crank angle from CSV: read, checked, closed, as a sum of orders.

use super::closing::{Closed, closed};
use super::column::{SAME, check_angles};
use super::fault::{TraceError, TraceFault};
use super::table::{self, Holds};
use lanchester_model::{TorqueCurve, TorqueOrder};
use lanchester_results::PeriodicCurve;
use std::f64::consts::TAU;

/// Most harmonics of the period that are kept.
pub const MOST_HARMONICS: i32 = 64;

/// Harmonics below this share of the range of the samples are left out.
const LEAST: f64 = 1e-9;

/// Reads a file of torque: CSV with a header that names the angle of crankshaft 1 and the torque on it with their units (`theta [deg], torque [N m]`).
///
/// Columns, comments, angles and the end of the period are as in a file of pressures ([`super::read_trace`]). Between the samples the torque is the
/// periodic cubic spline; its harmonics up to [`MOST_HARMONICS`] are returned, with how far their sum departs from the samples. `period` [rad]: `None`
/// for as many whole revolutions as the angles span.
///
/// # Errors
/// [`TraceError`] with the line, what was needed and what was got.
pub fn read_torque(text: &str, name: &str, period: Option<f64>) -> Result<TorqueCurve, TraceError> {
    let fault = |(line, fault): (Option<u64>, TraceFault)| TraceError { file: name.to_string(), line, fault };
    let table = table::read(text, Holds::Torque).map_err(fault)?;
    let period = period.unwrap_or_else(|| whole_turns(&table.angles));
    check_angles(&table, period).map_err(fault)?;
    let Some((heading, samples)) = table.columns.into_iter().next() else {
        return Err(fault((None, TraceFault::Torques { got: 0 })));
    };
    let Closed { knots, values, .. } =
        closed(&heading, &table.angles, samples, period).map_err(|found| match found {
            TraceFault::NotClosed { by, share, .. } => {
                fault((None, TraceFault::TorqueNotClosed { by, share }))
            }
            other => fault((None, other)),
        })?;
    let curve = PeriodicCurve::through(period, knots.clone(), &values)
        .map_err(|error| fault((None, TraceFault::Curve(error))))?;
    let [least, most] = [f64::min, f64::max]
        .map(|pick: fn(f64, f64) -> f64| values.iter().copied().reduce(pick).unwrap_or(0.0));
    // A constant torque has no range.
    let range = if most > least { most - least } else { most.abs().max(f64::MIN_POSITIVE) };
    let mut orders = vec![TorqueOrder { order: 0.0, sin: 0.0, cos: curve.mean() }];
    for harmonic in 1..=MOST_HARMONICS {
        let share = curve.coefficient(harmonic);
        if share.norm() > LEAST * range {
            let order = f64::from(harmonic) * TAU / period;
            orders.push(TorqueOrder { order, sin: -2.0 * share.im, cos: 2.0 * share.re });
        }
    }
    let sum = |theta: f64| -> f64 {
        orders
            .iter()
            .map(|one| one.sin * (one.order * theta).sin() + one.cos * (one.order * theta).cos())
            .sum()
    };
    let off = knots.iter().zip(&values).map(|(theta, value)| (sum(*theta) - value).abs());
    let departure = off.fold(0.0, f64::max) / range;
    Ok(TorqueCurve { orders, departure })
}

/// The least whole number of revolutions that holds the angles [rad].
fn whole_turns(angles: &[f64]) -> f64 {
    let span = angles.last().copied().unwrap_or(0.0) - angles.first().copied().unwrap_or(0.0);
    TAU * (span / TAU - SAME).ceil().max(1.0)
}
