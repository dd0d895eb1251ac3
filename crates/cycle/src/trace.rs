//! Measured pressures from CSV: read, checked, made periodic.

mod closing;
mod column;
mod fault;
mod firing;
mod options;
mod table;
mod torque;

pub use fault::{TraceError, TraceFault, trace_codes};
pub use firing::check_firing;
pub use options::{TraceOptions, TracePlace};
pub use torque::{MOST_HARMONICS, read_torque};

use closing::{Closed, closed};
use column::check_pressures;
use lanchester_results::PeriodicCurve;
use serde::Serialize;

/// A file of pressures as curves.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MeasuredTrace {
    /// One for each column of pressure: its heading, its absolute pressure [Pa] over the angle since firing top dead centre.
    pub columns: Vec<(String, PeriodicCurve)>,
    /// What was mended or looks odd.
    pub warnings: Vec<String>,
}

/// Reads a file of pressures: CSV with a header that names the angle and each pressure with its unit (`theta [deg], p [bar]`).
///
/// Columns are parted by commas, semicolons or tabs; lines that begin with `#` are comments. Angles rise, in any steps, from any angle, over one
/// whole cycle, with or without the first sample again at its end. Between the samples the pressure is the periodic cubic spline.
///
/// # Errors
/// [`TraceError`] with the line, what was needed and what was got.
pub fn read_trace(text: &str, options: &TraceOptions) -> Result<MeasuredTrace, TraceError> {
    let fault =
        |(line, fault): (Option<u64>, TraceFault)| TraceError { file: options.name.to_string(), line, fault };
    let table = table::read(text, table::Holds::Pressure).map_err(fault)?;
    column::check_angles(&table, options.cycle).map_err(fault)?;
    let mut trace = MeasuredTrace { columns: Vec::new(), warnings: Vec::new() };
    for (heading, values) in table.columns {
        let mut pressures: Vec<f64> = values;
        if options.gauge {
            for pressure in &mut pressures {
                *pressure += options.ambient_pressure;
            }
        }
        let mut said =
            check_pressures(&heading, &pressures, options).map_err(|found| fault((None, found)))?;
        let Closed { knots, values, warning } = closed(&heading, &table.angles, pressures, options.cycle)
            .map_err(|found| fault((None, found)))?;
        said.extend(warning);
        let knots = knots.into_iter().map(|angle| angle - options.top_dead_centre).collect();
        let curve = PeriodicCurve::through(options.cycle, knots, &values)
            .map_err(|error| fault((None, TraceFault::Curve(error))))?;
        let [(least, angle), _] = curve.extremes();
        if least <= 0.0 {
            let degrees = (angle + options.top_dead_centre).to_degrees();
            return Err(fault((None, TraceFault::TooCoarse { column: heading, degrees })));
        }
        trace.warnings.extend(said.into_iter().map(|warning| format!("{}: {warning}", options.name)));
        trace.columns.push((heading, curve));
    }
    Ok(trace)
}

/// Pressure at a speed from those at measured speeds: linear between neighbours, held beyond the first and the last. The flag
/// says that it is held.
///
/// `measured` holds speed [rad/s] and curve, rising in speed, at least one; a speed of `None` stands for all speeds.
///
/// # Errors
/// [`CurveError`](lanchester_results::CurveError) where there is none, or periods differ.
pub fn at_speed(
    measured: &[(Option<f64>, &PeriodicCurve)],
    speed: f64,
) -> Result<(PeriodicCurve, bool), lanchester_results::CurveError> {
    let above = measured.iter().position(|(own, _)| own.is_none_or(|own| own >= speed));
    let weights: Vec<(f64, &PeriodicCurve)> = match above {
        None => measured.last().map(|(_, curve)| (1.0, *curve)).into_iter().collect(),
        Some(0) => vec![(1.0, measured[0].1)],
        Some(above) => {
            let (low, high) = (measured[above - 1], measured[above]);
            let (from, to) = (low.0.unwrap_or(speed), high.0.unwrap_or(speed));
            let share = if to > from { (speed - from) / (to - from) } else { 1.0 };
            if share == 1.0 { vec![(1.0, high.1)] } else { vec![(1.0 - share, low.1), (share, high.1)] }
        }
    };
    let first = measured.first().and_then(|(speed, _)| *speed).unwrap_or(speed);
    let last = measured.last().and_then(|(speed, _)| *speed).unwrap_or(speed);
    let beyond = speed < first * (1.0 - SAME_SPEED) || speed > last * (1.0 + SAME_SPEED);
    match weights.as_slice() {
        [(_, only)] => Ok(((*only).clone(), beyond)),
        _ => Ok((PeriodicCurve::sum(&weights)?, beyond)),
    }
}

/// Speeds that differ by less than this share are one.
const SAME_SPEED: f64 = 1e-9;
