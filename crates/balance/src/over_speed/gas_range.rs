//! Main-bearing loads with gas over a range of speeds, or at speeds of the task.

use crate::answer::Answer;
use crate::error::BalanceError;
use crate::fitted::bare;
use crate::over_speed::gas::{GasOverSpeed, pressures};
use crate::over_speed::places::{GasCycle, GasPeak, SpeedPlaces};
use crate::over_speed::range::{Fitted, OverSpeeds, Worst, criteria, judged, no_gas, steps};
use lanchester_mechanism::{CylinderGas, MainForces};
use lanchester_model::Engine;
use lanchester_numerics::golden_section;
use lanchester_task::{BalanceTask, Criterion, Mains, Statistic};
use num_complex::Complex64;
use std::cell::RefCell;
use std::f64::consts::TAU;

/// A load may pass the value by this share of it.
const EXCESS: f64 = 1e-6;

/// Equal steps of speed that are looked at.
const STEPS: usize = 24;

/// Steps of the golden section about a peak over speed.
const GOLDEN_STEPS: usize = 20;

/// How far from an end of the range it is looked whether the loads rise from there, as a share of the step.
const FROM_END: f64 = 0.38;

/// Peaks that reach this share of the largest are judged from the beginning.
const FIRST: f64 = 0.9;

/// The main-bearing loads with gas that a task asks for, over speed.
pub(crate) struct GasRange<'a> {
    engine: Engine,
    task: &'a BalanceTask,
    gas: &'a dyn GasOverSpeed,
    criteria: Vec<Criterion>,
    /// Speeds that are looked at.
    speeds: Vec<KnownGas>,
    /// Whether what lies between them counts too.
    continuous: bool,
    /// The engine without what the task takes over.
    bare: Engine,
}

/// A speed whose pressures are known.
struct KnownGas {
    /// Speed of crankshaft 1 [rad/s].
    speed: f64,
    /// What loads are multiplied by.
    weight: f64,
    gas: Vec<CylinderGas>,
}

/// Loads at a speed, with its weight.
struct Weighted {
    weight: f64,
    forces: MainForces,
}

impl Weighted {
    fn load(&self, criterion: &Criterion) -> f64 {
        self.weight * load(criterion, &self.forces)
    }
}

impl<'a> GasRange<'a> {
    /// Of an engine whose task asks for loads of main bearings with gas.
    pub fn of(
        engine: &Engine,
        task: &'a BalanceTask,
        gas: Option<&'a dyn GasOverSpeed>,
    ) -> Result<Option<GasRange<'a>>, BalanceError> {
        let criteria = criteria(task, |criterion| matches!(criterion, Criterion::MainsWithGas(..)));
        let Some(first) = criteria.first() else { return Ok(None) };
        let Some(gas) = gas else { return Err(no_gas(engine, first)) };
        let (lowest, highest) = (engine.speed.lowest.min(engine.speed.highest), engine.speed.highest);
        let continuous = task.speeds.is_empty() && lowest < highest;
        let speeds: Vec<(f64, f64)> = match (task.speeds.is_empty(), continuous) {
            (false, _) => task.weighted_speeds(),
            (true, true) => steps(lowest, highest, STEPS).into_iter().map(|speed| (speed, 1.0)).collect(),
            (true, false) => vec![(highest, 1.0)],
        };
        let known = |(speed, weight): (f64, f64)| Ok(KnownGas { speed, weight, gas: pressures(gas, speed)? });
        let speeds = speeds.into_iter().map(known).collect::<Result<_, BalanceError>>()?;
        let bare = bare(engine, task);
        Ok(Some(GasRange { engine: engine.clone(), task, gas, criteria, speeds, continuous, bare }))
    }

    fn period(&self) -> f64 {
        TAU * f64::from(self.bare.strokes.revolutions())
    }

    /// Loads of the main bearings at every speed that is looked at.
    fn forces(&self, engine: &Engine) -> Result<Vec<Weighted>, BalanceError> {
        let of = |known: &KnownGas| {
            let forces = MainForces::new(engine, Some(&known.gas), known.speed)?;
            Ok(Weighted { weight: known.weight, forces })
        };
        self.speeds.iter().map(of).collect()
    }

    /// The largest of each criterion.
    fn worst(&self, forces: &[Weighted]) -> Vec<Worst> {
        let largest = |criterion: &Criterion| {
            let loads =
                forces.iter().map(|one| Worst { load: one.load(criterion), speed: one.forces.speed() });
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
    ) -> Result<Option<(Worst, Weighted)>, BalanceError> {
        let place = self.speeds.iter().position(|known| known.speed == worst.speed).unwrap_or(0);
        let from = self.speeds[place.saturating_sub(1)].speed;
        let to = self.speeds[(place + 1).min(self.speeds.len() - 1)].speed;
        let best: RefCell<Option<(Worst, Weighted)>> = RefCell::new(None);
        let look = |speed: f64| -> Result<f64, BalanceError> {
            let forces = MainForces::new(engine, Some(&pressures(self.gas, speed)?), speed)?;
            let found = load(criterion, &forces);
            let most = best.borrow().as_ref().map_or(worst.load, |best| best.0.load);
            if found > most {
                best.replace(Some((Worst { load: found, speed }, Weighted { weight: 1.0, forces })));
            }
            Ok(found)
        };
        // At an end of the range that is the worst nothing lies beside it, unless the loads rise from there.
        let beside = match worst.speed {
            speed if speed <= from => Some(from + FROM_END * (to - from)),
            speed if speed >= to => Some(to - FROM_END * (to - from)),
            _ => None,
        };
        let falls = beside.map_or(Ok(false), |speed| Ok::<bool, BalanceError>(look(speed)? < worst.load))?;
        if !falls {
            golden_section(from, to, GOLDEN_STEPS, look)?;
        }
        Ok(best.into_inner())
    }

    /// Adds where a criterion reaches `share` of its largest among `forces`.
    fn add(
        &self,
        places: &mut SpeedPlaces,
        criterion: &Criterion,
        forces: &[Weighted],
        share: f64,
    ) -> Result<(), BalanceError> {
        let Criterion::MainsWithGas(statistic, mains) = criterion else { return Ok(()) };
        let loads: Vec<f64> = forces.iter().map(|one| one.load(criterion)).collect();
        let least = share * loads.iter().copied().fold(0.0, f64::max);
        for (Weighted { weight, forces }, _) in forces.iter().zip(&loads).filter(|(_, load)| **load >= least)
        {
            let (speed, weight) = (forces.speed(), *weight);
            let bare = MainForces::new(&self.bare, Some(&pressures(self.gas, speed)?), speed)?;
            if *statistic != Statistic::Peak {
                places.add_cycle(GasCycle::of(&bare, weight));
                continue;
            }
            for main in indices(*mains, forces.count()) {
                let peak = forces.peak(main);
                if weight * peak.value >= least {
                    let force = bare.at(main, peak.theta);
                    places.add_peak(GasPeak { main, speed, weight, theta: peak.theta, force }, self.period());
                }
            }
        }
        Ok(())
    }
}

/// Which share of the largest is judged from the beginning: a mean is a sum of many amounts at every speed.
fn first(criterion: &Criterion) -> f64 {
    if matches!(criterion, Criterion::MainsWithGas(Statistic::Mean, _)) { 1.0 } else { FIRST }
}

impl OverSpeeds for GasRange<'_> {
    fn criteria(&self) -> &[Criterion] {
        &self.criteria
    }

    fn begin(&self, places: &mut SpeedPlaces) -> Result<(), BalanceError> {
        for forces in [self.forces(&self.engine)?, self.forces(&self.bare)?] {
            for criterion in &self.criteria {
                self.add(places, criterion, &forces, first(criterion))?;
            }
        }
        Ok(())
    }

    fn largest(&self, of: &Fitted) -> Result<Vec<Worst>, BalanceError> {
        Ok(self.worst(&self.forces(&of.engine)?))
    }

    fn look(
        &self,
        of: &Fitted,
        values: &[Option<f64>],
        places: &mut SpeedPlaces,
    ) -> Result<Vec<Worst>, BalanceError> {
        let forces = self.forces(&of.engine)?;
        let mut found = self.worst(&forces);
        for ((criterion, worst), value) in self.criteria.iter().zip(&mut found).zip(values) {
            let value = value.unwrap_or(worst.load);
            let most = value * (1.0 + EXCESS);
            if worst.load > most {
                self.add(places, criterion, &forces, most / worst.load)?;
            } else if self.continuous
                && let Some((fine, there)) = self.refined(criterion, &of.engine, worst)?
            {
                // Between the speeds that are looked at.
                if fine.load > most {
                    self.add(places, criterion, &[there], most / fine.load)?;
                }
                *worst = fine;
            }
        }
        Ok(found)
    }

    fn tell(&self, answer: &mut Answer, places: &SpeedPlaces, worst: &[Worst], excess: &[f64]) {
        let peaks = places.peaks.iter().map(|peak| peak.speed);
        let speeds = peaks.chain(places.cycles.iter().map(|cycle| cycle.speed)).collect();
        answer.gas_speeds = judged(speeds, self.task, worst, excess, |_| true);
    }

    fn join(
        &self,
        places: &mut SpeedPlaces,
        found: &SpeedPlaces,
        _: &Fitted,
        _: &Criterion,
    ) -> Result<(), BalanceError> {
        found.peaks.iter().for_each(|peak| places.add_peak(*peak, self.period()));
        found.cycles.iter().for_each(|cycle| places.add_cycle(cycle.clone()));
        Ok(())
    }
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
