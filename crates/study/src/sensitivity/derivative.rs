//! Exact derivatives of peaks and orders of the loads.

use super::input::Input;
use super::output::{Component, Output};
use super::train::{DualLoads, Train};
use lanchester_mechanism::{LoadError, LoadRequest, Mechanism};
use lanchester_model::Engine;
use num_dual::Dual64;
use serde::Serialize;
use std::f64::consts::TAU;

/// Angles in one revolution at which orders are taken: the loads of the highest order that is left are rounding.
const ANGLES: usize = 256;
/// Angles in one revolution between which peaks are looked for.
const SCAN: usize = 720;
/// Peaks that differ by less than this share are one height.
const SAME_HEIGHT: f64 = 1e-9;
/// Share of the derivative of a vector by which its slope is off since its peak is: a place is known to the root of the last digit.
const ROUNDING: f64 = 1e-6;
/// Halvings of an interval around a peak by the golden section.
const STEPS: usize = 60;

/// Derivative of an output by an input, in SI units.
///
/// A size that is zero grows whichever way the input goes, and of two equal peaks one may grow while the other falls: there the derivatives
/// on both sides differ.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Slope {
    /// For a larger input.
    pub up: f64,
    /// For a smaller input.
    pub down: f64,
}

impl Slope {
    /// Of the sum of two outputs.
    fn plus(self, other: Slope) -> Slope {
        Slope { up: self.up + other.up, down: self.down + other.down }
    }

    /// Of the size of a vector; of one that vanishes the size of its derivative.
    fn of_size(parts: &[Dual64], nothing: f64) -> Slope {
        let size = parts.iter().map(|part| part.re * part.re).sum::<f64>().sqrt();
        if size <= nothing {
            let growth = parts.iter().map(|part| part.eps * part.eps).sum::<f64>().sqrt();
            return Slope { up: growth, down: -growth };
        }
        let slope = parts.iter().map(|part| part.re * part.eps).sum::<f64>() / size;
        Slope { up: slope, down: slope }
    }

    /// Of the largest of outputs that are equal. Slopes that differ by no more than peaks can be placed are one.
    fn of_largest(slopes: &[(Slope, f64)]) -> Slope {
        let close = ROUNDING * slopes.iter().map(|(_, growth)| *growth).fold(0.0, f64::max);
        let up = slopes.iter().map(|(slope, _)| slope.up).reduce(f64::max).unwrap_or(0.0);
        let down = slopes.iter().map(|(slope, _)| slope.down).reduce(f64::min).unwrap_or(0.0);
        if up - down <= close {
            Slope { up: (up + down) / 2.0, down: (up + down) / 2.0 }
        } else {
            Slope { up, down }
        }
    }
}

/// Derivatives of `outputs` of an engine at `speed` [rad/s] by `inputs`: by output, then by input.
///
/// A peak is differentiated where it stands (book, eq. 32.2), an order through its integral (eq. 32.3).
///
/// # Errors
/// [`LoadError`] where the loads cannot be computed.
pub fn derivatives(
    engine: &Engine,
    speed: f64,
    outputs: &[Output],
    inputs: &[Input],
) -> Result<Vec<Vec<Slope>>, LoadError> {
    let request = LoadRequest { speed: Some(speed), samples: 1, ..LoadRequest::default() };
    let period = Mechanism::new(engine, &request)?.period();
    let Some(&first) = inputs.first() else { return Ok(vec![Vec::new(); outputs.len()]) };
    let plain = Train::new(engine, speed, first);
    let places: Vec<Places> =
        outputs.iter().map(|output| Places::of(&plain, *output, engine, speed, period)).collect();
    let count = ANGLES * (period / TAU).round() as usize;
    let by_input: Vec<Vec<Slope>> = inputs
        .iter()
        .map(|&input| {
            let train = Train::new(engine, speed, input);
            let needs_all = places.iter().any(|places| places.peaks.is_empty());
            let all: Vec<(f64, DualLoads)> = match needs_all {
                true => (0..count)
                    .map(|k| period * k as f64 / count as f64)
                    .map(|theta| (theta, train.loads(theta)))
                    .collect(),
                false => Vec::new(),
            };
            outputs.iter().zip(&places).map(|(output, places)| slope(&train, *output, places, &all)).collect()
        })
        .collect();
    Ok((0..outputs.len()).map(|place| by_input.iter().map(|slopes| slopes[place]).collect()).collect())
}

/// Where the peaks of an output stand, and what is nothing to it.
struct Places {
    /// Angles [rad]; none for an order, and for a load that vanishes.
    peaks: Vec<f64>,
    nothing: f64,
}

impl Places {
    fn of(train: &Train<'_>, output: Output, engine: &Engine, speed: f64, period: f64) -> Places {
        let nothing = output.nothing(engine, speed);
        if output.order.is_some() {
            return Places { peaks: Vec::new(), nothing };
        }
        let size = |theta: f64| {
            output.load.parts(&train.loads(theta)).iter().map(|part| part.re * part.re).sum::<f64>().sqrt()
        };
        let count = SCAN * (period / TAU).round() as usize;
        let step = period / count as f64;
        let sizes: Vec<f64> = (0..count).map(|k| size(step * k as f64)).collect();
        let highest = sizes.iter().copied().fold(0.0f64, f64::max);
        if highest <= nothing {
            return Places { peaks: Vec::new(), nothing };
        }
        let mut peaks: Vec<(f64, f64)> = (0..count)
            .filter(|&k| {
                let [before, after] = [sizes[(k + count - 1) % count], sizes[(k + 1) % count]];
                sizes[k] >= before && sizes[k] >= after && sizes[k] >= 0.99 * highest
            })
            .map(|k| highest_within(&size, step * (k as f64 - 1.0), step * (k as f64 + 1.0)))
            .collect();
        let best = peaks.iter().map(|peak| peak.1).fold(0.0f64, f64::max);
        peaks.retain(|peak| peak.1 >= best * (1.0 - SAME_HEIGHT));
        Places { peaks: peaks.into_iter().map(|peak| peak.0).collect(), nothing }
    }
}

/// Place and height of the highest point of a hill, by the golden section.
fn highest_within(size: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> (f64, f64) {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut inner = [to - golden * (to - from), from + golden * (to - from)];
    let mut heights = inner.map(size);
    for _ in 0..STEPS {
        if heights[0] >= heights[1] {
            to = inner[1];
            inner = [to - golden * (to - from), inner[0]];
            heights = [size(inner[0]), heights[0]];
        } else {
            from = inner[0];
            inner = [inner[1], from + golden * (to - from)];
            heights = [heights[1], size(inner[1])];
        }
    }
    let middle = (from + to) / 2.0;
    (middle, size(middle))
}

fn slope(train: &Train<'_>, output: Output, places: &Places, all: &[(f64, DualLoads)]) -> Slope {
    let at = |loads: &DualLoads| {
        let parts = output.load.parts(loads);
        let growth = parts.iter().map(|part| part.eps * part.eps).sum::<f64>().sqrt();
        (Slope::of_size(&parts, places.nothing), growth)
    };
    if let Some(order) = output.order {
        let none = Slope { up: 0.0, down: 0.0 };
        let components = output.load.components(order, all);
        return components
            .iter()
            .map(|Component { re, im }| Slope::of_size(&[*re, *im], places.nothing))
            .fold(none, Slope::plus);
    }
    let peaks = places.peaks.iter().map(|&theta| at(&train.loads(theta)));
    let everywhere = all.iter().filter(|_| places.peaks.is_empty()).map(|(_, loads)| at(loads));
    Slope::of_largest(&peaks.chain(everywhere).collect::<Vec<_>>())
}
