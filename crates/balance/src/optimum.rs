//! The best that exists for an engine with given free devices, with its proof.

use crate::answer::*;
use crate::branch::{self, Ending, Searched};
use crate::cancellation::cancel;
use crate::check::check;
use crate::convex::Failure;
use crate::convex::dense::norm;
use crate::cost::of_taken_over;
use crate::criterion::Judged;
use crate::error::BalanceError;
use crate::fitted::{bare, taken_over};
use crate::infeasible::obstacle;
use crate::limits::found_limits;
use crate::operator::{EngineLoads, Operator, WeightColumns, inertia_of, middle};
use crate::over_speed::gas::GasOverSpeed;
use crate::over_speed::gas_range::indices;
use crate::over_speed::places::SpeedPlaces;
use crate::over_speed::range::over_the_range;
use crate::problem::Problem;
use crate::settings::{BalanceSettings, Next, SearchState, StopCause, Watch};
use crate::stages::{Reached, StageProof, run};
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Place, Seat, Statistic, criterion_name, criterion_unit};
use std::rc::Rc;

/// Share of what a stage is without the devices below which it vanishes.
const VANISHES: f64 = 1e-9;

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
        return cancel(engine, task, kinematics);
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

fn empty(engine: &Engine, task: &BalanceTask) -> Answer {
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
struct Stand {
    /// Plane of every weight [m].
    planes: Vec<f64>,
    /// Axis of every shaft [m].
    axes: Vec<[f64; 2]>,
    /// The inertia that is used, by index.
    inertia: Option<usize>,
}

impl Stand {
    /// Of a task whose places are given.
    fn given(task: &BalanceTask, places: &[Vec<(num_complex::Complex64, f64)>]) -> Stand {
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

/// Share of its natural amount below which a weight is what the solver leaves open, if nothing is lost without it.
const LEFTOVER: f64 = 1e-9;

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

fn fill(
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
fn effects(
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
