//! From finitely many angles to the continuous cycle: solve, look for the true peaks, add them, polish, prove.

use super::certificate::certify;
use super::cone::{self, Touch};
use super::curve::{Member, length};
use super::polish::polish;
use super::programme::{Programme, Solution};
use std::f64::consts::TAU;

/// Angles in a revolution that a curve is judged at to begin with.
const FIRST_ANGLES: usize = 12;

/// Most rounds of exchange.
const MOST_ROUNDS: usize = 25;

/// Rounds in which the gap must halve.
const PATIENCE: usize = 10;

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
    let mut infeasible = false;
    let (mut narrowest, mut waited) = (f64::INFINITY, 0);
    for _ in 0..MOST_ROUNDS {
        *solves += 1;
        let Some(point) = cone::solve(programme, &touches) else { break };
        infeasible = point.infeasible;
        if infeasible {
            break;
        }
        let added = add_summits(programme, &point.x, &mut touches);
        consider(programme, &point.x, &point.support, &point.prices, &mut best);
        if done(&best) {
            break;
        }
        if let Some(better) = polish(programme, &point) {
            consider(programme, &better.x, &better.support, &better.prices, &mut best);
            if done(&best) {
                break;
            }
            add_summits(programme, &better.x, &mut touches);
        }
        let gap = best.as_ref().map_or(f64::INFINITY, |b| b.value - b.bound);
        if gap < 0.5 * narrowest {
            (narrowest, waited) = (gap, 0);
        } else if gap.is_finite() {
            waited += 1;
        }
        if !added || waited == PATIENCE {
            break;
        }
    }
    best.ok_or(if infeasible { Failure::Infeasible } else { Failure::NoPoint })
}

fn proved(solution: &Solution, relative: f64, floor: f64) -> bool {
    solution.value - solution.bound <= relative * solution.value.max(floor)
}

/// Keeps the better of the points and the better of the bounds.
fn consider(
    programme: &Programme,
    x: &[f64],
    support: &[super::programme::Support],
    prices: &[f64],
    best: &mut Option<Solution>,
) {
    let levels = programme.levels(x);
    let value = programme.value(x, &levels);
    let feasible = programme.violation(x, &levels) <= HOLDS && value.is_finite();
    let reach = programme.radius(best.as_ref().map_or(value, |b| b.value.max(value)));
    let radius = if reach.is_finite() { reach } else { FARTHEST };
    let certificate = certify(programme, &levels, support, prices, radius);
    // Amounts are never negative.
    let floor = if programme.linear.iter().all(|p| *p == 0.0) { programme.offset } else { f64::NEG_INFINITY };
    match best {
        None if feasible => {
            let (bound, support, prices) = certificate
                .map_or((floor, Vec::new(), vec![0.0; programme.rows.len()]), |c| {
                    (c.bound, c.support, c.prices)
                });
            *best = Some(Solution { x: x.to_vec(), levels, value, bound: bound.max(floor), support, prices });
        }
        None => {}
        Some(best) => {
            if feasible && value < best.value {
                (best.x, best.levels, best.value) = (x.to_vec(), levels, value);
            }
            if let Some(certificate) = certificate.filter(|c| c.bound > best.bound) {
                best.bound = certificate.bound;
                best.support = certificate.support;
                best.prices = certificate.prices;
            }
        }
    }
}

/// Equally spaced angles and the peaks where all variables are 0.
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
    add_summits(programme, &vec![0.0; programme.variables], &mut touches);
    touches
}

/// Adds the true peaks at `x` that are not yet judged; whether there were any that matter.
fn add_summits(programme: &Programme, x: &[f64], touches: &mut Vec<Touch>) -> bool {
    let before = touches.len();
    for group in (0..programme.groups.len()).filter(|&g| programme.judged(g)) {
        let members = &programme.groups[group].members;
        let known = |touch: &Touch| length(&members[touch.member].value(touch.angle, x));
        let level = touches.iter().filter(|t| t.group == group).map(known).fold(0.0, f64::max);
        for (member, one) in members.iter().enumerate() {
            if matches!(one, Member::Vector { .. }) {
                continue;
            }
            for summit in one.summits(&programme.grid, x, level).into_iter().take(24) {
                let angle = summit.angle;
                let new = touches
                    .iter()
                    .all(|t| t.group != group || t.member != member || apart(t.angle, angle) > 1e-9);
                if new && summit.amount > level * (1.0 + 1e-13) {
                    touches.push(Touch { group, member, angle });
                }
            }
        }
    }
    touches.len() > before
}

/// Distance of two angles on the circle.
pub(crate) fn apart(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(TAU);
    d.min(TAU - d)
}
