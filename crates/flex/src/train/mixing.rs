//! From the ends of cycles to the state that repeats: Anderson's mixing of fixed-point iterations.
//!
//! ```text
//! y_(k+1) = P_k - SUM g_j (P_(j+1) - P_j)    |f_k - SUM g_j (f_(j+1) - f_j)| least    f = P(y) - y
//! ```
//! Vibration of the crankshaft dies slowly under 1 % of critical damping; a few cycles tell where it ends. Source: Anderson, J. ACM 12 (1965) 547.

use crate::sparse::dot;
use lanchester_numerics::Lu;

/// Differences that are kept.
const WINDOW: usize = 6;
/// Growth of the residual after which what is kept counts no more.
const GROWTH: f64 = 3.0;

/// Starts and ends of cycles.
#[derive(Debug, Default)]
pub(crate) struct Mixing {
    /// Ends, and weighted residuals.
    ends: Vec<Vec<f64>>,
    residuals: Vec<Vec<f64>>,
}

impl Mixing {
    /// The next start after a cycle from `start` to `end`; `weights` make the components comparable, zero of those that do not count.
    pub fn next(&mut self, start: &[f64], end: &[f64], weights: &[f64]) -> Vec<f64> {
        let residual: Vec<f64> = start.iter().zip(end).zip(weights).map(|((a, b), w)| w * (b - a)).collect();
        let size = |own: &[f64]| dot(own, own).sqrt();
        if self.residuals.last().is_some_and(|before| size(&residual) > GROWTH * size(before)) {
            *self = Mixing::default();
        }
        self.ends.push(end.to_vec());
        self.residuals.push(residual.clone());
        if self.ends.len() > WINDOW + 1 {
            self.ends.remove(0);
            self.residuals.remove(0);
        }
        let count = self.ends.len() - 1;
        let difference = |of: &[Vec<f64>], j: usize| -> Vec<f64> {
            of[j + 1].iter().zip(&of[j]).map(|(a, b)| a - b).collect()
        };
        let changes: Vec<Vec<f64>> = (0..count).map(|j| difference(&self.residuals, j)).collect();
        let mut gram: Vec<f64> =
            (0..count * count).map(|k| dot(&changes[k / count], &changes[k % count])).collect();
        let largest = (0..count).map(|j| gram[j * (count + 1)]).fold(0.0, f64::max);
        (0..count).for_each(|j| gram[j * (count + 1)] += 1e-12 * largest);
        let mut shares: Vec<f64> = changes.iter().map(|change| dot(change, &residual)).collect();
        let mut mixed = end.to_vec();
        if count == 0 || largest == 0.0 {
            return mixed;
        }
        let Ok(factors) = Lu::new(count, gram) else { return mixed };
        factors.solve(&mut shares);
        if shares.iter().any(|share| !share.is_finite() || share.abs() > 1e3) {
            return mixed;
        }
        for (j, share) in shares.iter().enumerate() {
            for (to, change) in mixed.iter_mut().zip(difference(&self.ends, j)) {
                *to -= share * change;
            }
        }
        mixed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_vibrations_are_gone_after_a_few_cycles() {
        // Three turning and shrinking pairs about a point.
        let goal = [1.0, -2.0, 0.5, 3.0, -1.0, 0.2];
        let map = |y: &[f64]| -> Vec<f64> {
            let mut end = goal.to_vec();
            for pair in 0..3 {
                let (sin, cos) = (0.7 + pair as f64).sin_cos();
                let [a, b] = [0, 1].map(|k| y[2 * pair + k] - goal[2 * pair + k]);
                end[2 * pair] += 0.95 * (cos * a - sin * b);
                end[2 * pair + 1] += 0.95 * (sin * a + cos * b);
            }
            end
        };
        let (mut mixing, mut y) = (Mixing::default(), vec![0.0; 6]);
        for _ in 0..9 {
            let end = map(&y);
            y = mixing.next(&y, &end, &[1.0; 6]);
        }
        for (y, goal) in y.iter().zip(goal) {
            assert!((y - goal).abs() < 1e-6, "{y} {goal}");
        }
    }
}
