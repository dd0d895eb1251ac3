//! What an optimum is made of: stages, weights, shafts, inertias, and what they change.

use crate::answer::*;
use crate::convex::dense::norm;
use crate::cost::of_taken_over;
use crate::error::BalanceError;
use crate::fitted::taken_over;
use crate::judged::Judged;
use crate::limits::found_limits;
use crate::operator::{Operator, inertia_of, middle};
use crate::over_speed::criteria::indices;
use crate::problem::Problem;
use crate::settings::BalanceSettings;
use crate::stages::{Reached, StageProof};
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Place, Seat, Statistic, criterion_unit};

/// Share of what a stage is without the devices below which it vanishes.
const VANISHES: f64 = 1e-9;

/// Share of its natural amount below which a weight is what the solver leaves open, if nothing is lost without it.
pub(super) const LEFTOVER: f64 = 1e-9;

/// The answer of a task whose places are given, with its devices as `x` says: all but outcome, stages and limits.
pub(crate) fn with_devices(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    problem: &Problem,
    x: &[f64],
) -> Result<Answer, BalanceError> {
    let stand = Stand::given(task, &middle(engine, task));
    let mut answer = empty(engine, task);
    answer.weights = found_weights(problem, task, x, &stand.planes);
    answer.shafts = found_shafts(task, &answer.weights, &stand.axes);
    answer.inertias = found_inertias(problem, task, x, stand.inertia);
    answer.effects = effects(engine, task, kinematics, problem, x)?;
    Ok(answer)
}

/// Where the devices of an answer stand.
pub(super) struct Stand {
    /// Plane of every weight [m].
    pub planes: Vec<f64>,
    /// Axis of every shaft [m].
    pub axes: Vec<[f64; 2]>,
    /// The inertia that is used, by index.
    pub inertia: Option<usize>,
}

impl Stand {
    /// Of a task whose places are given.
    pub fn given(task: &BalanceTask, places: &[Vec<(num_complex::Complex64, f64)>]) -> Stand {
        let value = |place: Place| match place {
            Place::At(value) => value,
            Place::Between(low, high) => 0.5 * (low + high),
        };
        Stand {
            planes: places.iter().map(|corners| corners[0].1).collect(),
            axes: task.shafts.iter().map(|s| [value(s.x), value(s.y)]).collect(),
            inertia: (!task.inertias.is_empty()).then_some(0),
        }
    }
}

pub(super) fn empty(engine: &Engine, task: &BalanceTask) -> Answer {
    Answer {
        web_bounds: Vec::new(),
        version: ANSWER_VERSION,
        engine: engine.name.clone(),
        speed: engine.speed.highest,
        mount_speeds: None,
        mount_gas_speeds: None,
        gas_speeds: None,
        task: task.clone(),
        outcome: Outcome::Optimal,
        method: Method::Convex { solves: 0 },
        settings: BalanceSettings::default(),
        weights: Vec::new(),
        shafts: Vec::new(),
        inertias: Vec::new(),
        stages: Vec::new(),
        among_equals: Vec::new(),
        limits: Vec::new(),
        effects: Vec::new(),
        cancellation: None,
    }
}

pub(crate) fn found_stage(
    problem: &Problem,
    terms: &[(f64, Judged)],
    proof: &StageProof,
    x: &[f64],
) -> FoundStage {
    let values: Vec<(Criterion, f64)> =
        terms.iter().map(|(_, judged)| (judged.criterion, problem.value(judged, x))).collect();
    let value: f64 = terms.iter().zip(&values).map(|((weight, _), (_, value))| weight * value).sum();
    let unbalanced: f64 = terms.iter().map(|(weight, judged)| weight * judged.unbalanced).sum();
    // Nothing holds up what is not there.
    let vanishes = value <= proof.target.max(VANISHES * unbalanced);
    // Both are exact to rounding; the bound may end above the value by that much.
    let lower_bound = proof.bound.min(value);
    let term_weights: Vec<f64> = terms.iter().map(|(weight, _)| *weight).collect();
    let unit = match (&term_weights[..], &values[..]) {
        ([1.0], [(criterion, _)]) => criterion_unit(criterion),
        _ => "1",
    };
    let used = if proof.allowed > 0.0 { (value - proof.least).max(0.0) } else { 0.0 };
    let give_up = (proof.allowed > 0.0).then_some(StageGiveUp {
        least: proof.least,
        most: proof.least + proof.allowed,
        used,
    });
    FoundStage {
        value,
        lower_bound,
        gap: value - used - lower_bound,
        give_up,
        without_give_up: None,
        unit: unit.into(),
        terms: values,
        term_weights,
        active: if vanishes { Vec::new() } else { active(problem, terms, proof) },
    }
}

/// An angle with less than this share of a criterion's multipliers holds nothing up: an interior-point method leaves such
/// shares at every angle that it was given.
const HELD_UP: f64 = 1e-9;

/// Angles that hold a stage up.
fn active(problem: &Problem, terms: &[(f64, Judged)], proof: &StageProof) -> Vec<Active> {
    let revolutions = f64::from(problem.programme.grid.revolutions);
    let mut active = Vec::new();
    for one in &proof.solution.support {
        let mut named = terms.iter().map(|t| &t.1).chain(&problem.limits);
        let Some(judged) = named.find(|j| j.groups.iter().any(|g| g.0 == one.group)) else { continue };
        let (theta, speed) = match judged.criterion {
            Criterion::Peak(_) | Criterion::Order(..) => (one.angle * revolutions, None),
            Criterion::MainsWithGas(Statistic::Peak, mains) => {
                let operator = &problem.operator;
                let own = indices(mains, operator.mains.len());
                let mut places = operator.places.peaks.iter().filter(|peak| own.contains(&peak.main));
                let Some(peak) = places.nth(one.member) else { continue };
                (peak.theta, Some(peak.speed))
            }
            // What is a sum over weights or over the cycle stands at no angle.
            _ => continue,
        };
        let multiplier = norm(&one.y) * proof.scale / judged.scale;
        if multiplier > 0.0 {
            active.push(Active { criterion: judged.criterion, theta, speed, multiplier });
        }
    }
    active.sort_by(|a, b| a.theta.total_cmp(&b.theta));
    let sum = |criterion: Criterion| -> f64 {
        active.iter().filter(|one| one.criterion == criterion).map(|one| one.multiplier).sum()
    };
    active.iter().filter(|one| one.multiplier > HELD_UP * sum(one.criterion)).copied().collect()
}

fn found_weights(problem: &Problem, task: &BalanceTask, x: &[f64], planes: &[f64]) -> Vec<FoundWeight> {
    let mut found = Vec::new();
    for (index, weight) in task.weights.iter().enumerate() {
        let columns = &problem.operator.weights[index];
        let mut unbalance = problem.operator.unbalance(index, x);
        // Rounding is no weight.
        if unbalance.norm() <= 1e-12 * columns.unit {
            unbalance = num_complex::Complex64::ZERO;
        }
        // Rounding is no other amount of a catalogue.
        if let Some(catalogue) = weight.catalogue.as_ref().filter(|_| unbalance.norm() > 0.0) {
            let amount = catalogue.amount(catalogue.nearest(unbalance.norm()));
            if (amount - unbalance.norm()).abs() <= LEFTOVER * columns.unit {
                unbalance *= amount / unbalance.norm();
            }
        }
        found.push(FoundWeight {
            name: weight.name.clone(),
            unbalance,
            z: planes[index],
            mass: weight.radius.map(|radius| unbalance.norm() / radius),
            hole: weight.drill.as_ref().and_then(|drill| drill.hole(unbalance.norm())),
            used: unbalance.norm() > 0.0,
        });
    }
    found
}

fn found_shafts(task: &BalanceTask, weights: &[FoundWeight], axes: &[[f64; 2]]) -> Vec<FoundShaft> {
    let mut found = Vec::new();
    for (index, (shaft, [x, y])) in task.shafts.iter().zip(axes).enumerate() {
        let mut own = task.weights.iter().zip(weights).filter(|(w, _)| w.seat == Seat::Shaft(index));
        let used = own.any(|(_, weight)| weight.used);
        found.push(FoundShaft { name: shaft.name.clone(), x: *x, y: *y, used });
    }
    found
}

fn found_inertias(
    problem: &Problem,
    task: &BalanceTask,
    x: &[f64],
    used: Option<usize>,
) -> Vec<FoundInertia> {
    let mut found = Vec::new();
    for (index, inertia) in task.inertias.iter().enumerate() {
        let share = match problem.operator.inertia {
            Some((variable, _)) if used == Some(index) => x[variable].max(0.0),
            _ => 0.0,
        };
        found.push(FoundInertia {
            name: inertia.name.clone(),
            inertia: inertia_of(inertia, share),
            roll_share: 1.0 - share,
        });
    }
    found
}

/// Criteria without the free devices, as the file stands, and with the answer.
pub(super) fn effects(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    problem: &Problem,
    x: &[f64],
) -> Result<Vec<Effect>, BalanceError> {
    let nothing = BalanceTask {
        stages: crate::problem::stages(task),
        limits: task.limits.clone(),
        ..Default::default()
    };
    let operator = Operator::new(engine, &nothing, kinematics, &[])?;
    let standing = Problem::new(engine, &nothing, operator)?.with_effects(engine, &nothing)?;
    let problem = problem.clone().with_effects(engine, task)?;
    let mut effects = Vec::new();
    for judged in &problem.effects {
        let before = match judged.criterion {
            Criterion::Cost => of_taken_over(engine, task),
            Criterion::AddedMass | Criterion::AddedUnbalance => taken_over(engine, task, judged.criterion),
            _ => standing
                .effects
                .iter()
                .find(|e| e.criterion == judged.criterion)
                .map_or(0.0, |e| e.unbalanced),
        };
        effects.push(Effect {
            criterion: judged.criterion,
            without: judged.unbalanced,
            before,
            after: problem.value(judged, x),
        });
    }
    Ok(effects)
}

pub(super) fn fill(
    answer: &mut Answer,
    engine: &Engine,
    task: &BalanceTask,
    problem: &Problem,
    reached: &Reached,
    stand: &Stand,
) {
    let asked = problem.stages.iter().zip(&reached.stages);
    answer.stages = asked.map(|(terms, proof)| found_stage(problem, terms, proof, &reached.x)).collect();
    let implied = reached.among_equals.iter();
    answer.among_equals = implied
        .map(|(place, proof)| found_stage(problem, &problem.implied[*place], proof, &reached.x))
        .collect();
    answer.weights = found_weights(problem, task, &reached.x, &stand.planes);
    answer.shafts = found_shafts(task, &answer.weights, &stand.axes);
    answer.inertias = found_inertias(problem, task, &reached.x, stand.inertia);
    answer.limits = found_limits(engine, problem, task, reached, answer, stand.inertia);
}
