//! From finitely many angles to the continuous cycle: solve, look for the true peaks, add them, polish, prove.

use super::certificate::certify;
use super::cone::{self, Frame, Touch};
use super::curve::{FixedMember, Member, Summit, length};
use super::polish::polish;
use super::programme::{Programme, Solution};
use std::f64::consts::TAU;

/// Angles in a revolution that a curve is judged at to begin with.
const FIRST_ANGLES: usize = 12;

/// Most rounds of exchange.
const MOST_ROUNDS: usize = 25;

/// Rounds in which the gap must halve.
const PATIENCE: usize = 10;

/// An optimum below this share of the unit is solved in a smaller one, and the smallest unit.
const SMALL: f64 = 0.1;
const SMALLEST: f64 = 1e-8;

/// A row that is passed by no more than this share of it holds.
pub(crate) const HOLDS: f64 = 1e-10;

/// Nothing is looked for further out than this many natural amounts where no criterion bounds the variables.
const FARTHEST: f64 = 1e3;

/// Why a programme has no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The solver claims that the rows contradict one another.
    Infeasible,
    /// No feasible point was found.
    NoPoint,
}

/// Solves a programme to a gap of `relative` times the larger of the optimum and `floor`; counts cone programmes in
/// `solves`. The gap of the solution may be wider where rounding lets no more be proved.
pub(crate) fn solve(
    programme: &Programme,
    relative: f64,
    floor: f64,
    solves: &mut usize,
) -> Result<Solution, Failure> {
    let done = |best: &Option<Solution>| best.as_ref().is_some_and(|b| proved(b, relative, floor));
    let mut touches = first_touches(programme);
    let mut best: Option<Solution> = None;
    // Where all variables are 0 is a point like any other: of a later stage, what the earlier ones reached.
    let nothing = vec![0.0; programme.variables];
    let levels = add_summits(programme, &nothing, &mut touches);
    consider(programme, &nothing, &levels, &[], &vec![0.0; programme.rows.len()], &mut best);
    let mut infeasible = false;
    let mut frame = Frame { origin: nothing, unit: 1.0 };
    let (mut narrowest, mut waited) = (f64::INFINITY, 0);
    for _ in 0..MOST_ROUNDS {
        *solves += 1;
        let Some(point) = cone::solve(programme, &touches, &frame) else { break };
        infeasible = point.infeasible;
        if infeasible {
            break;
        }
        let before = touches.len();
        let levels = add_summits(programme, &point.x, &mut touches);
        let added = touches.len() > before;
        consider(programme, &point.x, &levels, &point.support, &point.prices, &mut best);
        if done(&best) {
            break;
        }
        if let Some(better) = polish(programme, &point, levels) {
            let levels = add_summits(programme, &better.x, &mut touches);
            consider(programme, &better.x, &levels, &better.support, &better.prices, &mut best);
            if done(&best) {
                break;
            }
        }
        let small = best.as_ref().filter(|b| b.value < SMALL * frame.unit && frame.unit > SMALLEST);
        let finer = small.is_some();
        if let Some(best) = small {
            frame = Frame { origin: best.x.clone(), unit: best.value.max(floor).max(SMALLEST) };
        }
        let gap = best.as_ref().map_or(f64::INFINITY, |b| b.value - b.bound);
        if gap < 0.5 * narrowest {
            (narrowest, waited) = (gap, 0);
        } else if gap.is_finite() {
            waited += 1;
        }
        if !(added || finer) || waited == PATIENCE {
            break;
        }
    }
    best.ok_or(if infeasible { Failure::Infeasible } else { Failure::NoPoint })
}

fn proved(solution: &Solution, relative: f64, floor: f64) -> bool {
    solution.value - solution.bound <= relative * solution.value.max(floor)
}

/// Keeps the better of the points and the better of the bounds; `levels` are those at `x`.
fn consider(
    programme: &Programme,
    x: &[f64],
    levels: &[f64],
    support: &[super::programme::Support],
    prices: &[f64],
    best: &mut Option<Solution>,
) {
    let value = programme.value(x, levels);
    let feasible = programme.violation(x, levels) <= HOLDS && value.is_finite();
    let reach = programme.radius(best.as_ref().map_or(value, |b| b.value.max(value)));
    let radius = if reach.is_finite() { reach } else { FARTHEST };
    let certificate = certify(programme, levels, support, prices, radius);
    // Amounts are never negative.
    let floor = if programme.linear.iter().all(|p| *p == 0.0) { programme.offset } else { f64::NEG_INFINITY };
    match best {
        None if feasible => {
            let (bound, support, prices) = certificate
                .map_or((floor, Vec::new(), vec![0.0; programme.rows.len()]), |c| {
                    (c.bound, c.support, c.prices)
                });
            *best = Some(Solution {
                x: x.to_vec(),
                levels: levels.to_vec(),
                value,
                bound: bound.max(floor),
                support,
                prices,
            });
        }
        None => {}
        Some(best) => {
            if feasible && value < best.value {
                (best.x, best.levels, best.value) = (x.to_vec(), levels.to_vec(), value);
            }
            if let Some(certificate) = certificate.filter(|c| c.bound > best.bound) {
                best.bound = certificate.bound;
                best.support = certificate.support;
                best.prices = certificate.prices;
            }
        }
    }
}

/// Equally spaced angles.
fn first_touches(programme: &Programme) -> Vec<Touch> {
    let mut touches = Vec::new();
    for group in (0..programme.groups.len()).filter(|&g| programme.judged(g)) {
        for (member, one) in programme.groups[group].members.iter().enumerate() {
            let count = match one {
                Member::Curve(_) => FIRST_ANGLES * programme.grid.revolutions as usize,
                Member::Vector { .. } => 1,
            };
            // A vector along one line has equal amounts half a turn apart in many engines: an odd start avoids doubles.
            touches.extend((0..count).map(|j| Touch { group, member, angle: TAU * j as f64 / count as f64 }));
        }
    }
    touches
}

/// Adds the true peaks at `x` that are not yet judged and matter; the true level of every judged group (0 for the others).
fn add_summits(programme: &Programme, x: &[f64], touches: &mut Vec<Touch>) -> Vec<f64> {
    let mut levels = vec![0.0f64; programme.groups.len()];
    for group in (0..programme.groups.len()).filter(|&g| programme.judged(g)) {
        let members = programme.groups[group].at(x);
        let known = |touch: &Touch| length(&members[touch.member].value(touch.angle));
        let level = touches.iter().filter(|t| t.group == group).map(known).fold(0.0, f64::max);
        for (member, one) in members.iter().enumerate() {
            let summits = one.summits(&programme.grid, level);
            levels[group] = levels[group].max(summits[0].amount);
            if matches!(one, FixedMember::Vector(_)) {
                continue;
            }
            for Summit { angle, amount } in summits.into_iter().take(24) {
                let new = touches
                    .iter()
                    .all(|t| t.group != group || t.member != member || apart(t.angle, angle) > 1e-9);
                if new && amount > level * (1.0 + 1e-13) {
                    touches.push(Touch { group, member, angle });
                }
            }
        }
    }
    levels
}

/// Distance of two angles on the circle.
pub(crate) fn apart(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(TAU);
    d.min(TAU - d)
}
