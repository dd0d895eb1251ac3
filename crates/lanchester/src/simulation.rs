//! A run of the multibody simulation with the gas, friction and block of an engine file.

pub(crate) mod crank_bodies;
pub(crate) mod plan;

use crate::crosscheck::pair::CrossCheckError;
use crate::inertias::rotor_inertia;
use crate::pressure::measured::TraceFile;
use crate::pressure::simulated::{GivenGas, gas_over_speed};
use crate::simulation::plan::{RunPlan, action_words, plan};
use lanchester_file::EngineFile;
use lanchester_mechanism::{GasTrain, Lever, LoadError, TorqueRequest, torque};
pub use lanchester_model::RunLength;
use lanchester_model::{MainSharing, NamedPoint};
use lanchester_multibody::{
    BlockMotion, Drive, GasPressure, Load, LoadLaw, MainRule, Motion, Occasion, ReactsOn, Run, RunState,
    Train,
};
use lanchester_report::{PeriodicResult, PointMotion, SIMULATION_VERSION, SimulationResult};
use nalgebra::Vector3;
pub use plan::SimulateRequest;
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
    let EngineFile { engine, tasks } = file;
    let input = tasks.simulation.as_deref();
    let mut train = Train::new(engine, &rotor_inertia(engine))?;
    let RunPlan { mut simulation, length, reference_speed: speed, mut notes } =
        plan(engine, input, &mut train, request)?;
    simulation.torque = match input {
        Some(input) => input.torque_orders().map_err(LoadError::Unread)?,
        None => Vec::new(),
    };
    let is_imposed = matches!(simulation.drive, Drive::Imposed { .. });
    let is_constant = matches!(&simulation.drive, Drive::Imposed { profile, .. } if profile.len() == 1);
    let with_gas = request.gas.or(input.and_then(|input| input.gas)).unwrap_or(true);
    let (reports, own) = match (&engine.gas, with_gas) {
        (Some(_), true) => gas_over_speed(engine, traces, speed, !is_constant)?,
        (Some(_), false) => {
            notes.push("The gas of the file is left out.".to_owned());
            (Vec::new(), 0)
        }
        (None, _) => (Vec::new(), 0),
    };
    if let [first, .., last] = &reports[..] {
        notes.push(format!(
            "The pressures follow the speed, on straight lines between {} speeds from {:.0} to {:.0} rpm.",
            reports.len(),
            first.speed * 30.0 / PI,
            last.speed * 30.0 / PI
        ));
    }
    let mut mean = 0.0;
    if let Some(report) = reports.get(own) {
        mean = GasTrain::new(engine, &report.cylinders, Lever::Exact)?.mean_torques().iter().sum();
        if let Some(friction) = engine.friction {
            let found = torque(
                engine,
                &report.cylinders,
                &TorqueRequest { speed: Some(speed), samples: 4, max_order: 1, ..TorqueRequest::default() },
            )?;
            let brake = found.indicated.brake(&friction, speed);
            simulation.friction_torque = (found.indicated.torque - brake.torque).max(0.0);
            notes.push(format!(
                "Friction: {:.4} N m, its mean effective pressure at {:.0} rpm as a constant torque.",
                simulation.friction_torque,
                speed * 30.0 / PI
            ));
        }
        simulation.governor = input.and_then(|input| input.governor);
    } else if input.is_some_and(|input| input.governor.is_some()) {
        notes.push("Without gas the governor has nothing to act on: it is left out.".to_owned());
    }
    let in_file = input.and_then(|input| input.load.as_ref());
    let law = match (&request.load, in_file) {
        (Some(law), _) => law.clone(),
        (None, Some(load)) => load.law.clone(),
        (None, None) if is_imposed || reports.is_empty() => LoadLaw::None,
        (None, None) => {
            let load = (mean - simulation.friction_torque).max(0.0);
            notes.push(format!(
                "Load: {load:.4} N m, constant, the mean that the engine gives at {:.0} rpm.",
                speed * 30.0 / PI
            ));
            LoadLaw::Constant(load)
        }
    };
    let reacts_on = request.reacts_on.or(in_file.map(|load| load.reacts_on)).unwrap_or(ReactsOn::Ground);
    simulation.load = Load { law, reacts_on };
    if let Some(rotor) = train.unknown_inertia() {
        notes.push(format!("The moment of inertia of {} is not known: it counts as 0.", rotor.name));
    }
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
    let on_mounts = simulation.block == BlockMotion::Mounts;
    let named = input.map_or(&[][..], |input| &input.points).iter().chain(&request.points);
    let points = named.map(|point| motion_of(point, &run)).collect();
    let gears = train.rotors.iter().skip(1).map(|rotor| rotor.name.clone()).collect();
    Ok(SimulationResult {
        version: SIMULATION_VERSION,
        engine: engine.name.clone(),
        gas: reports.into_iter().nth(own).map(|report| report.source),
        notes,
        revolutions: train.revolutions,
        actions: simulation.events.iter().map(|event| action_words(&event.action)).collect(),
        mounts: train.mounts.iter().filter(|_| on_mounts).map(|mount| mount.name.clone()).collect(),
        mains: train.rotors[..train.crankshafts].iter().map(|rotor| rotor.mains.clone()).collect(),
        main_rule: match input.and_then(|input| input.mains) {
            Some(MainSharing::Springs) => MainRule::Springs,
            Some(MainSharing::Beam) => MainRule::Beam,
            Some(MainSharing::Cut) | None => MainRule::Cut,
        },
        periodic,
        gears,
        points,
        run,
    })
}

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
