//! The optimum of weights that can be built: the largest unbalance that each web holds is the bound of its weight.

use crate::counterweight_error::CounterweightError;
use crate::counterweight_fit::WebSeat;
use crate::counterweights::{Surroundings, web_of, within};
use lanchester_balance::{
    Answer, BalanceError, BalanceSettings, Next, Outcome, SearchState, optimise_watched,
};
use lanchester_geometry::clearance::Obstacle;
use lanchester_geometry::{Design, DesignTask, LargestUnbalance, ShapeTask, largest_unbalance};
use lanchester_model::{BalanceTask, Counterweight, Engine, FreeWeight, Phase, Place, Seat};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// The largest unbalance that a web holds, as the bound of the free weight on it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WebBound {
    /// Name of the free weight.
    pub name: String,
    /// The bound [kg m].
    pub most: f64,
    /// Direction in which it holds, at `theta = 0` in the engine's frame [rad]: where the weight points.
    pub direction: f64,
    /// What the shape of that unbalance stands against.
    pub limits: Vec<FitLimit>,
    /// No shape of the ranges has more of its own than this [kg m]; none where the proof was broken off.
    pub proved: Option<f64>,
    /// Whether it is the default, rather than asked for.
    pub is_default: bool,
}

/// What keeps a shape from more unbalance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitLimit {
    /// The clearance, and what is nearest to the crank axis in its envelope.
    Clearance(Obstacle),
    /// The largest thickness of the ranges.
    Thickness,
    /// The thickness that rods beside the web leave.
    RodsBeside,
    /// The largest swept radius.
    SweptRadius,
    /// The largest mass.
    Mass,
    /// The largest polar inertia.
    Inertia,
    /// The largest half width.
    HalfWidth,
    /// The largest arc radius of the ranges.
    ArcRadius,
    /// The largest arc angle of the ranges.
    ArcAngle,
    /// The largest height of the rectangle or of the trapezoid.
    Height,
}

/// An optimum, and what bounds its weights on webs.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundedAnswer {
    /// The optimum.
    pub answer: Answer,
    /// Bounds by what fits, in the order of the task's weights; empty where none is asked for.
    pub bounds: Vec<WebBound>,
}

/// Why there is no such optimum.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WhatFitsError {
    /// The task has no meaning, or the search was broken off.
    #[error(transparent)]
    Balance(#[from] BalanceError),
    /// What fits cannot be found.
    #[error(transparent)]
    Counterweight(#[from] CounterweightError),
}

/// A bound is this part below what fits, so that more than one shape has it.
const BELOW: f64 = 1e-6;
/// Rounds after which directions and bounds agree, or bounds only fall.
const FREE_ROUNDS: usize = 3;
/// Most rounds.
const MOST_ROUNDS: usize = 12;
/// Directions closer than this are one [rad].
const SAME_DIRECTION: f64 = 1e-6;

/// A weight whose largest amount is what fits.
struct Fitted {
    /// Index in the task.
    weight: usize,
    /// Index of the weight whose bound it sets: its own, or that of its leader.
    leader: usize,
    /// Its amount over that of its leader.
    factor: f64,
    bound: WebBound,
}

/// The optimum of a task with the bounds of all weights whose largest amount is what fits: those that ask for it, and, where the file has
/// `[crank.body]` and `[counterweight_design]`, all on webs without a largest amount.
///
/// What fits depends on the direction of a weight. It is first that opposite the crankpin; then, in turn, that in the direction in which the optimum
/// has the weight, until every weight found fits where it points. `settings` and `watch` as in [`optimise_watched`].
///
/// # Errors
/// [`WhatFitsError`] as [`optimise_watched`], and where data for what fits are missing.
pub fn optimise_what_fits(
    engine: &Engine,
    task: &BalanceTask,
    settings: &BalanceSettings,
    watch: &dyn Fn(&SearchState<'_>) -> Next,
) -> Result<BoundedAnswer, WhatFitsError> {
    let mut task = task.clone();
    let mut fitted = fitted_weights(engine, &task)?;
    if fitted.is_empty() {
        let answer = optimise_watched(engine, &task, settings, watch)?;
        return Ok(BoundedAnswer { answer, bounds: Vec::new() });
    }
    let mut round = 0;
    loop {
        set_bounds(&mut task, &fitted)?;
        let answer = optimise_watched(engine, &task, settings, watch)?;
        if answer.weights.is_empty() || matches!(answer.outcome, Outcome::Infeasible { .. }) {
            return Ok(BoundedAnswer { answer, bounds: bounds(fitted) });
        }
        let mut has_moved = false;
        for one in &mut fitted {
            let found = &answer.weights[one.weight];
            let amount = found.unbalance.norm();
            let direction = found.unbalance.arg();
            let off = (direction - one.bound.direction + PI).rem_euclid(TAU) - PI;
            // A weight of next to nothing has no direction, and fits everywhere.
            if !found.used || amount < 1e-3 * one.bound.most || off.abs() < SAME_DIRECTION {
                continue;
            }
            let free = &task.weights[one.weight];
            let there = bound_of(engine, free, direction, one.bound.is_default)?;
            let passes = amount > there.most * (1.0 + 1e-9);
            let may_grow = round < FREE_ROUNDS
                && amount > one.bound.most * (1.0 - 1e-3)
                && there.most > one.bound.most * (1.0 + 1e-6);
            has_moved |= passes || may_grow;
            one.bound = match passes || may_grow || round < FREE_ROUNDS {
                true => there,
                // From here on bounds only fall, so that an end comes.
                false => WebBound { most: one.bound.most.min(there.most), ..there },
            };
        }
        round += 1;
        if !has_moved || round == MOST_ROUNDS {
            return Ok(BoundedAnswer { answer, bounds: bounds(fitted) });
        }
    }
}

fn bounds(fitted: Vec<Fitted>) -> Vec<WebBound> {
    fitted.into_iter().map(|one| one.bound).collect()
}

/// The weights whose largest amount is what fits, with what fits opposite their crankpin or in the direction that they have.
fn fitted_weights(engine: &Engine, task: &BalanceTask) -> Result<Vec<Fitted>, CounterweightError> {
    // Not yet the default where a crank body and shapes are given: within an envelope the search takes too long.
    let by_default = false;
    let mut fitted = Vec::new();
    for (index, weight) in task.weights.iter().enumerate() {
        let tie = task.ties.iter().find(|tie| tie.second == index);
        let leader = tie.map_or(index, |tie| tie.first);
        let leading = &task.weights[leader];
        let on_web = web_direction(engine, weight);
        let is_default = !leading.fits;
        if leading.fits {
            let missing = if on_web.is_none() {
                Some("a place on a web between whose neighbours there is room for a shape: `web = 1`")
            } else if engine.shape_task.is_none() {
                Some("the shapes that are allowed: a section [counterweight_design]")
            } else {
                None
            };
            if let Some(missing) = missing {
                return Err(CounterweightError::NoSpace { name: weight.name.clone(), missing });
            }
        } else if !by_default || leading.most.is_some() {
            continue;
        }
        let Some(opposite) = on_web else { continue };
        let direction = match weight.phase {
            Phase::Direction(direction) => direction,
            Phase::Free | Phase::Line(_) => opposite,
        };
        let bound = match fitted.iter().find_map(|known: &Fitted| {
            is_alike(engine, &task.weights[known.weight], weight, known.bound.direction, direction)
                .then(|| known.bound.clone())
        }) {
            Some(bound) => WebBound { name: weight.name.clone(), direction, is_default, ..bound },
            None => bound_of(engine, weight, direction, is_default)?,
        };
        fitted.push(Fitted { weight: index, leader, factor: tie.map_or(1.0, |tie| tie.factor.abs()), bound });
    }
    Ok(fitted)
}

/// Whether two weights stand alike without anything around them: then one tells for both.
fn is_alike(engine: &Engine, one: &FreeWeight, other: &FreeWeight, first: f64, second: f64) -> bool {
    let tilt = |weight: &FreeWeight, direction: f64| {
        let opposite = web_direction(engine, weight)?;
        Some(((direction - opposite + PI).rem_euclid(TAU) - PI).abs())
    };
    engine.envelope.is_none()
        && match (tilt(one, first), tilt(other, second)) {
            (Some(one), Some(other)) => (one - other).abs() < 1e-9,
            _ => false,
        }
}

/// The largest amounts of the leaders: what fits on the web of the leader and on those of all that follow it.
fn set_bounds(task: &mut BalanceTask, fitted: &[Fitted]) -> Result<(), CounterweightError> {
    for one in fitted {
        task.weights[one.leader].most = None;
    }
    for one in fitted {
        let leader = &mut task.weights[one.leader];
        let most = one.bound.most / one.factor;
        if leader.least > most {
            return Err(CounterweightError::LeastDoesNotFit {
                name: one.bound.name.clone(),
                least: leader.least * one.factor,
                most: one.bound.most,
            });
        }
        leader.most = Some(leader.most.map_or(most, |known| known.min(most)));
    }
    for tie in task.ties.clone() {
        if fitted.iter().any(|one| one.leader == tie.first) {
            task.weights[tie.second].most = task.weights[tie.first].most.map(|most| most * tie.factor.abs());
        }
    }
    Ok(())
}

/// The direction opposite the crankpin of the web that a weight stands on, at `theta = 0` in the engine's frame [rad]; none where it stands on no web.
fn web_direction(engine: &Engine, weight: &FreeWeight) -> Option<f64> {
    let placed = placed(engine, weight, 0.0)?;
    let throw = &engine.throws[web_of(engine, &placed)? / 2];
    Some(engine.crankshafts[placed.crankshaft].phase + throw.angle + PI)
}

/// A weight of one gram metre in the place of a free one on a crankshaft, pointing in a direction of the engine's frame [rad].
fn placed(engine: &Engine, weight: &FreeWeight, direction: f64) -> Option<Counterweight> {
    let (Seat::Crankshaft(crankshaft), Place::At(z)) = (weight.seat, weight.z) else { return None };
    let angle = direction - engine.crankshafts[crankshaft].phase;
    Some(Counterweight { name: weight.name.clone(), crankshaft, z, unbalance: SCALE, angle, part: None })
}

/// Unbalance that what fits is computed in [kg m].
const SCALE: f64 = 0.01;

/// What fits in the place of a weight that points in a direction [rad].
fn bound_of(
    engine: &Engine,
    weight: &FreeWeight,
    direction: f64,
    is_default: bool,
) -> Result<WebBound, CounterweightError> {
    let no_space = |missing| CounterweightError::NoSpace { name: weight.name.clone(), missing };
    let Some(task) = engine.shape_task else {
        return Err(no_space("the shapes that are allowed: a section [counterweight_design]"));
    };
    let Some(placed) = placed(engine, weight, direction) else {
        return Err(no_space("a place on a web: `web = 1`"));
    };
    let mut bare = engine.clone();
    bare.counterweights = vec![placed];
    let around = Surroundings::of(&bare, 0, &task)?;
    let mut seat = WebSeat::new(&bare, task.density, [(0, around.envelope.clone())]);
    let shapes = within(&around.task, around.envelope.as_ref());
    let shapes = ShapeTask { most_balance: None, least_balance: 1.0, ..shapes };
    let found = largest_unbalance(&DesignTask::new(SCALE, &shapes), &mut seat)?;
    if let Some(fault) = seat.fault {
        return Err(fault);
    }
    let Some(LargestUnbalance { design, unbalance, bound, proved }) = found.filter(|one| one.unbalance > 0.0)
    else {
        return Err(CounterweightError::NothingFits { name: weight.name.clone() });
    };
    Ok(WebBound {
        name: weight.name.clone(),
        most: unbalance / task.least_balance * (1.0 - BELOW),
        direction,
        limits: limits(&around, &design),
        proved: proved.then_some(bound / task.least_balance),
        is_default,
    })
}

/// What a design stands against.
fn limits(around: &Surroundings, design: &Design) -> Vec<FitLimit> {
    let task = &around.task;
    let at = |value: f64, limit: f64| value >= limit * (1.0 - 1e-6);
    let mut limits = Vec::new();
    if let (Some(envelope), Some(reach)) = (&around.envelope, &around.reach)
        && (reach.excess(&design.shape) > -1e-5 || design.swept_radius > envelope.circle - 1e-6)
    {
        limits.push(FitLimit::Clearance(envelope.nearest.limit));
    }
    let given = [
        (FitLimit::SweptRadius, design.swept_radius, task.limits.swept_radius),
        (FitLimit::Mass, design.mass, task.limits.mass),
        (FitLimit::Inertia, design.inertia, task.limits.inertia),
        (FitLimit::HalfWidth, design.half_width, task.limits.half_width),
        (FitLimit::ArcRadius, design.shape.arc_radius, Some(task.arc_radius.most)),
        (FitLimit::ArcAngle, design.shape.arc_angle, Some(task.arc_angle.most)),
    ];
    limits.extend(
        given
            .iter()
            .filter(|(_, value, limit)| limit.is_some_and(|limit| at(*value, limit)))
            .map(|one| one.0),
    );
    if at(design.thickness, task.thickness.most) {
        limits.push(if around.is_thinner { FitLimit::RodsBeside } else { FitLimit::Thickness });
    }
    if limits.iter().all(|limit| matches!(limit, FitLimit::Thickness | FitLimit::RodsBeside)) {
        limits.push(FitLimit::Height);
    }
    limits
}
