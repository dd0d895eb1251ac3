//! The bond graph's loads on the block and torque at imposed speed, held against the multibody simulation: six sources hold its block still, and what
//! they give is the opposite of the loads.

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::orders::order_rows;
use crate::crosscheck::pair::{CrossCheckError, Loads, Pair, loads_at};
use lanchester_bondgraph::{
    EngineBlock, EngineDrive, EngineRequest, Graph, Simulation as GraphRun, SimulationRequest, engine_graph,
    equations,
};
use lanchester_report::CrossRow;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Largest share by which the two may differ.
const BAR: f64 = 1e-9;

/// Tolerance of the steps: the angle is the one state.
const STEPS: f64 = 1e-12;

/// Samples of a revolution, and the place of the first in its step: off the angles at which the pressures of ideal cycles jump.
const SAMPLES: f64 = 72.0;
const PLACE: f64 = 0.37;

/// Rows over the cycle of that many revolutions and by order; `kinds`: names, units and scales.
pub(crate) fn load_rows(
    pair: &Pair<'_>,
    turns: f64,
    kinds: [((&str, &str), f64); 4],
) -> Result<Vec<CrossRow>, CrossCheckError> {
    let count = (SAMPLES * turns).round() as u32;
    let theta: Vec<f64> = (0..count).map(|k| (f64::from(k) + PLACE) * TAU / SAMPLES).collect();
    let (theta, by_graph): (Vec<f64>, Vec<Loads>) = graph_loads(pair, &theta)?.into_iter().unzip();
    let by_multibody: Vec<Loads> = theta.iter().map(|theta| loads_at(pair, *theta, &[]).0).collect();
    let mut rows = Vec::new();
    for (kind, ((name, unit), scale)) in kinds.into_iter().enumerate() {
        let name = format!("{name}, bond graph");
        let of = |loads: &[Loads]| loads.iter().map(|at| at[kind]).collect::<Vec<_>>();
        let (ours, theirs) = (of(&by_multibody), of(&by_graph));
        let largest = |trace: &[Complex64]| trace.iter().map(|at| at.norm()).fold(0.0, f64::max);
        // A graph that gives too few differs beyond any bar.
        let off = match ours.len() == count as usize {
            true => ours.iter().zip(&theirs).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max),
            false => f64::INFINITY,
        };
        rows.push(CrossRow::held(&name, unit, None, [largest(&theirs), largest(&ours), off, scale], BAR));
        if off.is_finite() {
            let most = pair.request.max_order;
            rows.extend(order_rows((&name, unit), [&theirs, &ours], turns, most, scale, BAR));
        }
    }
    for row in &mut rows {
        (row.closed_form, row.bond_graph) = (None, row.closed_form);
    }
    Ok(rows)
}

/// Loads of the graph beside its angles, which are those given but for the rounding of the time; none where it has no causality or its run ends early.
fn graph_loads(pair: &Pair<'_>, theta: &[f64]) -> Result<Vec<(f64, Loads)>, CrossCheckError> {
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.against_ground = true;
    request.block = EngineBlock::Held;
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    let description = engine_graph(pair.engine, &request)?;
    let found = Graph::new(&description).ok().and_then(|graph| equations(&graph).ok());
    let (Some(found), Some(last)) = (found, theta.last()) else { return Ok(Vec::new()) };
    let places: Vec<f64> = theta.iter().map(|theta| theta / pair.speed).collect();
    let asked = SimulationRequest { duration: last / pair.speed, tolerance: STEPS, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    Ok(if run.complete { loads_of(&run) } else { Vec::new() })
}

/// What the sources that hold the block still and drive its crank from the ground say, with the opposite sign.
fn loads_of(run: &GraphRun) -> Vec<(f64, Loads)> {
    let of = |name: &str| run.values(name).unwrap_or_default();
    let efforts = ["hold_vx", "hold_vy", "hold_wx", "hold_wy", "hold_wz", "drive"]
        .map(|name| of(&format!("{name}.effort")));
    let theta = of("theta");
    let count = efforts.iter().map(|values| values.len()).fold(theta.len(), usize::min);
    let at = |k: usize| {
        let [x, y, mx, my, mz, drive] = efforts.map(|values| -values[k]);
        let real = |value: f64| Complex64::new(value, 0.0);
        (theta[k], [Complex64::new(x, y), Complex64::new(mx, my), real(mz), real(drive)])
    };
    // The first is that of the start.
    (1..count).map(at).collect()
}
