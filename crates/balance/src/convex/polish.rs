//! The last digits: which peaks and rows hold the optimum up, and Newton's method on them ([`super::kkt`]).

use super::cone::ConePoint;
use super::curve::{Member, apart};
use super::dense::{add_scaled, least_squares, norm};
use super::kkt::{Newcomer, Peak, Pin, State};
use super::programme::{Programme, Support, largest};

/// A point with its multipliers.
pub(crate) struct Polished {
    pub x: Vec<f64>,
    pub support: Vec<Support>,
    pub prices: Vec<f64>,
}

/// Multipliers below this share of their group's weight are taken for noise of the interior-point method.
const NOISE: f64 = 1e-5;

/// Members that a unit of the variables moves by less than this share of their group's reach stay where they are.
const FIXED: f64 = 1e-7;

/// Vectors below this amount are taken to vanish, and curves that cost less than this share of all.
const VANISHES: f64 = 1e-6;

/// Peaks that stand above their level by less than this share of it are level.
const LEVEL: f64 = 2e-13;

/// Rounds in which peaks and rows may come and go.
const MOST_ROUNDS: usize = 60;

/// Improves the point of the interior-point method, with its true levels; `None` where Newton's method does not settle. A mean over
/// the cycle has a multiplier at every angle, too many for its dense equations, and is smooth: the interior-point method's digits
/// are enough.
pub(crate) fn polish(programme: &Programme, point: &ConePoint, levels: Vec<f64>) -> Option<Polished> {
    if programme.terms_of_a_mean().contains(&true) {
        return None;
    }
    let mut state = State::of(programme, point, levels);
    let mut before = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        let step = state.step()?;
        if !step.is_finite() || step > 1e3 {
            return None;
        }
        if step < 1e-3 && state.release() {
            continue;
        }
        // Nothing gives way to what is passed: the point is as good as it gets.
        let Some(changed) = (if step < 1e-8 { state.take_in() } else { Some(false) }) else { break };
        let stalls = step < 1e-9 && step > 0.3 * before;
        if !changed && (step < 1e-13 || stalls) {
            break;
        }
        before = if changed { f64::INFINITY } else { step };
    }
    Some(state.finish())
}

impl<'a> State<'a> {
    fn of(programme: &'a Programme, point: &ConePoint, levels: Vec<f64>) -> State<'a> {
        let mut state = State {
            programme,
            x: point.x.clone(),
            levels,
            peaks: Vec::new(),
            pinned: Vec::new(),
            rows: Vec::new(),
        };
        let value = programme.value(&state.x, &state.levels);
        let nothing: Vec<bool> = programme
            .cost
            .iter()
            .zip(&state.levels)
            .map(|(cost, level)| *cost > 0.0 && cost * level < VANISHES * value)
            .collect();
        for (r, &price) in point.prices.iter().enumerate() {
            if price > NOISE {
                state.rows.push((r, price));
            }
        }
        for one in &point.support {
            let weight = programme.weight(one.group, &point.prices);
            let size = norm(&one.y);
            let member = &programme.groups[one.group].members[one.member];
            let vanishes = match member {
                Member::Vector { .. } => {
                    norm(&member.value(0.0, &state.x)) < VANISHES
                        && programme.groups[one.group].members.len() == 1
                }
                Member::Curve(_) => nothing[one.group],
            };
            // A limit is not held up by what stages before have fixed.
            let fixed = programme.cost[one.group] == 0.0
                && largest(&member.directions(one.angle)) <= FIXED * programme.groups[one.group].reach;
            if weight <= NOISE || fixed {
                continue;
            }
            if vanishes {
                let Support { group, member, angle, y } = one.clone();
                state.pinned.push(Pin { group, member, angle, y });
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
        // Nor does a row hold anything up whose groups are all fixed.
        let acts = |group: usize| {
            state.peaks.iter().any(|p| p.group == group) || state.pinned.iter().any(|p| p.group == group)
        };
        state.rows.retain(|&(r, _)| {
            let row = &programme.rows[r];
            row.directions.iter().any(|h| *h != 0.0) || row.shares.iter().any(|s| acts(s.0))
        });
        state.follow_peaks();
        state
    }

    /// Drops what pushes the wrong way; whether there was any.
    fn release(&mut self) -> bool {
        if let Some(k) = self.rows.iter().position(|(_, price)| *price < -1e-12) {
            self.rows.remove(k);
            self.forget();
            return true;
        }
        let worst = (0..self.peaks.len())
            .min_by(|&a, &b| self.peaks[a].multiplier.total_cmp(&self.peaks[b].multiplier));
        if let Some(k) = worst
            && self.peaks[k].multiplier < -1e-12
        {
            self.peaks.remove(k);
            return true;
        }
        let over = self.pinned.iter().position(|pin| {
            let member = &self.programme.groups[pin.group].members[pin.member];
            matches!(member, Member::Vector { .. }) && norm(&pin.y) > self.weight(pin.group) * (1.0 + 1e-9)
        });
        let Some(k) = over else { return false };
        let Pin { group, y, .. } = self.pinned.remove(k);
        let size = norm(&y);
        self.levels[group] = VANISHES;
        // It leaves 0 along the way that its multiplier pulls.
        let member = &self.programme.groups[group].members[0];
        let wanted: Vec<f64> = y.iter().map(|v| VANISHES * v / size).collect();
        let direction = least_squares(member.columns(), &wanted, 1e-12);
        add_scaled(&mut self.x, 1.0, &direction);
        self.peaks.push(Peak { group, member: 0, angle: 0.0, multiplier: size });
        true
    }

    /// Groups without cost whose rows hold nothing up have no say.
    fn forget(&mut self) {
        let idle = |group: usize| {
            self.programme.cost[group] == 0.0
                && !self.rows.iter().any(|(r, _)| self.programme.rows[*r].shares.iter().any(|s| s.0 == group))
        };
        let keep: Vec<bool> = self.peaks.iter().map(|p| !idle(p.group)).collect();
        let mut keep = keep.into_iter();
        self.peaks.retain(|_| keep.next().unwrap_or(true));
    }

    /// Takes in the peak or the row that is passed most; whether there was any. `None` where nothing gives way.
    fn take_in(&mut self) -> Option<bool> {
        let programme: &'a Programme = self.programme;
        let mut highest: Option<(f64, Peak)> = None;
        let groups: Vec<usize> = self.peaks.iter().map(|p| p.group).collect();
        for group in (0..programme.groups.len()).filter(|g| groups.contains(g)) {
            let level = self.levels[group];
            for (member, one) in programme.groups[group].members.iter().enumerate() {
                for summit in one.summits(&programme.grid, &self.x, level).into_iter().take(8) {
                    let known = self.peaks.iter().any(|p| {
                        p.group == group && p.member == member && apart(p.angle, summit.angle) < 1e-6
                    });
                    let above = summit.amount - level * (1.0 + LEVEL) - 1e-15;
                    if !known && above > highest.as_ref().map_or(0.0, |h| h.0) {
                        highest = Some((above, Peak { group, member, angle: summit.angle, multiplier: 0.0 }));
                    }
                }
            }
        }
        if let Some((_, peak)) = highest {
            let admitted = self.admit(Newcomer::Peak(peak))?;
            self.forget();
            self.follow_peaks();
            return admitted.then_some(true);
        }
        let levels = programme.levels(&self.x);
        let passed = |r: usize| programme.excess(r, &self.x, &levels);
        let worst = (0..programme.rows.len())
            .filter(|r| self.rows.iter().all(|row| row.0 != *r))
            .max_by(|&a, &b| passed(a).total_cmp(&passed(b)));
        let Some(r) = worst.filter(|&r| passed(r) > 1e-13) else { return Some(false) };
        for &(group, _) in &programme.rows[r].shares {
            self.enter(group, &levels);
        }
        let admitted = self.admit(Newcomer::Row(r))?;
        self.forget();
        self.follow_peaks();
        admitted.then_some(true)
    }

    /// A group that begins to matter enters with its highest peak.
    fn enter(&mut self, group: usize, levels: &[f64]) {
        if self.peaks.iter().any(|p| p.group == group) || self.pinned.iter().any(|p| p.group == group) {
            return;
        }
        let programme: &'a Programme = self.programme;
        self.levels[group] = levels[group];
        let summits = programme.groups[group]
            .members
            .iter()
            .enumerate()
            .map(|(member, one)| (member, one.summits(&programme.grid, &self.x, levels[group])[0]));
        let highest = summits.max_by(|a, b| a.1.amount.total_cmp(&b.1.amount));
        if let Some((member, summit)) = highest {
            self.peaks.push(Peak { group, member, angle: summit.angle, multiplier: 0.0 });
        }
    }

    fn finish(self) -> Polished {
        let mut prices = vec![0.0; self.programme.rows.len()];
        self.rows.iter().for_each(|&(r, price)| prices[r] = price.max(0.0));
        let mut support = Vec::new();
        for peak in self.peaks.iter().filter(|p| p.multiplier > 0.0) {
            let value = self.member(peak).value(peak.angle, &self.x);
            let amount = norm(&value);
            let y = value.iter().map(|v| peak.multiplier * v / amount).collect();
            support.push(Support { group: peak.group, member: peak.member, angle: peak.angle, y });
        }
        for Pin { group, member, angle, y } in self.pinned {
            support.push(Support { group, member, angle, y });
        }
        Polished { x: self.x, support, prices }
    }
}
