//! Second derivatives over a box: how far a term can lie below its tangent.

use super::interval::Interval;
use super::number::Number;
use super::problem::SHAPE;
use std::ops::Add;

/// Most rounds in search of the least of a convex bound.
const SWEEPS: usize = 8;

/// Ranges of the second derivatives of a term over a box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bend(pub [[Interval; SHAPE]; SHAPE]);

impl Bend {
    /// Of a term that is linear.
    pub fn none() -> Bend {
        Bend([[Interval::of(0.0); SHAPE]; SHAPE])
    }

    /// Times a number that is not negative.
    pub fn times(&self, factor: f64) -> Bend {
        Bend(self.0.map(|row| row.map(|entry| Interval::new(entry.low * factor, entry.high * factor))))
    }

    /// Lower bound of `1/2 SUM H_jk s_j s_k` for `|s_k| <= half_k`, entry by entry.
    pub fn drop(&self, half: &[f64; SHAPE]) -> f64 {
        let mut sum = 0.0;
        for j in 0..SHAPE {
            sum += 0.5 * self.0[j][j].low.min(0.0) * half[j] * half[j];
            for k in 0..j {
                let entry = self.0[j][k];
                sum -= entry.low.abs().max(entry.high.abs()) * half[j] * half[k];
            }
        }
        sum
    }

    /// Lower bound of the same by the whole matrix: zero where it is positive definite over the box.
    ///
    /// What makes the matrix positive is lost, since `|s_k| <= 1` in units of the half widths.
    pub fn drop_of_whole(&self, half: &[f64; SHAPE]) -> f64 {
        -0.5 * self.convex(half).1
    }

    /// Lower bound of `slope . s + 1/2 SUM H_jk s_j s_k` for `|s_k| <= half_k`.
    ///
    /// The matrix is made positive as in [`Bend::drop_of_whole`]. What is then convex is followed down variable by variable;
    /// its tangent there is the bound, however far that came.
    pub fn least(&self, slope: &[f64; SHAPE], half: &[f64; SHAPE]) -> f64 {
        let (matrix, added) = self.convex(half);
        let start: [f64; SHAPE] = std::array::from_fn(|k| slope[k] * half[k]);
        let (mut point, mut rise) = ([0.0f64; SHAPE], start);
        for _ in 0..SWEEPS {
            let mut moved = 0.0f64;
            for k in 0..SHAPE {
                let curve = matrix[k][k];
                let step = if curve > 0.0 {
                    (point[k] - rise[k] / curve).clamp(-1.0, 1.0) - point[k]
                } else {
                    // Straight: to the end that lies lower, which the tangent reaches anyway.
                    0.0
                };
                point[k] += step;
                for (rise, entry) in rise.iter_mut().zip(&matrix[k]) {
                    *rise += entry * step;
                }
                moved = moved.max(step.abs());
            }
            if moved < 1e-2 {
                break;
            }
        }
        let mut least = -0.5 * added;
        for k in 0..SHAPE {
            // The value 1/2 (start + rise) . point, and from there the tangent's fall to the corner.
            least += 0.5 * (start[k] - rise[k]) * point[k] - rise[k].abs();
        }
        least
    }

    /// The matrix in units of the half widths: its middle, less the sum of the radii of each row on the diagonal. Its
    /// factorisation `L D L^T` is made positive by adding to `D`, which adds as much to its diagonal; with it the sum of what was added.
    fn convex(&self, half: &[f64; SHAPE]) -> ([[f64; SHAPE]; SHAPE], f64) {
        let mut m = [[0.0; SHAPE]; SHAPE];
        for j in 0..SHAPE {
            for k in 0..SHAPE {
                let (entry, scale) = (self.0[j][k], half[j] * half[k]);
                m[j][k] += 0.5 * (entry.low + entry.high) * scale;
                m[j][j] -= 0.5 * (entry.high - entry.low) * scale;
            }
        }
        let mut whole = m;
        let mut added = 0.0;
        let mut open = [true; SHAPE];
        for _ in 0..SHAPE {
            let mut pivot = SHAPE;
            for k in 0..SHAPE {
                if open[k] && (pivot == SHAPE || m[k][k] > m[pivot][pivot]) {
                    pivot = k;
                }
            }
            open[pivot] = false;
            let mut beside = 0.0;
            for k in 0..SHAPE {
                if open[k] {
                    beside += m[k][pivot] * m[k][pivot];
                }
            }
            let floor = f64::sqrt(beside);
            if m[pivot][pivot] < floor {
                added += floor - m[pivot][pivot];
                whole[pivot][pivot] += floor - m[pivot][pivot];
                m[pivot][pivot] = floor;
            }
            if beside == 0.0 {
                continue;
            }
            for j in 0..SHAPE {
                if !open[j] {
                    continue;
                }
                let factor = m[j][pivot] / m[pivot][pivot];
                for k in 0..SHAPE {
                    if open[k] {
                        m[j][k] -= factor * m[pivot][k];
                    }
                }
            }
        }
        (whole, added)
    }
}

impl Add for Bend {
    type Output = Bend;
    fn add(self, other: Bend) -> Bend {
        Bend(std::array::from_fn(|j| std::array::from_fn(|k| self.0[j][k] + other.0[j][k])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prop_bounds_lie_below_every_value() {
        let mut seed = 5u32;
        let mut next = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24) * 2.0 - 1.0
        };
        let mut convex = 0;
        for round in 0..300 {
            let shift = f64::from(round % 3) * 2.0;
            let mut entries = [[0.0; SHAPE]; SHAPE];
            for j in 0..SHAPE {
                for k in 0..=j {
                    entries[j][k] = next() + if j == k { shift } else { 0.0 };
                    entries[k][j] = entries[j][k];
                }
            }
            let bend = Bend(entries.map(|row| row.map(|e| Interval::new(e - 0.01, e + 0.01))));
            let half: [f64; SHAPE] = std::array::from_fn(|_| 0.1 + next().abs());
            let (by_entry, whole) = (bend.drop(&half), bend.drop_of_whole(&half));
            let slope: [f64; SHAPE] = std::array::from_fn(|_| 2.0 * next());
            let least = bend.least(&slope, &half);
            convex += usize::from(whole == 0.0);
            for _ in 0..100 {
                let s: [f64; SHAPE] = std::array::from_fn(|k| next() * half[k]);
                let mut value = 0.0;
                for j in 0..SHAPE {
                    for k in 0..SHAPE {
                        value += 0.5 * (entries[j][k] + 0.01) * s[j] * s[k];
                    }
                }
                let sloped = value + slope.iter().zip(&s).map(|(slope, s)| slope * s).sum::<f64>();
                assert!(sloped >= least - 1e-12, "{sloped} {least}");
                assert!(value >= by_entry - 1e-12 && value >= whole - 1e-12, "{value} {by_entry} {whole}");
            }
        }
        assert!(convex > 50, "some matrices must be seen as positive definite, {convex} were");
    }
}
