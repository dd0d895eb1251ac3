//! The end of a cycle must meet its beginning.

use super::column::SAME;
use super::fault::TraceFault;

/// Share of the range of pressure that is mended at most.
const MOST: f64 = 0.02;
/// Share below which nothing is said.
const SILENT: f64 = 1e-6;

/// One period of samples that meet at its ends.
#[derive(Debug)]
pub(super) struct Closed {
    /// Angles [rad], without the end.
    pub(super) knots: Vec<f64>,
    pub(super) values: Vec<f64>,
    /// What was mended.
    pub(super) warning: Option<String>,
}

/// Samples of one period without its end.
///
/// Where the file repeats its first angle at its end, the difference of the two values is spread evenly over the cycle; where it does not, both ends
/// are carried on in straight lines and must meet.
pub(super) fn closed(
    heading: &str,
    angles: &[f64],
    mut values: Vec<f64>,
    cycle: f64,
) -> Result<Closed, TraceFault> {
    let mut knots = angles.to_vec();
    let end = knots.len() - 1;
    let span = knots[end] - knots[0];
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let range = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - least;
    let repeats = (cycle - span).abs() <= SAME * cycle;
    let by = if repeats {
        values[end] - values[0]
    } else {
        let slope = |from: usize, to: usize| (values[to] - values[from]) / (knots[to] - knots[from]);
        values[end] - values[0] + (cycle - span) * (slope(end - 1, end) + slope(0, 1)) / 2.0
    };
    let share = if range > 0.0 { by.abs() / range } else { 0.0 };
    if share > MOST {
        return Err(TraceFault::NotClosed { column: heading.to_string(), by, share, most: MOST });
    }
    if !repeats {
        return Ok(Closed { knots, values, warning: None });
    }
    for (knot, value) in knots.iter().zip(&mut values) {
        *value -= by * ((knot - angles[0]) / span - 0.5);
    }
    knots.pop();
    values.pop();
    let warning = (share > SILENT).then(|| {
        format!(
            "\"{heading}\" does not close by {:.4} bar ({:.3} % of its range), which is spread over the cycle",
            by / 1e5,
            100.0 * share
        )
    });
    Ok(Closed { knots, values, warning })
}
