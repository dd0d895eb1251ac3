//! The conditions of optimality with the angles of the peaks as unknowns, and Newton's method on them.
//!
//! ```text
//! p + SUM m_k A_k^T u_k + SUM price_r h_r + SUM A_i^T y_i = 0       u_k = a_k / |a_k|
//! c_g + SUM b_rg price_r - SUM over k in g of m_k = 0
//! |a_k| = t_g          at the angle where |a_k| is largest
//! SUM b_rg t_g + h_r x = B_r     for the rows that hold it up
//! a_i = 0              for what vanishes: vectors, and curves at all the angles that they are judged at
//! ```
//! An angle that follows its peak adds `m q q^T / curvature` to the second derivative, with `q = (A'^T a + A^T a') / |a|`.
//! The system is regularised so that more peaks than needed do no harm; since every step starts from the true
//! residuals, that costs steps and no accuracy.

use super::curve::{Member, apart};
use super::dense::{Matrix, add_scaled, dot, eliminate, norm};
use super::programme::{Programme, Row};

/// A peak with less curvature than this share of its amount does not say where it would move to.
const STEADY: f64 = 1e-6;

/// A peak that holds the optimum up.
#[derive(Debug, Clone)]
pub(crate) struct Peak {
    pub group: usize,
    pub member: usize,
    pub angle: f64,
    pub multiplier: f64,
}

/// What vanishes, judged at an angle.
#[derive(Debug, Clone)]
pub(crate) struct Pin {
    pub group: usize,
    pub member: usize,
    pub angle: f64,
    /// Its multiplier.
    pub y: Vec<f64>,
}

/// What a peak contributes at the present point.
struct Local {
    amount: f64,
    /// `A^T u`.
    pull: Vec<f64>,
    /// `A`.
    directions: Matrix,
    unit: Vec<f64>,
    /// `q` over the root of the curvature.
    follow: Option<Vec<f64>>,
}

/// A point with what holds it up.
pub(crate) struct State<'a> {
    pub programme: &'a Programme,
    pub x: Vec<f64>,
    pub levels: Vec<f64>,
    pub peaks: Vec<Peak>,
    pub pinned: Vec<Pin>,
    /// Rows that hold it up, with their prices.
    pub rows: Vec<(usize, f64)>,
}

/// What is to be taken in among what holds the point up.
pub(crate) enum Newcomer {
    Peak(Peak),
    Row(usize),
}

/// Unknowns: variables, levels of the groups with peaks, multipliers, prices, multipliers of what is pinned.
struct System {
    matrix: Matrix,
    right: Vec<f64>,
    groups: Vec<usize>,
    variables: usize,
    at_peak: usize,
    at_row: usize,
    at_pin: usize,
}

impl System {
    fn level(&self, group: usize) -> Option<usize> {
        self.groups.binary_search(&group).ok().map(|k| self.variables + k)
    }

    /// How the excess of a peak over its level depends on variables and levels.
    fn peak_column(&self, group: usize, pull: &[f64]) -> Option<Vec<f64>> {
        let mut column = pull.to_vec();
        column.resize(self.at_peak, 0.0);
        column[self.level(group)?] = -1.0;
        Some(column)
    }

    /// How the excess of a row depends on variables and levels.
    fn row_column(&self, row: &Row) -> Vec<f64> {
        let mut column = row.directions.clone();
        column.resize(self.at_peak, 0.0);
        for &(group, share) in &row.shares {
            if let Some(level) = self.level(group) {
                column[level] += share;
            }
        }
        column
    }

    /// Puts a condition in as a row and a column.
    fn border(&mut self, line: usize, column: &[f64]) {
        for (j, value) in column.iter().enumerate() {
            self.matrix[(line, j)] = *value;
            self.matrix[(j, line)] = *value;
        }
    }
}

impl<'a> State<'a> {
    pub fn member(&self, peak: &Peak) -> &'a Member {
        let programme: &'a Programme = self.programme;
        &programme.groups[peak.group].members[peak.member]
    }

    /// Moves every angle to its peak; peaks that meet become one. Where the amount is level over a stretch (a vector that
    /// only turns) angles stay where they are.
    pub fn follow_peaks(&mut self) {
        let step = std::f64::consts::TAU / self.programme.grid.len() as f64;
        let mut kept: Vec<Peak> = Vec::new();
        for peak in std::mem::take(&mut self.peaks) {
            let mut peak = peak;
            if let Member::Curve(curve) = self.member(&peak) {
                let here = curve.at(&self.x);
                let (first, second) = here.jet(peak.angle).square_slope();
                let size = here.jet(peak.angle).square();
                if first.abs().max(second.abs()) > STEADY * size {
                    peak.angle = here.climb(peak.angle, step).rem_euclid(std::f64::consts::TAU);
                }
            }
            let twin = kept.iter_mut().find(|k| {
                k.group == peak.group && k.member == peak.member && apart(k.angle, peak.angle) < 1e-7
            });
            match twin {
                Some(twin) => twin.multiplier += peak.multiplier,
                None => kept.push(peak),
            }
        }
        self.peaks = kept;
    }

    fn local(&self, peak: &Peak) -> Option<Local> {
        let member = self.member(peak);
        let n = self.x.len();
        let value = member.value(peak.angle, &self.x);
        let amount = norm(&value);
        if amount <= 0.0 {
            return None;
        }
        let unit: Vec<f64> = value.iter().map(|v| v / amount).collect();
        let directions = member.directions(peak.angle);
        let mut pull = vec![0.0; n];
        directions.add_transposed(&unit, 1.0, &mut pull);
        let follow = match member {
            Member::Curve(curve) => {
                let jet = curve.at(&self.x).jet(peak.angle);
                let curvature = -jet.square_slope().1 / amount;
                let (_, slope) = curve.directions(peak.angle);
                let mut q = vec![0.0; n];
                slope.add_transposed(&unit, 1.0, &mut q);
                directions.add_transposed(&jet.slope.map(|s| s / amount), 1.0, &mut q);
                (curvature > STEADY * amount).then(|| q.iter().map(|q| q / curvature.sqrt()).collect())
            }
            Member::Vector { .. } => None,
        };
        Some(Local { amount, pull, directions, unit, follow })
    }

    /// The system of the conditions at the present point.
    fn system(&self) -> Option<System> {
        let n = self.x.len();
        let locals: Vec<Local> = self.peaks.iter().map(|p| self.local(p)).collect::<Option<_>>()?;
        let mut groups: Vec<usize> = self.peaks.iter().map(|p| p.group).collect();
        groups.sort_unstable();
        groups.dedup();
        let at_peak = n + groups.len();
        let at_row = at_peak + self.peaks.len();
        let at_pin = at_row + self.rows.len();
        let pinned = |pin: &Pin| &self.programme.groups[pin.group].members[pin.member];
        let size = at_pin + self.pinned.iter().map(|pin| pinned(pin).dimension()).sum::<usize>();
        let mut system = System {
            matrix: Matrix::zeros(size, size),
            right: vec![0.0; size],
            groups,
            variables: n,
            at_peak,
            at_row,
            at_pin,
        };
        let mut gradient = self.programme.linear.clone();
        for (k, (peak, local)) in self.peaks.iter().zip(&locals).enumerate() {
            add_scaled(&mut gradient, peak.multiplier, &local.pull);
            self.add_curvature(&mut system.matrix, peak.multiplier, local);
            let column = system.peak_column(peak.group, &local.pull)?;
            system.border(at_peak + k, &column);
            system.right[at_peak + k] = self.levels[peak.group] - local.amount;
        }
        for (place, &group) in system.groups.iter().enumerate() {
            let sum: f64 = self.peaks.iter().filter(|p| p.group == group).map(|p| p.multiplier).sum();
            system.right[n + place] = sum - self.weight(group);
        }
        for (k, &(r, price)) in self.rows.iter().enumerate() {
            let row = &self.programme.rows[r];
            add_scaled(&mut gradient, price, &row.directions);
            let column = system.row_column(row);
            system.border(at_row + k, &column);
            system.right[at_row + k] = -self.programme.excess(r, &self.x, &self.levels);
        }
        let mut line = at_pin;
        for pin in &self.pinned {
            let value = pinned(pin).value(pin.angle, &self.x);
            let columns = pinned(pin).directions(pin.angle);
            columns.add_transposed(&pin.y, 1.0, &mut gradient);
            for m in 0..columns.rows {
                let mut column = columns.row(m).to_vec();
                column.resize(at_peak, 0.0);
                system.border(line, &column);
                system.right[line] = -value[m];
                line += 1;
            }
        }
        for j in 0..n {
            system.right[j] = -gradient[j];
        }
        let largest = (0..n).map(|j| system.matrix[(j, j)]).fold(1e-3, f64::max);
        for j in 0..size {
            system.matrix[(j, j)] += if j < at_peak { 1e-9 * largest } else { -1e-11 };
        }
        Some(system)
    }

    /// One step of Newton's method; its size.
    pub fn step(&mut self) -> Option<f64> {
        let system = self.system()?;
        let step = eliminate(system.matrix.clone(), system.right.clone())?;
        self.advance(&system, &step, 1.0);
        self.follow_peaks();
        let (at_peak, at_row) = (system.at_peak, system.at_row);
        Some(norm(&step[..at_peak]).max(norm(&step[at_peak..at_row]) * 1e-4))
    }

    /// Moves all unknowns along a solution of the system.
    fn advance(&mut self, system: &System, step: &[f64], factor: f64) {
        add_scaled(&mut self.x, factor, &step[..system.variables]);
        for (place, &group) in system.groups.iter().enumerate() {
            self.levels[group] += factor * step[system.variables + place];
        }
        for (k, peak) in self.peaks.iter_mut().enumerate() {
            peak.multiplier += factor * step[system.at_peak + k];
        }
        for (k, row) in self.rows.iter_mut().enumerate() {
            row.1 += factor * step[system.at_row + k];
        }
        let mut line = system.at_pin;
        for pin in &mut self.pinned {
            for m in 0..self.programme.groups[pin.group].members[pin.member].dimension() {
                pin.y[m] += factor * step[line];
                line += 1;
            }
        }
    }

    /// Lets a peak or a row that is passed take its part of the load, while others give theirs up one by one: the dual
    /// step of an active-set method. `false` where nothing can give way.
    pub fn admit(&mut self, newcomer: Newcomer) -> Option<bool> {
        let mut own = 0.0;
        for _ in 0..40 {
            let system = self.system()?;
            let (column, passed) = match &newcomer {
                Newcomer::Peak(peak) => {
                    let local = self.local(peak)?;
                    (system.peak_column(peak.group, &local.pull)?, local.amount - self.levels[peak.group])
                }
                Newcomer::Row(r) => {
                    let excess = self.programme.excess(*r, &self.x, &self.levels);
                    (system.row_column(&self.programme.rows[*r]), excess)
                }
            };
            let mut right: Vec<f64> = column.iter().map(|c| -c).collect();
            right.resize(system.right.len(), 0.0);
            let response = eliminate(system.matrix.clone(), right)?;
            let slope = dot(&column, &response[..system.at_peak]);
            let full = if slope < 0.0 { passed.max(0.0) / -slope } else { f64::INFINITY };
            let held = self.peaks.iter().map(|p| p.multiplier).chain(self.rows.iter().map(|r| r.1));
            let mut first: Option<(usize, f64)> = None;
            for (k, multiplier) in held.enumerate() {
                let rate = response[system.at_peak + k];
                let until = multiplier.max(0.0) / -rate;
                if rate < 0.0 && first.is_none_or(|f| until < f.1) {
                    first = Some((k, until));
                }
            }
            match first {
                Some((k, until)) if until < full => {
                    self.advance(&system, &response, until);
                    own += until;
                    self.drop_held(k);
                }
                _ if full.is_finite() => {
                    self.advance(&system, &response, full);
                    own += full;
                    match newcomer {
                        Newcomer::Peak(peak) => self.peaks.push(Peak { multiplier: own, ..peak }),
                        Newcomer::Row(r) => self.rows.push((r, own)),
                    }
                    return Some(true);
                }
                _ => return Some(false),
            }
        }
        Some(false)
    }

    /// Drops peak `k`, or the row beyond the peaks.
    fn drop_held(&mut self, k: usize) {
        if k < self.peaks.len() {
            self.peaks.remove(k);
        } else {
            self.rows.remove(k - self.peaks.len());
        }
    }

    pub fn weight(&self, group: usize) -> f64 {
        let mut prices = vec![0.0; self.programme.rows.len()];
        self.rows.iter().for_each(|&(r, price)| prices[r] = price);
        self.programme.weight(group, &prices)
    }

    /// Second derivative of `m |a|` by `x`, its angle following the peak.
    fn add_curvature(&self, matrix: &mut Matrix, multiplier: f64, local: &Local) {
        let n = self.x.len();
        let factor = multiplier.max(0.0) / local.amount;
        // A^T (1 - u u^T) A.
        for m in 0..local.directions.rows {
            for i in 0..n {
                let left = local.directions[(m, i)] - local.unit[m] * local.pull[i];
                if left == 0.0 {
                    continue;
                }
                for j in 0..n {
                    matrix[(i, j)] += factor * left * local.directions[(m, j)];
                }
            }
        }
        if let Some(q) = &local.follow {
            for i in 0..n {
                for j in 0..n {
                    matrix[(i, j)] += multiplier.max(0.0) * q[i] * q[j];
                }
            }
        }
    }
}
