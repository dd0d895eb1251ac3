//! Where an expression can become infinite or jump.

use super::{Function, Id, Node, Pool, Var};
use std::collections::HashSet;

impl Pool {
    /// What an expression is divided by and may be zero at some time: each once.
    pub(crate) fn divisors(&mut self, id: Id) -> Vec<Id> {
        let mut found = Vec::new();
        for own in self.parts(id) {
            match self.node(own) {
                Node::Quotient(_, below) => found.push(below),
                Node::Call(Function::Tan, x) => found.push(self.call(Function::Cos, x)),
                _ => {}
            }
        }
        found.retain(|below| {
            self.may_vanish(*below) && self.depends(*below, |var| !matches!(var, Var::Parameter(_)))
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whether an expression jumps where a condition in it switches; `min`, `max` and `abs` have kinks alone.
    pub(crate) fn jumps(&self, id: Id) -> bool {
        let is_jump = |own: &Id| matches!(self.node(*own), Node::If(..) | Node::Call(Function::Sign, _));
        self.parts(id).iter().any(is_jump)
    }

    /// Arguments of roots, and of powers with an exponent between 0 and 1: at 0 their slope is infinite.
    pub(crate) fn roots(&self, id: Id) -> Vec<Id> {
        let is_root = |exponent: Id| self.value(exponent).is_some_and(|value| value > 0.0 && value < 1.0);
        let argument = |own: &Id| match self.node(*own) {
            Node::Call(Function::Sqrt, x) => Some(x),
            Node::Power(x, exponent) if is_root(exponent) => Some(x),
            _ => None,
        };
        self.parts(id).iter().filter_map(argument).collect()
    }

    /// An expression and all that it is made of.
    pub(crate) fn parts(&self, id: Id) -> Vec<Id> {
        let (mut seen, mut left, mut found) = (HashSet::from([id]), vec![id], Vec::new());
        while let Some(own) = left.pop() {
            found.push(own);
            left.extend(self.operands(own).filter(|operand| seen.insert(*operand)));
        }
        found
    }

    /// Whether an expression changes its sign at some place, as far as its form tells: roots and exponentials do not.
    fn may_vanish(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Constant(_) | Node::Var(Var::Parameter(_)) => false,
            Node::Call(Function::Sqrt | Function::Exp | Function::Abs, _) => false,
            Node::Negative(a) | Node::Quotient(a, _) | Node::Power(a, _) => self.may_vanish(a),
            Node::Product(a, b) => self.may_vanish(a) || self.may_vanish(b),
            _ => true,
        }
    }
}
