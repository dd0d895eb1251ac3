//! The bond graph's loads on the block and torque at imposed speed, held against the multibody simulation.
//!
//! A block that stands still has no flow, and so no effort that its graph could tell. Here it floats and is so heavy that the loads hardly move it:
//!
//! ```text
//! force = p',  moment = H'                 momenta of the block alone, whose mass and inertia are 10^14 kg and kg m^2
//! ```
//! At loads of 10^4 N it moves with 10^-10 m/s^2, which changes the loads by less than 10^-13 of theirs. It starts with 1 m/s, which changes no load, and with
//! 10^-12 rad/s, which changes them by less than 10^-12: momenta of 0 would leave the control of the steps nothing but rounding.

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::orders::order_rows;
use crate::crosscheck::pair::{CrossCheckError, Loads, Pair, loads_at};
use lanchester_bondgraph::{
    EngineBlock, EngineDrive, EngineRequest, Graph, Simulation as GraphRun, SimulationRequest, engine_graph,
    equations,
};
use lanchester_model::{Block, MovingParts};
use lanchester_report::CrossRow;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Largest share by which the two may differ.
const BAR: f64 = 1e-9;

/// Mass [kg] and moments of inertia [kg m^2] of the block.
const HEAVY: f64 = 1e14;

/// Tolerance of the steps: the loads follow from angle and speed, which are given.
const STEPS: f64 = 1e-6;

/// Velocity [m/s] and angular velocity [rad/s] of the block along every axis.
const DRIFT: f64 = 1.0;
const TURN: f64 = 1e-12;

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
    let block = Block {
        mass: HEAVY,
        centre: [0.0; 3],
        inertia: [HEAVY; 3],
        products: [0.0; 3],
        moving_parts: MovingParts::Added,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    };
    // Pistons and rods are the graph's own: the block counts without them.
    let Ok(engine) = pair.engine.with(|parts| {
        parts.block = Some(block);
        parts.mounts.clear();
    }) else {
        return Ok(Vec::new());
    };
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.block = EngineBlock::Space;
    (request.start.velocity, request.start.spin) = ([DRIFT; 3], [TURN; 3]);
    let (crankshafts, shafts) = pair.train.rotors.split_at(pair.train.crankshafts);
    request.crankshaft_inertia = crankshafts.iter().map(|rotor| rotor.inertia).collect();
    request.shaft_inertia = shafts.iter().map(|rotor| rotor.inertia).collect();
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    let description = engine_graph(&engine, &request)?;
    let found = Graph::new(&description).ok().and_then(|graph| equations(&graph).ok());
    let (Some(found), Some(last)) = (found, theta.last()) else { return Ok(Vec::new()) };
    let places: Vec<f64> = theta.iter().map(|theta| theta / pair.speed).collect();
    let asked = SimulationRequest { duration: last / pair.speed, tolerance: STEPS, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    Ok(if run.complete { loads_of(&run) } else { Vec::new() })
}

fn loads_of(run: &GraphRun) -> Vec<(f64, Loads)> {
    let of = |name: &str| run.values(name).unwrap_or_default();
    let [x, y] = ["block_x", "block_y"].map(|name| of(&format!("{name}.effort")));
    let [mx, my, mz] = ["x", "y", "z"].map(|axis| of(&format!("block_turn_{axis}.effort")));
    let (drive, theta) = (of("drive.effort"), of("theta"));
    let count = [x, y, mx, my, mz, drive, theta].map(<[f64]>::len).into_iter().min().unwrap_or(0);
    let real = |value: f64| Complex64::new(value, 0.0);
    // The drive sits on the block here: what the block gives to it belongs to the ground.
    let at = |k: usize| {
        let loads = [
            Complex64::new(x[k], y[k]),
            Complex64::new(mx[k], my[k]),
            real(mz[k] + drive[k]),
            real(-drive[k]),
        ];
        (theta[k], loads)
    };
    // The first is that of the start.
    (1..count).map(at).collect()
}
