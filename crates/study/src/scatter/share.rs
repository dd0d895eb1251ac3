//! Which tolerance the scatter comes from.

use crate::scatter::request::ScatterRequest;
use crate::scatter::result::Contribution;
use crate::scatter::sampler::Sampler;
use rayon::prelude::*;

/// Most samples from which shares of the variance are estimated.
pub(crate) const SHARED: u64 = 1 << 16;

/// Cells of each variable for these shares, of so many samples each: what varies within a cell is lost, with 128 cells
/// less than half a percent of a share.
const MOST_CELLS: usize = 128;
const PER_CELL: usize = 64;

/// Cells of each variable with so many samples.
fn cell_count(samples: usize) -> usize {
    (samples / PER_CELL).clamp(2, MOST_CELLS)
}

/// First-order shares of the variance, by output, then tolerance, from the outputs `values` of the samples from `first` on.
///
/// The samples fall into cells of equal probability by each variable; the variance of the cells' means, less what chance
/// alone would give, is the variable's (correlation ratio).
pub(crate) fn shares(
    request: &ScatterRequest,
    sampler: &Sampler,
    first: u64,
    values: &[Vec<f64>],
) -> Vec<Vec<Contribution>> {
    let count = values.first().map_or(0, Vec::len);
    let cell_count = cell_count(count);
    let means: Vec<f64> = values.iter().map(|v| v.iter().sum::<f64>() / count as f64).collect();
    let totals: Vec<f64> =
        values.iter().zip(&means).map(|(v, mean)| v.iter().map(|x| (x - mean).powi(2)).sum()).collect();
    let by_variable: Vec<Vec<f64>> = sampler
        .draws
        .par_iter()
        .map(|(_, stream, _)| {
            let mut sums = vec![vec![0.0; cell_count]; values.len()];
            let mut counts = vec![0u32; cell_count];
            for sample in 0..count {
                let cell = (stream.uniform(first + sample as u64) * cell_count as f64) as usize;
                counts[cell] += 1;
                for (sum, value) in sums.iter_mut().zip(values) {
                    sum[cell] += value[sample];
                }
            }
            let share = |place: usize| {
                if totals[place] <= 0.0 || count <= cell_count {
                    return 0.0;
                }
                let cells = sums[place].iter().zip(&counts).filter(|(_, n)| **n > 0);
                let between: f64 =
                    cells.map(|(sum, n)| (sum / f64::from(*n) - means[place]).powi(2) * f64::from(*n)).sum();
                let within = (totals[place] - between) / (count - cell_count) as f64;
                (between - (cell_count - 1) as f64 * within) / totals[place]
            };
            (0..values.len()).map(share).collect()
        })
        .collect();
    (0..values.len())
        .map(|place| {
            let blank = |tolerance| Contribution { tolerance, share: 0.0, error: 0.0 };
            let mut shares: Vec<Contribution> = (0..request.tolerances.len()).map(blank).collect();
            for (variable, own) in sampler.variables.iter().zip(&by_variable) {
                let (share, samples) = (own[place], count as f64);
                let sum = &mut shares[variable.tolerance];
                sum.share += share;
                // Of a squared correlation, and of what chance gives to cells.
                sum.error += 4.0 * share.max(0.0) * (1.0 - share).powi(2) / samples
                    + 2.0 * (cell_count - 1) as f64 / (samples * samples);
            }
            shares.iter_mut().for_each(|share| share.error = share.error.sqrt());
            shares
        })
        .collect()
}
