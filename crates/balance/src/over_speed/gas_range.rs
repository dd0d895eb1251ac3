//! Main-bearing loads with gas over a range of speeds, or at speeds of the task.

use crate::answer::Answer;
use crate::error::BalanceError;
use crate::fitted::bare;
use crate::over_speed::criteria::{criteria, indices};
use crate::over_speed::gas::{GasOverSpeed, parts, pressures};
use crate::over_speed::kind::{Fitted, OverSpeeds, Worst, judged, no_gas, steps};
use crate::over_speed::places::{GasCycle, GasPeak, SpeedPlaces};
use lanchester_mechanism::{MainForces, MainGas, MainInertia};
use lanchester_model::Engine;
use lanchester_numerics::golden_section;
use lanchester_task::{BalanceTask, Criterion, Mains, Statistic};
use num_complex::Complex64;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A load may pass the value by this share of it.
const EXCESS: f64 = 1e-6;

/// Equal steps of speed that are looked at.
const STEPS: usize = 24;

/// Steps of the golden section about a peak over speed.
const GOLDEN_STEPS: usize = 20;

/// How far from an end of the range it is looked whether the loads rise from there, as a share of the step.
const FROM_END: f64 = 0.38;

/// Between two angles a load is at most this much larger: what reaches less than this share of the largest at equal angles is no peak of all.
const CANDIDATE: f64 = 0.95;

/// Peaks that reach this share of the largest are judged from the beginning.
const FIRST: f64 = 0.9;

/// The main-bearing loads with gas that a task asks for, over speed.
pub(crate) struct GasRange<'a> {
    engine: Engine,
    task: &'a BalanceTask,
    gas: &'a dyn GasOverSpeed,
    criteria: Vec<Criterion>,
    /// Speeds of crankshaft 1 that are looked at [rad/s], with what loads there are multiplied by.
    speeds: Vec<(f64, f64)>,
    /// Whether what lies between them counts too.
    continuous: bool,
    /// The engine without what the task takes over.
    bare: Engine,
    /// Its main-bearing loads of inertia.
    bare_inertia: Arc<MainInertia>,
    /// Speeds between which the pressures are linear.
    knots: Vec<f64>,
    /// Main-bearing loads of gas, by the bits of the speed.
    loads: RefCell<BTreeMap<u64, Arc<MainGas>>>,
}

/// Loads at a speed, with its weight.
struct Weighted {
    weight: f64,
    forces: MainForces,
}

/// A criterion at every speed. A peak that no angle brings near the largest of all speeds is not looked for between the angles.
fn loads(criterion: &Criterion, at: &[Weighted]) -> Vec<f64> {
    let Criterion::MainsWithGas(Statistic::Peak, mains) = criterion else {
        return at.iter().map(|one| one.weight * load(criterion, &one.forces)).collect();
    };
    let sampled = |one: &Weighted| one.weight * largest_sample(*mains, &one.forces);
    let sampled: Vec<f64> = at.iter().map(sampled).collect();
    let near = CANDIDATE * sampled.iter().copied().fold(0.0, f64::max);
    let of = |(one, sampled): (&Weighted, f64)| match sampled < near {
        true => sampled,
        false => one.weight * load(criterion, &one.forces),
    };
    at.iter().zip(sampled).map(of).collect()
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
        let bare = bare(engine, task);
        Ok(Some(GasRange {
            engine: engine.clone(),
            task,
            gas,
            criteria,
            speeds,
            continuous,
            bare_inertia: Arc::new(MainInertia::new(&bare)?),
            bare,
            knots: gas.knots(),
            loads: RefCell::default(),
        }))
    }

    fn period(&self) -> f64 {
        TAU * f64::from(self.bare.strokes.revolutions())
    }

    /// Loads of the main bearings of gas at a speed at which pressures are known.
    fn gas_loads(&self, speed: f64) -> Result<Arc<MainGas>, BalanceError> {
        if let Some(known) = self.loads.borrow().get(&speed.to_bits()) {
            return Ok(Arc::clone(known));
        }
        let found = Arc::new(MainGas::new(&self.bare, &pressures(self.gas, speed)?)?);
        self.loads.borrow_mut().insert(speed.to_bits(), Arc::clone(&found));
        Ok(found)
    }

    /// Loads of the main bearings at a speed.
    fn forces_at(&self, inertia: &Arc<MainInertia>, speed: f64) -> Result<MainForces, BalanceError> {
        let of = |(share, knot): (f64, f64)| Ok((share, self.gas_loads(knot)?));
        let gas = parts(&self.knots, speed).into_iter().map(of).collect::<Result<_, BalanceError>>()?;
        Ok(MainForces::of(Arc::clone(inertia), gas, speed))
    }

    /// Loads of the main bearings at every speed that is looked at.
    fn forces(&self, inertia: &Arc<MainInertia>) -> Result<Vec<Weighted>, BalanceError> {
        let of =
            |&(speed, weight): &(f64, f64)| Ok(Weighted { weight, forces: self.forces_at(inertia, speed)? });
        self.speeds.iter().map(of).collect()
    }

    /// The largest of each criterion.
    fn worst(&self, forces: &[Weighted]) -> Vec<Worst> {
        let largest = |criterion: &Criterion| {
            let loads = loads(criterion, forces).into_iter().zip(forces);
            let loads = loads.map(|(load, one)| Worst { load, speed: one.forces.speed() });
            loads.max_by(|a, b| a.load.total_cmp(&b.load)).unwrap_or_default()
        };
        self.criteria.iter().map(largest).collect()
    }

    /// The largest beside the worst speed, between its neighbours, and the loads there.
    fn refined(
        &self,
        criterion: &Criterion,
        inertia: &Arc<MainInertia>,
        worst: &Worst,
    ) -> Result<Option<(Worst, Weighted)>, BalanceError> {
        let place = self.speeds.iter().position(|known| known.0 == worst.speed).unwrap_or(0);
        let from = self.speeds[place.saturating_sub(1)].0;
        let to = self.speeds[(place + 1).min(self.speeds.len() - 1)].0;
        let best: RefCell<Option<(Worst, Weighted)>> = RefCell::new(None);
        let look = |speed: f64| -> Result<f64, BalanceError> {
            let forces = self.forces_at(inertia, speed)?;
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
        let loads = loads(criterion, forces);
        let least = share * loads.iter().copied().fold(0.0, f64::max);
        for (Weighted { weight, forces }, _) in forces.iter().zip(&loads).filter(|(_, load)| **load >= least)
        {
            let (speed, weight) = (forces.speed(), *weight);
            let bare = self.forces_at(&self.bare_inertia, speed)?;
            if *statistic != Statistic::Peak {
                places.add_cycle(GasCycle::of(&bare, weight));
                continue;
            }
            for main in indices(*mains, forces.count()) {
                if weight * forces.largest_sample(main) < CANDIDATE * least {
                    continue;
                }
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
        let own = Arc::new(MainInertia::new(&self.engine)?);
        for forces in [self.forces(&own)?, self.forces(&self.bare_inertia)?] {
            for criterion in &self.criteria {
                self.add(places, criterion, &forces, first(criterion))?;
            }
        }
        Ok(())
    }

    fn largest(&self, of: &Fitted) -> Result<Vec<Worst>, BalanceError> {
        Ok(self.worst(&self.forces(&Arc::new(MainInertia::new(&of.engine)?))?))
    }

    fn look(
        &self,
        of: &Fitted,
        values: &[Option<f64>],
        places: &mut SpeedPlaces,
    ) -> Result<Vec<Worst>, BalanceError> {
        let inertia = Arc::new(MainInertia::new(&of.engine)?);
        let forces = self.forces(&inertia)?;
        let mut found = self.worst(&forces);
        for ((criterion, worst), value) in self.criteria.iter().zip(&mut found).zip(values) {
            let value = value.unwrap_or(worst.load);
            let most = value * (1.0 + EXCESS);
            if worst.load > most {
                self.add(places, criterion, &forces, most / worst.load)?;
            } else if self.continuous
                && let Some((fine, there)) = self.refined(criterion, &inertia, worst)?
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

/// Largest load of the mains that count at equal angles.
fn largest_sample(mains: Mains, forces: &MainForces) -> f64 {
    indices(mains, forces.count()).into_iter().map(|main| forces.largest_sample(main)).fold(0.0, f64::max)
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
        (Statistic::Peak, _) => {
            let near = CANDIDATE * largest_sample(*mains, forces);
            let near = indices.iter().filter(|main| forces.largest_sample(**main) >= near);
            near.map(|main| forces.peak(*main).value).fold(0.0, f64::max)
        }
        (Statistic::Rms, Mains::Largest) => indices.iter().map(square).fold(0.0, f64::max).sqrt(),
        (Statistic::Rms, _) => (indices.iter().map(square).sum::<f64>() / indices.len() as f64).sqrt(),
        (Statistic::Mean, _) => {
            indices.iter().map(|main| mean(*main, |load| load.norm())).sum::<f64>() / indices.len() as f64
        }
    }
}
