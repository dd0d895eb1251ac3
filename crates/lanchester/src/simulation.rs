//! A run of the multibody simulation with the gas, friction and block of an engine file.

use crate::crosscheck::{CrossCheckError, rotor_inertia};
use crate::pressure::{TraceFile, cylinder_gas};
use crate::simulated_gas::GivenGas;
use lanchester_mechanism::{GasTrain, Lever, TorqueRequest, torque};
use lanchester_model::Engine;
use lanchester_multibody::{
    Action, BlockMotion, Duration, Event, GasPressure, Load, LoadLaw, ReactsOn, STANDARD_GRAVITY, Simulation,
    Train, When,
};
use lanchester_report::{PeriodicResult, SIMULATION_VERSION, SimulationResult};

/// What to simulate; the rest follows from the engine.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulateRequest {
    /// Speed of crankshaft 1 at the start [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// How long.
    pub length: RunLength,
    /// Whether the speed is imposed; else it is free.
    pub imposed: bool,
    /// Whether the block moves on its mounts; `None`: where the file gives them in a form that a run can use.
    pub on_mounts: Option<bool>,
    /// Whether weight acts.
    pub gravity: bool,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// Torque of the load [N m]; `None`: with gas the mean that the engine gives at the start speed, without none.
    pub load: Option<LoadLaw>,
    /// Where the reaction to the load goes.
    pub reacts_on: ReactsOn,
    /// Cylinders, by index, that fire no more after the first revolution.
    pub misfire: Vec<usize>,
    /// Crank angle between samples [rad].
    pub step: f64,
    /// Tolerance of every step.
    pub tolerance: f64,
    /// Most evaluations of the equations of motion.
    pub most_evaluations: u64,
}

/// How long a run lasts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RunLength {
    /// Revolutions of crankshaft 1.
    Revolutions(f64),
    /// Seconds.
    Time(f64),
    /// One period of the periodic motion.
    Periodic,
}

impl Default for SimulateRequest {
    /// Ten revolutions at free speed from the highest of the engine, samples every degree.
    fn default() -> Self {
        SimulateRequest {
            speed: None,
            length: RunLength::Revolutions(10.0),
            imposed: false,
            on_mounts: None,
            gravity: true,
            gas: true,
            load: None,
            reacts_on: ReactsOn::Ground,
            misfire: Vec::new(),
            step: std::f64::consts::PI / 180.0,
            tolerance: 1e-9,
            most_evaluations: 10_000_000,
        }
    }
}

/// Simulates `engine`; `traces` holds the files that [`crate::trace_names`] names.
///
/// ```
/// use lanchester::{RunLength, SimulateRequest, simulate};
///
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4.toml"));
/// let engine = lanchester::file::read(text).engine().expect("the example has no mistakes");
/// let request = SimulateRequest { imposed: true, gravity: false, length: RunLength::Revolutions(2.0), ..SimulateRequest::default() };
/// let result = simulate(&engine, &[], &request)?;
/// assert!(result.run.audit.energy < 1e-9 && result.run.audit.loops < 1e-12);
/// # Ok::<(), lanchester::CrossCheckError>(())
/// ```
///
/// # Errors
/// [`CrossCheckError`] where the file lacks something that the run needs.
pub fn simulate(
    engine: &Engine,
    traces: &[TraceFile],
    request: &SimulateRequest,
) -> Result<SimulationResult, CrossCheckError> {
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let mut notes = Vec::new();
    let report = match (&engine.gas, request.gas) {
        (Some(_), true) => Some(cylinder_gas(engine, traces, speed)?),
        (Some(_), false) => {
            notes.push("The gas of the file is left out.".to_owned());
            None
        }
        (None, _) => None,
    };
    let train = Train::new(engine, &rotor_inertia(engine))?;
    let mut simulation = match request.imposed {
        true => Simulation::imposed(speed, 1.0),
        false => Simulation::free(speed, 1.0),
    };
    match request.length {
        RunLength::Revolutions(turns) => simulation.duration = Duration::Revolutions(turns),
        RunLength::Time(time) => simulation.duration = Duration::Time(time),
        RunLength::Periodic => {}
    }
    simulation.step = request.step;
    simulation.tolerance = request.tolerance;
    simulation.most_evaluations = request.most_evaluations;
    simulation.reactions = true;
    simulation.gravity = if request.gravity { STANDARD_GRAVITY } else { 0.0 };
    let can_move =
        train.fixed_because.is_none() && train.mounts.iter().all(|mount| !mount.frequency_dependent);
    if request.on_mounts.unwrap_or(can_move) {
        simulation.block = BlockMotion::Mounts;
    } else {
        let given = train
            .fixed_because
            .clone()
            .unwrap_or_else(|| "a mount's stiffness or loss depends on frequency".into());
        let because = if can_move { "as asked for".to_owned() } else { given };
        notes.push(format!("The block is fixed: {because}."));
    }
    let mut mean = 0.0;
    if let Some(report) = &report {
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
                "Friction: {:.4} N m, its mean effective pressure at the start speed as a constant torque.",
                simulation.friction_torque
            ));
        }
    }
    let law = match &request.load {
        Some(law) => law.clone(),
        None if request.imposed || report.is_none() => LoadLaw::None,
        None => {
            let load = mean - simulation.friction_torque;
            notes.push(format!(
                "Load: {load:.4} N m, constant, the mean that the engine gives at the start speed."
            ));
            LoadLaw::Constant(load)
        }
    };
    simulation.load = Load { law, reacts_on: request.reacts_on };
    for &cylinder in &request.misfire {
        let when = When::Angle(std::f64::consts::TAU);
        simulation.events.push(Event { when, action: Action::Misfire(cylinder) });
    }
    if let Some(rotor) = train.unknown_inertia() {
        notes.push(format!("The moment of inertia of {} is not known: it counts as 0.", rotor.name));
    }
    let given = report.as_ref().map(|report| GivenGas::new(&report.cylinders));
    let gas = given.as_ref().map(|given| given as &dyn GasPressure);
    let (run, periodic) = match request.length {
        RunLength::Periodic => {
            let found = train.periodic(&simulation, gas)?;
            let (outcome, residual, iterations) = (found.outcome, found.residual, found.iterations);
            (
                found.run,
                Some(PeriodicResult { outcome, residual, iterations, multipliers: found.multipliers }),
            )
        }
        _ => (train.run(&simulation, gas)?, None),
    };
    let on_mounts = simulation.block == BlockMotion::Mounts;
    Ok(SimulationResult {
        version: SIMULATION_VERSION,
        engine: engine.name.clone(),
        gas: report.map(|report| report.source),
        notes,
        revolutions: train.revolutions,
        mounts: train.mounts.iter().filter(|_| on_mounts).map(|mount| mount.name.clone()).collect(),
        mains: train.rotors[..train.crankshafts].iter().map(|rotor| rotor.mains.clone()).collect(),
        periodic,
        run,
    })
}
