//! What a torque does to the kinetic energy over its period: true extremes of torque and of the accumulated energy.
//!
//! ```text
//! E(theta) = INTEGRAL from 0 to theta of (T - T_mean)                                                    (25.1)
//! dE = max E - min E                        largest excess energy                                       (25.2)
//! A  = INTEGRAL over the own period of |T - T_mean|        the twin thesis's "variation of energy"       (25.3)
//! ```
//! E has its extremes where T crosses its mean. The torque is smooth between breaks (knots of the pressures): each stretch is
//! integrated with the Gauss rule, crossings within it are roots.

use crate::curve::GAUSS;
use crate::extremes::root;
use crate::result::{Extreme, Extremes};
use serde::Serialize;

/// Share of a stretch by which its ends are avoided: the torque may jump there.
const INSIDE: f64 = 1e-9;

/// Torques that differ by less than this share of their range are the same.
const SAME: f64 = 1e-9;

/// Golden section: shrinks a bracket by this share a step.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Accumulated energy of a torque over its period.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EnergyVariation {
    /// Mean torque [N m].
    pub mean: f64,
    /// Largest excess energy [J], eq. (25.2).
    pub excess: f64,
    /// Crank angle [rad] at which the accumulated energy is highest: there the crank turns fastest.
    pub highest: f64,
    /// Crank angle [rad] at which it is lowest.
    pub lowest: f64,
    /// Own period of the torque [rad]: the shortest after which it repeats.
    pub own_period: f64,
    /// Integral of `|T - T_mean|` over the own period [J], eq. (25.3), as the twin thesis counts it.
    pub absolute: f64,
}

/// Angles of one period at which a torque may jump or bend, from 0 to the period, both included.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Breaks(Vec<f64>);

impl Breaks {
    /// From any angles, at least `count` equal stretches among them.
    pub fn new(period: f64, angles: impl Iterator<Item = f64>, count: usize) -> Breaks {
        let equal = (0..=count).map(|j| period * j as f64 / count as f64);
        let mut breaks: Vec<f64> = angles.map(|angle| angle.rem_euclid(period)).chain(equal).collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|next, kept| *next - *kept <= 1e-12 * period);
        if let Some(last) = breaks.last_mut() {
            *last = period;
        }
        Breaks(breaks)
    }

    fn period(&self) -> f64 {
        self.0[self.0.len() - 1]
    }

    /// Integral of `function` over the period.
    pub fn integral(&self, function: impl Fn(f64) -> f64) -> f64 {
        self.0.windows(2).map(|pair| gauss(pair[0], pair[1], &function)).sum()
    }

    /// The angles.
    pub fn angles(&self) -> &[f64] {
        &self.0
    }

    /// Integral of `function` from one angle to another with no break between them.
    pub fn stretch(&self, from: f64, to: f64, function: &impl Fn(f64) -> f64) -> f64 {
        if to > from { gauss(from, to, function) } else { 0.0 }
    }

    /// Largest and smallest value of `function` over the continuous angle.
    pub fn extremes(&self, function: impl Fn(f64) -> f64) -> Extremes {
        // Highest and lowest sample with its neighbours, in one pass.
        let mut best = [(f64::NEG_INFINITY, [0.0; 2], 0.0); 2];
        for pair in self.0.windows(2) {
            let points = points(pair[0], pair[1]);
            for (k, theta) in points.iter().enumerate() {
                let here = function(*theta);
                for (best, sign) in best.iter_mut().zip([1.0, -1.0]) {
                    if sign * here > best.0 {
                        let around = [points[k.saturating_sub(1)], points[(k + 1).min(points.len() - 1)]];
                        *best = (sign * here, around, *theta);
                    }
                }
            }
        }
        let refined = |(coarse, around, at): (f64, [f64; 2], f64), sign: f64| {
            let (fine, theta) = peak(around, &|theta| sign * function(theta));
            let (value, theta) = if fine > coarse { (fine, theta) } else { (coarse, at) };
            Extreme { value: sign * value, theta }
        };
        Extremes { max: refined(best[0], 1.0), min: refined(best[1], -1.0) }
    }

    /// Energy that `torque` stores and gives back, its mean given.
    pub fn energy(&self, mean: f64, torque: impl Fn(f64) -> f64) -> EnergyVariation {
        let over = |theta: f64| torque(theta) - mean;
        let (mut highest, mut lowest) = (Extreme::default(), Extreme::default());
        let (mut energy, mut absolute) = (0.0, 0.0);
        for pair in self.0.windows(2) {
            let mut from = pair[0];
            let mut step = |to: f64| {
                let work = gauss(from, to, &over);
                absolute += work.abs();
                energy += work;
                from = to;
                if energy > highest.value {
                    highest = Extreme { value: energy, theta: to };
                }
                if energy < lowest.value {
                    lowest = Extreme { value: energy, theta: to };
                }
            };
            let points = points(pair[0], pair[1]);
            let mut before = (points[0], over(points[0]));
            for theta in &points[1..] {
                let here = (*theta, over(*theta));
                if (before.1 > 0.0) != (here.1 > 0.0) {
                    step(root(before.0, before.1, here.0, here.1, over));
                }
                before = here;
            }
            step(pair[1]);
        }
        let parts = self.repeats(&torque);
        let start = |extreme: Extreme| if extreme.theta >= self.period() { 0.0 } else { extreme.theta };
        EnergyVariation {
            mean,
            excess: highest.value - lowest.value,
            highest: start(highest),
            lowest: start(lowest),
            own_period: self.period() / f64::from(parts),
            absolute: absolute / f64::from(parts),
        }
    }

    /// How often `torque` repeats in the period.
    fn repeats(&self, torque: &impl Fn(f64) -> f64) -> u32 {
        const ANGLES: usize = 97;
        let period = self.period();
        // Away from breaks, where a jump may fall on either side.
        let angles: Vec<f64> = (0..ANGLES).map(|j| period * (j as f64 + 0.417) / ANGLES as f64).collect();
        let values: Vec<f64> = angles.iter().map(|theta| torque(*theta)).collect();
        let (least, most) =
            values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(*v), m.max(*v)));
        let repeats = |parts: u32| {
            let shift = period / f64::from(parts);
            let mut pairs = angles.iter().zip(&values);
            pairs.all(|(theta, value)| (torque(theta + shift) - value).abs() <= SAME * (most - least))
        };
        (2..=64).rev().find(|parts| repeats(*parts)).unwrap_or(1)
    }
}

/// Places within a stretch, its ends avoided.
fn points(from: f64, to: f64) -> [f64; 6] {
    let h = to - from;
    [INSIDE, 0.2, 0.4, 0.6, 0.8, 1.0 - INSIDE].map(|x| from + x * h)
}

fn gauss(from: f64, to: f64, function: &impl Fn(f64) -> f64) -> f64 {
    let h = to - from;
    let pair =
        |(x, weight): &(f64, f64)| weight * (function(from + h * (0.5 - x)) + function(from + h * (0.5 + x)));
    h * GAUSS.iter().map(pair).sum::<f64>()
}

/// Largest value within a bracket, and where.
pub(crate) fn peak([mut from, mut to]: [f64; 2], value: &impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut left, mut right) = (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
    let (mut at_left, mut at_right) = (value(left), value(right));
    for _ in 0..60 {
        if at_left >= at_right {
            (to, right, at_right) = (right, left, at_left);
            left = to - GOLDEN * (to - from);
            at_left = value(left);
        } else {
            (from, left, at_left) = (left, right, at_right);
            right = from + GOLDEN * (to - from);
            at_right = value(right);
        }
    }
    if at_left >= at_right { (at_left, left) } else { (at_right, right) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn a_sine_torque_stores_twice_its_amplitude() {
        let breaks = Breaks::new(2.0 * TAU, [0.3, 7.1].into_iter(), 90);
        let torque = |theta: f64| 5.0 + 3.0 * (2.0 * theta).sin();
        let energy = breaks.energy(5.0, torque);
        // INTEGRAL of 3 sin 2t over its positive half: 3; of its size over its own period pi: 6.
        assert!((energy.excess - 3.0).abs() < 1e-13, "{energy:?}");
        assert!(
            (energy.own_period - PI).abs() < 1e-14 && (energy.absolute - 6.0).abs() < 1e-12,
            "{energy:?}"
        );
        let extremes = breaks.extremes(torque);
        assert!((extremes.max.value - 8.0).abs() < 1e-13 && (extremes.min.value - 2.0).abs() < 1e-13);
        assert!((extremes.max.theta.rem_euclid(PI) - PI / 4.0).abs() < 1e-6, "{extremes:?}");
    }

    #[test]
    fn a_jump_is_no_root() {
        // 1 in the first third, -1/2 after it, mean 0.
        let third = TAU / 3.0;
        let breaks = Breaks::new(TAU, [third].into_iter(), 7);
        let energy = breaks.energy(0.0, |t| if t.rem_euclid(TAU) < third { 1.0 } else { -0.5 });
        assert!(
            (energy.excess - third).abs() < 1e-14 && (energy.highest - third).abs() < 1e-12,
            "{energy:?}"
        );
        assert!((energy.absolute - 2.0 * third).abs() < 1e-13 && energy.own_period == TAU);
    }
}
