//! Best first: of all boxes the one with the lowest bound is divided next, until no box can hold anything better than
//! what was found.

use super::alike::Alike;
use super::choices::{Choices, Split};
use super::reading::Reading;
use super::relaxed::Ground;
use crate::convex::{Failure, GAP};
use crate::error::BalanceError;
use crate::infeasible::relaxation;
use crate::problem::Problem;
use crate::settings::{BalanceSettings, Next, SearchState, StopCause};
use crate::stages::{Held, Walk};
use lanchester_task::GiveUp;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Most nodes for what decides among equals, and the share of the value that may stay open there. Within the gap of what was
/// asked these are never quite settled: a share of a part in 10^9 of the force may be worth one in 10^7 of the couple.
const AMONG_EQUALS: (usize, f64) = (200, 1e-5);

/// How far a search goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    /// Most boxes examined.
    nodes: usize,
    /// The gap that is aimed at as a multiple of the promised one.
    looseness: f64,
    /// Share of the value that may stay open beyond it.
    gap: f64,
}

impl Effort {
    /// What was asked for: to the gap of the settings.
    pub fn full(settings: &BalanceSettings) -> Effort {
        Effort { nodes: settings.max_nodes, looseness: settings.looseness(), gap: 0.0 }
    }

    /// What decides among equals.
    pub fn among_equals(settings: &BalanceSettings) -> Effort {
        let (nodes, gap) = AMONG_EQUALS;
        Effort { nodes: nodes.min(settings.max_nodes), gap, ..Effort::full(settings) }
    }
}

/// Share of the promised gap that a search uses up. Later stages may give up as much again; what is left is for rounding.
const SEARCHED: f64 = 0.45;

/// Optima of boxes closer than this share of the slack are the same.
const SAME: f64 = 1e-3;

/// Rounds in which a new best choice is moved along its places and phases in turn.
const MOVES: usize = 4;

/// How far the point of a box may pass a limit: it is read for the next choice, and only its bound counts.
const BOUNDED: f64 = 1e-5;

/// A box is not divided any more after so many on end whose bounds were spoiled by rounding.
const MOST_SPOILED: usize = 12;

/// A division that leaves no more than this share of what was open is good enough: no other is tried.
const ENOUGH: f64 = 0.5;

/// What is minimised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Goal {
    /// A stage of the task, by index.
    Stage(usize),
    /// The common factor by which the limits are relaxed.
    Relaxation,
}

/// A choice that is allowed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Incumbent {
    pub choices: Choices,
    pub value: f64,
    /// A box that is better by no more than this is not divided.
    pub slack: f64,
    /// Largest gap that counts as closed.
    pub target: f64,
}

/// What the search for one goal led to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Found {
    /// The best choice, if any is allowed.
    pub best: Option<Incumbent>,
    /// Nothing that is allowed goes below this.
    pub bound: f64,
    /// Boxes that may hold what is as good as the best.
    pub left: Vec<Choices>,
    /// Whether the optimum of every box left is the best value itself.
    pub exact: bool,
    /// What ended the search before its gap was closed.
    pub stopped: Option<StopCause>,
}

/// A box with what its programme says.
struct Examined {
    choices: Choices,
    /// Lower bound.
    bound: f64,
    /// Optimum of its programme, where it was found.
    value: f64,
    /// Where it can be divided; none where it is not divided any more.
    splits: Vec<Split>,
    /// How many boxes on end, this one the last, have most of what is open because of rounding.
    spoiled: usize,
}

/// What a box has from the one that it is a part of.
#[derive(Debug, Clone, Copy)]
struct Parent {
    bound: f64,
    spoiled: usize,
}

impl Examined {
    /// A box of which nothing is known: nothing that is minimised is below 0.
    fn unseen(choices: Choices) -> Examined {
        Examined { choices, bound: 0.0, value: f64::NEG_INFINITY, splits: Vec::new(), spoiled: 0 }
    }
}

impl PartialEq for Examined {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Examined {}

impl PartialOrd for Examined {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Examined {
    /// The lowest bound is the greatest.
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

/// Optimum of one convex programme.
struct Optimum {
    x: Vec<f64>,
    value: f64,
    bound: f64,
    /// Gap that is aimed at.
    aim: f64,
    /// Largest gap that counts as closed.
    target: f64,
}

/// A search over branch-and-bound nodes.
pub(super) struct Search<'a> {
    pub ground: &'a Ground<'a>,
    alike: Alike,
    pub nodes: usize,
    pub solves: usize,
    /// Whoever asked wants the best so far.
    pub stopped: Option<StopCause>,
}

impl<'a> Search<'a> {
    pub fn new(ground: &'a Ground<'a>) -> Search<'a> {
        Search { ground, alike: Alike::of(ground.task), nodes: 0, solves: 0, stopped: None }
    }

    /// Minimises a goal over the boxes of `start` with the earlier stages held, beginning from a choice that is known.
    pub fn run(
        &mut self,
        goal: Goal,
        start: Vec<Choices>,
        held: &[Held],
        known: Option<&Choices>,
        effort: Effort,
    ) -> Result<Found, BalanceError> {
        let mut hunt = Hunt {
            goal,
            give_up: match goal {
                Goal::Stage(stage) => self.ground.task.give_up.get(stage).copied().unwrap_or_default(),
                Goal::Relaxation => GiveUp::Nothing,
            },
            held,
            effort,
            best: None,
            aside: Vec::new(),
            queue: BinaryHeap::new(),
            // Peaks, masses and unbalances are not negative.
            lowest: 0.0,
        };
        if let Some(known) = known {
            self.attempt(&mut hunt, known)?;
        }
        let limit = self.nodes + effort.nodes;
        for choices in start {
            if !self.goes_on(&hunt)? {
                hunt.aside.push(Examined::unseen(choices));
                continue;
            }
            let whole = self.examine(&mut hunt, choices, Parent { bound: f64::NEG_INFINITY, spoiled: 0 })?;
            hunt.queue.extend(whole);
        }
        let mut stopped = self.stopped;
        while let Some(lowest) = hunt.queue.pop() {
            hunt.lowest = lowest.bound;
            if hunt.closes(lowest.bound) {
                hunt.aside.push(lowest);
                continue;
            }
            if stopped.is_none() && self.nodes >= limit {
                stopped = Some(StopCause::MaxNodes);
            }
            if stopped.is_some() {
                hunt.aside.push(lowest);
                break;
            }
            if lowest.splits.is_empty() {
                hunt.aside.push(lowest);
                continue;
            }
            match self.parts(&mut hunt, &lowest)? {
                Some(parts) => hunt.queue.extend(parts),
                None => {
                    stopped = self.stopped;
                    hunt.aside.push(lowest);
                    break;
                }
            }
        }
        hunt.aside.extend(hunt.queue.drain());
        Ok(hunt.found(stopped))
    }

    /// Asks whether to examine one more node.
    fn goes_on(&mut self, hunt: &Hunt) -> Result<bool, BalanceError> {
        if self.stopped.is_some() {
            return Ok(false);
        }
        let value = hunt.best.as_ref().map(|best| best.value);
        let stages = &self.ground.task.stages;
        let (index, stage) = match hunt.goal {
            Goal::Stage(index) => (index, stages.get(index)),
            Goal::Relaxation => (0, None),
        };
        let bound = hunt.aside.iter().map(|one| one.bound).fold(hunt.lowest, f64::min);
        let bound = value.map_or(bound, |value| bound.min(value)).max(0.0);
        let state = SearchState { stage, index, stages: stages.len(), value, bound, nodes: self.nodes };
        match (self.ground.watch)(&state) {
            Next::Continue => {}
            Next::Stop(cause) => self.stopped = Some(cause),
            Next::Abandon => return Err(BalanceError::BrokenOff),
        }
        Ok(self.stopped.is_none())
    }

    /// The parts of a box, divided where that leaves the least open. Where a whole range of places is equally good, to
    /// divide it doubles the boxes that are open, while dividing the phases closes them; elsewhere it is the other way.
    /// `None` where the search ends before all parts were examined: the box stays whole.
    fn parts(&mut self, hunt: &mut Hunt, whole: &Examined) -> Result<Option<Vec<Examined>>, BalanceError> {
        let parent = Parent { bound: whole.bound, spoiled: whole.spoiled };
        let (mut least, mut kept) = (f64::INFINITY, Vec::new());
        // Every division bounds the whole box.
        let mut proved = whole.bound;
        for &split in &whole.splits {
            let mut parts = Vec::new();
            for part in whole.choices.divided(self.ground.task, split) {
                if !self.alike.in_order(self.ground.task, &part) {
                    continue;
                }
                if !self.goes_on(hunt)? {
                    return Ok(None);
                }
                parts.extend(self.examine(hunt, part, parent)?);
            }
            proved = proved.max(parts.iter().map(|part| part.bound).fold(f64::INFINITY, f64::min));
            let open = parts.iter().map(|part| hunt.open(part.bound)).sum();
            if kept.is_empty() || open < least {
                (least, kept) = (open, parts);
            }
            if least <= ENOUGH * hunt.open(whole.bound) {
                break;
            }
        }
        kept.iter_mut().for_each(|part| part.bound = part.bound.max(proved));
        Ok(Some(kept))
    }

    /// Bounds a box and tries the choice nearest to its optimum; `None` where it holds nothing better.
    fn examine(
        &mut self,
        hunt: &mut Hunt,
        choices: Choices,
        parent: Parent,
    ) -> Result<Option<Examined>, BalanceError> {
        self.nodes += 1;
        let Some(mut problem) = self.ground.problem(&choices)? else { return Ok(None) };
        problem.programme.holds = BOUNDED;
        let optimum = match self.optimum(&problem, hunt.goal, hunt.held) {
            Ok(optimum) => optimum,
            Err(Failure::Infeasible) => return Ok(None),
            Err(Failure::NoPoint) if self.cannot_hold(&problem, hunt.held) => return Ok(None),
            Err(Failure::NoPoint) => {
                // Nothing is known about it but what holds for the box that it came from.
                let splits = choices.widest(self.ground.task).into_iter().collect();
                let (bound, spoiled) = (parent.bound, parent.spoiled);
                return Ok(Some(Examined { choices, bound, value: f64::NEG_INFINITY, splits, spoiled }));
            }
        };
        let bound = optimum.bound.max(parent.bound);
        if hunt.is_worse(bound) {
            return Ok(None);
        }
        // Where rounding spoils a certificate or a point the parts of the box may have better ones, but not for ever.
        let (rounding, open) = (optimum.value - optimum.bound, hunt.open(bound));
        let spoils = open > 0.0 && rounding > 0.5 * open;
        if spoils && self.cannot_hold(&problem, hunt.held) {
            return Ok(None);
        }
        let reading = Reading::of(self.ground.task, &choices, &problem, &optimum.x);
        if !hunt.closes(bound) {
            let before = hunt.best.as_ref().map_or(f64::INFINITY, |best| best.value);
            self.attempt(hunt, &reading.nearest())?;
            if hunt.best.as_ref().is_some_and(|best| best.value < before) {
                self.step_about(hunt)?;
            }
        }
        let spoiled = if spoils { parent.spoiled + 1 } else { 0 };
        let mut splits = reading.splits();
        if splits.is_empty() {
            splits.extend(choices.widest(self.ground.task));
        }
        if spoiled >= MOST_SPOILED {
            splits.clear();
        }
        Ok(Some(Examined { choices, bound, value: optimum.value, splits, spoiled }))
    }

    /// Whether an earlier stage is worse in a whole box than it may be. A box that no earlier stage allows, but for
    /// rounding, has a poor certificate of a later one.
    fn cannot_hold(&mut self, problem: &Problem, held: &[Held]) -> bool {
        let inexact = held.iter().enumerate().filter(|one| !one.1.exact);
        for (stage, one) in inexact {
            match self.optimum(problem, Goal::Stage(stage), &held[..stage]) {
                Ok(optimum) if optimum.bound > one.value + one.slack => return true,
                Err(Failure::Infeasible) => return true,
                Ok(_) | Err(Failure::NoPoint) => {}
            }
        }
        false
    }

    /// Solves the programme of a choice whose places are given and keeps it if it is the best so far; then moves places
    /// with the phases as they are, and phases with the places as they are, as long as that helps.
    fn attempt(&mut self, hunt: &mut Hunt, choices: &Choices) -> Result<(), BalanceError> {
        let mut choices = choices.clone();
        for _ in 0..MOVES {
            let Some(problem) = self.ground.problem(&choices)? else { return Ok(()) };
            let Ok(optimum) = self.optimum(&problem, hunt.goal, hunt.held) else { return Ok(()) };
            let before = hunt.best.as_ref().map_or(f64::INFINITY, |best| best.value);
            if optimum.value >= before {
                return Ok(());
            }
            let Effort { looseness, gap, .. } = hunt.effort;
            let slack = (SEARCHED * looseness * optimum.aim).max(gap * optimum.value);
            let target = optimum.target.max(2.0 * slack).max(looseness * optimum.aim);
            let helps = before - optimum.value > slack;
            hunt.best = Some(Incumbent { choices: choices.clone(), value: optimum.value, slack, target });
            let root = Choices::of(self.ground.task);
            let Some(everywhere) = root.first().filter(|_| helps) else { return Ok(()) };
            let reading = Reading::of(self.ground.task, &choices, &problem, &optimum.x);
            let along = reading.along(everywhere);
            if along == choices {
                return Ok(());
            }
            let Some(problem) = self.ground.problem(&along)? else { return Ok(()) };
            let Ok(moved) = self.optimum(&problem, hunt.goal, hunt.held) else { return Ok(()) };
            let nearest = Reading::of(self.ground.task, &along, &problem, &moved.x).nearest();
            choices = reading.freed(nearest);
        }
        Ok(())
    }

    /// Moves the amounts of catalogues up and down by one, as long as that helps.
    fn step_about(&mut self, hunt: &mut Hunt) -> Result<(), BalanceError> {
        for _ in 0..MOVES {
            let Some(before) = hunt.best.as_ref().map(|best| best.value) else { return Ok(()) };
            for weight in 0..self.ground.task.weights.len() {
                for up in [true, false] {
                    let Some(best) = &hunt.best else { return Ok(()) };
                    if let Some(stepped) = best.choices.stepped(self.ground.task, weight, up) {
                        self.attempt(hunt, &stepped)?;
                    }
                }
            }
            if hunt.best.as_ref().is_none_or(|best| before - best.value <= best.slack) {
                return Ok(());
            }
        }
        Ok(())
    }

    fn optimum(&mut self, problem: &Problem, goal: Goal, held: &[Held]) -> Result<Optimum, Failure> {
        match goal {
            Goal::Stage(stage) => {
                let mut walk = Walk::new(problem);
                for (earlier, held) in held.iter().enumerate() {
                    walk.hold(earlier, *held, &mut self.solves)?;
                }
                walk.stage(&problem.stages[stage], &mut self.solves)?;
                let proof = walk.proofs.pop().ok_or(Failure::NoPoint)?;
                let value = proof.solution.value * proof.scale;
                let bound = proof.bound.min(value);
                Ok(Optimum { x: walk.x, value, bound, aim: proof.aim, target: proof.target })
            }
            Goal::Relaxation => {
                let relaxed = relaxation(problem, &mut self.solves)?;
                let target = 10.0 * GAP * relaxed.value.max(1e-3);
                let bound = relaxed.bound.min(relaxed.value);
                Ok(Optimum { x: relaxed.x, value: relaxed.value, bound, aim: target, target })
            }
        }
    }
}

/// The state of one search.
struct Hunt<'a> {
    goal: Goal,
    /// What the stage gives up for later ones: boxes that are worse by no more than that stay theirs.
    give_up: GiveUp,
    held: &'a [Held],
    effort: Effort,
    best: Option<Incumbent>,
    /// Boxes that need no more division.
    aside: Vec<Examined>,
    queue: BinaryHeap<Examined>,
    /// Bound of the box that is divided, the lowest of the queue.
    lowest: f64,
}

impl Hunt<'_> {
    /// Whether nothing in a box with this bound is better than the best by more than the gap.
    fn closes(&self, bound: f64) -> bool {
        self.best.as_ref().is_some_and(|best| bound >= best.value - best.slack)
    }

    /// How much better than the best a box with this bound may be, nothing where that is within the gap.
    fn open(&self, bound: f64) -> f64 {
        if self.closes(bound) {
            0.0
        } else {
            self.best.as_ref().map_or(f64::INFINITY, |best| best.value - bound)
        }
    }

    /// Whether everything in a box with this bound is worse than the best by more than the gap and what may be given up.
    fn is_worse(&self, bound: f64) -> bool {
        let most = |best: &Incumbent| best.value + best.slack + self.give_up.amount(best.value);
        self.best.as_ref().is_some_and(|best| bound > most(best))
    }

    fn found(self, stopped: Option<StopCause>) -> Found {
        let value = self.best.as_ref().map_or(f64::INFINITY, |best| best.value);
        let bound = self.aside.iter().map(|one| one.bound).fold(value, f64::min);
        let left: Vec<&Examined> = self.aside.iter().filter(|one| !self.is_worse(one.bound)).collect();
        let same = self.best.as_ref().map_or(0.0, |best| SAME * best.slack);
        Found {
            bound,
            exact: left.iter().all(|one| one.value >= value - same),
            left: left.into_iter().map(|one| one.choices.clone()).collect(),
            stopped,
            best: self.best,
        }
    }
}
