//! A complex stiffness over frequency as springs and dashpots, which a run in time can use: a generalised Maxwell chain.
//!
//! ```text
//! K*(w) = K_0 + i w C + SUM over branches of K_j i w / (i w + r_j)            at most three branches; K_0, C and K_j not negative
//! in time   F = K_0 x + C x' + SUM K_j (x - q_j)      q_j' = r_j (x - q_j)
//! stored    1/2 K_0 x^2 + SUM 1/2 K_j (x - q_j)^2                     lost   C x'^2 + SUM r_j K_j (x - q_j)^2
//! ```
//! `K_0` is the stiffness at rest and given: it carries the weight and the mean torque. A loss factor that is the same at all frequencies, with a stiffness that is, too,
//! would answer before its cause (Kramers, Kronig): whatever loses must grow stiffer with the frequency. Within a band a chain comes close to it, with an error in
//! proportion to the loss factor that grows with the width of the band; beyond the band it is another spring. The damper `C` is a branch that relaxes at once: as one of
//! the branches it would make the equations of a run stiff.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

/// Most branches.
pub const MOST_BRANCHES: usize = 3;

/// Columns of the fit: the damper, then the branches.
const COLUMNS: usize = 1 + MOST_BRANCHES;

/// Frequencies of the fit.
const FREQUENCIES: usize = 41;

/// How far beyond the lower and the upper end of the band the rates of the outer branches may lie, as powers of ten.
const BELOW: [f64; 6] = [-0.6, -0.3, -0.15, 0.0, 0.3, 0.6];
const ABOVE: [f64; 4] = [-0.3, 0.0, 0.3, 0.6];

/// Rounds of least squares that weigh each frequency by its last departure, and so bring down the largest.
const ROUNDS: usize = 12;

/// Least weight of a frequency of a sum of 1.
const LEAST_WEIGHT: f64 = 1e-9;

/// Springs and dashpots along one direction.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MaxwellChain {
    /// Stiffness at rest [N/m].
    pub at_rest: f64,
    /// Damping beside it [N s/m].
    pub damping: f64,
    /// Stiffness [N/m] and rate of relaxation [1/s] of every branch.
    pub branches: Vec<[f64; 2]>,
    /// Largest departure from the complex stiffness over the band, over its size there.
    pub error: f64,
}

impl MaxwellChain {
    /// The chain of the least largest relative departure from `stiffness` [N/m] at angular frequencies of `band` [rad/s] among those whose stiffness at rest is
    /// `at_rest` [N/m]: least squares with the weights of Lawson's rounds.
    pub fn fit(stiffness: impl Fn(f64) -> Complex64, at_rest: f64, band: [f64; 2]) -> MaxwellChain {
        let [low, high] = band;
        let at = |k: usize| low * (high / low).powf(k as f64 / (FREQUENCIES - 1) as f64);
        let points: Vec<(f64, Complex64)> =
            (0..FREQUENCIES).map(|k| (at(k), stiffness(at(k)))).filter(|(_, k)| k.norm() > 0.0).collect();
        let mut best = MaxwellChain { at_rest, ..MaxwellChain::default() };
        best.error = best.largest_departure(&points);
        for below in BELOW {
            for above in ABOVE {
                let (first, last) = (low * 10f64.powf(-below), high * 10f64.powf(above));
                let rates: [f64; MOST_BRANCHES] = std::array::from_fn(|j| {
                    first * (last / first).powf(j as f64 / (MOST_BRANCHES - 1) as f64)
                });
                let found = with_rates(&points, at_rest, rates);
                if found.error < best.error {
                    best = found;
                }
            }
        }
        best
    }

    /// Largest departure over size at these frequencies.
    fn largest_departure(&self, points: &[(f64, Complex64)]) -> f64 {
        let off = |(frequency, wanted): &(f64, Complex64)| {
            (self.stiffness(*frequency) - wanted).norm() / wanted.norm()
        };
        points.iter().map(off).fold(0.0, f64::max)
    }

    /// Its complex stiffness at an angular frequency [rad/s].
    pub fn stiffness(&self, frequency: f64) -> Complex64 {
        let branch = |[stiffness, rate]: &[f64; 2]| *stiffness * share(frequency, *rate);
        let spring = Complex64::new(self.at_rest, self.damping * frequency);
        spring + self.branches.iter().map(branch).sum::<Complex64>()
    }
}

/// `i w / (i w + r)`.
fn share(frequency: f64, rate: f64) -> Complex64 {
    let turning = Complex64::new(0.0, frequency);
    turning / (turning + rate)
}

/// The best chain with these rates.
fn with_rates(points: &[(f64, Complex64)], at_rest: f64, rates: [f64; MOST_BRANCHES]) -> MaxwellChain {
    // The damper's column for the highest frequency, so that all are of one size.
    let highest = points.iter().map(|(frequency, _)| *frequency).fold(0.0, f64::max);
    let shares: Vec<[Complex64; COLUMNS]> = points
        .iter()
        .map(|(frequency, wanted)| {
            let column = |k: usize| match k {
                0 => Complex64::new(0.0, frequency / highest),
                _ => share(*frequency, rates[k - 1]),
            };
            std::array::from_fn(|k| column(k) / wanted.norm())
        })
        .collect();
    let wanted: Vec<Complex64> =
        points.iter().map(|(_, wanted)| (wanted - at_rest) / wanted.norm()).collect();
    let mut weights = vec![1.0; points.len()];
    let (mut least, mut best) = (f64::INFINITY, [0.0; COLUMNS]);
    for _ in 0..ROUNDS {
        let found = least_squares(&shares, &wanted, &weights);
        let off: Vec<f64> = shares
            .iter()
            .zip(&wanted)
            .map(|(row, wanted)| {
                (row.iter().zip(found).map(|(share, own)| share * own).sum::<Complex64>() - wanted).norm()
            })
            .collect();
        let largest = off.iter().copied().fold(0.0, f64::max);
        if largest < least {
            (least, best) = (largest, found);
        }
        if largest <= f64::EPSILON {
            break;
        }
        weights.iter_mut().zip(&off).for_each(|(weight, off)| *weight *= off / largest);
        let sum: f64 = weights.iter().sum();
        // A frequency without a weight would be lost for good.
        weights.iter_mut().for_each(|weight| *weight = (*weight / sum).max(LEAST_WEIGHT));
    }
    let branches = rates.iter().zip(&best[1..]).filter(|(_, stiffness)| **stiffness > 0.0);
    let branches = branches.map(|(rate, stiffness)| [*stiffness, *rate]).collect();
    let damping = if highest > 0.0 { best[0] / highest } else { 0.0 };
    let mut chain = MaxwellChain { at_rest, damping, branches, error: 0.0 };
    chain.error = chain.largest_departure(points);
    chain
}

/// Stiffnesses that are not negative with the least weighted sum of squares, by trying every choice of those that vanish.
fn least_squares(shares: &[[Complex64; COLUMNS]], wanted: &[Complex64], weights: &[f64]) -> [f64; COLUMNS] {
    let mut normal = [[0.0; COLUMNS]; COLUMNS];
    let mut load = [0.0; COLUMNS];
    for ((row, wanted), weight) in shares.iter().zip(wanted).zip(weights) {
        for i in 0..COLUMNS {
            load[i] += weight * (row[i].conj() * wanted).re;
            for j in 0..COLUMNS {
                normal[i][j] += weight * (row[i].conj() * row[j]).re;
            }
        }
    }
    let mut best = (0.0, [0.0; COLUMNS]);
    for choice in 1..1u32 << COLUMNS {
        let chosen: Vec<usize> = (0..COLUMNS).filter(|column| choice >> column & 1 == 1).collect();
        let own = DMatrix::from_fn(chosen.len(), chosen.len(), |i, j| normal[chosen[i]][chosen[j]]);
        let Some(factors) = own.cholesky() else { continue };
        let found = factors.solve(&DVector::from_fn(chosen.len(), |i, _| load[chosen[i]]));
        if !found.iter().all(|value| *value >= 0.0) {
            continue;
        }
        // At the least sum of squares it is lower than that of nothing by load times solution.
        let gained: f64 = chosen.iter().zip(found.iter()).map(|(column, value)| load[*column] * value).sum();
        if gained > best.0 {
            let mut full = [0.0; COLUMNS];
            chosen.iter().zip(found.iter()).for_each(|(column, value)| full[*column] = *value);
            best = (gained, full);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_found_again() {
        // Rates of the trial at the ends of the band and log-equally between.
        let wanted = |w: f64| Complex64::new(2e5, 15.0 * w) + 1e5 * share(w, 100.0) + 4e4 * share(w, 1000.0);
        let found = MaxwellChain::fit(wanted, 2e5, [100.0, 1000.0]);
        assert!(found.error < 1e-9 && found.at_rest == 2e5, "{found:?}");
        let own = MaxwellChain {
            at_rest: 2e5,
            damping: 20.0,
            branches: vec![[5e4, 80.0], [8e4, 300.0]],
            error: 0.0,
        };
        let found = MaxwellChain::fit(|w| own.stiffness(w), 2e5, [100.0, 1000.0]);
        assert!(found.error < 5e-3, "no trial has its rates: {found:?}");
    }

    #[test]
    fn a_constant_loss_factor_is_met_within_a_band_and_at_rest() {
        let fit = |ratio: f64, loss: f64| {
            MaxwellChain::fit(|_| 3e5 * Complex64::new(1.0, loss), 3e5, [60.0, 60.0 * ratio])
        };
        let error = |ratio: f64, loss: f64| fit(ratio, loss).error;
        let (narrow, wide, weak) = (error(4.0, 0.1), error(16.0, 0.1), error(16.0, 0.02));
        assert!(narrow < 0.053 && wide > narrow && wide < 0.075, "{narrow} {wide}");
        assert!((weak / wide - 0.2).abs() < 0.01, "in proportion to the loss: {weak} {wide}");
        // The best that any number of branches could do, by linear programming over three hundred rates, is 0.0609.
        assert!((error(8.0, 0.1) - 0.0609).abs() < 0.002, "{}", error(8.0, 0.1));
        for loss in [0.02, 0.05, 0.08, 0.1, 0.12, 0.15, 0.25] {
            let slow = fit(8.0, loss).stiffness(1e-3);
            assert!((slow - 3e5).norm() < 1e-4 * 3e5, "at rest the spring of the file: {loss} {slow}");
        }
    }

    #[test]
    fn a_mount_that_softens_with_the_frequency_is_no_chain() {
        let found = MaxwellChain::fit(|_| Complex64::new(2e5, 1e4), 3e5, [60.0, 480.0]);
        assert!(found.error > 0.4, "{found:?}");
    }

    #[test]
    fn dashpots_in_time_are_the_complex_stiffness() {
        let chain = MaxwellChain::fit(|_| 3e5 * Complex64::new(1.0, 0.2), 3e5, [60.0, 480.0]);
        for frequency in [60.0, 150.0, 480.0] {
            // q' = r (x - q) under x = cos(w t) by Heun's rule, until what was at the start is gone.
            let (steps, periods) = (4000, 60);
            let h = std::f64::consts::TAU / frequency / f64::from(steps);
            let mut relaxed = vec![0.0; chain.branches.len()];
            let mut found = Complex64::ZERO;
            for k in 0..steps * periods {
                let phase = |k: i32| frequency * h * f64::from(k);
                let (now, next) = (phase(k).cos(), phase(k + 1).cos());
                if k >= steps * (periods - 1) {
                    let each = chain.branches.iter().zip(&relaxed);
                    let damper = -chain.damping * frequency * phase(k).sin();
                    let force =
                        chain.at_rest * now + damper + each.map(|([own, _], q)| own * (now - q)).sum::<f64>();
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
        let found = MaxwellChain::fit(|_| Complex64::new(1e5, 0.0), 1e5, [50.0, 400.0]);
        assert!(found.error == 0.0 && found.branches.is_empty());
        assert!(MaxwellChain::fit(|_| Complex64::ZERO, 0.0, [50.0, 400.0]).branches.is_empty());
    }
}
