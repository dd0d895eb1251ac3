//! The last period of a run in numbers: extremes, orders, statistics.

use lanchester_multibody::{Run, RunExtremes, Samples};
use lanchester_results::{OrderLoads, TwoSided, amplitude};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;
use std::ops::Range;

/// Highest order that is computed.
const MOST: f64 = 24.0;

/// The last whole period of a run, or all of it where there is none.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct PeriodSummary {
    /// Whether it is a whole period: the crank turns through one at least.
    pub is_whole: bool,
    /// Its start and end [s].
    pub time: [f64; 2],
    /// Largest and smallest values.
    pub extremes: RunExtremes,
    /// Mean over time and standard deviation of what has a course.
    pub statistics: Vec<SeriesStatistics>,
    /// By order at the crank angle itself; empty where the samples are not equally spaced in the angle.
    pub orders: Vec<SimulatedOrder>,
}

/// Mean and deviation of one course over time.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SeriesStatistics {
    /// What it is.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Mean over time.
    pub mean: f64,
    /// Root of the mean square of what departs from it.
    pub deviation: f64,
}

/// One order of the last period: what the crank train does to the block and at its shaft, and how speed and block follow.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SimulatedOrder {
    /// Loads on the block and torque at crankshaft 1.
    pub loads: OrderLoads,
    /// Speed of crankshaft 1 [rad/s].
    #[schemars(with = "[f64; 2]")]
    pub speed: Complex64,
    /// Parts of the motion of the block's origin across the crank axis that turn with the crank and against it [m]; 0 with a fixed block.
    #[schemars(with = "[[f64; 2]; 2]")]
    pub motion: [Complex64; 2],
}

impl PeriodSummary {
    /// Of a run of a crank train that stands as before after `revolutions`; `mounts`: their names.
    pub fn of(run: &Run, revolutions: u32, mounts: &[String]) -> PeriodSummary {
        let samples = &run.samples;
        let range = last_period(samples, revolutions);
        let extremes = match &run.last_period_extremes {
            Some(own) => own.clone(),
            // Where it starts at the start of the run, it is the run.
            None if range.start == 0 => run.extremes.clone(),
            None => samples.extremes(range.clone()),
        };
        let time = samples.time.get(range.clone()).unwrap_or_default();
        let turned = match (samples.theta.get(range.start), samples.theta.last()) {
            (Some(start), Some(end)) => end - start,
            _ => 0.0,
        };
        PeriodSummary {
            is_whole: turned >= TAU * f64::from(revolutions) * (1.0 - 1e-6),
            time: [time.first().copied().unwrap_or(0.0), time.last().copied().unwrap_or(0.0)],
            extremes,
            statistics: statistics(samples, range.clone(), mounts),
            orders: orders(samples, range, revolutions),
        }
    }
}

/// Samples of the last whole period of `revolutions`, or all where there is none.
pub(crate) fn last_period(samples: &Samples, revolutions: u32) -> Range<usize> {
    let theta = &samples.theta;
    let Some(end) = theta.last() else { return 0..0 };
    let from = end - TAU * f64::from(revolutions) - 1e-9;
    let first = theta.iter().position(|at| *at >= from).unwrap_or(0);
    if theta[0] > from + 2e-9 { 0..theta.len() } else { first..theta.len() }
}

/// Samples of the last whole period at or before a crank angle, if the crank turns evenly spaced through it.
pub(crate) fn period_before(samples: &Samples, revolutions: u32, theta: f64) -> Option<Range<usize>> {
    let period = TAU * f64::from(revolutions);
    let end = samples.theta.iter().rposition(|at| *at <= theta + 1e-9)?;
    let start = samples.theta[..=end].iter().rposition(|at| *at <= samples.theta[end] - period + 1e-9)?;
    let inside = samples.theta.get(start..=end)?;
    let step = period / (inside.len() - 1).max(1) as f64;
    let is_even = inside.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-9 * period);
    (is_even && inside.len() > 8).then_some(start..end + 1)
}

/// Mean and deviation of `values` over `time`, straight between the samples.
fn mean_and_deviation(time: &[f64], values: &[f64]) -> [f64; 2] {
    let span = match (time.first(), time.last()) {
        (Some(from), Some(to)) if to > from => to - from,
        _ => return [values.first().copied().unwrap_or(0.0), 0.0],
    };
    let steps = || time.windows(2).zip(values.windows(2)).map(|(t, v)| (t[1] - t[0], v[0], v[1]));
    let mean = steps().map(|(h, a, b)| 0.5 * h * (a + b)).sum::<f64>() / span;
    let square = |a: f64, b: f64| (a * a + a * b + b * b) / 3.0;
    let spread = steps().map(|(h, a, b)| h * square(a - mean, b - mean)).sum::<f64>() / span;
    [mean, spread.max(0.0).sqrt()]
}

fn statistics(samples: &Samples, range: Range<usize>, mounts: &[String]) -> Vec<SeriesStatistics> {
    let time = samples.time.get(range.clone()).unwrap_or_default();
    let mut all = Vec::new();
    let mut add = |name: &str, unit: &str, values: &[f64]| {
        let [mean, deviation] = mean_and_deviation(time, values);
        all.push(SeriesStatistics { name: name.into(), unit: unit.into(), mean, deviation });
    };
    let of = |values: &[f64]| values.get(range.clone()).unwrap_or_default().to_vec();
    add("speed", "rad/s", &of(&samples.speed));
    add("acceleration", "rad/s2", &of(&samples.acceleration));
    for (name, values) in [
        ("gas torque", &samples.gas_torque),
        ("load torque", &samples.load_torque),
        ("starter torque", &samples.starter_torque),
        ("friction torque", &samples.friction_torque),
        ("torque of the pistons' friction", &samples.piston_friction_torque),
        ("driveline torque", &samples.driveline_torque),
        ("other torque", &samples.outside_torque),
    ] {
        if values.iter().any(|torque| *torque != 0.0) {
            add(name, "N m", &of(values));
        }
    }
    if let Some(reactions) = samples.reactions.get(range.clone()) {
        let torque: Vec<f64> = reactions.iter().map(|all| all.shaft_torque).collect();
        add("shaft torque", "N m", &torque);
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let force: Vec<f64> = reactions.iter().map(|all| all.on_block.force[k]).collect();
            add(&format!("force on the block along {axis}"), "N", &force);
        }
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let moment: Vec<f64> = reactions.iter().map(|all| all.on_block.moment[k]).collect();
            add(&format!("moment on the block about {axis}"), "N m", &moment);
        }
    }
    let position = samples.position.get(range.clone()).unwrap_or_default();
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        if !position.is_empty() {
            let place: Vec<f64> = position.iter().map(|at| at[k]).collect();
            add(&format!("origin of the block along {axis}"), "m", &place);
        }
    }
    let forces = samples.mounts.get(range.clone()).unwrap_or_default();
    for (mount, name) in mounts.iter().enumerate() {
        let size = |all: &Vec<[f64; 3]>| {
            all.get(mount).map_or(0.0, |force| force.iter().map(|part| part * part).sum::<f64>().sqrt())
        };
        let values: Vec<f64> = forces.iter().map(size).collect();
        add(&format!("force of mount {name}"), "N", &values);
    }
    all
}

fn orders(samples: &Samples, range: Range<usize>, revolutions: u32) -> Vec<SimulatedOrder> {
    let theta = &samples.theta[range.clone()];
    let period = TAU * f64::from(revolutions);
    let (Some(first), Some(last)) = (theta.first(), theta.last()) else { return Vec::new() };
    let count = theta.len() - 1;
    let step = period / count.max(1) as f64;
    let equal = theta.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-9 * period);
    if count < 8 || (last - first - period).abs() > 1e-9 * period || !equal || samples.reactions.is_empty() {
        return Vec::new();
    }
    let range = range.start..range.start + count;
    let loads = samples.block_loads(range.clone());
    let (start, turns) = (theta[0], f64::from(revolutions));
    let positions = samples.position.get(range.clone()).unwrap_or_default();
    let motion: Vec<Complex64> = positions.iter().map(|p| Complex64::new(p[0], p[1])).collect();
    let highest = (MOST * turns).min(count as f64 / 4.0) as u32;
    let orders = (0..=highest).map(|cycles| {
        let order = f64::from(cycles) / turns;
        let moved = match motion.is_empty() {
            true => TwoSided::default(),
            false => TwoSided::of_samples(&motion, start, turns, order),
        };
        SimulatedOrder {
            loads: loads.order(order, period),
            speed: amplitude(samples.speed[range.clone()].iter().copied(), count, start, turns, order),
            motion: [moved.forward, moved.backward],
        }
    });
    orders.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_and_deviation_are_those_over_time() {
        // Straight from 0 to 3 within 1 s, then 3 for 2 s: mean (1.5 + 6) / 3.
        let [mean, deviation] = mean_and_deviation(&[0.0, 1.0, 3.0], &[0.0, 3.0, 3.0]);
        assert!((mean - 2.5).abs() < 1e-15, "{mean}");
        // Mean square (3 + 18) / 3 = 7, less 6.25.
        assert!((deviation - 0.75f64.sqrt()).abs() < 1e-15, "{deviation}");
        assert_eq!(mean_and_deviation(&[1.0], &[4.0]), [4.0, 0.0]);
    }
}
