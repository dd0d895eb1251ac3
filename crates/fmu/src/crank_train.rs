//! The crank train at free speed.

use crate::phase::Phase;
use crate::unit::{FOREIGN, Stepped, Unit};
use lanchester::{CrankTrainModel, CrankTrainState};
use std::any::Any;

/// What changes.
#[derive(Debug, Clone, PartialEq)]
struct State {
    train: CrankTrainState,
    /// Time since the start at which an event of the file stopped the run [s].
    stopped: Option<f64>,
    /// The outputs of this state once they were asked for.
    outputs: Option<Vec<f64>>,
}

/// A crank train that is stepped through.
pub struct CrankTrainUnit {
    model: CrankTrainModel,
    state: State,
    count: u32,
}

impl CrankTrainUnit {
    /// Of a model.
    pub fn of(model: CrankTrainModel) -> CrankTrainUnit {
        let (count, state) = (model.variables().len() as u32, State::of(&model));
        CrankTrainUnit { model, state, count }
    }
}

impl State {
    fn of(model: &CrankTrainModel) -> State {
        State { train: model.state(), stopped: None, outputs: None }
    }
}

impl Unit for CrankTrainUnit {
    fn count(&self) -> u32 {
        self.count
    }

    fn number(&mut self, reference: u32) -> Result<f64, String> {
        let train = &self.state.train;
        match reference {
            CrankTrainModel::LOAD_TORQUE => Ok(train.inputs.load),
            CrankTrainModel::FUEL => Ok(train.inputs.fuel),
            CrankTrainModel::START_SPEED => Ok(train.start_speed),
            CrankTrainModel::START_ANGLE => Ok(train.start_angle),
            _ if reference < self.count => {
                if self.state.outputs.is_none() {
                    let outputs = self.model.outputs(&self.state.train).map_err(|error| error.to_string())?;
                    self.state.outputs = Some(outputs);
                }
                let place = (reference - CrankTrainModel::FIRST_OUTPUT) as usize;
                let found = self.state.outputs.as_ref().and_then(|outputs| outputs.get(place)).copied();
                found.ok_or_else(|| self.unknown(reference))
            }
            _ => Err(self.unknown(reference)),
        }
    }

    fn set_number(&mut self, phase: Phase, reference: u32, value: f64) -> Result<(), String> {
        let name = match reference {
            CrankTrainModel::LOAD_TORQUE => "load_torque",
            CrankTrainModel::FUEL => "fuel",
            CrankTrainModel::START_SPEED => "start_speed",
            CrankTrainModel::START_ANGLE => "start_angle",
            _ if reference < self.count => {
                return Err(format!("variable {reference} is computed and cannot be set"));
            }
            _ => return Err(self.unknown(reference)),
        };
        if !value.is_finite() {
            return Err(format!("{name} must be a finite number, and is {value}"));
        }
        let is_parameter = matches!(reference, CrankTrainModel::START_SPEED | CrankTrainModel::START_ANGLE);
        if is_parameter && !phase.is_before_run() {
            return Err(format!("{name} is a parameter: it may be set before the run begins"));
        }
        let train = &mut self.state.train;
        match reference {
            CrankTrainModel::LOAD_TORQUE => train.inputs.load = value,
            CrankTrainModel::FUEL if !(0.0..=1.0).contains(&value) => {
                return Err(format!("fuel must be from 0 to 1, and is {value}"));
            }
            CrankTrainModel::FUEL if value != 1.0 && !self.model.has_gas() => {
                return Err("fuel can be 1 alone: the engine file of this unit gives no gas".to_owned());
            }
            CrankTrainModel::FUEL => train.inputs.fuel = value,
            CrankTrainModel::START_SPEED if value < 0.0 => {
                return Err(format!("start_speed must be 0 rad/s or more, and is {value} rad/s"));
            }
            CrankTrainModel::START_SPEED => train.start_speed = value,
            _ => train.start_angle = value,
        }
        self.state.outputs = None;
        Ok(())
    }

    fn flag(&self, reference: u32) -> Result<bool, String> {
        Err(format!("no Boolean has the value reference {reference}: the unit has none"))
    }

    fn set_flag(&mut self, reference: u32, _value: bool) -> Result<(), String> {
        self.flag(reference).map(|_| ())
    }

    fn start(&mut self) -> Result<(), String> {
        self.number(CrankTrainModel::FIRST_OUTPUT).map(|_| ())
    }

    fn step(&mut self, _step: f64, to: f64) -> Result<Stepped, String> {
        if let Some(time) = self.state.stopped {
            return Err(format!("an event of the engine file stopped the run {time} s after its start"));
        }
        // The host's sums of steps may lie a rounding before.
        let to = to.max(self.state.train.time());
        let step = self.model.advance(&mut self.state.train, to).map_err(|error| error.to_string())?;
        self.state.stopped = step.is_stopped.then_some(step.time);
        self.state.outputs = None;
        Ok(Stepped { stopped: self.state.stopped, happened: step.happened })
    }

    fn has_stopped(&self) -> bool {
        self.state.stopped.is_some()
    }

    fn reset(&mut self) {
        self.state = State::of(&self.model);
    }

    fn saved(&self) -> Box<dyn Any> {
        Box::new(self.state.clone())
    }

    fn restore(&mut self, saved: &dyn Any) -> Result<(), String> {
        self.state = saved.downcast_ref::<State>().ok_or(FOREIGN)?.clone();
        Ok(())
    }
}
