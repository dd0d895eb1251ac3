//! The worst combination of deviations: what cannot be exceeded, and what is reached.

use crate::scatter::error::ScatterError;
use crate::scatter::farthest::Farthest;
use crate::scatter::request::{Output, ScatterRequest};
use crate::scatter::sampler::Sampler;
use crate::scatter::stream::Stream;
use lanchester_numerics::{LANES, Lanes};
use serde::Serialize;

/// Corners from which the search goes uphill.
const STARTS: u64 = 16;

/// The worst case of one output.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WorstCase {
    /// Which.
    pub output: Output,
    /// Of the nominal engine.
    pub nominal: f64,
    /// A loose upper bound: no engine within the tolerances exceeds this. It is the nominal value and all that every part may be off, in whatever
    /// direction, so that it is far from `attained` where the parts cannot all push one way.
    pub bound: f64,
    /// What the deviations of `deviations` reach: a corner of the tolerances of which no single deviation can be
    /// turned to its other end with gain. The worst case lies between this and `bound`.
    pub attained: f64,
    /// Deviation of every variable, tolerance by tolerance and part by part, in SI units.
    pub deviations: Vec<f64>,
}

/// The worst case of every output of the request; samples, limits and percentiles play no part.
///
/// # Errors
/// As [`crate::scatter::scatter`].
pub fn worst_cases(request: &ScatterRequest) -> Result<Vec<WorstCase>, ScatterError> {
    // All mistakes of the request first, then each output by itself.
    Sampler::new(request)?;
    let cases = request.outputs.iter().map(|&output| {
        let alone = ScatterRequest { outputs: vec![output], limits: Vec::new(), ..request.clone() };
        let sampler = Sampler::new(&alone)?;
        let nominal = sampler.nominal()[0];
        let (attained, deviations) = climb(&alone, &sampler);
        Ok(WorstCase { output, nominal, bound: nominal + farthest(&sampler, output), attained, deviations })
    });
    cases.collect()
}

/// How far an output may be from its nominal value at most.
fn farthest(sampler: &Sampler, output: Output) -> f64 {
    let quantity = usize::from(output.is_couple());
    let farthest = Farthest::of(&sampler.model);
    match output {
        Output::Force { order } | Output::Couple { order } => {
            farthest.order(order as usize - 1)[quantity].iter().sum()
        }
        Output::ForceSense { order, sense } | Output::CoupleSense { order, sense } => {
            farthest.order(order as usize - 1)[quantity][sense as usize]
        }
        Output::PeakForce | Output::PeakCouple => farthest.peak()[quantity],
    }
}

/// The best corner that turning one deviation at a time leads to, from several corners.
fn climb(request: &ScatterRequest, sampler: &Sampler) -> (f64, Vec<f64>) {
    let count = sampler.variables.len();
    let mut buffers = sampler.buffers();
    let mut values = [Lanes::ZERO];
    let mut lanes: Vec<Lanes> = vec![Lanes::ZERO; count];
    let mut best = (f64::NEG_INFINITY, Vec::new());
    for start in 0..STARTS {
        let mut corner: Vec<f64> = sampler
            .variables
            .iter()
            .enumerate()
            .map(|(index, variable)| {
                let up = Stream::new(request.seed, index).uniform(u64::MAX - start) < 0.5;
                if up { variable.half_width } else { -variable.half_width }
            })
            .collect();
        let mut reached = f64::NEG_INFINITY;
        loop {
            // The corner itself, then each variable turned, eight engines at a time.
            let mut gain: Option<(f64, Option<usize>)> = None;
            let mut next = 0;
            while next <= count {
                let turned: Vec<usize> = (next..(next + LANES).min(count + 1)).collect();
                for (index, lane) in lanes.iter_mut().enumerate() {
                    *lane = Lanes::all(corner[index]);
                    for (k, &turned) in turned.iter().enumerate() {
                        if turned == index + 1 {
                            lane[k] = -corner[index];
                        }
                    }
                }
                sampler.outputs_of(&lanes, &mut buffers, &mut values);
                for (k, &turned) in turned.iter().enumerate() {
                    let value = values[0][k];
                    if gain.is_none_or(|(most, _)| value > most) {
                        gain = Some((value, turned.checked_sub(1)));
                    }
                }
                next += LANES;
            }
            match gain {
                Some((value, Some(index))) if value > reached * (1.0 + 1e-12) => {
                    corner[index] = -corner[index];
                    reached = value;
                }
                Some((value, _)) => {
                    reached = reached.max(value);
                    break;
                }
                None => break,
            }
        }
        if reached > best.0 {
            best = (reached, corner);
        }
    }
    best
}
