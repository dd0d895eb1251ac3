//! What a torque does to the kinetic energy over its period: true extremes of torque and of the accumulated energy.
//!
//! ```text
//! E(theta) = INTEGRAL from 0 to theta of (T - T_mean)                                                    (25.1)
//! dE = max E - min E                        largest excess energy                                       (25.2)
//! A  = INTEGRAL over the own period of |T - T_mean|        the twin thesis's "variation of energy"       (25.3)
//! ```
//! E has its extremes where T crosses its mean. The torque is smooth between breaks (knots of the pressures): each stretch is
//! integrated with the Gauss rule, crossings within it are roots.

use lanchester_numerics::{GAUSS_4, gauss, golden_section, illinois};
use lanchester_results::{Extreme, Extremes};
use serde::Serialize;

/// Stretches of a revolution within which no torque hides an extreme, at least: on one of them the rule of four points is exact to rounding.
pub(crate) const STRETCHES: usize = 360;

/// The same for a motion near locking: a stretch as a share of the widest part of an ordinary quadrature.
pub(crate) const SHARE_OF_WIDTH: f64 = 1.0 / 3.0;

/// Share of a stretch by which its ends are avoided: the torque may jump there.
const INSIDE: f64 = 1e-9;

/// Torques that differ by less than this share of their range are the same.
const SAME: f64 = 1e-9;

/// Peaks that differ by less than this share of the range are equal.
const EQUAL: f64 = 1e-12;

/// Steps of the golden section: a bracket of a degree shrinks to 1e-10 rad, far below what a difference of values can tell.
const STEPS: usize = 40;

/// Accumulated energy of a torque over its period.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
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

    /// The angles.
    pub fn angles(&self) -> &[f64] {
        &self.0
    }

    /// Integral of `function` from one angle to another with no break between them.
    pub fn stretch(&self, from: f64, to: f64, function: &impl Fn(f64) -> f64) -> f64 {
        if to > from { gauss(&GAUSS_4, from, to, function) } else { 0.0 }
    }

    /// `torque` at the places of every stretch.
    pub fn sample<F: Fn(f64) -> f64>(&self, torque: F) -> SampledTorque<'_, F> {
        let at = |pair: &[f64]| StretchValues {
            at_points: points(pair[0], pair[1]).map(&torque),
            at_gauss: gauss_points(pair[0], pair[1]).map(&torque),
        };
        let values = self.0.windows(2).map(at).collect();
        SampledTorque { breaks: self, values, torque }
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

/// A torque at the places of one stretch: those where extremes and crossings are looked for, and those of the Gauss rule.
#[derive(Debug, Clone, PartialEq)]
struct StretchValues {
    at_points: [f64; 3],
    at_gauss: [f64; 4],
}

impl StretchValues {
    fn plus(&self, other: &StretchValues) -> StretchValues {
        StretchValues {
            at_points: std::array::from_fn(|k| self.at_points[k] + other.at_points[k]),
            at_gauss: std::array::from_fn(|k| self.at_gauss[k] + other.at_gauss[k]),
        }
    }
}

/// A torque with its values at the places of all stretches: each is computed once.
#[derive(Debug, Clone)]
pub(crate) struct SampledTorque<'a, F> {
    breaks: &'a Breaks,
    values: Vec<StretchValues>,
    torque: F,
}

impl<'a, F: Fn(f64) -> f64> SampledTorque<'a, F> {
    /// This torque and another over the same breaks, together.
    pub fn plus<G: Fn(f64) -> f64>(
        &self,
        other: &SampledTorque<'a, G>,
    ) -> SampledTorque<'a, impl Fn(f64) -> f64> {
        let values = self.values.iter().zip(&other.values).map(|(one, other)| one.plus(other)).collect();
        let (one, two) = (&self.torque, &other.torque);
        SampledTorque { breaks: self.breaks, values, torque: move |theta| one(theta) + two(theta) }
    }

    fn stretches(&self) -> impl Iterator<Item = ([f64; 2], &StretchValues)> {
        self.breaks.0.windows(2).map(|pair| [pair[0], pair[1]]).zip(&self.values)
    }

    /// Integral over the period.
    pub fn integral(&self) -> f64 {
        self.stretches().map(|([from, to], values)| gauss_sum(to - from, &values.at_gauss)).sum()
    }

    /// Largest and smallest value over the continuous angle; of equal ones the first.
    pub fn extremes(&self) -> Extremes {
        let values = self.values.iter().flat_map(|values| values.at_points);
        let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(v), m.max(v)));
        let range = most - least;
        let highest = |sign: f64| self.highest(sign, sign * if sign > 0.0 { most } else { least }, range);
        Extremes { max: highest(1.0), min: highest(-1.0) }
    }

    /// Largest value of `sign` times the torque, as a value of the torque; `coarse` is its largest sample. Every hill is climbed
    /// that may reach higher than that: between two samples the torque rises by no more than it falls to the next.
    fn highest(&self, sign: f64, coarse: f64, range: f64) -> Extreme {
        let mut best = Extreme { value: f64::NEG_INFINITY, theta: 0.0 };
        let mut take = |value: f64, theta: f64| {
            if value > best.value + EQUAL * range {
                best = Extreme { value, theta };
            }
        };
        for ([from, to], values) in self.stretches() {
            let (points, values) = (points(from, to), values.at_points.map(|value| sign * value));
            for (k, here) in values.into_iter().enumerate() {
                let (before, after) = (k.saturating_sub(1), (k + 1).min(values.len() - 1));
                let fall = (here - values[before]).max(here - values[after]);
                if here < values[before] || here < values[after] || here + fall < coarse {
                    continue;
                }
                let (fine, theta) =
                    peak([points[before], points[after]], &|theta| sign * (self.torque)(theta));
                if fine > here { take(fine, theta) } else { take(here, points[k]) }
            }
        }
        Extreme { value: sign * best.value, theta: best.theta }
    }

    /// Energy that it stores and gives back, its mean given.
    pub fn energy(&self, mean: f64) -> EnergyVariation {
        let over = |theta: f64| (self.torque)(theta) - mean;
        let (mut highest, mut lowest) = (Extreme::default(), Extreme::default());
        let (mut energy, mut absolute) = (0.0, 0.0);
        let mut add = |work: f64, to: f64| {
            absolute += work.abs();
            energy += work;
            if energy > highest.value {
                highest = Extreme { value: energy, theta: to };
            }
            if energy < lowest.value {
                lowest = Extreme { value: energy, theta: to };
            }
        };
        for ([start, end], values) in self.stretches() {
            let mut from = start;
            let points = points(start, end);
            let mut before = (points[0], values.at_points[0] - mean);
            for (theta, value) in points.iter().zip(values.at_points).skip(1) {
                let here = (*theta, value - mean);
                if (before.1 > 0.0) != (here.1 > 0.0) {
                    let crossing = illinois(before.0, before.1, here.0, here.1, 0.0, over);
                    add(gauss(&GAUSS_4, from, crossing, over), crossing);
                    from = crossing;
                }
                before = here;
            }
            let rest = match from > start {
                true => gauss(&GAUSS_4, from, end, over),
                false => gauss_sum(end - start, &values.at_gauss.map(|value| value - mean)),
            };
            add(rest, end);
        }
        let parts = self.breaks.repeats(&self.torque);
        let period = self.breaks.period();
        let start = |extreme: Extreme| if extreme.theta >= period { 0.0 } else { extreme.theta };
        EnergyVariation {
            mean,
            excess: highest.value - lowest.value,
            highest: start(highest),
            lowest: start(lowest),
            own_period: period / f64::from(parts),
            absolute: absolute / f64::from(parts),
        }
    }
}

/// Places within a stretch, its ends avoided.
fn points(from: f64, to: f64) -> [f64; 3] {
    let h = to - from;
    [INSIDE, 0.5, 1.0 - INSIDE].map(|x| from + x * h)
}

/// Places of the Gauss rule in a stretch, in pairs about its middle.
fn gauss_points(from: f64, to: f64) -> [f64; 4] {
    let h = to - from;
    std::array::from_fn(|k| {
        let (x, _) = GAUSS_4[k / 2];
        from + h * if k % 2 == 0 { 0.5 - x } else { 0.5 + x }
    })
}

/// Integral over a stretch of length `h` of what has these values at [`gauss_points`].
fn gauss_sum(h: f64, values: &[f64; 4]) -> f64 {
    h * GAUSS_4
        .iter()
        .zip(values.chunks(2))
        .map(|((_, weight), pair)| weight * (pair[0] + pair[1]))
        .sum::<f64>()
}

/// Largest value within a bracket, and where.
pub(crate) fn peak([from, to]: [f64; 2], value: &impl Fn(f64) -> f64) -> (f64, f64) {
    let Ok((place, largest)) =
        golden_section(from, to, STEPS, |place| Ok::<f64, std::convert::Infallible>(value(place)));
    (largest, place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn of_two_hills_the_higher_is_found_where_samples_say_the_other() {
        // Seventeen stretches with samples at halves: the higher hill stands between two of them, the lower one on one.
        let place = 0.25 * TAU / 17.0;
        let breaks = Breaks::new(TAU, std::iter::empty(), 17);
        let torque = |theta: f64| (2.0 * (theta - place)).cos() * (1.0 + 1e-3 * (theta - place).cos());
        let extremes = breaks.sample(torque).extremes();
        assert!((extremes.max.value - 1.001).abs() < 1e-13, "{extremes:?}");
        assert!((extremes.max.theta - place).abs() < 1e-6, "{extremes:?}");
        let valleys = breaks.sample(|theta: f64| -torque(theta)).extremes();
        assert!((valleys.min.value + 1.001).abs() < 1e-13, "{valleys:?}");
    }

    #[test]
    fn a_sine_torque_stores_twice_its_amplitude() {
        let breaks = Breaks::new(2.0 * TAU, [0.3, 7.1].into_iter(), 90);
        let torque = |theta: f64| 5.0 + 3.0 * (2.0 * theta).sin();
        let sampled = breaks.sample(torque);
        let energy = sampled.energy(5.0);
        // INTEGRAL of 3 sin 2t over its positive half: 3; of its size over its own period pi: 6.
        assert!((energy.excess - 3.0).abs() < 1e-13, "{energy:?}");
        assert!(
            (energy.own_period - PI).abs() < 1e-14 && (energy.absolute - 6.0).abs() < 1e-12,
            "{energy:?}"
        );
        let extremes = sampled.extremes();
        assert!((extremes.max.value - 8.0).abs() < 1e-13 && (extremes.min.value - 2.0).abs() < 1e-13);
        assert!((extremes.max.theta.rem_euclid(PI) - PI / 4.0).abs() < 1e-6, "{extremes:?}");
    }

    #[test]
    fn a_jump_is_no_root() {
        // 1 in the first third, -1/2 after it, mean 0.
        let third = TAU / 3.0;
        let breaks = Breaks::new(TAU, [third].into_iter(), 7);
        let energy = breaks.sample(|t| if t.rem_euclid(TAU) < third { 1.0 } else { -0.5 }).energy(0.0);
        assert!(
            (energy.excess - third).abs() < 1e-14 && (energy.highest - third).abs() < 1e-12,
            "{energy:?}"
        );
        assert!((energy.absolute - 2.0 * third).abs() < 1e-13 && energy.own_period == TAU);
    }

    #[test]
    fn sampled_torques_add_up() {
        let breaks = Breaks::new(TAU, [1.0].into_iter(), 40);
        let (one, two) = (|theta: f64| 2.0 + theta.sin(), |theta: f64| 1.0 - 3.0 * (2.0 * theta).cos());
        let (of_one, of_two) = (breaks.sample(one), breaks.sample(two));
        let (together, at_once) = (of_one.plus(&of_two), breaks.sample(|theta| one(theta) + two(theta)));
        assert_eq!((together.energy(3.0), together.extremes()), (at_once.energy(3.0), at_once.extremes()));
        assert!((together.integral() - 3.0 * TAU).abs() < 1e-13, "{}", together.integral());
    }
}
