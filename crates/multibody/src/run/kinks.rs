//! Crank angles at which what acts on the crank train has kinks.

use crate::gas_pressure::GasPressure;
use crate::simulation::{LoadLaw, Simulation};
use crate::train::Train;

/// Crank angles within one period at which pressures and load have kinks, rising; at which any of their derivatives jumps where `with_bends`.
pub(crate) fn kinks(
    train: &Train,
    gas: Option<&dyn GasPressure>,
    simulation: &Simulation,
    period: f64,
    with_bends: bool,
) -> Vec<f64> {
    let mut all = Vec::new();
    // Behind a driveline the load's angle is not the crank's: its kinks are left to the control of the steps.
    let (own, bends) = match &simulation.load.law {
        _ if !simulation.driveline.is_empty() => (period, Vec::new()),
        LoadLaw::Angle { period, points } => (*period, points.iter().map(|point| point[0]).collect()),
        LoadLaw::Map { period, curves } => {
            (*period, curves.iter().flat_map(|curve| &curve.points).map(|point| point[0]).collect())
        }
        _ => (period, Vec::new()),
    };
    let whole = (period / own).round();
    if (period / own - whole).abs() < 1e-9 {
        all.extend((0..whole as u32).flat_map(|turn| bends.iter().map(move |at| at + own * f64::from(turn))));
    }
    for (gas, (index, cylinder)) in
        gas.iter().flat_map(|gas| train.cylinders.iter().enumerate().map(move |cylinder| (gas, cylinder)))
    {
        let ratio = train.ratio(index).abs();
        let cycles = (period * ratio / gas.cycle()).round().max(1.0) as usize;
        for kink in if with_bends { gas.bends(index) } else { gas.kinks(index) } {
            for cycle in 0..cycles {
                let theta =
                    cylinder.firing_angle.unwrap_or(0.0) + (kink + gas.cycle() * cycle as f64) / ratio;
                all.push(theta.rem_euclid(period));
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup_by(|later, kept| *later - *kept < 1e-9);
    if all.len() > 1 && all[0] + period - all[all.len() - 1] < 1e-9 {
        all.pop();
    }
    all
}
