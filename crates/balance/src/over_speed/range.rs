//! Loads that a higher speed need not raise, over a range of speeds: the worst places of each answer join those that the programme
//! judges.
//!
//! Any set of places (speeds, or bearing, speed and angle) gives a lower bound of what the range allows. After each optimum the largest
//! loads over the whole range are looked for, and their places join the set until nothing passes the value by more
//! than the range leaves.

use crate::answer::{Answer, JudgedSpeeds};
use crate::error::BalanceError;
use crate::fitted::{bare, fitted};
use crate::over_speed::gas::GasOverSpeed;
use crate::over_speed::gas_range::GasRange;
use crate::over_speed::mount_range::MountRange;
use crate::over_speed::places::SpeedPlaces;
use crate::problem::stages;
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Stage};
use std::rc::Rc;

/// Most rounds; what is left then is told.
const MOST_ROUNDS: usize = 24;

/// What solves a task whose loads over speed are judged at given places.
pub(crate) type SolveAt<'a> = &'a dyn Fn(&BalanceTask, &Rc<SpeedPlaces>) -> Result<Answer, BalanceError>;

/// The largest of a criterion over the speeds, times the weight of its speed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Worst {
    pub load: f64,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
}

/// An engine with what is known of the devices that stand in no engine file.
#[derive(Debug, Clone)]
pub(crate) struct Fitted {
    pub engine: Engine,
    /// Share of the torque that a counter-rotating inertia takes off the roll moment.
    pub inertia_share: f64,
}

/// Criteria of one kind, which are judged over speeds.
pub(crate) trait OverSpeeds {
    fn criteria(&self) -> &[Criterion];

    /// Adds the places where a programme judges to begin with.
    fn begin(&self, places: &mut SpeedPlaces) -> Result<(), BalanceError>;

    /// The largest of each criterion.
    fn largest(&self, of: &Fitted) -> Result<Vec<Worst>, BalanceError>;

    /// The largest of each criterion; where it passes its value by more than counts, its places join the others.
    fn look(
        &self,
        of: &Fitted,
        values: &[Option<f64>],
        places: &mut SpeedPlaces,
    ) -> Result<Vec<Worst>, BalanceError>;

    /// Says in the answer where the criteria were judged.
    fn tell(&self, answer: &mut Answer, places: &SpeedPlaces, worst: &[Worst], excess: &[f64]);

    /// Adds the places that decide how small a criterion can be by itself: those that were `found` for it, or where it is largest then.
    fn join(
        &self,
        places: &mut SpeedPlaces,
        found: &SpeedPlaces,
        least: &Fitted,
        criterion: &Criterion,
    ) -> Result<(), BalanceError>;
}

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

impl From<Engine> for Fitted {
    fn from(engine: Engine) -> Fitted {
        Fitted { engine, inertia_share: 0.0 }
    }
}

impl Fitted {
    fn of(engine: &Engine, answer: &Answer) -> Fitted {
        let inertia_share = answer.inertias.iter().map(|found| 1.0 - found.roll_share).sum();
        Fitted { engine: fitted(engine, answer), inertia_share }
    }
}

/// The criteria of a task of one kind, each once.
pub(crate) fn criteria(task: &BalanceTask, counts: impl Fn(&Criterion) -> bool) -> Vec<Criterion> {
    let stages = stages(task);
    let asked = stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    let mut criteria: Vec<Criterion> = Vec::new();
    for criterion in asked.chain(task.limits.iter().map(|limit| limit.criterion)) {
        if counts(&criterion) && !criteria.contains(&criterion) {
            criteria.push(criterion);
        }
    }
    criteria
}

/// What is told of criteria of one kind, of which those at `own` places count.
pub(crate) fn judged(
    mut judged: Vec<f64>,
    task: &BalanceTask,
    worst: &[Worst],
    excess: &[f64],
    own: impl Fn(usize) -> bool + Copy,
) -> Option<JudgedSpeeds> {
    let first = (0..worst.len()).find(|place| own(*place))?;
    judged.sort_by(f64::total_cmp);
    judged.dedup();
    let excess = (0..excess.len()).filter(|place| own(*place)).map(|place| excess[place]).fold(0.0, f64::max);
    let given = task.weighted_speeds();
    let weight =
        |speed: &f64| given.iter().filter(|one| one.0 == *speed).map(|one| one.1).fold(0.0, f64::max);
    let weighted = given.iter().any(|one| one.1 != 1.0);
    let weights = if weighted { judged.iter().map(weight).collect() } else { Vec::new() };
    Some(JudgedSpeeds { judged, weights, worst: worst[first].speed, excess, range: given.is_empty() })
}

/// Why a criterion with gas has none.
pub(crate) fn no_gas(engine: &Engine, criterion: &Criterion) -> BalanceError {
    BalanceError::Missing {
        criterion: lanchester_task::criterion_name(criterion, engine),
        needed: "the pressures of the cylinders",
        hint: "add [gas] to the engine file, or leave \"with gas\" out",
    }
}

/// Equal steps from one speed to another, both included.
pub(crate) fn steps(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| from + (to - from) * k as f64 / count.max(1) as f64).collect()
}
