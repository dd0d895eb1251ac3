//! Variance-based indices: which input the scatter of an output over the ranges comes from, alone and with all others.

use super::input::{Input, deviate_all};
use super::operating_point::OperatingPoint;
use super::output::Output;
use super::value::possible;
use crate::scatter::stream::Stream;
use rayon::prelude::*;
use serde::Serialize;

/// Indices of one output by one input, with their standard errors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Index {
    /// Share of the variance that would vanish if this input alone were known (Saltelli et al. 2010).
    pub first: f64,
    /// Its standard error.
    pub first_error: f64,
    /// Share of the variance that would be left if all other inputs were known (Jansen 1999).
    pub total: f64,
    /// Its standard error.
    pub total_error: f64,
}

/// Variance-based sensitivities.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sobol {
    /// Draws of each of the two tables; the engine is computed `inputs + 2` times for each.
    pub samples: u64,
    /// Seed of the draws.
    pub seed: u64,
    /// Draws left out since one of their engines cannot turn, or has a mass below nothing.
    pub impossible: u64,
    /// By output: mean and standard deviation over the ranges.
    pub spreads: Vec<[f64; 2]>,
    /// By output, then by input. Zero where the output does not vary.
    pub indices: Vec<Vec<Index>>,
}

/// Outputs of one draw: of the first table, of the second, and of the first with one column of the second.
struct Draw {
    first: Vec<f64>,
    second: Vec<f64>,
    mixed: Vec<Vec<f64>>,
}

/// The indices over ranges `half_widths` either way of the nominal values, in SI units.
pub(super) fn sobol(
    point: &OperatingPoint,
    outputs: &[Output],
    inputs: &[(Input, f64)],
    [samples, seed]: [u64; 2],
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Sobol {
    let streams = |table: usize| -> Vec<Stream> {
        (0..inputs.len()).map(|place| Stream::new(seed, 2 * place + table)).collect()
    };
    let tables = [streams(0), streams(1)];
    let draw = |sample: u64| -> Option<Draw> {
        if !goes_on() {
            return None;
        }
        let at = |choose: &dyn Fn(usize) -> usize| {
            let mut own = point.clone();
            let deviations = inputs.iter().enumerate().map(|(place, (input, half))| {
                let uniform = tables[choose(place)][place].uniform(sample);
                (*input, half * (2.0 * uniform - 1.0))
            });
            deviate_all(&mut own, deviations).ok()?;
            possible(&own, outputs)
        };
        let mixed = (0..inputs.len()).map(|input| at(&|place| usize::from(place == input)));
        Some(Draw { first: at(&|_| 0)?, second: at(&|_| 1)?, mixed: mixed.collect::<Option<_>>()? })
    };
    let draws: Vec<Draw> = (0..samples).into_par_iter().filter_map(draw).collect();
    let by_output = |place: usize| {
        let all = draws.iter().flat_map(|draw| [draw.first[place], draw.second[place]]);
        let count = 2.0 * draws.len() as f64;
        let mean = all.clone().sum::<f64>() / count;
        let variance = all.map(|value| (value - mean).powi(2)).sum::<f64>() / count;
        // Of the variance each draw has its part: a share is a ratio of sums.
        let spread = |draw: &Draw| {
            let [a, b] = [draw.first[place] - mean, draw.second[place] - mean];
            0.5 * (a * a + b * b)
        };
        let index = |input: usize| {
            let own = |draw: &Draw| [draw.first[place], draw.second[place], draw.mixed[input][place]];
            let first = share(&draws, spread, |draw| {
                let [a, b, mixed] = own(draw);
                (b - mean) * (mixed - a)
            });
            let total = share(&draws, spread, |draw| {
                let [a, _, mixed] = own(draw);
                (a - mixed).powi(2) / 2.0
            });
            Index { first: first[0], first_error: first[1], total: total[0], total_error: total[1] }
        };
        let none = Index { first: 0.0, first_error: 0.0, total: 0.0, total_error: 0.0 };
        let varies = variance > 1e-24 * mean * mean;
        let indices: Vec<Index> = (0..inputs.len()).map(|k| if varies { index(k) } else { none }).collect();
        ([mean, variance.sqrt()], indices)
    };
    let (spreads, indices) = (0..outputs.len()).map(by_output).unzip();
    Sobol { samples, seed, impossible: samples - draws.len() as u64, spreads, indices }
}

/// A share of the variance, and its standard error: of a ratio of sums to first order (Cochran 1977, eq. 2.46), the mean taken as known.
///
/// ```text
/// S = SUM n / SUM v        se = sqrt( SUM (n - S v)^2 / (N (N - 1)) ) / mean(v)
/// ```
fn share(draws: &[Draw], spread: impl Fn(&Draw) -> f64, of: impl Fn(&Draw) -> f64) -> [f64; 2] {
    let count = draws.len() as f64;
    let whole = draws.iter().map(&spread).sum::<f64>();
    let share = draws.iter().map(&of).sum::<f64>() / whole;
    let off = draws.iter().map(|draw| (of(draw) - share * spread(draw)).powi(2)).sum::<f64>();
    [share, (off / (count * (count - 1.0).max(1.0))).sqrt() / (whole / count)]
}
