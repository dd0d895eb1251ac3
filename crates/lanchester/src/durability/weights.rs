//! Weights for the life of crankshaft and bearings: the search of `balance` with films and safeties of this engine.

use super::meter::{DurabilityRequest, EngineDurability};
use crate::inertias::with_known_rotors;
use crate::parts::web_bounds::optimise_on_webs;
use crate::pressure::measured::TraceFile;
use crate::pressure::over_speed::SpeedGas;
use crate::torsion_study::driveline;
use lanchester_balance::{
    Answer, BalanceError, BalanceSettings, Durable, DurableRequest, DurableSettings, GasOverSpeed, Next,
    durable,
};
use lanchester_file::EngineFile;

/// How far a search for films and safeties goes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DurableOptions {
    /// Of the local search.
    pub search: DurableSettings,
    /// Of the optima that are its starts.
    pub balance: BalanceSettings,
}

/// Films and safeties before, at the proved optimum `answer` of the file's engine, and after a local search for what the answer's task wants of them;
/// `traces` are the files that its file names or why they cannot be read.
///
/// They are judged at the speeds of the task, else at the lowest and the highest of the engine. What is searched over is not convex: a global
/// optimum is not claimed.
///
/// # Errors
/// [`BalanceError`] where moved weights cannot be judged by the stages of the task, or the watch abandons the search.
pub fn durable_balance(
    file: &EngineFile,
    traces: Result<&[TraceFile], String>,
    answer: &Answer,
    options: &DurableOptions,
    watch: &dyn Fn(usize) -> Next,
) -> Result<Durable, BalanceError> {
    let engine = &file.engine;
    let asked = |weights_alone: bool| DurabilityRequest {
        speeds: answer.task.speeds.clone(),
        weights_alone,
        driveline: Some(driveline(file).to_vec()),
        ..DurabilityRequest::default()
    };
    let meter = EngineDurability::new(traces.clone(), asked(true));
    let reporter = EngineDurability::new(traces.clone(), asked(false));
    let gas = SpeedGas::new(engine, traces.clone());
    let optimum = |task: &lanchester_task::BalanceTask| {
        let shapes = file.tasks.shape_task.as_ref();
        let found =
            optimise_on_webs(engine, traces.clone(), task, shapes, &options.balance, &|_| Next::Continue);
        found.map_err(|error| match error {
            crate::parts::web_bounds::WebBoundError::Balance(error) => error,
            _ => BalanceError::BrokenOff,
        })
    };
    let request = DurableRequest {
        meter: &meter,
        reporter: &reporter,
        gas: engine.gas.is_some().then_some(&gas as &dyn GasOverSpeed),
        optimum: &optimum,
        settings: options.search,
        watch,
    };
    durable(&with_known_rotors(engine), answer, &request)
}
