//! Weights for the life of crankshaft and bearings: after the proved optimum, a local search moves weights on the crankshafts so that oil films and
//! safeties become larger, without raising a stage beyond what it gives up.
//!
//! Films and safeties are not convex in the weights, so what is found is the best of what was tried: no global optimum is claimed. The loads on the
//! block are linear in the unbalances, so most moves need not ask for them at all:
//!
//! ```text
//! U = U_0 + B y        neutral y:  SUM U_k = SUM U_k0  and  SUM z_k U_k = SUM z_k U_k0  on every crankshaft: force, couple and roll moment stay
//! ```

mod answer;
mod climb;
mod merit;
mod moved;
mod request;
mod space;

pub use answer::{
    DURABLE_VERSION, Durable, DurableEnd, DurableLimit, DurableRow, DurableSettings, DurableStage,
};
pub use request::DurableRequest;

use crate::answer::{Answer, Outcome};
use crate::error::BalanceError;
use crate::fitted::fitted;
use climb::Climb;
use lanchester_model::Engine;
use lanchester_task::{Criterion, DurabilityCriterion, Load, Mains, Measured, Stage, Statistic};
use merit::{Aim, Wanted};
use space::Space;

/// Films and safeties before, at the proved optimum `answer`, and after a local search for what its task wants of them.
///
/// # Errors
/// [`BalanceError`] where a stage cannot be computed for moved weights; [`BalanceError::BrokenOff`] where the watch abandons it.
pub fn durable(
    engine: &Engine,
    answer: &Answer,
    request: &DurableRequest<'_>,
) -> Result<Durable, BalanceError> {
    let task = &answer.task;
    let wish = &task.durability;
    let named = told_criteria(engine, wish.criteria());
    let optimum = fitted(engine, answer);
    let measure = |engine: &Engine| request.reporter.measure(engine, &named);
    let (before, at_optimum) = (measure(engine), measure(&optimum));
    let rows = |after: &[Measured]| -> Vec<DurableRow> {
        let all = named.iter().zip(&before).zip(&at_optimum).zip(after);
        all.map(|(((criterion, before), optimum), after)| DurableRow {
            criterion: *criterion,
            name: criterion.title(),
            unit: criterion.unit().to_owned(),
            before: before.clone(),
            optimum: optimum.clone(),
            after: after.clone(),
        })
        .collect()
    };
    let mut found = Durable::unmoved(answer, rows(&at_optimum), wish);
    if wish.is_empty() || answer.weights.is_empty() {
        return Ok(found);
    }
    let is_searched = |criterion: &DurabilityCriterion| criterion.depends_on_unbalances();
    let is_short = |limit: &DurableLimit| is_searched(&limit.criterion) && limit.is_met != Some(true);
    if !wish.maximise.iter().any(is_searched) && !found.limits.iter().any(is_short) {
        found.end = match found.is_met() && wish.maximise.is_empty() {
            true => DurableEnd::NotNeeded,
            false => DurableEnd::NoWeights { reason: UNCHANGED.to_owned() },
        };
        return Ok(found);
    }
    let wanted = Wanted::new(engine, wish);
    if let Some(missing) = wanted.missing(&request.meter.measure(&optimum, wanted.parts())) {
        found.end = DurableEnd::NotMeasured(missing);
        return Ok(found);
    }
    let Some(space) = Space::new(engine, answer) else {
        found.end = DurableEnd::NoWeights { reason: "no weight on a crankshaft is free to move".into() };
        return Ok(found);
    };
    let mut climb = Climb::new(engine, answer, &space, &wanted, request);
    climb.start(space.base())?;
    // What is convex is solved with its proof: the best of its answers is where the search begins.
    for stage in surrogates(engine) {
        if climb.is_over() {
            break;
        }
        let mut other = task.clone();
        other.stages = task.stages_or_default().into_iter().chain([stage]).collect();
        other.cancel.clear();
        if task.cancel.is_empty()
            && let Ok(other) = (request.optimum)(&other)
            && other.outcome == Outcome::Optimal
        {
            climb.start(space.adopt(&other))?;
        }
    }
    if wanted.has_limits() {
        climb.up(Aim::Limits)?;
    }
    for place in 0..wanted.maximised() {
        climb.up(Aim::Maximise(place))?;
    }
    found.evaluations = climb.evaluations();
    let unbalances = climb.best();
    found.end = match climb.ending() {
        _ if unbalances == space.base() => DurableEnd::NothingBetter,
        Some(cause) => DurableEnd::Stopped { cause },
        None => DurableEnd::Moved,
    };
    if unbalances == space.base() {
        return Ok(found);
    }
    found.stages = climb.stages(&unbalances)?;
    found.effects = climb.effects(&unbalances)?;
    found.take(task, unbalances);
    let after = found.engine(engine, answer);
    let measured = measure(&after);
    found.rows = rows(&measured);
    found.judge(wish);
    Ok(found)
}

/// Why a search for what is named would be in vain.
const UNCHANGED: &str = "no unbalance on a crankshaft changes it: films of crankpins and the formulas after UR M53 follow from the forces of the rods";

/// What is always told beside what is wanted.
fn told_criteria(engine: &Engine, wanted: Vec<DurabilityCriterion>) -> Vec<DurabilityCriterion> {
    let mains = (0..engine.main_bearings().len()).map(|index| DurabilityCriterion::MainFilm(Some(index)));
    let usual = mains.chain([DurabilityCriterion::CrankpinFilm(None), DurabilityCriterion::RuleSafety(None)]);
    let mut all: Vec<DurabilityCriterion> = usual.collect();
    for criterion in wanted {
        if !all.contains(&criterion) {
            all.push(criterion);
        }
    }
    all
}

/// Convex criteria whose optimum is likely to have thick films.
fn surrogates(engine: &Engine) -> Vec<Stage> {
    let of = |criterion| Stage::of(vec![(1.0, criterion)]);
    match engine.gas {
        Some(_) => vec![
            of(Criterion::MainsWithGas(Statistic::Rms, Mains::All)),
            of(Criterion::MainsWithGas(Statistic::Peak, Mains::Largest)),
        ],
        None => vec![of(Criterion::Peak(Load::LargestMainLoad))],
    }
}
