//! The periodic motion: Newton on the map of one period over speed, block and driveline.
//!
//! ```text
//! G(x) = state after one period from x, less x;       G = 0       multipliers: eigenvalues of dG/dx + 1
//! ```
//! The crank angle is the independent variable, so that the period is known. A periodic motion with all multipliers within the unit circle is stable; with a
//! load that does not depend on the speed one of them is 1, because every speed has its own periodic motion: then the mean speed is kept at that of the start.
//!
//! Newton needs a start near the motion. Where it finds none, as with a governor that the start drives to an end of its range, the motion is followed forward
//! and Newton starts again from there; where there is none, what became of the engine is told. A governor with a dead time has its past as a state: see
//! `with_past`.

mod outcome;
mod search;
mod with_past;

use crate::error::MultibodyError;
use crate::gas_pressure::GasPressure;
use crate::powered::History;
use crate::run::result::{Run, RunOutcome, RunState};
use crate::run::runner::Runner;
use crate::simulation::{Duration, Simulation};
use crate::train::Train;
use nalgebra::DVector;
pub use outcome::{Followed, PeriodicOutcome};
use search::{NEARLY, Search, multipliers};
use serde::Serialize;
use std::cell::Cell;

/// Periods by which the motion is followed forward before Newton starts again.
const FOLLOWED: [usize; 2] = [20, 80];

/// A periodic motion, or what was found instead.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Periodic {
    /// How the search ended.
    pub outcome: PeriodicOutcome,
    /// Largest change over one period, over the size of its kind of state.
    pub residual: f64,
    /// Newton's iterations.
    pub iterations: usize,
    /// Multipliers by falling size: real and imaginary part; empty where none was found, and with a dead time, which has infinitely many.
    pub multipliers: Vec<[f64; 2]>,
    /// How far the motion was followed forward from the start, where Newton did not find it from there.
    pub followed: Option<Followed>,
    /// One period from its start, with samples; where the crank came to rest on the way, the run from the start until then.
    pub run: Run,
}

impl Train {
    /// The periodic motion next to the start that `simulation` describes; its duration does not count. Pistons and shafts return after
    /// [`Train::revolutions`] revolutions.
    ///
    /// # Errors
    /// As [`Train::run`].
    pub fn periodic(
        &self,
        simulation: &Simulation,
        gas: Option<&dyn GasPressure>,
    ) -> Result<Periodic, MultibodyError> {
        self.periodic_watched(simulation, gas, &|_| true)
    }

    /// The same; after every step `watch` sees how far a period is, and `false` ends the search: the run is then a period of the best trial so far, marked.
    ///
    /// # Errors
    /// As [`Train::run`].
    pub fn periodic_watched(
        &self,
        simulation: &Simulation,
        gas: Option<&dyn GasPressure>,
        watch: &dyn Fn(RunState) -> bool,
    ) -> Result<Periodic, MultibodyError> {
        let revolutions = f64::from(self.revolutions);
        let tolerance = simulation.tolerance.min(1e-11);
        let quiet = Simulation {
            duration: Duration::Revolutions(revolutions),
            reactions: false,
            step: std::f64::consts::TAU * revolutions,
            tolerance,
            ..simulation.clone()
        };
        let cancelled = Cell::new(false);
        let watch = |state| {
            let goes_on = watch(state);
            cancelled.set(cancelled.get() || !goes_on);
            goes_on
        };
        let mut runner = Runner::new(self, &quiet, gas)?;
        runner.watch = &watch;
        let mut search = Search::new(runner);
        let mut x = search.start.clone();
        let mut walk = Walk::default();
        // With a past the time of a period must be known first.
        if !search.has_past() {
            search.newton(&mut x);
        }
        for periods in FOLLOWED {
            if search.residual < NEARLY || cancelled.get() {
                break;
            }
            // From where the motion was left before, not from Newton's last trial.
            if let Some((end, past)) = walk.end.take() {
                (x, search.past) = (end, past);
            } else {
                x.copy_from(&search.start);
            }
            if !walk.follow(&mut search, &mut x, periods) {
                break;
            }
            walk.end = Some((x.clone(), search.past.clone()));
            search.newton(&mut x);
        }
        if search.residual >= NEARLY
            && !cancelled.get()
            && let Some((end, past)) = walk.end.take()
        {
            (x, search.past) = (end, past);
            search.residual = walk.off;
        }
        let outcome = match search.residual < NEARLY {
            _ if cancelled.get() => PeriodicOutcome::Cancelled,
            false => PeriodicOutcome::NotFound,
            true => search.outcome(&x),
        };
        let multipliers = search.at_motion.as_ref().map_or_else(Vec::new, multipliers);
        let came_to_rest = outcome == PeriodicOutcome::NotFound && walk.came_to_rest;
        let shown = |periods: usize| Simulation {
            duration: Duration::Revolutions(revolutions * periods as f64),
            tolerance,
            ..simulation.clone()
        };
        let mut run = if came_to_rest {
            self.run_from(&shown(walk.periods + 1), gas, None, &|_| true)?
        } else {
            let past = search.past.take();
            self.run_from(&shown(1), gas, Some((x.as_slice(), past.as_ref())), &|_| true)?
        };
        if cancelled.get() {
            run.outcome = RunOutcome::Cancelled;
        }
        let followed = (walk.periods > 0 || walk.came_to_rest).then_some(Followed {
            periods: walk.periods,
            time: walk.time,
            speeds: walk.speeds,
            came_to_rest: walk.came_to_rest,
        });
        let (residual, iterations) = (search.residual, search.iterations);
        Ok(Periodic { outcome, residual, iterations, multipliers, followed, run })
    }
}

/// The motion as it goes on from the start, period after period.
#[derive(Default)]
struct Walk {
    periods: usize,
    time: f64,
    speeds: [f64; 3],
    /// Change over its last period, over the size of its kind of state.
    off: f64,
    came_to_rest: bool,
    /// Where it was left, with its past.
    end: Option<(DVector<f64>, Option<History>)>,
}

impl Walk {
    /// Follows the motion from `x` over `periods`; whether it came so far.
    fn follow(&mut self, search: &mut Search<'_>, x: &mut DVector<f64>, periods: usize) -> bool {
        if self.periods == 0 {
            self.speeds = [search.speed(x); 3];
        }
        for _ in 0..periods {
            let Some(change) = search.change(x) else {
                self.came_to_rest = matches!(search.ended, RunOutcome::AtRest { .. });
                return false;
            };
            *x += &change;
            self.off = search.off(&change);
            self.periods += 1;
            self.time += search.time();
            self.speeds = [self.speeds[0], self.speeds[2], search.speed(x)];
            search.keep_past();
        }
        true
    }
}
