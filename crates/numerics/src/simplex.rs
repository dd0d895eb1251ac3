//! A small linear programme: the least `v` such that some `x` within a box satisfies all rows.
//!
//! ```text
//! minimise v     subject to  a_i . x + c_i v <= b_i,   0 <= x_j <= u_j,   v >= 0
//! ```
//! Dual simplex on a dense tableau in which every variable outside the basis is at zero: a variable at its upper bound is replaced by its
//! distance from there. All costs are zero or one from the start, so that the first basis is dual feasible and `v` only grows: it may
//! be left as soon as it is too large.

/// A coefficient below this is none, in rows scaled to about one.
const TINY: f64 = 1e-11;
const MOST_PIVOTS: usize = 80;

/// One row `a . x + c v <= b`, with `c` in the last column.
#[derive(Debug, Clone, Copy)]
pub struct SimplexRow<const N: usize> {
    /// Coefficients of the variables, then of `v`.
    pub a: [f64; N],
    /// Right side.
    pub b: f64,
}

/// How the programme ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SimplexEnd {
    /// At the least `v`.
    Optimal,
    /// No point satisfies the rows.
    Infeasible,
    /// `v` must be larger than the limit.
    Beyond,
    /// Too many pivots: nothing is known.
    Stopped,
}

/// The tableau of a programme in at most `N` variables, `v` among them, and what stands where.
#[derive(Debug, Clone)]
pub struct Simplex<const N: usize> {
    rows: Vec<[f64; N]>,
    rhs: Vec<f64>,
    cost: [f64; N],
    least: f64,
    /// Variable in each row and column: below `columns` a variable of the programme, above a slack.
    basic: Vec<usize>,
    outside: [usize; N],
    /// Whether a variable of the programme stands for its distance from the upper bound.
    flipped: [bool; N],
    upper: [f64; N],
    columns: usize,
}

impl<const N: usize> Default for Simplex<N> {
    fn default() -> Simplex<N> {
        Simplex {
            rows: Vec::new(),
            rhs: Vec::new(),
            cost: [0.0; N],
            least: 0.0,
            basic: Vec::new(),
            outside: [0; N],
            flipped: [false; N],
            upper: [0.0; N],
            columns: 0,
        }
    }
}

impl<const N: usize> Simplex<N> {
    /// Sets up and solves; `upper` holds the bounds of the `columns` variables, of which the last is `v`.
    pub fn solve(&mut self, rows: &[SimplexRow<N>], upper: &[f64], limit: f64) -> SimplexEnd {
        self.columns = upper.len();
        self.upper[..self.columns].copy_from_slice(upper);
        self.rows.clear();
        self.rhs.clear();
        self.basic.clear();
        for (at, row) in rows.iter().enumerate() {
            self.rows.push(row.a);
            self.rhs.push(row.b);
            self.basic.push(self.columns + at);
        }
        self.outside = std::array::from_fn(|j| j);
        self.flipped = [false; N];
        self.cost = [0.0; N];
        self.cost[self.columns - 1] = 1.0;
        self.least = 0.0;
        for _ in 0..MOST_PIVOTS {
            let Some(row) = self.leaving() else { return SimplexEnd::Optimal };
            let Some(column) = self.entering(row) else { return SimplexEnd::Infeasible };
            self.pivot(row, column);
            if self.least > limit {
                return SimplexEnd::Beyond;
            }
        }
        SimplexEnd::Stopped
    }

    /// The least `v`.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// The row farthest outside its bounds, turned so that it is below zero.
    fn leaving(&mut self) -> Option<usize> {
        let (mut worst, mut at, mut above) = (1e-12, None, false);
        for (row, (value, variable)) in self.rhs.iter().zip(&self.basic).enumerate() {
            if -value > worst {
                (worst, at, above) = (-value, Some(row), false);
            }
            if *variable < self.columns && value - self.upper[*variable] > worst {
                (worst, at, above) = (value - self.upper[*variable], Some(row), true);
            }
        }
        let row = at?;
        if above {
            let variable = self.basic[row];
            self.flipped[variable] = !self.flipped[variable];
            self.rhs[row] = self.upper[variable] - self.rhs[row];
            for entry in &mut self.rows[row] {
                *entry = -*entry;
            }
        }
        Some(row)
    }

    /// The column that costs least for each unit by which the row gets better.
    fn entering(&self, row: usize) -> Option<usize> {
        let mut best: Option<(usize, f64)> = None;
        for (column, entry) in self.rows[row][..self.columns].iter().enumerate() {
            if *entry > -TINY {
                continue;
            }
            let ratio = self.cost[column] / -entry;
            let better = best.is_none_or(|(other, least)| {
                ratio < least - 1e-14 || (ratio <= least + 1e-14 && *entry < self.rows[row][other])
            });
            if better {
                best = Some((column, ratio));
            }
        }
        best.map(|(column, _)| column)
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let inverse = 1.0 / self.rows[row][column];
        let mut pivot_row = self.rows[row].map(|entry| entry * inverse);
        pivot_row[column] = inverse;
        let value = self.rhs[row] * inverse;
        // The entry of the column itself becomes -factor times that of the pivot's row: as if it had been zero.
        let eliminate = |entries: &mut [f64; N]| {
            let factor = entries[column];
            entries[column] = 0.0;
            for (entry, of_pivot) in entries.iter_mut().zip(&pivot_row) {
                *entry -= factor * of_pivot;
            }
            factor * value
        };
        for (at, (entries, rhs)) in self.rows.iter_mut().zip(&mut self.rhs).enumerate() {
            if at != row && entries[column] != 0.0 {
                *rhs -= eliminate(entries);
            }
        }
        if self.cost[column] != 0.0 {
            self.least += eliminate(&mut self.cost);
        }
        self.rows[row] = pivot_row;
        self.rhs[row] = value;
        std::mem::swap(&mut self.basic[row], &mut self.outside[column]);
    }

    /// The point reached.
    pub fn point(&self) -> [f64; N] {
        let mut point = [0.0; N];
        for (value, variable) in self.rhs.iter().zip(&self.basic) {
            if *variable < self.columns {
                point[*variable] = *value;
            }
        }
        for (value, (flipped, upper)) in point.iter_mut().zip(self.flipped.iter().zip(&self.upper)) {
            if *flipped {
                *value = upper - *value;
            }
        }
        point
    }

    /// Rows with a multiplier that is not zero, and their multipliers.
    pub fn multipliers(&self) -> impl Iterator<Item = (usize, f64)> {
        let columns = self.outside[..self.columns].iter().zip(&self.cost);
        columns
            .filter(|(variable, cost)| **variable >= self.columns && **cost > TINY)
            .map(|(variable, cost)| (variable - self.columns, *cost))
    }

    /// Where the variables can lie with `v <= limit`: from a corner along edges, one for each variable outside the basis, of which a
    /// point takes parts from 0 to 1. `rows` are those of the programme.
    pub fn parallelepiped(&self, rows: &[SimplexRow<N>], limit: f64) -> ([f64; N], [[f64; N]; N]) {
        let room = (limit - self.least).max(0.0);
        let mut edges = [[0.0; N]; N];
        let mut most = [0.0; N];
        for j in 0..self.columns {
            let variable = self.outside[j];
            let far = if variable < self.columns {
                self.upper[variable]
            } else {
                let row = &rows[variable - self.columns];
                let fall: f64 = row.a[..self.columns - 1].iter().map(|a| a.min(0.0)).sum();
                row.b - fall - row.a[self.columns - 1] * limit
            };
            most[j] = if self.cost[j] > TINY { far.min(room / self.cost[j]) } else { far };
            if variable < self.columns {
                edges[j][variable] = most[j];
            }
        }
        for (row, variable) in self.rows.iter().zip(&self.basic) {
            if *variable < self.columns {
                for j in 0..self.columns {
                    edges[j][*variable] = -row[j] * most[j];
                }
            }
        }
        for edge in &mut edges {
            for (entry, flipped) in edge.iter_mut().zip(&self.flipped) {
                if *flipped {
                    *entry = -*entry;
                }
            }
        }
        (self.point(), edges)
    }

    /// Bounds on each variable that no point with `v <= limit` leaves, from the reduced costs and the rows of the tableau;
    /// `gain` is what is known of the sum of the rows with their multipliers beyond this programme.
    pub fn tightened(&self, limit: f64, gain: f64) -> [[f64; 2]; N] {
        let room = (limit - self.least).max(0.0);
        let room_of_variables = (room - gain).max(0.0);
        let most: [f64; N] = std::array::from_fn(|j| {
            if j >= self.columns {
                return 0.0;
            }
            let variable = self.outside[j];
            let (upper, room) = if variable < self.columns {
                (self.upper[variable], room_of_variables)
            } else {
                (f64::INFINITY, room)
            };
            if self.cost[j] > TINY { upper.min(room / self.cost[j]) } else { upper }
        });
        let mut bounds: [[f64; 2]; N] =
            std::array::from_fn(|j| [0.0, if j < self.columns { self.upper[j] } else { 0.0 }]);
        for j in 0..self.columns {
            if self.outside[j] < self.columns {
                bounds[self.outside[j]] = [0.0, most[j]];
            }
        }
        for (row, (value, variable)) in self.rows.iter().zip(self.rhs.iter().zip(&self.basic)) {
            if *variable < self.columns {
                let (mut low, mut high) = (*value, *value);
                for (entry, most) in row[..self.columns].iter().zip(&most) {
                    if *entry > TINY {
                        low -= entry * most;
                    } else if *entry < -TINY {
                        high -= entry * most;
                    }
                }
                let old = bounds[*variable];
                bounds[*variable] = [old[0].max(low), old[1].min(high)];
            }
        }
        for (bound, (flipped, upper)) in bounds.iter_mut().zip(self.flipped.iter().zip(&self.upper)) {
            if *flipped {
                *bound = [upper - bound[1], upper - bound[0]];
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: usize = 6;

    fn row(a: &[f64], b: f64) -> SimplexRow<COLUMNS> {
        let mut padded = [0.0; COLUMNS];
        padded[..a.len()].copy_from_slice(a);
        SimplexRow { a: padded, b }
    }

    #[test]
    fn least_violation_of_a_triangle() {
        // x + y >= 3 - v with x, y <= 1: v = 1 in the corner.
        let mut simplex = Simplex::<COLUMNS>::default();
        let end = simplex.solve(&[row(&[-1.0, -1.0, -1.0], -3.0)], &[1.0, 1.0, f64::INFINITY], f64::INFINITY);
        assert_eq!((end, simplex.least()), (SimplexEnd::Optimal, 1.0));
        assert_eq!(simplex.point()[..3], [1.0, 1.0, 1.0]);
        // With v <= 1.25 neither may be below 0.75.
        let bounds = simplex.tightened(1.25, 0.0);
        assert!((bounds[0][0] - 0.75).abs() < 1e-15 && (bounds[1][0] - 0.75).abs() < 1e-15, "{bounds:?}");
        assert_eq!(
            simplex.solve(&[row(&[-1.0, -1.0, -1.0], -3.0)], &[1.0, 1.0, f64::INFINITY], 0.5),
            SimplexEnd::Beyond
        );
    }

    #[test]
    fn rows_without_v_can_have_no_point() {
        let rows = [row(&[1.0, 1.0, 0.0], 0.5), row(&[-1.0, 0.0, 0.0], -0.3), row(&[0.0, -1.0, 0.0], -0.3)];
        let mut simplex = Simplex::<COLUMNS>::default();
        assert_eq!(simplex.solve(&rows, &[1.0, 1.0, f64::INFINITY], f64::INFINITY), SimplexEnd::Infeasible);
        let end = simplex.solve(&rows[..2], &[1.0, 1.0, f64::INFINITY], f64::INFINITY);
        let point = simplex.point();
        assert!(end == SimplexEnd::Optimal && point[0] >= 0.3 - 1e-12 && point[0] + point[1] <= 0.5 + 1e-12);
    }

    #[test]
    fn vertices_agree_with_trying_all_of_them() {
        // Pseudo-random rows in two variables: the least v is where two of the lines and bounds cross.
        let mut seed = 7u32;
        let mut next = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1 << 24) * 2.0 - 1.0
        };
        for _ in 0..200 {
            let rows: Vec<SimplexRow<COLUMNS>> =
                (0..6).map(|_| row(&[next(), next(), -1.0], next() - 0.5)).collect();
            let mut simplex = Simplex::<COLUMNS>::default();
            assert_eq!(simplex.solve(&rows, &[1.0, 1.0, f64::INFINITY], f64::INFINITY), SimplexEnd::Optimal);
            let violation =
                |x: f64, y: f64| rows.iter().map(|r| r.a[0] * x + r.a[1] * y - r.b).fold(0.0, f64::max);
            let point = simplex.point();
            assert!((violation(point[0], point[1]) - simplex.least()).abs() < 1e-9);
            let mut best = f64::INFINITY;
            for i in 0..=200 {
                for j in 0..=200 {
                    best = best.min(violation(f64::from(i) / 200.0, f64::from(j) / 200.0));
                }
            }
            // A grid can only be worse, by no more than its step times the steepest rows.
            assert!(best >= simplex.least() - 1e-9 && best - simplex.least() < 0.02);
            let bounds = simplex.tightened(simplex.least() + 0.1, 0.0);
            for k in 0..400 {
                let (x, y) = (f64::from(k % 20) / 19.0, f64::from(k / 20) / 19.0);
                if violation(x, y) <= simplex.least() + 0.1 {
                    assert!(x >= bounds[0][0] - 1e-9 && x <= bounds[0][1] + 1e-9);
                    assert!(y >= bounds[1][0] - 1e-9 && y <= bounds[1][1] + 1e-9);
                }
            }
        }
    }
}
