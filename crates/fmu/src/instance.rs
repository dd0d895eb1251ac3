//! A model that is stepped through, with its time.

use crate::crank_train::CrankTrainUnit;
use crate::loads::LoadsUnit;
use crate::phase::Phase;
use crate::unit::{FOREIGN, Stepped, Unit};
use lanchester::{
    CrankTrainModel, LoadsModel, TraceFile, UNIT_ENGINE, UnitKind, trace_names, unit_token, unit_trace,
};
use std::any::Any;
use std::path::Path;

/// What an instance knows beside its model.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Course {
    phase: Phase,
    /// Time of the start, and now [s].
    start: f64,
    time: f64,
}

/// All that a saved state holds.
pub struct State {
    course: Course,
    token: String,
    own: Box<dyn Any>,
}

/// An instance.
pub struct Instance {
    unit: Box<dyn Unit>,
    token: String,
    course: Course,
    /// Whether what happens on the way is told, beside what is wrong.
    pub is_verbose: bool,
}

const MADE: Course = Course { phase: Phase::Made, start: 0.0, time: 0.0 };

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
        let kind = UnitKind::ALL.into_iter().find(|kind| unit_token(*kind, &text) == expected);
        let Some(kind) = kind else {
            let own = UnitKind::ALL.map(|kind| format!("`{}`", unit_token(kind, &text))).join(" or ");
            return Err(format!(
                "the description of the unit carries `{expected}`, and its engine file and binary are {own}: export the unit anew"
            ));
        };
        let reading = lanchester::file::read(&text);
        let messages = || reading.diagnostics.iter().map(|found| found.message.clone()).collect::<Vec<_>>();
        let file =
            reading.file.as_ref().ok_or_else(|| format!("{UNIT_ENGINE}: {}", messages().join("; ")))?;
        let names: Vec<String> = trace_names(&file.engine).into_iter().map(str::to_owned).collect();
        let trace = |(place, name): (usize, String)| Ok(TraceFile { name, text: read(&unit_trace(place))? });
        let traces = names.into_iter().enumerate().map(trace).collect::<Result<Vec<_>, String>>()?;
        let unit: Box<dyn Unit> = match kind {
            UnitKind::Loads => {
                let model = LoadsModel::new(file.engine.clone(), traces);
                Box::new(LoadsUnit::of(model.map_err(|error| error.to_string())?))
            }
            UnitKind::CrankTrain => {
                let model = CrankTrainModel::new(file, &traces);
                Box::new(CrankTrainUnit::of(model.map_err(|error| error.to_string())?))
            }
        };
        Ok(Instance { unit, token: expected.to_owned(), course: MADE, is_verbose: false })
    }

    /// As when it was made.
    pub fn reset(&mut self) {
        self.course = MADE;
        self.unit.reset();
    }

    /// How far it is.
    pub fn phase(&self) -> Phase {
        self.course.phase
    }

    /// It can only be freed from now on.
    pub fn break_off(&mut self) {
        self.course.phase = Phase::Broken;
    }

    /// Goes from one phase to the next.
    ///
    /// # Errors
    /// Where it is in none of `from`.
    pub fn go(&mut self, from: &[Phase], to: Phase) -> Result<(), String> {
        let now = self.course.phase;
        if !from.contains(&now) {
            return Err(format!("this may not be called now: the instance is {}", now.words()));
        }
        self.course.phase = to;
        Ok(())
    }

    /// Initialisation ends: the start must be one that can be.
    ///
    /// # Errors
    /// In words: why it cannot.
    pub fn initialised(&mut self) -> Result<(), String> {
        self.go(&[Phase::Initialising], Phase::Running)?;
        self.unit.start().inspect_err(|_| self.course.phase = Phase::Initialising)
    }

    /// Where time starts [s].
    ///
    /// # Errors
    /// Where it is not finite.
    pub fn start_at(&mut self, time: f64) -> Result<(), String> {
        if !time.is_finite() {
            return Err(format!("the start time must be a finite number of seconds, and is {time}"));
        }
        (self.course.start, self.course.time) = (time, time);
        Ok(())
    }

    /// A number by its reference.
    ///
    /// # Errors
    /// In words: no number has this reference, or it cannot be computed.
    pub fn number(&mut self, reference: u32) -> Result<f64, String> {
        if reference == 0 { Ok(self.course.time) } else { self.unit.number(reference) }
    }

    /// Sets a number.
    ///
    /// # Errors
    /// In words: no number that may be set now has this reference, or the value is none.
    pub fn set_number(&mut self, reference: u32, value: f64) -> Result<(), String> {
        self.unit.set_number(self.course.phase, reference, value)
    }

    /// A Boolean by its reference.
    ///
    /// # Errors
    /// Where none has this reference.
    pub fn flag(&self, reference: u32) -> Result<bool, String> {
        self.unit.flag(reference)
    }

    /// Sets a Boolean.
    ///
    /// # Errors
    /// Where none has this reference, or the engine file does not allow it.
    pub fn set_flag(&mut self, reference: u32, value: bool) -> Result<(), String> {
        self.unit.set_flag(reference, value)
    }

    /// Goes on from `now` [s] by `step` [s], with the inputs held; the time of the instance is that where it got to.
    ///
    /// # Errors
    /// In words: a time that is not the present one, a step backwards, a step that fails. Time and state are then as before.
    pub fn step(&mut self, now: f64, step: f64) -> Result<Stepped, String> {
        let Course { start, time, .. } = self.course;
        if !(now.is_finite() && (now - time).abs() <= 1e-9 * time.abs().max(1.0)) {
            return Err(format!("the step begins at {now} s, and the instance is at {time} s"));
        }
        if !(step >= 0.0 && step.is_finite()) {
            return Err(format!("a step must be 0 s or more, and is {step} s"));
        }
        let mut stepped = self.unit.step(step, now + step - start)?;
        self.course.time = stepped.stopped.map_or(now + step, |stopped| start + stopped);
        if !self.is_verbose {
            stepped.happened.clear();
        }
        Ok(stepped)
    }

    /// Time [s].
    pub fn time(&self) -> f64 {
        self.course.time
    }

    /// Whether the run has stopped for good.
    pub fn has_stopped(&self) -> bool {
        self.unit.has_stopped()
    }

    /// A copy of all that changes.
    pub fn saved(&self) -> State {
        State { course: self.course, token: self.token.clone(), own: self.unit.saved() }
    }

    /// Back to a saved state.
    ///
    /// # Errors
    /// Where it is that of another unit.
    pub fn restore(&mut self, state: &State) -> Result<(), String> {
        if state.token != self.token {
            return Err(FOREIGN.to_owned());
        }
        self.unit.restore(state.own.as_ref())?;
        self.course = state.course;
        Ok(())
    }
}
