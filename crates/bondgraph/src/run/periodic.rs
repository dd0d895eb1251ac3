//! The periodic motion: Newton on the map of one period.
//!
//! ```text
//! G(x) = state after one period from x, less x;       G = 0       multipliers: eigenvalues of dG/dx + 1
//! ```
//! A period is a time, or lasts until one state has advanced by so much; then the time is found with the motion. What is conserved (the charge of a
//! closed circuit), or has no preferred value (the speed under a constant load), leaves `dG/dx` singular: among all solutions the step takes the
//! one that keeps what is conserved, else the smallest.

use crate::equations::Equations;
use crate::expression::Var;
use crate::graph::{Graph, Period, Rule};
use crate::run::compiled::Compiled;
use crate::run::motion::{PeriodicEnd, PeriodicMotion};
use crate::run::returning::Returning;
use crate::run::simulate::{Method, Pass, Simulation, SimulationRequest, Sizes, looks};
use lanchester_numerics::System;
use nalgebra::{DMatrix, DVector, Schur};

/// Newton's iterations.
const ITERATIONS: usize = 30;

/// What counts as closed: change over one period over the size of each state.
const CLOSED: f64 = 1e-10;

/// What still counts as closed where iterations no longer help: kinks within steps leave the map with noise.
const NEARLY: f64 = 1e-8;

/// Iterations without half the best residual so far after which none helps any more.
const IDLE: usize = 3;

/// Share of the residual before below which the derivative that gave the step is kept.
const HELPS: f64 = 0.05;

/// Step of the differences, as a share of the size of each state: the errors of the map weigh by its inverse, third derivatives by its
/// square.
const SHARE: f64 = 1e-4;

/// A multiplier closer to 1 than this prefers no value.
const NEUTRAL: f64 = 1e-6;

/// A step that keeps what is conserved and is larger than so many times the smallest is not taken: nothing is conserved along it.
const MOST_KEPT: f64 = 1e3;

/// Tolerance of the map at most, and of an implicit method, which is of lower order.
const MAP: [f64; 2] = [1e-12, 1e-10];

/// Tolerance of the map where its errors keep the residual above what counts as closed: at a reversal of the flow through a valve the rate goes as the
/// root of a pressure difference, and steps across it miss their tolerance by far.
const FINEST: f64 = 3e-14;

/// A residual below this that a step no longer reduces is taken as noise of the map.
const NOISY: f64 = 1e-6;

/// A period lasts at most so many times what the rate at the start would take.
const LONGEST: f64 = 20.0;

/// A return is looked for over so many times the fastest state's own time.
const HORIZON: f64 = 1e4;

/// What one period from a start leads to.
struct Arrival {
    state: Vec<f64>,
    time: f64,
}

/// The map of one period.
struct Search<'a> {
    equations: &'a Equations,
    compiled: Compiled,
    request: SimulationRequest,
    /// The state whose advance ends the period, and by how much it advances.
    section: Option<usize>,
    by: f64,
    /// Evaluations that are left.
    left: u64,
    absolute: Vec<f64>,
}

/// Place of a variable among the states.
fn state_of(equations: &Equations, var: Var) -> Option<usize> {
    let graph: &Graph = &equations.graph;
    let symbol = match var {
        Var::Signal(signal) => graph.signals[signal as usize].name.clone(),
        Var::Momentum(bond) => format!("{}.momentum", graph.bond_name(bond as usize)),
        Var::Displacement(bond) => format!("{}.displacement", graph.bond_name(bond as usize)),
        _ => return None,
    };
    equations.states.iter().position(|state| state.symbol == symbol)
}

impl Equations {
    /// The periodic motion next to the start, one period of it with the samples of `request`; its duration does not count. Where there is none the
    /// run is a period of the last trial, and `periodic` says what happened.
    pub fn periodic(&self, period: Period, request: &SimulationRequest) -> Simulation {
        let mut tolerance = request.tolerance;
        let (found, start) = match period.of.map(|var| state_of(self, var)) {
            Some(None) => {
                let instead = "what the period counts follows others and is no state".to_owned();
                (PeriodicMotion::not_found(0.0, instead), None)
            }
            Some(Some(section)) => self.search(Some(section), period.advance, request, &mut tolerance),
            None => self.search(None, period.advance, request, &mut tolerance),
        };
        let mut at = self.clone();
        if let Some(start) = start {
            at.states.iter_mut().zip(start).for_each(|(state, value)| state.start = value);
        }
        let duration = if found.period > 0.0 { found.period } else { request.duration };
        let mut run = at.simulate(&SimulationRequest { duration, tolerance, periodic: None, ..*request });
        if found.instead.is_none() {
            run.ended = format!("one period of {duration} s");
        } else {
            run.complete = false;
            run.ended =
                "no periodic motion was found: the run is the last trial, which does not close".into();
        }
        run.periodic = Some(found);
        run
    }

    fn search(
        &self,
        section: Option<usize>,
        by: f64,
        request: &SimulationRequest,
        tolerance: &mut f64,
    ) -> (PeriodicMotion, Option<Vec<f64>>) {
        let start: Vec<f64> = self.states.iter().map(|state| state.start).collect();
        // A copy of the equations that ends where the state has advanced.
        let mut ended = self.clone();
        let mut horizon = by;
        if let Some(section) = section {
            let mut compiled = Compiled::new(self, false);
            let mut rates = vec![0.0; start.len()];
            compiled.settle(0.0, &start);
            compiled.derivative(0.0, &start, &mut rates);
            let rate = rates[section];
            let symbol = &self.states[section].symbol;
            if rate == 0.0 || !rate.is_finite() || rate * by < 0.0 {
                let instead = if by == 0.0 {
                    format!("{symbol} does not move at the start: give it a start from which it moves")
                } else {
                    format!("{symbol} does not advance at the start: its rate is {rate:.6e}")
                };
                return (PeriodicMotion::not_found(0.0, instead), None);
            }
            let pool = &mut ended.graph.pool;
            let (state, target) = (pool.var(Var::State(section as u32)), pool.constant(start[section] + by));
            let advance = pool.difference(state, target);
            let when = if rate > 0.0 { advance } else { pool.negative(advance) };
            ended.rules.push((when, Vec::new()));
            ended.graph.rules.push(Rule { when, set: Vec::new(), stop: true, span: 0..0 });
            horizon = if by == 0.0 {
                let own = |(y, rate): (&f64, &f64)| y.abs() / rate.abs();
                let times = start.iter().zip(&rates).map(own).filter(|time| *time > 0.0 && time.is_finite());
                let fastest = times.fold(f64::INFINITY, f64::min);
                HORIZON * if fastest.is_finite() { fastest } else { 1.0 }
            } else {
                LONGEST * by / rate
            };
        }
        let mut search = Search {
            equations: &ended,
            compiled: Compiled::new(&ended, false),
            request: SimulationRequest {
                duration: horizon,
                samples: 1,
                audit: false,
                periodic: None,
                ..*request
            },
            section,
            by,
            left: request.most_evaluations,
            absolute: Vec::new(),
        };
        let found = search.newton(start);
        *tolerance = search.request.tolerance;
        found
    }
}

impl Search<'_> {
    /// One period from a start, or why it does not come to its end.
    fn arrive(&mut self, start: &[f64]) -> Result<Arrival, (f64, String)> {
        let request = SimulationRequest { most_evaluations: self.left, ..self.request };
        let absolute = std::mem::take(&mut self.absolute);
        let pass = self.equations.pass(&mut self.compiled, &request, &[request.duration], &absolute, start);
        self.absolute = absolute;
        self.left = self.left.saturating_sub(pass.statistics.evaluations);
        self.of_pass(pass, start)
    }

    fn of_pass(&mut self, pass: Pass, start: &[f64]) -> Result<Arrival, (f64, String)> {
        let (time, mut state) = pass.end;
        if !pass.complete {
            return Err((time, pass.ended));
        }
        let Some(section) = self.section else { return Ok(Arrival { state, time }) };
        let target = start[section] + self.by;
        let symbol = &self.equations.states[section].symbol;
        if time >= self.request.duration {
            let gone = state[section] - start[section];
            let unit = &self.equations.states[section].unit_name;
            let instead = if self.by == 0.0 {
                format!("{symbol} does not come back to where it started within {time:.6e} s")
            } else {
                format!("{symbol} advances by {gone:.6e} {unit} in {time:.6e} s and not by {:.6e}", self.by)
            };
            return Err((time, instead));
        }
        let mut rates = vec![0.0; state.len()];
        self.compiled.derivative(time, &state, &mut rates);
        // The event lies on the interpolant, the state beside it.
        let late = (target - state[section]) / rates[section];
        let size = 1e-6 * time;
        if late.is_nan() || late.abs() > size {
            return Err((time, format!("an event stops the run at {time} s, before the period ends")));
        }
        state.iter_mut().zip(&rates).for_each(|(value, rate)| *value += late * rate);
        state[section] = target;
        Ok(Arrival { state, time: time + late })
    }

    /// Sizes of all states over a first period, roughly.
    fn measure(&mut self, start: &[f64]) -> Result<(Sizes, Arrival), (f64, String)> {
        let tolerance = 1e-6f64.max(self.request.tolerance);
        let request = SimulationRequest { tolerance, most_evaluations: self.left, ..self.request };
        let small = vec![1e-12; start.len()];
        let pass = self.equations.pass(&mut self.compiled, &request, &looks(request.duration), &small, start);
        self.left = self.left.saturating_sub(pass.statistics.evaluations);
        let mut sizes = self.equations.sizes_of(&mut self.compiled, &pass);
        sizes.largest.iter_mut().for_each(|size| *size = if *size > 0.0 { *size } else { 1.0 });
        let implicit = pass.methods.last() == Some(&Method::Implicit);
        if implicit {
            self.request.method = Some(Method::Implicit);
        }
        self.tolerate(if implicit { MAP[1] } else { self.request.tolerance.min(MAP[0]) }, &sizes);
        Ok((sizes, self.of_pass(pass, start)?))
    }

    /// A finer map, where there is one.
    fn refine(&mut self, sizes: &Sizes) -> bool {
        let is_finer = self.request.tolerance > FINEST && self.request.method != Some(Method::Implicit);
        if is_finer {
            self.tolerate(FINEST, sizes);
        }
        is_finer
    }

    fn tolerate(&mut self, tolerance: f64, sizes: &Sizes) {
        self.request.tolerance = tolerance;
        self.absolute = sizes.absolute(tolerance);
    }

    fn returning(&mut self, at: &[f64], sizes: &[f64], period: f64, kept: &[usize]) -> Returning {
        let section = (self.section, self.by);
        Returning::new(self.equations, &mut self.compiled, at, sizes, section, period, kept)
    }

    fn newton(&mut self, mut start: Vec<f64>) -> (PeriodicMotion, Option<Vec<f64>>) {
        let (sizes, first) = match self.measure(&start) {
            Ok(found) => found,
            Err((time, instead)) => return (PeriodicMotion::not_found(time, instead), None),
        };
        // What events alone set takes their values; what they leave in a second period keeps its own.
        let pool = &self.equations.graph.pool;
        let set: Vec<usize> =
            (0..start.len()).filter(|index| pool.is_zero(self.equations.states[*index].rate)).collect();
        set.iter().for_each(|index| start[*index] = first.state[*index]);
        let second = match self.arrive(&start) {
            Ok(found) => found,
            Err((time, instead)) => return (PeriodicMotion::not_found(time, instead), Some(start)),
        };
        let kept: Vec<usize> =
            set.into_iter().filter(|index| second.state[*index] == start[*index]).collect();
        let returning = self.returning(&start, &sizes.largest, second.time, &kept);
        let mut found = PeriodicMotion::not_found(second.time, String::new());
        let (mut x, mut arrival) = (start, second);
        let mut slope: Option<DMatrix<f64>> = None;
        let (mut last, mut idle) = (f64::INFINITY, 0);
        let mut best: Option<(f64, Vec<f64>, Arrival)> = None;
        let mut instead = String::new();
        loop {
            let change = returning.change(&x, &arrival.state);
            let off = if change.is_empty() { 0.0 } else { change.amax() };
            idle = if best.as_ref().is_none_or(|(least, _, _)| off < 0.5 * least) { 0 } else { idle + 1 };
            if best.as_ref().is_none_or(|(least, _, _)| off < *least) {
                let kept = Arrival { state: arrival.state.clone(), time: arrival.time };
                best = Some((off, x.clone(), kept));
            }
            if off < CLOSED || (idle >= IDLE && best.as_ref().is_some_and(|(least, _, _)| *least < NEARLY)) {
                break;
            }
            if found.iterations >= ITERATIONS {
                instead =
                    self.stays(&returning, &change, &sizes.largest, "Newton's iterations do not close it");
                break;
            }
            let helps = off < HELPS * last;
            if !helps && (NEARLY..NOISY).contains(&off) && self.refine(&sizes) {
                // Residuals of the coarser map do not count.
                if let Some((_, least, _)) = best.take() {
                    x = least;
                }
                match self.arrive(&x) {
                    Ok(there) => arrival = there,
                    Err((_, why)) => {
                        instead = why;
                        break;
                    }
                }
                last = f64::INFINITY;
                continue;
            }
            // At the noise another derivative does not help either.
            if slope.is_none() || (!helps && (off >= NEARLY || idle == 0)) {
                slope = match self.slope(&returning, &x, Some(&change)) {
                    Ok(slope) => Some(slope),
                    Err(why) => {
                        instead = why;
                        break;
                    }
                };
            }
            last = off;
            let Some(step) = slope.as_ref().and_then(|slope| step(slope, &change)) else { break };
            if step.amax() < 1e-3 * off {
                let why = "no other start changes that: what drives and what brakes are not in balance";
                instead = self.stays(&returning, &change, &sizes.largest, why);
                break;
            }
            let Some(next) = returning.moved(&mut self.compiled, &x, &step) else {
                instead = "the step leads to a start that the graph does not allow".into();
                break;
            };
            match self.arrive(&next) {
                Ok(there) => arrival = there,
                Err((_, why)) => {
                    instead = why;
                    break;
                }
            }
            x = next;
            found.iterations += 1;
        }
        let Some((residual, x, arrival)) = best else { return (found, Some(x)) };
        (found.residual, found.period) = (residual, arrival.time);
        if residual >= NEARLY {
            let change = returning.change(&x, &arrival.state);
            if instead.is_empty() {
                instead = self.stays(&returning, &change, &sizes.largest, "Newton's step is none");
            }
            found.multipliers = slope.as_ref().map_or_else(Vec::new, multipliers);
            found.instead = Some(instead);
            return (found, Some(x));
        }
        // Components that are measured at the motion itself: there a move and its change are the same.
        let returning = self.returning(&x, &sizes.largest, arrival.time, &kept);
        let own = self.slope(&returning, &x, None).ok().or(slope);
        found.multipliers = own.as_ref().map_or_else(Vec::new, multipliers);
        let largest = found.multipliers.first().map_or(0.0, |m| m[0].hypot(m[1]));
        // What the noise of the map does to its differences.
        let neutral = NEUTRAL.max(residual / SHARE);
        found.outcome = match largest {
            largest if largest > 1.0 + neutral => PeriodicEnd::Unstable,
            largest if largest > 1.0 - neutral => PeriodicEnd::Neutral,
            _ => PeriodicEnd::Stable,
        };
        found.instead = None;
        (found, Some(x))
    }

    /// `dG/dx` by differences to one side of the change at `x`, or to both sides without it.
    fn slope(
        &mut self,
        returning: &Returning,
        x: &[f64],
        change: Option<&DVector<f64>>,
    ) -> Result<DMatrix<f64>, String> {
        let count = returning.count();
        let mut matrix = DMatrix::zeros(count, count);
        for column in 0..count {
            let mut beside = |side: f64| -> Result<DVector<f64>, String> {
                let mut by = DVector::zeros(count);
                by[column] = side * SHARE;
                let start = returning
                    .moved(&mut self.compiled, x, &by)
                    .ok_or_else(|| "a start beside it is not allowed by the graph".to_owned())?;
                let arrival = self.arrive(&start).map_err(|(_, why)| why)?;
                Ok(returning.change(&start, &arrival.state))
            };
            let above = beside(1.0)?;
            let slope = match change {
                Some(change) => (above - change) / SHARE,
                None => (above - beside(-1.0)?) / (2.0 * SHARE),
            };
            matrix.set_column(column, &slope);
        }
        Ok(matrix)
    }

    /// Which state changes most over a period, in words.
    fn stays(&self, returning: &Returning, change: &DVector<f64>, sizes: &[f64], why: &str) -> String {
        if change.is_empty() {
            return why.to_owned();
        }
        let component = change.iamax();
        let index = returning.state_of(component);
        let state = &self.equations.states[index];
        let way = if change[component] > 0.0 { "grows" } else { "falls" };
        let amount = change[component].abs() * sizes[index];
        if returning.own.contains(&index) {
            format!("{} {way} by {amount:.6e} {} over a period, and {why}", state.symbol, state.unit_name)
        } else {
            format!("a place that {} moves does not return after a period, and {why}", state.symbol)
        }
    }
}

/// Newton's step; where the slope is singular it keeps what is conserved, else it is the smallest.
fn step(slope: &DMatrix<f64>, change: &DVector<f64>) -> Option<DVector<f64>> {
    let count = change.len();
    // Beside a matrix of two or three rows `nalgebra` has forms of its own, whose left vectors of small values are noise.
    let size = count + 3;
    let mut padded = DMatrix::identity(size, size);
    padded.view_mut((0, 0), (count, count)).copy_from(slope);
    let mut right_side = DVector::zeros(size);
    right_side.rows_mut(0, count).copy_from(&-change);
    let parts = padded.try_svd(true, true, f64::EPSILON, 10_000)?;
    let smallest = parts.solve(&right_side, NEUTRAL).ok()?;
    let (u, v) = (parts.u.as_ref()?, parts.v_t.as_ref()?);
    let values = &parts.singular_values;
    let null: Vec<usize> = (0..size).filter(|k| values[*k] <= NEUTRAL).collect();
    if null.is_empty() {
        return Some(smallest.rows(0, count).into_owned());
    }
    let left = DMatrix::from_fn(size, null.len(), |i, k| u[(i, null[k])]);
    let right = DMatrix::from_fn(size, null.len(), |i, k| v[(null[k], i)]);
    let lost = (left.transpose() * &right).lu().solve(&(left.transpose() * &smallest));
    let step = match lost {
        Some(lost) if lost.amax() < MOST_KEPT * smallest.amax() => smallest - right * lost,
        _ => smallest,
    };
    Some(step.rows(0, count).into_owned())
}

/// Eigenvalues of the map's derivative by falling size.
fn multipliers(slope: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let map = slope + DMatrix::identity(slope.nrows(), slope.ncols());
    if map.is_empty() {
        return Vec::new();
    }
    let Some(schur) = Schur::try_new(map, f64::EPSILON, 10_000) else { return Vec::new() };
    let mut all: Vec<[f64; 2]> =
        schur.complex_eigenvalues().iter().map(|value| [value.re, value.im]).collect();
    all.sort_by(|a, b| b[0].hypot(b[1]).total_cmp(&a[0].hypot(a[1])));
    all
}
