//! The best that exists for an engine with given free devices, with its proof.

pub(crate) mod found;

use crate::answer::*;
use crate::branch::{self, Ending, Searched};
use crate::cancellation::cancel;
use crate::check::check;
use crate::convex::Failure;
use crate::error::BalanceError;
use crate::fitted::bare;
use crate::infeasible::obstacle;
use crate::judged::Judged;
use crate::operator::{EngineLoads, Operator, WeightColumns, middle};
use crate::over_speed::gas::GasOverSpeed;
use crate::over_speed::places::SpeedPlaces;
use crate::over_speed::range::over_the_range;
use crate::problem::Problem;
use crate::settings::{BalanceSettings, Next, SearchState, StopCause, Watch};
use crate::stages::{Reached, StageProof, run};
use found::{LEFTOVER, Stand, effects, empty, fill};
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, criterion_name, criterion_unit};
use std::rc::Rc;

/// Finds the best unbalances for `task`, from the exact motion of the engine.
///
/// All loads grow with the square of the speed, so the highest speed of the engine decides. What the task takes over
/// (counterweights and shafts with the names of its weights and shafts) is left out of the engine first.
///
/// # Errors
/// [`BalanceError`] where the task has no meaning for this engine. Limits that nobody can reach are an
/// [`Outcome::Infeasible`], orders that cannot vanish an [`Outcome::CannotVanish`].
///
/// # Source
/// Book, "The optimum and its proof", eqs. (12.1) to (12.9).
pub fn optimise(engine: &Engine, task: &BalanceTask) -> Result<Answer, BalanceError> {
    optimise_with(engine, task, Kinematics::Exact)
}

/// As [`optimise`], with the motion of the pistons that published cases were computed with.
///
/// # Errors
/// As [`optimise`].
pub fn optimise_with(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
) -> Result<Answer, BalanceError> {
    found(engine, task, kinematics, None, &BalanceSettings::default(), &|_| Next::Continue)
}

/// As [`optimise`], with settings, for a caller who watches: a search over choices tells `watch` where it stands before each of its
/// nodes, and does what it says. `gas`: the pressures, which loads with gas need. Stopped, it answers with the best so far and the bound that is proved by then
/// ([`Outcome::Stopped`]). Convex programmes take milliseconds and are always finished.
///
/// # Errors
/// As [`optimise`], [`BalanceError::Setting`], and [`BalanceError::BrokenOff`] where `watch` abandons the search.
pub fn optimise_watched(
    engine: &Engine,
    task: &BalanceTask,
    gas: Option<&dyn GasOverSpeed>,
    settings: &BalanceSettings,
    watch: &dyn Fn(&SearchState<'_>) -> Next,
) -> Result<Answer, BalanceError> {
    settings.check()?;
    found(engine, task, Kinematics::Exact, gas, settings, watch)
}

fn found(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    gas: Option<&dyn GasOverSpeed>,
    settings: &BalanceSettings,
    watch: &Watch,
) -> Result<Answer, BalanceError> {
    if !task.cancel.is_empty() {
        return cancel(engine, task, kinematics, &|task| optimise_with(engine, task, kinematics));
    }
    check(engine, task)?;
    let mut answer = over_the_range(engine, task, kinematics, gas, &|task, places| {
        if branch::is_needed(task) {
            return searched(engine, task, kinematics, places, settings, watch);
        }
        convex(engine, task, kinematics, places)
    })?;
    if answer.outcome == Outcome::Optimal && answer.stages.iter().any(|stage| stage.give_up.is_some()) {
        let strict = BalanceTask { give_up: Vec::new(), ..task.clone() };
        compare_gains(&mut answer, &found(engine, &strict, kinematics, gas, settings, watch)?);
    }
    Ok(answer)
}

/// Notes what the stages behind one that gives up something reach without that: in `strict` nobody gives up anything.
fn compare_gains(answer: &mut Answer, strict: &Answer) {
    let first = answer.stages.iter().position(|stage| stage.give_up.is_some()).unwrap_or(0);
    for (stage, strict) in answer.stages.iter_mut().zip(&strict.stages).skip(first + 1) {
        stage.without_give_up = Some(strict.value);
    }
    for stage in &mut answer.among_equals {
        let Some((criterion, _)) = stage.terms.first() else { continue };
        // What nobody can move without the give-up stands among the effects alone.
        let effect = strict.effects.iter().find(|effect| effect.criterion == *criterion);
        stage.without_give_up = effect.map(|effect| effect.after);
    }
}

/// The answer of one convex programme.
fn convex(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    judged: &Rc<SpeedPlaces>,
) -> Result<Answer, BalanceError> {
    let places = middle(engine, task);
    let bare = bare(engine, task);
    let loads = EngineLoads::of(&bare, kinematics)?.judged_at(judged);
    let operator = Operator::with(&loads, &bare, task, &places, &[])?;
    let problem = Problem::new(engine, task, operator)?;
    let mut solves = 0;
    let mut answer = empty(engine, task);
    match run(&problem, &mut solves) {
        Ok(reached) => {
            let reached = cleared(&problem, reached);
            let stand = Stand::given(task, &places);
            fill(&mut answer, engine, task, &problem, &reached, &stand);
            answer.outcome = outcome(&answer.stages, &reached.stages, None);
            answer.effects = effects(engine, task, kinematics, &problem, &reached.x)?;
        }
        Err(failure) => answer.outcome = refused(engine, &problem, task, failure, &mut solves),
    }
    answer.method = Method::Convex { solves };
    Ok(answer)
}

/// The answer of a search over choices.
fn searched(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    places: &Rc<SpeedPlaces>,
    settings: &BalanceSettings,
    watch: &Watch,
) -> Result<Answer, BalanceError> {
    let Searched { ending, nodes, solves } =
        branch::search(engine, task, kinematics, places, settings, watch)?;
    let mut answer = Answer { settings: *settings, ..empty(engine, task) };
    let chosen = branch::is_choice(task);
    answer.method = if chosen { Method::BranchAndBound { nodes, solves } } else { Method::Convex { solves } };
    match ending {
        Ending::Chosen(best) => {
            let reached = cleared(&best.problem, best.reached);
            let stand = Stand { planes: best.planes, axes: best.axes, inertia: best.inertia };
            fill(&mut answer, engine, task, &best.problem, &reached, &stand);
            answer.outcome = outcome(&answer.stages, &reached.stages, best.stopped.map(|stop| (stop, nodes)));
            answer.effects = effects(engine, task, kinematics, &best.problem, &reached.x)?;
        }
        Ending::Infeasible { relaxation, closest } => {
            let reason = if task.limits.is_empty() {
                "least amounts, ties and the number of optional devices contradict one another".to_string()
            } else {
                infeasible_words(engine, task, relaxation, &closest)
            };
            answer.outcome = Outcome::Infeasible { relaxation, closest, reason };
        }
        Ending::Nothing(cause) => {
            let reason = format!("{} before any feasible point was found", cause_words(cause, nodes));
            answer.outcome = Outcome::Stopped { reason, cause };
        }
    }
    Ok(answer)
}

/// The weights that are no more than leftovers set to nothing, where every gap that is closed and every rule that is
/// held stays so: all of them, as they may hold each other, or one by one.
fn cleared(problem: &Problem, mut reached: Reached) -> Reached {
    let leftovers: Vec<&WeightColumns> = problem
        .operator
        .weights
        .iter()
        .filter(|columns| {
            let amount: f64 = columns.corners.iter().map(|corner| corner.unbalance(&reached.x).norm()).sum();
            amount > 0.0 && amount <= LEFTOVER * columns.unit
        })
        .collect();
    let mut clear = |weights: &[&WeightColumns]| {
        let mut without = reached.x.clone();
        for (variable, _) in weights.iter().flat_map(|w| &w.corners).flat_map(|corner| &corner.terms) {
            without[*variable] = 0.0;
        }
        let holds = stays_proved(problem, &reached, &without);
        if holds {
            reached.x = without;
        }
        holds
    };
    if !leftovers.is_empty() && !clear(&leftovers) {
        for weight in &leftovers {
            clear(&[weight]);
        }
    }
    reached
}

/// Whether `x` is as good as what was reached: gaps within what counts as closed, or no wider; rules and ties no worse.
fn stays_proved(problem: &Problem, reached: &Reached, x: &[f64]) -> bool {
    let implied = reached.among_equals.iter().map(|(place, proof)| (&problem.implied[*place], proof));
    let mut stages = problem.stages.iter().zip(&reached.stages).chain(implied);
    let is_closed = |(terms, proof): (&Vec<(f64, Judged)>, &StageProof)| {
        let value = |x: &[f64]| -> f64 { terms.iter().map(|(w, judged)| w * problem.value(judged, x)).sum() };
        value(x) - proof.bound <= proof.target || value(x) <= value(&reached.x)
    };
    let passed = |x: &[f64]| problem.programme.violation(x, &problem.programme.levels(x));
    let missed = |x: &[f64]| {
        let rows = problem.operator.equalities.times(x);
        rows.iter().zip(&problem.operator.equal_to).map(|(row, to)| (row - to).abs()).fold(0.0, f64::max)
    };
    stages.all(is_closed)
        && passed(x) <= passed(&reached.x).max(0.0)
        && missed(x) <= missed(&reached.x).max(LEFTOVER)
}

/// What ended a search after so many nodes.
fn cause_words(cause: StopCause, nodes: usize) -> String {
    let count = format!("after {nodes} node{}", if nodes == 1 { "" } else { "s" });
    match cause {
        StopCause::MaxNodes => format!("the largest number of nodes was reached {count}"),
        StopCause::TimeLimit => format!("the time limit was reached {count}"),
        StopCause::Cancelled => format!("cancelled {count}"),
        StopCause::Rounding => format!("rounding ended the search {count}"),
    }
}

/// Optimal where every gap is closed; `ended` is the first stage whose search ended before that, why, and after how many nodes of
/// all stages.
fn outcome(
    stages: &[FoundStage],
    proofs: &[StageProof],
    ended: Option<((usize, StopCause), usize)>,
) -> Outcome {
    let open = stages.iter().zip(proofs).enumerate().find(|(_, (stage, proof))| stage.gap > proof.target);
    match open {
        None => Outcome::Optimal,
        Some((index, (stage, _))) => {
            let share = stage.gap / stage.value.max(f64::MIN_POSITIVE);
            let number = index + 1;
            let left = format!("a gap of {share:.1e} of the value of stage {number} is left");
            let (reason, cause) = match ended {
                Some(((stage, cause), nodes)) if stage <= index => {
                    (format!("{} in stage {}; {left}", cause_words(cause, nodes), stage + 1), cause)
                }
                _ => (format!("rounding: {left}"), StopCause::Rounding),
            };
            Outcome::Stopped { reason, cause }
        }
    }
}

/// What stands in the way of the limits.
fn refused(
    engine: &Engine,
    problem: &Problem,
    task: &BalanceTask,
    failure: Failure,
    solves: &mut usize,
) -> Outcome {
    if task.limits.is_empty() || failure == Failure::NoPoint && problem.programme.rows.is_empty() {
        let reason = "the cone programme could not be solved".to_string();
        return Outcome::Stopped { reason, cause: StopCause::Rounding };
    }
    let obstacle = obstacle(problem, solves);
    if obstacle.relaxation <= 1.0 + 1e-9 {
        return Outcome::Stopped {
            reason: "the limits can only just be held together, too closely for a proof".to_string(),
            cause: StopCause::Rounding,
        };
    }
    let reason = infeasible_words(engine, task, obstacle.relaxation, &obstacle.closest);
    Outcome::Infeasible { relaxation: obstacle.relaxation, closest: obstacle.closest, reason }
}

/// How close each limit can be reached alone, and how far all must be relaxed together.
fn infeasible_words(engine: &Engine, task: &BalanceTask, relaxation: f64, closest: &[f64]) -> String {
    if closest.is_empty() {
        return "the limits cannot hold together; the search stopped before it was known how far they must be relaxed"
            .into();
    }
    let mut parts = Vec::new();
    for (limit, closest) in task.limits.iter().zip(closest) {
        let (name, unit) = (criterion_name(&limit.criterion, engine), criterion_unit(&limit.criterion));
        let verdict =
            if *closest > limit.most { "cannot be reached even alone" } else { "can be reached alone" };
        parts
            .push(format!("{name} at most {:.6} {unit} {verdict} (closest {closest:.6} {unit})", limit.most));
    }
    let mut reason = parts.join("; ");
    if relaxation.is_finite() {
        reason += &format!("; all limits must be relaxed by a factor of {relaxation:.6} together");
    }
    reason
}
