//! A run that is advanced from call to call: a step of another program, with its inputs held over the step.
//!
//! Each call ends exactly at the time that it is asked for. The integrator keeps the length of its steps from call to call, so that short calls cost little more than long ones; what
//! happens on the way (events of the list, halts at standstill, the switch between crank angle and time as independent variable) is as in [`Train::run`].

use crate::error::MultibodyError;
use crate::gas_pressure::GasPressure;
use crate::powered::{Conditions, History};
use crate::run::check::check;
use crate::run::kept::Kept;
use crate::run::result::{Cost, Happened, RunOutcome, Samples};
use crate::run::runner::Runner;
use crate::simulation::{Duration, Simulation};
use crate::train::Train;
use std::cell::RefCell;
use std::rc::Rc;

/// What comes from outside and holds until it is set anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepInputs {
    /// Torque on the shaft of the load besides what the load of the [`Simulation`] takes, against positive rotation whatever the speed [N m]: a negative one drives.
    /// Its reaction goes where that of the load goes.
    pub load: f64,
    /// Factor on the fired part of the gas besides governor and events, from 0 to 1.
    pub fuel: f64,
}

impl Default for StepInputs {
    /// No torque, all fuel.
    fn default() -> StepInputs {
        StepInputs { load: 0.0, fuel: 1.0 }
    }
}

/// All of a stepper that changes: a copy is a saved state, from which the same calls give the same bits. It belongs to the engine, simulation and gas that it was made with.
#[derive(Debug, Clone, PartialEq)]
pub struct StepperState {
    time: f64,
    state: Vec<f64>,
    pending: Vec<bool>,
    step: Option<(bool, f64)>,
    scale: f64,
    conditions: Conditions,
    history: Option<History>,
}

impl StepperState {
    /// Time since the start [s].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Crank angle of crankshaft 1 relative to the block [rad].
    pub fn angle(&self) -> f64 {
        self.state[0]
    }

    /// Its rate [rad/s].
    pub fn speed(&self) -> f64 {
        self.state[1]
    }
}

/// What one call of [`Stepper::advance`] came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Advance {
    /// `Complete`: the time that was asked for is reached. `Stopped`: an event of the list stopped the run before, the stepper is there and may go on. Others: it failed, and the stepper is as before the call.
    pub outcome: RunOutcome,
    /// What happened on the way.
    pub happened: Vec<Happened>,
    /// Cost of this call.
    pub cost: Cost,
}

/// A run that is advanced from call to call.
///
/// ```
/// use lanchester_multibody::{RotorInertia, RunOutcome, Simulation, StepInputs, Stepper, Train};
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4.toml"));
/// let engine = lanchester_file::read(text).engine().expect("the example has no mistakes");
/// let inertia = RotorInertia { crankshafts: vec![Some(0.1)], flywheel: 0.2, shafts: Vec::new() };
/// let train = Train::new(&engine, &inertia)?;
/// let simulation = Simulation::free(200.0, 1.0);
/// let mut stepper = Stepper::new(&train, &simulation, None, StepInputs::default())?;
/// let saved = stepper.save();
/// stepper.set_inputs(StepInputs { load: 30.0, ..StepInputs::default() })?;
/// assert_eq!(stepper.advance(0.05)?.outcome, RunOutcome::Complete);
/// assert!(stepper.time() == 0.05 && stepper.speed() < 200.0);
/// stepper.restore(&saved)?;
/// assert_eq!(stepper.time(), 0.0);
/// # Ok::<(), lanchester_multibody::MultibodyError>(())
/// ```
pub struct Stepper<'a> {
    runner: Runner<'a>,
}

impl<'a> Stepper<'a> {
    /// At the start that `simulation` describes. Its duration and the step of its samples do not count; its largest number of evaluations bounds every single call.
    ///
    /// # Errors
    /// As [`Train::run`], and [`MultibodyError::Number`] for inputs that cannot be.
    pub fn new(
        train: &'a Train,
        simulation: &'a Simulation,
        gas: Option<&'a dyn GasPressure>,
        inputs: StepInputs,
    ) -> Result<Stepper<'a>, MultibodyError> {
        check(train, simulation, gas.is_some())?;
        check_inputs(inputs)?;
        let mut runner = Runner::unstarted(train, simulation, gas, true);
        (runner.powered.conditions.demand, runner.powered.conditions.fuel) = (inputs.load, inputs.fuel);
        runner.start();
        Ok(Stepper { runner })
    }

    /// Goes on from a state of [`Stepper::save`] or [`Stepper::into_state`] of the same engine, simulation and gas.
    ///
    /// # Errors
    /// [`MultibodyError::ForeignState`] where it cannot be one of theirs.
    pub fn resume(
        train: &'a Train,
        simulation: &'a Simulation,
        gas: Option<&'a dyn GasPressure>,
        state: StepperState,
    ) -> Result<Stepper<'a>, MultibodyError> {
        let mut stepper = Stepper { runner: Runner::unstarted(train, simulation, gas, true) };
        stepper.put(state)?;
        Ok(stepper)
    }

    /// Time since the start [s].
    pub fn time(&self) -> f64 {
        self.runner.time
    }

    /// Crank angle of crankshaft 1 relative to the block [rad].
    pub fn angle(&self) -> f64 {
        self.runner.state[0]
    }

    /// Its rate [rad/s].
    pub fn speed(&self) -> f64 {
        self.runner.state[1]
    }

    /// Sets what comes from outside, from now on.
    ///
    /// # Errors
    /// [`MultibodyError::Number`] for a torque that is not finite, or fuel beyond 0 and 1.
    pub fn set_inputs(&mut self, inputs: StepInputs) -> Result<(), MultibodyError> {
        check_inputs(inputs)?;
        let Runner { powered, time, .. } = &mut self.runner;
        let conditions = &mut powered.conditions;
        if (conditions.demand, conditions.fuel) == (inputs.load, inputs.fuel) {
            return Ok(());
        }
        (conditions.demand, conditions.fuel) = (inputs.load, inputs.fuel);
        if let Some(history) = &powered.history {
            history.borrow_mut().jump(*time);
        }
        Ok(())
    }

    /// Goes on to the time `to` [s] since the start, exactly.
    ///
    /// # Errors
    /// [`MultibodyError::Number`] where `to` is not finite or lies before the present time.
    pub fn advance(&mut self, to: f64) -> Result<Advance, MultibodyError> {
        let time = self.runner.time;
        if !(to.is_finite() && to >= time) {
            return Err(MultibodyError::Number {
                quantity: "time to go on to [s]".to_owned(),
                needed: "finite and not before the present time",
                got: to,
            });
        }
        if to == time {
            return Ok(Advance {
                outcome: RunOutcome::Complete,
                happened: Vec::new(),
                cost: Cost::default(),
            });
        }
        let before = self.save();
        let runner = &mut self.runner;
        runner.until = Duration::Time(to);
        runner.cost = Cost::default();
        // An input may have changed since friction took hold.
        runner.grip();
        let outcome = runner.go(|_, _| {});
        let (happened, cost) = (std::mem::take(&mut runner.happened), runner.cost);
        match outcome {
            RunOutcome::Complete => runner.time = to,
            RunOutcome::Stopped => {}
            _ => self.put(before)?,
        }
        Ok(Advance { outcome, happened, cost })
    }

    /// All quantities of a run at the present time, one value each; reactions where the [`Simulation`] asks for them.
    pub fn sample(&mut self) -> Samples {
        let mut samples = Samples::default();
        let mut kept = Kept::new(self.runner.state.len());
        kept.push(self.runner.time).copy_from_slice(&self.runner.state);
        self.runner.take(&kept, &mut samples, None, |_, _, _| {});
        samples
    }

    /// A copy of all that changes.
    pub fn save(&self) -> StepperState {
        let Runner { powered, time, state, pending, step, scale, .. } = &self.runner;
        StepperState {
            time: *time,
            state: state.clone(),
            pending: pending.clone(),
            step: *step,
            scale: *scale,
            conditions: powered.conditions.clone(),
            history: powered.history.as_ref().map(|history| history.borrow().clone()),
        }
    }

    /// Back to a state that was saved, of the same engine, simulation and gas.
    ///
    /// # Errors
    /// [`MultibodyError::ForeignState`] where it cannot be one of theirs.
    pub fn restore(&mut self, state: &StepperState) -> Result<(), MultibodyError> {
        self.put(state.clone())
    }

    /// All that changes, without a copy.
    pub fn into_state(self) -> StepperState {
        let Runner { powered, time, state, pending, step, scale, .. } = self.runner;
        let own = |history: Rc<RefCell<History>>| {
            Rc::try_unwrap(history).map_or_else(|shared| shared.borrow().clone(), RefCell::into_inner)
        };
        let history = powered.history.map(own);
        StepperState { time, state, pending, step, scale, conditions: powered.conditions, history }
    }

    fn put(&mut self, own: StepperState) -> Result<(), MultibodyError> {
        let runner = &mut self.runner;
        let StepperState { time, state, pending, step, scale, conditions, history } = own;
        let fits = state.len() == runner.state.len()
            && pending.len() == runner.pending.len()
            && conditions.fired.len() == runner.powered.conditions.fired.len()
            && history.is_some() == runner.powered.history.is_some();
        if !fits {
            return Err(MultibodyError::ForeignState { needed: runner.state.len(), got: state.len() });
        }
        (runner.time, runner.state, runner.pending) = (time, state, pending);
        (runner.step, runner.scale) = (step, scale);
        runner.powered.conditions = conditions;
        runner.powered.history = history.map(|history| Rc::new(RefCell::new(history)));
        Ok(())
    }
}

fn check_inputs(inputs: StepInputs) -> Result<(), MultibodyError> {
    let number = |quantity: &str, needed, got: f64, fits: bool| match fits {
        true => Ok(()),
        false => Err(MultibodyError::Number { quantity: quantity.to_owned(), needed, got }),
    };
    number("torque of the load from outside [N m]", "finite", inputs.load, inputs.load.is_finite())?;
    number("fuel as a share", "from 0 to 1", inputs.fuel, (0.0..=1.0).contains(&inputs.fuel))
}
