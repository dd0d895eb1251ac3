//! Expressions: shared trees with exact derivatives.
//!
//! All expressions of a graph live in one [`Pool`], which keeps equal subexpressions once: derivatives stay small, and common
//! subexpressions are found for free.

mod derivative;
mod hazard;
mod parse;
mod print;

pub(crate) use derivative::By;
pub(crate) use parse::{Parsed, Scope, parse};
pub(crate) use print::{Printed, Style, identifier};

use crate::curve::Curve;
use std::collections::HashMap;
use std::sync::Arc;

/// Place of an expression in its pool.
pub(crate) type Id = u32;

/// A quantity that an expression depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Var {
    /// Time [s].
    Time,
    Parameter(u32),
    Signal(u32),
    Effort(u32),
    Flow(u32),
    /// Displacement of a store's port: state or follower.
    Displacement(u32),
    /// Momentum of a store's port.
    Momentum(u32),
    State(u32),
    Unknown(u32),
    /// A common part that has a name of its own, in printed equations alone.
    Named(u32),
}

/// Functions of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Sqrt,
    Exp,
    Ln,
    Abs,
    Sign,
    Tanh,
}

/// One operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// Bits of a number.
    Constant(u64),
    Var(Var),
    Negative(Id),
    Sum(Id, Id),
    Product(Id, Id),
    Quotient(Id, Id),
    Power(Id, Id),
    Call(Function, Id),
    Atan2(Id, Id),
    Min(Id, Id),
    Max(Id, Id),
    /// The second where the first is positive, else the third.
    If(Id, Id, Id),
    /// A curve of the pool, or a derivative of it, at an argument.
    Table(u32, u8, Id),
}

/// All expressions of a graph.
#[derive(Debug, Clone, Default)]
pub(crate) struct Pool {
    nodes: Vec<Node>,
    places: HashMap<Node, Id>,
    /// Curves with their names.
    pub(crate) curves: Vec<(String, Arc<Curve>)>,
}

impl Pool {
    pub(crate) fn node(&self, id: Id) -> Node {
        self.nodes[id as usize]
    }

    fn keep(&mut self, node: Node) -> Id {
        if let Some(id) = self.places.get(&node) {
            return *id;
        }
        let id = u32::try_from(self.nodes.len()).unwrap_or(u32::MAX);
        self.nodes.push(node);
        self.places.insert(node, id);
        id
    }

    pub(crate) fn constant(&mut self, value: f64) -> Id {
        let value = if value == 0.0 { 0.0 } else { value };
        self.keep(Node::Constant(value.to_bits()))
    }

    pub(crate) fn var(&mut self, var: Var) -> Id {
        self.keep(Node::Var(var))
    }

    pub(crate) fn value(&self, id: Id) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.value(id) == Some(0.0)
    }

    fn is_one(&self, id: Id) -> bool {
        self.value(id) == Some(1.0)
    }

    pub(crate) fn negative(&mut self, a: Id) -> Id {
        match self.node(a) {
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Node::Negative(b) => b,
            // -(-x + y) = x - y, to the last digit.
            Node::Sum(x, y) if matches!(self.node(x), Node::Negative(_)) => {
                let (x, y) = (self.negative(x), self.negative(y));
                self.sum(x, y)
            }
            _ => self.keep(Node::Negative(a)),
        }
    }

    pub(crate) fn sum(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.value(a), self.value(b)) {
            return self.constant(total(x, y));
        }
        if self.negative(a) == b {
            return self.constant(0.0);
        }
        self.keep(Node::Sum(a, b))
    }

    pub(crate) fn difference(&mut self, a: Id, b: Id) -> Id {
        let minus = self.negative(b);
        self.sum(a, minus)
    }

    pub(crate) fn product(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) || self.is_zero(b) {
            return self.constant(0.0);
        }
        if self.is_one(a) {
            return b;
        }
        if self.is_one(b) {
            return a;
        }
        match (self.node(a), self.node(b)) {
            (Node::Constant(x), Node::Constant(y)) => {
                return self.constant(f64::from_bits(x) * f64::from_bits(y));
            }
            (Node::Negative(x), Node::Negative(y)) => return self.product(x, y),
            (Node::Negative(x), _) => {
                let product = self.product(x, b);
                return self.negative(product);
            }
            (_, Node::Negative(y)) => {
                let product = self.product(a, y);
                return self.negative(product);
            }
            (_, Node::Constant(_)) => return self.product(b, a),
            (Node::Constant(x), _) if f64::from_bits(x) == -1.0 => return self.negative(b),
            (Node::Constant(x), Node::Product(c, d)) => {
                if let Some(y) = self.value(c) {
                    let both = self.constant(f64::from_bits(x) * y);
                    return self.product(both, d);
                }
            }
            (_, Node::Quotient(c, d)) => {
                let above = self.product(a, c);
                return self.quotient(above, d);
            }
            (Node::Quotient(c, d), _) => {
                let above = self.product(c, b);
                return self.quotient(above, d);
            }
            _ => {}
        }
        self.keep(Node::Product(a, b))
    }

    pub(crate) fn quotient(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) && !self.is_zero(b) {
            return self.constant(0.0);
        }
        if self.is_one(b) {
            return a;
        }
        if a == b && !self.is_zero(b) {
            return self.constant(1.0);
        }
        match (self.node(a), self.node(b)) {
            (Node::Constant(x), Node::Constant(y)) if f64::from_bits(y) != 0.0 => {
                return self.constant(f64::from_bits(x) / f64::from_bits(y));
            }
            (Node::Negative(x), Node::Negative(y)) => return self.quotient(x, y),
            // A number that multiplies both, such as the 2 of d/dq q^2/(2 C).
            (Node::Product(x, above), Node::Product(y, below))
                if x == y && self.value(x).is_some_and(|value| value != 0.0) =>
            {
                return self.quotient(above, below);
            }
            (Node::Negative(x), _) => {
                let quotient = self.quotient(x, b);
                return self.negative(quotient);
            }
            (_, Node::Negative(y)) => {
                let quotient = self.quotient(a, y);
                return self.negative(quotient);
            }
            (Node::Quotient(x, y), _) => {
                let below = self.product(y, b);
                return self.quotient(x, below);
            }
            (_, Node::Quotient(x, y)) => {
                let above = self.product(a, y);
                return self.quotient(above, x);
            }
            (Node::Product(x, y), _) if x == b && !self.is_zero(b) => return y,
            (Node::Product(x, y), _) if y == b && !self.is_zero(b) => return x,
            _ => {}
        }
        self.keep(Node::Quotient(a, b))
    }

    pub(crate) fn power(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (_, Some(0.0)) => return self.constant(1.0),
            (_, Some(1.0)) => return a,
            (Some(x), Some(y)) if x.powf(y).is_finite() => return self.constant(x.powf(y)),
            _ => {}
        }
        self.keep(Node::Power(a, b))
    }

    pub(crate) fn square(&mut self, a: Id) -> Id {
        let two = self.constant(2.0);
        self.power(a, two)
    }

    pub(crate) fn call(&mut self, function: Function, a: Id) -> Id {
        if let Some(x) = self.value(a) {
            let value = function.apply(x);
            if value.is_finite() {
                return self.constant(value);
            }
        }
        self.keep(Node::Call(function, a))
    }

    pub(crate) fn choice(&mut self, g: Id, a: Id, b: Id) -> Id {
        if a == b {
            return a;
        }
        match self.value(g) {
            Some(g) if g > 0.0 => a,
            Some(_) => b,
            None => self.keep(Node::If(g, a, b)),
        }
    }

    /// The operands of an expression.
    pub(crate) fn operands(&self, id: Id) -> impl Iterator<Item = Id> + use<> {
        let (list, count) = match self.node(id) {
            Node::Constant(_) | Node::Var(_) => ([0; 3], 0),
            Node::Negative(a) | Node::Call(_, a) | Node::Table(_, _, a) => ([a, 0, 0], 1),
            Node::Sum(a, b)
            | Node::Product(a, b)
            | Node::Quotient(a, b)
            | Node::Power(a, b)
            | Node::Atan2(a, b)
            | Node::Min(a, b)
            | Node::Max(a, b) => ([a, b, 0], 2),
            Node::If(a, b, c) => ([a, b, c], 3),
        };
        list.into_iter().take(count)
    }

    /// The same operation on other operands.
    pub(crate) fn with_operands(&mut self, id: Id, mut of: impl FnMut(&mut Pool, Id) -> Id) -> Id {
        match self.node(id) {
            Node::Constant(_) | Node::Var(_) => id,
            Node::Negative(a) => {
                let a = of(self, a);
                self.negative(a)
            }
            Node::Call(function, a) => {
                let a = of(self, a);
                self.call(function, a)
            }
            Node::Table(curve, derivative, a) => {
                let a = of(self, a);
                self.table(curve, derivative, a)
            }
            Node::If(g, a, b) => {
                let (g, a, b) = (of(self, g), of(self, a), of(self, b));
                self.choice(g, a, b)
            }
            node => {
                let operands: Vec<Id> = self.operands(id).collect();
                let (a, b) = (of(self, operands[0]), of(self, operands[1]));
                match node {
                    Node::Sum(..) => self.sum(a, b),
                    Node::Product(..) => self.product(a, b),
                    Node::Quotient(..) => self.quotient(a, b),
                    Node::Power(..) => self.power(a, b),
                    Node::Atan2(..) => self.keep(Node::Atan2(a, b)),
                    Node::Min(..) => self.keep(Node::Min(a, b)),
                    _ => self.keep(Node::Max(a, b)),
                }
            }
        }
    }

    /// `x / (x^2 + width^2)^(1/4)`: the root of the absolute value with the sign of x, with a finite slope at 0.
    pub(crate) fn regular_root(&mut self, x: Id, width: Id) -> Id {
        let (xx, ww) = (self.square(x), self.square(width));
        let sum = self.sum(xx, ww);
        let root = self.call(Function::Sqrt, sum);
        let below = self.call(Function::Sqrt, root);
        self.quotient(x, below)
    }

    pub(crate) fn atan2(&mut self, a: Id, b: Id) -> Id {
        self.keep(Node::Atan2(a, b))
    }

    /// A curve, or a derivative of it, at an argument; none is left of a cubic behind its third derivative.
    pub(crate) fn table(&mut self, curve: u32, derivative: u8, a: Id) -> Id {
        if derivative > 3 { self.constant(0.0) } else { self.keep(Node::Table(curve, derivative, a)) }
    }

    pub(crate) fn least(&mut self, a: Id, b: Id) -> Id {
        self.keep(Node::Min(a, b))
    }

    pub(crate) fn largest(&mut self, a: Id, b: Id) -> Id {
        self.keep(Node::Max(a, b))
    }

    /// Replaces variables; `known` keeps what is replaced already and must belong to the same replacement.
    pub(crate) fn substitute(
        &mut self,
        id: Id,
        known: &mut HashMap<Id, Id>,
        replace: &impl Fn(Var) -> Option<Id>,
    ) -> Id {
        if let Some(new) = known.get(&id) {
            return *new;
        }
        let new = match self.node(id) {
            Node::Var(var) => replace(var).unwrap_or(id),
            _ => self.with_operands(id, |pool, operand| pool.substitute(operand, known, replace)),
        };
        known.insert(id, new);
        new
    }

    /// All variables of some expressions.
    pub(crate) fn variables(&self, ids: &[Id]) -> Vec<Var> {
        let mut seen = vec![false; self.nodes.len()];
        let mut stack: Vec<Id> = ids.to_vec();
        let mut found = Vec::new();
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut seen[id as usize], true) {
                continue;
            }
            if let Node::Var(var) = self.node(id) {
                found.push(var);
            }
            stack.extend(self.operands(id));
        }
        found
    }

    pub(crate) fn depends(&self, id: Id, on: impl Fn(Var) -> bool) -> bool {
        self.variables(&[id]).into_iter().any(on)
    }

    /// Value of an expression for given values of its variables.
    pub(crate) fn evaluate(&self, id: Id, of: &impl Fn(Var) -> f64) -> f64 {
        let at = |id: Id| self.evaluate(id, of);
        match self.node(id) {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Var(var) => of(var),
            Node::Negative(a) => -at(a),
            Node::Sum(a, b) => at(a) + at(b),
            Node::Product(a, b) => at(a) * at(b),
            Node::Quotient(a, b) => at(a) / at(b),
            Node::Power(a, b) => at(a).powf(at(b)),
            Node::Call(function, a) => function.apply(at(a)),
            Node::Atan2(a, b) => at(a).atan2(at(b)),
            Node::Min(a, b) => at(a).min(at(b)),
            Node::Max(a, b) => at(a).max(at(b)),
            Node::If(g, a, b) => at(if at(g) > 0.0 { a } else { b }),
            Node::Table(curve, derivative, a) => self.curves[curve as usize].1.at(at(a), derivative),
        }
    }
}

/// What of two numbers, each rounded and each of some operations, their sum may leave where it is 0, as a share of the larger.
const CANCELLED: f64 = 4.0 * f64::EPSILON;

/// The sum of two numbers of a file; one that cancels to their rounding is 0.
pub(crate) fn total(x: f64, y: f64) -> f64 {
    let sum = x + y;
    if sum.abs() <= CANCELLED * x.abs().max(y.abs()) { 0.0 } else { sum }
}

impl Function {
    pub(crate) const ALL: [(&'static str, Function); 11] = [
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("tan", Function::Tan),
        ("asin", Function::Asin),
        ("acos", Function::Acos),
        ("sqrt", Function::Sqrt),
        ("exp", Function::Exp),
        ("ln", Function::Ln),
        ("abs", Function::Abs),
        ("sign", Function::Sign),
        ("tanh", Function::Tanh),
    ];

    pub(crate) fn name(self) -> &'static str {
        Function::ALL.iter().find(|(_, function)| *function == self).map_or("", |(name, _)| name)
    }

    pub(crate) fn apply(self, x: f64) -> f64 {
        match self {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Sqrt => x.sqrt(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Abs => x.abs(),
            Function::Sign => {
                if x > 0.0 {
                    1.0
                } else if x < 0.0 {
                    -1.0
                } else {
                    0.0
                }
            }
            Function::Tanh => x.tanh(),
        }
    }
}
