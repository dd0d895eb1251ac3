//! The bond graph held against the multibody simulation: everything free, the same pressures.
//!
//! Both integrate what they derive from the engine file themselves. Quantities: crank angle and speed, rotation of the block, deflection
//! of the mounts along their directions.

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::pair::{CrossCheckError, Pair};
use crate::pressure::simulated::GivenGas;
use lanchester_bondgraph::{
    EngineBlock, EngineLoad, EngineRequest, Graph, Simulation as GraphRun, SimulationRequest, engine_graph,
    equations,
};
use lanchester_mechanism::{GasTrain, Lever};
use lanchester_multibody::{
    BlockMotion, BlockStart, GasPressure, LoadLaw, Motion, Run, RunOutcome, STANDARD_GRAVITY, Simulation,
};
use lanchester_report::CrossRow;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Largest share by which the two may differ.
const BAR: f64 = 1e-8;

/// Tolerance of the steps of both: pieces of a pressure meet with jumps of their second derivative, which cost digits.
const STEPS: f64 = 1e-13;

/// Revolutions compared, and samples of each.
const REVOLUTIONS: f64 = 10.0;
const SAMPLES: f64 = 12.0;

/// A quantity: its name and unit, and the pairs of series of which it is made, ours and theirs.
type Quantity = (&'static str, &'static str, Vec<[Vec<f64>; 2]>);

/// Condition D, or why it does not apply.
pub(crate) fn all_free(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    let train = &pair.train;
    if let Some(rotor) = train.rotors[..train.crankshafts].iter().find(|rotor| !rotor.known) {
        return Ok(Err(format!(
            "the inertia of {} is not known: [flywheel] inertia and crankshaft_inertia or [crank.body] give it",
            rotor.name
        )));
    }
    let moves = train.fixed_because.is_none() && train.mounts.iter().all(|mount| !mount.frequency_dependent);
    let load = match pair.gas {
        Some(gas) => GasTrain::new(pair.engine, gas, Lever::Exact)?.mean_torques().iter().sum(),
        None => 0.0,
    };
    let run = simulated(pair, moves, load)?;
    if run.outcome != RunOutcome::Complete {
        return Ok(Err("the simulated engine does not turn ten times".into()));
    }
    let mut request = EngineRequest::free(pair.speed, REVOLUTIONS);
    request.block = if moves { EngineBlock::Space } else { EngineBlock::Fixed };
    request.mounts = moves;
    request.gravity = STANDARD_GRAVITY;
    let (crankshafts, shafts) = train.rotors.split_at(train.crankshafts);
    request.crankshaft_inertia = crankshafts.iter().map(|rotor| rotor.inertia).collect();
    request.shaft_inertia = shafts.iter().map(|rotor| rotor.inertia).collect();
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    request.load = EngineLoad { torque: load_torque(load), reacts_on_block: false };
    let description = engine_graph(pair.engine, &request)?;
    let refused = || Ok(Err("its bond graph has no causality".into()));
    let Ok(graph) = Graph::new(&description) else { return refused() };
    let Ok(found) = equations(&graph) else { return refused() };
    let asked = SimulationRequest { duration: run.end[0], tolerance: STEPS, ..found.request() };
    let ours = found.simulate_at(&asked, &run.samples.time[1..]);
    if !ours.complete {
        return Ok(Err(format!("the bond graph's run ends early: {}", ours.ended)));
    }
    Ok(Ok(quantities(pair, &ours, &run, moves).into_iter().map(row).collect()))
}

fn load_torque(load: f64) -> LoadLaw {
    if load == 0.0 { LoadLaw::None } else { LoadLaw::Constant(load) }
}

fn simulated(pair: &Pair<'_>, moves: bool, load: f64) -> Result<Run, CrossCheckError> {
    let mut simulation = Simulation::free(pair.speed, REVOLUTIONS);
    simulation.block = if moves { BlockMotion::Mounts } else { BlockMotion::Fixed };
    simulation.block_start = BlockStart::AsDrawn;
    simulation.gravity = STANDARD_GRAVITY;
    simulation.step = TAU / SAMPLES;
    simulation.tolerance = STEPS;
    simulation.load.law = LoadLaw::Constant(load);
    let given = pair.gas.map(GivenGas::new);
    let gas = given.as_ref().map(|given| given as &dyn GasPressure);
    Ok(pair.train.run(&simulation, gas)?)
}

fn quantities(pair: &Pair<'_>, ours: &GraphRun, run: &Run, moves: bool) -> Vec<Quantity> {
    let samples = &run.samples;
    let own = |name: &str| ours.values(name).map(<[f64]>::to_vec).unwrap_or_default();
    let mut found: Vec<Quantity> = vec![
        ("crank angle", "rad", vec![[own("theta"), samples.theta.clone()]]),
        ("speed", "rad/s", vec![[own("crank.flow"), samples.speed.clone()]]),
    ];
    if !moves {
        return found;
    }
    let spins = ["wx.flow", "wy.flow", "wz.flow"]
        .into_iter()
        .enumerate()
        .map(|(k, name)| [own(name), samples.spin.iter().map(|spin| spin[k]).collect()]);
    found.push(("rotation of the block", "rad/s", spins.collect()));
    let mut deflections = Vec::new();
    for (index, mount) in pair.engine.mounts.iter().enumerate() {
        let Some(spring) = &mount.spring else { continue };
        let at = Vector3::new(mount.x, mount.y, mount.z);
        for (way, axis) in spring.axes.iter().enumerate().filter(|(way, _)| spring.stiffness[*way] != 0.0) {
            let theirs = samples.position.iter().zip(&samples.orientation).map(|(position, orientation)| {
                let motion = Motion { orientation: *orientation, ..Motion::fixed(0.0, 0.0) };
                (Vector3::from(*position) + motion.rotation() * at - at).dot(&Vector3::from(*axis))
            });
            let name = format!("mount{}_{}_spring.displacement", index + 1, way + 1);
            deflections.push([own(&name), theirs.collect()]);
        }
    }
    found.push(("deflection of the mounts", "m", deflections));
    found
}

/// Largest values and the largest difference; series of different length differ beyond any bar.
fn row((name, unit, pairs): Quantity) -> CrossRow {
    let largest = |side: usize| {
        pairs.iter().flat_map(|pair| &pair[side]).fold(0.0f64, |most, value| most.max(value.abs()))
    };
    let mut off = 0.0f64;
    for [ours, theirs] in &pairs {
        if ours.len() != theirs.len() {
            off = f64::INFINITY;
        }
        for (a, b) in ours.iter().zip(theirs) {
            off = off.max((a - b).abs());
        }
    }
    let scale = largest(1).max(f64::MIN_POSITIVE);
    let name = format!("{name}, bond graph");
    let mut row = CrossRow::held(&name, unit, None, [largest(0), largest(1), off, scale], BAR);
    (row.closed_form, row.bond_graph) = (None, row.closed_form);
    row
}
