//! Equations compiled for the integrators.

use crate::domain::Domain;
use crate::equations::{Equations, What};
use crate::expression::{Id, Pool, Var};
use crate::run::following::Following;
use crate::run::held::{Held, Switches};
use crate::run::sticking::Sticking;
use crate::run::tape::Tape;
use lanchester_numerics::{Lu, System};
use std::collections::HashMap;

/// Newton iterations for the unknowns of nonlinear loops: an exponential comes down by one unit of its exponent each.
const ITERATIONS: usize = 200;
/// Values from which they are tried where the last ones do not lead to a solution.
const GUESSES: [f64; 5] = [0.0, 1.0, -1.0, 1e3, -1e3];
/// The smallest share of a Newton step that is tried.
const LEAST_SHARE: f64 = 1e-12;

/// Equations as tapes: rates, unknowns with their exact Jacobian, variables of the bonds, switches.
#[derive(Debug, Clone)]
pub(crate) struct Compiled {
    pub(crate) states: usize,
    unknowns: usize,
    bonds: usize,
    audited: bool,
    /// Of each bond: what its power is made of.
    domains: Vec<Domain>,
    rates: Tape,
    /// Residuals of the unknowns, then their slopes by the unknowns.
    residuals: Tape,
    /// Efforts, flows, signals.
    variables: Tape,
    /// Slopes of rates by states and unknowns, of residuals by states and unknowns.
    slopes: Option<Tape>,
    /// Conditions and arguments of curves.
    switch_functions: Tape,
    pub(crate) held: Held,
    /// Dry friction that can stick.
    pub(crate) sticking: Sticking,
    /// Each condition as the graph writes it.
    pub(crate) conditions: Vec<String>,
    /// Of each event of the graph: its switch, the states that it sets.
    rules: Vec<(u32, Vec<u32>)>,
    /// Switches of events that end the simulation.
    stops: Vec<usize>,
    /// Divisors of ratios: their switch and element.
    divisors: Vec<(usize, usize)>,
    /// What stores hold that follow something which jumps, and their bonds.
    leaps: Tape,
    leaping: Vec<usize>,
    /// Their new values, one event after the other.
    settings: Tape,
    /// Whether events are passed over.
    pub(crate) without_events: bool,
    /// Whether a run ends as soon as it is seen to need more evaluations than it may take.
    pub(crate) looks_ahead: bool,
    /// Solves for all unknowns at once, where they are rates of followers.
    following: Option<Following>,
    /// Rates that it found with them.
    found: Vec<f64>,
    /// When the unknowns had no solution, if they had none the last time.
    unsolved_at: Option<f64>,
    /// Time, states, unknowns.
    pub(crate) inputs: Vec<f64>,
    pub(crate) work: Vec<f64>,
    values: Vec<f64>,
    scratch: Vec<f64>,
}

impl Compiled {
    /// Compiles; with `audited` the energy through every bond is integrated beside the states.
    pub(crate) fn new(equations: &Equations, audited: bool) -> Compiled {
        let mut pool = equations.graph.pool.clone();
        let values: Vec<Id> =
            equations.graph.parameters.iter().map(|parameter| pool.constant(parameter.value)).collect();
        let mut known = HashMap::new();
        let number = |var: Var| match var {
            Var::Parameter(index) => Some(values[index as usize]),
            _ => None,
        };
        let states = equations.states.len();
        let left: Vec<u32> = (0..equations.unknowns.len() as u32)
            .filter(|index| equations.unknowns[*index as usize].solved.is_none())
            .collect();
        let input = |var: Var| match var {
            Var::State(state) => 1 + state,
            Var::Unknown(unknown) => {
                let place = left.iter().position(|index| *index == unknown).unwrap_or(0);
                (1 + states + place) as u32
            }
            _ => 0,
        };
        let mut fold = |id: Id| pool.substitute(id, &mut known, &number);
        let rates: Vec<Id> = equations.states.iter().map(|state| fold(state.rate)).collect();
        let values: Vec<Id> =
            left.iter().map(|index| fold(equations.unknowns[*index as usize].value)).collect();
        let variables: Vec<Id> = (equations.efforts.iter().chain(&equations.flows).chain(&equations.signals))
            .map(|id| fold(*id))
            .collect();
        let held: Vec<Id> = left
            .iter()
            .map(|index| match equations.unknowns[*index as usize].what {
                What::Following(held) => fold(held),
                What::Tear => 0,
            })
            .collect();
        let residuals: Vec<Id> = left
            .iter()
            .zip(values)
            .map(|(index, value)| {
                let me = pool.var(Var::Unknown(*index));
                pool.difference(me, value)
            })
            .collect();
        let mut switches = Switches::default();
        let mut set_values = Vec::new();
        let (mut rules, mut stops) = (Vec::new(), Vec::new());
        for ((when, set), rule) in equations.rules.iter().zip(&equations.graph.rules) {
            let when = pool.substitute(*when, &mut known, &number);
            for (_, value) in set {
                set_values.push(pool.substitute(*value, &mut known, &number));
            }
            if rule.stop {
                stops.push(switches.of(when) as usize);
            }
            rules.push((switches.of(when), set.iter().map(|(state, _)| *state).collect()));
        }
        let settings = Tape::new(&mut pool, &set_values, &input, &mut switches);
        let mut divisors = Vec::new();
        for (element, divisor) in &equations.divisors {
            let divisor = pool.substitute(*divisor, &mut known, &number);
            divisors.push((switches.of(divisor) as usize, *element));
        }
        let (mut leaping, mut leaps) = (Vec::new(), Vec::new());
        for unknown in &equations.unknowns {
            if let What::Following(held) = unknown.what
                && pool.jumps(held)
            {
                leaping.push(unknown.bond);
                leaps.push(pool.substitute(held, &mut known, &number));
            }
        }
        let leaps = Tape::new(&mut pool, &leaps, &input, &mut switches);
        let following = Following::new(equations, &mut pool, &rates, &held, &left, &input, &mut switches);
        if let Some(following) = following {
            let variables = Tape::new(&mut pool, &variables, &input, &mut switches);
            let sticking = Sticking::new(&mut pool, &input, &mut switches);
            let functions = functions(&mut pool, &input, &mut switches);
            return Compiled {
                states,
                unknowns: left.len(),
                bonds: equations.graph.bonds.len(),
                audited,
                domains: domains(equations),
                rates: Tape::default(),
                residuals: Tape::default(),
                variables,
                slopes: None,
                switch_functions: functions,
                held: Held::new(&switches, &pool),
                sticking,
                conditions: equations.conditions(&mut pool, &number, &mut known, &switches.functions),
                rules,
                stops,
                divisors,
                leaps,
                leaping,
                settings,
                without_events: false,
                looks_ahead: false,
                following: Some(following),
                found: vec![0.0; states],
                unsolved_at: None,
                inputs: vec![0.0; 1 + states + left.len()],
                work: Vec::new(),
                values: Vec::new(),
                scratch: Vec::new(),
            };
        }
        let by: Vec<Var> =
            (0..states as u32).map(Var::State).chain(left.iter().map(|index| Var::Unknown(*index))).collect();
        // Column by column, so that one memory of derivatives serves each.
        let mut slopes = vec![0; (states + left.len()) * by.len()];
        for (column, var) in by.iter().enumerate() {
            let mut known = HashMap::new();
            for (row, id) in rates.iter().chain(&residuals).enumerate() {
                slopes[row * by.len() + column] = pool.derivative(*id, *var, &mut known);
            }
        }
        let mut with_slopes = residuals.clone();
        for row in 0..left.len() {
            for column in 0..left.len() {
                with_slopes.push(slopes[(states + row) * by.len() + states + column]);
            }
        }
        let rates = Tape::new(&mut pool, &rates, &input, &mut switches);
        let residuals = Tape::new(&mut pool, &with_slopes, &input, &mut switches);
        let variables = Tape::new(&mut pool, &variables, &input, &mut switches);
        let slopes = Tape::new(&mut pool, &slopes, &input, &mut switches);
        let sticking = Sticking::new(&mut pool, &input, &mut switches);
        let switch_functions = functions(&mut pool, &input, &mut switches);
        let unknowns = left.len();
        Compiled {
            states,
            unknowns,
            bonds: equations.graph.bonds.len(),
            audited,
            domains: domains(equations),
            rates,
            residuals,
            variables,
            slopes: Some(slopes),
            switch_functions,
            held: Held::new(&switches, &pool),
            sticking,
            conditions: equations.conditions(&mut pool, &number, &mut known, &switches.functions),
            rules,
            stops,
            divisors,
            leaps,
            leaping,
            settings,
            without_events: false,
            looks_ahead: false,
            following: None,
            found: Vec::new(),
            unsolved_at: None,
            inputs: vec![0.0; 1 + states + unknowns],
            work: Vec::new(),
            values: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// Operations of one evaluation of the rates.
    pub(crate) fn operations(&self) -> usize {
        self.rates.len() + self.residuals.len() + self.following.as_ref().map_or(0, Following::operations)
    }

    /// Time and states as inputs, unknowns solved by Newton's iteration from their last values; false where it fails.
    fn place(&mut self, t: f64, y: &[f64]) -> bool {
        self.inputs[0] = t;
        self.inputs[1..=self.states].copy_from_slice(&y[..self.states]);
        if self.unknowns == 0 {
            return true;
        }
        let solved = if let Some(following) = &mut self.following {
            let (inputs, unknowns) = self.inputs.split_at_mut(1 + self.states);
            following.solve(inputs, &self.held, &mut self.work, &mut self.found, unknowns)
        } else {
            // What fails from the last values may succeed from others: at 0 a root has no finite slope.
            self.newton()
                || GUESSES.iter().any(|guess| {
                    self.inputs[1 + self.states..].fill(*guess);
                    self.newton()
                })
        };
        self.unsolved_at = (!solved).then_some(t);
        if !solved {
            self.inputs[1 + self.states..].fill(0.0);
        }
        solved
    }

    /// Newton's iteration for the unknowns. A step that does not shrink the next one is halved: the next by the slopes at hand, which is a
    /// measure that no unit changes.
    fn newton(&mut self) -> bool {
        let n = self.unknowns;
        let from = 1 + self.states;
        self.values.resize(n + n * n, 0.0);
        let mut last = f64::INFINITY;
        self.residuals.run(&self.inputs, &self.held, &mut self.work, &mut self.values);
        for _ in 0..ITERATIONS {
            if !self.values.iter().all(|value| value.is_finite()) {
                return false;
            }
            let mut change = self.values[..n].to_vec();
            let Ok(factors) = Lu::new(n, self.values[n..].to_vec()) else { return false };
            factors.solve(&mut change);
            let before = self.inputs[from..].to_vec();
            let size_of = |step: &[f64]| {
                let shares = step.iter().zip(before.iter().zip(&change));
                shares.map(|(step, (x, d))| step.abs() / (x.abs() + d.abs() + 1e-30)).fold(0.0, f64::max)
            };
            let mut size = 0.0f64;
            for (i, change) in change.iter().enumerate() {
                let unknown = &mut self.inputs[from + i];
                *unknown -= change;
                size = size.max(change.abs() / (unknown.abs() + 1e-30));
            }
            if !size.is_finite() {
                return false;
            }
            if size < 1e-15 || (size < 1e-10 && size >= last) {
                return true;
            }
            last = size;
            let own = size_of(&change);
            let mut share = 1.0;
            loop {
                self.residuals.run(&self.inputs, &self.held, &mut self.work, &mut self.values);
                if size < 1e-10 {
                    break;
                }
                if self.values.iter().all(|value| value.is_finite()) {
                    let mut next = self.values[..n].to_vec();
                    factors.solve(&mut next);
                    if size_of(&next) <= (1.0 - 0.25 * share) * own {
                        break;
                    }
                }
                share *= 0.5;
                if share < LEAST_SHARE {
                    return false;
                }
                for (unknown, (x, d)) in self.inputs[from..].iter_mut().zip(before.iter().zip(&change)) {
                    *unknown = x - share * d;
                }
                last = f64::INFINITY;
            }
        }
        last < 1e-8
    }

    /// Whether unknowns have a solution.
    pub(crate) fn is_solved(&mut self, t: f64, y: &[f64]) -> bool {
        self.place(t, y)
    }

    /// When unknowns were without a solution, if they were so the last time.
    pub(crate) fn unsolved_at(&self) -> Option<f64> {
        self.unsolved_at
    }

    /// Effort and flow of every bond, then every signal.
    pub(crate) fn variables(&mut self, t: f64, y: &[f64], signals: usize) -> Vec<f64> {
        let mut values = vec![f64::NAN; 2 * self.bonds + signals];
        self.hold(t, y);
        if self.place(t, y) {
            self.variables.run(&self.inputs, &self.held, &mut self.work, &mut values);
        }
        values
    }

    /// Rates of the states with the signs as they are held; no numbers where unknowns have no solution.
    pub(crate) fn rates(&mut self, t: f64, y: &[f64], rates: &mut [f64]) -> bool {
        if !self.place(t, y) {
            rates.fill(f64::NAN);
            return false;
        }
        if self.following.is_some() {
            rates[..self.states].copy_from_slice(&self.found);
        } else {
            self.rates.run(&self.inputs, &self.held, &mut self.work, &mut rates[..self.states]);
        }
        true
    }

    /// Values of conditions and arguments of curves. Unknowns are solved only where these hang on one.
    pub(crate) fn quantities(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        let ready = if self.switch_functions.reads_from(1 + self.states) {
            self.place(t, y)
        } else {
            self.inputs[0] = t;
            self.inputs[1..=self.states].copy_from_slice(&y[..self.states]);
            true
        };
        if ready {
            self.switch_functions.run(&self.inputs, &self.held, &mut self.work, values);
        } else {
            values.fill(f64::NAN);
        }
    }

    /// Sets the states that the event of a switch sets, by the state just before; whether there is one.
    pub(crate) fn happen(&mut self, switch: usize, t: f64, y: &mut [f64]) -> bool {
        if !self.rules.iter().any(|(own, _)| *own as usize == switch) || !self.place(t, y) {
            return false;
        }
        let count = self.rules.iter().map(|(_, states)| states.len()).sum();
        let mut values = vec![0.0; count];
        self.settings.run(&self.inputs, &self.held, &mut self.work, &mut values);
        let mut next = 0;
        for (own, states) in &self.rules {
            for state in states {
                if *own as usize == switch {
                    y[*state as usize] = values[next];
                }
                next += 1;
            }
        }
        true
    }

    /// The element whose ratio becomes infinite where a switch changes.
    pub(crate) fn infinite(&self, switch: usize) -> Option<usize> {
        self.divisors.iter().find(|(own, _)| *own == switch).map(|(_, element)| *element)
    }

    /// What stores hold that follow something which jumps; empty where nothing can.
    pub(crate) fn leaps(&mut self, t: f64, y: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.leaping.len()];
        if !values.is_empty() && self.place(t, y) {
            self.leaps.run(&self.inputs, &self.held, &mut self.work, &mut values);
        }
        values
    }

    /// Bond of a store that follows something which jumps.
    pub(crate) fn leaping(&self, index: usize) -> usize {
        self.leaping[index]
    }

    /// Whether the event of a switch ends the simulation.
    pub(crate) fn stops(&self, switch: usize) -> bool {
        self.stops.contains(&switch)
    }

    /// Sets each switch by its function; where that is zero, by where it goes next, or lets it stick there. Curves are read ahead of their place.
    pub(crate) fn settle(&mut self, t: f64, y: &[f64]) {
        let count = self.held.quantities();
        let mut values = vec![0.0; count];
        // Switches may hang on one another: as many passes as there are settle any chain.
        for _ in 0..=count.min(20) {
            self.quantities(t, y, &mut values);
            self.held.settle(&values);
        }
        if values[..self.held.on.len()].contains(&0.0) {
            let mut slope = vec![0.0; y.len()];
            self.derivative(t, y, &mut slope);
            let step = 1e-9;
            let ahead: Vec<f64> = y.iter().zip(&slope).map(|(y, s)| y + step * s).collect();
            let mut later = vec![0.0; count];
            self.quantities(t + step, &ahead, &mut later);
            let at_zero: Vec<usize> = (0..self.held.on.len()).filter(|index| values[*index] == 0.0).collect();
            at_zero.iter().for_each(|index| self.held.turn(*index, later[*index] > 0.0));
            self.stick(&at_zero, t, y);
        }
    }
}

fn domains(equations: &Equations) -> Vec<Domain> {
    equations.graph.bonds.iter().map(|bond| bond.domain).collect()
}

/// Functions of switches and arguments of curves, which may hold such themselves.
fn functions(pool: &mut Pool, input: &impl Fn(Var) -> u32, switches: &mut Switches) -> Tape {
    let mut functions = switches.all();
    let mut tape = Tape::new(pool, &functions, input, switches);
    while switches.all().len() > functions.len() {
        functions = switches.all();
        tape = Tape::new(pool, &functions, input, switches);
    }
    tape
}

impl System for Compiled {
    fn dimension(&self) -> usize {
        self.states + if self.audited { self.bonds } else { 0 }
    }

    fn derivative(&mut self, t: f64, y: &[f64], derivative: &mut [f64]) {
        self.hold(t, y);
        if self.rates(t, y, derivative) && self.audited {
            self.scratch.resize(2 * self.bonds, 0.0);
            self.variables.run(&self.inputs, &self.held, &mut self.work, &mut self.scratch);
            for bond in 0..self.bonds {
                let (effort, flow) = (self.scratch[bond], self.scratch[self.bonds + bond]);
                derivative[self.states + bond] = self.domains[bond].power(effort, flow);
            }
        }
    }

    fn events(&self) -> usize {
        if self.without_events { 0 } else { self.held.events() }
    }

    fn event_functions(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        self.hold(t, y);
        let mut quantities = std::mem::take(&mut self.scratch);
        quantities.resize(self.held.quantities(), 0.0);
        self.quantities(t, y, &mut quantities);
        self.held.event_functions(&quantities, values);
        self.scratch = quantities;
    }

    /// Exact for the states; energies hang on nothing, and Newton's iteration needs no slopes of theirs.
    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut [f64]) -> bool {
        if self.slopes.is_none() || !self.held.stuck.is_empty() {
            return false;
        }
        if !self.place(t, y) {
            jacobian.fill(f64::NAN);
            return true;
        }
        let (n, m, size) = (self.states, self.unknowns, self.dimension());
        let mut slopes = vec![0.0; (n + m) * (n + m)];
        if let Some(tape) = &self.slopes {
            tape.run(&self.inputs, &self.held, &mut self.work, &mut slopes);
        }
        let at = |row: usize, column: usize| slopes[row * (n + m) + column];
        for column in 0..n {
            for row in 0..n {
                jacobian[row * size + column] = at(row, column);
            }
        }
        if m > 0 {
            let own = (0..m * m).map(|k| at(n + k / m, n + k % m)).collect();
            let Ok(factors) = Lu::new(m, own) else {
                jacobian.fill(f64::NAN);
                return true;
            };
            for column in 0..n {
                let mut change: Vec<f64> = (0..m).map(|row| at(n + row, column)).collect();
                factors.solve(&mut change);
                for row in 0..n {
                    let through: f64 = (0..m).map(|k| at(row, n + k) * change[k]).sum();
                    jacobian[row * size + column] -= through;
                }
            }
        }
        true
    }
}
