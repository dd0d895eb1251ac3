//! Loads that a higher speed need not raise, over a range of speeds: the worst places of each answer join those that the programme
//! judges.
//!
//! Any set of places (speeds, or bearing, speed and angle) gives a lower bound of what the range allows. After each optimum the largest
//! loads over the whole range are looked for, and their places join the set until nothing passes the value by more
//! than the range leaves.

use crate::answer::Answer;
use crate::error::BalanceError;
use crate::fitted::bare;
use crate::over_speed::gas::GasOverSpeed;
use crate::over_speed::gas_range::GasRange;
use crate::over_speed::kind::{Fitted, OverSpeeds, Worst};
use crate::over_speed::mount_range::MountRange;
use crate::over_speed::places::SpeedPlaces;
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Stage};
use std::rc::Rc;

/// Most rounds; what is left then is told.
const MOST_ROUNDS: usize = 24;

/// What solves a task whose loads over speed are judged at given places.
pub(crate) type SolveAt<'a> = &'a dyn Fn(&BalanceTask, &Rc<SpeedPlaces>) -> Result<Answer, BalanceError>;

/// Solves `task` by `solve` with the places at which its loads over speed have to be judged.
pub(crate) fn over_the_range(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    gas: Option<&dyn GasOverSpeed>,
    solve: SolveAt<'_>,
) -> Result<Answer, BalanceError> {
    let mut kinds: Vec<Box<dyn OverSpeeds + '_>> = Vec::new();
    if let Some(mounts) = MountRange::of(engine, task, kinematics, gas)? {
        kinds.push(Box::new(mounts));
    }
    if let Some(mains) = GasRange::of(engine, task, gas)? {
        kinds.push(Box::new(mains));
    }
    if kinds.is_empty() {
        return solve(task, &Rc::default());
    }
    Ok(exchange(engine, task, &kinds, solve)?.0)
}

/// Optimum after optimum until no place of the range passes the value; also where they were judged.
fn exchange(
    engine: &Engine,
    task: &BalanceTask,
    kinds: &[Box<dyn OverSpeeds + '_>],
    solve: SolveAt<'_>,
) -> Result<(Answer, SpeedPlaces), BalanceError> {
    let mut places = SpeedPlaces::default();
    for kind in kinds {
        kind.begin(&mut places)?;
    }
    let (mut round, mut sought) = (0, false);
    loop {
        round += 1;
        let mut answer = solve(task, &Rc::new(places.clone()))?;
        if answer.stages.is_empty() {
            // How far limits are from holding is known where the places that decide about them are.
            let limited: Vec<Criterion> = task.limits.iter().map(|limit| limit.criterion).collect();
            let own = kinds.iter().flat_map(|kind| kind.criteria()).filter(|one| limited.contains(one));
            if !sought && own.clone().next().is_some() {
                sought = true;
                for criterion in own {
                    join_alone(&mut places, engine, task, kinds, *criterion, solve)?;
                }
                continue;
            }
            return Ok((answer, places));
        }
        let fitted = Fitted::of(engine, &answer);
        let known = places.clone();
        let mut found = Vec::new();
        for kind in kinds {
            let value = |criterion: &Criterion| {
                answer.effects.iter().find(|one| one.criterion == *criterion).map(|effect| effect.after)
            };
            let values: Vec<Option<f64>> = kind.criteria().iter().map(value).collect();
            let worst = kind.look(&fitted, &values, &mut places)?;
            let excess = |(worst, value): (&Worst, &Option<f64>)| {
                let value = value.unwrap_or(worst.load);
                ((worst.load - value) / value.max(f64::MIN_POSITIVE)).max(0.0)
            };
            let excess: Vec<f64> = worst.iter().zip(&values).map(excess).collect();
            found.push((worst, excess));
        }
        if places == known || round == MOST_ROUNDS {
            for (kind, (worst, excess)) in kinds.iter().zip(&found) {
                kind.tell(&mut answer, &places, worst, excess);
                tell_effects(&mut answer, engine, task, kind.as_ref(), worst)?;
            }
            return Ok((answer, places));
        }
    }
}

/// Adds the places that decide how small a limited criterion can be by itself.
fn join_alone(
    places: &mut SpeedPlaces,
    engine: &Engine,
    task: &BalanceTask,
    kinds: &[Box<dyn OverSpeeds + '_>],
    criterion: Criterion,
    solve: SolveAt<'_>,
) -> Result<(), BalanceError> {
    let alone = BalanceTask {
        stages: vec![Stage { terms: vec![(1.0, criterion)] }],
        give_up: Vec::new(),
        limits: Vec::new(),
        ..task.clone()
    };
    let (answer, found) = exchange(engine, &alone, kinds, solve)?;
    let fitted = Fitted::of(engine, &answer);
    kinds.iter().try_for_each(|kind| kind.join(places, &found, &fitted, &criterion))
}

/// Before, without and after of criteria over speed, each at its own worst speed.
fn tell_effects(
    answer: &mut Answer,
    engine: &Engine,
    task: &BalanceTask,
    kind: &dyn OverSpeeds,
    worst: &[Worst],
) -> Result<(), BalanceError> {
    let before = kind.largest(&Fitted::from(engine.clone()))?;
    let without = kind.largest(&Fitted::from(bare(engine, task)))?;
    for (place, criterion) in kind.criteria().iter().enumerate() {
        for effect in answer.effects.iter_mut().filter(|effect| effect.criterion == *criterion) {
            effect.before = before[place].load;
            effect.without = without[place].load;
            effect.after = effect.after.max(worst[place].load);
        }
    }
    raise(answer, kind.criteria());
    Ok(())
}

/// A stage has what the range has of it, above the bound by no more than the search left.
fn raise(answer: &mut Answer, criteria: &[Criterion]) {
    for stage in &mut answer.stages {
        for ((criterion, value), weight) in stage.terms.iter_mut().zip(&stage.term_weights) {
            let effect = answer.effects.iter().find(|effect| effect.criterion == *criterion);
            if let Some(effect) = effect.filter(|effect| criteria.contains(&effect.criterion)) {
                let rise = effect.after - *value;
                (*value, stage.value, stage.gap) =
                    (effect.after, stage.value + weight * rise, stage.gap + weight * rise);
            }
        }
    }
}
