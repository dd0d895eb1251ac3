//! The crank train with free speed as a model that other programs step through: functional mock-up units.

use crate::crosscheck::pair::CrossCheckError;
use crate::pressure::measured::TraceFile;
use crate::pressure::simulated::GivenGas;
use crate::simulation::gas_torque::CHOSEN_LOAD;
use crate::simulation::plan::CLOSE_SAMPLES;
use crate::simulation::plan::{SimulateRequest, action_words};
use crate::simulation::prepared::{Prepared, prepare};
use lanchester_exchange::{FmuKind, FmuRole, FmuVariable};
use lanchester_file::EngineFile;
use lanchester_model::RunLength;
use lanchester_multibody::{
    Advance, BlockMotion, GasPressure, LoadLaw, MultibodyError, Occasion, RunOutcome, Samples, Simulation,
    StepInputs, Stepper, StepperState, Train,
};
use nalgebra::{Quaternion, UnitQuaternion};
use std::f64::consts::TAU;

/// Why the crank train did not reach the time that it was to go on to.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CrankTrainFault {
    /// The engine, its inputs or the time.
    #[error(transparent)]
    Multibody(#[from] MultibodyError),
    /// The step would need more evaluations than a single one may.
    #[error("the step needs more than {limit} evaluations of the equations of motion: take a shorter one")]
    TooManyEvaluations {
        /// Largest number of a step.
        limit: u64,
    },
    /// The integrator found no way on.
    #[error(
        "the step fails at crank angle {theta} rad: {} cannot be computed further",
        .quantity.unwrap_or("the motion")
    )]
    Failed {
        /// Crank angle of the last good state [rad].
        theta: f64,
        /// What became no number, where something did.
        quantity: Option<&'static str>,
    },
}

/// What a step came to.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankTrainStep {
    /// The time that it ended at [s since the start]: an event of the file may stop the run before what was asked for.
    pub time: f64,
    /// Whether an event of the file stopped the run.
    pub is_stopped: bool,
    /// What happened on the way, in words.
    pub happened: Vec<String>,
}

/// The crank train of an engine file at free speed as [`crate::simulate`] runs it, advanced step by step with inputs that are held over a step.
///
/// Gas, friction, governor, starter, driveline, mounts, weight and events are those of the file. The torque of the input is added to the load of the file; a file
/// without `[load]` leaves the load to the input, which starts with the constant torque that [`crate::simulate`] takes then.
pub struct CrankTrainModel {
    name: String,
    train: Train,
    simulation: Simulation,
    gas: Option<GivenGas<'static>>,
    load: f64,
    duration: f64,
    highest_speed: f64,
    notes: Vec<String>,
}

/// All of a crank train that changes: a copy is a saved state.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankTrainState {
    /// Inputs.
    pub inputs: StepInputs,
    /// Speed of crankshaft 1 at the start [rad/s].
    pub start_speed: f64,
    /// Crank angle at the start [rad].
    pub start_angle: f64,
    /// Once it has started.
    progress: Option<StepperState>,
}

/// An output: name, description and unit.
type Output = (String, String, &'static str);

impl CrankTrainModel {
    /// Reference of the torque of the load [N m], an input.
    pub const LOAD_TORQUE: u32 = 1;
    /// Reference of the factor on the fired part of the gas, an input.
    pub const FUEL: u32 = 2;
    /// Reference of the speed at the start [rad/s], a parameter.
    pub const START_SPEED: u32 = 3;
    /// Reference of the crank angle at the start [rad], a parameter.
    pub const START_ANGLE: u32 = 4;
    /// Reference of the first output, the crank angle; the others follow.
    pub const FIRST_OUTPUT: u32 = 5;

    /// The crank train of a file, prepared; `traces` holds the files that [`crate::trace_names`] names. An imposed speed of the file is that of the start.
    ///
    /// # Errors
    /// [`CrossCheckError`] where the file lacks something that a run at free speed needs.
    pub fn new(file: &EngineFile, traces: &[TraceFile]) -> Result<CrankTrainModel, CrossCheckError> {
        let request = SimulateRequest { imposed: Some(false), ..SimulateRequest::default() };
        let prepared = prepare(file, traces, &request)?;
        let Prepared {
            train,
            mut simulation,
            length,
            reference_speed,
            reports,
            is_load_chosen,
            mut notes,
            ..
        } = prepared;
        simulation.reactions = false;
        // A unit has no samples of its own: the host asks when it will.
        notes.retain(|note| !note.starts_with(CLOSE_SAMPLES));
        let mut load = 0.0;
        if is_load_chosen
            && let LoadLaw::Constant(torque) | LoadLaw::Viscous { torque, .. } = simulation.load.law
        {
            (load, simulation.load.law) = (torque, LoadLaw::None);
            notes.retain(|note| !note.starts_with(CHOSEN_LOAD));
            notes.push(format!(
                "The file gives no load: the input starts with {load:.4} N m, the mean torque that the engine gives at its start speed."
            ));
        }
        let revolution = TAU / reference_speed;
        let duration = match length {
            RunLength::Revolutions(turns) => turns * revolution,
            RunLength::Time(time) => time,
            RunLength::Periodic => f64::from(train.revolutions) * revolution,
        };
        let gas = (!reports.is_empty()).then(|| GivenGas::over_speed(&reports).owned());
        let engine = &file.engine;
        let mut model = CrankTrainModel {
            name: engine.name.clone(),
            train,
            simulation,
            gas,
            load,
            duration,
            highest_speed: engine.speed.highest,
            notes,
        };
        // What cannot start is refused here.
        let state = model.state();
        model.outputs(&state)?;
        Ok(model)
    }

    /// Name of the engine.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Duration of the run that the file describes [s].
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Highest speed of the file [rad/s].
    pub fn highest_speed(&self) -> f64 {
        self.highest_speed
    }

    /// What the user should know of the run.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Whether gas presses.
    pub fn has_gas(&self) -> bool {
        self.gas.is_some()
    }

    /// Before the start, with the inputs and parameters of the file.
    pub fn state(&self) -> CrankTrainState {
        CrankTrainState {
            inputs: StepInputs { load: self.load, fuel: 1.0 },
            start_speed: self.simulation.start_speed,
            start_angle: self.simulation.start_angle,
            progress: None,
        }
    }

    /// Time, inputs, parameters and outputs, in the order of their references from 0 on.
    pub fn variables(&self) -> Vec<FmuVariable> {
        let mut variables: Vec<FmuVariable> = Vec::new();
        let mut push = |name: &str, description: &str, role, unit, start| {
            variables.push(FmuVariable {
                name: name.to_owned(),
                reference: variables.len() as u32,
                description: description.to_owned(),
                role,
                kind: FmuKind::Real { unit, start, range: [None; 2] },
            });
        };
        push("time", "Time", FmuRole::Time, "s", None);
        let shaft = match self.simulation.driveline.len() {
            0 => "crankshaft 1".to_owned(),
            count => format!("inertia {count} of the driveline"),
        };
        let load = format!(
            "Torque of the load on {shaft}, against positive rotation whatever the speed (a negative one drives), added to the load of the engine file"
        );
        push("load_torque", &load, FmuRole::Input, "N.m", Some(self.load));
        let fuel = match self.has_gas() {
            true => "Factor from 0 to 1 on the fired part of the gas, beside governor and events",
            false => {
                "Factor on the fired part of the gas: the engine file gives no gas, so that only 1 can be"
            }
        };
        push("fuel", fuel, FmuRole::Input, "1", Some(1.0));
        let speed = Some(self.simulation.start_speed);
        push("start_speed", "Speed of crankshaft 1 at the start", FmuRole::Parameter, "rad/s", speed);
        let angle = "Crank angle at the start; 0: throw 1 points along x";
        push("start_angle", angle, FmuRole::Parameter, "rad", Some(self.simulation.start_angle));
        for (name, description, unit) in self.described() {
            push(&name, &description, FmuRole::Output, unit, None);
        }
        let least_fuel = if self.has_gas() { 0.0 } else { 1.0 };
        for (reference, bounds) in
            [(Self::FUEL, [Some(least_fuel), Some(1.0)]), (Self::START_SPEED, [Some(0.0), None])]
        {
            if let FmuKind::Real { range, .. } = &mut variables[reference as usize].kind {
                *range = bounds;
            }
        }
        variables
    }

    /// Outputs in their order.
    fn described(&self) -> Vec<Output> {
        let mut all: Vec<Output> = Vec::new();
        let mut push = |name: &str, description: &str, unit| {
            all.push((name.to_owned(), description.to_owned(), unit));
        };
        push("crank_angle", "Angle of crankshaft 1 relative to the block; 0: throw 1 points along x", "rad");
        push("speed", "Speed of crankshaft 1 relative to the block", "rad/s");
        push("acceleration", "Angular acceleration of crankshaft 1 relative to the block", "rad/s2");
        push("torque_gas", "Torque of the gas on crankshaft 1, positive in the sense of rotation", "N.m");
        push(
            "torque_load",
            "Torque of the load on the shaft that it acts on, of file and input, positive in the sense of rotation",
            "N.m",
        );
        push("torque_starter", "Torque of the starter on crankshaft 1", "N.m");
        push("torque_friction", "Torque of dry friction on crankshaft 1", "N.m");
        push("torque_outside", "Torque over the angle that the engine file gives, on crankshaft 1", "N.m");
        if self.simulation.governor.is_some() {
            push("governor", "Factor of the governor on the fired part of the gas, from 0 to 1", "1");
        }
        if !self.simulation.driveline.is_empty() {
            push("torque_driveline", "Torque of the driveline on crankshaft 1", "N.m");
        }
        for number in 1..=self.simulation.driveline.len() {
            push(
                &format!("driveline_{number}_angle"),
                &format!("Angle of inertia {number} of the driveline relative to the block"),
                "rad",
            );
            push(
                &format!("driveline_{number}_speed"),
                &format!("Speed of inertia {number} of the driveline relative to the block"),
                "rad/s",
            );
        }
        if self.simulation.block == BlockMotion::Fixed {
            return all;
        }
        for (name, what, unit) in [
            ("block_position", "Displacement of the block's origin, frame of the engine file, along", "m"),
            (
                "block_rotation",
                "Rotation of the block as axis times angle, frame of the engine file, about",
                "rad",
            ),
            ("block_velocity", "Velocity of the block's origin, axes of the block, along", "m/s"),
            ("block_spin", "Angular velocity of the block, axes of the block, about", "rad/s"),
        ] {
            for axis in ["x", "y", "z"] {
                push(&format!("{name}_{axis}"), &format!("{what} {axis}"), unit);
            }
        }
        let on_mounts = self.simulation.block == BlockMotion::Mounts;
        for (place, mount) in self.train.mounts.iter().filter(|_| on_mounts).enumerate() {
            let number = place + 1;
            for axis in ["x", "y", "z"] {
                push(
                    &format!("mount_{number}_force_{axis}"),
                    &format!(
                        "Force of the block on mount {number} ({}) along {axis}, with weight and mean torque",
                        mount.name
                    ),
                    "N",
                );
            }
        }
        all
    }

    /// Values in the order of [`CrankTrainModel::described`].
    fn values(&self, own: &Samples) -> Vec<f64> {
        let mut all = Vec::new();
        let first = |series: &[f64]| series.first().copied().unwrap_or(f64::NAN);
        for series in [
            &own.theta,
            &own.speed,
            &own.acceleration,
            &own.gas_torque,
            &own.load_torque,
            &own.starter_torque,
            &own.friction_torque,
            &own.outside_torque,
        ] {
            all.push(first(series));
        }
        all.extend(own.governor.first());
        if !self.simulation.driveline.is_empty() {
            all.push(first(&own.driveline_torque));
        }
        all.extend(own.driveline.iter().flatten().flatten());
        for (place, [w, x, y, z]) in own.orientation.iter().enumerate() {
            let turn = UnitQuaternion::from_quaternion(Quaternion::new(*w, *x, *y, *z)).scaled_axis();
            all.extend(own.position[place]);
            all.extend(turn.iter());
            all.extend(own.velocity[place]);
            all.extend(own.spin[place]);
        }
        all.extend(own.mounts.iter().flatten().flatten());
        all
    }

    /// The stepper of a state.
    fn stepper(&mut self, state: CrankTrainState) -> Result<Stepper<'_>, MultibodyError> {
        (self.simulation.start_speed, self.simulation.start_angle) = (state.start_speed, state.start_angle);
        let gas = self.gas.as_ref().map(|gas| gas as &dyn GasPressure);
        match state.progress {
            None => Stepper::new(&self.train, &self.simulation, gas, state.inputs),
            Some(progress) => {
                let mut stepper = Stepper::resume(&self.train, &self.simulation, gas, progress)?;
                stepper.set_inputs(state.inputs)?;
                Ok(stepper)
            }
        }
    }

    /// The outputs of a state in their order.
    ///
    /// # Errors
    /// [`MultibodyError`] for inputs or a start that cannot be.
    pub fn outputs(&mut self, state: &CrankTrainState) -> Result<Vec<f64>, MultibodyError> {
        let samples = self.stepper(state.clone())?.sample();
        Ok(self.values(&samples))
    }

    /// Goes on to the time `to` [s] since the start; where it fails, the state stays as it was.
    ///
    /// # Errors
    /// [`CrankTrainFault`].
    pub fn advance(
        &mut self,
        state: &mut CrankTrainState,
        to: f64,
    ) -> Result<CrankTrainStep, CrankTrainFault> {
        let limit = self.simulation.most_evaluations;
        let mut stepper = self.stepper(state.clone())?;
        let Advance { outcome, happened, .. } = stepper.advance(to)?;
        let progress = stepper.into_state();
        let is_stopped = match outcome {
            RunOutcome::Complete => false,
            RunOutcome::Stopped => true,
            RunOutcome::Failed { theta, quantity, .. } => {
                return Err(CrankTrainFault::Failed { theta, quantity });
            }
            _ => return Err(CrankTrainFault::TooManyEvaluations { limit }),
        };
        let time = progress.time();
        state.progress = Some(progress);
        let happened = happened.into_iter().map(|own| {
            let what = match own.what {
                Occasion::Event { index } => match self.simulation.events.get(index) {
                    Some(event) => format!("event {}: {}", index + 1, action_words(&event.action)),
                    None => format!("event {}", index + 1),
                },
                Occasion::StarterOff => "the starter lets go".to_owned(),
                Occasion::Reversed => "the crankshaft comes to a halt and turns on".to_owned(),
                Occasion::Held => "the crankshaft comes to rest".to_owned(),
                Occasion::Released => "the crankshaft breaks away from rest".to_owned(),
            };
            format!("{:.6} s, crank angle {:.4} rad: {what}", own.time, own.theta)
        });
        Ok(CrankTrainStep { time, is_stopped, happened: happened.collect() })
    }
}

impl CrankTrainState {
    /// Time since the start [s].
    pub fn time(&self) -> f64 {
        self.progress.as_ref().map_or(0.0, StepperState::time)
    }

    /// Whether it has gone on from the start.
    pub fn has_started(&self) -> bool {
        self.progress.is_some()
    }
}
