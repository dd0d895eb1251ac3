//! Second derivatives over a box: how far a term can lie below its tangent.

use super::interval::Interval;
use super::number::Number;
use super::problem::SHAPE;
use std::ops::Add;

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
    /// In units of the half widths the matrix is its middle, less the sum of the radii of each row on the diagonal. Its
    /// factorisation `L D L^T` is made positive by adding to `D`; what was added is lost, since `|s_k| <= 1`.
    pub fn drop_of_whole(&self, half: &[f64; SHAPE]) -> f64 {
        let mut m = [[0.0; SHAPE]; SHAPE];
        for j in 0..SHAPE {
            for k in 0..SHAPE {
                let (entry, scale) = (self.0[j][k], half[j] * half[k]);
                m[j][k] += 0.5 * (entry.low + entry.high) * scale;
                m[j][j] -= 0.5 * (entry.high - entry.low) * scale;
            }
        }
        let mut added = 0.0;
        for pivot in 0..SHAPE {
            let beside = (pivot + 1..SHAPE).map(|k| m[k][pivot].abs()).fold(0.0, f64::max);
            let floor = 0.1 * beside;
            if m[pivot][pivot] < floor {
                added += floor - m[pivot][pivot];
                m[pivot][pivot] = floor;
            }
            if beside == 0.0 {
                continue;
            }
            for j in pivot + 1..SHAPE {
                let factor = m[j][pivot] / m[pivot][pivot];
                for k in pivot + 1..SHAPE {
                    m[j][k] -= factor * m[pivot][k];
                }
            }
        }
        -0.5 * added
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
    fn both_bounds_lie_below_every_value() {
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
            convex += usize::from(whole == 0.0);
            for _ in 0..100 {
                let s: [f64; SHAPE] = std::array::from_fn(|k| next() * half[k]);
                let mut value = 0.0;
                for j in 0..SHAPE {
                    for k in 0..SHAPE {
                        value += 0.5 * (entries[j][k] + 0.01) * s[j] * s[k];
                    }
                }
                assert!(value >= by_entry - 1e-12 && value >= whole - 1e-12, "{value} {by_entry} {whole}");
            }
        }
        assert!(convex > 50, "some matrices must be seen as positive definite, {convex} were");
    }
}
