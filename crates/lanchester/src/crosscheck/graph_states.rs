//! The gas as states of the bond graph held against the computed cycle, and its compliant joints against the reactions.

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::rungs::{CrossCheckError, Pair};
use lanchester_bondgraph::{
    CompliantJoints, EngineDrive, EngineJoints, EngineRequest, GasStates, Graph, Simulation as GraphRun,
    SimulationRequest, engine_graph, equations,
};
use lanchester_report::CrossRow;
use std::f64::consts::TAU;

/// Share of the peak by which the pressures may differ, and the tolerance of the steps.
const GAS_BAR: f64 = 1e-6;
const GAS_STEPS: f64 = 1e-10;
/// Cycles until what is left of the start is below the bar, and samples of the one that is compared.
const CYCLES: f64 = 14.0;
const GAS_SAMPLES: u32 = 240;

/// Share by which forces of compliant joints may differ from those of rigid ones.
const JOINT_BAR: f64 = 1e-2;
/// Stiffness of pins and skirts [N/m] and damping ratio: stiff enough for the bar, soft enough for a short run.
const JOINTS: [f64; 3] = [4e9, 2e9, 0.7];
const JOINT_STEPS: f64 = 1e-7;
const JOINT_SAMPLES: u32 = 180;
/// Share of a cycle in which the dampers settle: springs start with their forces, but at rest.
const SETTLES: f64 = 0.125;

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

/// Forces that ideal joints do not show, from compliant ones: side thrust, pins.
pub(crate) fn joint_rows(pair: &Pair<'_>) -> Result<Vec<CrossRow>, CrossCheckError> {
    let [stiffness, skirt_stiffness, damping_ratio] = JOINTS;
    let joints = CompliantJoints { stiffness, skirt_stiffness, damping_ratio, ..CompliantJoints::default() };
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.joints = EngineJoints::Compliant(joints);
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    let turns = if pair.gas.is_some() { f64::from(pair.engine.strokes.revolutions()) } else { 1.0 };
    // Bodies without mass cannot move by themselves: such an engine has ideal joints alone.
    let Ok(Some(run)) = imposed(pair, request, (SETTLES, JOINT_SAMPLES), turns, JOINT_STEPS) else {
        return Ok(Vec::new());
    };
    let shares = pair.train.main_shares(&[]);
    let of = |name: String| run.values(&name).unwrap_or_default();
    let theta = of("theta".into());
    // Of each kind: largest of ours, of theirs, of the difference.
    let mut kinds = [[0.0f64; 3]; 3];
    for (sample, theta) in theta.iter().enumerate().skip(1) {
        let theirs = pair.reactions(*theta, &shares);
        for (index, theirs) in theirs.cylinders.iter().enumerate() {
            let k = index + 1;
            // Spring and damper of a joint.
            let force = |name: String| -> f64 {
                let of =
                    |part: &str| of(format!("{name}_{part}.effort")).get(sample).copied().unwrap_or(f64::NAN);
                of("spring") + of("damper")
            };
            let [cos, sin] = [pair.train.cylinders[index].axis.re, pair.train.cylinders[index].axis.im];
            let (along, across) = (force(format!("pin{k}_along")), force(format!("pin{k}_across")));
            let pin = [along * cos - across * sin, along * sin + across * cos];
            let lower = ["x", "y"].map(|axis| force(format!("crankpin{k}_{axis}")));
            let side = force(format!("contact{k}_1")) + force(format!("contact{k}_2"));
            let pairs = [
                ([side, 0.0], [theirs.side_thrust, 0.0]),
                (pin, [theirs.piston_pin.force[0], theirs.piston_pin.force[1]]),
                (lower, [theirs.lower_pin.force[0], theirs.lower_pin.force[1]]),
            ];
            for (kind, (ours, theirs)) in kinds.iter_mut().zip(pairs) {
                let size = |force: [f64; 2]| force[0].hypot(force[1]);
                let off = size([ours[0] - theirs[0], ours[1] - theirs[1]]);
                kind[0] = kind[0].max(size(ours));
                kind[1] = kind[1].max(size(theirs));
                kind[2] = if off.is_nan() { f64::INFINITY } else { kind[2].max(off) };
            }
        }
    }
    let names = ["side thrust", "piston pins", "crankpins and knuckle pins"];
    let largest = kinds.iter().fold(0.0f64, |most, kind| most.max(kind[1]));
    let rows = names.into_iter().zip(kinds).map(|(name, [ours, theirs, off])| {
        let scale = theirs.max(0.1 * largest);
        let name = format!("{name}, bond graph with compliant joints");
        let mut row = CrossRow::held(&name, "N", None, [ours, theirs, off, scale], JOINT_BAR);
        (row.closed_form, row.bond_graph) = (None, row.closed_form);
        row.reason = Some("ideal joints of the bond graph have no pins and walls".into());
        row
    });
    Ok(rows.collect())
}
