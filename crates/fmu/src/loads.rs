//! The loads of an engine at a speed that is given.

use crate::phase::Phase;
use crate::unit::{FOREIGN, Stepped, Unit};
use lanchester::LoadsModel;
use std::any::Any;

/// What changes.
#[derive(Debug, Clone, PartialEq)]
struct State {
    /// Speed [rad/s].
    speed: f64,
    has_gas: bool,
    start_angle: f64,
    /// Crank angle [rad], and what its sum has lost to rounding.
    angle: [f64; 2],
    /// The loads of this state once they were asked for.
    loads: Option<Vec<f64>>,
}

/// A loads model that is stepped through.
#[derive(Debug)]
pub struct LoadsUnit {
    model: LoadsModel,
    state: State,
    count: u32,
}

impl LoadsUnit {
    /// Of a model.
    pub fn of(model: LoadsModel) -> LoadsUnit {
        let (count, state) = (model.variables().len() as u32, State::of(&model));
        LoadsUnit { model, state, count }
    }

    fn no_flag(&self, reference: u32) -> String {
        format!("no Boolean has the value reference {reference}: {} (gas) is the only one", LoadsModel::GAS)
    }
}

impl Unit for LoadsUnit {
    fn count(&self) -> u32 {
        self.count
    }

    fn number(&mut self, reference: u32) -> Result<f64, String> {
        match reference {
            LoadsModel::SPEED => Ok(self.state.speed),
            LoadsModel::START_ANGLE => Ok(self.state.start_angle),
            LoadsModel::CRANK_ANGLE => Ok(self.state.crank_angle()),
            LoadsModel::GAS => Err(format!("variable {reference} (gas) is a Boolean, no number")),
            _ if reference < self.count => {
                if self.state.loads.is_none() {
                    let State { speed, has_gas, .. } = self.state;
                    let loads = self.model.at(speed, self.state.crank_angle(), has_gas);
                    self.state.loads = Some(loads.map_err(|error| error.to_string())?);
                }
                let place = (reference - LoadsModel::FIRST_LOAD) as usize;
                let found = self.state.loads.as_ref().and_then(|loads| loads.get(place)).copied();
                found.ok_or_else(|| self.unknown(reference))
            }
            _ => Err(self.unknown(reference)),
        }
    }

    fn set_number(&mut self, phase: Phase, reference: u32, value: f64) -> Result<(), String> {
        let name = match reference {
            LoadsModel::SPEED => "speed",
            LoadsModel::START_ANGLE => "start_angle",
            LoadsModel::GAS => return Err(format!("variable {reference} (gas) is a Boolean, no number")),
            _ if reference < self.count => {
                return Err(format!("variable {reference} is computed and cannot be set"));
            }
            _ => return Err(self.unknown(reference)),
        };
        if !value.is_finite() {
            return Err(format!("{name} must be a finite number, and is {value}"));
        }
        if reference == LoadsModel::SPEED {
            if value < 0.0 {
                return Err(format!("speed must be 0 rad/s or more, and is {value} rad/s"));
            }
            self.state.speed = value;
        } else {
            if !phase.is_before_run() {
                return Err("start_angle is a parameter: it may be set before the run begins".to_owned());
            }
            self.state.start_angle = value;
            self.state.angle = [value, 0.0];
        }
        self.state.loads = None;
        Ok(())
    }

    fn flag(&self, reference: u32) -> Result<bool, String> {
        if reference == LoadsModel::GAS { Ok(self.state.has_gas) } else { Err(self.no_flag(reference)) }
    }

    fn set_flag(&mut self, reference: u32, value: bool) -> Result<(), String> {
        if reference != LoadsModel::GAS {
            return Err(self.no_flag(reference));
        }
        if value && !self.model.has_gas() {
            return Err("gas can be false alone: the engine file of this unit gives no gas".to_owned());
        }
        self.state.has_gas = value;
        self.state.loads = None;
        Ok(())
    }

    fn step(&mut self, step: f64, _to: f64) -> Result<Stepped, String> {
        let before = self.state.clone();
        let state = &mut self.state;
        // A sum of many steps that loses nothing (Neumaier).
        let (angle, by) = (state.angle[0], state.speed * step);
        let sum = angle + by;
        state.angle[1] += if angle.abs() >= by.abs() { (angle - sum) + by } else { (by - sum) + angle };
        state.angle[0] = sum;
        state.loads = None;
        match self.number(LoadsModel::FIRST_LOAD) {
            Ok(_) => Ok(Stepped::default()),
            Err(message) => {
                self.state = before;
                Err(message)
            }
        }
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

impl State {
    fn of(model: &LoadsModel) -> State {
        State {
            speed: model.engine().speed.highest,
            has_gas: model.has_gas(),
            start_angle: 0.0,
            angle: [0.0; 2],
            loads: None,
        }
    }

    fn crank_angle(&self) -> f64 {
        self.angle[0] + self.angle[1]
    }
}
