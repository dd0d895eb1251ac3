//! Second derivatives over a box: how far a term can lie below its tangent.

use super::curve::{PAIRS, pair};
use super::interval::Interval;
use super::problem::SHAPE;

/// Most rounds in search of the least of a convex bound.
const SWEEPS: usize = 8;

/// Ranges of the second derivatives of a term over a box, or of a sum of terms: the lower triangle, row by row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bend {
    middle: [f64; PAIRS],
    radius: [f64; PAIRS],
    /// Largest absolute values beside the diagonal, half of what is below zero on it.
    fall: [f64; PAIRS],
}

/// Products of the half widths of a box, in the order of the pairs.
pub(super) fn products(half: &[f64; SHAPE]) -> [f64; PAIRS] {
    let mut products = [0.0; PAIRS];
    for j in 0..SHAPE {
        for k in 0..=j {
            products[pair(j, k)] = half[j] * half[k];
        }
    }
    products
}

impl Bend {
    /// Of a term with these second derivatives.
    pub fn of(ranges: &[Interval; PAIRS]) -> Bend {
        let mut fall = ranges.map(|range| range.low.abs().max(range.high.abs()));
        for j in 0..SHAPE {
            fall[pair(j, j)] = -0.5 * ranges[pair(j, j)].low.min(0.0);
        }
        Bend {
            middle: ranges.map(|range| 0.5 * (range.low + range.high)),
            radius: ranges.map(|range| 0.5 * (range.high - range.low)),
            fall,
        }
    }

    /// Of the sum of terms with weights that are not negative.
    pub fn sum<'a>(terms: impl Iterator<Item = (f64, &'a Bend)>) -> Bend {
        let mut sum = Bend { middle: [0.0; PAIRS], radius: [0.0; PAIRS], fall: [0.0; PAIRS] };
        for (weight, term) in terms {
            for at in 0..PAIRS {
                sum.middle[at] += weight * term.middle[at];
                sum.radius[at] += weight * term.radius[at];
            }
        }
        for j in 0..SHAPE {
            for k in 0..=j {
                let at = pair(j, k);
                let low = sum.middle[at] - sum.radius[at];
                sum.fall[at] =
                    if j == k { -0.5 * low.min(0.0) } else { sum.middle[at].abs() + sum.radius[at] };
            }
        }
        sum
    }

    /// Lower bound of `1/2 SUM H_jk s_j s_k` for `|s_k| <= half_k`, entry by entry; `products` are those of the half widths.
    pub fn drop(&self, products: &[f64; PAIRS]) -> f64 {
        -self.fall.iter().zip(products).map(|(fall, product)| fall * product).sum::<f64>()
    }

    /// How much the slope by a variable may change over a box of these widths.
    pub fn turn(&self, k: usize, widths: &[f64; SHAPE]) -> f64 {
        let most = |j: usize| self.middle[pair(j, k)].abs() + self.radius[pair(j, k)];
        (0..SHAPE).map(|j| most(j) * widths[j]).sum()
    }

    /// Lower bound of `1/2 SUM H_jk s_j s_k` and of `slope . s + 1/2 SUM H_jk s_j s_k` for `|s_k| <= half_k`, by the whole
    /// matrix: the first is zero where it is positive definite over the box.
    ///
    /// What makes the matrix positive is lost, since `|s_k| <= 1` in units of the half widths. What is then convex is followed down
    /// variable by variable; its tangent there is the bound, however far that came.
    pub fn least(&self, slope: &[f64; SHAPE], half: &[f64; SHAPE]) -> [f64; 2] {
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
        [-0.5 * added, least]
    }

    /// The matrix in units of the half widths: its middle, less the sum of the radii of each row on the diagonal. Its
    /// factorisation `L D L^T` is made positive by adding to `D`, which adds as much to its diagonal; with it the sum of what was added.
    fn convex(&self, half: &[f64; SHAPE]) -> ([[f64; SHAPE]; SHAPE], f64) {
        let mut m = [[0.0; SHAPE]; SHAPE];
        for j in 0..SHAPE {
            for k in 0..=j {
                let (at, scale) = (pair(j, k), half[j] * half[k]);
                let radius = self.radius[at] * scale;
                m[j][j] -= radius;
                if k == j {
                    m[j][j] += self.middle[at] * scale;
                } else {
                    m[k][k] -= radius;
                    m[j][k] = self.middle[at] * scale;
                    m[k][j] = m[j][k];
                }
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
            let mut ranges = [Interval::new(0.0, 0.0); PAIRS];
            for j in 0..SHAPE {
                for k in 0..=j {
                    ranges[pair(j, k)] = Interval::new(entries[j][k] - 0.01, entries[j][k] + 0.01);
                }
            }
            // In two parts, as a sum of terms is.
            let single = Bend::of(&ranges);
            let bend = Bend::sum([(0.25, &single), (0.75, &single)].into_iter());
            let half: [f64; SHAPE] = std::array::from_fn(|_| 0.1 + next().abs());
            let (by_entry, again) = (single.drop(&products(&half)), bend.drop(&products(&half)));
            assert!((by_entry - again).abs() < 1e-13);
            let slope: [f64; SHAPE] = std::array::from_fn(|_| 2.0 * next());
            let [whole, least] = bend.least(&slope, &half);
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
