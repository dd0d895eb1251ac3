//! True peaks of a load: from its samples to the extreme over the continuous angle.

use crate::speed::energy::peak;
use lanchester_results::Extreme;

/// Local maxima of the samples below this share of the largest are no candidates.
const CANDIDATE: f64 = 0.95;

/// Share of a stretch by which its ends are avoided: the load may jump there.
const INSIDE: f64 = 1e-9;

/// Jumps closer than this are at one angle [rad]: what would stand between them is their rounding.
const SAME: f64 = 1e-11;

/// Largest value of `value`, which is not negative, and its angle. `samples` are its values at equal steps of `period` from 0; it is
/// smooth but at the angles `jumps` (from 0 to the period, rising) and its peaks are wider than a step.
pub(crate) fn true_peak(samples: &[f64], period: f64, jumps: &[f64], value: impl Fn(f64) -> f64) -> Extreme {
    let count = samples.len();
    let step = period / count.max(1) as f64;
    let largest = samples.iter().copied().fold(0.0, f64::max);
    let mut best = Extreme::default();
    let mut take = |value: f64, theta: f64| {
        if value > best.value {
            best = Extreme { value, theta: theta.rem_euclid(period) };
        }
    };
    for (i, here) in samples.iter().enumerate() {
        take(*here, step * i as f64);
        let beside = [samples[(i + count - 1) % count], samples[(i + 1) % count]];
        if *here < CANDIDATE * largest || beside.iter().any(|other| other > here) {
            continue;
        }
        let (from, to) = (step * (i as f64 - 1.0), step * (i as f64 + 1.0));
        let within = [-period, 0.0, period]
            .into_iter()
            .flat_map(|turn| jumps.iter().map(move |jump| jump + turn))
            .filter(|jump| *jump > from && *jump < to);
        let mut cuts: Vec<f64> = within.chain([from, to]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|next, kept| *next - *kept <= SAME);
        for pair in cuts.windows(2) {
            let width = pair[1] - pair[0];
            let margin = (INSIDE * width).max(SAME).min(width / 4.0);
            let bracket = [pair[0] + margin, pair[1] - margin];
            let (found, theta) = peak(bracket, &value);
            take(found, theta);
            for theta in bracket {
                take(value(theta), theta);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn a_peak_between_samples_is_found() {
        let value = |theta: f64| 2.0 + (theta - 1.234).cos();
        let samples: Vec<f64> = (0..12).map(|k| value(TAU * f64::from(k) / 12.0)).collect();
        let found = true_peak(&samples, TAU, &[], value);
        assert!((found.value - 3.0).abs() < 1e-14 && (found.theta - 1.234).abs() < 1e-7, "{found:?}");
    }

    #[test]
    fn nothing_stands_between_jumps_at_one_angle() {
        // One load comes as another goes.
        let jump = 2.0 * TAU / 90.0;
        for apart in [-1e-15, 0.0, 1e-15] {
            let comes = |theta: f64| if theta >= jump { 1.0 } else { 0.0 };
            let goes = |theta: f64| if theta < jump + apart { 1.0 } else { 0.0 };
            let value = |theta: f64| comes(theta) + goes(theta);
            let found = true_peak(&[1.0; 90], TAU, &[jump.min(jump + apart), jump.max(jump + apart)], value);
            assert_eq!(found.value, 1.0, "{apart}");
        }
    }

    #[test]
    fn a_jump_between_samples_is_seen_from_its_high_side() {
        // A saw: rises to 1 at its jump.
        let jump = 0.4321;
        let value = |theta: f64| (theta - jump).rem_euclid(PI) / PI;
        let samples: Vec<f64> = (0..90).map(|k| value(TAU * f64::from(k) / 90.0)).collect();
        let found = true_peak(&samples, TAU, &[jump, jump + PI], value);
        assert!((found.value - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.theta.rem_euclid(PI) - jump).abs() < 1e-8, "{found:?}");
    }
}
