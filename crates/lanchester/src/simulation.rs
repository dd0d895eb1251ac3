//! A run of the multibody simulation with the gas, friction and block of an engine file.

mod beside;
pub(crate) mod crank_bodies;
pub(crate) mod gas_torque;
mod heat;
pub(crate) mod mount_chains;
pub(crate) mod plan;
pub(crate) mod prepared;

use crate::crosscheck::pair::CrossCheckError;
use crate::pressure::measured::TraceFile;
use crate::pressure::simulated::GivenGas;
use crate::simulation::plan::action_words;
use crate::simulation::prepared::{Prepared, prepare};
pub use beside::simulation_beside;
use lanchester_file::EngineFile;
pub use lanchester_model::RunLength;
use lanchester_model::{Action, MainSharing, NamedPoint};
use lanchester_multibody::{BlockMotion, GasPressure, MainRule, Motion, Occasion, Run, RunOutcome, RunState};
use lanchester_report::{PeriodSummary, PeriodicResult, PointMotion, SIMULATION_VERSION, SimulationResult};
use nalgebra::Vector3;
pub use plan::{RunStart, SimulateRequest};
use std::f64::consts::PI;

/// Simulates `engine`; `traces` holds the files that [`crate::trace_names`] names.
///
/// ```
/// use lanchester::{RunLength, SimulateRequest, simulate};
///
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4.toml"));
/// let file = lanchester::file::read(text).file.expect("the example has no mistakes");
/// let length = Some(RunLength::Revolutions(2.0));
/// let request = SimulateRequest { imposed: Some(true), gravity: Some(false), length, ..SimulateRequest::default() };
/// let result = simulate(&file, &[], &request)?;
/// assert!(result.run.audit.energy < 1e-9 && result.run.audit.loops < 1e-12);
/// # Ok::<(), lanchester::CrossCheckError>(())
/// ```
///
/// # Errors
/// [`CrossCheckError`] where the file lacks something that the run needs.
pub fn simulate(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &SimulateRequest,
) -> Result<SimulationResult, CrossCheckError> {
    simulate_watched(file, traces, request, &|_| true)
}

/// The same; after every step `watch` sees how far the run is, and `false` ends it with the samples so far.
///
/// # Errors
/// As [`simulate`].
pub fn simulate_watched(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &SimulateRequest,
    watch: &dyn Fn(RunState) -> bool,
) -> Result<SimulationResult, CrossCheckError> {
    let engine = &file.engine;
    let input = file.tasks.simulation.as_deref();
    let Prepared { train, simulation, length, every, reports, own, mut notes, .. } =
        prepare(file, traces, request)?;
    let given = (!reports.is_empty()).then(|| GivenGas::over_speed(&reports));
    let gas = given.as_ref().map(|given| given as &dyn GasPressure);
    let (run, periodic) = match length {
        RunLength::Periodic => {
            let found = train.periodic_watched(&simulation, gas, watch)?;
            let (outcome, residual, iterations) = (found.outcome, found.residual, found.iterations);
            let (multipliers, followed) = (found.multipliers, found.followed);
            (found.run, Some(PeriodicResult { outcome, residual, iterations, multipliers, followed }))
        }
        _ => (train.run_watched(&simulation, gas, watch)?, None),
    };
    for (index, event) in simulation.events.iter().enumerate() {
        let came = run.events.iter().any(|happened| happened.what == Occasion::Event { index });
        if !came && periodic.is_none() {
            notes.push(format!("Event {} ({}) never came.", index + 1, action_words(&event.action)));
        }
    }
    if let Some(starter) = &simulation.starter
        && run.stall.is_none()
        && matches!(run.outcome, RunOutcome::Complete)
        && periodic.is_none()
        && simulation.start_speed < starter.until
        && !run.events.iter().any(|happened| happened.what == Occasion::StarterOff)
    {
        notes.push(format!(
            "The starter still turns the crank at the end: it comes to {:.0} rpm at the most, and lets go at {:.0} rpm.",
            run.extremes.speed.most.value * 30.0 / PI,
            starter.until * 30.0 / PI
        ));
    }
    let fastest = run.samples.speed.iter().fold(0.0f64, |most, speed| most.max(speed.abs()));
    if fastest > BEYOND * engine.speed.highest.max(simulation.start_speed) {
        notes.push(format!(
            "The engine comes to {:.0} rpm; the highest speed of the file is {:.0} rpm{}.",
            fastest * 30.0 / PI,
            engine.speed.highest * 30.0 / PI,
            if gas.is_some() { ", and beyond it pressures are those there" } else { "" }
        ));
    }
    let on_mounts = simulation.block == BlockMotion::Mounts;
    let named = input.map_or(&[][..], |input| &input.points).iter().chain(&request.points);
    let points = named.map(|point| motion_of(point, &run)).collect();
    let heat =
        given.as_ref().and_then(|_| heat::period_heat(engine, traces, &simulation, &run, train.revolutions));
    let mounts: Vec<String> =
        train.mounts.iter().filter(|_| on_mounts).map(|mount| mount.name.clone()).collect();
    let changes_fuel = |action: &Action| matches!(action, Action::Misfire(_) | Action::Fuel(_));
    let is_fired_throughout = !simulation.events.iter().any(|event| changes_fuel(&event.action))
        && (simulation.governor.is_none() || gas.is_none());
    let gears = train.rotors.iter().skip(1).map(|rotor| rotor.name.clone()).collect();
    Ok(SimulationResult {
        version: SIMULATION_VERSION,
        engine: engine.name.clone(),
        gas: reports.into_iter().nth(own).map(|report| report.source),
        notes,
        revolutions: train.revolutions,
        actions: simulation.events.iter().map(|event| action_words(&event.action)).collect(),
        period: PeriodSummary::of(&run, train.revolutions, &mounts),
        mounts,
        mains: train.rotors[..train.crankshafts].iter().map(|rotor| rotor.mains.clone()).collect(),
        main_rule: match input.and_then(|input| input.mains) {
            Some(MainSharing::Springs) => MainRule::Springs,
            Some(MainSharing::Beam) => MainRule::Beam,
            Some(MainSharing::Cut) | None => MainRule::Cut,
        },
        periodic,
        every,
        is_fired_throughout,
        gears,
        heat,
        points,
        run,
    })
}

/// A run whose speed goes so many times beyond the highest one of the file is told.
const BEYOND: f64 = 1.05;

/// Displacement of a point of the block at every sample.
fn motion_of(point: &NamedPoint, run: &Run) -> PointMotion {
    let at = Vector3::from(point.at);
    let places = run.samples.position.iter().zip(&run.samples.orientation);
    let displacement = places.map(|(position, orientation)| {
        let motion =
            Motion { position: (*position).into(), orientation: *orientation, ..Motion::fixed(0.0, 0.0) };
        (motion.position + motion.rotation() * at - at).into()
    });
    PointMotion { name: point.name.clone(), at: point.at, displacement: displacement.collect() }
}
