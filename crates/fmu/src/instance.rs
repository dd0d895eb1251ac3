//! A loads model that is stepped through.

use lanchester::{LoadsModel, TraceFile, UNIT_ENGINE, trace_names, unit_token, unit_trace};
use std::path::Path;

/// How far an instance is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made: inputs and parameters may be set.
    Made,
    /// Being initialised.
    Initialising,
    /// Stepped through.
    Running,
    /// Ended: values may be read.
    Ended,
    /// A function panicked: nothing is left but to be freed.
    Broken,
}

/// What an instance knows beside its model: all that a saved state holds.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// How far it is.
    pub phase: Phase,
    /// Time [s].
    time: f64,
    /// Speed [rad/s].
    speed: f64,
    has_gas: bool,
    start_angle: f64,
    /// Crank angle [rad], and what its sum has lost to rounding.
    angle: [f64; 2],
    /// The loads of this state once they were asked for.
    loads: Option<Vec<f64>>,
}

/// An instance.
#[derive(Debug)]
pub struct Instance {
    model: LoadsModel,
    /// State.
    pub state: State,
    /// How many variables there are.
    count: u32,
}

impl Instance {
    /// From the resources of a unit, whose description carries `expected`.
    ///
    /// # Errors
    /// In words: a file that is missing or wrong, another engine file than the description was made for.
    pub fn new(resources: &Path, expected: &str) -> Result<Instance, String> {
        let read = |name: &str| {
            std::fs::read_to_string(resources.join(name))
                .map_err(|error| format!("cannot read {name} among the resources of the unit: {error}"))
        };
        let text = read(UNIT_ENGINE)?;
        let own = unit_token(&text);
        if own != expected {
            return Err(format!(
                "the description of the unit carries `{expected}`, and its engine file and binary are `{own}`: export the unit anew"
            ));
        }
        let reading = lanchester::file::read(&text);
        let messages = || reading.diagnostics.iter().map(|found| found.message.clone()).collect::<Vec<_>>();
        let file =
            reading.file.as_ref().ok_or_else(|| format!("{UNIT_ENGINE}: {}", messages().join("; ")))?;
        let engine = file.engine.clone();
        let names: Vec<String> = trace_names(&engine).into_iter().map(str::to_owned).collect();
        let trace = |(place, name): (usize, String)| Ok(TraceFile { name, text: read(&unit_trace(place))? });
        let traces = names.into_iter().enumerate().map(trace).collect::<Result<Vec<_>, String>>()?;
        let model = LoadsModel::new(engine, traces).map_err(|error| error.to_string())?;
        Ok(Instance::of(model))
    }

    /// Of a model.
    pub fn of(model: LoadsModel) -> Instance {
        let (count, state) = (model.variables().len() as u32, State::of(&model));
        Instance { model, state, count }
    }

    /// As when it was made.
    pub fn reset(&mut self) {
        self.state = State::of(&self.model);
    }

    /// Goes from one phase to the next.
    ///
    /// # Errors
    /// Where it stands in none of `from`.
    pub fn go(&mut self, from: &[Phase], to: Phase) -> Result<(), String> {
        let now = self.state.phase;
        if !from.contains(&now) {
            return Err(format!("this may not be called now: the instance is {}", now.words()));
        }
        self.state.phase = to;
        Ok(())
    }

    /// Where time starts [s].
    ///
    /// # Errors
    /// Where it is not finite.
    pub fn start_at(&mut self, time: f64) -> Result<(), String> {
        if !time.is_finite() {
            return Err(format!("the start time must be a finite number of seconds, and is {time}"));
        }
        self.state.time = time;
        Ok(())
    }

    /// A number by its reference.
    ///
    /// # Errors
    /// In words: no number has this reference, or it cannot be computed.
    pub fn number(&mut self, reference: u32) -> Result<f64, String> {
        match reference {
            0 => Ok(self.state.time),
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

    /// Sets a number.
    ///
    /// # Errors
    /// In words: no number that may be set now has this reference, or the value is none.
    pub fn set_number(&mut self, reference: u32, value: f64) -> Result<(), String> {
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
            if !matches!(self.state.phase, Phase::Made | Phase::Initialising) {
                return Err("start_angle is a parameter: it may be set before the run begins".to_owned());
            }
            self.state.start_angle = value;
            self.state.angle = [value, 0.0];
        }
        self.state.loads = None;
        Ok(())
    }

    /// A Boolean by its reference.
    ///
    /// # Errors
    /// Where none has this reference.
    pub fn flag(&self, reference: u32) -> Result<bool, String> {
        if reference == LoadsModel::GAS { Ok(self.state.has_gas) } else { Err(self.no_flag(reference)) }
    }

    /// Sets a Boolean.
    ///
    /// # Errors
    /// Where none has this reference, or the engine file gives no gas.
    pub fn set_flag(&mut self, reference: u32, value: bool) -> Result<(), String> {
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

    /// Goes on from `now` [s] by `step` [s], with the speed held.
    ///
    /// # Errors
    /// In words: a time that is not the present one, a step backwards, loads that cannot be computed where it ends.
    pub fn step(&mut self, now: f64, step: f64) -> Result<(), String> {
        let time = self.state.time;
        if !(now.is_finite() && (now - time).abs() <= 1e-9 * time.abs().max(1.0)) {
            return Err(format!("the step begins at {now} s, and the instance is at {time} s"));
        }
        if !(step >= 0.0 && step.is_finite()) {
            return Err(format!("a step must be 0 s or more, and is {step} s"));
        }
        let before = self.state.clone();
        let state = &mut self.state;
        // A sum of many steps that loses nothing (Neumaier).
        let (angle, by) = (state.angle[0], state.speed * step);
        let sum = angle + by;
        state.angle[1] += if angle.abs() >= by.abs() { (angle - sum) + by } else { (by - sum) + angle };
        state.angle[0] = sum;
        state.time = now + step;
        state.loads = None;
        self.number(LoadsModel::FIRST_LOAD).map(|_| ()).inspect_err(|_| self.state = before)
    }

    /// Time [s].
    pub fn time(&self) -> f64 {
        self.state.time
    }

    fn unknown(&self, reference: u32) -> String {
        format!("no number has the value reference {reference}: they go from 0 to {}", self.count - 1)
    }

    fn no_flag(&self, reference: u32) -> String {
        format!("no Boolean has the value reference {reference}: {} (gas) is the only one", LoadsModel::GAS)
    }
}

impl State {
    fn of(model: &LoadsModel) -> State {
        State {
            phase: Phase::Made,
            time: 0.0,
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

impl Phase {
    fn words(self) -> &'static str {
        match self {
            Phase::Made => "not yet initialised",
            Phase::Initialising => "being initialised",
            Phase::Running => "running",
            Phase::Ended => "ended",
            Phase::Broken => "broken by an earlier failure and can only be freed",
        }
    }
}
