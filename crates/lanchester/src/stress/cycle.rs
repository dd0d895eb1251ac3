//! A flexible crankshaft in its bearings over the cycle: mesh and laws from the engine file, gas and masses as everywhere, the crank train of `flex`.

pub(crate) mod free;
pub(crate) mod housed_law;
pub(crate) mod laws;
pub(crate) mod request;
mod results;
pub(crate) mod rules;
pub(crate) mod train;

use crate::pressure::cylinders::{CylinderCycle, GasReport, cylinder_gas};
use crate::pressure::measured::TraceFile;
use crate::stress::fatigue::fatigue_measure;
use crate::stress::request::{StressError, StressStage};
use crate::stress::run::{check_crankshaft, sheet};
use free::{free_start, run_law};
use lanchester_flex::train::{BasisOptions, CycleOptions, CycleState, crank_basis};
use lanchester_mechanism::{BearingPart, BearingRequest, bearing_loads};
use lanchester_model::{Engine, Housing};
use lanchester_report::{CRANK_CYCLE_VERSION, CrankCycle, CrankKind, CycleLaw, CycleRun};
use laws::BearingLaws;
pub use request::CycleRequest;
use results::{FilletStress, cycle_run};
use rules::main_rules;
use std::f64::consts::TAU;
use train::{Composed, bearing_places, gas_force};

/// What is said of largest values under a pressure that jumps.
const RINGING: &str = "The pressure of an ideal cycle jumps: crankshaft and bearings ring behind it as they never do in an engine, and the largest values are those of the ringing. Take a measured pressure or the single zone.";

/// How far a computation is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleStage {
    /// Meshing and solving.
    Mesh(StressStage),
    /// The crankshaft has so many coordinates, its fillets so many nodes.
    Reduced(usize, usize),
    /// A run.
    Running {
        /// The law.
        law: CycleLaw,
        /// The crankshaft.
        crank: CrankKind,
        /// How far it is.
        state: CycleState,
    },
}

/// A crankshaft in its bearings over the cycle. `watch` sees how far it is; `false` ends it with the runs so far and the last whole cycle of the one that runs.
/// `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`StressError`] where the file says too little, the shape is not covered, or the factor needs more memory than allowed.
pub fn crank_cycle(
    engine: &Engine,
    traces: &[TraceFile],
    request: &CycleRequest,
    watch: &dyn Fn(CycleStage) -> bool,
) -> Result<CrankCycle, StressError> {
    check_crankshaft(engine, &request.mesh)?;
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let gas = match &engine.gas {
        Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed)?),
        _ => None,
    };
    let cylinders = gas.as_ref().map(|gas| gas.cylinders.as_slice());
    let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
    let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
    let loads = bearing_loads(engine, cylinders, &asked)?;
    let mut notes = Vec::new();
    // What may be refused at once is, before the mesh.
    let places = bearing_places(engine, request.mesh.crankshaft)?;
    let laws = BearingLaws::new(engine, &loads, &places, &request.laws, request.tilt, &mut notes)?;
    if places.iter().any(|own| matches!(own.data.housing, Some(Housing::Stiffness(_)))) {
        notes.push(
            "Housings that yield: behind the shells of films; in series with the stiffness of contacts and bushings; rigid bearings know none."
                .to_owned(),
        );
    }
    let measure = fatigue_measure(engine, request.factors)?;
    let yielding = engine.crank_material.unwrap_or_default().yield_strength();
    let free = free_start(engine, cylinders, request, speed, loads.period)?;
    let mesh_watch = |stage| {
        watch(CycleStage::Mesh(stage));
    };
    let sheet = sheet(engine, &request.mesh, &mesh_watch)?;
    let surfaces: Vec<_> = places.iter().map(|own| own.surface.clone()).collect();
    let estimate = |estimate: &_| mesh_watch(StressStage::Factoring(*estimate));
    let damping = request::damping(request, engine).0;
    let basis = BasisOptions { damping, tilt: request.tilt, ..request.basis };
    let basis = crank_basis(&sheet.crank, &surfaces, basis, &estimate)?;
    watch(CycleStage::Reduced(basis.body.size(), basis.stress.nodes()));
    let turns = (loads.period / TAU).round().max(1.0) as usize;
    let options = CycleOptions {
        samples: turns * request.instants,
        most_cycles: request.most_cycles,
        ..CycleOptions::default()
    };
    let force = |index: usize, theta: f64| gas_force(engine, gas.as_ref(), index, theta);
    let composed = Composed::new(engine, &force, speed, loads.period, &places);
    let mut kinds = vec![CrankKind::Flexible];
    kinds.extend(request.rigid_crank.then_some(CrankKind::Rigid));
    let mains = places.iter().filter(|own| own.is_main()).count();
    let mut runs: Vec<CycleRun> = Vec::new();
    let mut stopped = false;
    for law in &request.laws {
        for kind in &kinds {
            if stopped {
                continue;
            }
            let body = match kind {
                CrankKind::Flexible => basis.body.clone(),
                CrankKind::Rigid => basis.body.rigid(),
            };
            let train = composed.train(body, laws.of(*law));
            let rigid = train.mains.iter().filter(|main| main.law.is_rigid()).count();
            if *kind == CrankKind::Rigid && rigid > 2 {
                notes.push(format!(
                    "A rigid crankshaft on {mains} rigid bearings has no loads of its own: left out."
                ));
                continue;
            }
            let run_watch = |state: CycleState| watch(CycleStage::Running { law: *law, crank: *kind, state });
            let found = run_law(train, free.as_ref(), options, &run_watch)?;
            stopped = found.stopped();
            let stress = (*kind == CrankKind::Flexible).then_some(FilletStress {
                basis: &basis.stress,
                findley: measure.as_ref().map(|own| &own.findley),
                yielding: yielding.map(|own| own.value),
            });
            runs.push(cycle_run(*law, *kind, &found, &places, &laws, stress)?);
        }
    }
    if stopped {
        notes.push("Stopped before its end: what had been computed is told.".to_owned());
    }
    if sheet.crank.corners.iter().all(|corner| corner.nodes.is_empty()) {
        notes.push(
            "No fillet has a radius: the stress of a sharp corner is unbounded; give pin_fillet and journal_fillet in [crank.body]."
                .to_owned(),
        );
    }
    let theta: Vec<f64> =
        (0..options.samples).map(|k| loads.period * k as f64 / options.samples as f64).collect();
    let rules = match main_rules(engine, cylinders, speed, &theta, request.mesh.crankshaft) {
        Ok(rules) => Some(rules),
        Err(reason) => {
            notes.push(format!("No comparison with the rules of a rigid crankshaft: {reason}."));
            None
        }
    };
    let is_ideal = |gas: &GasReport| {
        gas.cycles.iter().any(|own| matches!(&own.cycle, CylinderCycle::Ideal(ideal) if ideal.heat > 0.0))
    };
    let ringing = gas.as_ref().is_some_and(is_ideal).then(|| RINGING.to_owned());
    notes.extend(match &measure {
        Some(own) => own.estimated(),
        None => Some("No safety against fatigue: [crank.material] gives no strength; add tensile_strength or a preset.".to_owned()),
    });
    notes.extend(left_out(engine, request, &sheet.crank.left_out));
    Ok(CrankCycle {
        version: CRANK_CYCLE_VERSION,
        speed,
        period: loads.period,
        motion: request.motion,
        gas: gas.map(|gas| gas.source),
        coordinates: basis.body.size(),
        stress_nodes: basis.stress.nodes(),
        frequencies: basis.frequencies,
        options,
        rules,
        runs,
        ringing,
        fatigue: measure,
        notes,
        sheet,
    })
}

/// What the model leaves out.
fn left_out(engine: &Engine, request: &CycleRequest, unmeshed: &[String]) -> Vec<String> {
    let (damping, source) = request::damping(request, engine);
    let films = request.laws.iter().any(|law| matches!(law, CycleLaw::Film | CycleLaw::File));
    let tilt = if films && !request.tilt { "tilt of journals in the law of the film, " } else { "" };
    let mut notes = vec![format!(
        "Left out: gravity, friction couples, tilt and axial motion of rods, motion of the crankshaft along its axis, {tilt}\
         deformation of shells and block. Material: {} % of critical damping in every mode, {source}.",
        100.0 * damping
    )];
    if !unmeshed.is_empty() {
        notes.push(
            "Masses that are not meshed load the bearings of the rules, not those of the runs.".to_owned(),
        );
    }
    notes
}
