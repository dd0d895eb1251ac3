//! Forces at mounts with springs over a range of speeds: the worst speed of each answer joins those that the programme judges.
//!
//! ```text
//! F_k(theta, W) = SUM over orders of  W^2 T_k(n W) L_n e^{i n theta}          L_n: load of order n at 1 rad/s, affine in the devices
//! minimise max over mounts k, speeds W of a set, angles theta of |F_k|
//! ```
//! Any set of speeds gives a lower bound of what the range allows. The set begins with both ends, the worst speeds without
//! the devices and steps between; after each optimum the largest force over the whole range is looked for, and its
//! speed joins the set until nothing passes the value by more than [`EXCESS`].

use crate::answer::{Answer, JudgedSpeeds};
use crate::convex::curve::Member;
use crate::error::BalanceError;
use crate::fitted::{bare, fitted};
use crate::mounts::on_springs;
use crate::operator::Operator;
use crate::problem::stages;
use crate::wave::{Wave, curve};
use lanchester_mechanism::{Kinematics, MountSystem};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Load, Stage};
use std::collections::BTreeSet;

/// A speed may pass the value by this share of it.
const EXCESS: f64 = 5e-9;

/// Most rounds; what is left then is told.
const MOST_ROUNDS: usize = 24;

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

/// Solves `task` by `solve` with the speeds at which its mount forces have to be judged.
pub(crate) fn over_the_range(
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    solve: &dyn Fn(&BalanceTask) -> Result<Answer, BalanceError>,
) -> Result<Answer, BalanceError> {
    let criteria = mount_criteria(task);
    if criteria.is_empty() || !engine.is_on_springs() {
        return solve(task);
    }
    let range = task.speeds.is_empty();
    let mut forces = RangeForces::of(engine, kinematics, &task.speeds)?;
    let mut judged = if range { forces.first_speeds(&criteria)? } else { task.speeds.clone() };
    let (mut round, mut sought) = (0, false);
    loop {
        round += 1;
        let mut answer = solve(&BalanceTask { speeds: judged.clone(), ..task.clone() })?;
        if answer.stages.is_empty() {
            // How far limits are from holding is known where the speeds that decide about them are.
            if range && !sought && !task.limits.is_empty() {
                sought = true;
                for criterion in limited_alone(task) {
                    let alone = BalanceTask {
                        stages: vec![Stage { terms: vec![(1.0, criterion)] }],
                        limits: Vec::new(),
                        ..task.clone()
                    };
                    let alone = over_the_range(engine, &alone, kinematics, solve)?;
                    let least = RangeForces::of(&fitted(engine, &alone), kinematics, &[])?;
                    judged.extend(least.peaks(criterion)?.into_iter().map(|peak| peak.1));
                }
                // What lies close together is one: rows that are nearly equal leave the solver without a scale.
                thin(&mut judged, 10.0 * SAME * engine.speed.highest);
                continue;
            }
            answer.task = task.clone();
            return Ok(answer);
        }
        forces = RangeForces::of(&fitted(engine, &answer), kinematics, &task.speeds)?;
        let mut added = Vec::new();
        let mut excess = 0.0f64;
        let mut worst = None;
        for criterion in &criteria {
            let peaks = forces.peaks(*criterion)?;
            let Some(&(force, speed)) = peaks.first() else { continue };
            worst.get_or_insert(speed);
            let value = answer.effects.iter().find(|effect| effect.criterion == *criterion);
            let value = value.map_or(force, |effect| effect.after);
            // What is rounding of the loads of the whole engine passes nothing.
            let most = value + EXCESS * value.max(1e-6 * forces.operator.natural_force);
            if force > most {
                excess = excess.max((force - value) / value.max(f64::MIN_POSITIVE));
                added.extend(peaks.iter().filter(|peak| peak.0 > most).map(|peak| peak.1));
            }
        }
        let known =
            |speed: &f64| judged.iter().any(|other| (other - speed).abs() <= SAME * forces.operator.speed);
        added.retain(|speed| !known(speed));
        if added.is_empty() || round == MOST_ROUNDS || !range {
            let worst = worst.unwrap_or(engine.speed.highest);
            answer.mount_speeds = Some(JudgedSpeeds { judged, worst, excess, range });
            tell_the_range(&mut answer, engine, task, kinematics, &criteria, &forces)?;
            answer.task = task.clone();
            return Ok(answer);
        }
        judged.extend(added);
    }
}

/// The limited criteria of a task that are about forces at mounts.
fn limited_alone(task: &BalanceTask) -> Vec<Criterion> {
    mount_criteria(&BalanceTask { stages: vec![Stage { terms: Vec::new() }], ..task.clone() })
}

/// Before, without and after of the mount forces, each at its own worst speed.
fn tell_the_range(
    answer: &mut Answer,
    engine: &Engine,
    task: &BalanceTask,
    kinematics: Kinematics,
    criteria: &[Criterion],
    after: &RangeForces,
) -> Result<(), BalanceError> {
    let before = RangeForces::of(engine, kinematics, &task.speeds)?;
    let without = RangeForces::of(&bare(engine, task), kinematics, &task.speeds)?;
    for effect in answer.effects.iter_mut().filter(|effect| criteria.contains(&effect.criterion)) {
        effect.before = before.largest(effect.criterion)?;
        effect.without = without.largest(effect.criterion)?;
        effect.after = effect.after.max(after.largest(effect.criterion)?);
    }
    raise(answer, criteria);
    Ok(())
}

/// A stage has what the range has of it, above the bound by no more than the search left.
pub(crate) fn raise(answer: &mut Answer, criteria: &[Criterion]) {
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

/// The criteria of a task that are about forces at mounts, each once.
fn mount_criteria(task: &BalanceTask) -> Vec<Criterion> {
    let stages = stages(task);
    let asked = stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    let mut criteria: Vec<Criterion> = Vec::new();
    for criterion in asked.chain(task.limits.iter().map(|limit| limit.criterion)) {
        let about = matches!(
            criterion,
            Criterion::Peak(Load::MountForce(_) | Load::LargestMountForce)
                | Criterion::Order(Load::MountForce(_) | Load::LargestMountForce, _)
        );
        if about && !criteria.contains(&criterion) {
            criteria.push(criterion);
        }
    }
    criteria
}

/// Forces at the mounts of an engine without free devices, at any speed.
struct RangeForces {
    engine: Engine,
    operator: Operator,
    /// Speeds to look at, rising [rad/s].
    places: Vec<f64>,
    /// Whether what lies between them counts too.
    continuous: bool,
}

impl RangeForces {
    /// Over the range of the engine, or at `speeds` alone.
    fn of(engine: &Engine, kinematics: Kinematics, speeds: &[f64]) -> Result<RangeForces, BalanceError> {
        let operator = Operator::new(engine, &BalanceTask::default(), kinematics, &[])?;
        let (lowest, highest) = (engine.speed.lowest.min(engine.speed.highest), engine.speed.highest);
        if !speeds.is_empty() {
            let places = speeds.to_vec();
            let engine = engine.clone();
            return Ok(RangeForces { engine, operator, places, continuous: false });
        }
        let keys: BTreeSet<u32> =
            operator.channels.iter().flat_map(|wave| wave.base.keys().copied()).collect();
        let mut places = steps(lowest, highest, SEARCH_STEPS);
        for mode in MountSystem::new(engine)?.modes()?.damped {
            let frequency = mode.root.im.abs();
            for key in keys.iter().filter(|key| **key > 0) {
                let speed = frequency * f64::from(operator.grid.revolutions) / f64::from(*key);
                let half_width = mode.damping_ratio.min(0.5) * speed;
                places.extend(ABOUT.iter().map(|about| speed + about * half_width));
            }
        }
        places.retain(|speed| *speed >= lowest && *speed <= highest);
        thin(&mut places, 1e-6 * highest);
        let continuous = lowest < highest;
        Ok(RangeForces { engine: engine.clone(), operator, places, continuous })
    }

    /// Where a programme judges to begin with.
    fn first_speeds(&self, criteria: &[Criterion]) -> Result<Vec<f64>, BalanceError> {
        let (Some(&lowest), Some(&highest)) = (self.places.first(), self.places.last()) else {
            return Ok(Vec::new());
        };
        let mut speeds = steps(lowest, highest, if lowest < highest { FIRST_STEPS } else { 0 });
        for criterion in criteria {
            let peaks = self.peaks(*criterion)?.into_iter().map(|peak| peak.1);
            speeds.extend(peaks.filter(|speed| highest - speed > 2e-3 * highest));
        }
        thin(&mut speeds, 2e-3 * highest);
        Ok(speeds)
    }

    /// Largest force of a criterion over all its speeds [N].
    fn largest(&self, criterion: Criterion) -> Result<f64, BalanceError> {
        Ok(self.peaks(criterion)?.first().map_or(0.0, |peak| peak.0))
    }

    /// Peaks over speed of a criterion that are nearly as high as the highest, the highest first: force [N] and speed [rad/s].
    fn peaks(&self, criterion: Criterion) -> Result<Vec<(f64, f64)>, BalanceError> {
        // No force is larger than its orders together: most speeds need no look at their angles.
        let reach: Vec<f64> =
            self.places.iter().map(|speed| self.reach(criterion, *speed)).collect::<Result<_, _>>()?;
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
            let (own, speed) = (at(Some(*place)), self.places[*place]);
            let fine = if self.continuous { self.refined(criterion, *place)? } else { (own, speed) };
            Ok(if fine.0 > own { fine } else { (own, speed) })
        };
        let mut peaks: Vec<(f64, f64)> =
            peaks.iter().take(REFINED).map(refined).collect::<Result<_, BalanceError>>()?;
        peaks.sort_by(|a, b| b.0.total_cmp(&a.0));
        Ok(peaks)
    }

    /// Largest force beside a place, between its neighbours, and its speed.
    fn refined(&self, criterion: Criterion, place: usize) -> Result<(f64, f64), BalanceError> {
        let mut from = self.places[place.saturating_sub(1)];
        let mut to = self.places[(place + 1).min(self.places.len() - 1)];
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let at = |speed: f64| self.force(criterion, speed);
        let (mut left, mut right) = (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
        let (mut at_left, mut at_right) = (at(left)?, at(right)?);
        for _ in 0..GOLDEN_STEPS {
            if at_left >= at_right {
                (to, right, at_right) = (right, left, at_left);
                left = to - GOLDEN * (to - from);
                at_left = at(left)?;
            } else {
                (from, left, at_left) = (left, right, at_right);
                right = from + GOLDEN * (to - from);
                at_right = at(right)?;
            }
        }
        Ok(if at_left >= at_right { (at_left, left) } else { (at_right, right) })
    }

    /// The forces that a criterion is about at a speed.
    fn waves(&self, criterion: Criterion, speed: f64) -> Result<Vec<Vec<Wave>>, BalanceError> {
        let all = on_springs(&self.engine, &self.operator, speed)?;
        let (load, order) = match criterion {
            Criterion::Order(load, order) => (load, Some(order)),
            Criterion::Peak(load) => (load, None),
            _ => return Ok(Vec::new()),
        };
        let own = match load {
            Load::MountForce(index) => all.into_iter().skip(index).take(1).collect(),
            _ => all,
        };
        let Some(order) = order else { return Ok(own) };
        let key = (order * f64::from(self.operator.grid.revolutions)).round() as u32;
        Ok(own.iter().map(|mount| mount.iter().map(|wave| wave.only(key)).collect()).collect())
    }

    /// More than the force can be: the amplitudes of all orders and components together [N].
    fn reach(&self, criterion: Criterion, speed: f64) -> Result<f64, BalanceError> {
        let of_mount = |mount: &Vec<Wave>| {
            let of_wave = |wave: &Wave| wave.base.values().map(|[cos, sin]| cos.hypot(*sin)).sum::<f64>();
            mount.iter().map(|wave| of_wave(wave).powi(2)).sum::<f64>().sqrt()
        };
        Ok(self.waves(criterion, speed)?.iter().map(of_mount).fold(0.0, f64::max))
    }

    /// Largest force at a speed over all angles [N].
    fn force(&self, criterion: Criterion, speed: f64) -> Result<f64, BalanceError> {
        let grid = &self.operator.grid;
        let natural = self.operator.natural_force;
        let of_mount = |mount: &Vec<Wave>| {
            let member = Member::Curve(curve(mount, natural, 0, grid));
            natural * member.summits(grid, &[], 0.0)[0].amount
        };
        Ok(self.waves(criterion, speed)?.iter().map(of_mount).fold(0.0, f64::max))
    }
}

/// Puts speeds in order, one of those that are closer than `same`.
fn thin(speeds: &mut Vec<f64>, same: f64) {
    speeds.sort_by(f64::total_cmp);
    speeds.dedup_by(|next, kept| *next - *kept <= same);
}

/// Equal steps from one speed to another, both included.
pub(crate) fn steps(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| from + (to - from) * k as f64 / count.max(1) as f64).collect()
}
