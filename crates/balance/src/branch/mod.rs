//! Branch and bound around the convex programmes: places that are to be found, given and least amounts, devices that
//! may be left out.
//!
//! A box of choices has a convex programme that loses nothing of it ([`relaxed`]), whose certificate bounds everything in
//! the box from below. The box with the lowest bound is divided; choices near the programmes' optima are tried, and the
//! best of them bounds the optimum from above. The search ends when no box can hold anything better by more than its share
//! of the gap that was asked for, after the largest number of nodes for a stage, or when whoever asked wants the best so far
//! ([`crate::BalanceSettings`], [`crate::Next`]): then the gap that is left is stated. A box that is divided when the search
//! ends stays whole, and a box that was not examined has the bound 0, so that the bound holds whenever it ends. What only decides
//! among equals is searched less far ([`search::Effort::among_equals`]).
//!
//! Later stages search the boxes that are left of the earlier ones. They hold an earlier stage within as large a share of
//! the gap; where the earlier optimum does not depend on the choices that are left they hold it exactly.
//!
//! Source: book, "Choices: branch and bound", eqs. (18.1) to (18.4).

mod alike;
mod choices;
mod reading;
mod relaxed;
mod search;

use crate::error::BalanceError;
use crate::fitted::bare;
use crate::operator::EngineLoads;
use crate::over_speed::places::SpeedPlaces;
use crate::problem::{Problem, has_free_axis, implied, is_of_crank, stages};
use crate::settings::{BalanceSettings, StopCause, Watch};
use crate::stages::{Held, Reached, Walk};
use choices::{Choices, stretch};
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, FreeWeight, Limit, Load, Phase, Place, Seat, Stage};
use relaxed::Ground;
use search::{Effort, Found, Goal, Search};
use std::rc::Rc;

/// The best choice with its convex programme.
pub(crate) struct Chosen {
    pub problem: Problem,
    /// Where the stages led with these choices given; their bounds are those over all choices.
    pub reached: Reached,
    /// Plane of every weight [m].
    pub planes: Vec<f64>,
    /// Axis of every shaft [m].
    pub axes: Vec<[f64; 2]>,
    /// The inertia that is used.
    pub inertia: Option<usize>,
    /// The first stage whose search ended before its gap was closed, and why.
    pub stopped: Option<(usize, StopCause)>,
}

impl Chosen {
    /// Takes what was searched beyond the stages that were asked for as what decides among equals.
    fn part(&mut self, asked: usize) {
        let Chosen { problem, reached, .. } = self;
        let mut implied = problem.stages.split_off(asked);
        let proofs = reached.stages.split_off(asked).into_iter().enumerate();
        let later = std::mem::take(&mut reached.among_equals).into_iter();
        let count = implied.len();
        reached.among_equals = proofs.chain(later.map(|(place, proof)| (place + count, proof))).collect();
        implied.append(&mut problem.implied);
        problem.implied = implied;
        self.stopped = self.stopped.filter(|(stage, _)| *stage < asked);
    }
}

/// How a search ended.
pub(crate) enum Ending {
    Chosen(Box<Chosen>),
    /// The limits cannot hold together: their common relaxation and the closest value of each alone; none of them where the
    /// search ended before they were found.
    Infeasible {
        relaxation: f64,
        closest: Vec<f64>,
    },
    /// Nothing was found that holds the limits, and nothing proves that there is nothing.
    Nothing(StopCause),
}

/// A search with what it cost.
pub(crate) struct Searched {
    pub ending: Ending,
    pub nodes: usize,
    pub solves: usize,
}

/// Whether a task asks for more than one convex programme.
pub(crate) fn is_needed(task: &BalanceTask) -> bool {
    let place = |place: Place| matches!(place, Place::Between(..));
    task.weights.iter().any(|w| w.least > 0.0 || place(w.z) || w.catalogue.is_some())
        || has_free_axis(task)
        || task.inertias.len() > 1
        || task.most_optional.is_some()
        || pays(task)
}

/// Whether the use of a device has a cost that counts.
fn pays(task: &BalanceTask) -> bool {
    (0..task.weights.len()).any(|weight| task.pays_for_weight(weight))
        || (0..task.shafts.len()).any(|shaft| task.pays_for_shaft(shaft))
}

/// Whether one of the choices cannot be said by a convex programme.
pub(crate) fn is_choice(task: &BalanceTask) -> bool {
    let place = |place: Place| matches!(place, Place::Between(..));
    let open = |w: &FreeWeight| {
        !matches!(w.phase, Phase::Direction(_)) && (w.least > 0.0 || place(w.z))
            || w.least > 0.0 && w.optional
            || w.catalogue.is_some()
            // A crankshaft bends otherwise on either side of a plane, and other mains carry it on either side of a main.
            || place(w.z) && matches!(w.seat, Seat::Crankshaft(_))
    };
    has_free_axis(task)
        || task.weights.iter().any(open)
        || task.inertias.len() > 1
        || task.most_optional.is_some()
        || pays(task)
}

/// Searches all choices of a task, as far as the settings say and for as long as `watch` does.
pub(crate) fn search(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    places: &Rc<SpeedPlaces>,
    settings: &BalanceSettings,
    watch: &Watch,
) -> Result<Searched, BalanceError> {
    let bare = bare(engine, task);
    let loads = EngineLoads::of(&bare, kinematics)?.judged_at(places);
    let asked = stages(task);
    let asked_count = asked.len();
    // An axis that is to be found is not left to chance by those who do not name the roll moment. The bearings of a crankshaft
    // decide with the choices kept: to search all choices for them takes many times as long.
    let mut decisive = implied(engine, task);
    // Amounts of a catalogue are searched for them too: kept, they would be whatever the stages leave open.
    let steps = task.weights.iter().any(|weight| weight.catalogue.is_some());
    decisive.retain(|criterion| steps || has_free_axis(task) && !is_of_crank(criterion));
    let decisive = decisive.into_iter().map(|criterion| Stage { terms: vec![(1.0, criterion)] });
    let mut task = BalanceTask { stages: asked.into_iter().chain(decisive).collect(), ..task.clone() };
    if !sees_axes(&task) {
        let middle = |place: Place| Place::At(stretch(place).iter().sum::<f64>() / 2.0);
        for shaft in &mut task.shafts {
            (shaft.x, shaft.y) = (middle(shaft.x), middle(shaft.y));
        }
    }
    let task = &task;
    let ground = Ground { engine, bare, loads, task, settings: *settings, watch };
    let mut search = Search::new(&ground);
    let mut ending = ending(&mut search, &ground, asked_count)?;
    if let Ending::Chosen(chosen) = &mut ending {
        chosen.part(asked_count);
    }
    Ok(Searched { ending, nodes: search.nodes, solves: search.solves })
}

/// Whether anything that is judged depends on where the axis of a shaft is.
fn sees_axes(task: &BalanceTask) -> bool {
    let stages = task.stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    stages.chain(task.limits.iter().map(|limit| limit.criterion)).any(|criterion| match criterion {
        Criterion::Peak(load) | Criterion::Order(load, _) => load == Load::RollMoment || load.is_at_mounts(),
        Criterion::MainRms(_) | Criterion::MainMean(_) | Criterion::MainsWithGas(..) => false,
        Criterion::AddedMass | Criterion::AddedUnbalance | Criterion::Cost => false,
    })
}

/// Searches stage after stage; of these the first `asked` were asked for.
fn ending(search: &mut Search, ground: &Ground, asked: usize) -> Result<Ending, BalanceError> {
    let count = stages(ground.task).len();
    let mut boxes = Choices::of(ground.task);
    let mut held: Vec<Held> = Vec::new();
    let mut known: Option<Choices> = None;
    let mut bounds = Vec::new();
    let mut given_up = Vec::new();
    let mut stopped = None;
    for stage in 0..count {
        let settings = &ground.settings;
        let effort = if stage < asked { Effort::full(settings) } else { Effort::among_equals(settings) };
        let found = search.run(Goal::Stage(stage), boxes, &held, known.as_ref(), effort)?;
        let Some(best) = &found.best else {
            // What was asked stands whether or not this has a solution.
            if stage >= asked {
                break;
            }
            let cause = found.stopped.unwrap_or(StopCause::Rounding);
            return if found.left.is_empty() { refusal(search, ground) } else { Ok(Ending::Nothing(cause)) };
        };
        if let Some(cause) = found.stopped {
            stopped.get_or_insert((stage, cause));
        }
        bounds.push((found.bound, best.target));
        let allowed = ground.task.give_up.get(stage).map_or(0.0, |give_up| give_up.amount(best.value));
        let allowed = if allowed > best.target { allowed } else { 0.0 };
        given_up.push(allowed);
        let slack = best.slack + allowed;
        held.push(Held { value: best.value, slack, exact: found.exact && allowed == 0.0 });
        known = Some(best.choices.clone());
        boxes = found.left;
    }
    let nothing = Ending::Nothing(stopped.map_or(StopCause::Rounding, |(_, cause)| cause));
    let Some(choices) = known else { return Ok(nothing) };
    let Some(problem) = ground.problem(&choices)? else { return Ok(nothing) };
    let Some(mut reached) = reached(&problem, &held, &given_up, &mut search.solves) else {
        return Ok(nothing);
    };
    for (proof, (bound, target)) in reached.stages.iter_mut().zip(bounds) {
        (proof.bound, proof.target) = (bound, target);
    }
    for (proof, (held, allowed)) in reached.stages.iter_mut().zip(held.iter().zip(given_up)) {
        if allowed > 0.0 {
            (proof.least, proof.allowed) = (held.value, allowed);
        }
    }
    let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
    Ok(Ending::Chosen(Box::new(Chosen {
        reached,
        planes: choices.weights.iter().map(|w| middle(w.z)).collect(),
        axes: choices.shafts.iter().map(|s| [middle(s.x), middle(s.y)]).collect(),
        inertia: choices.inertia,
        stopped,
        problem,
    })))
}

/// The point of a choice, the earlier stages held as in the search, and the proof of each stage.
fn reached(problem: &Problem, held: &[Held], given_up: &[f64], solves: &mut usize) -> Option<Reached> {
    let mut walk = Walk::new(problem);
    let mut proofs = Vec::new();
    for (stage, one) in held.iter().enumerate() {
        let mut alone = walk.clone();
        alone.stage(&problem.stages[stage], solves).ok()?;
        proofs.push(alone.proofs.pop()?);
        if one.exact || stage + 1 == held.len() && given_up[stage] == 0.0 {
            alone.proofs.clear();
            walk = alone;
        } else if stage + 1 == held.len() {
            walk.hold_from(alone.x, stage, *one, solves).ok()?;
        } else {
            walk.hold(stage, *one, solves).ok()?;
        }
    }
    Some(Reached { stages: proofs, ..walk.settle(solves) })
}

/// How far the limits are from holding together, and how close each alone can be reached.
fn refusal(search: &mut Search, ground: &Ground) -> Result<Ending, BalanceError> {
    let task = ground.task;
    if task.limits.is_empty() {
        return Ok(Ending::Infeasible { relaxation: f64::INFINITY, closest: Vec::new() });
    }
    let value = |found: &Found| found.best.as_ref().map_or(f64::INFINITY, |best| best.value);
    let effort = Effort::full(&ground.settings);
    let relaxed = search.run(Goal::Relaxation, Choices::of(task), &[], None, effort)?;
    let mut closest = Vec::new();
    for Limit { criterion, .. } in &task.limits {
        let alone = BalanceTask {
            limits: Vec::new(),
            stages: vec![Stage { terms: vec![(1.0, *criterion)] }],
            ..task.clone()
        };
        let ground = Ground {
            engine: ground.engine,
            bare: ground.bare.clone(),
            loads: ground.loads.clone(),
            task: &alone,
            settings: ground.settings,
            watch: ground.watch,
        };
        let mut own = Search::new(&ground);
        own.stopped = search.stopped;
        let found = own.run(Goal::Stage(0), Choices::of(&alone), &[], None, effort)?;
        search.nodes += own.nodes;
        search.solves += own.solves;
        search.stopped = own.stopped;
        closest.push(value(&found));
    }
    // That the limits cannot hold is proved; how far they are from it is not known to the end.
    if search.stopped.is_some() {
        return Ok(Ending::Infeasible { relaxation: f64::INFINITY, closest: Vec::new() });
    }
    Ok(Ending::Infeasible { relaxation: value(&relaxed), closest })
}
