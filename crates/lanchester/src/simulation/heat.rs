//! Heat of the last period of a run: that of the computed cycles at its mean speed.

use crate::pressure::cycles::cycle_results;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use lanchester_cycle::CylinderVolume;
use lanchester_model::{Engine, GasProcess, GasSource};
use lanchester_multibody::{Action, Run, Simulation};
use lanchester_report::{CycleResult, PeriodHeat};
use std::f64::consts::TAU;

/// What the fuel of all cylinders gives in one period of `revolutions` at the end of `run`; `None` where pressures are measured or a closed cylinder's, where a cylinder may
/// have less than its fuel, and where the run has no whole last period.
pub(super) fn period_heat(
    engine: &Engine,
    traces: &[TraceFile],
    simulation: &Simulation,
    run: &Run,
    revolutions: u32,
) -> Option<PeriodHeat> {
    let Some(GasSource::Cycle(cycle)) = engine.gas.as_ref().map(|gas| &gas.source) else { return None };
    let scales = |action: &Action| matches!(action, Action::Misfire(_) | Action::Fuel(_));
    let is_scaled =
        simulation.governor.is_some() || simulation.events.iter().any(|event| scales(&event.action));
    if cycle.process == GasProcess::Sealed || is_scaled {
        return None;
    }
    run.last_period?;
    let period = TAU * f64::from(revolutions);
    let (theta, time) = (&run.samples.theta, &run.samples.time);
    let (end, now) = (theta.last()?, time.last()?);
    // The crank may have turned back before.
    let first = theta.iter().rposition(|at| *at <= end - period + 1e-6)?;
    let speed = (end - theta[first]) / (now - time[first]);
    if !(speed > 0.0 && speed.is_finite()) {
        return None;
    }
    // A cycle that cannot be at this speed has been told by the run.
    let gas = cylinder_gas(engine, traces, speed).ok()?;
    let volumes = CylinderVolume::of_engine(engine, Some(cycle.compression_ratio)).ok()?;
    let mut heat = PeriodHeat { speed, ..PeriodHeat::default() };
    for own in cycle_results(engine, &gas).ok()? {
        let cycles: f64 = (own.cylinders.iter())
            .filter_map(|number| volumes.get(number.checked_sub(1)?))
            .map(|volume| period * volume.speed_ratio().abs() / volume.cycle())
            .sum();
        add(&mut heat, &own, cycles);
    }
    (heat.fuel > 0.0).then_some(heat)
}

/// Adds so many `cycles` like `own`.
fn add(heat: &mut PeriodHeat, own: &CycleResult, cycles: f64) {
    let fuel = match (own.thermal_efficiency, own.indicated_efficiency) {
        (Some(thermal), Some(indicated)) if indicated != 0.0 => own.heat * thermal / indicated,
        _ => own.heat,
    };
    let walls = own.exchange.as_ref().map_or(0.0, |exchange| exchange.wall_heat);
    heat.fuel += cycles * fuel;
    heat.unburned += cycles * (fuel - own.heat);
    heat.walls += cycles * walls;
    heat.indicated += cycles * own.work;
    heat.exhaust += cycles * (own.heat - walls - own.work);
}
