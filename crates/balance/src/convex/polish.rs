//! The last digits: Newton's method on the conditions of optimality, with the angles of the peaks as unknowns.
//!
//! ```text
//! p + SUM m_k A_k^T u_k + SUM price_r h_r + SUM A_i^T y_i = 0       u_k = a_k / |a_k|
//! c_g + SUM b_rg price_r - SUM over k in g of m_k = 0
//! |a_k| = t_g          at the angle where |a_k| is largest
//! SUM b_rg t_g + h_r x = B_r     for the rows that hold it up
//! a_i = 0              for vectors that vanish
//! ```
//! An angle that follows its peak adds `m q q^T / curvature` to the second derivative, with `q = (A'^T a + A^T a') / |a|`.
//! The system is regularised so that more peaks than needed do no harm; since every step starts from the true
//! residuals, that costs steps and no accuracy.

use super::cone::ConePoint;
use super::curve::{Member, Vector, WIDTH, inner, length};
use super::dense::{Matrix, add_scaled, eliminate, norm};
use super::exchange::apart;
use super::programme::{Programme, Support};

/// A point with its multipliers.
pub(crate) struct Polished {
    pub x: Vec<f64>,
    pub support: Vec<Support>,
    pub prices: Vec<f64>,
}

/// Multipliers below this share of their group's weight are taken for noise of the interior-point method.
const NOISE: f64 = 1e-5;

/// A peak with less curvature than this share of its amount does not say where it would move to.
const STEADY: f64 = 1e-7;

/// Vectors below this amount are taken to vanish.
const VANISHES: f64 = 1e-6;

/// Rounds in which peaks and rows may come and go.
const MOST_ROUNDS: usize = 30;

/// A peak that holds the optimum up.
#[derive(Debug, Clone)]
struct Peak {
    group: usize,
    member: usize,
    angle: f64,
    multiplier: f64,
}

/// What a peak contributes at the present point.
struct Local {
    amount: f64,
    /// `A^T u`.
    pull: Vec<f64>,
    /// `A`.
    directions: Matrix,
    unit: Vector,
    /// `q` over the root of the curvature.
    follow: Option<Vec<f64>>,
}

struct State<'a> {
    programme: &'a Programme,
    x: Vec<f64>,
    levels: Vec<f64>,
    peaks: Vec<Peak>,
    /// Vectors that vanish, with their multipliers.
    pinned: Vec<(usize, Vector)>,
    /// Rows that hold it up, with their prices.
    rows: Vec<(usize, f64)>,
}

/// Improves the point of the interior-point method; `None` where Newton's method does not settle.
pub(crate) fn polish(programme: &Programme, point: &ConePoint) -> Option<Polished> {
    let mut state = State::of(programme, point);
    let mut seen = 0;
    while seen < MOST_ROUNDS {
        seen += 1;
        let step = state.step()?;
        if !step.is_finite() || step > 1e3 {
            return None;
        }
        let changed = if step < 1e-3 { state.revise(step < 1e-9) } else { false };
        if !changed && step < 1e-13 {
            break;
        }
    }
    Some(state.finish())
}

impl<'a> State<'a> {
    fn of(programme: &'a Programme, point: &ConePoint) -> State<'a> {
        let levels = programme.levels(&point.x);
        let mut state = State {
            programme,
            x: point.x.clone(),
            levels,
            peaks: Vec::new(),
            pinned: Vec::new(),
            rows: Vec::new(),
        };
        for (r, &price) in point.prices.iter().enumerate() {
            if price > NOISE {
                state.rows.push((r, price));
            }
        }
        for one in &point.support {
            let weight = programme.weight(one.group, &point.prices);
            let size = length(&one.y);
            let member = &programme.groups[one.group].members[one.member];
            let vanishes = matches!(member, Member::Vector { .. })
                && length(&member.value(0.0, &state.x)) < VANISHES
                && programme.groups[one.group].members.len() == 1;
            if weight <= NOISE {
                continue;
            }
            if vanishes {
                state.pinned.push((one.group, one.y));
                state.levels[one.group] = 0.0;
            } else if size > NOISE * weight {
                state.peaks.push(Peak {
                    group: one.group,
                    member: one.member,
                    angle: one.angle,
                    multiplier: size,
                });
            }
        }
        state.follow_peaks();
        state
    }

    fn member(&self, peak: &Peak) -> &'a Member {
        let programme: &'a Programme = self.programme;
        &programme.groups[peak.group].members[peak.member]
    }

    /// Moves every angle to its peak; peaks that meet become one.
    fn follow_peaks(&mut self) {
        let step = std::f64::consts::TAU / self.programme.grid.len() as f64;
        let mut kept: Vec<Peak> = Vec::new();
        for peak in std::mem::take(&mut self.peaks) {
            let mut peak = peak;
            if let Member::Curve(curve) = self.member(&peak) {
                peak.angle = curve.at(&self.x).climb(peak.angle, step).rem_euclid(std::f64::consts::TAU);
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
        let amount = length(&value);
        if amount <= 0.0 {
            return None;
        }
        let unit = value.map(|v| v / amount);
        let directions = member.directions(peak.angle);
        let mut pull = vec![0.0; n];
        directions.add_transposed(&unit, 1.0, &mut pull);
        let follow = match member {
            Member::Curve(curve) => {
                let jet = curve.at(&self.x).jet(peak.angle);
                let curvature = -(inner(&jet.slope, &jet.slope) + inner(&jet.value, &jet.bend)) / amount;
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

    /// One step of Newton's method; its size.
    fn step(&mut self) -> Option<f64> {
        let n = self.x.len();
        let locals: Vec<Local> = self.peaks.iter().map(|p| self.local(p)).collect::<Option<_>>()?;
        // Unknowns: x, levels of the groups with peaks, multipliers, prices, multipliers of what is pinned.
        let mut groups: Vec<usize> = self.peaks.iter().map(|p| p.group).collect();
        for (r, _) in &self.rows {
            let shares = &self.programme.rows[*r].shares;
            groups.extend(shares.iter().map(|s| s.0).filter(|g| self.pinned.iter().all(|p| p.0 != *g)));
        }
        groups.sort_unstable();
        groups.dedup();
        let at_level = |group: usize| groups.iter().position(|&g| g == group).map(|k| n + k);
        let at_peak = n + groups.len();
        let at_row = at_peak + self.peaks.len();
        let at_pin = at_row + self.rows.len();
        let dimension = |group: usize| self.programme.groups[group].members[0].dimension();
        let size = at_pin + self.pinned.iter().map(|p| dimension(p.0)).sum::<usize>();
        let mut matrix = Matrix::zeros(size, size);
        let mut right = vec![0.0; size];

        let mut gradient = self.programme.linear.clone();
        for (peak, local) in self.peaks.iter().zip(&locals) {
            add_scaled(&mut gradient, peak.multiplier, &local.pull);
            self.add_curvature(&mut matrix, peak.multiplier, local);
        }
        for (k, (peak, local)) in self.peaks.iter().zip(&locals).enumerate() {
            let line = at_peak + k;
            for j in 0..n {
                matrix[(line, j)] = local.pull[j];
                matrix[(j, line)] = local.pull[j];
            }
            let level = at_level(peak.group)?;
            matrix[(line, level)] = -1.0;
            matrix[(level, line)] = -1.0;
            right[line] = self.levels[peak.group] - local.amount;
        }
        for &group in &groups {
            let weight = self.weight(group);
            let sum: f64 = self.peaks.iter().filter(|p| p.group == group).map(|p| p.multiplier).sum();
            right[at_level(group)?] = sum - weight;
        }
        for (k, &(r, price)) in self.rows.iter().enumerate() {
            let row = &self.programme.rows[r];
            add_scaled(&mut gradient, price, &row.directions);
            let line = at_row + k;
            for j in 0..n {
                matrix[(line, j)] = row.directions[j];
                matrix[(j, line)] = row.directions[j];
            }
            for &(group, share) in &row.shares {
                if let Some(level) = at_level(group) {
                    matrix[(line, level)] = share;
                    matrix[(level, line)] = share;
                }
            }
            right[line] = -self.programme.excess(r, &self.x, &self.levels);
        }
        let mut line = at_pin;
        for (group, y) in &self.pinned {
            let member = &self.programme.groups[*group].members[0];
            let value = member.value(0.0, &self.x);
            let columns = member.columns();
            columns.add_transposed(y, 1.0, &mut gradient);
            for m in 0..columns.rows {
                for j in 0..n {
                    matrix[(line, j)] = columns[(m, j)];
                    matrix[(j, line)] = columns[(m, j)];
                }
                right[line] = -value[m];
                line += 1;
            }
        }
        for j in 0..n {
            right[j] = -gradient[j];
        }
        let largest = (0..n).map(|j| matrix[(j, j)]).fold(1e-3, f64::max);
        for j in 0..size {
            matrix[(j, j)] += if j < at_peak { 1e-9 * largest } else { -1e-11 };
        }
        let step = eliminate(matrix, right)?;

        add_scaled(&mut self.x, 1.0, &step[..n]);
        for &group in &groups {
            self.levels[group] += step[at_level(group)?];
        }
        for (k, peak) in self.peaks.iter_mut().enumerate() {
            peak.multiplier += step[at_peak + k];
        }
        for (k, row) in self.rows.iter_mut().enumerate() {
            row.1 += step[at_row + k];
        }
        let mut line = at_pin;
        for (group, y) in &mut self.pinned {
            for m in 0..self.programme.groups[*group].members[0].dimension() {
                y[m] += step[line];
                line += 1;
            }
        }
        self.follow_peaks();
        Some(norm(&step[..at_peak]).max(norm(&step[at_peak..at_row]) * 1e-4))
    }

    fn weight(&self, group: usize) -> f64 {
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

    /// Drops what pushes the wrong way and, once the steps are small, adds what is passed; whether anything changed.
    fn revise(&mut self, settled: bool) -> bool {
        let worst_peak = (0..self.peaks.len())
            .min_by(|&a, &b| self.peaks[a].multiplier.total_cmp(&self.peaks[b].multiplier));
        if let Some(k) = worst_peak
            && self.peaks[k].multiplier < -1e-12
        {
            self.peaks.remove(k);
            return true;
        }
        if let Some(k) = self.rows.iter().position(|(_, price)| *price < -1e-12) {
            self.rows.remove(k);
            return true;
        }
        let over = self.pinned.iter().position(|(group, y)| length(y) > self.weight(*group) * (1.0 + 1e-9));
        if let Some(k) = over {
            let (group, y) = self.pinned.remove(k);
            let size = length(&y);
            self.levels[group] = 1e-6;
            // It leaves 0 along the way that its multiplier pulls.
            let member = &self.programme.groups[group].members[0];
            let direction = super::dense::least_squares(
                member.columns(),
                &y.map(|v| 1e-6 * v / size)[..member.dimension()],
                1e-12,
            );
            add_scaled(&mut self.x, 1.0, &direction);
            self.peaks.push(Peak { group, member: 0, angle: 0.0, multiplier: size });
            return true;
        }
        settled && self.add_passed()
    }

    /// Adds peaks that stand above their level and rows that are passed.
    fn add_passed(&mut self) -> bool {
        let programme: &'a Programme = self.programme;
        let before = (self.peaks.len(), self.rows.len());
        let active: Vec<usize> = self.peaks.iter().map(|p| p.group).collect();
        for group in 0..programme.groups.len() {
            if !active.contains(&group) {
                continue;
            }
            let level = self.levels[group];
            for (member, one) in programme.groups[group].members.iter().enumerate() {
                for summit in one.summits(&programme.grid, &self.x, level).into_iter().take(8) {
                    let known = self.peaks.iter().any(|p| {
                        p.group == group && p.member == member && apart(p.angle, summit.angle) < 1e-6
                    });
                    if !known && summit.amount > level * (1.0 + 1e-13) + 1e-15 {
                        self.peaks.push(Peak { group, member, angle: summit.angle, multiplier: 0.0 });
                    }
                }
            }
        }
        let levels = programme.levels(&self.x);
        for r in 0..programme.rows.len() {
            let known = self.rows.iter().any(|row| row.0 == r);
            if !known && programme.excess(r, &self.x, &levels) > 1e-13 {
                for &(group, _) in &programme.rows[r].shares {
                    self.enter(group, &levels);
                }
                self.rows.push((r, 0.0));
            }
        }
        before != (self.peaks.len(), self.rows.len())
    }

    /// A group that begins to matter enters with its highest peaks.
    fn enter(&mut self, group: usize, levels: &[f64]) {
        if self.peaks.iter().any(|p| p.group == group) || self.pinned.iter().any(|p| p.0 == group) {
            return;
        }
        let programme: &'a Programme = self.programme;
        self.levels[group] = levels[group];
        for (member, one) in programme.groups[group].members.iter().enumerate() {
            for summit in one.summits(&programme.grid, &self.x, levels[group]).into_iter().take(8) {
                if summit.amount >= levels[group] * (1.0 - 1e-9) {
                    self.peaks.push(Peak { group, member, angle: summit.angle, multiplier: 0.0 });
                }
            }
        }
    }

    fn finish(self) -> Polished {
        let mut prices = vec![0.0; self.programme.rows.len()];
        self.rows.iter().for_each(|&(r, price)| prices[r] = price.max(0.0));
        let mut support = Vec::new();
        for peak in self.peaks.iter().filter(|p| p.multiplier > 0.0) {
            let value = self.member(peak).value(peak.angle, &self.x);
            let amount = length(&value);
            let mut y = [0.0; WIDTH];
            for m in 0..WIDTH {
                y[m] = peak.multiplier * value[m] / amount;
            }
            support.push(Support { group: peak.group, member: peak.member, angle: peak.angle, y });
        }
        for (group, y) in &self.pinned {
            support.push(Support { group: *group, member: 0, angle: 0.0, y: *y });
        }
        Polished { x: self.x, support, prices }
    }
}
