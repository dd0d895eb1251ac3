//! Main-bearing loads with gas over a range of speeds: the worst speed and angle of each answer join those that the programme
//! judges.
//!
//! Any set of places (bearing, speed, angle) gives a lower bound of what the range allows. After each optimum the largest
//! loads over the whole range are looked for, and their places join the set until nothing passes the value by
//! more than [`EXCESS`].

use crate::answer::{Answer, JudgedSpeeds};
use crate::error::BalanceError;
use crate::fitted::{bare, fitted};
use crate::gas_places::{GasCycle, GasPeak, GasPlaces};
use crate::problem::stages;
use crate::speed_range::{raise, steps};
use lanchester_mechanism::{CylinderGas, MainForces};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Mains, Stage, Statistic};
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::rc::Rc;

/// The pressures on all pistons of an engine at any speed.
pub trait GasOverSpeed {
    /// One entry a cylinder, at a speed of crankshaft 1 [rad/s].
    ///
    /// # Errors
    /// Why there are none, in words.
    fn at(&self, speed: f64) -> Result<Vec<CylinderGas>, String>;
}

/// A load may pass the value by this share of it.
const EXCESS: f64 = 1e-6;

/// Most rounds; what is left then is told.
const MOST_ROUNDS: usize = 16;

/// Equal steps of speed that are looked at.
const STEPS: usize = 24;

/// Steps of the golden section about a peak over speed.
const GOLDEN_STEPS: usize = 20;

/// Peaks that reach this share of the largest are judged from the beginning.
const FIRST: f64 = 0.9;

/// What solves a task whose loads with gas are judged at given places.
pub(crate) type SolveAt<'a> = &'a dyn Fn(&BalanceTask, &Rc<GasPlaces>) -> Result<Answer, BalanceError>;

/// Solves `task` by `solve` with the places at which its main-bearing loads with gas have to be judged.
pub(crate) fn with_gas(
    engine: &Engine,
    task: &BalanceTask,
    gas: Option<&dyn GasOverSpeed>,
    solve: SolveAt<'_>,
) -> Result<Answer, BalanceError> {
    let criteria = criteria(task);
    let Some(first) = criteria.first() else { return solve(task, &Rc::default()) };
    let Some(gas) = gas else { return Err(no_gas(engine, first)) };
    let range = GasRange::of(engine, task, gas, criteria)?;
    range.exchange(engine, task, solve).map(|found| found.0)
}

fn no_gas(engine: &Engine, criterion: &Criterion) -> BalanceError {
    BalanceError::Missing {
        criterion: lanchester_task::criterion_name(criterion, engine),
        needed: "the pressures of the cylinders",
        hint: "add [gas] to the engine file, or leave \"with gas\" out",
    }
}

/// The criteria of a task that count the gas, each once.
fn criteria(task: &BalanceTask) -> Vec<Criterion> {
    let stages = stages(task);
    let asked = stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    let mut criteria: Vec<Criterion> = Vec::new();
    for criterion in asked.chain(task.limits.iter().map(|limit| limit.criterion)) {
        if matches!(criterion, Criterion::MainsWithGas(..)) && !criteria.contains(&criterion) {
            criteria.push(criterion);
        }
    }
    criteria
}

/// The largest of a criterion over the speeds.
#[derive(Debug, Clone, Copy, Default)]
struct Worst {
    load: f64,
    speed: f64,
}

/// An engine whose gas is known over a range of speeds.
struct GasRange<'a> {
    gas: &'a dyn GasOverSpeed,
    criteria: Vec<Criterion>,
    /// Speeds that are looked at [rad/s], with their pressures.
    speeds: Vec<(f64, Vec<CylinderGas>)>,
    /// Whether what lies between them counts too.
    continuous: bool,
    /// The engine without what the task takes over.
    bare: Engine,
}

impl GasRange<'_> {
    fn of<'a>(
        engine: &Engine,
        task: &BalanceTask,
        gas: &'a dyn GasOverSpeed,
        criteria: Vec<Criterion>,
    ) -> Result<GasRange<'a>, BalanceError> {
        let (lowest, highest) = (engine.speed.lowest.min(engine.speed.highest), engine.speed.highest);
        let continuous = task.speeds.is_empty() && lowest < highest;
        let speeds = match (task.speeds.is_empty(), continuous) {
            (false, _) => task.speeds.clone(),
            (true, true) => steps(lowest, highest, STEPS),
            (true, false) => vec![highest],
        };
        if speeds.len() > 1 {
            let mean = criteria.iter().find(|one| matches!(one, Criterion::MainsWithGas(Statistic::Mean, _)));
            if let Some(mean) = mean {
                return Err(BalanceError::Missing {
                    criterion: lanchester_task::criterion_name(mean, engine),
                    needed: "one speed",
                    hint: "give it by `speeds` or --speed; over a range of speeds ask for the root mean square or the peak",
                });
            }
        }
        let known = |speed: f64| Ok((speed, at(gas, speed)?));
        let speeds = speeds.into_iter().map(known).collect::<Result<_, BalanceError>>()?;
        Ok(GasRange { gas, criteria, speeds, continuous, bare: bare(engine, task) })
    }

    /// Optimum after optimum until no place of the range passes the value; also where they were judged.
    fn exchange(
        &self,
        engine: &Engine,
        task: &BalanceTask,
        solve: SolveAt<'_>,
    ) -> Result<(Answer, GasPlaces), BalanceError> {
        let mut places = GasPlaces::default();
        let standing = self.forces(engine)?;
        let bare = self.forces(&self.bare)?;
        let before = self.worst(&standing);
        let without = self.worst(&bare);
        for criterion in &self.criteria {
            self.add(&mut places, criterion, &standing, FIRST)?;
            self.add(&mut places, criterion, &bare, FIRST)?;
        }
        let (mut round, mut sought) = (0, false);
        loop {
            round += 1;
            let mut answer = solve(task, &Rc::new(places.clone()))?;
            if answer.stages.is_empty() {
                // How far limits are from holding is known where the places that decide about them are.
                if !sought && task.limits.iter().any(|limit| self.criteria.contains(&limit.criterion)) {
                    sought = true;
                    for limit in task.limits.iter().filter(|l| self.criteria.contains(&l.criterion)) {
                        let stages = vec![Stage { terms: vec![(1.0, limit.criterion)] }];
                        let alone = BalanceTask { stages, limits: Vec::new(), ..task.clone() };
                        let alone_places = self.exchange(engine, &alone, solve)?.1;
                        join(&mut places, alone_places, self.period());
                    }
                    continue;
                }
                answer.task = task.clone();
                return Ok((answer, places));
            }
            let fitted = fitted(engine, &answer);
            let forces = self.forces(&fitted)?;
            let after = self.worst(&forces);
            let (mut excess, mut worst) = (0.0f64, None);
            let known = places.clone();
            for (criterion, after) in self.criteria.iter().zip(&after) {
                worst.get_or_insert(after.speed);
                let effect = answer.effects.iter().find(|effect| effect.criterion == *criterion);
                let value = effect.map_or(after.load, |effect| effect.after);
                if after.load > value * (1.0 + EXCESS) {
                    excess = excess.max((after.load - value) / value.max(f64::MIN_POSITIVE));
                    self.add(&mut places, criterion, &forces, value * (1.0 + EXCESS) / after.load)?;
                } else if self.continuous {
                    // Between the speeds that are looked at.
                    let (fine, there) = self.refined(criterion, &fitted, after)?;
                    if fine.load > value * (1.0 + EXCESS) {
                        excess = excess.max((fine.load - value) / value.max(f64::MIN_POSITIVE));
                        let share = value * (1.0 + EXCESS) / fine.load;
                        self.add(&mut places, criterion, std::slice::from_ref(&there), share)?;
                    }
                }
            }
            if places == known || round == MOST_ROUNDS {
                let mut judged: Vec<f64> = places.peaks.iter().map(|peak| peak.speed).collect();
                judged.extend(places.cycles.iter().map(|cycle| cycle.speed));
                judged.sort_by(f64::total_cmp);
                judged.dedup();
                let worst = worst.unwrap_or(engine.speed.highest);
                answer.gas_speeds =
                    Some(JudgedSpeeds { judged, worst, excess, range: task.speeds.is_empty() });
                for (place, criterion) in self.criteria.iter().enumerate() {
                    let own = answer.effects.iter_mut().filter(|effect| effect.criterion == *criterion);
                    for effect in own {
                        effect.before = before[place].load;
                        effect.without = without[place].load;
                        effect.after = effect.after.max(after[place].load);
                    }
                }
                raise(&mut answer, &self.criteria);
                answer.task = task.clone();
                return Ok((answer, places));
            }
        }
    }

    fn period(&self) -> f64 {
        TAU * f64::from(self.bare.strokes.revolutions())
    }

    /// Loads of the main bearings at every speed that is looked at.
    fn forces(&self, engine: &Engine) -> Result<Vec<MainForces>, BalanceError> {
        let of = |(speed, gas): &(f64, Vec<CylinderGas>)| Ok(MainForces::new(engine, Some(gas), *speed)?);
        self.speeds.iter().map(of).collect()
    }

    /// The largest of each criterion.
    fn worst(&self, forces: &[MainForces]) -> Vec<Worst> {
        let largest = |criterion: &Criterion| {
            let loads = forces.iter().map(|one| Worst { load: load(criterion, one), speed: one.speed() });
            loads.max_by(|a, b| a.load.total_cmp(&b.load)).unwrap_or_default()
        };
        self.criteria.iter().map(largest).collect()
    }

    /// The largest beside the worst speed, between its neighbours, and the loads there.
    fn refined(
        &self,
        criterion: &Criterion,
        engine: &Engine,
        worst: &Worst,
    ) -> Result<(Worst, MainForces), BalanceError> {
        let place = self.speeds.iter().position(|known| known.0 == worst.speed).unwrap_or(0);
        let forces_at = |speed: f64| -> Result<MainForces, BalanceError> {
            Ok(MainForces::new(engine, Some(&at(self.gas, speed)?), speed)?)
        };
        let mut best = (*worst, forces_at(worst.speed)?);
        let mut from = self.speeds[place.saturating_sub(1)].0;
        let mut to = self.speeds[(place + 1).min(self.speeds.len() - 1)].0;
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let mut look = |speed: f64| -> Result<f64, BalanceError> {
            let forces = forces_at(speed)?;
            let found = load(criterion, &forces);
            if found > best.0.load {
                best = (Worst { load: found, speed }, forces);
            }
            Ok(found)
        };
        let (mut left, mut right) = (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
        let (mut at_left, mut at_right) = (look(left)?, look(right)?);
        for step in 0..GOLDEN_STEPS {
            // At an end of the range that is the worst nothing lies beside it.
            if step == 1 && best_is_end(worst, from, to) && at_left.max(at_right) < worst.load {
                break;
            }
            if at_left >= at_right {
                (to, right, at_right) = (right, left, at_left);
                left = to - GOLDEN * (to - from);
                at_left = look(left)?;
            } else {
                (from, left, at_left) = (left, right, at_right);
                right = from + GOLDEN * (to - from);
                at_right = look(right)?;
            }
        }
        Ok(best)
    }

    /// Adds where a criterion reaches `share` of its largest among `forces`.
    fn add(
        &self,
        places: &mut GasPlaces,
        criterion: &Criterion,
        forces: &[MainForces],
        share: f64,
    ) -> Result<(), BalanceError> {
        let Criterion::MainsWithGas(statistic, mains) = criterion else { return Ok(()) };
        let loads: Vec<f64> = forces.iter().map(|one| load(criterion, one)).collect();
        let least = share * loads.iter().copied().fold(0.0, f64::max);
        for (forces, _) in forces.iter().zip(&loads).filter(|(_, load)| **load >= least) {
            let speed = forces.speed();
            let bare = MainForces::new(&self.bare, Some(&at(self.gas, speed)?), speed)?;
            if *statistic != Statistic::Peak {
                if places.cycles.iter().all(|cycle| cycle.speed != speed) {
                    places.cycles.push(GasCycle::of(&bare));
                }
                continue;
            }
            for main in indices(*mains, forces.count()) {
                let peak = forces.peak(main);
                if peak.value < least {
                    continue;
                }
                let new = GasPeak { main, speed, theta: peak.theta, force: bare.at(main, peak.theta) };
                if places.peaks.iter().all(|known| !known.is(&new, self.period())) {
                    places.peaks.push(new);
                }
            }
        }
        Ok(())
    }
}

fn best_is_end(worst: &Worst, from: f64, to: f64) -> bool {
    worst.speed <= from || worst.speed >= to
}

fn at(gas: &dyn GasOverSpeed, speed: f64) -> Result<Vec<CylinderGas>, BalanceError> {
    gas.at(speed).map_err(|reason| BalanceError::Gas { reason })
}

/// The main bearings that count.
pub(crate) fn indices(mains: Mains, count: usize) -> Vec<usize> {
    match mains {
        Mains::One(index) => vec![index],
        Mains::All | Mains::Largest => (0..count).collect(),
    }
}

/// A criterion at one speed.
fn load(criterion: &Criterion, forces: &MainForces) -> f64 {
    let Criterion::MainsWithGas(statistic, mains) = criterion else { return 0.0 };
    let indices = indices(*mains, forces.count());
    let nodes = if *statistic == Statistic::Peak { Vec::new() } else { forces.nodes() };
    let mean = |main: usize, of: fn(&Complex64) -> f64| {
        let loads = forces.at_nodes(main, &nodes);
        nodes.iter().zip(&loads).map(|(node, load)| node.1 * of(load)).sum::<f64>()
    };
    let square = |main: &usize| mean(*main, Complex64::norm_sqr);
    match (statistic, mains) {
        (Statistic::Peak, _) => indices.iter().map(|main| forces.peak(*main).value).fold(0.0, f64::max),
        (Statistic::Rms, Mains::Largest) => indices.iter().map(square).fold(0.0, f64::max).sqrt(),
        (Statistic::Rms, _) => (indices.iter().map(square).sum::<f64>() / indices.len() as f64).sqrt(),
        (Statistic::Mean, _) => {
            indices.iter().map(|main| mean(*main, |load| load.norm())).sum::<f64>() / indices.len() as f64
        }
    }
}

/// Adds places that are not yet known.
fn join(places: &mut GasPlaces, other: GasPlaces, period: f64) {
    for peak in other.peaks {
        if places.peaks.iter().all(|known| !known.is(&peak, period)) {
            places.peaks.push(peak);
        }
    }
    for cycle in other.cycles {
        if places.cycles.iter().all(|known| known.speed != cycle.speed) {
            places.cycles.push(cycle);
        }
    }
}
