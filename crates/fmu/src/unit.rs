//! What every model that is stepped through can do.

use crate::phase::Phase;
use std::any::Any;

/// Where a step ended.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stepped {
    /// Time since the start [s] at which the model stopped for good before the end that was asked for; `None`: it got there.
    pub stopped: Option<f64>,
    /// What happened on the way, in words.
    pub happened: Vec<String>,
}

/// A model with its state. Value reference 0, the time, is the instance's own.
pub trait Unit {
    /// How many variables there are, the time among them.
    fn count(&self) -> u32;

    /// A number by its reference.
    ///
    /// # Errors
    /// In words: no number has this reference, or it cannot be computed.
    fn number(&mut self, reference: u32) -> Result<f64, String>;

    /// Sets a number.
    ///
    /// # Errors
    /// In words: no number that may be set now has this reference, or the value is none.
    fn set_number(&mut self, phase: Phase, reference: u32, value: f64) -> Result<(), String>;

    /// A Boolean by its reference.
    ///
    /// # Errors
    /// Where none has this reference.
    fn flag(&self, reference: u32) -> Result<bool, String>;

    /// Sets a Boolean.
    ///
    /// # Errors
    /// Where none has this reference, or it cannot be so.
    fn set_flag(&mut self, reference: u32, value: bool) -> Result<(), String>;

    /// The run is about to begin.
    ///
    /// # Errors
    /// In words: why it cannot.
    fn start(&mut self) -> Result<(), String> {
        Ok(())
    }

    /// Goes on by a step [s], which ends `to` seconds after the start, with the inputs held. Where it fails, the state stays.
    ///
    /// # Errors
    /// In words: why it cannot.
    fn step(&mut self, step: f64, to: f64) -> Result<Stepped, String>;

    /// Whether it has stopped for good.
    fn has_stopped(&self) -> bool {
        false
    }

    /// As when it was made.
    fn reset(&mut self);

    /// A copy of all that changes.
    fn saved(&self) -> Box<dyn Any>;

    /// Back to a saved state.
    ///
    /// # Errors
    /// Where it is that of another model.
    fn restore(&mut self, saved: &dyn Any) -> Result<(), String>;

    /// No number has this reference.
    fn unknown(&self, reference: u32) -> String {
        format!("no number has the value reference {reference}: they go from 0 to {}", self.count() - 1)
    }
}

/// A saved state of another model.
pub const FOREIGN: &str = "the saved state is that of another unit";
