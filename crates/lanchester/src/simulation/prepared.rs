//! A run with its gas, friction and load, before it starts.

use crate::crosscheck::pair::CrossCheckError;
use crate::inertias::{rotating_bodies, rotor_inertia};
use crate::pressure::cylinders::GasReport;
use crate::pressure::measured::TraceFile;
use crate::pressure::simulated::gas_over_speed;
use crate::simulation::gas_torque::{chosen_load, friction_note, mean_and_friction};
use crate::simulation::plan::{RunPlan, SimulateRequest, plan};
use lanchester_file::EngineFile;
use lanchester_mechanism::LoadError;
use lanchester_model::{Engine, RotatingKind, RunLength};
use lanchester_multibody::{Drive, Duration, Load, LoadLaw, ReactsOn, Simulation, Train};
use std::f64::consts::{PI, TAU};

/// A run before it starts.
pub(crate) struct Prepared {
    pub train: Train,
    pub simulation: Simulation,
    pub length: RunLength,
    /// Samples from one that was asked for to the next.
    pub every: usize,
    /// Speed at which friction and the mean torque of the gas are judged [rad/s].
    pub reference_speed: f64,
    /// The gas at one speed or at several that rise; empty without gas.
    pub reports: Vec<GasReport>,
    /// Which of them is that at the reference speed.
    pub own: usize,
    /// Whether neither request nor file gives a load, so that the mean torque of the gas is it.
    pub is_load_chosen: bool,
    /// What the user should know.
    pub notes: Vec<String>,
}

/// Prepares the run of a file; `traces` holds the files that [`crate::trace_names`] names.
pub(crate) fn prepare(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &SimulateRequest,
) -> Result<Prepared, CrossCheckError> {
    let EngineFile { engine, tasks } = file;
    let input = tasks.simulation.as_deref();
    let mut train = Train::new(engine, &rotor_inertia(engine))?;
    let RunPlan { mut simulation, length, every, reference_speed: speed, mut notes } =
        plan(engine, input, &mut train, request)?;
    simulation.looks = looks(&simulation, engine.speed.highest);
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
        let (of_gas, parts) = mean_and_friction(engine, &report.cylinders, speed)?;
        mean = of_gas;
        [simulation.friction_torque, simulation.friction_growth[0], simulation.friction_growth[1]] = parts;
        if engine.friction.is_some() {
            notes.push(friction_note(parts, speed));
        }
        simulation.governor = input.and_then(|input| input.governor);
    } else if input.is_some_and(|input| input.governor.is_some()) {
        notes.push("Without gas the governor has nothing to act on: it is left out.".to_owned());
    }
    let in_file = input.and_then(|input| input.load.as_ref());
    let mut is_load_chosen = false;
    let law = match (&request.load, in_file) {
        (Some(law), _) => law.clone(),
        (None, Some(load)) => load.law.clone(),
        (None, None) if is_imposed || reports.is_empty() => LoadLaw::None,
        (None, None) => {
            is_load_chosen = true;
            let load = (mean - simulation.friction(speed)).max(0.0);
            let ratio = simulation.driveline.iter().map(|link| link.ratio).product();
            let is_periodic = length == RunLength::Periodic && simulation.governor.is_none();
            chosen_load(load, speed, ratio, is_periodic, &mut notes)
        }
    };
    let reacts_on = request.reacts_on.or(in_file.map(|load| load.reacts_on)).unwrap_or(ReactsOn::Ground);
    simulation.load = Load { law, reacts_on };
    notes.extend(unknown_inertias(engine, is_imposed));
    Ok(Prepared {
        train,
        simulation,
        length,
        every,
        reference_speed: speed,
        reports,
        own,
        is_load_chosen,
        notes,
    })
}

/// Crank angle between places where largest values are looked for, at most [rad], and most of them in a run.
const LOOKED_AT: f64 = TAU / 360.0;
const MOST_LOOKS: f64 = 1e6;

/// Places from one sample to the next at which largest values are looked for; `highest`: speed that a free run may come to [rad/s].
fn looks(simulation: &Simulation, highest: f64) -> usize {
    let fastest = match &simulation.drive {
        Drive::Imposed { profile, .. } => profile.iter().map(|[_, speed]| speed.abs()).fold(0.0, f64::max),
        Drive::Free => simulation.start_speed.abs().max(highest),
    };
    let turned = match simulation.duration {
        Duration::Revolutions(turns) => TAU * turns,
        Duration::Time(time) => fastest * time,
    };
    let parts = (simulation.step / LOOKED_AT * (1.0 - 1e-9)).ceil();
    if parts > 1.0 && turned / simulation.step * parts <= MOST_LOOKS { parts as usize } else { 1 }
}

/// What is told of bodies whose inertia is not known. At a free speed without any inertia of crankshaft 1 the run is refused instead.
fn unknown_inertias(engine: &Engine, is_imposed: bool) -> Option<String> {
    let bodies = rotating_bodies(engine);
    let unknown = bodies.iter().filter(|body| body.inertia.is_none() && body.kind != RotatingKind::Flywheel);
    let named: Vec<String> = unknown.map(|body| format!("\"{}\" (`{}`)", body.name, body.key)).collect();
    if named.is_empty() {
        return None;
    }
    let effect = match is_imposed {
        true => "their gyroscopic couples are left out",
        false => "the speed fluctuates by more than it would",
    };
    Some(format!(
        "Not known, and counted as 0: the moments of inertia of {}; {effect}. The key in brackets gives each, of a crankshaft [crank.body] too.",
        named.join(", ")
    ))
}
