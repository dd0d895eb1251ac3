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
use crate::run::Returning;
use crate::run::result::{Run, RunOutcome, RunState};
use crate::run::runner::Runner;
use crate::simulation::{Duration, Simulation};
use crate::train::Train;
use nalgebra::{DMatrix, DVector};
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
        let quiet = self.one_period(simulation, false);
        let cancelled = Cell::new(false);
        let watch = |state| {
            let goes_on = watch(state);
            cancelled.set(cancelled.get() || !goes_on);
            goes_on
        };
        let mut runner = Runner::new(self, &quiet, gas)?;
        runner.watch = &watch;
        let mut search = Search::new(runner);
        search.is_judged = true;
        let (x, walk) = search.find(&cancelled);
        let outcome = match search.residual < NEARLY {
            _ if cancelled.get() => PeriodicOutcome::Cancelled,
            false => PeriodicOutcome::NotFound,
            true => search.outcome(&x),
        };
        let multipliers = search.at_motion.as_ref().map_or_else(Vec::new, multipliers);
        let came_to_rest = outcome == PeriodicOutcome::NotFound && walk.came_to_rest;
        let mut shown = self.one_period(simulation, true);
        let mut run = if came_to_rest {
            shown.duration = Duration::Revolutions(revolutions * (walk.periods + 1) as f64);
            self.run_from(&shown, gas, None, &|_| true)?
        } else {
            let past = search.past.take();
            let returning = Returning { state: x.as_slice(), past: past.as_ref(), at_bends: search.at_bends };
            self.run_from(&shown, gas, Some(returning), &|_| true)?
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

    /// One period of the periodic motion next to the start with its samples, to a residual of 1e-8, without a word on its stability, which costs two periods for each
    /// component of the state; `None` where none was found. The `derivative` that a search for a similar motion left saves as many again; it is left for the next.
    ///
    /// # Errors
    /// As [`Train::run`].
    pub fn closed_period(
        &self,
        simulation: &Simulation,
        gas: Option<&dyn GasPressure>,
        derivative: &mut MapDerivative,
    ) -> Result<Option<Run>, MultibodyError> {
        let quiet = self.one_period(simulation, false);
        let mut search = Search::new(Runner::new(self, &quiet, gas)?);
        search.derivative = derivative.0.take().filter(|own| own.nrows() == search.start.len());
        let (x, _) = search.find(&Cell::new(false));
        derivative.0 = search.derivative.take();
        if search.residual >= NEARLY {
            return Ok(None);
        }
        let past = search.past.take();
        let shown = self.one_period(simulation, true);
        let returning = Returning { state: x.as_slice(), past: past.as_ref(), at_bends: search.at_bends };
        self.run_from(&shown, gas, Some(returning), &|_| true).map(Some)
    }

    /// What is simulated of a search, and of the motion that it finds where `is_shown`.
    fn one_period(&self, simulation: &Simulation, is_shown: bool) -> Simulation {
        let revolutions = f64::from(self.revolutions);
        let own = Simulation {
            duration: Duration::Revolutions(revolutions),
            tolerance: simulation.tolerance.min(1e-11),
            ..simulation.clone()
        };
        if is_shown {
            return own;
        }
        Simulation { reactions: false, step: std::f64::consts::TAU * revolutions, ..own }
    }
}

/// Derivative of the map of one period, as [`Train::closed_period`] leaves it; none at first.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MapDerivative(Option<DMatrix<f64>>);

impl Search<'_> {
    /// Newton from the start and, where that finds nothing, from where the motion comes to: the best place, and how far the motion was followed.
    fn find(&mut self, cancelled: &Cell<bool>) -> (DVector<f64>, Walk) {
        let mut x = self.start.clone();
        let mut walk = Walk::default();
        // With a past the time of a period must be known first; a start is no motion that returns.
        let is_started = self.is_being_started();
        if !self.has_past() && !is_started {
            self.close(&mut x);
        }
        for periods in FOLLOWED {
            if self.residual < NEARLY || cancelled.get() {
                break;
            }
            // From where the motion was left before, not from Newton's last trial.
            if let Some((end, past)) = walk.end.take() {
                (x, self.past) = (end, past);
            } else {
                x.copy_from(&self.start);
            }
            if !walk.follow(self, &mut x, periods) {
                break;
            }
            walk.end = Some((x.clone(), self.past.clone()));
            if is_started {
                self.measure_by(&x);
            }
            self.close(&mut x);
        }
        if self.residual >= NEARLY
            && !cancelled.get()
            && let Some((end, past)) = walk.end.take()
        {
            (x, self.past) = (end, past);
            self.residual = walk.off;
        }
        (x, walk)
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
