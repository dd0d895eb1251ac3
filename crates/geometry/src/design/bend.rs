//! Second derivatives over a box: how far a term can lie below its tangent.

use super::curve::{PAIRS, pair};
use super::problem::SHAPE;
use lanchester_numerics::Interval;

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
    pub fn least(&self, slope: &[f64; SHAPE], half: &[f64; SHAPE]) -> [f64; 2] {
        // The matrix in units of the half widths: its middle, less the sum of the radii of each row on the diagonal.
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
        least(m, std::array::from_fn(|k| slope[k] * half[k]))
    }

    /// Lower bound of `slope . s + 1/2 SUM H_jk s_j s_k` for `s = centre + SUM edge_i z_i` with `|z_i| <= 1`, in a box of half widths
    /// with these `products`; or one below `asked`, if it does not come so far.
    pub fn least_within<const N: usize>(
        &self,
        slope: &[f64; SHAPE],
        products: &[f64; PAIRS],
        centre: &[f64; SHAPE],
        edges: &[[f64; SHAPE]; N],
        asked: f64,
    ) -> f64 {
        let times = |s: &[f64; SHAPE]| -> [f64; SHAPE] {
            let mut out = [0.0; SHAPE];
            for j in 0..SHAPE {
                for k in 0..SHAPE {
                    out[j] += self.middle[pair(j, k)] * s[k];
                }
            }
            out
        };
        let dot = |a: &[f64; SHAPE], b: &[f64; SHAPE]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let mut uncertain = 0.0;
        for j in 0..SHAPE {
            for k in 0..=j {
                let at = pair(j, k);
                uncertain += if j == k { 0.5 } else { 1.0 } * self.radius[at] * products[at];
            }
        }
        let of_centre = times(centre);
        let at_centre = dot(slope, centre) + 0.5 * dot(centre, &of_centre) - uncertain;
        // No bound lies above the value at the centre.
        if at_centre < asked {
            return at_centre;
        }
        let rise: [f64; SHAPE] = std::array::from_fn(|k| slope[k] + of_centre[k]);
        let bent = edges.map(|edge| times(&edge));
        let matrix: [[f64; N]; N] =
            std::array::from_fn(|j| std::array::from_fn(|k| dot(&edges[j], &bent[k])));
        let start = edges.map(|edge| dot(&edge, &rise));
        at_centre + least(matrix, start)[1]
    }
}

/// Lower bound of `1/2 z.M z` and of `start . z + 1/2 z.M z` for `|z_k| <= 1`.
///
/// What makes the matrix positive is lost, since `|z_k| <= 1`. What is then convex is followed down
/// variable by variable; its tangent there is the bound, however far that came.
fn least<const N: usize>(matrix: [[f64; N]; N], start: [f64; N]) -> [f64; 2] {
    let (matrix, added) = convex(matrix);
    let (mut point, mut rise) = ([0.0f64; N], start);
    for _ in 0..SWEEPS {
        let mut moved = 0.0f64;
        for k in 0..N {
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
    for k in 0..N {
        // The value 1/2 (start + rise) . point, and from there the tangent's fall to the corner.
        least += 0.5 * (start[k] - rise[k]) * point[k] - rise[k].abs();
    }
    [-0.5 * added, least]
}

/// The matrix with its factorisation `L D L^T` made positive by adding to `D`, which adds as much to its diagonal; with it the sum of
/// what was added.
fn convex<const N: usize>(mut m: [[f64; N]; N]) -> ([[f64; N]; N], f64) {
    let mut whole = m;
    let mut added = 0.0;
    let mut open = [true; N];
    for _ in 0..N {
        let mut pivot = N;
        for k in 0..N {
            if open[k] && (pivot == N || m[k][k] > m[pivot][pivot]) {
                pivot = k;
            }
        }
        open[pivot] = false;
        let mut beside = 0.0;
        for k in 0..N {
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
        for j in 0..N {
            if !open[j] {
                continue;
            }
            let factor = m[j][pivot] / m[pivot][pivot];
            for k in 0..N {
                if open[k] {
                    m[j][k] -= factor * m[pivot][k];
                }
            }
        }
    }
    (whole, added)
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
            // In a parallelepiped of the box, which is thin along its last edges.
            let edges: [[f64; SHAPE]; 6] = std::array::from_fn(|i| {
                std::array::from_fn(|k| next() * half[k] * if i < 2 { 0.2 } else { 1e-3 })
            });
            let centre: [f64; SHAPE] = std::array::from_fn(|k| 0.5 * next() * half[k]);
            let least = bend.least_within(&slope, &products(&half), &centre, &edges, f64::NEG_INFINITY);
            for _ in 0..100 {
                let mut s = centre;
                for edge in &edges {
                    let z = next();
                    for (s, edge) in s.iter_mut().zip(edge) {
                        *s += z * edge;
                    }
                }
                let mut value: f64 = slope.iter().zip(&s).map(|(slope, s)| slope * s).sum();
                for j in 0..SHAPE {
                    for k in 0..SHAPE {
                        value += 0.5 * (entries[j][k] - 0.01) * s[j] * s[k];
                    }
                }
                assert!(value >= least - 1e-12, "{value} {least}");
            }
        }
        assert!(convex > 50, "some matrices must be seen as positive definite, {convex} were");
    }
}
