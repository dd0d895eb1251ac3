//! Largest and smallest values over a run, at every place that is looked at and between them.
//!
//! ```text
//! v(t1 + x) = v1 + s x + c x^2        top at x = -s/2c, of v1 - s^2/4c        where v1 is not below v0 and v2, and one of them is lower
//! ```
//! A top or a bottom between three places that follow one another is that of the parabola through them. Where a pressure jumps, an event changes what acts or friction takes hold, both sides
//! are looked at, and no parabola goes across.

use crate::reactions::Reactions;
use crate::run::extremes::{Bounds, CylinderExtremes, Peak, RotorExtremes, RunExtremes};
use crate::run::result::Samples;
use std::collections::VecDeque;

/// What is looked at in one place.
pub(crate) struct Seen<'a> {
    pub time: f64,
    pub theta: f64,
    pub speed: f64,
    /// Place of the block's origin and its quaternion, where it moves.
    pub pose: Option<([f64; 3], [f64; 4])>,
    pub mounts: &'a [[f64; 3]],
    /// Twists and torques of the driveline's springs.
    pub springs: &'a [[f64; 2]],
    pub reactions: Option<&'a Reactions>,
}

/// Rotation vector of a unit quaternion `(w, x, y, z)` [rad].
fn rotation_vector([w, x, y, z]: [f64; 4]) -> [f64; 3] {
    let sine = (x * x + y * y + z * z).sqrt();
    // The shorter way round; of a small turn the sine is its half.
    let size = 2.0 * sine.atan2(w.abs()) * w.signum();
    let factor = if sine > 0.0 { size / sine } else { 0.0 };
    [factor * x, factor * y, factor * z]
}

fn square(force: &[f64]) -> f64 {
    force.iter().map(|part| part * part).sum()
}

impl Seen<'_> {
    /// All values one after the other, in the order that [`Values`] takes them in; of forces that have a size the square of it.
    fn values(&self, out: &mut Vec<f64>) {
        out.clear();
        out.push(self.speed);
        if let Some((position, orientation)) = self.pose {
            out.extend(position);
            out.extend(rotation_vector(orientation));
        }
        out.extend(self.mounts.iter().map(|force| square(force)));
        out.extend(self.springs.iter().map(|spring| spring[1]));
        let Some(reactions) = self.reactions else { return };
        out.push(reactions.shaft_torque);
        for own in &reactions.cylinders {
            out.push(own.side_thrust * own.side_thrust);
            out.push(square(&own.piston_pin.force));
            out.push(square(&own.lower_pin.force));
            out.extend(own.throw_frame);
        }
        for rotor in &reactions.rotors {
            for rule in rotor.mains.iter() {
                out.extend(rule.iter().map(|force| square(force)));
            }
            out.push(rotor.gear_torque);
            out.push(square(&rotor.gear_force));
            out.push(square(&rotor.bearings.force));
            out.push(square(&rotor.bearings.moment[..2]));
        }
    }

    /// The bounds of [`Seen::values`] by their names.
    fn named(&self, bounds: &[Bounds]) -> RunExtremes {
        let mut rest = bounds.iter().copied();
        let mut next = || rest.next().unwrap_or_default();
        let speed = next();
        let of_pose = if self.pose.is_some() { 3 } else { 0 };
        let position = (0..of_pose).map(|_| next()).collect();
        let turn = (0..of_pose).map(|_| next()).collect();
        let size = |bounds: Bounds| Peak { value: bounds.most.value.max(0.0).sqrt(), ..bounds.most };
        let mounts = self.mounts.iter().map(|_| size(next())).collect();
        let driveline = self.springs.iter().map(|_| next()).collect();
        let mut all = RunExtremes { speed, position, turn, mounts, driveline, ..RunExtremes::default() };
        let Some(reactions) = self.reactions else { return all };
        all.shaft_torque = Some(next());
        let cylinder = |_| CylinderExtremes {
            side_thrust: size(next()),
            piston_pin: size(next()),
            lower_pin: size(next()),
            along_throw: next(),
            across_throw: next(),
        };
        all.cylinders = reactions.cylinders.iter().map(cylinder).collect();
        for rotor in &reactions.rotors {
            let mains = [0, 1, 2].map(|rule| rotor.mains[rule].iter().map(|_| size(next())).collect());
            all.rotors.push(RotorExtremes {
                mains,
                gear_torque: next(),
                gear_force: size(next()),
                bearing_force: size(next()),
                bearing_moment: size(next()),
            });
        }
        all
    }
}

/// How many times one step may be longer than the next for a parabola through them.
const UNEVEN: f64 = 50.0;

/// Bounds of many values over places that follow one another.
#[derive(Default)]
struct Fold {
    bounds: Vec<Bounds>,
    /// The last two places, the older one first: time, angle, values.
    before: [(f64, f64, Vec<f64>); 2],
    /// How many of them are joined to the next place.
    joined: usize,
}

impl Fold {
    /// One place more; `apart`: no parabola from the one before it.
    fn push(&mut self, [time, theta]: [f64; 2], apart: bool, values: &[f64]) {
        if self.bounds.is_empty() {
            let none = |value| Peak { value, time, theta };
            let all = Bounds { most: none(f64::NEG_INFINITY), least: none(f64::INFINITY) };
            self.bounds = vec![all; values.len()];
        }
        if apart || time <= self.before[1].0 {
            self.joined = 0;
        }
        for (bounds, &value) in self.bounds.iter_mut().zip(values) {
            if value > bounds.most.value {
                bounds.most = Peak { value, time, theta };
            }
            if value < bounds.least.value {
                bounds.least = Peak { value, time, theta };
            }
        }
        if self.joined == 2 {
            self.between([time, theta], values);
        }
        self.before.swap(0, 1);
        let last = &mut self.before[1];
        (last.0, last.1) = (time, theta);
        last.2.clear();
        last.2.extend_from_slice(values);
        self.joined = (self.joined + 1).min(2);
    }

    /// Tops and bottoms about the middle one of three places.
    fn between(&mut self, [time, theta]: [f64; 2], values: &[f64]) {
        let [(t0, theta0, first), (t1, theta1, middle)] = &self.before;
        let (h1, h2) = (t1 - t0, time - t1);
        // Beside a place that is much nearer, rounding would make the parabola.
        if h1.max(h2) > UNEVEN * h1.min(h2) {
            return;
        }
        // Slope at the middle place and half the curvature.
        let parabola = |v0: f64, v1: f64, v2: f64| {
            let (d1, d2) = ((v1 - v0) / h1, (v2 - v1) / h2);
            ((d1 * h2 + d2 * h1) / (h1 + h2), (d2 - d1) / (h1 + h2))
        };
        let (turned, bent) = parabola(*theta0, *theta1, theta);
        let at = |v0: f64, v1: f64, v2: f64| {
            let (slope, half) = parabola(v0, v1, v2);
            let x = -0.5 * slope / half;
            Peak { value: v1 + 0.5 * slope * x, time: t1 + x, theta: theta1 + x * (turned + bent * x) }
        };
        let triples = first.iter().zip(middle).zip(values);
        for (bounds, ((&v0, &v1), &v2)) in self.bounds.iter_mut().zip(triples) {
            if v1 >= v0 && v1 >= v2 && (v1 > v0 || v1 > v2) {
                let top = at(v0, v1, v2);
                if top.value > bounds.most.value {
                    bounds.most = top;
                }
            } else if v1 <= v0 && v1 <= v2 && (v1 < v0 || v1 < v2) {
                let bottom = at(v0, v1, v2);
                if bottom.value < bounds.least.value {
                    bounds.least = bottom;
                }
            }
        }
    }
}

/// Places of the last period that are remembered at most: a crank that creeps takes more.
const MOST_PLACES: usize = 60_000;

/// Looks at a run as it goes on.
pub(crate) struct Looker {
    whole: Fold,
    room: Vec<f64>,
    /// Time, angle and whether it stands apart, of the places of the last period, and of one before it.
    places: VecDeque<([f64; 2], bool)>,
    /// Their values.
    values: VecDeque<f64>,
    /// Crank angle of a period [rad].
    period: f64,
}

/// Places whose crank angles are a period apart to this bound mark its ends [rad].
const SAME_ANGLE: f64 = 1e-6;

impl Looker {
    pub fn new(period: f64) -> Looker {
        Looker {
            whole: Fold::default(),
            room: Vec::new(),
            places: VecDeque::new(),
            values: VecDeque::new(),
            period,
        }
    }

    /// One place more; `apart`: something jumps there.
    pub fn look(&mut self, seen: &Seen<'_>, apart: bool) {
        let mut room = std::mem::take(&mut self.room);
        seen.values(&mut room);
        let at = [seen.time, seen.theta];
        self.whole.push(at, apart, &room);
        let turns_back = self.places.back().is_some_and(|(before, _)| before[1] > at[1]);
        if turns_back || self.places.len() >= MOST_PLACES {
            self.places.clear();
            self.values.clear();
        }
        self.places.push_back((at, apart));
        self.values.extend(&room);
        while self.places.get(1).is_some_and(|(second, _)| second[1] < at[1] - self.period - SAME_ANGLE) {
            self.places.pop_front();
            self.values.drain(..room.len());
        }
        self.room = room;
    }

    /// Extremes over the run, which has `samples`, and over its last period where the crank turns forward through a whole one.
    pub fn close(mut self, samples: &Samples) -> (RunExtremes, Option<RunExtremes>) {
        let shape = samples.time.len().checked_sub(1).and_then(|last| samples.seen(last));
        let (Some(shape), Some((end, _))) = (shape, self.places.back()) else {
            return (RunExtremes::default(), None);
        };
        let whole = shape.named(&self.whole.bounds);
        let count = self.whole.bounds.len();
        let from = end[1] - self.period;
        let values = self.values.make_contiguous();
        let inside = self.places.iter().position(|(at, _)| at[1] >= from - SAME_ANGLE);
        let starts = self.places.front().is_some_and(|(at, _)| at[1] <= from + SAME_ANGLE);
        let Some(first) = inside.filter(|_| starts && count > 0) else { return (whole, None) };
        let mut fold = Fold::default();
        let rows = values.chunks_exact(count).zip(&self.places).skip(first);
        rows.for_each(|(row, (at, apart))| fold.push(*at, *apart, row));
        (whole, Some(shape.named(&fold.bounds)))
    }
}

impl Samples {
    /// What stands at a sample.
    fn seen(&self, index: usize) -> Option<Seen<'_>> {
        let pose = self.position.get(index).zip(self.orientation.get(index));
        Some(Seen {
            time: *self.time.get(index)?,
            theta: *self.theta.get(index)?,
            speed: *self.speed.get(index)?,
            pose: pose.map(|(position, orientation)| (*position, *orientation)),
            mounts: self.mounts.get(index).map_or(&[], |mounts| mounts),
            springs: self.driveline_springs.get(index).map_or(&[], |springs| springs),
            reactions: self.reactions.get(index),
        })
    }

    /// Extremes over some of the samples, and between them on parabolas; zeros without any.
    pub fn extremes(&self, range: std::ops::Range<usize>) -> RunExtremes {
        let (mut fold, mut room) = (Fold::default(), Vec::new());
        let mut last = None;
        for seen in range.filter_map(|index| self.seen(index)) {
            seen.values(&mut room);
            fold.push([seen.time, seen.theta], false, &room);
            last = Some(seen);
        }
        last.map_or_else(RunExtremes::default, |seen| seen.named(&fold.bounds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_has_its_top_between_uneven_places_and_none_across_a_jump() {
        let place = |t: f64| 3.0 - 2.0 * (t - 0.4) * (t - 0.4);
        let mut fold = Fold::default();
        for t in [0.0, 0.3, 0.7, 1.0] {
            fold.push([t, 10.0 * t], false, &[place(t), -place(t)]);
        }
        for (top, sign) in [(fold.bounds[0].most, 1.0), (fold.bounds[1].least, -1.0)] {
            // Exact but for rounding.
            assert!((top.value - 3.0 * sign).abs() < 1e-14, "{top:?}");
            assert!((top.time - 0.4).abs() < 1e-14 && (top.theta - 4.0).abs() < 1e-13, "{top:?}");
        }
        let mut apart = Fold::default();
        for (k, t) in [0.0, 0.3, 0.7, 1.0].into_iter().enumerate() {
            apart.push([t, 10.0 * t], k == 2, &[place(t)]);
        }
        assert_eq!(apart.bounds[0].most, Peak { value: place(0.3), time: 0.3, theta: 3.0 });
    }

    #[test]
    fn a_turn_is_the_shorter_way_round() {
        let half = 0.5 * 0.3f64;
        for sign in [1.0, -1.0] {
            let q = [sign * half.cos(), 0.0, sign * half.sin() * 0.6, sign * half.sin() * 0.8];
            let turn = rotation_vector(q);
            // 0.3 rad about (0, 0.6, 0.8).
            assert!(
                turn[0] == 0.0 && (turn[1] - 0.18).abs() < 1e-15 && (turn[2] - 0.24).abs() < 1e-15,
                "{turn:?}"
            );
        }
        assert_eq!(rotation_vector([1.0, 0.0, 0.0, 0.0]), [0.0; 3]);
    }
}
