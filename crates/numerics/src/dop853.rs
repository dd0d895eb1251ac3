//! DOP853: Dormand and Prince's explicit Runge-Kutta pair of order 8(5,3) with an interpolant of order 7.
//!
//! Source: Hairer, Norsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd edition, section II.10.

use crate::control::{course, first_step, infinite, together};
use crate::dop853_table::{A, C, D, ERROR_5, ORDER_3};
use crate::event::Sides;
use crate::stages::{LANES, Stages};
use crate::step::Interpolant;
use crate::{Outcome, Settings, Statistics, Step, System};
use std::ops::ControlFlow;

/// Step times spectral radius above which the step is held by stability: the method's region ends there on the real axis.
const STABLE: f64 = 6.1;

/// The integrator. It keeps its step, the signs of events and its statistics from run to run, so that a run may be
/// continued behind an event.
#[derive(Debug, Clone)]
pub struct Dop853 {
    settings: Settings,
    step: Option<f64>,
    sides: Sides,
    statistics: Statistics,
    stages: Stages,
    coefficients: Vec<f64>,
    trial: Vec<f64>,
    next: Vec<f64>,
    stiff: u32,
    not_stiff: u32,
}

/// What an attempted step came to.
enum Attempt {
    /// Error over tolerance.
    Error(f64),
    /// A stage is no number.
    NotFinite(Outcome),
}

impl Dop853 {
    /// An integrator with these settings.
    pub fn new(settings: Settings) -> Dop853 {
        Dop853 {
            step: settings.first_step,
            settings,
            sides: Sides::default(),
            statistics: Statistics::default(),
            stages: Stages::default(),
            coefficients: Vec::new(),
            trial: Vec::new(),
            next: Vec::new(),
            stiff: 0,
            not_stiff: 0,
        }
    }

    /// Cost of all runs so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Length of the next step, as the last one proposes it: the first step of a run that goes on where this one ends. `None` before any.
    pub fn proposed_step(&self) -> Option<f64> {
        self.step
    }

    /// Forgets step and signs of events: for a state that was set from outside.
    pub fn restart(&mut self) {
        self.step = self.settings.first_step;
        self.sides.forget();
    }

    /// Integrates from `t` to `end`, forwards or backwards, and shows each accepted step to `observe`. `t` and `y` hold
    /// the last good state, whatever the outcome.
    ///
    /// # Panics
    /// If `y` has not the system's dimension.
    pub fn run(
        &mut self,
        system: &mut impl System,
        t: &mut f64,
        y: &mut [f64],
        end: f64,
        mut observe: impl FnMut(&Step) -> ControlFlow<()>,
    ) -> Outcome {
        let n = system.dimension();
        assert_eq!(y.len(), n, "a state of the system's dimension");
        self.stages.resize(16, n);
        self.coefficients.resize(7 * n, 0.0);
        self.trial.resize(n, 0.0);
        self.next.resize(n, 0.0);
        if let Some(outcome) = infinite(y) {
            return outcome;
        }
        for stop in course(*t, end, &self.settings.stops) {
            if let Some(outcome) = self.reach(system, t, y, stop, &mut observe) {
                return outcome;
            }
        }
        Outcome::Reached
    }

    /// Steps up to one forced stop; an outcome where the run ends before.
    fn reach(
        &mut self,
        system: &mut impl System,
        t: &mut f64,
        y: &mut [f64],
        stop: f64,
        observe: &mut impl FnMut(&Step) -> ControlFlow<()>,
    ) -> Option<Outcome> {
        if together(*t, stop) {
            *t = stop;
            return None;
        }
        let sense = (stop - *t).signum();
        system.enter(*t, stop);
        system.derivative(*t, y, self.stages.row_mut(0));
        self.statistics.evaluations += 1;
        if let Some(outcome) = infinite(self.stages.row(0)) {
            return Some(outcome);
        }
        let mut wanted = match self.step {
            Some(step) => step.abs(),
            None => {
                self.statistics.evaluations += 1;
                first_step(system, &self.settings, (*t, stop), y, self.stages.row(0), 8.0).abs()
            }
        };
        let mut rejected = false;
        loop {
            if self.statistics.evaluations + 15 > self.settings.most_evaluations {
                return Some(Outcome::TooManyEvaluations { limit: self.settings.most_evaluations });
            }
            wanted = wanted.min(self.settings.longest_step);
            let left = (stop - *t).abs();
            let last = wanted * 1.01 >= left;
            let size = if last { left } else { wanted.min(0.5 * left.max(wanted)) };
            let h = sense * size;
            let to = if last { stop } else { *t + h };
            match self.attempt(system, *t, y, h) {
                Attempt::NotFinite(outcome) => {
                    self.statistics.rejected += 1;
                    rejected = true;
                    wanted = 0.25 * size;
                    if together(*t, *t + sense * wanted) {
                        return Some(outcome);
                    }
                    continue;
                }
                Attempt::Error(error) => {
                    let Settings { safety, largest_growth, .. } = self.settings;
                    let factor = (safety * error.max(1e-30).powf(-0.125)).clamp(1.0 / 3.0, largest_growth);
                    if error > 1.0 {
                        self.statistics.rejected += 1;
                        rejected = true;
                        wanted = size * factor.min(0.9);
                        if together(*t, *t + sense * wanted) {
                            return Some(Outcome::StepTooSmall { step: sense * wanted });
                        }
                        continue;
                    }
                    let proposed = size * if rejected { factor.min(1.0) } else { factor };
                    // A step that was cut by a stop says nothing against the longer one that was wanted.
                    wanted = if last { proposed.max(wanted) } else { proposed };
                    rejected = false;
                }
            }
            self.step = Some(wanted);
            let ended = self.accept(system, (t, y), (h, to), observe);
            if ended.is_some() || *t == stop {
                return ended;
            }
        }
    }

    /// The twelve stages of a step of `h`, the new state and its derivative.
    fn attempt(&mut self, system: &mut impl System, t: f64, y: &[f64], h: f64) -> Attempt {
        let n = y.len();
        for stage in 1..13 {
            let state = if stage == 12 { &mut self.next } else { &mut self.trial };
            self.stages.advance(state, y, h, A[stage]);
            let slope = self.stages.row_mut(stage);
            system.derivative(t + C[stage] * h, state, slope);
            self.statistics.evaluations += 1;
            if let Some(outcome) = infinite(slope) {
                return Attempt::NotFinite(outcome);
            }
        }
        let (mut fifth, mut third) = (0.0, 0.0);
        for (lane, (start, end)) in y.chunks(LANES).zip(self.next.chunks(LANES)).enumerate() {
            let of_5 = self.stages.sum(ERROR_5, lane);
            let (of_8, below) = (self.stages.sum(A[12], lane), self.stages.sum(&ORDER_3, lane));
            for (k, (from, to)) in start.iter().zip(end).enumerate() {
                let by_scale = 1.0 / self.settings.scale(LANES * lane + k, from.abs().max(to.abs()));
                fifth += (of_5[k] * by_scale).powi(2);
                third += ((of_8[k] - below[k]) * by_scale).powi(2);
            }
        }
        let sum = fifth + 0.01 * third;
        if sum <= 0.0 {
            return Attempt::Error(0.0);
        }
        let error = h.abs() * fifth / (n as f64 * sum).sqrt();
        if error.is_finite() { Attempt::Error(error) } else { Attempt::Error(1e30) }
    }

    /// Moves on by the accepted step, or to the first event within it.
    fn accept(
        &mut self,
        system: &mut impl System,
        (t, y): (&mut f64, &mut [f64]),
        (h, to): (f64, f64),
        observe: &mut impl FnMut(&Step) -> ControlFlow<()>,
    ) -> Option<Outcome> {
        let n = y.len();
        self.statistics.steps += 1;
        let stiff = self.measure_stiffness(h, n);
        let watched = system.events() > 0
            && !self.is_quiet(system, *t, to, y, h)
            && !(self.settings.glance && self.is_far(system, (*t, y), to, h));
        let dense =
            watched || self.settings.dense && self.settings.samples.is_none_or(|grid| grid.within(*t, to));
        if dense && let Some(outcome) = self.interpolate(system, *t, y, h) {
            return Some(outcome);
        }
        let interpolant = if dense { Interpolant::Nested(&self.coefficients) } else { Interpolant::None };
        let mut step = Step { from: *t, to, start: y, end: &self.next, length: h, interpolant };
        let crossing = if watched { self.sides.first_crossing(system, &step, &self.settings) } else { None };
        if let Some(crossing) = &crossing {
            self.statistics.events += 1;
            step.at(crossing.place, &mut self.trial);
            step.to = crossing.place;
            step.end = &self.trial;
        }
        let flow = observe(&step);
        *t = step.to;
        y.copy_from_slice(if crossing.is_some() { &self.trial } else { &self.next });
        self.stages.copy(12, 0);
        if let Some(crossing) = crossing {
            return Some(Outcome::Event { index: crossing.index, rising: crossing.rising });
        }
        if flow.is_break() {
            return Some(Outcome::Stopped);
        }
        stiff
    }

    /// Whether no event can lie within the step, by the largest slope of every component at its stages with a margin of two.
    fn is_quiet(&mut self, system: &impl System, from: f64, to: f64, y: &[f64], h: f64) -> bool {
        self.trial.fill(0.0);
        for stage in 0..13 {
            for (most, slope) in self.trial.iter_mut().zip(self.stages.row(stage)) {
                *most = most.max(slope.abs());
            }
        }
        self.trial.iter_mut().for_each(|most| *most *= 2.0 * h.abs());
        self.sides.are_known(system.events()) && system.is_quiet(from, to, y, &self.trial)
    }

    /// Whether every event function keeps well away from zero on the cubic between the ends of the step.
    fn is_far(&mut self, system: &mut impl System, (t, y): (f64, &[f64]), to: f64, h: f64) -> bool {
        let slopes = [self.stages.row(0), self.stages.row(12)];
        self.sides.are_far(system, [(t, y), (to, &self.next)], slopes, h)
    }

    /// Three more stages and the seven coefficients of the interpolant.
    fn interpolate(&mut self, system: &mut impl System, t: f64, y: &[f64], h: f64) -> Option<Outcome> {
        let n = y.len();
        for stage in 13..16 {
            self.stages.advance(&mut self.trial, y, h, A[stage]);
            let slope = self.stages.row_mut(stage);
            system.derivative(t + C[stage] * h, &self.trial, slope);
            self.statistics.evaluations += 1;
            if let Some(outcome) = infinite(slope) {
                return Some(outcome);
            }
        }
        let f = &mut self.coefficients;
        let (first, last) = (self.stages.row(0), self.stages.row(12));
        for i in 0..n {
            let rise = self.next[i] - y[i];
            f[i] = rise;
            f[n + i] = h * first[i] - rise;
            f[2 * n + i] = 2.0 * rise - h * (last[i] + first[i]);
        }
        for (row, weights) in D.iter().enumerate() {
            self.stages.combine(&mut f[(3 + row) * n..(4 + row) * n], h, weights);
        }
        None
    }

    /// Step times spectral radius, from the last two stages, which stand at the same place: fifteen steps near the
    /// border of stability without six others between them mean stiffness.
    fn measure_stiffness(&mut self, h: f64, n: usize) -> Option<Outcome> {
        if !self.settings.stiffness_test {
            return None;
        }
        let (mut slopes, mut states) = (0.0, 0.0);
        for i in 0..n {
            let scale = self.settings.scale(i, self.next[i].abs());
            slopes += ((self.stages.row(12)[i] - self.stages.row(11)[i]) / scale).powi(2);
            states += ((self.next[i] - self.trial[i]) / scale).powi(2);
        }
        let ratio = if states > 0.0 { h.abs() * (slopes / states).sqrt() } else { 0.0 };
        if ratio > STABLE {
            self.not_stiff = 0;
            self.stiff += 1;
        } else {
            self.not_stiff += 1;
            if self.not_stiff == 6 {
                self.stiff = 0;
            }
        }
        (self.stiff >= 15).then_some(Outcome::Stiff { step_times_rate: ratio })
    }
}
