//! Best first: of all boxes the one with the lowest bound is divided next, until no box can hold anything better than
//! what was found.

use super::alike::Alike;
use super::choices::{Choices, Split};
use super::reading::Reading;
use super::relaxed::Ground;
use crate::convex::Failure;
use crate::error::BalanceError;
use crate::infeasible::relaxation;
use crate::problem::Problem;
use crate::stages::{GAP, Held, Walk};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Most boxes examined for one stage.
pub(crate) const MOST_NODES: usize = 2000;

/// How far a search goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    /// Most boxes examined.
    nodes: usize,
    /// Share of the value that may stay open.
    gap: f64,
}

impl Effort {
    /// What was asked for: to the promised gap.
    pub const FULL: Effort = Effort { nodes: MOST_NODES, gap: 0.0 };
    /// What decides among equals. Within the gap of what was asked these are never quite settled: a share of a part in
    /// 10^9 of the force may be worth one in 10^7 of the couple.
    pub const AMONG_EQUALS: Effort = Effort { nodes: 200, gap: 1e-5 };
}

/// Share of the promised gap that a search uses up; the rest is what later stages may give up of earlier ones.
const SEARCHED: f64 = 0.5;

/// Optima of boxes closer than this share of the largest gap are the same.
const SAME: f64 = 1e-3;

/// Rounds in which a new best choice is moved along its places and phases in turn.
const MOVES: usize = 4;

/// How far the point of a box may pass a limit: it is read for the next choice, and only its bound counts.
const BOUNDED: f64 = 1e-5;

/// A box is not divided any more after so many on end whose bounds were spoiled by rounding.
const MOST_SPOILED: usize = 12;

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
    /// Whether the search ended because of the number of boxes.
    pub stopped: bool,
}

/// A box with what its programme says.
struct Examined {
    choices: Choices,
    /// Lower bound.
    bound: f64,
    /// Optimum of its programme, where it was found.
    value: f64,
    /// Where to divide it.
    split: Option<Split>,
    /// How many boxes on end, this one the last, have most of what is open because of rounding.
    spoiled: usize,
}

/// What a box has from the one that it is a part of.
#[derive(Debug, Clone, Copy)]
struct Parent {
    bound: f64,
    spoiled: usize,
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
    target: f64,
}

/// A search over boxes of choices.
pub(super) struct Search<'a> {
    pub ground: &'a Ground<'a>,
    alike: Alike,
    pub nodes: usize,
    pub solves: usize,
}

impl<'a> Search<'a> {
    pub fn new(ground: &'a Ground<'a>) -> Search<'a> {
        Search { ground, alike: Alike::of(ground.task), nodes: 0, solves: 0 }
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
        let mut hunt =
            Hunt { goal, held, gap: effort.gap, best: None, aside: Vec::new(), queue: BinaryHeap::new() };
        if let Some(known) = known {
            self.attempt(&mut hunt, known)?;
        }
        let limit = self.nodes + effort.nodes;
        for choices in start {
            self.examine(&mut hunt, choices, Parent { bound: f64::NEG_INFINITY, spoiled: 0 })?;
        }
        let mut stopped = false;
        while let Some(lowest) = hunt.queue.pop() {
            if hunt.closes(lowest.bound) {
                hunt.aside.push(lowest);
                continue;
            }
            if self.nodes >= limit {
                stopped = true;
                hunt.aside.push(lowest);
                break;
            }
            let Some(split) = lowest.split else {
                hunt.aside.push(lowest);
                continue;
            };
            let parent = Parent { bound: lowest.bound, spoiled: lowest.spoiled };
            for part in lowest.choices.divided(self.ground.task, split) {
                if self.alike.in_order(self.ground.task, &part) {
                    self.examine(&mut hunt, part, parent)?;
                }
            }
        }
        hunt.aside.extend(hunt.queue.drain());
        Ok(hunt.found(stopped))
    }

    /// Bounds a box, tries the choice nearest to its optimum, and keeps the box if it may hold something better.
    fn examine(&mut self, hunt: &mut Hunt, choices: Choices, parent: Parent) -> Result<(), BalanceError> {
        self.nodes += 1;
        let Some(mut problem) = self.ground.problem(&choices)? else { return Ok(()) };
        problem.programme.holds = BOUNDED;
        let optimum = match self.optimum(&problem, hunt.goal, hunt.held) {
            Ok(optimum) => optimum,
            Err(Failure::Infeasible) => return Ok(()),
            Err(Failure::NoPoint) => {
                // Nothing is known about it but what holds for the box that it came from.
                let split = choices.widest(self.ground.task);
                let (bound, spoiled) = (parent.bound, parent.spoiled);
                let unknown = Examined { choices, bound, value: f64::NEG_INFINITY, split, spoiled };
                hunt.queue.push(unknown);
                return Ok(());
            }
        };
        let bound = optimum.bound.max(parent.bound);
        if hunt.is_worse(bound) {
            return Ok(());
        }
        let reading = Reading::of(self.ground.task, &choices, &problem, &optimum.x);
        if !hunt.closes(bound) {
            self.attempt(hunt, &reading.nearest())?;
        }
        // Where rounding spoils a certificate or a point the parts of the box may have better ones, but not for ever.
        let rounding = optimum.value - optimum.bound;
        let open = hunt.best.as_ref().map_or(f64::INFINITY, |best| best.value - bound);
        let spoiled = if rounding > 0.5 * open { parent.spoiled + 1 } else { 0 };
        let split = reading.split().or_else(|| choices.widest(self.ground.task));
        let split = split.filter(|_| spoiled < MOST_SPOILED);
        hunt.queue.push(Examined { choices, bound, value: optimum.value, split, spoiled });
        Ok(())
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
            let target = (SEARCHED * optimum.target).max(hunt.gap * optimum.value);
            let helps = before - optimum.value > target;
            hunt.best = Some(Incumbent { choices: choices.clone(), value: optimum.value, target });
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
                Ok(Optimum { x: walk.x, value, bound: proof.bound.min(value), target: proof.target })
            }
            Goal::Relaxation => {
                let relaxed = relaxation(problem, &mut self.solves)?;
                let target = 10.0 * GAP * relaxed.value.max(1e-3);
                let bound = relaxed.bound.min(relaxed.value);
                Ok(Optimum { x: relaxed.x, value: relaxed.value, bound, target })
            }
        }
    }
}

/// The state of one search.
struct Hunt<'a> {
    goal: Goal,
    held: &'a [Held],
    /// Share of the value that may stay open.
    gap: f64,
    best: Option<Incumbent>,
    /// Boxes that need no more division.
    aside: Vec<Examined>,
    queue: BinaryHeap<Examined>,
}

impl Hunt<'_> {
    /// Whether nothing in a box with this bound is better than the best by more than the gap.
    fn closes(&self, bound: f64) -> bool {
        self.best.as_ref().is_some_and(|best| bound >= best.value - best.target)
    }

    /// Whether everything in a box with this bound is worse than the best by more than the gap.
    fn is_worse(&self, bound: f64) -> bool {
        self.best.as_ref().is_some_and(|best| bound > best.value + best.target)
    }

    fn found(self, stopped: bool) -> Found {
        let value = self.best.as_ref().map_or(f64::INFINITY, |best| best.value);
        let bound = self.aside.iter().map(|one| one.bound).fold(value, f64::min);
        let left: Vec<&Examined> = self.aside.iter().filter(|one| !self.is_worse(one.bound)).collect();
        let same = self.best.as_ref().map_or(0.0, |best| SAME * best.target);
        Found {
            bound,
            exact: left.iter().all(|one| one.value >= value - same),
            left: left.into_iter().map(|one| one.choices.clone()).collect(),
            stopped,
            best: self.best,
        }
    }
}
