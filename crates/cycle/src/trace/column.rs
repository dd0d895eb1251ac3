//! Whether angles make a cycle and pressures can be those of an engine.

use super::fault::TraceFault;
use super::options::{TraceOptions, TracePlace};
use super::table::Table;

/// Fewest samples of a cycle.
const FEWEST: usize = 36;
/// Widest step from sample to sample [rad]: 10 deg.
const WIDEST: f64 = std::f64::consts::PI / 18.0;
/// Share of a cycle within which its end and its beginning are one angle.
pub(super) const SAME: f64 = 1e-6;
/// Least absolute pressure [Pa] that a cylinder or a crankcase may have, and below which it looks odd.
const LEAST: f64 = 5e3;
const ODD: f64 = 2e4;
/// Largest pressures [Pa] in cylinder and crankcase.
const LARGEST: [f64; 2] = [5e7, 2e6];
/// Gauge pressure [Pa] below which it falls somewhere in most engines.
const USUAL_GAUGE: f64 = 5e4;
/// Peaks below this absolute pressure [Pa] are odd.
const LOW_PEAK: f64 = 3e5;

/// The angles must rise and make one cycle without gaps.
pub(super) fn check_angles(table: &Table, cycle: f64) -> Result<(), (Option<u64>, TraceFault)> {
    let angles = &table.angles;
    let (Some(&first), Some(&last)) = (angles.first(), angles.last()) else {
        return Err((None, TraceFault::TooFew { got: 0, needed: FEWEST }));
    };
    if angles.len() < FEWEST {
        return Err((None, TraceFault::TooFew { got: angles.len(), needed: FEWEST }));
    }
    if angles.windows(2).all(|pair| pair[1] < pair[0]) {
        let (from, to) = (first.to_degrees(), last.to_degrees());
        return Err((Some(table.lines[0]), TraceFault::Falling { from, to }));
    }
    if let Some(at) = (1..angles.len()).find(|at| angles[*at] <= angles[at - 1]) {
        let (angle, before) = (angles[at].to_degrees(), angles[at - 1].to_degrees());
        return Err((Some(table.lines[at]), TraceFault::NotRising { angle, before }));
    }
    let span = last - first;
    if span > cycle * (1.0 + SAME) {
        let fault = TraceFault::TooLong { span: span.to_degrees(), cycle: cycle.to_degrees() };
        return Err((table.lines.last().copied(), fault));
    }
    // A step within rounding of the widest is no gap.
    let most = WIDEST * (1.0 + SAME);
    let gap = |from: f64, to: f64| TraceFault::Gap {
        from: from.to_degrees(),
        to: to.to_degrees(),
        cycle: cycle.to_degrees(),
        most: WIDEST.to_degrees(),
    };
    if let Some(at) = (1..angles.len()).find(|at| angles[*at] - angles[at - 1] > most) {
        return Err((Some(table.lines[at]), gap(angles[at - 1], angles[at])));
    }
    if cycle - span > most {
        return Err((table.lines.last().copied(), gap(last, first + cycle)));
    }
    Ok(())
}

/// Absolute pressures [Pa] that no engine has are refused, odd ones told.
pub(super) fn check_pressures(
    heading: &str,
    pressures: &[f64],
    options: &TraceOptions,
) -> Result<Vec<String>, TraceFault> {
    let least = pressures.iter().copied().fold(f64::INFINITY, f64::min);
    let peak = pressures.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let shown =
        |pressure: f64| (if options.gauge { pressure - options.ambient_pressure } else { pressure }) / 1e5;
    let column = || heading.to_string();
    // A gauge pressure only has to lie above a vacuum; absolute ones near 0 are gauge pressures.
    if least <= if options.gauge { 0.0 } else { LEAST } {
        return Err(TraceFault::TooLow { column: column(), least: 1e5 * shown(least), gauge: options.gauge });
    }
    let most = LARGEST[usize::from(options.place == TracePlace::Crankcase)];
    if peak > most {
        return Err(TraceFault::TooHigh { column: column(), peak, most });
    }
    let mut warnings = Vec::new();
    if !options.gauge && least < ODD {
        warnings.push(format!(
            "\"{heading}\" falls to {:.3} bar absolute: are these gauge pressures?",
            shown(least)
        ));
    }
    if options.gauge && least - options.ambient_pressure > USUAL_GAUGE {
        warnings.push(format!(
            "\"{heading}\" never falls below {:.3} bar gauge: are these absolute pressures?",
            shown(least)
        ));
    }
    if options.place == TracePlace::Cylinder && peak < LOW_PEAK {
        warnings.push(format!("\"{heading}\" peaks at {:.3} bar only: is its unit right?", shown(peak)));
    }
    Ok(warnings)
}
