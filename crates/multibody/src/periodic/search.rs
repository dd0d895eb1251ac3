//! The map of one period over the components of the state that must return, and Newton's steps on it.

use super::outcome::PeriodicOutcome;
use crate::powered::History;
use crate::run::result::RunOutcome;
use crate::run::runner::Runner;
use crate::simulation::Drive;
use nalgebra::{DMatrix, DVector, Schur};

/// Newton's iterations.
pub(super) const ITERATIONS: usize = 30;

/// What counts as closed: change over one period over the size of each kind of state.
pub(super) const CLOSED: f64 = 1e-10;

/// What still counts as closed where iterations no longer help: the errors of the steps leave the map with noise. What is reached is told.
pub(super) const NEARLY: f64 = 1e-8;

/// What the bends of pressures may leave within steps that go across them: farther from a motion than that, ends of steps there help nothing.
const NOISE: f64 = 1e-4;

/// Iterations without half the best residual so far after which none helps any more.
pub(super) const IDLE: usize = 3;

/// Share of the residual before below which the derivative that gave the step is kept.
pub(super) const HELPS: f64 = 0.05;

/// Step of the differences, as a share of the size of each kind of state.
pub(super) const SHARE: f64 = 1e-5;

/// A multiplier closer to 1 than this has no preferred speed.
const NEUTRAL: f64 = 1e-6;

/// Largest change of the speed in one of Newton's steps, as a share of the speed: farther away the derivative says nothing.
const FARTHEST: f64 = 0.25;

/// Eigenvalues of the map's derivative by falling size; empty where they are not found.
pub(super) fn multipliers(slope: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let map = slope + DMatrix::identity(slope.nrows(), slope.ncols());
    let Some(schur) = Schur::try_new(map, f64::EPSILON, 10_000) else { return Vec::new() };
    let mut all: Vec<[f64; 2]> =
        schur.complex_eigenvalues().iter().map(|value| [value.re, value.im]).collect();
    all.sort_by(|a, b| b[0].hypot(b[1]).total_cmp(&a[0].hypot(a[1])));
    all
}

/// Sizes of the kinds of state: speeds by `speed` [rad/s], angles by 1 rad; places by what the block moves by: a millimetre, a milliradian.
fn sizes(runner: &Runner<'_>, speed: f64) -> Vec<f64> {
    let layout = runner.powered.layout;
    let mut sizes = Vec::new();
    if matches!(runner.powered.simulation.drive, Drive::Free) {
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
    sizes
}

/// The map of one period over the components of the state that must return.
pub(super) struct Search<'a> {
    runner: Runner<'a>,
    pub start: DVector<f64>,
    pub(super) sizes: Vec<f64>,
    /// Whether the speed is free.
    moves_freely: bool,
    /// Least residual so far: change over one period over the size of each kind of state.
    pub residual: f64,
    /// Newton's iterations.
    pub iterations: usize,
    /// Whether the stability of the motion is asked for.
    pub is_judged: bool,
    /// Derivative of the map less its argument from before, or the last one.
    pub derivative: Option<DMatrix<f64>>,
    /// The same at the motion that was found, where its stability is asked for.
    pub at_motion: Option<DMatrix<f64>>,
    /// How the last period ended.
    pub ended: RunOutcome,
    /// What a governor with a dead time wanted before the period.
    pub past: Option<History>,
    /// Whether steps end at the bends of the pressures.
    pub at_bends: bool,
}

impl<'a> Search<'a> {
    pub fn new(runner: Runner<'a>) -> Search<'a> {
        let sizes = sizes(&runner, runner.state[1].abs().max(1.0));
        let start = DVector::from_column_slice(&runner.returning());
        let moves_freely = matches!(runner.powered.simulation.drive, Drive::Free);
        let past = runner.powered.history.as_ref().map(|history| history.borrow().clone());
        Search {
            runner,
            start,
            sizes,
            moves_freely,
            residual: f64::INFINITY,
            iterations: 0,
            is_judged: false,
            derivative: None,
            at_motion: None,
            ended: RunOutcome::Complete,
            past,
            at_bends: false,
        }
    }

    /// Whether the period begins with a starter at work: it does not return, and Newton has nothing to start from.
    pub fn is_being_started(&self) -> bool {
        self.runner.powered.conditions.starter
    }

    /// Speeds are measured by the one of `x` from now on.
    pub fn measure_by(&mut self, x: &DVector<f64>) {
        let speed = self.speed(x).abs().max(1.0);
        self.sizes = sizes(&self.runner, speed);
    }

    /// Newton's steps from `x`, and where they stay short of [`CLOSED`], from there with steps that end at the bends of the pressures: pressures through points have
    /// jumps of their curvature at every point, whose errors within steps leave the map with noise.
    pub fn close(&mut self, x: &mut DVector<f64>) {
        self.newton(x);
        let is_near = self.residual < NOISE && self.residual >= CLOSED;
        if !is_near || self.has_past() || self.at_bends || !self.runner.end_steps_at_bends() {
            return;
        }
        self.at_bends = true;
        self.newton(x);
    }

    /// Whether the past is part of the state.
    pub fn has_past(&self) -> bool {
        self.past.is_some()
    }

    /// Periods into which the past reaches.
    pub fn periods_of_past(&self) -> usize {
        let delay = self.runner.powered.simulation.governor.map_or(0.0, |governor| governor.delay);
        (delay / self.runner.time).ceil() as usize
    }

    /// The past of the next period is that of the end of the last one.
    pub fn keep_past(&mut self) {
        let time = self.runner.time;
        self.past = self.runner.powered.history.as_ref().map(|history| history.borrow().earlier_by(time));
    }

    /// Speed of the crank in a state [rad/s].
    pub fn speed(&self, x: &DVector<f64>) -> f64 {
        if self.moves_freely { x[0] } else { self.runner.state[1] }
    }

    /// Time of the last period [s].
    pub fn time(&self) -> f64 {
        self.runner.time
    }

    /// Largest change over the size of its kind of state.
    pub fn off(&self, change: &DVector<f64>) -> f64 {
        change.iter().zip(&self.sizes).map(|(c, s)| (c / s).abs()).fold(0.0, f64::max)
    }

    /// `G(x)`; `None` where the period does not come to its end.
    pub fn change(&mut self, x: &DVector<f64>) -> Option<DVector<f64>> {
        self.runner.rewind(x.as_slice(), self.past.as_ref());
        self.ended = self.runner.go(|_, _| {});
        (self.ended == RunOutcome::Complete)
            .then(|| DVector::from_column_slice(&self.runner.returning()) - x)
            .filter(|change| change.iter().all(|value| value.is_finite()))
    }

    /// Newton's steps from `x`, which becomes the best place.
    pub fn newton(&mut self, x: &mut DVector<f64>) {
        if self.has_past() {
            return self.newton_with_past(x);
        }
        // A derivative from farther away serves until it no longer helps; the multipliers take one at the motion itself.
        let mut slope = self.derivative.take();
        let mut helps = slope.is_some();
        let mut best: Option<(f64, DVector<f64>)> = None;
        let (mut idle, mut last) = (0, f64::INFINITY);
        for _ in 0..ITERATIONS {
            let Some(change) = self.change(x) else { break };
            let off = self.off(&change);
            let is_best = best.as_ref().is_none_or(|(least, _)| off < *least);
            idle = if best.as_ref().is_none_or(|(least, _)| off < 0.5 * least) { 0 } else { idle + 1 };
            if is_best {
                best = Some((off, x.clone()));
            }
            if idle >= IDLE {
                break;
            }
            if off < CLOSED {
                if self.is_judged {
                    self.at_motion = self.slope(x, &change, true);
                }
                break;
            }
            helps = helps && off < HELPS * last;
            last = off;
            if !helps {
                slope = self.slope(x, &change, false);
                helps = true;
            }
            let Some(step) = slope.as_ref().and_then(|matrix| self.step(matrix, &change)) else { break };
            *x += self.bounded(step, x);
            self.iterations += 1;
        }
        if let Some((least, place)) = best {
            (self.residual, *x) = (least, place);
        }
        if !self.is_judged {
            self.derivative = slope;
        }
    }

    /// A step that leaves the speed near what it is.
    pub(super) fn bounded(&self, step: DVector<f64>, x: &DVector<f64>) -> DVector<f64> {
        let share = if self.moves_freely { FARTHEST * x[0].abs() / step[0].abs() } else { 1.0 };
        step * share.min(1.0)
    }

    /// What kind of motion was found at `x`.
    pub fn outcome(&mut self, x: &DVector<f64>) -> PeriodicOutcome {
        if x.is_empty() {
            return PeriodicOutcome::Stable;
        }
        if !self.has_past() && self.at_motion.is_none() {
            let change = self.change(x);
            self.at_motion = change.and_then(|change| self.slope(x, &change, true));
        }
        let multipliers = self.at_motion.as_ref().map_or_else(Vec::new, multipliers);
        let Some(largest) = multipliers.first().map(|m| m[0].hypot(m[1])).filter(|_| !self.has_past()) else {
            // With a past, or without multipliers, a small departure is followed.
            let dies_out = self.dies_out(x);
            return if dies_out { PeriodicOutcome::Stable } else { PeriodicOutcome::Unstable };
        };
        // What the noise of the map does to its differences.
        let neutral = NEUTRAL.max(self.residual / SHARE);
        match largest {
            largest if largest > 1.0 + neutral => PeriodicOutcome::Unstable,
            largest if largest > 1.0 - neutral && self.moves_freely => PeriodicOutcome::Neutral,
            _ => PeriodicOutcome::Stable,
        }
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
        self.step_above(slope, change, NEUTRAL)
    }

    /// Newton's step along what changes by more than `least`, each component over its size.
    pub(super) fn step_above(
        &self,
        slope: &DMatrix<f64>,
        change: &DVector<f64>,
        least: f64,
    ) -> Option<DVector<f64>> {
        let size = change.len();
        let scaled = DMatrix::from_fn(size, size, |i, j| slope[(i, j)] * self.sizes[j] / self.sizes[i]);
        let right = DVector::from_fn(size, |i, _| -change[i] / self.sizes[i]);
        let parts = scaled.svd(true, true);
        let step = parts.solve(&right, least).ok()?;
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

    /// A crank that turns is not held, and a starter that it outruns is gone, whatever was before.
    fn turns_on(&mut self) {
        let speed = self.state[1];
        let conditions = &mut self.powered.conditions;
        if speed != 0.0 {
            (conditions.held, conditions.sense) = (false, speed.signum());
        }
        let until = self.powered.simulation.starter.map_or(f64::INFINITY, |starter| starter.until);
        conditions.starter = conditions.starter && speed < until;
    }

    /// Back to the start of the run with these components, and the past of a governor with a dead time.
    pub(crate) fn rewind(&mut self, returning: &[f64], past: Option<&History>) {
        let layout = self.powered.layout;
        if let (Some(history), Some(past)) = (&self.powered.history, past) {
            history.replace(past.clone());
        }
        self.time = 0.0;
        self.state[0] = self.powered.simulation.start_angle;
        self.state[layout.works()..].fill(0.0);
        let mut rest = returning.iter().copied();
        let mut next = || rest.next().unwrap_or(0.0);
        if matches!(self.powered.simulation.drive, Drive::Free) {
            self.state[1] = next();
            self.turns_on();
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
