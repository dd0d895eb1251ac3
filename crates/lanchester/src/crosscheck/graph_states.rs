//! The bond graph at imposed speed: what holds its block still against the reactions, and its gas as states against the computed cycle.

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::pair::{CrossCheckError, Pair};
use lanchester_bondgraph::{
    EngineBlock, EngineDrive, EngineRequest, GasStates, Graph, Simulation as GraphRun, SimulationRequest,
    engine_graph, equations,
};
use lanchester_report::CrossRow;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Share of the peak by which the pressures may differ, and the tolerance of the steps.
const GAS_BAR: f64 = 1e-6;
const GAS_STEPS: f64 = 1e-10;
/// Cycles until what is left of the start is below the bar, and samples of the one that is compared.
const CYCLES: f64 = 14.0;
const GAS_SAMPLES: u32 = 240;

/// Share by which loads on the block and torque may differ, and the tolerance of the steps: the angle is the one state.
const LOADS_BAR: f64 = 1e-9;
const LOADS_STEPS: f64 = 1e-12;

/// Force and couple on the block as complex numbers of the plane, roll moment, torque of the shaft, at crank angles from 0 on: from the sources
/// that hold the block of the graph still and drive its crank from the ground.
fn held_loads(pair: &Pair<'_>, theta: &[f64]) -> Result<Option<Vec<[Complex64; 4]>>, CrossCheckError> {
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.against_ground = true;
    request.block = EngineBlock::Held;
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    let places: Vec<f64> = theta[1..].iter().map(|theta| theta / pair.speed).collect();
    let duration = places.last().copied().unwrap_or(0.0);
    let description = engine_graph(pair.engine, &request)?;
    let found = Graph::new(&description).ok().and_then(|graph| equations(&graph).ok());
    let Some(found) = found else { return Ok(None) };
    let asked = SimulationRequest { duration, tolerance: LOADS_STEPS, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    let of = |name: &str| run.values(&format!("{name}.effort")).filter(|values| values.len() == theta.len());
    let names = ["hold_vx", "hold_vy", "hold_wx", "hold_wy", "hold_wz", "drive"];
    let efforts: Option<Vec<&[f64]>> = names.into_iter().map(of).collect();
    Ok(efforts.map(|efforts| {
        let at = |k: usize| {
            let own = |name: usize| -efforts[name][k];
            let real = |value: f64| Complex64::new(value, 0.0);
            [Complex64::new(own(0), own(1)), Complex64::new(own(2), own(3)), real(own(4)), real(own(5))]
        };
        (0..theta.len()).map(at).collect()
    }))
}

/// Loads on the block and torque of the shaft against those of the multibody simulation, each with its largest amplitude of its kind.
pub(crate) fn load_rows(
    pair: &Pair<'_>,
    theta: &[f64],
    theirs: &[[Complex64; 4]],
    kinds: [(&str, &str, f64); 4],
) -> Result<Vec<CrossRow>, CrossCheckError> {
    // Without causality nothing agrees.
    let ours = held_loads(pair, theta)?.unwrap_or_default();
    let rows = kinds.into_iter().enumerate().map(|(kind, (name, unit, scale))| {
        let largest = |side: &[[Complex64; 4]]| side.iter().map(|at| at[kind].norm()).fold(0.0, f64::max);
        let off = ours.iter().zip(theirs).map(|(a, b)| (a[kind] - b[kind]).norm()).fold(0.0, f64::max);
        let off = if ours.len() == theirs.len() { off } else { f64::INFINITY };
        let name = format!("{name}, bond graph");
        let values = [largest(&ours), largest(theirs), off, scale];
        let mut row = CrossRow::held(&name, unit, None, values, LOADS_BAR);
        (row.closed_form, row.bond_graph) = (None, row.closed_form);
        row
    });
    Ok(rows.collect())
}

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
    let (Some(gas), Ok(states)) = (pair.gas, GasStates::of(pair.engine)) else { return Ok(None) };
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
