//! Cycles of a train until they repeat.

use super::assembly::{Assembly, SUMS};
use super::flywheel::{FreeFlywheel, FreeSpeed, HARDLY};
use super::mixing::Mixing;
use super::parts::CrankTrain;
use super::plane::{length, plus};
use super::snapshot::CycleInstant;
use crate::FlexError;
use lanchester_numerics::Esdirk;
use serde::Serialize;

/// Samples between two forced stops before the cycles repeat.
const COARSE: usize = 8;
/// Halvings of the distance between stops after which a step is too short.
const FINEST: u32 = 24;
/// Damping of the first cycle over that given: what the start disturbs dies sooner.
const FIRST_DAMPING: f64 = 20.0;
/// Cycles of an envelope where they never repeat.
const ENVELOPE: usize = 5;
/// Share of the tolerance below which the step is doubled: 2^-4 with a margin.
const DOUBLED: f64 = 0.04;

/// How a train is run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CycleOptions {
    /// Instants of a period, a multiple of 8.
    pub samples: usize,
    /// Tolerance of a step: of eccentricities over the clearance, of deformations over those under the largest force.
    pub tolerance: f64,
    /// Most cycles.
    pub most_cycles: usize,
    /// Change of the orbits from cycle to cycle over the clearance that counts as none.
    pub orbit_change: f64,
    /// Change of loads and deformation over their largest that counts as none.
    pub stress_change: f64,
}

impl Default for CycleOptions {
    /// Every degree of a four-stroke engine.
    fn default() -> CycleOptions {
        CycleOptions {
            samples: 720,
            tolerance: 1e-4,
            most_cycles: 30,
            orbit_change: 1e-3,
            stress_change: 5e-3,
        }
    }
}

/// How the cycles ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum CycleOutcome {
    /// They repeat.
    Periodic,
    /// They do not within the most that are allowed: five more give the envelope.
    NotPeriodic,
    /// A step without solution: a film has no thickness left, or a rod does not reach. The last whole cycle stands, with fewer instants.
    Broken {
        /// Angle of crankshaft 1 [rad], from the first cycle on.
        theta: f64,
    },
    /// Stopped by the one who watches: the last whole cycle stands, with fewer instants.
    Stopped,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleState {
    /// Whole cycles so far.
    pub cycles: usize,
    /// Part of the cycle that runs, 0 to 1.
    pub part: f64,
    /// Largest change of an orbit from the last cycle but one, over the clearance; infinite before there are two.
    pub orbit_change: f64,
    /// The same of loads and deformation, over their largest.
    pub stress_change: f64,
    /// The same of a free flywheel's speed, over its swing; none where the motion is imposed.
    pub speed_change: Option<f64>,
}

/// Work and energy over the recorded cycle [J].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct EnergyBalance {
    /// Work of the gas.
    pub gas: f64,
    /// Work of the flywheel on the crankshaft.
    pub drive: f64,
    /// Lost in the material's damping.
    pub damping: f64,
    /// Taken by the bearings, their springs' energy included.
    pub bearings: f64,
    /// Change of kinetic and elastic energy.
    pub change: f64,
    /// What is missing: gas + drive - damping - bearings - change.
    pub missing: f64,
    /// Sum of the sizes of all powers over time, by which `missing` is judged.
    pub turnover: f64,
}

impl EnergyBalance {
    /// Missing energy over the turnover.
    pub fn error(&self) -> f64 {
        if self.turnover > 0.0 { self.missing.abs() / self.turnover } else { self.missing.abs() }
    }
}

/// A recorded cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedCycle {
    /// Its instants.
    pub instants: Vec<CycleInstant>,
    /// Its energies.
    pub energy: EnergyBalance,
}

/// What cycles of a train gave.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainCycles {
    /// How they ended.
    pub outcome: CycleOutcome,
    /// Cycles that were run, the recorded ones included.
    pub cycles: usize,
    /// Largest change of an orbit from the last cycle but one, over the clearance.
    pub orbit_change: f64,
    /// The same of loads and deformation, over their largest.
    pub stress_change: f64,
    /// How a free flywheel turns, from its first cycle on; none where the motion is imposed.
    pub free: Option<FreeSpeed>,
    /// The recorded cycle, or five of them where they do not repeat; the last whole one of a run that was stopped or broke off, none where it had none.
    pub recorded: Vec<RecordedCycle>,
    /// Steps of all cycles, those of the recorded ones included.
    pub steps: u64,
    /// Steps that were tried again shorter.
    pub rejected: u64,
    /// Newton iterations of all stages.
    pub iterations: u64,
}

/// What hears how far a run is, and says whether it goes on.
pub type CycleWatch<'a> = &'a dyn Fn(CycleState) -> bool;

struct Runner<'a> {
    train: &'a CrankTrain,
    flywheel: Option<FreeFlywheel>,
    watch: CycleWatch<'a>,
    /// What the watch hears; whether it said stop; the last whole cycle.
    heard: CycleState,
    stopped: bool,
    last: Option<RecordedCycle>,
    assembly: Assembly<'a>,
    integrator: Esdirk,
    state: Vec<f64>,
    slope: Vec<f64>,
    /// Time of the last good state [s].
    time: f64,
    /// Halvings of the distance between coarse stops.
    level: u32,
    steps: u64,
    rejected: u64,
    iterations: u64,
}

/// Runs a train until its cycles repeat, and records the last one.
///
/// # Errors
/// As [`CrankTrain::check`]; [`FlexError::Number`] for samples that are no multiple of 8.
pub fn run_cycles(train: &CrankTrain, options: CycleOptions) -> Result<TrainCycles, FlexError> {
    run_cycles_watched(train, options, &|_| true)
}

/// The same; `watch` hears many times a cycle how far the run is, and stops it with `false`.
///
/// # Errors
/// As [`run_cycles`].
pub fn run_cycles_watched(
    train: &CrankTrain,
    options: CycleOptions,
    watch: CycleWatch<'_>,
) -> Result<TrainCycles, FlexError> {
    run(train, None, options, watch)
}

/// The same with a flywheel that turns freely at the mean speed of `train.motion`, which it follows over the first cycle.
///
/// # Errors
/// As [`run_cycles`]; [`FlexError::Number`] for an inertia that is none.
pub fn run_free(
    train: &CrankTrain,
    flywheel: FreeFlywheel,
    options: CycleOptions,
    watch: CycleWatch<'_>,
) -> Result<TrainCycles, FlexError> {
    flywheel.check()?;
    run(train, Some(flywheel), options, watch)
}

fn run(
    train: &CrankTrain,
    flywheel: Option<FreeFlywheel>,
    options: CycleOptions,
    watch: CycleWatch<'_>,
) -> Result<TrainCycles, FlexError> {
    train.check()?;
    if options.samples < 4 * COARSE || !options.samples.is_multiple_of(COARSE) {
        return Err(FlexError::Number {
            quantity: "instants of a period".to_owned(),
            needed: format!("a multiple of {COARSE}, at least {}", 4 * COARSE),
            got: options.samples as f64,
            hint: "720 are one a degree of a four-stroke engine",
        });
    }
    let assembly = Assembly::new(train, options.tolerance, flywheel);
    let state = assembly.start();
    let mut found = TrainCycles {
        outcome: CycleOutcome::NotPeriodic,
        cycles: 0,
        orbit_change: f64::INFINITY,
        stress_change: f64::INFINITY,
        free: None,
        recorded: Vec::new(),
        steps: 0,
        rejected: 0,
        iterations: 0,
    };
    let mut runner = Runner {
        train,
        flywheel,
        watch,
        heard: found.state(flywheel),
        stopped: false,
        last: None,
        integrator: Esdirk::new(state.len()),
        slope: vec![0.0; state.len()],
        state,
        assembly,
        time: 0.0,
        level: 4,
        steps: 0,
        rejected: 0,
        iterations: 0,
    };
    let mut before: Vec<CycleInstant> = Vec::new();
    let mut mixing = Mixing::default();
    let weights = runner.assembly.weights();
    runner.damp(FIRST_DAMPING);
    while found.cycles < options.most_cycles {
        let start = runner.state.clone();
        let Some(now) = runner.cycle(found.cycles, options.samples, COARSE) else {
            return Ok(runner.broken(found));
        };
        found.cycles += 1;
        found.compare(&mut runner, &before, &now.instants, &start, &now.energy);
        before = now.instants.clone();
        runner.last = Some(now);
        if found.cycles > 2 && found.repeats(options, flywheel) {
            // What is recorded follows without mixing: it must repeat too.
            let start = runner.state.clone();
            let Some(now) = runner.cycle(found.cycles, options.samples, 1) else {
                return Ok(runner.broken(found));
            };
            found.cycles += 1;
            let coarse: Vec<CycleInstant> = now.instants.iter().step_by(COARSE).cloned().collect();
            found.compare(&mut runner, &before, &coarse, &start, &now.energy);
            before = coarse;
            if found.repeats(options, flywheel) {
                found.outcome = CycleOutcome::Periodic;
                found.recorded.push(now);
                return Ok(runner.counted(found));
            }
        } else if found.cycles > 1 {
            let next = mixing.next(&start, &runner.state, &weights);
            runner.begin(next, found.cycles);
        }
        runner.damp(1.0);
    }
    for _ in 0..ENVELOPE {
        let start = runner.state.clone();
        let Some(now) = runner.cycle(found.cycles, options.samples, 1) else {
            return Ok(runner.broken(found));
        };
        found.cycles += 1;
        let coarse: Vec<CycleInstant> = now.instants.iter().step_by(COARSE).cloned().collect();
        found.compare(&mut runner, &before, &coarse, &start, &now.energy);
        before = coarse;
        if found.repeats(options, flywheel) {
            found.outcome = CycleOutcome::Periodic;
            found.recorded = vec![now];
            break;
        }
        found.recorded.push(now);
    }
    Ok(runner.counted(found))
}

impl TrainCycles {
    /// Compares a cycle with the one before, and sets the flywheel for the next.
    fn compare(
        &mut self,
        runner: &mut Runner,
        before: &[CycleInstant],
        now: &[CycleInstant],
        start: &[f64],
        energy: &EnergyBalance,
    ) {
        if !before.is_empty() {
            (self.orbit_change, self.stress_change) = runner.change(before, now);
        }
        self.free = runner.turn_flywheel(self.cycles, start, now, energy);
        runner.heard = self.state(runner.flywheel);
    }

    /// What the watch hears at the start of a cycle.
    fn state(&self, flywheel: Option<FreeFlywheel>) -> CycleState {
        let speed_change = flywheel.map(|_| self.free.map_or(f64::INFINITY, |free| free.change));
        let (orbit_change, stress_change) = (self.orbit_change, self.stress_change);
        CycleState { cycles: self.cycles, part: 0.0, orbit_change, stress_change, speed_change }
    }

    fn repeats(&self, options: CycleOptions, flywheel: Option<FreeFlywheel>) -> bool {
        self.orbit_change < options.orbit_change
            && self.stress_change < options.stress_change
            && flywheel.is_none_or(|own| self.free.is_some_and(|free| free.change < own.change))
    }
}

impl Runner<'_> {
    fn counted(&self, mut found: TrainCycles) -> TrainCycles {
        (found.steps, found.rejected, found.iterations) = (self.steps, self.rejected, self.iterations);
        found
    }

    fn broken(&mut self, mut found: TrainCycles) -> TrainCycles {
        found.outcome = match self.stopped {
            true => CycleOutcome::Stopped,
            false => CycleOutcome::Broken { theta: self.assembly.first(self.time, &self.state, &[]).angle },
        };
        found.recorded = self.last.take().into_iter().collect();
        self.counted(found)
    }

    /// Takes a state at the start of a cycle, where it leaves every film some thickness.
    fn begin(&mut self, state: Vec<f64>, number: usize) {
        if self.assembly.has_films(number as f64 * self.train.motion.duration(), &state) {
            self.state = state;
        }
    }

    /// After a cycle from `start`: the flywheel at angle zero again, with the speed and load of the next; how it turned, once it is free.
    fn turn_flywheel(
        &mut self,
        cycles: usize,
        start: &[f64],
        now: &[CycleInstant],
        energy: &EnergyBalance,
    ) -> Option<FreeSpeed> {
        let flywheel = self.flywheel?;
        let motion = &self.train.motion;
        let duration = motion.duration();
        let ends = self.assembly.flywheel(start).zip(self.assembly.flywheel(&self.state));
        let ([rate, load], found) = match ends {
            None => ([motion.at(0.0).speed - motion.speed, -energy.gas / motion.period], None),
            Some((start, end)) => {
                let speeds = || now.iter().map(|own| own.speed);
                let swing = speeds().fold(0.0, f64::max) - speeds().fold(f64::INFINITY, f64::min);
                let change = FreeFlywheel::change_of_speed(start, end, duration);
                let change = change / swing.max(HARDLY * motion.speed);
                (flywheel.next(start, end, duration), Some(FreeSpeed { load: end[2], change }))
            }
        };
        self.assembly.set_flywheel(cycles as f64 * duration, &mut self.state, [0.0, rate, load]);
        self.integrator.restart();
        found
    }

    fn damp(&mut self, factor: f64) {
        self.assembly.damping = factor;
        self.integrator.restart();
    }

    /// One cycle with so many stops; none where it breaks.
    fn cycle(&mut self, number: usize, samples: usize, every: usize) -> Option<RecordedCycle> {
        let stops = samples / every;
        let duration = self.train.motion.duration();
        let start = number as f64 * duration;
        let sums = self.assembly.sums();
        self.state[sums..].fill(0.0);
        let before = self.assembly.energy(start, &self.state);
        let mut instants = Vec::with_capacity(stops);
        for stop in 0..stops {
            if stop.is_multiple_of(COARSE / every) {
                let state = CycleState { part: stop as f64 / stops as f64, ..self.heard };
                if !(self.watch)(state) {
                    self.stopped = true;
                    return None;
                }
            }
            if stop == 0 {
                // The slope at the start, for the snapshot.
                let mut slope = std::mem::take(&mut self.slope);
                let works = lanchester_numerics::StageSystem::slope(
                    &mut self.assembly,
                    start,
                    &self.state,
                    &mut slope,
                );
                self.slope = slope;
                if !works {
                    return None;
                }
            }
            let from = start + duration * stop as f64 / stops as f64;
            let mut own = self.assembly.snapshot(from, &self.state, &self.slope)?;
            own.theta -= self.train.motion.speed * start;
            instants.push(own);
            self.between(start, duration / stops as f64, stop, (COARSE / every).ilog2())?;
        }
        let end = start + duration;
        let energy = self.state[sums..].to_vec();
        let [gas, drive, damping, bearings, turnover] =
            <[f64; SUMS]>::try_from(energy.as_slice()).unwrap_or_default();
        let change = self.assembly.energy(end, &self.state) - before;
        Some(RecordedCycle {
            instants,
            energy: EnergyBalance {
                gas,
                drive,
                damping,
                bearings: -bearings,
                change,
                missing: gas + drive - damping + bearings - change,
                turnover,
            },
        })
    }

    /// From one stop to the next in halves of halves of their distance.
    /// The level counts from the distance of the coarse stops, which is `coarser` doublings of this one: so lengths of steps are the same in all cycles.
    fn between(&mut self, start: f64, distance: f64, stop: usize, coarser: u32) -> Option<()> {
        let whole = 1u64 << FINEST;
        let mut at = 0u64;
        let mut level = self.level.saturating_sub(coarser);
        while at < whole {
            // A step begins at a multiple of its length.
            while !at.is_multiple_of(whole >> level) {
                level += 1;
            }
            let size = whole >> level;
            let h = distance * (1.0 / (1u64 << level) as f64);
            let t = start + distance * (stop as f64 + at as f64 / whole as f64);
            let done = self.integrator.attempt(&mut self.assembly, t, h, &self.state);
            let error = match done {
                Some(iterations) => {
                    self.iterations += u64::from(iterations);
                    self.assembly.error(t + h, self.integrator.next(), self.integrator.error())
                }
                None => f64::INFINITY,
            };
            if error.is_nan() || error > 1.0 {
                self.rejected += 1;
                level += if error.is_finite() && error < 16.0 { 1 } else { 2 };
                if level >= FINEST {
                    return None;
                }
                continue;
            }
            self.steps += 1;
            self.slope.copy_from_slice(self.integrator.end_slope());
            self.integrator.accept(&mut self.state);
            self.time = t + h;
            at += size;
            if error < DOUBLED && level > 0 && at.is_multiple_of(whole >> (level - 1)) {
                level -= 1;
            }
        }
        self.level = level + coarser;
        Some(())
    }

    /// Largest change of orbits over their clearances, and of loads and deformation over their largest.
    fn change(&self, before: &[CycleInstant], now: &[CycleInstant]) -> (f64, f64) {
        let (mut orbit, mut load, mut largest) = (0.0f64, 0.0f64, f64::MIN_POSITIVE);
        let (mut shape, mut most) = (0.0f64, f64::MIN_POSITIVE);
        let clearance = |index: usize| {
            let mains = self.train.mains.len();
            let law = match index.checked_sub(mains) {
                None => &self.train.mains[index].law,
                Some(index) => &self.train.cylinders[index].law,
            };
            law.clearance()
        };
        let undeformed = vec![0.0; self.train.body.size()];
        for (a, b) in before.iter().zip(now) {
            let places = |own: &CycleInstant| [own.main_places.clone(), own.pin_places.clone()].concat();
            for (index, (a, b)) in places(a).into_iter().zip(places(b)).enumerate() {
                if let Some(clearance) = clearance(index).filter(|c| *c > 0.0) {
                    orbit = orbit.max(length(plus(a, -1.0, b)) / clearance);
                }
            }
            let forces = |own: &CycleInstant| [own.main_forces.clone(), own.pin_forces.clone()].concat();
            for (a, b) in forces(a).into_iter().zip(forces(b)) {
                load = load.max(length(plus(a, -1.0, b)));
                largest = largest.max(length(b));
            }
            shape = shape.max(self.assembly.deformation(&a.coordinates, &b.coordinates));
            most = most.max(self.assembly.deformation(&b.coordinates, &undeformed));
        }
        (orbit, (load / largest).max(shape / most))
    }
}
