//! The search: all directions by turns, both ways, and along the slope that they show, with steps that shrink.

use crate::answer::{Answer, Effect};
use crate::durable::answer::DurableStage;
use crate::durable::merit::{Aim, Wanted, soft_smallest};
use crate::durable::moved::moved;
use crate::durable::request::DurableRequest;
use crate::durable::space::Space;

use crate::error::BalanceError;
use crate::fitted::fitted;
use crate::optimum::optimise_watched;
use crate::settings::{BalanceSettings, Next, StopCause};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Load, Measured, Stage};
use num_complex::Complex64;

/// First step, and the step at which the search ends, as shares of the unit of unbalances.
const FIRST_STEP: f64 = 0.15;
const LAST_STEP: f64 = 0.004;

/// Share of a merit by which another must be better: less is the rounding of an orbit that repeats to a thousandth of its clearance.
const BETTER: f64 = 2e-3;

/// Share of its value by which what was reached before may fall while the next is made large.
const KEPT: f64 = 1e-3;

/// Share of what a stage would be without weights by which it may be raised: what its proof leaves open.
const ROUNDING: f64 = 1e-6;

/// A point with what was measured there.
#[derive(Clone)]
struct Point {
    unbalances: Vec<Complex64>,
    values: Vec<f64>,
}

pub(super) struct Climb<'a> {
    engine: &'a Engine,
    answer: &'a Answer,
    space: &'a Space,
    wanted: &'a Wanted,
    request: &'a DurableRequest<'a>,
    /// Points from which the search may begin; the first is the optimum.
    starts: Vec<Point>,
    best: Option<Point>,
    /// What earlier aims reached.
    reached: Vec<(Aim, f64)>,
    evaluations: usize,
    ending: Option<StopCause>,
    /// Whether stages or limits see what happens inside the crankshaft.
    sees_inside: bool,
    /// Whether a stage may be raised.
    gives_up: bool,
}

impl<'a> Climb<'a> {
    pub fn new(
        engine: &'a Engine,
        answer: &'a Answer,
        space: &'a Space,
        wanted: &'a Wanted,
        request: &'a DurableRequest<'a>,
    ) -> Climb<'a> {
        let task = &answer.task;
        let asked = asked(task);
        Climb {
            engine,
            answer,
            space,
            wanted,
            request,
            starts: Vec::new(),
            best: None,
            reached: Vec::new(),
            evaluations: 0,
            ending: None,
            sees_inside: asked.iter().any(|criterion| !is_on_block(*criterion)),
            gives_up: task.give_up.iter().any(|own| own.amount(1.0) > 0.0),
        }
    }

    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    pub fn ending(&self) -> Option<StopCause> {
        self.ending
    }

    pub fn is_over(&self) -> bool {
        self.ending.is_some()
    }

    /// The best unbalances so far.
    pub fn best(&self) -> Vec<Complex64> {
        self.best.as_ref().map_or_else(|| self.space.base(), |point| point.unbalances.clone())
    }

    /// Adds a start, if it holds what the stages allow.
    pub fn start(&mut self, unbalances: Vec<Complex64>) -> Result<(), BalanceError> {
        let is_base = self.starts.is_empty();
        let Some(within) = self.space.moved(&unbalances, &[]) else { return Ok(()) };
        if !is_base
            && (self.starts.iter().any(|start| start.unbalances == within) || !self.is_allowed(&within)?)
        {
            return Ok(());
        }
        if let Some(point) = self.measure(within)? {
            self.starts.push(point);
        }
        Ok(())
    }

    /// Makes an aim as large as the search can, keeping what earlier ones reached.
    pub fn up(&mut self, aim: Aim) -> Result<(), BalanceError> {
        let starts: Vec<Point> = self.best.iter().cloned().chain(self.starts.clone()).collect();
        let Some(mut best) = starts.into_iter().reduce(|best, other| {
            if self.is_better(aim, &other.values, &best.values) { other } else { best }
        }) else {
            return Ok(());
        };
        let [directions, neutral] = self.space.directions();
        // Where no stage gives up anything, what changes the loads on the block raises one of them.
        let is_free = self.answer.task.cancel.is_empty() && (self.gives_up || neutral == 0);
        let count = if is_free { directions } else { neutral };
        let mut step = FIRST_STEP;
        while step >= LAST_STEP && !self.is_over() {
            if aim == Aim::Limits && self.wanted.merit(aim, &best.values) >= 1.0 {
                break;
            }
            let (mut found, mut slope) = (None::<Point>, vec![0.0; count]);
            let numbers = |climb: &Climb<'_>, values: &[f64]| climb.wanted.numbers(aim, values);
            let unit = self.wanted.merit(aim, &best.values).abs().max(f64::MIN_POSITIVE);
            let here = soft_smallest(&numbers(self, &best.values), unit);
            for (direction, slope) in slope.iter_mut().enumerate() {
                let mut sides = [None, None];
                for (side, sense) in sides.iter_mut().zip([1.0, -1.0]) {
                    let Some(point) = self.at(&best, &[(direction, sense * step)])? else { continue };
                    *side = Some(soft_smallest(&numbers(self, &point.values), unit));
                    let than = found.as_ref().map_or(&best.values, |found| &found.values);
                    if self.is_better(aim, &point.values, than) {
                        found = Some(point);
                    }
                }
                *slope = match sides {
                    [Some(ahead), Some(behind)] => 0.5 * (ahead - behind),
                    [Some(ahead), None] => (ahead - here).max(0.0),
                    [None, Some(behind)] => (here - behind).min(0.0),
                    [None, None] => 0.0,
                };
            }
            let size = slope.iter().map(|own| own * own).sum::<f64>().sqrt();
            if size > 0.0 {
                for reach in [4.0, 2.0, 1.0] {
                    let along: Vec<(usize, f64)> =
                        slope.iter().map(|own| reach * step * own / size).enumerate().collect();
                    let Some(point) = self.at(&best, &along)? else { continue };
                    let than = found.as_ref().map_or(&best.values, |found| &found.values);
                    if self.is_better(aim, &point.values, than) {
                        found = Some(point);
                    }
                }
            }
            match found {
                Some(point) => best = point,
                None => step *= 0.4,
            }
        }
        self.reached.push((aim, self.wanted.merit(aim, &best.values)));
        self.best = Some(best);
        Ok(())
    }

    /// The point moved along directions, if it is allowed and can be measured.
    fn at(&mut self, from: &Point, along: &[(usize, f64)]) -> Result<Option<Point>, BalanceError> {
        if self.is_over() {
            return Ok(None);
        }
        let Some(unbalances) = self.space.moved(&from.unbalances, along) else { return Ok(None) };
        let neutral = self.space.directions()[1];
        let is_neutral = along.iter().all(|(direction, _)| *direction < neutral);
        if (self.sees_inside || !is_neutral) && !self.is_allowed(&unbalances)? {
            return Ok(None);
        }
        self.measure(unbalances)
    }

    fn measure(&mut self, unbalances: Vec<Complex64>) -> Result<Option<Point>, BalanceError> {
        match (self.request.watch)(self.evaluations) {
            Next::Continue => {}
            Next::Stop(cause) => self.ending = Some(cause),
            Next::Abandon => return Err(BalanceError::BrokenOff),
        }
        if self.evaluations >= self.request.settings.most_evaluations {
            self.ending = Some(StopCause::MaxNodes);
        }
        if self.is_over() && !self.starts.is_empty() {
            return Ok(None);
        }
        self.evaluations += 1;
        let engine = fitted(self.engine, &moved(self.answer, &unbalances));
        let measured = self.request.meter.measure(&engine, self.wanted.parts());
        let values: Option<Vec<f64>> = measured.iter().map(Measured::value).collect();
        Ok(values.map(|values| Point { unbalances, values }))
    }

    /// Whether the first is better than the second: it holds what earlier aims reached, and has more of this one.
    fn is_better(&self, aim: Aim, values: &[f64], than: &[f64]) -> bool {
        let keeps = |values: &[f64]| {
            self.wanted.before(aim).into_iter().all(|before| {
                let reached = self.reached.iter().find(|(known, _)| *known == before).map(|known| known.1);
                let reached = reached.unwrap_or(f64::NEG_INFINITY);
                // A limit that was reached is kept to the last digit.
                let room = if before == Aim::Limits && reached >= 1.0 { 0.0 } else { KEPT * reached.abs() };
                self.wanted.merit(before, values) >= reached - room
            })
        };
        match (keeps(values), keeps(than)) {
            (false, _) => false,
            (true, false) => true,
            (true, true) => {
                let (merit, other) = (self.wanted.merit(aim, values), self.wanted.merit(aim, than));
                merit > other + BETTER * other.abs()
            }
        }
    }

    /// Whether moved weights hold every stage and limit of the task.
    fn is_allowed(&self, unbalances: &[Complex64]) -> Result<bool, BalanceError> {
        let values = self.values(unbalances)?;
        let task = &self.answer.task;
        let holds =
            |value: f64, allowed: f64, scale: f64| value <= allowed + ROUNDING * scale.max(allowed.abs());
        for stage in self.stage_values(&values) {
            if !holds(stage.0.value, stage.0.allowed, stage.1) {
                return Ok(false);
            }
        }
        let natural = |criterion: Criterion| {
            let effect = self.answer.effects.iter().find(|effect| effect.criterion == criterion);
            effect.map_or(0.0, |effect| effect.without)
        };
        Ok(task.limits.iter().all(|limit| {
            let value = values.iter().find(|own| own.0 == limit.criterion).map_or(0.0, |own| own.1);
            holds(value, limit.most, natural(limit.criterion))
        }))
    }

    /// The stages of the task with moved weights.
    pub fn stages(&self, unbalances: &[Complex64]) -> Result<Vec<DurableStage>, BalanceError> {
        let values = self.values(unbalances)?;
        Ok(self.stage_values(&values).into_iter().map(|stage| stage.0).collect())
    }

    /// Every stage, with what it would be without weights.
    fn stage_values(&self, values: &[(Criterion, f64)]) -> Vec<(DurableStage, f64)> {
        let task = &self.answer.task;
        let of =
            |criterion: &Criterion| values.iter().find(|own| own.0 == *criterion).map_or(0.0, |own| own.1);
        let natural = |criterion: &Criterion| {
            let effect = self.answer.effects.iter().find(|effect| effect.criterion == *criterion);
            effect.map_or(0.0, |effect| effect.without)
        };
        let stages = self.answer.stages.iter().enumerate();
        stages
            .map(|(index, stage)| {
                let sum = |value: &dyn Fn(&Criterion) -> f64| -> f64 {
                    let terms = stage.terms.iter().zip(&stage.term_weights);
                    terms.map(|((criterion, _), weight)| weight * value(criterion)).sum()
                };
                let least = stage.give_up.map_or(stage.value, |own| own.least);
                let room = task.give_up.get(index).map_or(0.0, |own| own.amount(least));
                let found = DurableStage {
                    unit: stage.unit.clone(),
                    optimum: stage.value,
                    allowed: stage.value.max(least + room),
                    value: sum(&of),
                };
                (found, sum(&natural))
            })
            .collect()
    }

    /// What the answer tells before and after, with moved weights.
    pub fn effects(&self, unbalances: &[Complex64]) -> Result<Vec<Effect>, BalanceError> {
        let told = self.answer.effects.iter().map(|effect| effect.criterion).collect();
        let values = self.values_of(told, unbalances)?;
        let of = |effect: &Effect| values.iter().find(|own| own.0 == effect.criterion).map(|own| own.1);
        let effects = &self.answer.effects;
        Ok(effects.iter().map(|own| Effect { after: of(own).unwrap_or(own.after), ..*own }).collect())
    }

    /// Criteria of the task with moved weights.
    fn values(&self, unbalances: &[Complex64]) -> Result<Vec<(Criterion, f64)>, BalanceError> {
        self.values_of(asked(&self.answer.task), unbalances)
    }

    /// Criteria with moved weights.
    fn values_of(
        &self,
        asked: Vec<Criterion>,
        unbalances: &[Complex64],
    ) -> Result<Vec<(Criterion, f64)>, BalanceError> {
        let (task, answer) = (&self.answer.task, self.answer);
        let engine = fitted(self.engine, &moved(answer, unbalances));
        let (of_weights, of_loads): (Vec<Criterion>, Vec<Criterion>) =
            asked.into_iter().partition(|criterion| {
                matches!(criterion, Criterion::AddedMass | Criterion::AddedUnbalance | Criterion::Cost)
            });
        let mut values: Vec<(Criterion, f64)> = of_weights
            .into_iter()
            .map(|criterion| (criterion, amount(task, answer, unbalances, criterion)))
            .collect();
        if of_loads.is_empty() {
            return Ok(values);
        }
        let judged = BalanceTask {
            stages: of_loads.iter().map(|own| Stage::of(vec![(1.0, *own)])).collect(),
            speeds: task.speeds.clone(),
            speed_weights: task.speed_weights.clone(),
            ..BalanceTask::default()
        };
        let found =
            optimise_watched(&engine, &judged, self.request.gas, &BalanceSettings::default(), &|_| {
                Next::Continue
            })?;
        values.extend(found.effects.iter().map(|effect| (effect.criterion, effect.after)));
        Ok(values)
    }
}

/// All criteria of stages and limits.
fn asked(task: &BalanceTask) -> Vec<Criterion> {
    let of_stages = task.stages_or_default().into_iter().flat_map(|stage| stage.terms).map(|term| term.1);
    let mut all: Vec<Criterion> = Vec::new();
    for criterion in of_stages.chain(task.limits.iter().map(|limit| limit.criterion)) {
        if !all.contains(&criterion) {
            all.push(criterion);
        }
    }
    all
}

/// Whether a criterion sees no more of the weights on a crankshaft than their sum and its moment.
fn is_on_block(criterion: Criterion) -> bool {
    match criterion {
        Criterion::Peak(load) | Criterion::Order(load, _) => {
            !matches!(load, Load::MainLoad(_) | Load::LargestMainLoad | Load::BendingMoment)
        }
        _ => false,
    }
}

/// Mass, unbalance or cost of the free weights.
fn amount(task: &BalanceTask, answer: &Answer, unbalances: &[Complex64], criterion: Criterion) -> f64 {
    let weights = task.weights.iter().zip(unbalances);
    let used = |unbalance: &Complex64| unbalance.norm() > 0.0;
    match criterion {
        Criterion::AddedMass => {
            weights.map(|(own, unbalance)| own.radius.map_or(0.0, |radius| unbalance.norm() / radius)).sum()
        }
        Criterion::AddedUnbalance => weights.map(|(_, unbalance)| unbalance.norm()).sum(),
        _ => {
            let of_weights: f64 = weights
                .filter(|(_, unbalance)| used(unbalance))
                .map(|(own, unbalance)| own.cost.fixed + own.cost.per_amount * unbalance.norm())
                .sum();
            let shafts = answer.shafts.iter().enumerate().filter(|(_, shaft)| shaft.used);
            of_weights + shafts.map(|(index, _)| task.shaft_cost(index)).sum::<f64>()
        }
    }
}
