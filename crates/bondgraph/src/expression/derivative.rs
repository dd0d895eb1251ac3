//! Exact derivatives.

use super::{Function, Id, Node, Pool, Var};
use std::collections::HashMap;

/// By what a derivative is taken.
#[derive(Clone, Copy)]
pub(crate) enum By<'a> {
    /// A variable.
    Variable(Var),
    /// Whatever changes, with the rates of variables; those that are not named stand still.
    Rates(&'a HashMap<Var, Id>),
}

impl Pool {
    /// Derivative by a variable; `known` keeps derivatives by the same variable. Those of `sign` and of the choice itself are zero:
    /// steps are events, not slopes.
    pub(crate) fn derivative(&mut self, id: Id, by: Var, known: &mut HashMap<Id, Id>) -> Id {
        self.slope(id, By::Variable(by), known)
    }

    /// The same by a variable or along rates: each subexpression is differentiated once, however many variables change.
    pub(crate) fn slope(&mut self, id: Id, by: By<'_>, known: &mut HashMap<Id, Id>) -> Id {
        if let Some(found) = known.get(&id) {
            return *found;
        }
        let slope = match self.node(id) {
            Node::Constant(_) => self.constant(0.0),
            Node::Var(var) => match by {
                By::Variable(by) => self.constant(f64::from(u8::from(var == by))),
                By::Rates(rates) => match rates.get(&var) {
                    Some(rate) => *rate,
                    None => self.constant(0.0),
                },
            },
            Node::Negative(a) => {
                let a = self.slope(a, by, known);
                self.negative(a)
            }
            Node::Sum(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                self.sum(da, db)
            }
            Node::Product(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                let (first, second) = (self.product(da, b), self.product(a, db));
                self.sum(first, second)
            }
            Node::Quotient(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                let first = self.quotient(da, b);
                let (above, below) = (self.product(a, db), self.square(b));
                let second = self.quotient(above, below);
                self.difference(first, second)
            }
            Node::Power(a, b) => self.derivative_of_power(id, (a, b), by, known),
            Node::Call(function, a) => {
                let da = self.slope(a, by, known);
                if self.is_zero(da) { da } else { self.derivative_of_call(function, id, a, da) }
            }
            Node::Atan2(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                let (first, second) = (self.product(b, da), self.product(a, db));
                let above = self.difference(first, second);
                let (aa, bb) = (self.square(a), self.square(b));
                let below = self.sum(aa, bb);
                self.quotient(above, below)
            }
            Node::Min(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                let g = self.difference(b, a);
                self.choice(g, da, db)
            }
            Node::Max(a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                let g = self.difference(a, b);
                self.choice(g, da, db)
            }
            Node::Table(curve, order, a) => {
                let da = self.slope(a, by, known);
                if self.is_zero(da) {
                    da
                } else {
                    let slope = self.table(curve, order + 1, a);
                    self.product(slope, da)
                }
            }
            Node::If(g, a, b) => {
                let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
                self.choice(g, da, db)
            }
        };
        known.insert(id, slope);
        slope
    }

    fn derivative_of_power(
        &mut self,
        id: Id,
        (a, b): (Id, Id),
        by: By<'_>,
        known: &mut HashMap<Id, Id>,
    ) -> Id {
        let (da, db) = (self.slope(a, by, known), self.slope(b, by, known));
        let minus_one = self.constant(-1.0);
        let lower = self.sum(b, minus_one);
        let power = self.power(a, lower);
        let scaled = self.product(b, power);
        let first = self.product(scaled, da);
        if self.is_zero(db) {
            return first;
        }
        let log = self.call(Function::Ln, a);
        let weighed = self.product(id, log);
        let second = self.product(weighed, db);
        self.sum(first, second)
    }

    fn derivative_of_call(&mut self, function: Function, id: Id, a: Id, da: Id) -> Id {
        let one = self.constant(1.0);
        match function {
            Function::Sin => {
                let cos = self.call(Function::Cos, a);
                self.product(cos, da)
            }
            Function::Cos => {
                let sin = self.call(Function::Sin, a);
                let product = self.product(sin, da);
                self.negative(product)
            }
            Function::Tan => {
                let square = self.square(id);
                let factor = self.sum(one, square);
                self.product(factor, da)
            }
            Function::Asin | Function::Acos => {
                let square = self.square(a);
                let rest = self.difference(one, square);
                let root = self.call(Function::Sqrt, rest);
                let quotient = self.quotient(da, root);
                if function == Function::Asin { quotient } else { self.negative(quotient) }
            }
            Function::Sqrt => {
                let two = self.constant(2.0);
                let below = self.product(two, id);
                self.quotient(da, below)
            }
            Function::Exp => self.product(id, da),
            Function::Ln => self.quotient(da, a),
            Function::Abs => {
                let sign = self.call(Function::Sign, a);
                self.product(sign, da)
            }
            Function::Sign => self.constant(0.0),
            Function::Tanh => {
                let square = self.square(id);
                let factor = self.difference(one, square);
                self.product(factor, da)
            }
        }
    }
}
