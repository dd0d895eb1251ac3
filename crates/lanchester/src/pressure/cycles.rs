//! What computed cycles give, for every front end.

use crate::pressure::cylinders::{CylinderCycle, GasReport};
use lanchester_cycle::{CycleError, CylinderVolume};
use lanchester_model::{Engine, GasProcess, GasSource};
use lanchester_report::{CYCLE_RESULT_VERSION, CycleResult, CycleTrace, ExchangeResult};

/// Angles of a revolution of the own crankshaft in the traces.
const SAMPLES: usize = 360;

/// What the computed cycles of `gas` give in `engine`: each once; none where pressures are measured.
///
/// # Errors
/// [`CycleError`] where a cylinder has no bore or its linkage does not turn.
pub fn cycle_results(engine: &Engine, gas: &GasReport) -> Result<Vec<CycleResult>, CycleError> {
    let Some(GasSource::Cycle(cycle)) = engine.gas.as_ref().map(|gas| &gas.source) else {
        return Ok(Vec::new());
    };
    let volumes = CylinderVolume::of_engine(engine, Some(cycle.compression_ratio))?;
    let burned = match &cycle.process {
        GasProcess::Diesel { fuel } | GasProcess::Seiliger { fuel, .. } => fuel.efficiency,
        GasProcess::Otto { heat: lanchester_model::IdealHeat::Fuel(fuel) } => fuel.efficiency,
        GasProcess::Otto { .. } | GasProcess::Sealed | GasProcess::SingleZone(_) => 1.0,
    };
    let process = gas.source.trim_start_matches("computed: ").to_owned();
    let results = gas.cycles.iter().filter_map(|computed| {
        let index = computed.cylinders.first()?.checked_sub(1)?;
        let (volume, indicated) = (volumes.get(index)?, gas.indicated.get(index)?);
        let count = SAMPLES * engine.strokes.revolutions() as usize;
        let step = volume.cycle() / count as f64;
        let angle: Vec<f64> = (0..count).map(|k| step * k as f64).collect();
        let over = |value: &dyn Fn(f64) -> f64| angle.iter().map(|psi| value(*psi)).collect::<Vec<f64>>();
        let half = |angle: f64| if angle > 0.5 * volume.cycle() { angle - volume.cycle() } else { angle };
        let pressure = computed.cycle.pressure();
        let known = CycleTrace {
            volume: over(&|psi| volume.at(psi)[0]),
            pressure: over(&|psi| pressure.at(psi)),
            ..CycleTrace::default()
        };
        let work = indicated.work;
        let mut result = CycleResult {
            version: CYCLE_RESULT_VERSION,
            cylinders: computed.cylinders.clone(),
            process: process.clone(),
            work,
            gross_work: indicated.gross_work,
            exchange_work: indicated.exchange_work,
            mean_effective_pressure: indicated.mean_effective_pressure,
            heat: 0.0,
            thermal_efficiency: None,
            indicated_efficiency: None,
            trapped_mass: 0.0,
            peak_pressure: indicated.peak_pressure,
            peak_pressure_angle: indicated.peak_angle,
            peak_temperature: 0.0,
            peak_temperature_angle: 0.0,
            exchange: None,
            trace: CycleTrace::default(),
        };
        match &computed.cycle {
            CylinderCycle::Ideal(ideal) => {
                let hottest = ideal.states.iter().map(|state| state.temperature).fold(0.0, f64::max);
                result.heat = ideal.heat;
                result.thermal_efficiency = (ideal.heat > 0.0).then(|| work / ideal.heat);
                result.indicated_efficiency = result.thermal_efficiency.map(|share| burned * share);
                result.trapped_mass = ideal.mass;
                result.peak_temperature = hottest;
                result.peak_temperature_angle = ideal.cut_off_angle;
                result.trace = CycleTrace { angle, ..known };
            }
            CylinderCycle::SingleZone(zone) => {
                let since = &zone.since_closing;
                let [_, (hottest, at)] = zone.temperature.extremes();
                result.heat = zone.heat;
                result.thermal_efficiency = zone.indicated_efficiency;
                result.indicated_efficiency = zone.fuel_efficiency;
                result.trapped_mass = zone.trapped.mass;
                result.peak_temperature = hottest;
                result.peak_temperature_angle = half(at);
                result.exchange = Some(ExchangeResult {
                    fresh_mass: zone.trapped.fresh,
                    residual_share: zone.residual_share,
                    trapped_temperature: zone.temperature.at(zone.closing_angle),
                    closing_angle: zone.closing_angle,
                    volumetric_efficiency: zone.volumetric_efficiency,
                    trapping_efficiency: zone.trapping_efficiency,
                    wall_heat: zone.passed.wall_heat,
                    wall_heat_share: (zone.heat > 0.0).then(|| zone.passed.wall_heat / zone.heat),
                    body_temperature: gas.body_temperature,
                    energy_residual: zone.balance.energy,
                    energy_residual_share: zone.balance.energy_share,
                    mass_residual: zone.balance.mass,
                    mass_residual_share: zone.balance.mass_share,
                    converged: zone.outcome.converged,
                    cycles: zone.outcome.cycles,
                });
                let known = CycleTrace {
                    temperature: over(&|psi| zone.temperature.at(psi)),
                    mass: over(&|psi| zone.mass.at(psi)),
                    heat_release: over(&|psi| since.released.slope(psi)),
                    wall_heat: over(&|psi| since.wall_heat.slope(psi)),
                    intake: over(&|psi| since.mass[0].slope(psi)),
                    exhaust: over(&|psi| -since.mass[1].slope(psi)),
                    ..known
                };
                result.trace = CycleTrace { angle, ..known };
            }
        }
        Some(result)
    });
    Ok(results.collect())
}
