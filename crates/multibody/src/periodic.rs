//! The periodic motion: Newton on the map of one period over speed, block and driveline.
//!
//! ```text
//! G(x) = state after one period from x, less x;       G = 0       multipliers: eigenvalues of dG/dx + 1
//! ```
//! The crank angle is the independent variable, so that the period is known. A periodic motion with all multipliers within the unit circle is stable; with a
//! load that does not depend on the speed one of them is 1, because every speed has its own periodic motion: then the mean speed is kept at that of the start.

use crate::error::MultibodyError;
use crate::gas_pressure::GasPressure;
use crate::run::result::{Run, RunOutcome, RunState};
use crate::run::runner::Runner;
use crate::simulation::{Drive, Duration, Simulation};
use crate::train::Train;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use std::cell::Cell;

/// Newton's iterations.
const ITERATIONS: usize = 30;

/// What counts as closed: change over one period over the size of each kind of state.
const CLOSED: f64 = 1e-10;

/// What still counts as closed where iterations no longer help: pressures through points have kinks of their curvature at every point, whose errors within
/// steps leave the map with noise.
const NEARLY: f64 = 1e-8;

/// Iterations without half the best residual so far after which none helps any more.
const IDLE: usize = 3;

/// Share of the residual before below which the derivative that gave the step is kept.
const HELPS: f64 = 0.05;

/// Step of the differences, as a share of the size of each kind of state.
const SHARE: f64 = 1e-5;

/// A multiplier closer to 1 than this has no preferred speed.
const NEUTRAL: f64 = 1e-6;

/// A periodic motion, or what was found instead.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Periodic {
    /// How Newton ended.
    pub outcome: PeriodicOutcome,
    /// Largest change over one period, over the size of its kind of state.
    pub residual: f64,
    /// Newton's iterations.
    pub iterations: usize,
    /// Multipliers by falling size: real and imaginary part.
    pub multipliers: Vec<[f64; 2]>,
    /// One period from its start, with samples.
    pub run: Run,
}

/// How the search for a periodic motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PeriodicOutcome {
    /// Found: small departures from it die out.
    Stable,
    /// Found: the load does not depend on the speed, so that departures of the speed stay.
    Neutral,
    /// Found: small departures from it grow.
    Unstable,
    /// Not found: the run shows the last trial, which does not close.
    NotFound,
    /// Whoever watched the search ended it: the run is a period of the best trial so far, which need not close.
    Cancelled,
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
        if let Some(governor) = simulation.governor.filter(|governor| governor.delay > 0.0) {
            return Err(MultibodyError::DelayNotPeriodic { delay: governor.delay });
        }
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
        let mut iterations = 0;
        let mut found = None;
        // A derivative from farther away serves until it no longer helps; the multipliers take one at the motion itself.
        let (mut slope, mut helps) = (None, false);
        let mut at_motion = None;
        let mut best: Option<(f64, DVector<f64>)> = None;
        let mut idle = 0;
        let mut last = f64::INFINITY;
        while iterations < ITERATIONS {
            let Some(change) = search.change(&x) else { break };
            let off = change.iter().zip(search.sizes.iter()).map(|(c, s)| (c / s).abs()).fold(0.0, f64::max);
            found = Some(off);
            idle = if best.as_ref().is_none_or(|(least, _)| off < 0.5 * least) { 0 } else { idle + 1 };
            if best.as_ref().is_none_or(|(least, _)| off < *least) {
                best = Some((off, x.clone()));
            }
            if idle >= IDLE && best.as_ref().is_some_and(|(least, _)| *least < NEARLY) {
                break;
            }
            if off < CLOSED {
                at_motion = search.slope(&x, &change, true);
                break;
            }
            helps = helps && off < HELPS * last;
            last = off;
            if !helps {
                slope = search.slope(&x, &change, false);
                helps = true;
            }
            let Some(step) = slope.as_ref().and_then(|matrix| search.step(matrix, &change)) else { break };
            x += step;
            iterations += 1;
        }
        let mut residual = found.unwrap_or(f64::INFINITY);
        if let Some((least, place)) =
            best.filter(|(least, _)| (cancelled.get() || *least < NEARLY) && *least < residual)
        {
            (residual, x) = (least, place);
        }
        if at_motion.is_none() && residual < NEARLY && !cancelled.get() {
            let change = search.change(&x);
            at_motion = change.and_then(|change| search.slope(&x, &change, true));
        }
        let multipliers = at_motion.as_ref().or(slope.as_ref()).map_or_else(Vec::new, multipliers);
        let largest = multipliers.first().map_or(0.0, |m| m[0].hypot(m[1]));
        // What the noise of the map does to its differences.
        let neutral = NEUTRAL.max(residual / SHARE);
        let outcome = match residual < NEARLY {
            _ if cancelled.get() => PeriodicOutcome::Cancelled,
            false => PeriodicOutcome::NotFound,
            true if largest > 1.0 + neutral => PeriodicOutcome::Unstable,
            true if largest > 1.0 - neutral && search.moves_freely => PeriodicOutcome::Neutral,
            true => PeriodicOutcome::Stable,
        };
        let shown = Simulation { duration: quiet.duration, tolerance, ..simulation.clone() };
        let mut run = self.run_from(&shown, gas, Some(x.as_slice()), &|_| true)?;
        if cancelled.get() {
            run.outcome = RunOutcome::Cancelled;
        }
        Ok(Periodic { outcome, residual, iterations, multipliers, run })
    }
}

/// Eigenvalues of the map's derivative by falling size.
fn multipliers(slope: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let map = slope + DMatrix::identity(slope.nrows(), slope.ncols());
    let mut all: Vec<[f64; 2]> = map.complex_eigenvalues().iter().map(|value| [value.re, value.im]).collect();
    all.sort_by(|a, b| b[0].hypot(b[1]).total_cmp(&a[0].hypot(a[1])));
    all
}

/// The map of one period over the components of the state that must return.
struct Search<'a> {
    runner: Runner<'a>,
    start: DVector<f64>,
    sizes: Vec<f64>,
    /// Whether the speed is free.
    moves_freely: bool,
}

impl<'a> Search<'a> {
    fn new(runner: Runner<'a>) -> Search<'a> {
        let layout = runner.powered.layout;
        let speed = runner.state[1].abs().max(1.0);
        let start = DVector::from_column_slice(&runner.returning());
        let moves_freely = matches!(runner.powered.simulation.drive, Drive::Free);
        // Speeds by the speed, angles by 1 rad; places by what the block moves by: a millimetre, a milliradian.
        let mut sizes = Vec::new();
        if moves_freely {
            sizes.push(speed);
        }
        sizes.extend((0..layout.links).flat_map(|_| [1.0, speed]));
        if layout.moving {
            sizes.extend([1e-3; 6]);
            sizes.extend([1e-3 * speed; 6]);
        }
        if layout.governed {
            sizes.extend(std::iter::repeat_n(1.0, layout.relaxing() - layout.governor()));
        }
        sizes.extend(std::iter::repeat_n(1e-3, layout.branches));
        Search { runner, start, sizes, moves_freely }
    }

    /// `G(x)`; `None` where the period does not come to its end.
    fn change(&mut self, x: &DVector<f64>) -> Option<DVector<f64>> {
        self.runner.rewind(x.as_slice());
        let outcome = self.runner.go(|_, _| {});
        (outcome == RunOutcome::Complete)
            .then(|| DVector::from_column_slice(&self.runner.returning()) - x)
            .filter(|change| change.iter().all(|value| value.is_finite()))
    }

    /// `dG/dx` by differences to one side, or to both.
    fn slope(&mut self, x: &DVector<f64>, change: &DVector<f64>, central: bool) -> Option<DMatrix<f64>> {
        let mut matrix = DMatrix::zeros(change.len(), x.len());
        for k in 0..x.len() {
            let step = SHARE * self.sizes[k];
            let mut beside = x.clone();
            beside[k] += step;
            let above = self.change(&beside)?;
            if !central {
                matrix.set_column(k, &((above - change) / step));
                continue;
            }
            beside[k] -= 2.0 * step;
            let below = self.change(&beside)?;
            matrix.set_column(k, &((above - below) / (2.0 * step)));
        }
        Some(matrix)
    }

    /// Newton's step; with a speed that nothing prefers the smallest one.
    fn step(&self, slope: &DMatrix<f64>, change: &DVector<f64>) -> Option<DVector<f64>> {
        let size = change.len();
        let scaled = DMatrix::from_fn(size, size, |i, j| slope[(i, j)] * self.sizes[j] / self.sizes[i]);
        let right = DVector::from_fn(size, |i, _| -change[i] / self.sizes[i]);
        let parts = scaled.svd(true, true);
        let step = parts.solve(&right, NEUTRAL).ok()?;
        Some(DVector::from_fn(size, |i, _| step[i] * self.sizes[i]))
    }
}

impl Runner<'_> {
    /// The components of the state that must return after a period: speed, driveline relative to the crank, block, governor. The turn of the block is that of
    /// its rotation vector.
    pub(crate) fn returning(&self) -> Vec<f64> {
        let layout = self.powered.layout;
        let mut all = Vec::new();
        if matches!(self.powered.simulation.drive, Drive::Free) {
            all.push(self.state[1]);
        }
        let mut ratio = 1.0;
        for (index, link) in self.powered.simulation.driveline.iter().enumerate() {
            ratio *= link.ratio;
            all.push(self.state[layout.link(index)] - ratio * self.state[0]);
            all.push(self.state[layout.link(index) + 1]);
        }
        if layout.moving {
            let own = &self.state[layout.pose()..layout.pose() + 13];
            let q = nalgebra::Quaternion::new(own[3], own[4], own[5], own[6]);
            let turn = nalgebra::UnitQuaternion::from_quaternion(q).scaled_axis();
            all.extend([own[0], own[1], own[2], turn.x, turn.y, turn.z]);
            all.extend(&own[7..13]);
        }
        if layout.governed {
            all.extend(&self.state[layout.governor()..layout.relaxing()]);
        }
        all.extend(&self.state[layout.relaxing()..layout.works()]);
        all
    }

    /// Back to the start of the run with these components.
    pub(crate) fn rewind(&mut self, returning: &[f64]) {
        let layout = self.powered.layout;
        self.time = 0.0;
        self.state[0] = self.powered.simulation.start_angle;
        self.state[layout.works()..].fill(0.0);
        let mut rest = returning.iter().copied();
        let mut next = || rest.next().unwrap_or(0.0);
        if matches!(self.powered.simulation.drive, Drive::Free) {
            self.state[1] = next();
        }
        let mut ratio = 1.0;
        for (index, link) in self.powered.simulation.driveline.iter().enumerate() {
            ratio *= link.ratio;
            self.state[layout.link(index)] = next() + ratio * self.state[0];
            self.state[layout.link(index) + 1] = next();
        }
        if layout.moving {
            let at = layout.pose();
            let own: [f64; 12] = std::array::from_fn(|_| next());
            let turn =
                nalgebra::UnitQuaternion::from_scaled_axis(nalgebra::Vector3::new(own[3], own[4], own[5]));
            self.state[at..at + 3].copy_from_slice(&own[..3]);
            self.state[at + 3..at + 7].copy_from_slice(&[turn.w, turn.i, turn.j, turn.k]);
            self.state[at + 7..at + 13].copy_from_slice(&own[6..]);
        }
        if layout.governed {
            self.state[layout.governor()..layout.relaxing()].iter_mut().for_each(|own| *own = next());
        }
        self.state[layout.relaxing()..layout.works()].iter_mut().for_each(|own| *own = next());
    }
}
