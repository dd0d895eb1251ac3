//! A balancing task as a convex programme.

use crate::convex::HOLDS;
use crate::convex::programme::{Group, Programme, Row};
use crate::criterion::{amounts, judge, level};
use crate::error::BalanceError;
use crate::judged::Judged;
use crate::operator::Operator;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, GiveUp, Load, Mains, Place, Seat, Stage};
use std::rc::Rc;

/// What a row of the programme stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rule {
    /// Limit of the task, by index.
    Limit(usize),
    /// Largest amount of a weight, by index.
    MostAmount(usize),
    /// Least amount of a weight, by index.
    LeastAmount(usize),
    /// Largest inertia.
    MostInertia,
    /// A variable that is not negative, or another condition without a price.
    Plain,
}

/// A task with its engine: the programme, and how to read it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Problem {
    pub operator: Operator,
    /// Rows hold, nothing is minimised.
    pub programme: Programme,
    /// What each row stands for, and what a level of 1 of its limit is in SI units.
    pub rules: Vec<(Rule, f64)>,
    /// The stages' terms.
    pub stages: Vec<Vec<(f64, Judged)>>,
    /// What each stage gives up for later ones, in the order of the stages.
    pub give_up: Vec<GiveUp>,
    /// What is minimised after them without being asked.
    pub implied: Vec<Vec<(f64, Judged)>>,
    /// The task's limits.
    pub limits: Vec<Judged>,
    /// Rows of sums whose largest counts, each with the group of what none of them passes.
    pub sums: Vec<(usize, usize)>,
    /// Weights of given amount in a given direction, with the row of the operator's equalities that says so.
    pub given: Vec<(usize, usize)>,
    /// Groups of the amounts of every weight's corners.
    pub amounts: Vec<Vec<usize>>,
    /// Radius of every weight, where all have one.
    pub radii: Option<Vec<f64>>,
    /// What the task names; with [`Problem::with_effects`] also what is told in any case.
    pub effects: Vec<Judged>,
}

/// The stages of a task: what it says, or force and then couple.
pub(crate) fn stages(task: &BalanceTask) -> Vec<Stage> {
    task.stages_or_default()
}

/// What decides among answers that the stages leave equal, before the weights do: of force and couple what the stages do
/// not name, then the roll moment if a device is free that is there for its sake: an inertia, or the axis of a shaft
/// (whoever asks for the least weights has them before the roll moment), then, where a weight on a crankshaft is free, what
/// it is there for: the loads of all main bearings, the largest of them, the bending moment.
pub(crate) fn implied(engine: &Engine, task: &BalanceTask) -> Vec<Criterion> {
    let stages = stages(task);
    let named = stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    let weighs = named
        .clone()
        .any(|c| matches!(c, Criterion::AddedMass | Criterion::AddedUnbalance | Criterion::Cost));
    let mut implied = vec![Load::Force, Load::Couple];
    if !weighs && (!task.inertias.is_empty() || has_free_axis(task)) {
        implied.push(Load::RollMoment);
    }
    let mut implied: Vec<Criterion> = implied.into_iter().map(Criterion::Peak).collect();
    if task.weights.iter().any(|w| matches!(w.seat, Seat::Crankshaft(_))) {
        implied.extend(of_crank(engine));
    }
    implied.retain(|criterion| named.clone().all(|named| named != *criterion));
    implied
}

/// What weights on a crankshaft are for: the loads of its main bearings, then its bending moment.
fn of_crank(engine: &Engine) -> Vec<Criterion> {
    let mut criteria = Vec::new();
    if !engine.main_bearings().is_empty() {
        criteria.extend([Criterion::MainRms(Mains::All), Criterion::Peak(Load::LargestMainLoad)]);
    }
    if !engine.main_planes(0).is_empty() {
        criteria.push(Criterion::Peak(Load::BendingMoment));
    }
    criteria
}

/// Whether a criterion is one of those that weights on a crankshaft are for.
pub(crate) fn is_of_crank(criterion: &Criterion) -> bool {
    matches!(criterion, Criterion::MainRms(_) | Criterion::Peak(Load::LargestMainLoad | Load::BendingMoment))
}

/// Whether the axis of a shaft is to be found.
pub(crate) fn has_free_axis(task: &BalanceTask) -> bool {
    let open = |place: Place| matches!(place, Place::Between(..));
    task.shafts.iter().any(|shaft| open(shaft.x) || open(shaft.y))
}

impl Problem {
    pub fn new(engine: &Engine, task: &BalanceTask, operator: Operator) -> Result<Problem, BalanceError> {
        let mut groups: Vec<Group> = Vec::new();
        let amounts = amounts(&operator, &mut groups);
        let mut known: Vec<Judged> = Vec::new();
        let mut find = |criterion: Criterion, groups: &mut Vec<Group>| -> Result<Judged, BalanceError> {
            if let Some(found) = known.iter().find(|j| j.criterion == criterion) {
                return Ok(found.clone());
            }
            let judged = judge(engine, task, &operator, criterion, &amounts, groups)?;
            known.push(judged.clone());
            Ok(judged)
        };
        let asked = stages(task);
        let implied = implied(engine, task)
            .into_iter()
            .map(|criterion| Ok(vec![(1.0, find(criterion, &mut groups)?)]))
            .collect::<Result<Vec<Vec<_>>, BalanceError>>()?;
        let stages = asked
            .iter()
            .map(|stage| stage.terms.iter().map(|&(w, c)| Ok((w, find(c, &mut groups)?))).collect())
            .collect::<Result<Vec<Vec<_>>, BalanceError>>()?;
        let limits = task
            .limits
            .iter()
            .map(|limit| find(limit.criterion, &mut groups))
            .collect::<Result<Vec<_>, BalanceError>>()?;
        let effects = known;
        let mut problem = Problem {
            programme: Programme {
                variables: operator.variables,
                grid: Rc::clone(&operator.grid),
                cost: vec![0.0; groups.len()],
                linear: vec![0.0; operator.variables],
                offset: 0.0,
                holds: HOLDS,
                rows: Vec::new(),
                groups,
            },
            rules: Vec::new(),
            operator,
            stages,
            give_up: task.give_up.clone(),
            implied,
            limits,
            sums: Vec::new(),
            given: Vec::new(),
            amounts,
            radii: task.weights.iter().map(|w| w.radius).collect(),
            effects,
        };
        problem.add_rows(task);
        Ok(problem)
    }

    /// The problem with the criteria that are told in any case, before those that the task names.
    pub fn with_effects(mut self, engine: &Engine, task: &BalanceTask) -> Result<Problem, BalanceError> {
        let always = [Load::Force, Load::Couple, Load::RollMoment].map(Criterion::Peak);
        let mut effects = Vec::new();
        for criterion in always.into_iter().chain(of_crank(engine)) {
            let known = self.effects.iter().position(|judged| judged.criterion == criterion);
            effects.push(match known {
                Some(place) => self.effects.remove(place),
                None => {
                    let groups = &mut self.programme.groups;
                    judge(engine, task, &self.operator, criterion, &self.amounts, groups)?
                }
            });
        }
        effects.append(&mut self.effects);
        self.effects = effects;
        self.programme.cost.resize(self.programme.groups.len(), 0.0);
        Ok(self)
    }

    fn add_rows(&mut self, task: &BalanceTask) {
        let nothing = vec![0.0; self.operator.variables];
        let mut known: Vec<usize> = Vec::new();
        let named = self.effects.iter().filter_map(|judged| {
            let largest = judged.largest.as_ref()?;
            Some((judged.groups.first()?.0, largest))
        });
        for (group, largest) in named {
            if known.contains(&largest.variable) {
                continue;
            }
            known.push(largest.variable);
            for sum in &largest.sums {
                let mut directions = nothing.clone();
                directions[largest.variable] = -1.0;
                self.sums.push((self.programme.rows.len(), group));
                self.programme.rows.push(Row { shares: sum.clone(), directions, most: 0.0 });
                self.rules.push((Rule::Plain, 1.0));
            }
        }
        for (index, (limit, judged)) in task.limits.iter().zip(&self.limits).enumerate() {
            let row = Row {
                shares: judged.groups.clone(),
                directions: nothing.clone(),
                most: limit.most / judged.scale,
            };
            self.programme.rows.push(row);
            self.rules.push((Rule::Limit(index), judged.scale));
        }
        for (index, weight) in task.weights.iter().enumerate() {
            let Some(most) = weight.most else { continue };
            let unit = self.operator.weights[index].unit;
            let row = Row {
                shares: self.amounts[index].iter().map(|&g| (g, 1.0)).collect(),
                directions: nothing.clone(),
                most: most / unit,
            };
            self.programme.rows.push(row);
            self.rules.push((Rule::MostAmount(index), unit));
        }
        for &variable in &self.operator.positive {
            let mut directions = nothing.clone();
            directions[variable] = -1.0;
            self.programme.rows.push(Row { shares: Vec::new(), directions, most: 0.0 });
            self.rules.push((Rule::Plain, 1.0));
        }
        if let Some((variable, most)) = self.operator.inertia {
            let mut directions = nothing.clone();
            directions[variable] = 1.0;
            self.programme.rows.push(Row { shares: Vec::new(), directions, most });
            self.rules.push((Rule::MostInertia, 1.0));
        }
    }

    /// How far later stages may raise a stage with this least value, in its unit.
    pub fn allowed(&self, stage: usize, least: f64) -> f64 {
        self.give_up.get(stage).map_or(0.0, |give_up| give_up.amount(least))
    }

    /// All criteria that decide: of the stages, of what is implied, and of the limits.
    pub fn judged(&self) -> impl Iterator<Item = &Judged> {
        let stages = self.stages.iter().chain(&self.implied).flatten().map(|term| &term.1);
        stages.chain(&self.limits)
    }

    /// True value of a criterion at `x`, in its own unit.
    pub fn value(&self, judged: &Judged, x: &[f64]) -> f64 {
        judged.value(|group| level(&self.programme.groups[group], &self.programme.grid, x))
    }

    /// Costs of the groups for a stage, what a cost of 1 is in the stage's unit, and the stage without the devices.
    pub fn cost(&self, terms: &[(f64, Judged)]) -> (Vec<f64>, f64, f64) {
        let scale = terms.iter().map(|(w, j)| w * j.scale).fold(0.0, f64::max);
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let mut cost = vec![0.0; self.programme.groups.len()];
        for (weight, judged) in terms {
            for &(group, share) in &judged.groups {
                cost[group] += weight * judged.scale * share / scale;
            }
        }
        (cost, scale, terms.iter().map(|(w, j)| w * j.unbalanced).sum())
    }

    /// Whether a group is a load (else the amount of a weight).
    pub fn is_load(&self, group: usize) -> bool {
        !self.amounts.iter().flatten().any(|&amount| amount == group)
    }
}
