//! From finitely many angles to the continuous cycle: solve, look for the true peaks, add them, polish, prove.

use super::certificate::certify;
use super::cone::{self, Frame, Touch};
use super::curve::{FixedMember, Member, Summit, apart};
use super::dense::{add_scaled, dot};
use super::polish::polish;
use super::programme::{Programme, Solution};
use std::f64::consts::TAU;

/// Angles in a revolution that a curve is judged at to begin with.
const FIRST_ANGLES: usize = 12;

/// Most rounds of exchange.
const MOST_ROUNDS: usize = 25;

/// Rounds in which the gap must halve.
const PATIENCE: usize = 10;

/// Halvings of the way from a point that holds to one that passes a row.
const HALVINGS: usize = 30;

/// An optimum below this share of the unit is solved in a smaller one, and the smallest unit.
const SMALL: f64 = 0.1;
const SMALLEST: f64 = 1e-8;

/// A row that is passed by no more than this share of it holds.
pub(crate) const HOLDS: f64 = 1e-10;

/// Nothing is looked for further out than this many natural amounts where no criterion bounds the variables.
const FARTHEST: f64 = 1e3;

/// Rounds in which a point is moved over the rows that it passes, and how far beyond them, as a share of the row.
const PUSHES: usize = 8;
const BEYOND: f64 = 1e-6;

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
    if programme.variables == 0 && (0..programme.groups.len()).all(|group| !programme.judged(group)) {
        return of_nothing(programme);
    }
    let done = |found: &Found| found.best.as_ref().is_some_and(|b| proved(b, relative, floor));
    let mut touches = first_touches(programme);
    let mut found = Found::default();
    // Where all variables are 0 is a point like any other: of a later stage, what the earlier ones reached.
    let nothing = vec![0.0; programme.variables];
    let levels = add_summits(programme, &nothing, &mut touches);
    consider(programme, &nothing, &levels, &[], &vec![0.0; programme.rows.len()], &mut found);
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
        consider(programme, &point.x, &levels, &point.support, &point.prices, &mut found);
        if done(&found) {
            break;
        }
        if let Some(better) = polish(programme, &point, levels) {
            let levels = add_summits(programme, &better.x, &mut touches);
            consider(programme, &better.x, &levels, &better.support, &better.prices, &mut found);
            if done(&found) {
                break;
            }
        }
        let small = found.best.as_ref().filter(|b| b.value < SMALL * frame.unit && frame.unit > SMALLEST);
        let finer = small.is_some();
        if let Some(best) = small {
            frame = Frame { origin: best.x.clone(), unit: best.value.max(floor).max(SMALLEST) };
        }
        let gap = found.closest(programme.holds).map_or(f64::INFINITY, |b| b.value - b.bound);
        if gap < 0.5 * narrowest {
            (narrowest, waited) = (gap, 0);
        } else if gap.is_finite() {
            waited += 1;
        }
        if !(added || finer) || waited == PATIENCE {
            break;
        }
    }
    let whole = done(&found);
    found.taken(programme, whole).ok_or(if infeasible { Failure::Infeasible } else { Failure::NoPoint })
}

/// The one point of a programme in which nothing is judged and nothing moves, which is its own proof.
fn of_nothing(programme: &Programme) -> Result<Solution, Failure> {
    let levels = programme.levels(&[]);
    if programme.violation(&[], &levels) > programme.holds {
        return Err(Failure::Infeasible);
    }
    let value = programme.value(&[], &levels);
    let (support, prices) = (Vec::new(), vec![0.0; programme.rows.len()]);
    Ok(Solution { x: Vec::new(), levels, value, bound: value, support, prices })
}

/// Whether the gap is no more than `relative` times the larger of the optimum and `floor`.
pub(crate) fn proved(solution: &Solution, relative: f64, floor: f64) -> bool {
    solution.value - solution.bound <= relative * solution.value.max(floor)
}

/// The best so far.
#[derive(Default)]
struct Found {
    /// The best point that holds the rows.
    best: Option<Solution>,
    /// Of the points that pass a row the one that does so least, and by how much.
    nearly: Option<(f64, Solution)>,
}

impl Found {
    /// The best point that passes no row by more than `holds`.
    fn closest(&self, holds: f64) -> Option<&Solution> {
        self.best.as_ref().or(self.nearly.as_ref().filter(|one| one.0 <= holds).map(|one| &one.1))
    }

    /// The solution; unless it is `proved`, a point that passed a row may be a better one once it is drawn in.
    fn taken(self, programme: &Programme, proved: bool) -> Option<Solution> {
        match (self.best, self.nearly) {
            (None, Some((violation, nearly))) if violation <= programme.holds => Some(nearly),
            (None, Some((_, nearly))) => drawn_in(programme, nearly),
            (Some(best), Some((_, nearly))) if !proved && nearly.value < best.value => {
                Some(match drawn_in(programme, nearly) {
                    Some(inside) => better(best, inside),
                    None => best,
                })
            }
            (best, _) => best,
        }
    }

    /// Takes in a point that passes the rows by `violation`.
    fn add(&mut self, violation: f64, mut found: Solution) {
        let known = [self.best.as_ref(), self.nearly.as_ref().map(|one| &one.1)];
        if let Some(bound) = known.into_iter().flatten().max_by(|a, b| a.bound.total_cmp(&b.bound)) {
            raise(&mut found, bound);
        }
        for one in [self.best.as_mut(), self.nearly.as_mut().map(|one| &mut one.1)].into_iter().flatten() {
            raise(one, &found);
        }
        if violation <= HOLDS {
            self.best = Some(match self.best.take() {
                Some(before) => better(before, found),
                None => found,
            });
        } else if self.nearly.as_ref().is_none_or(|(least, _)| violation < *least) {
            self.nearly = Some((violation, found));
        }
    }
}

/// Draws a point that passes a row towards one that holds all of them until it holds, as what is allowed is convex: towards
/// 0, where what earlier stages left is kept, or, where 0 does not hold, the nearest point beyond the rows of variables alone.
fn drawn_in(programme: &Programme, nearly: Solution) -> Option<Solution> {
    let holds = |x: &[f64]| programme.violation(x, &programme.levels(x)) <= HOLDS;
    let origin = beyond_plain_rows(programme);
    if !holds(&origin) {
        return None;
    }
    let at = |share: f64| -> Vec<f64> {
        nearly.x.iter().zip(&origin).map(|(x, from)| from + share * (x - from)).collect()
    };
    let (mut inside, mut outside) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        *(if holds(&at(middle)) { &mut inside } else { &mut outside }) = middle;
    }
    let x = at(inside);
    let levels = programme.levels(&x);
    let value = programme.value(&x, &levels);
    Some(Solution { x, levels, value, ..nearly })
}

/// 0, moved straight over every row of variables alone that it passes, such as that of a least amount, and a little beyond.
fn beyond_plain_rows(programme: &Programme) -> Vec<f64> {
    let mut x = vec![0.0; programme.variables];
    for _ in 0..PUSHES {
        for row in programme.rows.iter().filter(|row| row.shares.is_empty()) {
            let (excess, square) =
                (dot(&row.directions, &x) - row.most, dot(&row.directions, &row.directions));
            if excess > 0.0 && square > 0.0 {
                add_scaled(&mut x, -(excess + BEYOND * row.most.abs()) / square, &row.directions);
            }
        }
    }
    x
}

/// Adds a point with the bound that its multipliers prove; `levels` are those at `x`.
fn consider(
    programme: &Programme,
    x: &[f64],
    levels: &[f64],
    support: &[super::programme::Support],
    prices: &[f64],
    found: &mut Found,
) {
    let value = programme.value(x, levels);
    if !value.is_finite() {
        return;
    }
    let violation = programme.violation(x, levels);
    let reach = programme.radius(found.best.as_ref().map_or(value, |b| b.value.max(value)));
    let radius = if reach.is_finite() { reach } else { FARTHEST };
    let certificate = certify(programme, levels, support, prices, radius);
    // Amounts are never negative.
    let floor = if programme.linear.iter().all(|p| *p == 0.0) { programme.offset } else { f64::NEG_INFINITY };
    let (bound, support, prices) = certificate
        .map_or((floor, Vec::new(), vec![0.0; programme.rows.len()]), |c| (c.bound, c.support, c.prices));
    let (x, levels) = (x.to_vec(), levels.to_vec());
    found.add(violation, Solution { x, levels, value, bound: bound.max(floor), support, prices });
}

/// The better point of two with the better bound.
pub(crate) fn better(before: Solution, found: Solution) -> Solution {
    let (mut kept, other) = if found.value < before.value { (found, before) } else { (before, found) };
    raise(&mut kept, &other);
    kept
}

/// Takes over a better bound with what proves it.
fn raise(kept: &mut Solution, other: &Solution) {
    if other.bound > kept.bound {
        kept.bound = other.bound;
        kept.support.clone_from(&other.support);
        kept.prices.clone_from(&other.prices);
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
        let known = |touch: &Touch| members[touch.member].amount(touch.angle);
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

/// The gap that is aimed at, relative to the larger of the optimum and a millionth of the unbalanced load.
pub(crate) const GAP: f64 = 1e-9;
