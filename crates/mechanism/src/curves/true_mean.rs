//! Means of a load over the continuous cycle.

use lanchester_numerics::{GAUSS_8, gauss};

/// Jumps closer than this are at one angle [rad].
const SAME: f64 = 1e-11;

/// Weights of the first samples of a smooth stretch; those of the last mirror them, all others count whole. Gregory's rule with
/// differences to the fifth: exact for polynomials of degree 5.
const ENDS: [f64; 6] = [
    19_087.0 / 60_480.0,
    84_199.0 / 60_480.0,
    18_869.0 / 30_240.0,
    37_621.0 / 30_240.0,
    55_031.0 / 60_480.0,
    61_343.0 / 60_480.0,
];

/// Mean of `value` over a period. `samples` are its values at equal steps of `period` from 0; it is smooth but at the angles
/// `jumps` (from 0 to the period, rising).
///
/// Without a jump the mean of the samples is exact but for orders above half their number. Between jumps the samples are taken by
/// Gregory's rule, and the rest of the steps in which jumps lie by Gauss's.
pub(crate) fn true_mean(samples: &[f64], period: f64, jumps: &[f64], value: impl Fn(f64) -> f64) -> f64 {
    let count = samples.len();
    if jumps.is_empty() || count == 0 {
        return samples.iter().sum::<f64>() / count.max(1) as f64;
    }
    let step = period / count as f64;
    let mut cuts: Vec<f64> = jumps.to_vec();
    cuts.dedup_by(|next, kept| *next - *kept <= SAME);
    cuts.push(cuts[0] + period);
    let gauss = |from: f64, to: f64| gauss(&GAUSS_8, from, to, &value);
    let mut sum = 0.0;
    for pair in cuts.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        // The samples inside, away from the jumps by more than rounding.
        let first = ((from + SAME) / step).ceil() as usize;
        let last = ((to - SAME) / step).floor() as usize;
        if last < first + 2 * ENDS.len() {
            let pieces = ((to - from) / step).ceil().max(1.0);
            let width = (to - from) / pieces;
            sum += (0..pieces as usize)
                .map(|k| gauss(from + width * k as f64, from + width * (k + 1) as f64))
                .sum::<f64>();
            continue;
        }
        let weight = |k: usize| {
            let end = (k - first).min(last - k);
            ENDS.get(end).copied().unwrap_or(1.0)
        };
        sum += step * (first..=last).map(|k| weight(k) * samples[k % count]).sum::<f64>();
        sum += gauss(from, step * first as f64) + gauss(step * last as f64, to);
    }
    sum / period
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn samples(count: usize, value: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..count).map(|k| value(TAU * k as f64 / count as f64)).collect()
    }

    #[test]
    fn a_saw_that_jumps_between_samples_has_its_mean() {
        // Rises from 0 to 1 twice a turn: the mean of samples alone errs by the share of a step before the jump.
        let jump = 0.4321;
        let value = |theta: f64| ((theta - jump).rem_euclid(PI) / PI).powi(3);
        let samples = samples(90, value);
        let mean = true_mean(&samples, TAU, &[jump, jump + PI], value);
        assert!((mean - 0.25).abs() < 1e-13, "{mean}");
        let of_samples = samples.iter().sum::<f64>() / 90.0;
        assert!((of_samples - 0.25).abs() > 1e-3, "{of_samples}");
    }

    #[test]
    fn jumps_close_together_and_on_samples() {
        // 1 on a stretch of a step and a half that starts on a sample, cos elsewhere: mean by hand.
        let step = TAU / 288.0;
        let (from, to) = (10.0 * step, 11.5 * step);
        let value = |theta: f64| {
            let theta = theta.rem_euclid(TAU);
            if theta >= from && theta < to { 1.0 } else { 2.0 + theta.cos() }
        };
        let want = (2.0 * TAU - 2.0 * (to - from) - (to.sin() - from.sin()) + (to - from)) / TAU;
        let mean = true_mean(&samples(288, value), TAU, &[from, to], value);
        assert!((mean - want).abs() < 1e-11, "{mean} {want}");
    }
}
