//! The bond graph at imposed speed, its gas as states, held against the computed cycle.

use crate::crosscheck::pair::{CrossCheckError, Pair};
use crate::pressure::cylinders::cylinder_gas;
use lanchester_bondgraph::{
    EngineDrive, EngineRequest, GasStates, Graph, Simulation as GraphRun, SimulationRequest, engine_graph,
    equations,
};
use lanchester_report::CrossRow;
use std::f64::consts::TAU;

/// Share of the peak by which the pressures may differ, and the tolerance of the steps.
const GAS_BAR: f64 = 1e-6;
const GAS_STEPS: f64 = 1e-10;
/// Cycles until what is left of the start is below the bar, and samples of the one that is compared.
const CYCLES: f64 = 14.0;
const GAS_SAMPLES: u32 = 240;

/// A run of a graph of the engine at imposed speed, block fixed, with samples over its last turns.
fn imposed(
    pair: &Pair<'_>,
    request: EngineRequest,
    (first, count): (f64, u32),
    turns: f64,
    tolerance: f64,
) -> Result<Option<GraphRun>, CrossCheckError> {
    let cycle = turns * TAU / pair.speed;
    let description = engine_graph(pair.engine, &request)?;
    let found = Graph::new(&description).ok().and_then(|graph| equations(&graph).ok());
    let Some(found) = found else { return Ok(None) };
    let all = f64::from(count);
    let places: Vec<f64> = (1..=count).map(|k| cycle * (first + f64::from(k) / all)).collect();
    let asked = SimulationRequest { duration: (first + 1.0) * cycle, tolerance, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    Ok(run.complete.then_some(run))
}

/// The pressures of a single-zone cycle, where the file has one that the graph takes.
pub(crate) fn gas_row(pair: &Pair<'_>) -> Result<Option<CrossRow>, CrossCheckError> {
    let (Some(gas), Ok(mut states)) = (pair.gas, GasStates::of(pair.engine)) else { return Ok(None) };
    // A body that takes heat starts with the temperature that the cycle has; a computed one needs no traces.
    if let Some(walls) = &mut states.walls
        && let Some(body) = cylinder_gas(pair.engine, &[], pair.speed)?.body_temperature
    {
        walls.start = body;
    }
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.gas_states = Some(states);
    let turns = f64::from(pair.engine.strokes.revolutions());
    let Some(run) = imposed(pair, request, (CYCLES, GAS_SAMPLES), turns, GAS_STEPS)? else { return Ok(None) };
    let (mut peak, mut ours_peak, mut off) = (0.0f64, 0.0f64, 0.0f64);
    for (index, theirs) in gas.iter().enumerate() {
        let of = |what: String| run.values(&what).unwrap_or_default();
        let (ours, angle) = (of(format!("mass{}.effort", index + 1)), of(format!("psi{}", index + 1)));
        if ours.len() < 2 {
            off = f64::INFINITY;
        }
        for (pressure, psi) in ours.iter().zip(angle).skip(1) {
            let known = theirs.cylinder.at(*psi);
            peak = peak.max(known);
            ours_peak = ours_peak.max(*pressure);
            off = off.max((pressure - known).abs());
        }
    }
    let mut row = CrossRow::held(
        "pressure, gas as states of the bond graph",
        "Pa",
        None,
        [peak, peak, off, peak],
        GAS_BAR,
    );
    row.bond_graph = Some(ours_peak);
    row.reason = Some("the multibody simulation takes the pressures of the cycle".into());
    Ok(Some(row))
}
