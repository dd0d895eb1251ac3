//! Exact cancellation: weights that make chosen orders vanish, or the proof that none can (book, "Exact cancellation",
//! eqs. (20.1) to (20.5)). Of all that do it, those that come first by the stages of a task that says nothing: force, couple,
//! loads of the main bearings, bending moment; then the lightest. How light any can be is proved in any case.

pub(crate) mod answer;
mod equations;
mod functional;
mod lightest;
mod obstruction;
mod total;
mod words;

pub use answer::{
    Cancellation, CancellationVerdict, CancelledOrder, Functional, FunctionalTerm, Obstruction, OrderSense,
};

use crate::answer::{Answer, FoundStage, Method, Outcome};
use crate::check::check;
use crate::error::BalanceError;
use crate::fitted::{bare, fitted};
use crate::limits::found_limits;
use crate::operator::{Operator, middle};
use crate::optimum::found::{found_stage, with_devices};
use crate::problem::Problem;
use crate::settings::StopCause;
use crate::stages::{Reached, StageProof, Walk};
use equations::Equations;
use functional::Weighed;
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Place, Stage, criterion_unit};
use lightest::{Lightest, lightest};
use obstruction::obstructions;
use total::Total;

/// What has vanished, as a share of the loads of all moving masses.
const VANISHED: f64 = 1e-10;

/// What finds the optimum of a task in which nothing is to vanish.
pub(crate) type Optimise<'a> = &'a dyn Fn(&BalanceTask) -> Result<Answer, BalanceError>;

/// The weights that make the orders of `task.cancel` vanish and come first by the default stages, then the lightest; where none can, the proof, and the weights that
/// leave the least by `optimise`.
pub(crate) fn cancel(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    optimise: Optimise<'_>,
) -> Result<Answer, BalanceError> {
    check(engine, task)?;
    suits(task)?;
    let operator = Operator::new(&bare(engine, task), task, kinematics, &middle(engine, task))?;
    let equations = Equations::new(engine, task, &operator)?;
    let total = Total::new(task, &equations);
    let mut solves = 0;
    match lightest(&equations, &total.costs, &operator.grid, &mut solves) {
        Ok(found) => {
            let question = Question { engine, task, kinematics, operator, equations };
            question.vanishing(&total, &found, solves)
        }
        Err(_) => {
            let proofs = obstructions(&equations, &operator.grid, &mut solves);
            Question { engine, task, kinematics, operator, equations }.remaining(&proofs, optimise)
        }
    }
}

/// Exact cancellation is convex with places given and amounts free from 0 on; and it wants one thing only.
fn suits(task: &BalanceTask) -> Result<(), BalanceError> {
    let unsuited = |needed: &'static str, got: String, hint: &'static str| {
        Err(BalanceError::Unsuited { method: "exact cancellation", needed, got, hint })
    };
    let to_be_found = |place: Place| matches!(place, Place::Between(..));
    if let Some(shaft) = task.shafts.iter().find(|s| to_be_found(s.x) || to_be_found(s.y)) {
        return unsuited(
            "shafts with a given axis",
            format!("`{}` with an axis to be found", shaft.name),
            "give x and y one place each",
        );
    }
    if let Some(weight) = task.weights.iter().find(|w| to_be_found(w.z)) {
        return unsuited(
            "weights in given planes",
            format!("`{}` with a plane to be found", weight.name),
            "give z one place",
        );
    }
    if let Some(weight) = task.weights.iter().find(|w| w.least > 0.0) {
        return unsuited(
            "weights of any amount from 0 on",
            format!("`{}` with a least amount", weight.name),
            "leave out `least`, or `unbalance` where it gives the amount",
        );
    }
    if let Some(weight) = task.weights.iter().find(|w| w.catalogue.is_some()) {
        return unsuited(
            "weights of any amount from 0 on",
            format!("`{}` with a catalogue", weight.name),
            "leave out `step` or `catalogue`: steps cancel nothing exactly",
        );
    }
    if task.inertias.len() > 1 {
        return unsuited(
            "one counter-rotating inertia at most",
            format!("{} to choose from", task.inertias.len()),
            "ask for one after the other",
        );
    }
    if task.most_optional.is_some() {
        return unsuited(
            "devices that may all be used",
            "a largest number of optional devices".into(),
            "leave out `most_optional`, or ask with fewer devices",
        );
    }
    if !task.stages.is_empty() || !task.limits.is_empty() || !task.give_up.is_empty() {
        return unsuited(
            "orders to cancel alone",
            "criteria to minimise or limits beside them".into(),
            "ask for one after the other",
        );
    }
    Ok(())
}

/// A task with its engine and its equations.
struct Question<'a> {
    engine: &'a Engine,
    task: &'a BalanceTask,
    kinematics: Kinematics,
    operator: Operator,
    equations: Equations,
}

impl Question<'_> {
    /// The answer where the orders vanish.
    fn vanishing(self, total: &Total, found: &Lightest, solves: usize) -> Result<Answer, BalanceError> {
        let Question { engine, task, kinematics, operator, equations } = self;
        let mut solves = solves;
        let judged = judged(task, Vec::new());
        let mut problem = Problem::new(engine, &judged, operator)?;
        let reached = by_stages(&mut problem, &equations, equations.unscaled(&found.u), &mut solves);
        let x = &reached.x;
        let mut stages = vec![Stage { terms: vec![(1.0, total.criterion)] }];
        stages.extend(stages_of(task));
        let named = BalanceTask { stages, ..judged };
        let of_named = Problem::new(engine, &named, problem.operator.clone())?;
        let mut answer = with_devices(engine, &named, kinematics, &of_named, x)?;
        answer.task = task.clone();
        answer.method = Method::Convex { solves };
        let lightest_decides = reached.among_equals.is_empty();
        if lightest_decides {
            answer.stages = vec![total.stage(found)];
            answer.limits = total.limits(task, &equations, found);
        } else {
            answer.among_equals = reached
                .among_equals
                .iter()
                .map(|(place, proof)| found_stage(&problem, &problem.implied[*place], proof, x))
                .collect();
            let inertia = (!task.inertias.is_empty()).then_some(0);
            answer.limits = found_limits(engine, &problem, task, &reached, &answer, inertia);
            answer.outcome = outcome(&answer.among_equals, &reached.among_equals);
        }
        let orders = orders(engine, task, kinematics, &answer)?;
        let natural = |order: &CancelledOrder| match criterion_unit(&order.criterion) {
            "N" => problem.operator.natural_force,
            _ => problem.operator.natural_moment,
        };
        if let Some(order) = orders.iter().find(|order| order.left > VANISHED * natural(order)) {
            let reason = words::not_vanished(engine, order);
            answer.outcome = Outcome::Stopped { reason, cause: StopCause::Rounding };
        }
        let verdict = CancellationVerdict::Vanish {
            total: if lightest_decides { total.unit * found.value } else { total.of(&equations, x) },
            least: total.unit * found.value,
            is_mass: total.criterion == Criterion::AddedMass,
            lightest: found.proof.functional(&equations, task, total.unit),
        };
        answer.cancellation = Some(Cancellation { orders, verdict });
        Ok(answer)
    }

    /// The answer where they cannot vanish: what leaves the least of the first, then of the second, and so on.
    fn remaining(self, proofs: &[Weighed], optimise: Optimise<'_>) -> Result<Answer, BalanceError> {
        let Question { engine, task, kinematics, equations, .. } = &self;
        let mut answer = optimise(&judged(task, stages_of(task)))?;
        answer.task = (*task).clone();
        let mut orders = orders(engine, task, *kinematics, &answer)?;
        for (order, stage) in orders.iter_mut().zip(stages_of(task)) {
            let alone = optimise(&judged(task, vec![stage]))?;
            order.least_alone = alone.stages.first().map_or(order.left, |stage| stage.value);
        }
        let obstructions: Vec<Obstruction> = proofs
            .iter()
            .map(|proof| Obstruction {
                reason: words::reason(engine, task, equations, proof),
                functional: proof.functional(equations, task, 1.0),
            })
            .collect();
        answer.outcome = if obstructions.is_empty() {
            let reason = "too close between vanishing and not for a proof of either".into();
            Outcome::Stopped { reason, cause: StopCause::Rounding }
        } else {
            let mut reasons: Vec<&str> = obstructions.iter().map(|o| o.reason.as_str()).collect();
            reasons.dedup();
            Outcome::CannotVanish { reason: reasons.join("; ") }
        };
        let verdict = CancellationVerdict::CannotVanish { obstructions };
        answer.cancellation = Some(Cancellation { orders, verdict });
        Ok(answer)
    }
}

/// Among the points that satisfy the equations those that come first by the stages of a task that says nothing, then the
/// lightest; `lightest` itself where these stages leave nothing open.
fn by_stages(
    problem: &mut Problem,
    equations: &Equations,
    lightest: Vec<f64>,
    solves: &mut usize,
) -> Reached {
    for row in 0..equations.matrix.rows {
        let mut line: Vec<f64> = equations
            .matrix
            .row(row)
            .iter()
            .zip(&equations.stretch)
            .map(|(value, stretch)| value / stretch)
            .collect();
        let largest = line.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        if largest > 0.0 {
            line.iter_mut().for_each(|value| *value /= largest);
            problem.operator.equalities.push(&line);
            problem.operator.equal_to.push(equations.right[row] / largest);
        }
    }
    let stages = std::mem::take(&mut problem.stages);
    let implied = std::mem::take(&mut problem.implied);
    problem.implied = stages.into_iter().chain(implied).collect();
    let mut walk = Walk::new(problem);
    walk.x.clone_from(&lightest);
    let reached = walk.settle(solves);
    if reached.among_equals.is_empty() { Reached { x: lightest, ..reached } } else { reached }
}

/// Optimal where every gap of what decided is closed.
fn outcome(stages: &[FoundStage], proofs: &[(usize, StageProof)]) -> Outcome {
    let open = stages.iter().zip(proofs).find(|(stage, (_, proof))| stage.gap > proof.target);
    open.map_or(Outcome::Optimal, |(stage, _)| Outcome::Stopped {
        reason: format!("rounding leaves a gap of {:.1e} {} open", stage.gap, stage.unit),
        cause: StopCause::Rounding,
    })
}

/// The orders as stages, one after the other.
fn stages_of(task: &BalanceTask) -> Vec<Stage> {
    let stage = |&(load, order): &_| Stage { terms: vec![(1.0, Criterion::Order(load, order))] };
    task.cancel.iter().map(stage).collect()
}

/// The devices of a task with something to minimise.
fn judged(task: &BalanceTask, stages: Vec<Stage>) -> BalanceTask {
    BalanceTask { cancel: Vec::new(), stages, ..task.clone() }
}

/// What is left of every order, from the loads of the engine with the answer fitted.
fn orders(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    answer: &Answer,
) -> Result<Vec<CancelledOrder>, BalanceError> {
    let mut fitted = fitted(engine, answer);
    if answer.weights.is_empty() {
        fitted = bare(engine, task);
    }
    // An inertia stands in no engine file: it acts beside it.
    let beside =
        BalanceTask { inertias: task.inertias.clone(), stages: stages_of(task), ..BalanceTask::default() };
    let operator = Operator::new(&fitted, &beside, kinematics, &[])?;
    let problem = Problem::new(&fitted, &beside, operator)?;
    let share: Vec<f64> = answer.inertias.iter().take(1).map(|i| 1.0 - i.roll_share).collect();
    let orders = problem.stages.iter().flatten().map(|(_, judged)| {
        let before = answer.effects.iter().find(|e| e.criterion == judged.criterion);
        CancelledOrder {
            criterion: judged.criterion,
            without: before.map_or(0.0, |e| e.without),
            left: problem.value(judged, &share),
            least_alone: 0.0,
        }
    });
    Ok(orders.collect())
}
