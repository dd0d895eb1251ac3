//! Radau IIA with three stages: implicit, order 5, stiffly accurate, for stiff systems and those of index 1.
//!
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, sections IV.8 and VI.1. Newton's
//! iteration runs down to a thousandth of the tolerance or to rounding with the Jacobian of each step's start, so that the error follows the
//! tolerance. The solution between the ends is the collocation polynomial, of order 3 alone: put stops where samples must be as
//! good as steps.

use crate::control::{course, first_step, infinite, norm, together};
use crate::event::Sides;
use crate::radau_table::{C1, C2, ERROR, PAIR_IM, PAIR_RE, REAL, T, T_INVERSE};
use crate::step::{Interpolant, collocation_weights};
use crate::{ComplexLu, Lu, Outcome, Settings, Statistics, Step, System};
use num_complex::Complex64;
use std::ops::ControlFlow;

/// Newton iterations of a step before it is shortened.
const ITERATIONS: u32 = 12;
/// Remaining error of Newton's iteration against the tolerance of a step.
const REMAINING: f64 = 1e-3;
/// Where corrections stop shrinking below this against the tolerance, it is rounding.
const ROUNDING: f64 = 0.03;

/// The integrator. It keeps its step, the signs of events and its statistics from run to run.
#[derive(Debug, Clone)]
pub struct Radau5 {
    settings: Settings,
    inner: Settings,
    step: Option<f64>,
    sides: Sides,
    statistics: Statistics,
}

/// Work of one run.
struct Work {
    mass: Option<Vec<f64>>,
    slope: Vec<f64>,
    jacobian: Vec<f64>,
    /// Increments of the three stages, and the same in the transformed variables.
    z: Vec<f64>,
    w: Vec<f64>,
    /// Derivatives at the stages.
    f: Vec<f64>,
    state: Vec<f64>,
    next: Vec<f64>,
    real: Option<Lu<f64>>,
    pair: Option<ComplexLu>,
    /// Step of the increments in `z`, where they may be continued for a first guess.
    previous: Option<f64>,
}

/// Why a step was not made.
enum Failure {
    Singular,
    NotFinite(Outcome),
    Diverges,
}

impl Radau5 {
    /// An integrator with these settings.
    pub fn new(settings: Settings) -> Radau5 {
        // The estimate is of order 3, the step of order 5: the estimate is held to the power 2/3 of the tolerance.
        let mut inner = settings.clone();
        for (relative, absolute) in inner.relative.iter_mut().zip(&mut inner.absolute) {
            let held = 0.1 * relative.max(1e-14).powf(2.0 / 3.0);
            *absolute *= held / relative.max(1e-14);
            *relative = held;
        }
        Radau5 {
            step: settings.first_step,
            settings,
            inner,
            sides: Sides::default(),
            statistics: Statistics::default(),
        }
    }

    /// Cost of all runs so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Forgets step and signs of events: for a state that was set from outside.
    pub fn restart(&mut self) {
        self.step = self.settings.first_step;
        self.sides.forget();
    }

    /// Integrates from `t` to `end`, forwards or backwards, and shows each accepted step to `observe`. `t` and `y` hold
    /// the last good state, whatever the outcome. With a singular mass matrix the start must fulfil the algebraic equations.
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
        if let Some(outcome) = infinite(y) {
            return outcome;
        }
        let mut work = Work {
            mass: system.mass(),
            slope: vec![0.0; n],
            jacobian: vec![0.0; n * n],
            z: vec![0.0; 3 * n],
            w: vec![0.0; 3 * n],
            f: vec![0.0; 3 * n],
            state: vec![0.0; n],
            next: vec![0.0; n],
            real: None,
            pair: None,
            previous: None,
        };
        for stop in course(*t, end, &self.settings.stops) {
            if let Some(outcome) = self.reach(system, &mut work, (t, y), stop, &mut observe) {
                return outcome;
            }
        }
        Outcome::Reached
    }

    fn reach(
        &mut self,
        system: &mut impl System,
        work: &mut Work,
        (t, y): (&mut f64, &mut [f64]),
        stop: f64,
        observe: &mut impl FnMut(&Step) -> ControlFlow<()>,
    ) -> Option<Outcome> {
        if together(*t, stop) {
            *t = stop;
            return None;
        }
        let n = y.len();
        let sense = (stop - *t).signum();
        system.enter(*t, stop);
        self.slope(system, *t, y, &mut work.slope);
        if let Some(outcome) = infinite(&work.slope) {
            return Some(outcome);
        }
        let mut wanted = match self.step {
            Some(step) => step.abs(),
            None if work.mass.is_none() => {
                self.statistics.evaluations += 1;
                first_step(system, &self.settings, (*t, stop), y, &work.slope, 5.0).abs()
            }
            None => 1e-6 * (stop - *t).abs(),
        };
        let (mut rejected, mut fresh) = (false, false);
        let mut last_accepted: Option<(f64, f64)> = None;
        loop {
            if self.statistics.evaluations + 3 * u64::from(ITERATIONS) + n as u64
                > self.settings.most_evaluations
            {
                return Some(Outcome::TooManyEvaluations { limit: self.settings.most_evaluations });
            }
            if !fresh {
                self.jacobian(system, *t, y, work);
                fresh = true;
            }
            wanted = wanted.min(self.settings.longest_step);
            let left = (stop - *t).abs();
            let last = wanted * 1.01 >= left;
            let size = if last { left } else { wanted.min(0.5 * left.max(wanted)) };
            let h = sense * size;
            match self.attempt(system, work, *t, y, h) {
                Err(failure) => {
                    self.statistics.rejected += 1;
                    rejected = true;
                    wanted = size * if matches!(failure, Failure::Diverges) { 0.5 } else { 0.25 };
                    if together(*t, *t + sense * wanted) {
                        return Some(match failure {
                            Failure::Singular => Outcome::Singular,
                            Failure::NotFinite(outcome) => outcome,
                            Failure::Diverges => Outcome::StepTooSmall { step: sense * wanted },
                        });
                    }
                }
                Ok(iterations) => {
                    let error = self.error(system, work, *t, y, h, rejected || last_accepted.is_none());
                    let cautious =
                        0.9 * f64::from(2 * ITERATIONS + 1) / f64::from(2 * ITERATIONS + iterations);
                    let factor = (cautious * error.max(1e-30).powf(-0.25)).clamp(0.125, 5.0);
                    if error.is_nan() || error >= 1.0 {
                        self.statistics.rejected += 1;
                        rejected = true;
                        wanted = size * if error.is_nan() { 0.25 } else { factor.min(0.9) };
                        if together(*t, *t + sense * wanted) {
                            return Some(Outcome::StepTooSmall { step: sense * wanted });
                        }
                        continue;
                    }
                    let predicted = last_accepted.map_or(factor, |(before, its_error)| {
                        let trend = size / before * (its_error / (error * error).max(1e-30)).powf(0.25) * 0.9;
                        factor.min(trend.clamp(0.125, 5.0))
                    });
                    last_accepted = Some((size, error.max(1e-2)));
                    let proposed = size * if rejected { predicted.min(1.0) } else { predicted };
                    wanted = if last { proposed.max(wanted) } else { proposed };
                    self.step = Some(wanted);
                    (rejected, fresh) = (false, false);
                    let to = if last { stop } else { *t + h };
                    let ended = self.accept(system, work, (t, y), (h, to), observe);
                    if ended.is_some() || *t == stop {
                        return ended;
                    }
                    self.slope(system, *t, y, &mut work.slope);
                    if let Some(outcome) = infinite(&work.slope) {
                        return Some(outcome);
                    }
                }
            }
        }
    }

    fn slope(&mut self, system: &mut impl System, t: f64, y: &[f64], slope: &mut [f64]) {
        system.derivative(t, y, slope);
        self.statistics.evaluations += 1;
    }

    /// The Jacobian at the step's start: the system's own, or by forward differences.
    fn jacobian(&mut self, system: &mut impl System, t: f64, y: &[f64], work: &mut Work) {
        let n = y.len();
        self.statistics.jacobians += 1;
        work.jacobian.fill(0.0);
        if system.jacobian(t, y, &mut work.jacobian) {
            return;
        }
        work.state.copy_from_slice(y);
        let mut shifted = vec![0.0; n];
        for j in 0..n {
            let least = self.settings.absolute.get(j).copied().unwrap_or(1e-9).max(1e-300);
            let shift = (f64::EPSILON * y[j].abs().max(least)).sqrt().min(1e-5 * y[j].abs().max(1.0));
            work.state[j] = y[j] + shift;
            let shift = work.state[j] - y[j];
            self.slope(system, t, &work.state, &mut shifted);
            for i in 0..n {
                work.jacobian[i * n + j] = (shifted[i] - work.slope[i]) / shift;
            }
            work.state[j] = y[j];
        }
    }

    /// Newton's iteration for the three stages; the number of iterations.
    fn attempt(
        &mut self,
        system: &mut impl System,
        work: &mut Work,
        t: f64,
        y: &[f64],
        h: f64,
    ) -> Result<u32, Failure> {
        let n = y.len();
        self.factorise(work, n, h)?;
        guess(work, n, h);
        let (Some(real), Some(pair)) = (&work.real, &work.pair) else {
            return Err(Failure::Singular);
        };
        let (rate, pair_rate) = (REAL / h, Complex64::new(PAIR_RE, PAIR_IM) / h);
        let mut before = f64::INFINITY;
        let (mut right, mut right_pair) = (vec![0.0; n], vec![Complex64::default(); n]);
        let mut changes = vec![0.0; 3 * n];
        for iteration in 1..=ITERATIONS {
            for (stage, c) in [C1, C2, 1.0].into_iter().enumerate() {
                for i in 0..n {
                    work.state[i] = y[i] + work.z[stage * n + i];
                }
                let f = &mut work.f[stage * n..(stage + 1) * n];
                system.derivative(t + c * h, &work.state, f);
                self.statistics.evaluations += 1;
                if let Some(outcome) = infinite(f) {
                    return Err(Failure::NotFinite(outcome));
                }
            }
            self.statistics.iterations += 1;
            for i in 0..n {
                let a = |row: usize| -> f64 { (0..3).map(|k| T_INVERSE[row][k] * work.f[k * n + i]).sum() };
                let mw = [0, 1, 2].map(|k| times_mass(work.mass.as_deref(), &work.w[k * n..(k + 1) * n], i));
                right[i] = a(0) - rate * mw[0];
                right_pair[i] = Complex64::new(a(1), a(2)) - pair_rate * Complex64::new(mw[1], mw[2]);
            }
            real.solve(&mut right);
            pair.solve(&mut right_pair);
            for i in 0..n {
                let change = [right[i], right_pair[i].re, right_pair[i].im];
                for k in 0..3 {
                    work.w[k * n + i] += change[k];
                }
                for k in 0..3 {
                    changes[k * n + i] = (0..3).map(|m| T[k][m] * change[m]).sum();
                    work.z[k * n + i] = (0..3).map(|m| T[k][m] * work.w[m * n + i]).sum();
                }
            }
            let size = (0..3).map(|k| norm(&self.inner, &changes[k * n..(k + 1) * n], y)).fold(0.0, f64::max);
            if !size.is_finite() {
                return Err(Failure::Diverges);
            }
            let ratio = size / before;
            if size == 0.0
                || (iteration > 1 && ratio < 1.0 && size * ratio / (1.0 - ratio) <= REMAINING)
                || (iteration > 2 && ratio >= 0.5 && size <= ROUNDING)
            {
                return Ok(iteration);
            }
            let left = f64::from(ITERATIONS - iteration) as i32;
            if iteration > 2 && (ratio >= 1.0 || size * ratio.powi(left) / (1.0 - ratio) > ROUNDING) {
                return Err(Failure::Diverges);
            }
            before = size;
        }
        Err(Failure::Diverges)
    }

    fn factorise(&mut self, work: &mut Work, n: usize, h: f64) -> Result<(), Failure> {
        self.statistics.factorisations += 1;
        if work.jacobian.iter().any(|v| !v.is_finite()) {
            return Err(Failure::NotFinite(Outcome::NotFinite { component: 0 }));
        }
        let (rate, pair_rate) = (REAL / h, Complex64::new(PAIR_RE, PAIR_IM) / h);
        let mass = |k: usize| match &work.mass {
            Some(mass) => mass[k],
            None => f64::from(u8::from(k / n == k % n)),
        };
        let real = (0..n * n).map(|k| rate * mass(k) - work.jacobian[k]).collect();
        let pair = (0..n * n).map(|k| pair_rate * mass(k) - work.jacobian[k]).collect();
        let singular = |_| Failure::Singular;
        work.real = Some(Lu::new(n, real).map_err(singular)?);
        work.pair = Some(Lu::new(n, pair).map_err(singular)?);
        Ok(())
    }

    /// Error of the step over its tolerance.
    fn error(
        &mut self,
        system: &mut impl System,
        work: &mut Work,
        t: f64,
        y: &[f64],
        h: f64,
        again: bool,
    ) -> f64 {
        let n = y.len();
        for i in 0..n {
            work.state[i] = (0..3).map(|k| ERROR[k] / h * work.z[k * n + i]).sum();
            work.next[i] = y[i] + work.z[2 * n + i];
        }
        let increments: Vec<f64> = (0..n).map(|i| times_mass(work.mass.as_deref(), &work.state, i)).collect();
        let Some(real) = &work.real else { return f64::NAN };
        let mut estimate: Vec<f64> = increments.iter().zip(&work.slope).map(|(a, f)| a + f).collect();
        real.solve(&mut estimate);
        let mut error = norm(&self.inner, &estimate, y);
        if error >= 1.0 && again {
            let mut shifted: Vec<f64> = y.iter().zip(&estimate).map(|(y, e)| y + e).collect();
            system.derivative(t, &shifted, &mut work.state);
            self.statistics.evaluations += 1;
            for i in 0..n {
                shifted[i] = increments[i] + work.state[i];
            }
            real.solve(&mut shifted);
            error = norm(&self.inner, &shifted, y);
        }
        error.max(1e-10)
    }

    fn accept(
        &mut self,
        system: &mut impl System,
        work: &mut Work,
        (t, y): (&mut f64, &mut [f64]),
        (h, to): (f64, f64),
        observe: &mut impl FnMut(&Step) -> ControlFlow<()>,
    ) -> Option<Outcome> {
        self.statistics.steps += 1;
        let interpolant = Interpolant::Collocation(&work.z);
        let mut step = Step { from: *t, to, start: y, end: &work.next, length: h, interpolant };
        let crossing = self.sides.first_crossing(system, &step, &self.settings);
        if let Some(crossing) = &crossing {
            self.statistics.events += 1;
            step.at(crossing.place, &mut work.state);
            step.to = crossing.place;
            step.end = &work.state;
        }
        let flow = observe(&step);
        *t = step.to;
        y.copy_from_slice(if crossing.is_some() { &work.state } else { &work.next });
        work.previous = Some(h);
        if let Some(crossing) = crossing {
            return Some(Outcome::Event { index: crossing.index, rising: crossing.rising });
        }
        flow.is_break().then_some(Outcome::Stopped)
    }
}

/// First guess of the stages: the last step's polynomial continued, or nothing.
fn guess(work: &mut Work, n: usize, h: f64) {
    match work.previous.take() {
        Some(before) => {
            let last = work.z.clone();
            for (stage, c) in [C1, C2, 1.0].into_iter().enumerate() {
                let weights = collocation_weights(1.0 + c * h / before);
                for i in 0..n {
                    let there: f64 = (0..3).map(|k| weights[k] * last[k * n + i]).sum();
                    work.z[stage * n + i] = there - last[2 * n + i];
                }
            }
        }
        None => work.z.fill(0.0),
    }
    for i in 0..n {
        for k in 0..3 {
            work.w[k * n + i] = (0..3).map(|m| T_INVERSE[k][m] * work.z[m * n + i]).sum();
        }
    }
}

/// Row `i` of the mass matrix times a vector.
fn times_mass(mass: Option<&[f64]>, vector: &[f64], i: usize) -> f64 {
    match mass {
        Some(mass) => {
            let n = vector.len();
            mass[i * n..(i + 1) * n].iter().zip(vector).map(|(m, v)| m * v).sum()
        }
        None => vector[i],
    }
}
