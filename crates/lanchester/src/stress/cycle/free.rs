//! One law: at constant speed, or with the speed that gas and inertia make.

use super::CycleRequest;
use crate::inertias::known_inertia;
use crate::stress::request::StressError;
use lanchester_flex::train::{
    CrankTrain, CycleOptions, CycleOutcome, CycleState, FreeFlywheel, ImposedMotion, TrainCycles,
    run_cycles_watched, run_free,
};
use lanchester_mechanism::{CylinderGas, OuterTorque, RippleOutcome, speed_ripple};
use lanchester_model::Engine;
use lanchester_report::CycleSpeed;
use std::f64::consts::TAU;

/// Orders of a free speed over a revolution.
const ORDERS: f64 = 24.0;
/// Change of a free speed over its swing that counts as none, and the most runs for it.
const CHANGE: f64 = 1e-3;
const RUNS: usize = 12;

/// Cycles of a train with its laws.
pub(crate) struct LawCycles {
    pub train: CrankTrain,
    pub cycles: TrainCycles,
    /// Runs of a free speed, and its last change.
    pub free: Option<(usize, f64)>,
}

impl LawCycles {
    /// Whether the one who watches said stop.
    pub fn stopped(&self) -> bool {
        self.cycles.outcome == CycleOutcome::Stopped
    }
}

/// Runs a law.
pub(crate) fn run_law(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    request: &CycleRequest,
    mut train: CrankTrain,
    options: CycleOptions,
    watch: &dyn Fn(usize, CycleState) -> bool,
) -> Result<LawCycles, StressError> {
    if request.motion == CycleSpeed::Constant {
        let cycles = run_cycles_watched(&train, options, &|state| watch(1, state))?;
        return Ok(LawCycles { train, cycles, free: None });
    }
    let unknown = |reason: &str, hint: &str| StressError::FreeSpeed {
        reason: reason.to_owned(),
        hint: hint.to_owned(),
    };
    if engine.crankshafts.len() > 1 {
        return Err(unknown(
            "the engine has several crankshafts, geared to one another",
            "ask for constant speed",
        ));
    }
    let speed = train.motion.speed;
    let ripple = match speed_ripple(engine, gas, speed, &OuterTorque::default(), known_inertia(engine))? {
        RippleOutcome::Periodic(ripple) => ripple,
        RippleOutcome::IncompleteInertia(missing) => {
            return Err(unknown(
                &missing.reason,
                "give the inertias that are missing, or ask for constant speed",
            ));
        }
        RippleOutcome::Stops(stopped) => {
            return Err(unknown(&stopped.reason, "ask for a higher speed, or for constant speed"));
        }
    };
    let orders = (ORDERS * train.motion.period / TAU).round() as usize;
    // The torque may repeat sooner than the cylinders do.
    let times = (train.motion.period / ripple.period).round().max(1.0) as usize;
    train.motion =
        ImposedMotion::of_speeds(&ripple.speed.repeat(times), ripple.period * times as f64, orders);
    let wheel = ripple.inertia.given.flywheel + ripple.inertia.geared;
    let flywheel = FreeFlywheel {
        inertia: wheel,
        train: ripple.inertia.mean - wheel,
        orders,
        change: CHANGE,
        most_runs: RUNS,
    };
    let found = run_free(&train, flywheel, options, watch)?;
    train.motion = found.motion;
    Ok(LawCycles { train, cycles: found.found, free: Some((found.runs, found.change)) })
}
