//! One law: at constant speed, or with the speed that gas and inertia make.

use super::request::CycleRequest;
use crate::inertias::known_inertia;
use crate::stress::request::StressError;
use lanchester_flex::train::{
    CrankTrain, CycleOptions, CycleOutcome, CycleWatch, FreeFlywheel, ImposedMotion, TrainCycles,
    run_cycles_watched, run_free,
};
use lanchester_mechanism::{CylinderGas, OuterTorque, RippleOutcome, speed_ripple};
use lanchester_model::Engine;
use lanchester_report::{CycleSpeed, SPEED_SETTLED};
use std::f64::consts::TAU;

/// Orders of the first guess of a free speed over a revolution.
const ORDERS: f64 = 24.0;

/// Cycles of a train with its laws.
pub(crate) struct LawCycles {
    pub train: CrankTrain,
    pub cycles: TrainCycles,
}

impl LawCycles {
    /// Whether the one who watches said stop.
    pub fn stopped(&self) -> bool {
        self.cycles.outcome == CycleOutcome::Stopped
    }
}

/// A first guess of a free speed, and what turns freely.
pub(crate) struct FreeStart {
    motion: ImposedMotion,
    flywheel: FreeFlywheel,
}

/// Where the speed is to swing: how it does of a rigid crankshaft.
pub(crate) fn free_start(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    request: &CycleRequest,
    speed: f64,
    period: f64,
) -> Result<Option<FreeStart>, StressError> {
    if request.motion == CycleSpeed::Constant {
        return Ok(None);
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
    let ripple = match speed_ripple(engine, gas, speed, &OuterTorque::default(), known_inertia(engine))? {
        RippleOutcome::Periodic(ripple) => ripple,
        RippleOutcome::IncompleteInertia(missing) => return Err(unknown(&missing.reason, &missing.fix)),
        RippleOutcome::Stops(stopped) => return Err(unknown(&stopped.reason, &stopped.fix)),
    };
    let orders = (ORDERS * period / TAU).round() as usize;
    // The torque may repeat sooner than the cylinders do.
    let times = (period / ripple.period).round().max(1.0) as usize;
    let motion = ImposedMotion::of_speeds(&ripple.speed.repeat(times), ripple.period * times as f64, orders);
    let wheel = ripple.inertia.given.flywheel + ripple.inertia.geared;
    let flywheel = FreeFlywheel { inertia: wheel, train: ripple.inertia.mean - wheel, change: SPEED_SETTLED };
    Ok(Some(FreeStart { motion, flywheel }))
}

/// Runs a law.
pub(crate) fn run_law(
    mut train: CrankTrain,
    free: Option<&FreeStart>,
    options: CycleOptions,
    watch: CycleWatch<'_>,
) -> Result<LawCycles, StressError> {
    let cycles = match free {
        None => run_cycles_watched(&train, options, watch)?,
        Some(start) => {
            train.motion = start.motion.clone();
            run_free(&train, start.flywheel, options, watch)?
        }
    };
    Ok(LawCycles { train, cycles })
}
