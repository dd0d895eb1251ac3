//! A complex stiffness over frequency as springs and dashpots, which a run in time can use: a generalised Maxwell chain.
//!
//! ```text
//! K*(w) = K_0 + SUM over branches of K_j i w / (i w + r_j)            at most four branches, K_0 and K_j not negative
//! in time   F = K_0 x + SUM K_j (x - q_j)      q_j' = r_j (x - q_j)
//! stored    1/2 K_0 x^2 + SUM 1/2 K_j (x - q_j)^2                     lost   SUM r_j K_j (x - q_j)^2
//! ```
//! A loss factor that is the same at all frequencies, with a stiffness that is, too, would answer before its cause (Kramers, Kronig). Within a band a chain comes close to
//! it, with an error in proportion to the loss factor that grows with the width of the band; beyond the band it is another spring, softer at rest.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

/// Most branches.
pub const MOST_BRANCHES: usize = 4;

/// Frequencies of the fit.
const FREQUENCIES: usize = 41;

/// How far beyond either end of the band the rates of the outer branches may lie, as powers of ten.
const BEYOND: [f64; 7] = [-0.3, 0.0, 0.3, 0.6, 1.0, 1.4, 2.0];

/// Springs and dashpots along one direction.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MaxwellChain {
    /// Stiffness at rest [N/m].
    pub at_rest: f64,
    /// Stiffness [N/m] and rate of relaxation [1/s] of every branch.
    pub branches: Vec<[f64; 2]>,
    /// Largest departure from the complex stiffness over the band, over its size there.
    pub error: f64,
}

impl MaxwellChain {
    /// The chain next to `stiffness` [N/m] at angular frequencies of `band` [rad/s], by least squares of the relative departures.
    pub fn fit(stiffness: impl Fn(f64) -> Complex64, band: [f64; 2]) -> MaxwellChain {
        let [low, high] = band;
        let at = |k: usize| low * (high / low).powf(k as f64 / (FREQUENCIES - 1) as f64);
        let points: Vec<(f64, Complex64)> =
            (0..FREQUENCIES).map(|k| (at(k), stiffness(at(k)))).filter(|(_, k)| k.norm() > 0.0).collect();
        if points.is_empty() {
            return MaxwellChain::default();
        }
        let mut best = MaxwellChain { error: f64::INFINITY, ..MaxwellChain::default() };
        for below in BEYOND {
            for above in BEYOND {
                let (first, last) = (low * 10f64.powf(-below), high * 10f64.powf(above));
                let rates: [f64; MOST_BRANCHES] = std::array::from_fn(|j| {
                    first * (last / first).powf(j as f64 / (MOST_BRANCHES - 1) as f64)
                });
                if let Some(found) = with_rates(&points, rates).filter(|found| found.error < best.error) {
                    best = found;
                }
            }
        }
        best
    }

    /// Its complex stiffness at an angular frequency [rad/s].
    pub fn stiffness(&self, frequency: f64) -> Complex64 {
        let branch = |[stiffness, rate]: &[f64; 2]| *stiffness * share(frequency, *rate);
        self.at_rest + self.branches.iter().map(branch).sum::<Complex64>()
    }
}

/// `i w / (i w + r)`.
fn share(frequency: f64, rate: f64) -> Complex64 {
    let turning = Complex64::new(0.0, frequency);
    turning / (turning + rate)
}

/// The chain with these rates: least squares over stiffnesses that are not negative, by trying every choice of those that vanish.
fn with_rates(points: &[(f64, Complex64)], rates: [f64; MOST_BRANCHES]) -> Option<MaxwellChain> {
    let columns = MOST_BRANCHES + 1;
    let part = |row: usize, column: usize| {
        let (frequency, wanted) = points[row / 2];
        let value = if column == 0 { Complex64::ONE } else { share(frequency, rates[column - 1]) };
        (if row.is_multiple_of(2) { value.re } else { value.im }) / wanted.norm()
    };
    let matrix = DMatrix::from_fn(2 * points.len(), columns, part);
    let right = DVector::from_fn(2 * points.len(), |row, _| {
        let wanted = points[row / 2].1;
        (if row.is_multiple_of(2) { wanted.re } else { wanted.im }) / wanted.norm()
    });
    let (normal, load) = (matrix.transpose() * &matrix, matrix.transpose() * &right);
    let mut best: Option<(f64, DVector<f64>)> = None;
    for choice in 1..1u32 << columns {
        let chosen: Vec<usize> = (0..columns).filter(|column| choice >> column & 1 == 1).collect();
        let own = DMatrix::from_fn(chosen.len(), chosen.len(), |i, j| normal[(chosen[i], chosen[j])]);
        let Some(factors) = own.cholesky() else { continue };
        let found = factors.solve(&DVector::from_fn(chosen.len(), |i, _| load[chosen[i]]));
        if !found.iter().all(|value| *value >= 0.0) {
            continue;
        }
        let mut full = DVector::zeros(columns);
        chosen.iter().zip(found.iter()).for_each(|(column, value)| full[*column] = *value);
        let off = (&matrix * &full - &right).norm_squared();
        if best.as_ref().is_none_or(|(least, _)| off < *least) {
            best = Some((off, full));
        }
    }
    let (_, found) = best?;
    let branches = rates.iter().zip(found.iter().skip(1)).filter(|(_, stiffness)| **stiffness > 0.0);
    let mut chain = MaxwellChain {
        at_rest: found[0],
        branches: branches.map(|(rate, stiffness)| [*stiffness, *rate]).collect(),
        error: 0.0,
    };
    let off = points
        .iter()
        .map(|(frequency, wanted)| (chain.stiffness(*frequency) - wanted).norm() / wanted.norm());
    chain.error = off.fold(0.0, f64::max);
    Some(chain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_found_again() {
        let own = MaxwellChain {
            at_rest: 2e5,
            branches: vec![[5e4, 100.0], [8e4, 100.0 * 10f64.powf(0.5)], [3e4, 1000.0]],
            error: 0.0,
        };
        // Rates of the trial at the ends of the band and log-equally between.
        let wanted = |w: f64| 2e5 + 1e5 * share(w, 100.0) + 4e4 * share(w, 1000.0);
        let found = MaxwellChain::fit(wanted, [100.0, 1000.0]);
        assert!(found.error < 1e-9, "{found:?}");
        assert!((found.at_rest - 2e5).abs() < 1e-3 * 2e5);
        let found = MaxwellChain::fit(|w| own.stiffness(w), [100.0, 1000.0]);
        assert!(found.error < 2e-3, "{found:?}");
    }

    #[test]
    fn a_constant_loss_factor_is_met_within_a_band() {
        let error = |ratio: f64, loss: f64| {
            MaxwellChain::fit(|_| 3e5 * Complex64::new(1.0, loss), [60.0, 60.0 * ratio]).error
        };
        let (narrow, wide, weak) = (error(4.0, 0.1), error(16.0, 0.1), error(16.0, 0.02));
        assert!(narrow < 0.02 && wide > narrow && wide < 0.1, "{narrow} {wide}");
        assert!((weak / wide - 0.2).abs() < 0.05, "in proportion to the loss: {weak} {wide}");
    }

    #[test]
    fn dashpots_in_time_are_the_complex_stiffness() {
        let chain = MaxwellChain::fit(|_| 3e5 * Complex64::new(1.0, 0.2), [60.0, 480.0]);
        for frequency in [60.0, 150.0, 480.0] {
            // q' = r (x - q) under x = cos(w t) by Heun's rule, until what was at the start is gone.
            let (steps, periods) = (4000, 60);
            let h = std::f64::consts::TAU / frequency / f64::from(steps);
            let mut relaxed = vec![0.0; chain.branches.len()];
            let mut found = Complex64::ZERO;
            for k in 0..steps * periods {
                let phase = |k: i32| (frequency * h * f64::from(k)).cos();
                let (now, next) = (phase(k), phase(k + 1));
                if k >= steps * (periods - 1) {
                    let each = chain.branches.iter().zip(&relaxed);
                    let force = chain.at_rest * now + each.map(|([own, _], q)| own * (now - q)).sum::<f64>();
                    let turn = Complex64::cis(-frequency * h * f64::from(k));
                    found += 2.0 / f64::from(steps) * force * turn;
                }
                for (q, [_, rate]) in relaxed.iter_mut().zip(&chain.branches) {
                    let slope = rate * (now - *q);
                    let then = rate * (next - (*q + h * slope));
                    *q += 0.5 * h * (slope + then);
                }
            }
            let wanted = chain.stiffness(frequency);
            assert!((found - wanted).norm() < 1e-3 * wanted.norm(), "{frequency}: {found} {wanted}");
            let given = 3e5 * Complex64::new(1.0, 0.2);
            assert!((found - given).norm() < (chain.error + 1e-3) * given.norm(), "{frequency}: {found}");
        }
    }

    #[test]
    fn a_spring_without_loss_stays_one() {
        let found = MaxwellChain::fit(|_| Complex64::new(1e5, 0.0), [50.0, 400.0]);
        assert!(found.error < 1e-12 && (found.at_rest - 1e5).abs() < 1e-6);
        assert!(MaxwellChain::fit(|_| Complex64::ZERO, [50.0, 400.0]).branches.is_empty());
    }
}
