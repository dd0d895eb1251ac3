//! Criteria of one kind over speed: what each kind can say of an engine, and what both kinds need for it.

use crate::answer::{Answer, JudgedSpeeds};
use crate::error::BalanceError;
use crate::fitted::fitted;
use crate::over_speed::places::SpeedPlaces;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion};

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

impl From<Engine> for Fitted {
    fn from(engine: Engine) -> Fitted {
        Fitted { engine, inertia_share: 0.0 }
    }
}

impl Fitted {
    pub fn of(engine: &Engine, answer: &Answer) -> Fitted {
        let inertia_share = answer.inertias.iter().map(|found| 1.0 - found.roll_share).sum();
        Fitted { engine: fitted(engine, answer), inertia_share }
    }
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
