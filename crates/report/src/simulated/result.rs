//! A simulated run with what its reader must know.

use crate::simulated::heat::PeriodHeat;
use crate::simulated::period::{PeriodSummary, SimulatedOrder, last_period};
use lanchester_multibody::{Followed, MainRule, Occasion, PeriodicOutcome, Run, thinned};
use serde::Serialize;
use std::borrow::Cow;
use std::f64::consts::TAU;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const SIMULATION_VERSION: u32 = 1;

/// A simulated run with what its reader must know.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SimulationResult {
    /// [`SIMULATION_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Where the pressures come from, in words; `None`: no gas.
    pub gas: Option<String>,
    /// What was chosen where nothing was said, and what the file gives but the run does not use.
    pub notes: Vec<String>,
    /// Revolutions after which all shafts and cylinders stand as before.
    pub revolutions: u32,
    /// What each event of the run does, in words.
    pub actions: Vec<String>,
    /// Names of the mounts.
    pub mounts: Vec<String>,
    /// Planes of the main bearings [m], by crankshaft.
    pub mains: Vec<Vec<f64>>,
    /// The rule of main bearings that tables of one rule and pictures show.
    pub main_rule: MainRule,
    /// How the search for a periodic motion ended, where one was asked for.
    pub periodic: Option<PeriodicResult>,
    /// Names of what turns besides crankshaft 1, in the order of the rotors of the reactions.
    pub gears: Vec<String>,
    /// Samples from one that was asked for to the next: between them stand others, at most a degree apart, so that largest values and orders do not depend on the step.
    /// What is written has every one that was asked for ([`SimulationResult::written`]).
    #[serde(skip)]
    pub every: usize,
    /// Whether every cylinder has all its fuel to the end, as the closed form has it.
    #[serde(skip)]
    pub is_fired_throughout: bool,
    /// Heat of the last period, where the pressures are those of a computed cycle and every cylinder has all its fuel.
    pub heat: Option<PeriodHeat>,
    /// Motion of the points of the block that were asked for.
    pub points: Vec<PointMotion>,
    /// The last period in numbers.
    pub period: PeriodSummary,
    /// The run.
    pub run: Run,
}

/// Motion of a point of the block.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PointMotion {
    /// Its name.
    pub name: String,
    /// Where it is with the block as drawn [m].
    pub at: [f64; 3],
    /// Its displacement from there at every sample [m], axes of the frame; empty with a fixed block.
    pub displacement: Vec<[f64; 3]>,
}

/// How the search for a periodic motion ended.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PeriodicResult {
    /// Outcome.
    pub outcome: PeriodicOutcome,
    /// Largest change over one period, over the size of its kind of state.
    pub residual: f64,
    /// Newton's iterations.
    pub iterations: usize,
    /// Multipliers by falling size: real and imaginary part; empty where there are none to tell.
    pub multipliers: Vec<[f64; 2]>,
    /// How far the motion was followed from the start, where Newton did not find it from there.
    pub followed: Option<Followed>,
}

impl SimulationResult {
    /// With the samples that were asked for alone.
    pub fn written(&self) -> Cow<'_, SimulationResult> {
        if self.every <= 1 {
            return Cow::Borrowed(self);
        }
        let point = |own: &PointMotion| PointMotion {
            displacement: thinned(&own.displacement, self.every),
            name: own.name.clone(),
            at: own.at,
        };
        Cow::Owned(SimulationResult {
            engine: self.engine.clone(),
            gas: self.gas.clone(),
            notes: self.notes.clone(),
            actions: self.actions.clone(),
            mounts: self.mounts.clone(),
            mains: self.mains.clone(),
            periodic: self.periodic.clone(),
            gears: self.gears.clone(),
            heat: self.heat,
            points: self.points.iter().map(point).collect(),
            period: self.period.clone(),
            run: self.run.every(self.every),
            every: 1,
            ..*self
        })
    }

    /// Samples of the last whole period, or all where there is none.
    pub fn last_period(&self) -> std::ops::Range<usize> {
        last_period(&self.run.samples, self.revolutions)
    }

    /// The last whole period by order, at the crank angle itself; empty where its samples are not equally spaced in the angle, or none is whole.
    pub fn orders(&self) -> &[SimulatedOrder] {
        &self.period.orders
    }

    /// What curves over some samples are drawn over, with its unit: revolutions from the first of them, time where the crank turns back.
    pub(crate) fn abscissa(&self, range: std::ops::Range<usize>) -> (&'static str, &'static str, Vec<f64>) {
        let samples = &self.run.samples;
        let since = |values: &[f64], unit: f64| -> Vec<f64> {
            let first = values.first().copied().unwrap_or(0.0);
            values.iter().map(|value| (value - first) / unit).collect()
        };
        let theta = samples.theta.get(range.clone()).unwrap_or_default();
        if theta.is_sorted() {
            return ("revolutions", "1", since(theta, TAU));
        }
        ("time", "s", since(samples.time.get(range).unwrap_or_default(), 1.0))
    }

    /// Highest, lowest and mean (over time) speed in the last whole period [rad/s].
    pub fn speeds(&self) -> [f64; 3] {
        let range = self.last_period();
        let (speed, time) = (&self.run.samples.speed[range.clone()], &self.run.samples.time[range.clone()]);
        let theta = &self.run.samples.theta[range];
        let bounds = self.period.extremes.speed;
        let mean = match (theta.first(), theta.last(), time.first(), time.last()) {
            (Some(a), Some(b), Some(from), Some(to)) if to > from => (b - a) / (to - from),
            _ => speed.first().copied().unwrap_or(0.0),
        };
        [bounds.most.value, bounds.least.value, mean]
    }

    /// Words for something that happened in the run.
    pub fn happened(&self, what: Occasion) -> String {
        occasion_words(what, &self.actions)
    }

    /// Main bearings: number of the crankshaft, of the main, plane, largest load in the last period by every rule [N].
    pub(super) fn mains(&self) -> Vec<(usize, usize, f64, [f64; 3])> {
        let mut all = Vec::new();
        for (shaft, planes) in self.mains.iter().enumerate() {
            for (main, z) in planes.iter().enumerate() {
                let rotor = self.period.extremes.rotors.get(shaft);
                let of = |rule: usize| {
                    rotor.and_then(|own| own.mains[rule].get(main)).map_or(0.0, |peak| peak.value)
                };
                all.push((shaft + 1, main + 1, *z, [of(0), of(1), of(2)]));
            }
        }
        all
    }
}

/// What happened, in words.
pub(super) fn occasion_words(what: Occasion, actions: &[String]) -> String {
    match what {
        Occasion::Event { index } => {
            actions.get(index).cloned().unwrap_or_else(|| format!("event {}", index + 1))
        }
        Occasion::StarterOff => "the starter lets go".into(),
        Occasion::Reversed => "the crank reverses".into(),
        Occasion::Held => "friction holds the crank".into(),
        Occasion::Released => "the crank breaks away".into(),
    }
}
