//! The set of holes that comes nearest to a wanted unbalance.
//!
//! A hole at an allowed angle with an allowed drill is a vector of fixed direction and bounded length. Where any depth may be
//! drilled, the best lengths of a set of holes are a box-constrained least-squares problem in the plane, solved exactly: its
//! solution for two holes is the crossing or lies on an edge of the box, and more than two holes always have a solution with
//! one of them at its bound. Where depths go by steps, all steps of all holes but the last are tried, and the last takes the
//! nearest steps to what remains. Where the wall between the best of any depth would be too thin, shallower ones are tried
//! so, by even steps.

use crate::removal::hole::{Bit, Hole, wall};
use crate::rotor::allowed::is_allowed;
use lanchester_task::workshop::{Allowed, Drill, DrillDirection};
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Sets of depths looked at before the search gives up: about a second where every set has three holes.
const MOST_TRIALS: usize = 2_000_000;

/// Depths tried of each hole where the wall between the best ones would be too thin.
const SHALLOWER: usize = 25;

/// What a search found.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Search {
    /// The holes, by angle.
    pub(crate) holes: Vec<Hole>,
    /// Wanted less removed [kg m].
    pub(crate) left: Complex64,
    /// Whether every set was looked at.
    pub(crate) complete: bool,
}

/// A place and a drill for one hole.
#[derive(Debug, Clone)]
struct Candidate {
    angle: f64,
    direction: Complex64,
    bit: Bit,
    /// Least and largest unbalance [kg m].
    bounds: [f64; 2],
    /// Unbalance of every allowed depth with the depth, rising; empty where any depth may be drilled.
    steps: Vec<(f64, f64)>,
}

struct State<'a> {
    drill: &'a Drill,
    radius: f64,
    target: Complex64,
    tolerance: f64,
    trials: usize,
    best: Vec<Hole>,
    best_left: f64,
}

/// The holes that come nearest to removing `target`; `tolerance` is what may be left without another hole.
pub(crate) fn search(
    target: Complex64,
    allowed: &Allowed,
    drill: &Drill,
    radius: f64,
    tolerance: f64,
) -> Search {
    let candidates = candidates(target, allowed, drill, radius);
    let mut state =
        State { drill, radius, target, tolerance, trials: 0, best: Vec::new(), best_left: target.norm() };
    for count in 1..=drill.most_holes {
        if state.best_left <= tolerance {
            break;
        }
        state.choose(&candidates, count, &mut Vec::new());
    }
    let mut holes = state.best;
    holes.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    let removed: Complex64 = holes.iter().map(|hole| Complex64::from_polar(hole.unbalance, hole.angle)).sum();
    Search { holes, left: target - removed, complete: state.trials <= MOST_TRIALS }
}

/// Allowed places within a quarter turn of the target (a hole farther off adds to what the others must remove), the
/// nearest first.
fn candidates(target: Complex64, allowed: &Allowed, drill: &Drill, radius: f64) -> Vec<Candidate> {
    let towards = target.arg();
    let step = drill.angle_step.max(1e-3);
    let turns = (FRAC_PI_2 / step).floor() as i32;
    let mut angles: Vec<f64> = (-turns..=turns)
        .map(|k| towards + f64::from(k) * step)
        .filter(|angle| match allowed {
            Allowed::Any => true,
            Allowed::Some { sectors, .. } => {
                !sectors.is_empty()
                    && is_allowed(&Allowed::Some { angles: Vec::new(), sectors: sectors.clone() }, *angle)
            }
        })
        .collect();
    if let Allowed::Some { angles: singles, sectors } = allowed {
        angles.extend(singles.iter().chain(sectors.iter().flatten()));
    }
    let off = |angle: f64| {
        let turn = (angle - towards).rem_euclid(TAU);
        turn.min(TAU - turn)
    };
    angles.retain(|angle| off(*angle) < FRAC_PI_2 - 1e-9);
    angles.sort_by(|a, b| off(*a).total_cmp(&off(*b)));
    let mut kept: Vec<f64> = Vec::new();
    for angle in angles.into_iter().map(|angle| angle.rem_euclid(TAU)) {
        if kept.iter().all(|other| (angle - other).abs() > 1e-9) {
            kept.push(angle);
        }
    }
    let bits: Vec<Bit> =
        drill.diameters.iter().filter_map(|diameter| Bit::of(drill, radius, *diameter)).collect();
    let mut candidates = Vec::with_capacity(kept.len() * bits.len());
    for angle in kept {
        for bit in &bits {
            let steps: Vec<(f64, f64)> = drill
                .depth_step
                .map_or(Vec::new(), |step| bit.depths(step))
                .into_iter()
                .map(|depth| (bit.unbalance(depth), depth))
                .collect();
            let bounds = match (drill.depth_step, steps.first(), steps.last()) {
                (Some(_), Some(first), Some(last)) => [first.0, last.0],
                (Some(_), ..) => continue,
                (None, ..) => bit.bounds(),
            };
            let direction = Complex64::from_polar(1.0, angle);
            candidates.push(Candidate { angle, direction, bit: *bit, bounds, steps });
        }
    }
    candidates
}

impl State<'_> {
    /// Goes through all sets of `count` more holes from `rest` on top of the `chosen` ones.
    fn choose<'c>(&mut self, rest: &'c [Candidate], count: usize, chosen: &mut Vec<&'c Candidate>) {
        if count == 0 {
            self.lengths(chosen);
            return;
        }
        for (index, candidate) in rest.iter().enumerate() {
            if self.trials > MOST_TRIALS || self.best_left <= self.rounding() {
                return;
            }
            // Two holes in one place are one.
            if chosen.iter().any(|other| other.angle == candidate.angle) {
                continue;
            }
            chosen.push(candidate);
            self.choose(&rest[index + 1..], count - 1, chosen);
            chosen.pop();
        }
    }

    /// Below this nothing can be improved [kg m].
    fn rounding(&self) -> f64 {
        1e-12 * self.target.norm()
    }

    /// The best lengths of a set of holes.
    fn lengths(&mut self, chosen: &[&Candidate]) {
        let (lengths, least) = box_least_squares(self.target, chosen, &mut self.trials);
        if least >= self.best_left - self.rounding() {
            return;
        }
        if self.drill.depth_step.is_none() {
            let holes: Vec<Hole> = chosen
                .iter()
                .zip(&lengths)
                .map(|(candidate, length)| candidate.bit.hole(candidate.angle, candidate.bit.depth(*length)))
                .collect();
            if self.thick(&holes) {
                self.offer(holes);
            } else if self.drill.direction == DrillDirection::Radial {
                self.shallower(chosen);
            }
        } else {
            self.steps(self.target, chosen, &mut Vec::new());
        }
    }

    /// Radial holes run together at depth: the best of shallower ones whose walls are thick enough.
    fn shallower(&mut self, chosen: &[&Candidate]) {
        let stepped: Vec<Candidate> = chosen
            .iter()
            .map(|candidate| {
                let depths = candidate.bit.even_depths(SHALLOWER).into_iter();
                let steps = depths.map(|depth| (candidate.bit.unbalance(depth), depth)).collect();
                Candidate { steps, ..(*candidate).clone() }
            })
            .collect();
        self.steps(self.target, &stepped.iter().collect::<Vec<_>>(), &mut Vec::new());
    }

    /// All steps of all holes but the last, for which the steps nearest to what remains are taken.
    fn steps(&mut self, remaining: Complex64, chosen: &[&Candidate], holes: &mut Vec<Hole>) {
        let Some((candidate, others)) = chosen.split_first() else { return };
        if others.is_empty() {
            self.trials += 1;
            let wanted = (remaining * candidate.direction.conj()).re;
            let above = candidate.steps.partition_point(|(unbalance, _)| *unbalance < wanted);
            for (unbalance, depth) in candidate.steps[above.saturating_sub(1)..].iter().take(2) {
                if (remaining - candidate.direction * unbalance).norm() < self.best_left - self.rounding() {
                    holes.push(candidate.bit.hole(candidate.angle, *depth));
                    self.offer(holes.clone());
                    holes.pop();
                }
            }
            return;
        }
        for (unbalance, depth) in &candidate.steps {
            if self.trials > MOST_TRIALS {
                return;
            }
            let remaining = remaining - candidate.direction * unbalance;
            // Even the best lengths of the others may not be enough.
            let (_, least) = box_least_squares(remaining, others, &mut self.trials);
            if least < self.best_left - self.rounding() {
                holes.push(candidate.bit.hole(candidate.angle, *depth));
                self.steps(remaining, others, holes);
                holes.pop();
            }
        }
    }

    /// Whether wall and distance between two holes are large enough.
    fn apart(&self, one: &Hole, other: &Hole) -> bool {
        let distance = 2.0 * self.radius * (0.5 * (one.angle - other.angle)).sin().abs();
        distance >= self.drill.spacing - 1e-12
            && wall(self.drill.direction, self.radius, one, other) >= self.drill.land - 1e-12
    }

    /// Whether all walls and distances are large enough.
    fn thick(&self, holes: &[Hole]) -> bool {
        holes.iter().enumerate().all(|(k, one)| holes[..k].iter().all(|other| self.apart(one, other)))
    }

    /// Takes a set of holes if it leaves less than the best so far and its walls are thick enough. More holes than before
    /// must be worth it: a set within the tolerance ends the search before another hole is tried.
    fn offer(&mut self, holes: Vec<Hole>) {
        let removed: Complex64 =
            holes.iter().map(|hole| Complex64::from_polar(hole.unbalance, hole.angle)).sum();
        let left = (self.target - removed).norm();
        if left >= self.best_left - self.rounding() {
            return;
        }
        let more = holes.len() > self.best.len();
        if self.thick(&holes) && !(more && self.best_left <= self.tolerance) {
            (self.best, self.best_left) = (holes, left);
        }
    }
}

/// Lengths within the bounds of the candidates that come nearest to the target, and the distance left.
fn box_least_squares(target: Complex64, chosen: &[&Candidate], trials: &mut usize) -> (Vec<f64>, f64) {
    *trials += 1;
    match chosen {
        [] => (Vec::new(), target.norm()),
        [one] => {
            let length = (target * one.direction.conj()).re.clamp(one.bounds[0], one.bounds[1]);
            (vec![length], (target - one.direction * length).norm())
        }
        [one, other] => {
            let cross = |a: Complex64, b: Complex64| a.re * b.im - a.im * b.re;
            let sine = cross(one.direction, other.direction);
            let crossing = [cross(target, other.direction) / sine, cross(one.direction, target) / sine];
            let inside = |length: f64, bounds: [f64; 2]| length >= bounds[0] && length <= bounds[1];
            if inside(crossing[0], one.bounds) && inside(crossing[1], other.bounds) {
                return (crossing.to_vec(), 0.0);
            }
            at_bounds(target, chosen, trials)
        }
        _ => at_bounds(target, chosen, trials),
    }
}

/// The best with one of the holes at its bound.
fn at_bounds(target: Complex64, chosen: &[&Candidate], trials: &mut usize) -> (Vec<f64>, f64) {
    let mut best = (Vec::new(), f64::INFINITY);
    for fixed in 0..chosen.len() {
        let mut others = chosen.to_vec();
        let candidate = others.remove(fixed);
        for bound in candidate.bounds {
            let (mut lengths, left) =
                box_least_squares(target - candidate.direction * bound, &others, trials);
            if left < best.1 {
                lengths.insert(fixed, bound);
                best = (lengths, left);
            }
        }
    }
    best
}
