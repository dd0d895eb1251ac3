//! The nine arrangements of the twin-cylinder thesis for an engine, each with its loads, sweep and true optimum.

use lanchester_balance::{BalanceError, optimise_with};
use lanchester_literature::{
    ArrangementOptions, SweepOptions, TwinArrangement, arranged, arrangement_task, crank_load, crank_task,
    swept_crank,
};
use lanchester_mechanism::{LoadRequest, PeakMode, loads};
use lanchester_model::{Engine, Fault, SpeedRange};
use lanchester_report::ArrangementResult;
use lanchester_task::BalanceTask;

/// `engine` in all nine arrangements, its own counterweights and shafts left out.
///
/// Sizes, sweep and optimum use the motion of `request`; the sweep looks at the angles of its peak grid, at every
/// degree without one.
///
/// # Errors
/// [`BalanceError`] where the engine has several crankshafts or its loads cannot be computed.
///
/// # Example
/// ```
/// let template = lanchester::file::template("twin-180").expect("it is in the gallery");
/// let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
/// let nine = lanchester::arrangements(&engine, &Default::default())?;
/// let couple = |number: usize| nine[number - 1].loads.total.peaks.couple.max.value;
/// // The crank halves the couple of an out-of-phase twin; one double shaft more removes its first order.
/// assert!(couple(2) < 0.51 * couple(1) && couple(4) < 1e-6 * couple(1));
/// # Ok::<(), lanchester::balance::BalanceError>(())
/// ```
pub fn arrangements(engine: &Engine, request: &LoadRequest) -> Result<Vec<ArrangementResult>, BalanceError> {
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let engine = engine
        .with(|parts| parts.speed = SpeedRange { lowest: speed, highest: speed })
        .map_err(|faults| BalanceError::Engine(Fault::first_of(faults)))?;
    let mut sweep = SweepOptions::fitting(&engine);
    if let PeakMode::Grid(angles) = request.peaks {
        sweep.angles = angles;
    }
    let options =
        ArrangementOptions { kinematics: request.kinematics, sweep, ..ArrangementOptions::default() };
    let judged = crank_load(&engine, &options)?;
    TwinArrangement::ALL
        .into_iter()
        .map(|arrangement| {
            let fitted = arranged(&engine, arrangement, &options)?;
            let best = |task: BalanceTask| match task.stages.is_empty() {
                true => Ok(None),
                false => optimise_with(&fitted, &task, request.kinematics).map(Some),
            };
            let crank_optimum = best(crank_task(&engine, arrangement, &options)?)?;
            let optimum = best(arrangement_task(&engine, arrangement, &options)?)?;
            Ok(ArrangementResult {
                arrangement,
                loads: loads(&fitted, request)?,
                engine: fitted,
                judged,
                sweep: swept_crank(&engine, arrangement, &options)?,
                crank_optimum,
                optimum,
            })
        })
        .collect()
}
