//! A convex programme over loads: what is minimised and what must hold, scaled to numbers about 1.
//!
//! ```text
//! minimise  SUM over groups g of  c_g t_g + p x
//! with      |a(phi; x)| <= t_g                      for every member a of g, for every angle
//!           SUM over g of  b_rg t_g + h_r x <= B_r  for every row r
//! ```
//! `t_g` is the largest amount of its members: the peak of a load over the cycle is a group of one curve, added mass a
//! sum of groups of one vector each, a largest amount a group with a row of its own.

use super::curve::{FixedMember, Grid, Member};
use super::dense::{Matrix, RowFactors, add_scaled, dot};
use std::rc::Rc;

/// Directions that move a group by less than this share of its reach are not seen by it.
pub(crate) const UNSEEN: f64 = 1e-11;

/// More terms than this are a mean over the cycle: no task has as many weights.
const MANY: usize = 150;

/// Rows are judged relative to their limits, smaller limits to this.
const LEAST: f64 = 1e-3;

/// Values whose largest amount counts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Group {
    pub members: Vec<Member>,
    /// The most that a unit of a variable changes a coefficient: what its directions are measured against.
    pub reach: f64,
}

impl Group {
    pub fn new(members: Vec<Member>) -> Group {
        let reach = members.iter().map(|m| largest(m.columns())).fold(0.0, f64::max);
        Group { members, reach: if reach > 0.0 { reach } else { 1.0 } }
    }

    /// Its members at one choice of the variables.
    pub fn at(&self, x: &[f64]) -> Vec<FixedMember<'_>> {
        self.members.iter().map(|m| m.at(x)).collect()
    }

    /// Whether the variables still move it.
    pub fn moves(&self) -> bool {
        self.members.iter().any(|m| largest(m.columns()) > UNSEEN * self.reach)
    }

    /// Adds how its coefficients depend on the variables, one row each, to `rows`; what it does not see counts as 0.
    pub fn add_directions(&self, rows: &mut Matrix) {
        for columns in self.members.iter().map(Member::columns) {
            for i in 0..columns.rows {
                let seen = |c: &f64| if c.abs() > UNSEEN * self.reach { c / self.reach } else { 0.0 };
                let row: Vec<f64> = columns.row(i).iter().map(seen).collect();
                rows.push(&row);
            }
        }
    }
}

/// The largest coefficient.
pub(crate) fn largest(columns: &Matrix) -> f64 {
    (0..columns.rows).flat_map(|i| columns.row(i)).fold(0.0, |a, b| a.max(b.abs()))
}

/// `SUM of shares t + directions x <= most`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// Groups with their positive factors.
    pub shares: Vec<(usize, f64)>,
    /// Factors of the variables.
    pub directions: Vec<f64>,
    pub most: f64,
}

/// A convex programme.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Programme {
    pub variables: usize,
    pub grid: Rc<Grid>,
    pub groups: Vec<Group>,
    pub rows: Vec<Row>,
    /// `c`, one a group, not negative.
    pub cost: Vec<f64>,
    /// `p`.
    pub linear: Vec<f64>,
    /// Constant part of what is minimised.
    pub offset: f64,
    /// How far a point may pass a row, as a share of it: rounding where the point is the answer, more where only the
    /// bound counts.
    pub holds: f64,
}

/// A multiplier: `y` of one member at one angle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Support {
    pub group: usize,
    pub member: usize,
    pub angle: f64,
    pub y: Vec<f64>,
}

/// The best point found, with its proof.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Solution {
    pub x: Vec<f64>,
    /// True largest amount of each group.
    pub levels: Vec<f64>,
    pub value: f64,
    /// Nothing that holds the rows goes below this.
    pub bound: f64,
    /// Multipliers behind the bound.
    pub support: Vec<Support>,
    /// Multiplier of each row.
    pub prices: Vec<f64>,
}

impl Programme {
    /// Whether a group is judged: it costs something or stands in a row.
    pub fn judged(&self, group: usize) -> bool {
        self.cost[group] > 0.0 || self.rows.iter().any(|r| r.shares.iter().any(|s| s.0 == group))
    }

    /// The programme with `x = origin + directions z` put in. Groups that the `z` do not touch become numbers.
    pub fn restricted(&self, origin: &[f64], directions: &Matrix) -> Programme {
        let group = |group: &Group| Group {
            members: group.members.iter().map(|m| m.restricted(origin, directions)).collect(),
            reach: group.reach,
        };
        let into = |row: &[f64]| {
            let mut result = vec![0.0; directions.columns];
            directions.add_transposed(row, 1.0, &mut result);
            result
        };
        Programme {
            variables: directions.columns,
            grid: Rc::clone(&self.grid),
            groups: self.groups.iter().map(group).collect(),
            rows: self
                .rows
                .iter()
                .map(|r| Row {
                    shares: r.shares.clone(),
                    directions: into(&r.directions),
                    most: r.most - dot(&r.directions, origin),
                })
                .collect(),
            cost: self.cost.clone(),
            linear: into(&self.linear),
            offset: self.offset + dot(&self.linear, origin),
            holds: self.holds,
        }
    }

    /// Groups of one fixed vector each that are judged, where these are many, as those of a mean over the cycle: it has one
    /// at every angle.
    pub fn terms_of_a_mean(&self) -> Vec<bool> {
        let single = |group: usize| matches!(self.groups[group].members[..], [Member::Vector { .. }]);
        let terms: Vec<bool> =
            (0..self.groups.len()).map(|group| single(group) && self.judged(group)).collect();
        let many = terms.iter().filter(|term| **term).count() > MANY;
        terms.into_iter().map(|term| term && many).collect()
    }

    /// All coefficients of the variables that anything judged depends on, one row each.
    pub fn seen(&self) -> Matrix {
        let mut seen = Matrix::zeros(0, self.variables);
        for (index, group) in self.groups.iter().enumerate() {
            if self.judged(index) {
                group.add_directions(&mut seen);
            }
        }
        self.rows.iter().for_each(|r| seen.push(&r.directions));
        seen.push(&self.linear);
        seen
    }

    /// True largest amount of every judged group at `x` (0 for the others).
    pub fn levels(&self, x: &[f64]) -> Vec<f64> {
        let level = |group: usize| {
            if !self.judged(group) {
                return 0.0;
            }
            let mut level = 0.0f64;
            for member in &self.groups[group].members {
                level = level.max(member.summits(&self.grid, x, level)[0].amount);
            }
            level
        };
        (0..self.groups.len()).map(level).collect()
    }

    /// What is minimised.
    pub fn value(&self, x: &[f64], levels: &[f64]) -> f64 {
        dot(&self.cost, levels) + dot(&self.linear, x) + self.offset
    }

    /// How far row `r` is passed (negative: room left).
    pub fn excess(&self, r: usize, x: &[f64], levels: &[f64]) -> f64 {
        let row = &self.rows[r];
        let shares: f64 = row.shares.iter().map(|&(g, share)| share * levels[g]).sum();
        shares + dot(&row.directions, x) - row.most
    }

    /// The most that any row is passed, as a share of it (of a thousandth for a smaller one).
    pub fn violation(&self, x: &[f64], levels: &[f64]) -> f64 {
        let share = |r: usize| self.excess(r, x, levels) / self.rows[r].most.abs().max(LEAST);
        (0..self.rows.len()).map(share).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Weight that the multipliers of a group add up to: `c_g + SUM of b_rg price_r`.
    pub fn weight(&self, group: usize, prices: &[f64]) -> f64 {
        let mut weight = self.cost[group];
        for (row, price) in self.rows.iter().zip(prices) {
            weight += row.shares.iter().filter(|s| s.0 == group).map(|s| s.1 * price).sum::<f64>();
        }
        weight
    }

    /// Radius around 0 that holds every point which is as good as `value` and keeps the rows, from the mean square of
    /// every curve (Parseval) and the vectors; infinite where something is seen by rows of variables alone.
    pub fn radius(&self, value: f64) -> f64 {
        let mut stack = Matrix::zeros(0, self.variables);
        let mut constant = 0.0;
        for (index, group) in self.groups.iter().enumerate() {
            let Some(most) = self.most_level(index, value) else { continue };
            for member in &group.members {
                // Mean |g|^2 <= most^2 bounds half the squares of the coefficients.
                let (base, factor) = match member {
                    Member::Curve(curve) => (curve.touched_coefficients(), 1.0 / (2f64.sqrt() * most)),
                    Member::Vector { base, .. } => (base.clone(), 1.0 / most),
                };
                let columns = member.columns();
                for i in 0..columns.rows {
                    let mut row = vec![0.0; self.variables];
                    add_scaled(&mut row, factor, columns.row(i));
                    stack.push(&row);
                }
                constant += dot(&base, &base) * factor * factor + 1.0;
            }
        }
        let factors = RowFactors::of(&stack, 1e-13);
        if self.variables == 0 {
            0.0
        } else if factors.rank() < self.variables {
            f64::INFINITY
        } else {
            2.0 * constant.sqrt() / factors.least_singular_value()
        }
    }

    /// The largest level that a group can have at any point as good as `value`.
    fn most_level(&self, group: usize, value: f64) -> Option<f64> {
        let by_cost = (self.cost[group] > 0.0 && self.linear.iter().all(|p| *p == 0.0))
            .then(|| (value - self.offset) / self.cost[group]);
        let by_rows = self.rows.iter().filter(|r| r.directions.iter().all(|h| *h == 0.0)).filter_map(|r| {
            let share = r.shares.iter().find(|s| s.0 == group)?;
            Some(r.most / share.1)
        });
        by_cost.into_iter().chain(by_rows).filter(|most| *most > 0.0).reduce(f64::min)
    }
}
