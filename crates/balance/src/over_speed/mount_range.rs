//! Forces at mounts with springs over a range of speeds, of inertia alone or with the torque of the gas.
//!
//! ```text
//! F_k(theta, W) = SUM over orders of  T_k(n W) ( W^2 L_n + G_n(W) e_z ) e^{i n theta}
//! L_n: load of order n at 1 rad/s, affine in the devices      G_n: roll moment of the gas
//! minimise max over mounts k, speeds W of a set, angles theta of |F_k|
//! ```
//! The set begins with both ends, the worst speeds of the engine as it stands and steps between.

use crate::answer::Answer;
use crate::convex::curve::Member;
use crate::criterion::order_key;
use crate::error::BalanceError;
use crate::mounts::on_springs;
use crate::operator::{EngineLoads, Operator};
use crate::over_speed::gas::{GasOverSpeed, GasRoll, GasRolls};
use crate::over_speed::places::{MountPlace, SpeedPlaces};
use crate::over_speed::range::{Fitted, OverSpeeds, Worst, criteria, judged, no_gas, steps};
use crate::wave::{Wave, curve};
use lanchester_mechanism::{Kinematics, MountSystem};
use lanchester_model::Engine;
use lanchester_numerics::golden_section;
use lanchester_task::{BalanceTask, Criterion, FreeInertia, Load};
use std::collections::BTreeSet;
use std::rc::Rc;

/// A speed may pass the value by this share of it.
const EXCESS: f64 = 5e-9;

/// Equal steps of the first set, and of the search.
const FIRST_STEPS: usize = 4;
const SEARCH_STEPS: usize = 240;

/// Places about a resonance that are looked at, in shares of its half width.
const ABOUT: [f64; 9] = [-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0];

/// Speeds closer than this share of the highest are one.
const SAME: f64 = 1e-6;

/// Steps of the golden section about a peak over speed.
const GOLDEN_STEPS: usize = 24;

/// Peaks over speed that reach this share of the highest are refined, and how many of them at most.
const NEARLY: f64 = 0.97;
const REFINED: usize = 8;

/// The forces at the mounts that a task asks for, over speed.
pub(crate) struct MountRange<'a> {
    engine: Engine,
    task: &'a BalanceTask,
    criteria: Vec<Criterion>,
    kinematics: Kinematics,
    gas: Option<GasRolls<'a>>,
}

impl<'a> MountRange<'a> {
    /// Of an engine on springs whose task asks for forces at mounts.
    pub fn of(
        engine: &Engine,
        task: &'a BalanceTask,
        kinematics: Kinematics,
        gas: Option<&'a dyn GasOverSpeed>,
    ) -> Result<Option<MountRange<'a>>, BalanceError> {
        let criteria = criteria(task, |criterion| load(criterion).is_some());
        if criteria.is_empty() || !engine.is_on_springs() {
            return Ok(None);
        }
        let with_gas = criteria.iter().find(|criterion| criterion.counts_gas());
        let gas = match (with_gas, gas) {
            (Some(criterion), None) => return Err(no_gas(engine, criterion)),
            (Some(_), Some(gas)) => Some(GasRolls::of(engine, gas)?),
            (None, _) => None,
        };
        Ok(Some(MountRange { engine: engine.clone(), task, criteria, kinematics, gas }))
    }

    fn forces(&self, of: &Fitted) -> Result<RangeForces<'_>, BalanceError> {
        RangeForces::of(of, self)
    }

    /// The period and the orders of the gas, and no place.
    fn no_place(&self) -> SpeedPlaces {
        let of_gas = self.gas.as_ref().map(|gas| (gas.revolutions, gas.highest));
        let (revolutions, highest_order) = of_gas.unwrap_or_default();
        SpeedPlaces { revolutions, highest_order, ..SpeedPlaces::default() }
    }

    /// Adds a speed that is further than `same` from all others.
    fn add(&self, places: &mut SpeedPlaces, speed: f64, same: f64) -> Result<(), BalanceError> {
        if !places.mounts.iter().any(|known| (known.speed - speed).abs() <= same) {
            places.mounts.push(self.place(speed, 1.0)?);
        }
        Ok(())
    }

    /// A speed with its weight and, where it counts, its gas.
    fn place(&self, speed: f64, weight: f64) -> Result<MountPlace, BalanceError> {
        let gas = self.gas.as_ref().map_or_else(|| Ok(Rc::default()), |gas| gas.at(speed))?;
        Ok(MountPlace { speed, weight, gas })
    }
}

impl OverSpeeds for MountRange<'_> {
    fn criteria(&self) -> &[Criterion] {
        &self.criteria
    }

    fn begin(&self, places: &mut SpeedPlaces) -> Result<(), BalanceError> {
        let SpeedPlaces { revolutions, highest_order, .. } = self.no_place();
        (places.revolutions, places.highest_order) = (revolutions, highest_order);
        let speeds = match self.task.speeds.is_empty() {
            true => {
                let standing = Fitted::from(self.engine.clone());
                let speeds = self.forces(&standing)?.first_speeds(&self.criteria)?;
                speeds.into_iter().map(|speed| (speed, 1.0)).collect()
            }
            false => self.task.weighted_speeds(),
        };
        for (speed, weight) in speeds {
            places.mounts.push(self.place(speed, weight)?);
        }
        Ok(())
    }

    fn largest(&self, of: &Fitted) -> Result<Vec<Worst>, BalanceError> {
        let forces = self.forces(of)?;
        let first = |criterion| Ok(forces.peaks(criterion)?.first().copied().unwrap_or_default());
        self.criteria.iter().map(|criterion| first(*criterion)).collect()
    }

    fn look(
        &self,
        of: &Fitted,
        values: &[Option<f64>],
        places: &mut SpeedPlaces,
    ) -> Result<Vec<Worst>, BalanceError> {
        let forces = self.forces(of)?;
        let mut worst = Vec::new();
        for (criterion, value) in self.criteria.iter().zip(values) {
            let peaks = forces.peaks(*criterion)?;
            let largest = peaks.first().copied().unwrap_or_default();
            let value = value.unwrap_or(largest.load);
            // What is rounding of the loads of the whole engine passes nothing.
            let most = value + EXCESS * value.max(1e-6 * forces.operator.natural_force);
            for peak in peaks.iter().filter(|peak| peak.load > most) {
                if self.task.speeds.is_empty() {
                    self.add(places, peak.speed, SAME * self.engine.speed.highest)?;
                }
            }
            worst.push(largest);
        }
        Ok(worst)
    }

    fn tell(&self, answer: &mut Answer, places: &SpeedPlaces, worst: &[Worst], excess: &[f64]) {
        let speeds = || places.mounts.iter().map(|place| place.speed).collect();
        let gas = |place: usize| self.criteria[place].counts_gas();
        answer.mount_speeds = judged(speeds(), self.task, worst, excess, |place| !gas(place));
        answer.mount_gas_speeds = judged(speeds(), self.task, worst, excess, gas);
    }

    fn join(
        &self,
        places: &mut SpeedPlaces,
        _: &SpeedPlaces,
        least: &Fitted,
        criterion: &Criterion,
    ) -> Result<(), BalanceError> {
        if self.task.speeds.is_empty() && self.criteria.contains(criterion) {
            // What lies close together is one: rows that are nearly equal leave the solver without a scale.
            let same = 10.0 * SAME * self.engine.speed.highest;
            for peak in self.forces(least)?.peaks(*criterion)? {
                self.add(places, peak.speed, same)?;
            }
        }
        Ok(())
    }
}

/// The load of a criterion about forces at mounts, and its order.
fn load(criterion: &Criterion) -> Option<(Load, Option<f64>)> {
    match criterion {
        Criterion::Peak(load) if load.is_at_mounts() => Some((*load, None)),
        Criterion::Order(load, order) if load.is_at_mounts() => Some((*load, Some(*order))),
        _ => None,
    }
}

/// Forces at the mounts of an engine without free devices, at any speed.
struct RangeForces<'a> {
    range: &'a MountRange<'a>,
    system: MountSystem,
    operator: Operator,
    inertia_share: f64,
    /// Speeds to look at with their weights, rising [rad/s].
    places: Vec<(f64, f64)>,
    /// Whether what lies between them counts too.
    continuous: bool,
}

impl RangeForces<'_> {
    /// Over the range of the engine, or at the speeds of the task alone.
    fn of<'a>(of: &Fitted, range: &'a MountRange<'a>) -> Result<RangeForces<'a>, BalanceError> {
        let Fitted { engine, inertia_share } = of;
        let system = MountSystem::new(engine)?;
        // A unit of it is the whole torque.
        let inertia =
            FreeInertia { name: String::new(), ratio: 1.0, crank_inertia: 1.0, most: None, optional: false };
        let inertias = if *inertia_share > 0.0 { vec![inertia] } else { Vec::new() };
        let task = BalanceTask { inertias, ..BalanceTask::default() };
        let (lowest, highest) = (engine.speed.lowest.min(engine.speed.highest), engine.speed.highest);
        let loads = EngineLoads::of(engine, range.kinematics)?.judged_at(&Rc::new(range.no_place()));
        let operator = Operator::with(&loads, engine, &task, &[], &[])?;
        let mut forces = RangeForces {
            range,
            system,
            operator,
            inertia_share: *inertia_share,
            places: range.task.weighted_speeds(),
            continuous: false,
        };
        if forces.places.is_empty() {
            forces.places = forces.to_look_at(lowest, highest)?;
            forces.continuous = lowest < highest;
        }
        Ok(forces)
    }

    /// Steps over the range and places about every resonance.
    fn to_look_at(&self, lowest: f64, highest: f64) -> Result<Vec<(f64, f64)>, BalanceError> {
        let revolutions = f64::from(self.operator.grid.revolutions);
        let ends = [self.range.place(lowest, 1.0)?, self.range.place(highest, 1.0)?];
        let of_gas = ends.iter().flat_map(|place| &place.gas.orders);
        let keys: BTreeSet<u32> = self
            .operator
            .channels
            .iter()
            .flat_map(|wave| wave.base.keys().copied())
            .chain(of_gas.map(|(order, _)| (order * revolutions).round() as u32))
            .filter(|key| *key > 0)
            .collect();
        let mut places = steps(lowest, highest, SEARCH_STEPS);
        for mode in self.system.modes()?.damped {
            let frequency = mode.root.im.abs();
            for key in &keys {
                let speed = frequency * revolutions / f64::from(*key);
                let half_width = mode.damping_ratio.min(0.5) * speed;
                places.extend(ABOUT.iter().map(|about| speed + about * half_width));
            }
        }
        places.retain(|speed| *speed >= lowest && *speed <= highest);
        thin(&mut places, 1e-6 * highest);
        Ok(places.into_iter().map(|speed| (speed, 1.0)).collect())
    }

    /// Where a programme judges to begin with.
    fn first_speeds(&self, criteria: &[Criterion]) -> Result<Vec<f64>, BalanceError> {
        let (Some(&(lowest, _)), Some(&(highest, _))) = (self.places.first(), self.places.last()) else {
            return Ok(Vec::new());
        };
        let mut speeds = steps(lowest, highest, if lowest < highest { FIRST_STEPS } else { 0 });
        for criterion in criteria {
            let peaks = self.peaks(*criterion)?.into_iter().map(|peak| peak.speed);
            speeds.extend(peaks.filter(|speed| highest - speed > 2e-3 * highest));
        }
        thin(&mut speeds, 2e-3 * highest);
        Ok(speeds)
    }

    /// Peaks over speed of a criterion that are nearly as high as the highest, the highest first.
    fn peaks(&self, criterion: Criterion) -> Result<Vec<Worst>, BalanceError> {
        // No force is larger than its orders together: most speeds need no look at their angles.
        let reach: Vec<f64> =
            self.places.iter().map(|place| self.reach(criterion, *place)).collect::<Result<_, _>>()?;
        let mut order: Vec<usize> = (0..reach.len()).collect();
        order.sort_by(|a, b| reach[*b].total_cmp(&reach[*a]));
        let mut forces: Vec<Option<f64>> = vec![None; reach.len()];
        let mut highest = 0.0f64;
        for place in order {
            if reach[place] < NEARLY * highest {
                break;
            }
            let force = self.force(criterion, self.places[place])?;
            highest = highest.max(force);
            forces[place] = Some(force);
        }
        let at = |place: Option<usize>| {
            place.and_then(|place| forces.get(place).copied().flatten()).unwrap_or(0.0)
        };
        let is_peak = |place: &usize| {
            let own = at(Some(*place));
            own > 0.0
                && own >= NEARLY * highest
                && own >= at(place.checked_sub(1))
                && own >= at(Some(place + 1))
        };
        let mut peaks: Vec<usize> = (0..reach.len()).filter(is_peak).collect();
        peaks.sort_by(|a, b| at(Some(*b)).total_cmp(&at(Some(*a))));
        let refined = |place: &usize| {
            let own = Worst { load: at(Some(*place)), speed: self.places[*place].0 };
            let fine = if self.continuous { self.refined(criterion, *place)? } else { own };
            Ok(if fine.load > own.load { fine } else { own })
        };
        let mut peaks: Vec<Worst> =
            peaks.iter().take(REFINED).map(refined).collect::<Result<_, BalanceError>>()?;
        peaks.sort_by(|a, b| b.load.total_cmp(&a.load));
        Ok(peaks)
    }

    /// Largest force beside a place, between its neighbours.
    fn refined(&self, criterion: Criterion, place: usize) -> Result<Worst, BalanceError> {
        let from = self.places[place.saturating_sub(1)].0;
        let to = self.places[(place + 1).min(self.places.len() - 1)].0;
        let force = |speed: f64| self.force(criterion, (speed, 1.0));
        let (speed, load) = golden_section(from, to, GOLDEN_STEPS, force)?;
        Ok(Worst { load, speed })
    }

    /// The forces that a criterion is about at a speed, times its weight.
    fn waves(
        &self,
        criterion: Criterion,
        (speed, weight): (f64, f64),
    ) -> Result<Vec<Vec<Wave>>, BalanceError> {
        let Some((load, order)) = load(&criterion) else { return Ok(Vec::new()) };
        let place = match load.counts_gas() {
            true => self.range.place(speed, weight)?,
            false => MountPlace { speed, weight, gas: Rc::new(GasRoll::default()) },
        };
        let all = on_springs(&self.system, &self.operator, &place, load.counts_gas())?;
        let own: Vec<Vec<Wave>> = match load {
            Load::MountForce(index) | Load::MountForceWithGas(index) => {
                all.into_iter().skip(index).take(1).collect()
            }
            _ => all,
        };
        let key = order.map(|order| order_key(order, self.operator.grid.revolutions));
        let with_devices = |wave: &Wave| {
            let wave = key.map_or_else(|| wave.clone(), |key| wave.only(key));
            wave.at(&[self.inertia_share])
        };
        Ok(own.iter().map(|mount| mount.iter().map(with_devices).collect()).collect())
    }

    /// More than the force can be: the amplitudes of all orders and components together [N].
    fn reach(&self, criterion: Criterion, place: (f64, f64)) -> Result<f64, BalanceError> {
        let of_mount = |mount: &Vec<Wave>| {
            let of_wave = |wave: &Wave| wave.base.values().map(|[cos, sin]| cos.hypot(*sin)).sum::<f64>();
            mount.iter().map(|wave| of_wave(wave).powi(2)).sum::<f64>().sqrt()
        };
        Ok(self.waves(criterion, place)?.iter().map(of_mount).fold(0.0, f64::max))
    }

    /// Largest force at a speed over all angles [N].
    fn force(&self, criterion: Criterion, place: (f64, f64)) -> Result<f64, BalanceError> {
        let grid = &self.operator.grid;
        let natural = self.operator.natural_force;
        let of_mount = |mount: &Vec<Wave>| {
            let member = Member::Curve(curve(mount, natural, 0, grid));
            natural * member.summits(grid, &[], 0.0)[0].amount
        };
        Ok(self.waves(criterion, place)?.iter().map(of_mount).fold(0.0, f64::max))
    }
}

/// Puts speeds in order, one of those that are closer than `same`.
fn thin(speeds: &mut Vec<f64>, same: f64) {
    speeds.sort_by(f64::total_cmp);
    speeds.dedup_by(|next, kept| *next - *kept <= same);
}
