//! Equations compiled for the integrators.

use crate::equations::Equations;
use crate::expression::{Id, Var};
use crate::tape::{Switches, Tape};
use lanchester_numerics::{Lu, System};
use std::collections::HashMap;

/// Newton iterations for the unknowns of nonlinear loops.
const ITERATIONS: usize = 50;

/// Equations as tapes: rates, unknowns with their exact Jacobian, variables of the bonds, switches.
#[derive(Debug, Clone)]
pub(crate) struct Compiled {
    pub(crate) states: usize,
    unknowns: usize,
    bonds: usize,
    audited: bool,
    /// Whether effort times flow is the power of each bond; of a heat bond the flow itself is.
    true_bonds: Vec<bool>,
    rates: Tape,
    /// Residuals of the unknowns, then their slopes by the unknowns.
    residuals: Tape,
    /// Efforts, flows, signals.
    variables: Tape,
    /// Slopes of rates by states and unknowns, of residuals by states and unknowns.
    slopes: Tape,
    switch_functions: Tape,
    pub(crate) on: Vec<bool>,
    /// Time, states, unknowns.
    inputs: Vec<f64>,
    work: Vec<f64>,
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
        let residuals: Vec<Id> = left
            .iter()
            .zip(values)
            .map(|(index, value)| {
                let me = pool.var(Var::Unknown(*index));
                pool.difference(me, value)
            })
            .collect();
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
        let mut switches = Switches::default();
        let rates = Tape::new(&mut pool, &rates, &input, &mut switches);
        let residuals = Tape::new(&mut pool, &with_slopes, &input, &mut switches);
        let variables = Tape::new(&mut pool, &variables, &input, &mut switches);
        let slopes = Tape::new(&mut pool, &slopes, &input, &mut switches);
        // Functions of switches may hold switches themselves.
        let mut functions = switches.functions.clone();
        let mut switch_functions = Tape::new(&mut pool, &functions, &input, &mut switches);
        while switches.functions.len() > functions.len() {
            functions = switches.functions.clone();
            switch_functions = Tape::new(&mut pool, &functions, &input, &mut switches);
        }
        let unknowns = left.len();
        Compiled {
            states,
            unknowns,
            bonds: equations.graph.bonds.len(),
            audited,
            true_bonds: equations.graph.bonds.iter().map(|bond| bond.domain.is_true_bond()).collect(),
            rates,
            residuals,
            variables,
            slopes,
            switch_functions,
            on: vec![false; functions.len()],
            inputs: vec![0.0; 1 + states + unknowns],
            work: Vec::new(),
            values: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// Operations of one evaluation of the rates.
    pub(crate) fn operations(&self) -> usize {
        self.rates.len() + self.residuals.len()
    }

    /// Time and states as inputs, unknowns solved by Newton's iteration from their last values; false where it fails.
    fn place(&mut self, t: f64, y: &[f64]) -> bool {
        self.inputs[0] = t;
        self.inputs[1..=self.states].copy_from_slice(&y[..self.states]);
        let n = self.unknowns;
        if n == 0 {
            return true;
        }
        self.values.resize(n + n * n, 0.0);
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            self.residuals.run(&self.inputs, &self.on, &mut self.work, &mut self.values);
            let mut change = self.values[..n].to_vec();
            let Ok(factors) = Lu::new(n, self.values[n..].to_vec()) else { return false };
            factors.solve(&mut change);
            let mut size = 0.0f64;
            for (i, change) in change.iter().enumerate() {
                let unknown = &mut self.inputs[1 + self.states + i];
                *unknown -= change;
                size = size.max(change.abs() / (unknown.abs() + 1e-30));
            }
            if !size.is_finite() {
                self.inputs[1 + self.states..].fill(0.0);
                return false;
            }
            if size < 1e-15 || (size < 1e-10 && size >= last) {
                return true;
            }
            last = size;
        }
        last < 1e-8
    }

    /// Effort and flow of every bond, then every signal.
    pub(crate) fn variables(&mut self, t: f64, y: &[f64], signals: usize) -> Vec<f64> {
        let mut values = vec![f64::NAN; 2 * self.bonds + signals];
        if self.place(t, y) {
            self.variables.run(&self.inputs, &self.on, &mut self.work, &mut values);
        }
        values
    }

    /// Sets each switch by its function; where that is zero, by where it goes next.
    pub(crate) fn settle(&mut self, t: f64, y: &[f64]) {
        let count = self.on.len();
        let mut values = vec![0.0; count];
        // Switches may hang on one another: as many passes as there are settle any chain.
        for _ in 0..=count.min(20) {
            self.event_functions(t, y, &mut values);
            for (on, value) in self.on.iter_mut().zip(&values) {
                *on = *value > 0.0;
            }
        }
        if values.contains(&0.0) {
            let mut slope = vec![0.0; y.len()];
            self.derivative(t, y, &mut slope);
            let step = 1e-9;
            let ahead: Vec<f64> = y.iter().zip(&slope).map(|(y, s)| y + step * s).collect();
            let mut later = vec![0.0; count];
            self.event_functions(t + step, &ahead, &mut later);
            for index in 0..count {
                if values[index] == 0.0 {
                    self.on[index] = later[index] > 0.0;
                }
            }
        }
    }
}

impl System for Compiled {
    fn dimension(&self) -> usize {
        self.states + if self.audited { self.bonds } else { 0 }
    }

    fn derivative(&mut self, t: f64, y: &[f64], derivative: &mut [f64]) {
        if !self.place(t, y) {
            derivative.fill(f64::NAN);
            return;
        }
        self.rates.run(&self.inputs, &self.on, &mut self.work, &mut derivative[..self.states]);
        if self.audited {
            self.scratch.resize(2 * self.bonds, 0.0);
            self.variables.run(&self.inputs, &self.on, &mut self.work, &mut self.scratch);
            for bond in 0..self.bonds {
                let effort = if self.true_bonds[bond] { self.scratch[bond] } else { 1.0 };
                derivative[self.states + bond] = effort * self.scratch[self.bonds + bond];
            }
        }
    }

    fn events(&self) -> usize {
        self.on.len()
    }

    fn event_functions(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        if self.place(t, y) {
            self.switch_functions.run(&self.inputs, &self.on, &mut self.work, values);
        } else {
            values.fill(f64::NAN);
        }
    }

    /// Exact for the states; energies hang on nothing, and Newton's iteration needs no slopes of theirs.
    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut [f64]) -> bool {
        if !self.place(t, y) {
            jacobian.fill(f64::NAN);
            return true;
        }
        let (n, m, size) = (self.states, self.unknowns, self.dimension());
        let mut slopes = vec![0.0; (n + m) * (n + m)];
        self.slopes.run(&self.inputs, &self.on, &mut self.work, &mut slopes);
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
