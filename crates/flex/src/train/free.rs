//! The train whose flywheel turns freely: the speed that repeats under a constant load.
//!
//! The torque `T` of the flywheel on the crankshaft under a motion turns the flywheel itself the other way. With its inertia `J_f` and that of the train about `J_t`, the next
//! motion of the same mean speed is, order by order of the period,
//!
//! ```text
//! (J_f + J_t) a_new = -(T - mean T) + J_t a_old         theta_k = -a_k/(k W)^2                           (book, eq. 51.12)
//! ```
//! which a rigid train of constant inertia solves at once; what is left is taken out by Anderson's mixing. The mean of T is the load.

use super::cycle::{CycleOptions, CycleOutcome, CycleState, TrainCycles, run_cycles_watched};
use super::mixing::Mixing;
use super::motion::ImposedMotion;
use super::parts::CrankTrain;
use crate::FlexError;
use std::f64::consts::TAU;

/// A flywheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeFlywheel {
    /// Inertia of all that turns rigidly with the flywheel's end of crankshaft 1 [kg m^2], the crank train left out.
    pub inertia: f64,
    /// Mean inertia of the crank train about [kg m^2]: it does not change the answer, only the way to it.
    pub train: f64,
    /// Orders of the period that its speed has.
    pub orders: usize,
    /// Change of the speed from run to run over its swing that counts as none.
    pub change: f64,
    /// Most runs.
    pub most_runs: usize,
}

/// What a free flywheel does.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeCycles {
    /// The last run.
    pub found: TrainCycles,
    /// Its motion.
    pub motion: ImposedMotion,
    /// Runs.
    pub runs: usize,
    /// Change of the speed in the last of them over its swing.
    pub change: f64,
}

/// Runs a train again and again until its flywheel turns as its torque makes it; `train.motion` is the first guess. `watch` hears the number of the run.
///
/// # Errors
/// As [`super::run_cycles`]; [`FlexError::Number`] for an inertia that is none.
pub fn run_free(
    train: &CrankTrain,
    flywheel: FreeFlywheel,
    options: CycleOptions,
    watch: &dyn Fn(usize, CycleState) -> bool,
) -> Result<FreeCycles, FlexError> {
    for (name, value) in
        [("inertia of the flywheel", flywheel.inertia), ("inertia of the train", flywheel.train)]
    {
        if !(value > 0.0 && value.is_finite()) {
            return Err(FlexError::Number {
                quantity: format!("{name} [kg m^2]"),
                needed: "above 0".to_owned(),
                got: value,
                hint: "give the inertia of the flywheel",
            });
        }
    }
    let mut train = train.clone();
    let base = TAU * train.motion.speed / train.motion.period;
    let orders = flywheel.orders.min(options.samples / 4);
    train.motion.swing.resize(orders, [0.0; 2]);
    let weights: Vec<f64> = (0..2 * orders).map(|k| base * (k / 2 + 1) as f64).collect();
    let mut mixing = Mixing::default();
    let mut runs = 0;
    loop {
        runs += 1;
        let found = run_cycles_watched(&train, options, &|state| watch(runs, state))?;
        let ended = matches!(found.outcome, CycleOutcome::Stopped | CycleOutcome::Broken { .. });
        let Some(cycle) = found.recorded.last().filter(|_| !ended) else {
            return Ok(FreeCycles { found, motion: train.motion, runs, change: f64::INFINITY });
        };
        let torque: Vec<f64> = cycle.instants.iter().map(|own| train.ratio * own.torque).collect();
        let next: Vec<f64> = (0..orders)
            .flat_map(|k| {
                let rate = base * (k + 1) as f64;
                let of = series(&torque, k + 1);
                let old = train.motion.swing[k].map(|part| -rate * rate * part);
                [0, 1].map(|part| {
                    let a = (flywheel.train * old[part] - of[part]) / (flywheel.inertia + flywheel.train);
                    -a / (rate * rate)
                })
            })
            .collect();
        let now: Vec<f64> = train.motion.swing.iter().flatten().copied().collect();
        let size = |own: &[f64]| own.iter().zip(&weights).map(|(v, w)| (w * v).powi(2)).sum::<f64>().sqrt();
        let apart: Vec<f64> = next.iter().zip(&now).map(|(a, b)| a - b).collect();
        let change = size(&apart) / size(&next).max(f64::MIN_POSITIVE);
        if change <= flywheel.change || runs >= flywheel.most_runs {
            return Ok(FreeCycles { found, motion: train.motion, runs, change });
        }
        let mixed = mixing.next(&now, &next, &weights);
        train.motion.swing = mixed.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
        // The cycle begins at angle zero.
        train.motion.offset = -train.motion.swing.iter().map(|pair| pair[0]).sum::<f64>();
    }
}

/// Cosine and sine of an order of equally spaced samples.
fn series(samples: &[f64], order: usize) -> [f64; 2] {
    let n = samples.len() as f64;
    let sum = |of: fn(f64) -> f64| {
        let terms = samples.iter().enumerate();
        terms.map(|(k, value)| value * of(TAU * order as f64 * k as f64 / n)).sum::<f64>() * 2.0 / n
    };
    [sum(f64::cos), sum(f64::sin)]
}
