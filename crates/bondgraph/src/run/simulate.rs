//! Simulation: the equations integrated, events located, energy through every bond audited.

use crate::equations::Equations;
use crate::graph::{Kind, Period};
use crate::run::audit::{Audit, Jump, Place, audit};
use crate::run::compiled::Compiled;
use crate::run::motion::PeriodicMotion;
use crate::run::seconds::seconds;
use lanchester_numerics::{Dop853, Outcome, Radau5, SampleGrid, Settings, Statistics, Step, System};
use lanchester_results::{Series, values_of};
use serde::Serialize;
use std::collections::HashMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

/// More events than these at places that cannot be told apart mean that a condition switches to and fro.
const CHATTER: u32 = 200;

/// So many times in a row at places that cannot be told apart mean that an event comes ever faster.
const EVER_FASTER: u32 = 3;

/// So many steps that come no further than a billionth of the duration, and do not double the time, come nowhere.
const STANDSTILL: u32 = 5000;

/// Runs that may take so many evaluations are long: they look ahead on the way.
const LONG: u64 = 10_000_000;
/// Evaluations of an explicit step.
const PER_STEP: u64 = 12;
/// Share of the evaluations that a run may take after which it looks ahead, and what a run that goes on may need, in the same unit.
const LOOK_AHEAD: [u64; 2] = [20, 2];

/// Tolerances below this are met at samples by steps that end there: the interpolant would be less accurate than the steps.
const FINE: f64 = 1e-9;

/// Tolerances below this reach a kink or event by steps of their own: the interpolant would be less accurate.
const STEP_AGAIN: f64 = 3e-8;

/// Evaluations of the pass that measures sizes.
const ROUGH: u64 = 6000;
/// Its tolerance, where that of the run is no coarser.
const ROUGH_TOLERANCE: f64 = 1e-5;

/// What stays below this share of the largest of its unit is rounding: what symmetry keeps at zero, say.
const ROUNDING: f64 = 1e-12;

/// Places at which a rough pass measures what rounding does to the rates.
const LOOKS: usize = 24;

/// A smaller change at an event is no jump, as a share.
const LEAP: f64 = 1e-9;

/// How a simulation is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimulationRequest {
    /// Duration [s].
    pub duration: f64,
    /// The period of a periodic motion that is looked for; one period of it is then shown, and the duration does not count.
    pub periodic: Option<Period>,
    /// Samples over it, beside the start.
    pub samples: usize,
    /// Relative tolerance of every step.
    pub tolerance: f64,
    /// Whether the energy through every bond is integrated beside the states.
    pub audit: bool,
    /// The method; chosen by measured stiffness where absent.
    pub method: Option<Method>,
    /// Largest number of evaluations; of a periodic motion those of the whole search.
    pub most_evaluations: u64,
    /// What may end it from outside.
    pub cancel: Option<Cancel>,
}

/// A flag that ends a run after the step at hand, with the samples so far, as soon as it is set.
#[derive(Debug, Clone, Copy)]
pub struct Cancel(pub &'static AtomicBool);

impl Cancel {
    fn is_set(self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl PartialEq for Cancel {
    /// Whether it is the same flag.
    fn eq(&self, other: &Cancel) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

/// A method of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "GraphMethod")]
pub enum Method {
    /// DOP853, order 8.
    Explicit,
    /// Radau IIA, order 5.
    Implicit,
}

/// A simulation: what was computed, what happened, what it cost.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "GraphRun")]
pub struct Simulation {
    /// Version of this structure.
    pub version: u32,
    /// Name of the graph.
    pub graph: String,
    /// Whether the whole duration was covered; otherwise the samples so far are good.
    pub complete: bool,
    /// Why it ended, in words.
    pub ended: String,
    /// Methods that ran, in their order.
    pub methods: Vec<Method>,
    /// Time at which stiffness made the method implicit [s].
    pub stiff_from: Option<f64>,
    /// Relative tolerance.
    pub tolerance: f64,
    /// Times of the samples [s].
    pub time: Vec<f64>,
    /// States, then effort, flow and power of every bond, then what each junction shares, then signals, at the samples.
    pub series: Vec<Series>,
    /// Evaluations that the whole duration would need, as far as the run came: where it ended for their number.
    pub evaluations_needed: Option<f64>,
    /// Switches of conditions.
    pub events: Vec<Event>,
    /// Energy through every bond.
    pub audit: Option<Audit>,
    /// Cost, of all methods together.
    pub statistics: Statistics,
    /// Operations of one evaluation.
    pub operations: usize,
    /// The periodic motion that was looked for.
    pub periodic: Option<PeriodicMotion>,
}

/// A condition that switched.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "GraphEvent")]
pub struct Event {
    /// When [s].
    pub time: f64,
    /// Which condition, by its place among those of the graph.
    pub condition: usize,
    /// That condition as the graph writes it: `pipe.effort > 0`; of dry friction that sticks `crank.flow sticks`.
    pub expression: String,
    /// Whether it became true.
    pub on: bool,
}

/// What one pass gives.
pub(crate) struct Pass {
    pub(crate) samples: Vec<(f64, Vec<f64>)>,
    pub(crate) variables: Vec<Vec<f64>>,
    /// Largest size of each state.
    pub(crate) largest: Vec<f64>,
    /// Time and state at its end.
    pub(crate) end: (f64, Vec<f64>),
    /// Why it ended, in words.
    pub(crate) ended: String,
    /// Whether it came to its end.
    pub(crate) complete: bool,
    /// Methods that ran.
    pub(crate) methods: Vec<Method>,
    stiff_from: Option<f64>,
    evaluations_needed: Option<f64>,
    events: Vec<Event>,
    /// Of an audited run: events that set states.
    jumps: Vec<Jump>,
    /// Its cost.
    pub(crate) statistics: Statistics,
}

/// How large states become, and what rounding does to them.
pub(crate) struct Sizes {
    /// Largest size of each state.
    pub largest: Vec<f64>,
    /// What rounding of all states makes of each over one step.
    noise: Vec<f64>,
}

impl Sizes {
    /// Absolute tolerances: a share of the size, and no less than rounding leaves, below which steps would follow noise: forces that cancel move what symmetry
    /// hardly moves.
    pub fn absolute(&self, tolerance: f64) -> Vec<f64> {
        let own = self.largest.iter().zip(&self.noise);
        own.map(|(size, noise)| (0.01 * tolerance * size).max(*noise).max(1e-200)).collect()
    }
}

impl Compiled {
    /// That a condition switched, or began or ended to stick.
    fn event(&self, time: f64, condition: usize, sticks: bool, on: bool) -> Event {
        let written = &self.conditions[condition];
        let expression = match written.strip_suffix(" > 0") {
            Some(function) if sticks => format!("{function} sticks"),
            _ => written.clone(),
        };
        Event { time, condition, expression, on }
    }
}

impl Simulation {
    /// Values of a quantity at the samples: `crank.flow`, `block_x.momentum`.
    pub fn values(&self, name: &str) -> Option<&[f64]> {
        values_of(&self.series, name)
    }
}

impl Equations {
    /// What the graph's file asks for.
    pub fn request(&self) -> SimulationRequest {
        let asked = self.graph.simulation;
        SimulationRequest {
            duration: asked.duration,
            periodic: asked.period.filter(|_| asked.periodic),
            samples: asked.samples,
            tolerance: asked.tolerance,
            audit: false,
            method: None,
            most_evaluations: 10_000_000,
            cancel: None,
        }
    }

    /// The period of its periodic motion, where the graph says it.
    pub fn period(&self) -> Option<Period> {
        self.graph.simulation.period
    }

    /// Simulates. Every way in which a run can end is said in the result.
    pub fn simulate(&self, request: &SimulationRequest) -> Simulation {
        if let Some(period) = request.periodic {
            return self.periodic(period, request);
        }
        let samples = request.samples;
        // The last is the end itself: rounding must not put it behind.
        let place = |k: usize| request.duration * if k == samples { 1.0 } else { k as f64 / samples as f64 };
        let places: Vec<f64> = (1..=samples).map(place).collect();
        self.simulate_at(request, &places)
    }

    /// A run over the duration with samples at `places` [s], which rise from above 0; those behind the duration are not reached.
    pub fn simulate_at(&self, request: &SimulationRequest, places: &[f64]) -> Simulation {
        let mut compiled = Compiled::new(self, request.audit);
        let start: Vec<f64> = self.states.iter().map(|state| state.start).collect();
        let dimension = self.states.len() + if request.audit { self.graph.bonds.len() } else { 0 };
        // A rough pass measures how large each quantity becomes: absolute tolerances are shares of that. Its beginning is enough where
        // every state has moved by then: a size that is still small there makes the tolerance finer, never coarser. Energies are not
        // taken that way: what a closed valve carries is nothing for long.
        let coarse = ROUGH_TOLERANCE.max(request.tolerance);
        let rough = |compiled: &mut Compiled, most_evaluations: u64| -> (Pass, Sizes) {
            let rough = SimulationRequest { tolerance: coarse, most_evaluations, ..*request };
            let pass = self.pass(compiled, &rough, &looks(request.duration), &vec![1e-12; dimension], &start);
            let sizes = self.sizes_of(compiled, &pass);
            (pass, sizes)
        };
        let is_cancelled = || request.cancel.is_some_and(Cancel::is_set);
        let most = request.most_evaluations;
        let is_too_long = |pass: &Pass| pass.evaluations_needed.is_some();
        let beginning = if request.audit { most } else { most.min(ROUGH) };
        let (mut first, mut found) = rough(&mut compiled, beginning);
        if !first.complete && beginning < most && found.largest.contains(&0.0) && !is_cancelled() {
            (first, found) = rough(&mut compiled, most);
        }
        let (mut pass, tolerance) = if is_cancelled() {
            // What there is: its own few samples.
            first.complete = false;
            first.ended = format!(
                "cancelled at {} s of a first pass, which measures the sizes of the states: its samples, to a tolerance of {coarse:e}",
                first.end.0
            );
            (first, coarse)
        } else {
            compiled.looks_ahead = most >= LONG;
            let mut pass =
                self.pass(&mut compiled, request, places, &found.absolute(request.tolerance), &start);
            if !pass.complete && !first.complete && beginning < most && !is_cancelled() && !is_too_long(&pass)
            {
                let (_, found) = rough(&mut compiled, most);
                pass = self.pass(&mut compiled, request, places, &found.absolute(request.tolerance), &start);
            }
            (pass, request.tolerance)
        };
        self.end_where_not_finite(&mut compiled, &mut pass);
        let time: Vec<f64> = pass.samples.iter().map(|(t, _)| *t).collect();
        let series = self.series(&pass);
        let audit =
            request.audit.then(|| audit(self, &pass.samples, &pass.variables, &pass.jumps, &pass.end.1));
        Simulation {
            version: 1,
            graph: self.graph.name.clone(),
            complete: pass.complete,
            ended: pass.ended,
            methods: pass.methods,
            stiff_from: pass.stiff_from,
            evaluations_needed: pass.evaluations_needed,
            tolerance,
            time,
            series,
            events: pass.events,
            audit,
            statistics: pass.statistics,
            operations: compiled.operations(),
            periodic: None,
        }
    }

    /// Sizes of all states of a rough pass with some samples.
    pub(crate) fn sizes_of(&self, compiled: &mut Compiled, pass: &Pass) -> Sizes {
        let mut largest = pass.largest.clone();
        let of_unit = self.measure_rounding(&mut largest);
        // Every state is known to its last digit and no better: what that does to the rates no step can be rid of.
        let (mut rates, mut beside) = (vec![0.0; largest.len()], vec![0.0; largest.len()]);
        let mut noise = vec![0.0f64; largest.len()];
        for (look, (t, state)) in pass.samples.iter().enumerate() {
            compiled.settle(*t, state);
            compiled.derivative(*t, state, &mut rates);
            let rounded: Vec<f64> =
                state
                    .iter()
                    .enumerate()
                    .map(|(k, y)| {
                        if (look + k) % 2 == 0 { y * (1.0 + f64::EPSILON) } else { y * (1.0 - f64::EPSILON) }
                    })
                    .collect();
            compiled.derivative(*t, &rounded, &mut beside);
            for (most, (a, b)) in noise.iter_mut().zip(rates.iter().zip(&beside)) {
                *most = most.max((a - b).abs());
            }
        }
        let step = pass.end.0 / pass.statistics.steps.max(1) as f64;
        // No more than what counts as rounding at all: a rate that is very steep somewhere must not make the whole run coarse.
        noise.iter_mut().zip(of_unit).for_each(|(own, most)| *own = (*own * step).min(ROUNDING * most));
        Sizes { largest, noise }
    }

    /// Gives what is nothing but rounding the size of the largest of its unit: a share of its own size would make steps follow noise.
    /// Audited energies stand behind the states. Gives the largest of the unit of each.
    fn measure_rounding(&self, largest: &mut [f64]) -> Vec<f64> {
        let units: Vec<Option<&str>> = (0..largest.len())
            .map(|index| self.states.get(index).map(|state| state.unit_name.as_str()))
            .collect();
        let of_unit: Vec<f64> = units
            .iter()
            .map(|unit| {
                let own = units.iter().zip(largest.iter()).filter(|(other, _)| *other == unit);
                own.fold(0.0f64, |most, (_, size)| most.max(*size))
            })
            .collect();
        for (size, most) in largest.iter_mut().zip(&of_unit) {
            if *size > 0.0 && *size < ROUNDING * most {
                *size = *most;
            }
        }
        of_unit
    }

    /// Effort of every bond at the start, by its name.
    pub(crate) fn efforts_at_start(&self) -> HashMap<String, f64> {
        let mut compiled = Compiled::new(self, false);
        let y: Vec<f64> = self.states.iter().map(|state| state.start).collect();
        compiled.settle(0.0, &y);
        let variables = compiled.variables(0.0, &y, self.graph.signals.len());
        (0..self.graph.bonds.len()).map(|bond| (self.graph.bond_name(bond), variables[bond])).collect()
    }

    fn series(&self, pass: &Pass) -> Vec<Series> {
        let bonds = self.graph.bonds.len();
        let mut series = Vec::new();
        for (index, state) in self.states.iter().enumerate() {
            series.push(Series {
                name: state.symbol.clone(),
                unit: state.unit_name.clone(),
                values: pass.samples.iter().map(|(_, y)| y[index]).collect(),
            });
        }
        for bond in 0..bonds {
            let units = self.graph.bonds[bond].domain.unit_names();
            let name = self.graph.bond_name(bond);
            let of = |value: &dyn Fn(&[f64]) -> f64| pass.variables.iter().map(|v| value(v)).collect();
            series.push(Series {
                name: format!("{name}.effort"),
                unit: units[0].into(),
                values: of(&|v| v[bond]),
            });
            series.push(Series {
                name: format!("{name}.flow"),
                unit: units[1].into(),
                values: of(&|v| v[bonds + bond]),
            });
            let domain = self.graph.bonds[bond].domain;
            series.push(Series {
                name: format!("{name}.power"),
                unit: "W".into(),
                values: of(&|v| domain.power(v[bond], v[bonds + bond])),
            });
        }
        for element in self.graph.elements.iter().filter(|element| element.is_junction()) {
            let bond = element.ports[0];
            let units = self.graph.bonds[bond].domain.unit_names();
            let (what, place, unit) = match element.kind {
                Kind::One => ("flow", bonds + bond, units[1]),
                _ => ("effort", bond, units[0]),
            };
            series.push(Series {
                name: format!("{}.{what}", element.name),
                unit: unit.into(),
                values: pass.variables.iter().map(|v| v[place]).collect(),
            });
        }
        for (index, signal) in self.graph.signals.iter().enumerate() {
            if signal.start.is_none() {
                series.push(Series {
                    name: signal.name.clone(),
                    unit: signal.unit.to_string(),
                    values: pass.variables.iter().map(|v| v[2 * bonds + index]).collect(),
                });
            }
        }
        series
    }

    /// One integration over the whole duration, from the states `start`.
    pub(crate) fn pass(
        &self,
        compiled: &mut Compiled,
        request: &SimulationRequest,
        places: &[f64],
        absolute: &[f64],
        start: &[f64],
    ) -> Pass {
        let signals = self.graph.signals.len();
        let mut y = start.to_vec();
        y.resize(absolute.len(), 0.0);
        let mut t = 0.0;
        compiled.settle(t, &y);
        let mut settings = Settings::uniform(y.len(), request.tolerance);
        settings.absolute = absolute.to_vec();
        settings.most_evaluations = request.most_evaluations;
        settings.stiffness_test = request.method.is_none();
        settings.glance = true;
        settings.samples = grid(places, request.duration);
        if request.tolerance < FINE {
            settings.stops = places.to_vec();
        }
        let mut explicit = Dop853::new(settings.clone());
        settings.stops = places.to_vec();
        let mut implicit = Radau5::new(settings);
        let first = request.method.unwrap_or(Method::Explicit);
        let mut pass = Pass {
            samples: vec![(0.0, y.clone())],
            variables: vec![compiled.variables(t, &y, signals)],
            largest: y.iter().map(|y| y.abs()).collect(),
            end: (0.0, y.clone()),
            ended: String::new(),
            complete: false,
            methods: vec![first],
            stiff_from: None,
            evaluations_needed: None,
            events: Vec::new(),
            jumps: Vec::new(),
            statistics: Statistics::default(),
        };
        let (mut next, mut at_once) = (0, 0);
        // The last event that set states, when it came, how often at once.
        let mut setting = (usize::MAX, f64::NEG_INFINITY, 0);
        let mut stepped = (0.0, y.clone());
        // Steps in all, and those between two looks ahead.
        let (mut taken, between) = (0, request.most_evaluations / LOOK_AHEAD[0] / PER_STEP);
        let looks_ahead = compiled.looks_ahead && between > 0;
        let mut needed = None;
        // Steps since a time from which the run has not got away.
        let (mut stuck, mut stuck_from) = (0, 0.0);
        loop {
            let samples = &mut pass.samples;
            let largest = &mut pass.largest;
            let before = samples.len();
            let observe = |step: &Step| {
                stepped.0 = step.from;
                stepped.1.copy_from_slice(step.start);
                for (most, value) in largest.iter_mut().zip(step.end) {
                    *most = most.max(value.abs());
                }
                while next < places.len() && places[next] <= step.to {
                    let mut state = vec![0.0; step.end.len()];
                    step.at(places[next], &mut state);
                    samples.push((places[next], state));
                    next += 1;
                }
                stuck += 1;
                if step.to - stuck_from > 1e-9 * request.duration || step.to > 2.0 * stuck_from {
                    (stuck, stuck_from) = (0, step.to);
                }
                taken += 1;
                if looks_ahead && taken % between == 0 {
                    let own = (PER_STEP * taken) as f64 * request.duration / step.to;
                    if own > (LOOK_AHEAD[1] * request.most_evaluations) as f64 {
                        needed = Some(own);
                        return ControlFlow::Break(());
                    }
                }
                if stuck > STANDSTILL || request.cancel.is_some_and(Cancel::is_set) {
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(())
            };
            let is_explicit = pass.methods.last() == Some(&Method::Explicit);
            let last_time = t;
            let outcome = if is_explicit {
                explicit.run(compiled, &mut t, &mut y, request.duration, observe)
            } else {
                implicit.run(compiled, &mut t, &mut y, request.duration, observe)
            };
            for (place, state) in &pass.samples[before..] {
                pass.variables.push(compiled.variables(*place, state, signals));
            }
            match outcome {
                Outcome::Event { index, rising } => {
                    if is_explicit && request.tolerance < STEP_AGAIN {
                        step_again(compiled, request, absolute, &stepped, t, &mut y);
                    }
                    if compiled.held.stuck.contains(&index) {
                        pass.events.push(compiled.event(t, index, true, false));
                        compiled.give_way(index, t, &y);
                        explicit.restart();
                        implicit.restart();
                        continue;
                    }
                    if compiled.held.is_condition(index) {
                        pass.events.push(compiled.event(t, index, false, rising));
                    }
                    if let Some(element) = compiled.infinite(index) {
                        let name = &self.graph.elements[element].name;
                        pass.ended = format!("the ratio of `{name}` becomes infinite at {t} s");
                        // A sample at that place has no numbers.
                        while pass.samples.last().is_some_and(|(at, _)| t - at < 1e-9 * request.duration) {
                            pass.samples.pop();
                            pass.variables.pop();
                        }
                        break;
                    }
                    let before = compiled.leaps(t, &y);
                    compiled.held.happen(index, rising);
                    if let Some(bond) = leapt(&before, &compiled.leaps(t, &y)) {
                        let name = self.graph.bond_name(compiled.leaping(bond));
                        pass.ended = format!(
                            "`{name}` follows what jumps at {t} s, which would take an impulse: put a resistor or spring between, or let it change in some time"
                        );
                        break;
                    }
                    let place = |compiled: &mut Compiled, state: &[f64]| {
                        let variables = compiled.variables(t, state, signals);
                        Place { time: t, state: state.to_vec(), variables }
                    };
                    if compiled.stick(&[index], t, &y) {
                        pass.events.push(compiled.event(t, index, true, true));
                        explicit.restart();
                        implicit.restart();
                    }
                    let rises = rising && compiled.held.is_condition(index);
                    let just_before = (request.audit && rises).then(|| place(compiled, &y));
                    if rises && compiled.happen(index, t, &mut y) {
                        let again = setting.0 == index && t - setting.1 <= 1e-9 * request.duration;
                        setting = (index, t, if again { setting.2 + 1 } else { 0 });
                        compiled.settle(t, &y);
                        if let Some(just_before) = just_before {
                            pass.jumps.push([just_before, place(compiled, &y)]);
                        }
                        explicit.restart();
                        implicit.restart();
                        for (most, value) in pass.largest.iter_mut().zip(&y) {
                            *most = most.max(value.abs());
                        }
                    }
                    if setting.2 >= EVER_FASTER {
                        pass.ended = format!(
                            "an event comes ever faster, and no more can be told apart at {t} s: let it end the run, or stop what bounces below a least speed"
                        );
                        break;
                    }
                    if rises && compiled.stops(index) {
                        pass.complete = true;
                        pass.ended = format!("stopped by an event at {t} s");
                        break;
                    }
                    at_once = if t - last_time <= 1e-9 * request.duration { at_once + 1 } else { 0 };
                    if at_once > CHATTER {
                        let root = self.root_at_zero(compiled, request.duration, t, &y);
                        pass.ended = format!("a condition switches to and fro at {} s", seconds(t))
                            + &root.unwrap_or_else(|| {
                                ": give it a small width, for example tanh(x/width) instead of sign(x)".into()
                            });
                        break;
                    }
                }
                Outcome::Stiff { .. } => {
                    pass.stiff_from = Some(t);
                    pass.methods.push(Method::Implicit);
                }
                Outcome::Reached => {
                    pass.complete = true;
                    pass.ended = "the whole duration".into();
                    break;
                }
                Outcome::Stopped if stuck > STANDSTILL => {
                    pass.ended = format!("steps come no further than {} s", seconds(t))
                        + &self.root_at_zero(compiled, request.duration, t, &y).unwrap_or_default()
                        + &self.grown_moduli(compiled, t, &y);
                    break;
                }
                Outcome::Stopped if needed.is_some() => {
                    pass.evaluations_needed = needed;
                    pass.ended = format!(
                        "the whole duration needs some {:.0e} evaluations, more than {}: at {t} s",
                        needed.unwrap_or(f64::NAN),
                        request.most_evaluations
                    );
                    break;
                }
                Outcome::Stopped => {
                    pass.ended = format!("cancelled at {t} s");
                    break;
                }
                other => {
                    if matches!(other, Outcome::TooManyEvaluations { .. }) && looks_ahead && t > 0.0 {
                        pass.evaluations_needed =
                            Some(request.most_evaluations as f64 * request.duration / t);
                    }
                    let words = self.in_words(compiled, other, t, &y);
                    let root = self.root_at_zero(compiled, request.duration, t, &y);
                    pass.ended = words
                        + &root.unwrap_or_else(|| self.fastest(compiled, t, &y, &pass.largest, other))
                        + &self.grown_moduli(compiled, t, &y);
                    break;
                }
            }
        }
        let (a, b) = (explicit.statistics(), implicit.statistics());
        pass.statistics = Statistics {
            steps: a.steps + b.steps,
            rejected: a.rejected + b.rejected,
            evaluations: a.evaluations + b.evaluations,
            jacobians: b.jacobians,
            factorisations: b.factorisations,
            iterations: b.iterations,
            events: a.events + b.events,
        };
        pass.end = (t, y);
        pass
    }
}

/// The places of [`LOOKS`], equally spaced.
pub(crate) fn looks(duration: f64) -> Vec<f64> {
    (1..=LOOKS).map(|k| duration * k as f64 / LOOKS as f64).collect()
}

/// Which of some values has jumped, if one has.
fn leapt(before: &[f64], after: &[f64]) -> Option<usize> {
    let jumped = |(a, b): (&f64, &f64)| (a - b).abs() > LEAP * a.abs().max(b.abs());
    before.iter().zip(after).position(jumped)
}

/// The grid of places that are equally spaced from 0 on.
fn grid(places: &[f64], duration: f64) -> Option<SampleGrid> {
    let spacing = *places.first()?;
    let uniform = places
        .iter()
        .enumerate()
        .all(|(k, place)| (place - spacing * (k + 1) as f64).abs() <= 1e-9 * duration);
    (uniform && spacing > 0.0).then_some(SampleGrid { origin: 0.0, spacing })
}

/// The state at a kink of a curve or where a condition switches, by steps of their own from the start of the step that met it: the interpolant is
/// less accurate. What was held goes on smoothly beyond, so that the place does not matter to the last digit.
fn step_again(
    compiled: &mut Compiled,
    request: &SimulationRequest,
    absolute: &[f64],
    (from, start): &(f64, Vec<f64>),
    to: f64,
    state: &mut [f64],
) {
    let mut settings = Settings::uniform(state.len(), request.tolerance);
    settings.absolute = absolute.to_vec();
    settings.dense = false;
    settings.first_step = Some(to - from);
    let (mut t, mut fine) = (*from, start.clone());
    compiled.without_events = true;
    let outcome = Dop853::new(settings).run(compiled, &mut t, &mut fine, to, |_| ControlFlow::Continue(()));
    compiled.without_events = false;
    if outcome == Outcome::Reached {
        state.copy_from_slice(&fine);
    }
}
