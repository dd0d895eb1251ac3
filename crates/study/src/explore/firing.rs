//! When the cylinders of a crank fire: every cylinder at one of its top dead centres in the cycle.
//!
//! Cylinder j stands at top dead centre where its pin has a certain angle, `tau_j = b_j - a_j`: that of its axis where it is
//! centred. In
//! a four-stroke engine it fires in one of two revolutions, which is one bit of the firing code; cylinder 1 fires in the
//! first. Angles here count from the firing of cylinder 1.

use num_complex::Complex64;
use std::f64::consts::TAU;

/// Angles closer than this [rad] are one.
const SAME: f64 = 1e-9;

/// The angle in [0, 2 pi); one that misses the turn by rounding is 0.
fn turned(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if TAU - turned < SAME { 0.0 } else { turned }
}

/// What fires once a cycle: a cylinder, or the chamber of several pistons.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FiringUnit {
    /// Group whose throw drives it.
    pub group: usize,
    /// How far its pin stands ahead of the throw [rad].
    pub lead: f64,
    /// Angle of its pin at its top dead centre [rad].
    pub axis: f64,
}

/// Which cylinders stand side by side in one bank.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Neighbours {
    /// Banks of so many cylinders, one after the other.
    Banks(usize),
    /// These pairs.
    Pairs(Vec<[usize; 2]>),
}

impl Neighbours {
    fn holds(&self, a: usize, b: usize) -> bool {
        match self {
            Neighbours::Banks(groups) => a / groups == b / groups && a.abs_diff(b) == 1,
            Neighbours::Pairs(pairs) => pairs.contains(&[a, b]) || pairs.contains(&[b, a]),
        }
    }
}

/// Top dead centres of a crank, and the firings on it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Firing {
    /// Top dead centres after that of cylinder 1 [rad], in [0, 2 pi), by cylinder.
    tops: Vec<f64>,
    /// Firing angles after that of cylinder 1 [rad], by cylinder.
    angles: Vec<f64>,
    /// Cylinders by firing angle.
    order: Vec<usize>,
    /// Length of a working cycle [rad].
    cycle: f64,
    neighbours: Neighbours,
}

impl Firing {
    pub fn new(revolutions: u32, neighbours: Neighbours) -> Firing {
        let cycle = TAU * f64::from(revolutions);
        Firing { tops: Vec::new(), angles: Vec::new(), order: Vec::new(), cycle, neighbours }
    }

    /// Top dead centres of another crank: pins and axes by cylinder.
    pub fn set_crank(&mut self, pins_and_axes: impl Iterator<Item = (f64, f64)>) {
        self.tops.clear();
        let mut first = None;
        for (pin, axis) in pins_and_axes {
            let top = axis - pin;
            let first = *first.get_or_insert(top);
            self.tops.push(turned(top - first));
        }
    }

    /// Whether firings even within `tolerance` [rad] are possible on this crank at all: a necessary condition, that no
    /// code which is even breaks.
    pub fn may_be_even(&self, tolerance: f64) -> bool {
        let count = self.tops.len() as f64;
        let interval = self.cycle / count;
        // The k-th firing is off its even place by at most k intervals' tolerance.
        let allowed = count * tolerance + 1e-6;
        let revolutions = (self.cycle / TAU).round() as u32;
        self.tops.iter().all(|top| {
            (0..revolutions).any(|revolution| {
                let angle = top + TAU * f64::from(revolution);
                let off = angle - (angle / interval).round() * interval;
                off.abs() <= allowed
            })
        })
    }

    /// Fires by code: bit j - 1 sends cylinder j + 1 into the second revolution.
    pub fn set_code(&mut self, code: u64) {
        self.angles.clear();
        for (index, top) in self.tops.iter().enumerate() {
            let second = index > 0 && code >> (index - 1) & 1 == 1;
            self.angles.push(top + if second { TAU } else { 0.0 });
        }
        self.order.clear();
        self.order.extend(0..self.angles.len());
        let angles = &self.angles;
        self.order.sort_unstable_by(|&a, &b| {
            // Angles that are one but for rounding stand by number.
            if (angles[a] - angles[b]).abs() < SAME { a.cmp(&b) } else { angles[a].total_cmp(&angles[b]) }
        });
    }

    /// Firing angles after that of cylinder 1 [rad], by cylinder.
    pub fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Largest difference of a firing interval from the even one [rad].
    pub fn unevenness(&self) -> f64 {
        let count = self.order.len();
        let even = self.cycle / count as f64;
        let interval = |k: usize| {
            let here = self.angles[self.order[k]];
            if k + 1 < count { self.angles[self.order[k + 1]] - here } else { self.cycle - here }
        };
        (0..count).map(|k| (interval(k) - even).abs()).fold(0.0, f64::max)
    }

    /// `|SUM e^{i h angle / 2}| / cylinders`.
    pub fn harmonic(&self, half_orders: u32) -> f64 {
        let factor = 0.5 * f64::from(half_orders);
        let sum: Complex64 = self.angles.iter().map(|angle| Complex64::cis(factor * angle)).sum();
        sum.norm() / self.angles.len() as f64
    }

    /// Successive firings of cylinders that stand side by side in one bank.
    pub fn neighbours(&self) -> usize {
        let count = self.order.len();
        let pairs = if count > 2 { count } else { count.saturating_sub(1) };
        (0..pairs).filter(|&k| self.neighbours.holds(self.order[k], self.order[(k + 1) % count])).count()
    }

    /// The code of an equivalent firing, on a crank that looks the same from there: `from` is the
    /// cylinder that stands where cylinder j stood, time runs backward if `reversed`.
    pub fn code_seen(&self, code: u64, from: impl Fn(usize) -> usize, reversed: bool) -> u64 {
        let angle = |cylinder: usize| {
            let second = cylinder > 0 && code >> (cylinder - 1) & 1 == 1;
            self.tops[cylinder] + if second { TAU } else { 0.0 }
        };
        let first = angle(from(0));
        let mut seen = 0;
        for j in 1..self.tops.len() {
            let after = angle(from(j)) - first;
            let after = if reversed { -after } else { after };
            // A whole number of turns, whatever rounding says.
            let turns = ((after - self.tops[j]) / TAU).round() as i64;
            if turns.rem_euclid(2) == 1 {
                seen |= 1 << (j - 1);
            }
        }
        seen
    }
}
