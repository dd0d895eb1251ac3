//! Stores that follow, solved in the rates of the states that they act on.
//!
//! ```text
//! x_A' = r + G u        u = Phi x_A' + b        (1 - G Phi) x_A' = r + G b
//! ```
//! | symbol | name                                                                           |
//! |--------|--------------------------------------------------------------------------------|
//! | x_A    | states whose rates hang on what the followers do                               |
//! | u      | rates of what the followers hold: their efforts (I) or flows (C)                |
//! | G      | influence of these on the rates                                                |
//! | Phi    | slopes of what the followers hold by the states x_A                            |
//! | b      | the part of u that the known rates and the time bring                          |
//!
//! As many unknowns as states, not as followers: an engine has a hundred of these and seven of those.

use crate::equations::{Equations, What};
use crate::expression::{Id, Node, Pool, Var};
use crate::run::held::{Held, Switches};
use crate::run::tape::Tape;
use lanchester_numerics::Lu;
use std::collections::HashMap;
use std::rc::Rc;

/// Rest and factors of unknowns.
type Linear = Rc<(Id, Vec<(u32, Id)>)>;

/// Coefficients compiled.
#[derive(Debug, Clone)]
pub(crate) struct Following {
    /// Rates without followers, b, entries of G, entries of Phi.
    tape: Tape,
    states: usize,
    followers: usize,
    /// States whose rates hang on followers.
    acted: Vec<usize>,
    /// Place in `acted` and follower of each entry of G.
    influence: Vec<(usize, usize)>,
    /// Follower and place in `acted` of each entry of Phi.
    slopes: Vec<(usize, usize)>,
    /// Entries of the matrix to which products of an entry of G and one of Phi go, with the places of both.
    products: Vec<[u32; 3]>,
    values: Vec<f64>,
    matrix: Vec<f64>,
    right: Vec<f64>,
}

impl Following {
    /// Compiles; none where an unknown is not the rate of a follower, or does not act linearly.
    pub(crate) fn new(
        equations: &Equations,
        pool: &mut Pool,
        rates: &[Id],
        held: &[Id],
        left: &[u32],
        input: &impl Fn(Var) -> u32,
        switches: &mut Switches,
    ) -> Option<Following> {
        let follows = |index: &u32| matches!(equations.unknowns[*index as usize].what, What::Following(_));
        if left.is_empty() || !left.iter().all(follows) {
            return None;
        }
        let mut memory = HashMap::new();
        let split: Vec<Linear> =
            rates.iter().map(|rate| linear(pool, *rate, &mut memory)).collect::<Option<_>>()?;
        let acted: Vec<usize> = (0..rates.len()).filter(|state| !split[*state].1.is_empty()).collect();
        let mut outputs: Vec<Id> = split.iter().map(|parts| parts.0).collect();
        let mut by_state: Vec<HashMap<Id, Id>> = vec![HashMap::new(); rates.len()];
        let mut by_time = HashMap::new();
        let (mut known, mut slopes, mut slope_ids) = (Vec::new(), Vec::new(), Vec::new());
        for (follower, held) in held.iter().enumerate() {
            let mut sum = pool.derivative(*held, Var::Time, &mut by_time);
            for var in pool.variables(&[*held]) {
                match var {
                    Var::State(state) => {
                        let state = state as usize;
                        let slope = pool.derivative(*held, var, &mut by_state[state]);
                        match acted.iter().position(|other| *other == state) {
                            Some(place) if !pool.is_zero(slope) => {
                                slopes.push((follower, place));
                                slope_ids.push(slope);
                            }
                            Some(_) => {}
                            None => {
                                let term = pool.product(slope, split[state].0);
                                sum = pool.sum(sum, term);
                            }
                        }
                    }
                    Var::Unknown(_) => return None,
                    _ => {}
                }
            }
            known.push(sum);
        }
        let (mut influence, mut influence_ids) = (Vec::new(), Vec::new());
        for (place, state) in acted.iter().enumerate() {
            for (unknown, factor) in &split[*state].1 {
                influence.push((place, left.iter().position(|other| other == unknown)?));
                influence_ids.push(*factor);
            }
        }
        outputs.extend(known.into_iter().chain(influence_ids).chain(slope_ids));
        let tape = Tape::new(pool, &outputs, input, switches);
        let mut columns: Vec<Vec<(usize, usize)>> = vec![Vec::new(); left.len()];
        for (entry, (row, follower)) in influence.iter().enumerate() {
            columns[*follower].push((*row, entry));
        }
        let size = acted.len();
        let products = (slopes.iter().enumerate())
            .flat_map(|(slope, (follower, column))| {
                let entry = move |(row, entry): &(usize, usize)| {
                    [row * size + column, *entry, slope].map(|place| place as u32)
                };
                columns[*follower].iter().map(entry)
            })
            .collect();
        Some(Following {
            tape,
            states: rates.len(),
            followers: left.len(),
            acted,
            influence,
            slopes,
            products,
            values: vec![0.0; outputs.len()],
            matrix: Vec::new(),
            right: Vec::new(),
        })
    }

    /// Operations of one evaluation.
    pub(crate) fn operations(&self) -> usize {
        self.tape.len()
    }

    /// Rates of all states into `rates` and of the followers into `unknowns`; false where the matrix is singular.
    pub(crate) fn solve(
        &mut self,
        inputs: &[f64],
        held: &Held,
        work: &mut Vec<f64>,
        rates: &mut [f64],
        unknowns: &mut [f64],
    ) -> bool {
        self.tape.run(inputs, held, work, &mut self.values);
        let size = self.acted.len();
        let (base, rest) = self.values.split_at(self.states);
        let (known, rest) = rest.split_at(self.followers);
        let (influence, slopes) = rest.split_at(self.influence.len());
        rates[..self.states].copy_from_slice(base);
        unknowns.copy_from_slice(known);
        self.right.clear();
        self.right.extend(self.acted.iter().map(|state| base[*state]));
        self.matrix.clear();
        self.matrix.resize(size * size, 0.0);
        for ((row, follower), value) in self.influence.iter().zip(influence) {
            self.right[*row] += value * known[*follower];
        }
        for row in 0..size {
            self.matrix[row * size + row] = 1.0;
        }
        for [place, entry, slope] in &self.products {
            self.matrix[*place as usize] -= influence[*entry as usize] * slopes[*slope as usize];
        }
        let Ok(factors) = Lu::new(size, std::mem::take(&mut self.matrix)) else { return false };
        factors.solve(&mut self.right);
        for (state, rate) in self.acted.iter().zip(&self.right) {
            rates[*state] = *rate;
        }
        for ((follower, column), slope) in self.slopes.iter().zip(slopes) {
            unknowns[*follower] += slope * self.right[*column];
        }
        true
    }
}

/// An expression as a rest and factors of unknowns; none where it is not linear in them.
fn linear(pool: &mut Pool, id: Id, memory: &mut HashMap<Id, Linear>) -> Option<Linear> {
    if let Some(found) = memory.get(&id) {
        return Some(Rc::clone(found));
    }
    let parts = match pool.node(id) {
        Node::Var(Var::Unknown(unknown)) => {
            let (zero, one) = (pool.constant(0.0), pool.constant(1.0));
            (zero, vec![(unknown, one)])
        }
        Node::Negative(a) => {
            let a = linear(pool, a, memory)?;
            map(pool, &a, &mut |pool, id| pool.negative(id))
        }
        Node::Sum(a, b) => {
            let (a, b) = (linear(pool, a, memory)?, linear(pool, b, memory)?);
            let rest = pool.sum(a.0, b.0);
            (rest, merge(pool, &a.1, &b.1))
        }
        Node::Product(a, b) => {
            let (left, right) = (linear(pool, a, memory)?, linear(pool, b, memory)?);
            match (left.1.is_empty(), right.1.is_empty()) {
                (true, true) => (id, Vec::new()),
                (true, false) => map(pool, &right, &mut |pool, id| pool.product(a, id)),
                (false, true) => map(pool, &left, &mut |pool, id| pool.product(id, b)),
                (false, false) => return None,
            }
        }
        Node::Quotient(a, b) => {
            let (above, below) = (linear(pool, a, memory)?, linear(pool, b, memory)?);
            match (above.1.is_empty(), below.1.is_empty()) {
                (true, true) => (id, Vec::new()),
                (false, true) => map(pool, &above, &mut |pool, id| pool.quotient(id, b)),
                _ => return None,
            }
        }
        _ => {
            let operands: Vec<Id> = pool.operands(id).collect();
            for operand in operands {
                if !linear(pool, operand, memory)?.1.is_empty() {
                    return None;
                }
            }
            (id, Vec::new())
        }
    };
    let parts = if parts.1.is_empty() { (id, parts.1) } else { parts };
    let parts = Rc::new(parts);
    memory.insert(id, Rc::clone(&parts));
    Some(parts)
}

fn map(pool: &mut Pool, parts: &Linear, of: &mut impl FnMut(&mut Pool, Id) -> Id) -> (Id, Vec<(u32, Id)>) {
    let rest = of(pool, parts.0);
    (rest, parts.1.iter().map(|(unknown, id)| (*unknown, of(pool, *id))).collect())
}

/// Sum of two lists of factors, both by rising unknown.
fn merge(pool: &mut Pool, a: &[(u32, Id)], b: &[(u32, Id)]) -> Vec<(u32, Id)> {
    let (mut i, mut j) = (0, 0);
    let mut sum = Vec::with_capacity(a.len() + b.len());
    while i < a.len() || j < b.len() {
        match (a.get(i), b.get(j)) {
            (Some(x), Some(y)) if x.0 == y.0 => {
                let both = pool.sum(x.1, y.1);
                if !pool.is_zero(both) {
                    sum.push((x.0, both));
                }
                (i, j) = (i + 1, j + 1);
            }
            (Some(x), y) if y.is_none_or(|y| x.0 < y.0) => {
                sum.push(*x);
                i += 1;
            }
            (_, Some(y)) => {
                sum.push(*y);
                j += 1;
            }
            _ => break,
        }
    }
    sum
}
