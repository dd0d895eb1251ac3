//! The best weights for engines as the tolerances of the file make them.

use lanchester_balance::{BalanceError, RobustAnswer, RobustMeasure, RobustRequest, optimise_robust_while};
use lanchester_model::Engine;
use lanchester_study::scatter::{Output, ScatterError, ScatterRequest, Scattering};
use lanchester_task::{BalanceTask, Tolerance};

/// How many engines are drawn, and what of them counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobustOptions {
    /// Engines that are optimised for, from 1 to [`MOST_ENGINES`]; as many more, drawn independently, judge the answer anew.
    pub engines: u64,
    /// Seed of the draws: the same seed draws the same engines.
    pub seed: u64,
    /// What of the engines is minimised.
    pub measure: RobustMeasure,
}

/// Most engines that are optimised for.
pub const MOST_ENGINES: u64 = 20_000;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RobustError {
    /// No engine can be drawn.
    #[error(transparent)]
    Scatter(#[from] ScatterError),
    /// The question has no meaning for this engine.
    #[error(transparent)]
    Balance(#[from] BalanceError),
    /// Too few or too many engines.
    #[error(
        "the number of engines must be from 1 to {MOST_ENGINES}, got {0}\nhint: some hundred are enough for the mean of the worst 5 %"
    )]
    Engines(u64),
}

/// Draws engines within the tolerances and finds the weights of `task` that are best for them. What varies of weights
/// that the task takes over does not: their places are taken by weights without deviations.
///
/// # Errors
/// [`RobustError`].
pub fn robust_balance(
    engine: &Engine,
    tolerances: &[Tolerance],
    task: &BalanceTask,
    options: &RobustOptions,
) -> Result<RobustAnswer, RobustError> {
    robust_balance_while(engine, tolerances, task, options, &|| true)
}

/// As [`robust_balance`], as long as `goes_on` says so.
///
/// # Errors
/// [`RobustError`]; [`BalanceError::BrokenOff`] in it where it no longer goes on.
pub fn robust_balance_while(
    engine: &Engine,
    tolerances: &[Tolerance],
    task: &BalanceTask,
    options: &RobustOptions,
    goes_on: &dyn Fn() -> bool,
) -> Result<RobustAnswer, RobustError> {
    let RobustOptions { engines, seed, measure } = *options;
    if !(1..=MOST_ENGINES).contains(&engines) {
        return Err(RobustError::Engines(engines));
    }
    let scattering = Scattering::new(ScatterRequest {
        engine: engine.clone(),
        speed: None,
        tolerances: tolerances.to_vec(),
        outputs: vec![Output::Force { order: 1 }],
        limits: Vec::new(),
        percentiles: Vec::new(),
        samples: 2 * engines,
        seed,
    })?;
    let (samples, second) = (scattering.engines(0..engines)?, scattering.engines(engines..2 * engines)?);
    let request = RobustRequest { samples: &samples, second: &second, measure, seed };
    Ok(optimise_robust_while(engine, task, &request, goes_on)?)
}
