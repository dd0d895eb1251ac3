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
use crate::expression::{By, Id, Node, Pool, Var};
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
    /// How many entries G has; those of Phi follow.
    influence: usize,
    /// What is summed up to `G Phi`, row by row, to `G b` and to `Phi x_A'`.
    products: Sums,
    right_sides: Sums,
    unknowns: Sums,
    values: Vec<f64>,
    matrix: Vec<f64>,
    right: Vec<f64>,
}

/// Sums of products of two lists of numbers.
#[derive(Debug, Clone, Default)]
struct Sums {
    /// Where the products of each sum end.
    ends: Vec<u32>,
    /// Places of both factors.
    factors: Vec<[u32; 2]>,
}

impl Sums {
    /// From factors with the sum that each belongs to, `count` sums in all; the order within a sum is kept.
    fn new(count: usize, mut products: Vec<(usize, [u32; 2])>) -> Sums {
        products.sort_by_key(|(sum, _)| *sum);
        let end = |sum| products.partition_point(|(own, _)| *own <= sum) as u32;
        Sums { ends: (0..count).map(end).collect(), factors: products.into_iter().map(|own| own.1).collect() }
    }

    /// Puts each product to its number, which begins the sum.
    fn fold(&self, [a, b]: [&[f64]; 2], to: &mut [f64], put: impl Fn(f64, f64) -> f64) {
        let mut start = 0;
        for (to, end) in to.iter_mut().zip(&self.ends) {
            let end = *end as usize;
            let products = self.factors[start..end].iter().map(|[i, j]| a[*i as usize] * b[*j as usize]);
            *to = products.fold(*to, &put);
            start = end;
        }
    }
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
        // What changes by itself: time, and states whose rates are known.
        let mut running: HashMap<Var, Id> = HashMap::from([(Var::Time, pool.constant(1.0))]);
        for (state, parts) in split.iter().enumerate() {
            if parts.1.is_empty() {
                running.insert(Var::State(state as u32), parts.0);
            }
        }
        let mut along = HashMap::new();
        // Entries by followers: place in `acted` and expression.
        let (mut known, mut slopes) = (Vec::new(), vec![Vec::new(); held.len()]);
        for (follower, held) in held.iter().enumerate() {
            for var in pool.variables(&[*held]) {
                match var {
                    Var::State(state) => {
                        let Some(place) = acted.iter().position(|other| *other == state as usize) else {
                            continue;
                        };
                        let slope = pool.derivative(*held, var, &mut by_state[state as usize]);
                        if !pool.is_zero(slope) {
                            slopes[follower].push((place, slope));
                        }
                    }
                    Var::Unknown(_) => return None,
                    _ => {}
                }
            }
            slopes[follower].sort_unstable_by_key(|(place, _)| *place);
            known.push(pool.slope(*held, By::Rates(&running), &mut along));
        }
        let mut influence = vec![Vec::new(); held.len()];
        for (place, state) in acted.iter().enumerate() {
            for (unknown, factor) in &split[*state].1 {
                influence[left.iter().position(|other| other == unknown)?].push((place, *factor));
            }
        }
        outputs.extend(known);
        // Followers with the place in `acted` of each of their entries.
        let mut list = |entries: Vec<Vec<(usize, Id)>>| -> Vec<Vec<(usize, u32)>> {
            let mut count = 0;
            let mut place = |(place, id): (usize, Id)| {
                outputs.push(id);
                count += 1;
                (place, count - 1)
            };
            entries.into_iter().map(|own| own.into_iter().map(&mut place).collect()).collect()
        };
        let (influence, slopes) = (list(influence), list(slopes));
        let (mut products, mut right_sides, mut unknowns) = (Vec::new(), Vec::new(), Vec::new());
        for (follower, (influence, slopes)) in influence.iter().zip(&slopes).enumerate() {
            for (row, g) in influence {
                right_sides.push((*row, [*g, follower as u32]));
                products
                    .extend(slopes.iter().map(|(column, slope)| (row * acted.len() + column, [*g, *slope])));
            }
            unknowns.extend(slopes.iter().map(|(column, slope)| (follower, [*slope, *column as u32])));
        }
        let tape = Tape::new(pool, &outputs, input, switches);
        Some(Following {
            tape,
            states: rates.len(),
            followers: left.len(),
            influence: influence.iter().map(Vec::len).sum(),
            products: Sums::new(acted.len() * acted.len(), products),
            right_sides: Sums::new(acted.len(), right_sides),
            unknowns: Sums::new(left.len(), unknowns),
            acted,
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
        let (influence, slopes) = rest.split_at(self.influence);
        rates[..self.states].copy_from_slice(base);
        unknowns.copy_from_slice(known);
        self.right.clear();
        self.right.extend(self.acted.iter().map(|state| base[*state]));
        self.matrix.clear();
        self.matrix.resize(size * size, 0.0);
        for row in 0..size {
            self.matrix[row * size + row] = 1.0;
        }
        self.right_sides.fold([influence, known], &mut self.right, |sum, product| sum + product);
        self.products.fold([influence, slopes], &mut self.matrix, |sum, product| sum - product);
        let Ok(factors) = Lu::new(size, std::mem::take(&mut self.matrix)) else { return false };
        factors.solve(&mut self.right);
        for (state, rate) in self.acted.iter().zip(&self.right) {
            rates[*state] = *rate;
        }
        self.unknowns.fold([slopes, &self.right], unknowns, |sum, product| sum + product);
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
