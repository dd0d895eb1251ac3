//! What a search for films and safeties needs.

use crate::answer::Answer;
use crate::durable::answer::DurableSettings;
use crate::error::BalanceError;
use crate::over_speed::gas::GasOverSpeed;
use crate::settings::Next;
use lanchester_task::{BalanceTask, DurabilityMeter};

/// What a search needs beside the engine.
pub struct DurableRequest<'a> {
    /// Tells films and safeties of engines that differ in weights alone, many times: what counts during the search.
    pub meter: &'a dyn DurabilityMeter,
    /// Tells those that are reported and judged: before, at the optimum, after.
    pub reporter: &'a dyn DurabilityMeter,
    /// The pressures, where a stage or limit counts the gas.
    pub gas: Option<&'a dyn GasOverSpeed>,
    /// The optimum of another task of the same engine, as that of the answer was found.
    pub optimum: &'a dyn Fn(&BalanceTask) -> Result<Answer, BalanceError>,
    /// How far the search goes.
    pub settings: DurableSettings,
    /// Asked before each evaluation, with the number of those done.
    pub watch: &'a dyn Fn(usize) -> Next,
}
