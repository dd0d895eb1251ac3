//! Expressions compiled once to a flat list of operations.

use crate::expression::{Function, Id, Node, Pool, Var};
use crate::run::held::{Held, Switches};
use std::collections::HashMap;

/// One operation on places of the tape.
#[derive(Debug, Clone, Copy)]
enum Operation {
    Constant(f64),
    Input(u32),
    Negative(u32),
    Sum(u32, u32),
    Product(u32, u32),
    Quotient(u32, u32),
    Square(u32),
    Power(u32, u32),
    Call(Function, u32),
    Atan2(u32, u32),
    /// The second where the switch is on, else the third.
    Choice(u32, u32, u32),
    /// 1 or -1 by a switch.
    Sign(u32),
    /// A curve or its derivative, within the window of a slot.
    Curve {
        slot: u32,
        at: u32,
        derivative: u8,
    },
}

/// A compiled list of expressions.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tape {
    operations: Vec<Operation>,
    outputs: Vec<u32>,
}

impl Tape {
    /// Compiles expressions; `input` gives the place of each variable among the inputs.
    pub(crate) fn new(
        pool: &mut Pool,
        outputs: &[Id],
        input: &impl Fn(Var) -> u32,
        switches: &mut Switches,
    ) -> Tape {
        let mut tape = Tape::default();
        let mut places: HashMap<Id, u32> = HashMap::new();
        for output in outputs {
            let mut stack = vec![(*output, false)];
            while let Some((id, ready)) = stack.pop() {
                if places.contains_key(&id) {
                    continue;
                }
                if !ready {
                    stack.push((id, true));
                    stack.extend(pool.operands(id).map(|operand| (operand, false)));
                    continue;
                }
                let at = |id: Id| places[&id];
                let operation = match pool.node(id) {
                    Node::Constant(bits) => Operation::Constant(f64::from_bits(bits)),
                    Node::Var(var) => Operation::Input(input(var)),
                    Node::Negative(a) => Operation::Negative(at(a)),
                    Node::Sum(a, b) => Operation::Sum(at(a), at(b)),
                    Node::Product(a, b) => Operation::Product(at(a), at(b)),
                    Node::Quotient(a, b) => Operation::Quotient(at(a), at(b)),
                    Node::Power(a, b) if pool.value(b) == Some(2.0) => Operation::Square(at(a)),
                    Node::Power(a, b) => Operation::Power(at(a), at(b)),
                    Node::Call(Function::Sign, a) => Operation::Sign(switches.of(a)),
                    Node::Call(Function::Abs, a) => {
                        let minus = tape.push(Operation::Negative(at(a)));
                        Operation::Choice(switches.of(a), at(a), minus)
                    }
                    Node::Call(function, a) => Operation::Call(function, at(a)),
                    Node::Atan2(a, b) => Operation::Atan2(at(a), at(b)),
                    Node::Min(a, b) => Operation::Choice(switches.of(pool.difference(b, a)), at(a), at(b)),
                    Node::Max(a, b) => Operation::Choice(switches.of(pool.difference(a, b)), at(a), at(b)),
                    Node::If(g, a, b) => Operation::Choice(switches.of(g), at(a), at(b)),
                    Node::Table(curve, derivative, a) => {
                        Operation::Curve { slot: switches.slot(curve, a), at: at(a), derivative }
                    }
                };
                let place = tape.push(operation);
                places.insert(id, place);
            }
        }
        tape.outputs = outputs.iter().map(|id| places[id]).collect();
        tape
    }

    fn push(&mut self, operation: Operation) -> u32 {
        self.operations.push(operation);
        self.operations.len() as u32 - 1
    }

    /// Values of the outputs; `work` keeps its room from call to call.
    pub(crate) fn run(&self, inputs: &[f64], held: &Held, work: &mut Vec<f64>, outputs: &mut [f64]) {
        work.clear();
        for operation in &self.operations {
            let at = |place: u32| work[place as usize];
            let value = match *operation {
                Operation::Constant(value) => value,
                Operation::Input(input) => inputs[input as usize],
                Operation::Negative(a) => -at(a),
                Operation::Sum(a, b) => at(a) + at(b),
                Operation::Product(a, b) => at(a) * at(b),
                Operation::Quotient(a, b) => at(a) / at(b),
                Operation::Square(a) => at(a) * at(a),
                Operation::Power(a, b) => at(a).powf(at(b)),
                Operation::Call(function, a) => function.apply(at(a)),
                Operation::Atan2(a, b) => at(a).atan2(at(b)),
                Operation::Choice(switch, a, b) => at(if held.on[switch as usize] { a } else { b }),
                Operation::Curve { slot, at: x, derivative } => held.curve(slot, at(x), derivative),
                Operation::Sign(switch) => {
                    if held.on[switch as usize] {
                        1.0
                    } else {
                        -1.0
                    }
                }
            };
            work.push(value);
        }
        for (output, place) in outputs.iter_mut().zip(&self.outputs) {
            *output = work[*place as usize];
        }
    }

    /// Number of operations.
    pub(crate) fn len(&self) -> usize {
        self.operations.len()
    }
}
