//! Expressions compiled once to a flat list of operations, those of one kind side by side: a loop over sums costs a fraction of as many
//! choices of what to do next.

use crate::expression::{Function, Id, Node, Pool, Var};
use crate::run::held::{Held, Switches};
use std::collections::{HashMap, HashSet};

/// One operation on places of the tape.
#[derive(Debug, Clone, Copy)]
enum Operation {
    Constant(f64),
    Input(u32),
    Negative(u32),
    Sum(u32, u32),
    Difference(u32, u32),
    Product(u32, u32),
    /// The product of the first two, added to the third.
    SumOfProduct(u32, u32, u32),
    /// The product of the first two, taken from the third.
    LessProduct(u32, u32, u32),
    Quotient(u32, u32),
    Square(u32),
    Power(u32, u32),
    Call(Function, u32),
    Atan2(u32, u32),
    /// The second where the switch is on, else the third.
    Choice(u32, u32, u32),
    /// 1 or -1 by a switch, between them while it sticks.
    Sign(u32),
    /// A curve or its derivative, within the window of a slot.
    Curve {
        slot: u32,
        at: u32,
        derivative: u8,
    },
}

/// Operations of one kind that need nothing of one another: they are run in one loop without a choice inside.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    kind: Kind,
    /// Number of operations.
    count: usize,
}

/// What an operation does, without its operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Negative,
    Sum,
    Difference,
    Product,
    SumOfProduct,
    LessProduct,
    Quotient,
    Square,
    Power,
    Call(Function),
    Atan2,
    Choice,
    Sign,
    Curve(u8),
}

/// A compiled list of expressions: inputs and constants, then stretches of operations.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tape {
    constants: Vec<f64>,
    /// Inputs before the constants.
    inputs: usize,
    stretches: Vec<Stretch>,
    /// Places of the operands of each operation, in the order of the stretches.
    operands: Operands,
    outputs: Vec<u32>,
    /// Places of inputs that are read, rising.
    read: Vec<u32>,
}

/// Place of an operand.
trait Place: Copy {
    fn index(self) -> usize;
}

impl Place for u16 {
    fn index(self) -> usize {
        usize::from(self)
    }
}

impl Place for u32 {
    fn index(self) -> usize {
        self as usize
    }
}

/// Places of operands: narrow ones where all fit, for those of an engine then stay in the fastest memory beside its values.
#[derive(Debug, Clone)]
enum Operands {
    Narrow(Vec<[u16; 3]>),
    Wide(Vec<[u32; 3]>),
}

impl Default for Operands {
    fn default() -> Operands {
        Operands::Wide(Vec::new())
    }
}

impl Operands {
    fn new(places: Vec<[u32; 3]>) -> Operands {
        let narrow = places.iter().map(|own| {
            let [a, b, c] = own.map(u16::try_from);
            Some([a.ok()?, b.ok()?, c.ok()?])
        });
        match narrow.collect() {
            Some(narrow) => Operands::Narrow(narrow),
            None => Operands::Wide(places),
        }
    }

    fn len(&self) -> usize {
        match self {
            Operands::Narrow(all) => all.len(),
            Operands::Wide(all) => all.len(),
        }
    }
}

/// Operations in the order in which they are found.
#[derive(Debug, Default)]
struct Found {
    operations: Vec<Operation>,
}

impl Found {
    fn push(&mut self, operation: Operation) -> u32 {
        self.operations.push(operation);
        self.operations.len() as u32 - 1
    }
}

impl Tape {
    /// Compiles expressions; `input` gives the place of each variable among the inputs.
    pub(crate) fn new(
        pool: &mut Pool,
        outputs: &[Id],
        input: &impl Fn(Var) -> u32,
        switches: &mut Switches,
    ) -> Tape {
        let (order, uses) = reachable(pool, outputs);
        let joined = joined(pool, &order, &uses);
        let mut tape = Found::default();
        let mut places: HashMap<Id, u32> = HashMap::new();
        for id in order {
            let join = joined.get(&id).copied();
            if matches!(join, Some(Join::Within)) {
                continue;
            }
            let at = |id: Id| places[&id];
            let operation = match (join, pool.node(id)) {
                (Some(Join::Difference(a, b)), _) => Operation::Difference(at(a), at(b)),
                (Some(Join::SumOfProduct(a, b, c)), _) => Operation::SumOfProduct(at(a), at(b), at(c)),
                (Some(Join::LessProduct(a, b, c)), _) => Operation::LessProduct(at(a), at(b), at(c)),
                (_, node) => match node {
                    Node::Constant(bits) => Operation::Constant(f64::from_bits(bits)),
                    Node::Var(var) => Operation::Input(input(var)),
                    Node::Negative(a) => Operation::Negative(at(a)),
                    Node::Sum(a, b) => Operation::Sum(at(a), at(b)),
                    Node::Product(a, b) => Operation::Product(at(a), at(b)),
                    Node::Quotient(a, b) => Operation::Quotient(at(a), at(b)),
                    Node::Power(a, b) if pool.value(b) == Some(2.0) => Operation::Square(at(a)),
                    Node::Power(a, b) => Operation::Power(at(a), at(b)),
                    Node::Call(Function::Sign, a) => Operation::Sign(switches.of_sign(a)),
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
                },
            };
            let place = tape.push(operation);
            places.insert(id, place);
        }
        let outputs: Vec<u32> = outputs.iter().map(|id| places[id]).collect();
        Tape::arrange(&tape.operations, &outputs)
    }

    /// Puts operations of one kind together, as many as are ready at a time.
    fn arrange(operations: &[Operation], outputs: &[u32]) -> Tape {
        let mut tape = Tape::default();
        let mut read: Vec<u32> = operations
            .iter()
            .filter_map(|operation| match operation {
                Operation::Input(input) => Some(*input),
                _ => None,
            })
            .collect();
        read.sort_unstable();
        read.dedup();
        tape.inputs = read.last().map_or(0, |last| *last as usize + 1);
        tape.read = read;
        // Where each operation's value stands; operands that are missing; who waits for whom.
        let mut places = vec![0u32; operations.len()];
        let mut missing = vec![0u8; operations.len()];
        let mut waiting: Vec<Vec<u32>> = vec![Vec::new(); operations.len()];
        let mut ready: Vec<(Kind, Vec<u32>)> = Vec::new();
        let is_leaf =
            |place: u32| matches!(operations[place as usize], Operation::Input(_) | Operation::Constant(_));
        let add = |ready: &mut Vec<(Kind, Vec<u32>)>, kind: Kind, index: u32| match ready
            .iter_mut()
            .find(|(known, _)| *known == kind)
        {
            Some((_, list)) => list.push(index),
            None => ready.push((kind, vec![index])),
        };
        for (index, operation) in operations.iter().enumerate() {
            match *operation {
                Operation::Input(input) => places[index] = input,
                Operation::Constant(value) => {
                    places[index] = (tape.inputs + tape.constants.len()) as u32;
                    tape.constants.push(value);
                }
                operation => {
                    let (kind, operands, count) = operation.parts();
                    for operand in &operands[..count] {
                        if !is_leaf(*operand) {
                            missing[index] += 1;
                            waiting[*operand as usize].push(index as u32);
                        }
                    }
                    if missing[index] == 0 {
                        add(&mut ready, kind, index as u32);
                    }
                }
            }
        }
        let mut next = (tape.inputs + tape.constants.len()) as u32;
        let mut all = Vec::new();
        loop {
            let longest = (0..ready.len()).max_by_key(|index| ready[*index].1.len());
            let Some((kind, list)) = longest.map(|index| ready.swap_remove(index)) else { break };
            tape.stretches.push(Stretch { kind, count: list.len() });
            for index in &list {
                places[*index as usize] = next;
                next += 1;
                let operation = operations[*index as usize];
                let (_, operands, count) = operation.parts();
                let mut own = [0; 3];
                for (own, operand) in own.iter_mut().zip(&operands[..count]) {
                    *own = places[*operand as usize];
                }
                // What is no operand: a switch or the slot of a curve.
                match operation {
                    Operation::Choice(switch, ..) => own[2] = switch,
                    Operation::Sign(switch) => own[2] = switch,
                    Operation::Curve { slot, .. } => own[2] = slot,
                    _ => {}
                }
                all.push(own);
            }
            for index in list {
                for other in std::mem::take(&mut waiting[index as usize]) {
                    missing[other as usize] -= 1;
                    if missing[other as usize] == 0 {
                        add(&mut ready, operations[other as usize].parts().0, other);
                    }
                }
            }
        }
        tape.operands = Operands::new(all);
        tape.outputs = outputs.iter().map(|place| places[*place as usize]).collect();
        tape
    }

    /// Whether it reads an input at a place or behind it.
    pub(crate) fn reads_from(&self, place: usize) -> bool {
        self.read.last().is_some_and(|last| *last as usize >= place)
    }

    /// Values of the outputs; `work` keeps its room from call to call.
    pub(crate) fn run(&self, inputs: &[f64], held: &Held, work: &mut Vec<f64>, outputs: &mut [f64]) {
        let first = self.inputs + self.constants.len();
        work.resize(first + self.operands.len(), 0.0);
        work[..self.inputs].copy_from_slice(&inputs[..self.inputs]);
        work[self.inputs..first].copy_from_slice(&self.constants);
        match &self.operands {
            Operands::Narrow(operands) => self.operate(operands, held, first, work),
            Operands::Wide(operands) => self.operate(operands, held, first, work),
        }
        for (output, place) in outputs.iter_mut().zip(&self.outputs) {
            *output = work[*place as usize];
        }
    }

    /// Runs all operations; their values stand from `first` on.
    fn operate<P: Place>(&self, operands: &[[P; 3]], held: &Held, first: usize, work: &mut [f64]) {
        let mut at = 0;
        for Stretch { kind, count } in &self.stretches {
            let (done, rest) = work.split_at_mut(first + at);
            let values = rest[..*count].iter_mut().zip(&operands[at..at + count]);
            let of = |place: P| done[place.index()];
            match *kind {
                Kind::Negative => values.for_each(|(value, [a, ..])| *value = -of(*a)),
                Kind::Sum => values.for_each(|(value, [a, b, _])| *value = of(*a) + of(*b)),
                Kind::Difference => values.for_each(|(value, [a, b, _])| *value = of(*a) - of(*b)),
                Kind::Product => values.for_each(|(value, [a, b, _])| *value = of(*a) * of(*b)),
                Kind::SumOfProduct => {
                    values.for_each(|(value, [a, b, c])| *value = of(*c) + of(*a) * of(*b));
                }
                Kind::LessProduct => {
                    values.for_each(|(value, [a, b, c])| *value = of(*c) - of(*a) * of(*b));
                }
                Kind::Quotient => values.for_each(|(value, [a, b, _])| *value = of(*a) / of(*b)),
                Kind::Square => values.for_each(|(value, [a, ..])| *value = of(*a) * of(*a)),
                Kind::Power => values.for_each(|(value, [a, b, _])| *value = of(*a).powf(of(*b))),
                Kind::Call(function) => {
                    values.for_each(|(value, [a, ..])| *value = function.apply(of(*a)));
                }
                Kind::Atan2 => values.for_each(|(value, [a, b, _])| *value = of(*a).atan2(of(*b))),
                Kind::Choice => values.for_each(|(value, [a, b, switch])| {
                    *value = of(if held.on[switch.index()] { *a } else { *b });
                }),
                Kind::Sign => values.for_each(|(value, [.., switch])| {
                    *value = held.signs[switch.index()];
                }),
                Kind::Curve(derivative) => values.for_each(|(value, [a, _, slot])| {
                    *value = held.curve(slot.index() as u32, of(*a), derivative);
                }),
            }
            at += count;
        }
    }

    /// Number of operations.
    pub(crate) fn len(&self) -> usize {
        self.operands.len()
    }
}

impl Operation {
    /// Its kind, its operands and how many these are.
    fn parts(self) -> (Kind, [u32; 3], usize) {
        match self {
            // Leaves are put down before anything else: their kind is never asked for.
            Operation::Constant(_) | Operation::Input(_) => (Kind::Negative, [0; 3], 0),
            Operation::Negative(a) => (Kind::Negative, [a, 0, 0], 1),
            Operation::Sum(a, b) => (Kind::Sum, [a, b, 0], 2),
            Operation::Difference(a, b) => (Kind::Difference, [a, b, 0], 2),
            Operation::Product(a, b) => (Kind::Product, [a, b, 0], 2),
            Operation::SumOfProduct(a, b, c) => (Kind::SumOfProduct, [a, b, c], 3),
            Operation::LessProduct(a, b, c) => (Kind::LessProduct, [a, b, c], 3),
            Operation::Quotient(a, b) => (Kind::Quotient, [a, b, 0], 2),
            Operation::Square(a) => (Kind::Square, [a, 0, 0], 1),
            Operation::Power(a, b) => (Kind::Power, [a, b, 0], 2),
            Operation::Call(function, a) => (Kind::Call(function), [a, 0, 0], 1),
            Operation::Atan2(a, b) => (Kind::Atan2, [a, b, 0], 2),
            Operation::Choice(_, a, b) => (Kind::Choice, [a, b, 0], 2),
            Operation::Sign(_) => (Kind::Sign, [0; 3], 0),
            Operation::Curve { at, derivative, .. } => (Kind::Curve(derivative), [at, 0, 0], 1),
        }
    }
}

/// How a sum is put together with what it alone needs.
#[derive(Debug, Clone, Copy)]
enum Join {
    /// A part of another operation.
    Within,
    Difference(Id, Id),
    SumOfProduct(Id, Id, Id),
    LessProduct(Id, Id, Id),
}

/// All expressions that some need, operands first, and how often each is needed.
fn reachable(pool: &Pool, outputs: &[Id]) -> (Vec<Id>, HashMap<Id, u32>) {
    let mut order = Vec::new();
    let mut uses: HashMap<Id, u32> = HashMap::new();
    let mut done: HashSet<Id> = HashSet::new();
    for output in outputs {
        *uses.entry(*output).or_default() += 1;
        let mut stack = vec![(*output, false)];
        while let Some((id, ready)) = stack.pop() {
            if ready {
                if done.insert(id) {
                    order.push(id);
                    pool.operands(id).for_each(|operand| *uses.entry(operand).or_default() += 1);
                }
            } else if !done.contains(&id) {
                stack.push((id, true));
                stack.extend(pool.operands(id).map(|operand| (operand, false)));
            }
        }
    }
    (order, uses)
}

/// Sums that take a product or a negative of no other use into themselves.
fn joined(pool: &Pool, order: &[Id], uses: &HashMap<Id, u32>) -> HashMap<Id, Join> {
    let once = |id: Id| uses.get(&id) == Some(&1);
    let product = |id: Id| match pool.node(id) {
        Node::Product(x, y) if once(id) => Some((x, y)),
        _ => None,
    };
    let negative = |id: Id| match pool.node(id) {
        Node::Negative(x) if once(id) => Some(x),
        _ => None,
    };
    let mut found = HashMap::new();
    for id in order {
        let Node::Sum(a, b) = pool.node(*id) else { continue };
        if a == b {
            continue;
        }
        let join = [(a, b), (b, a)].into_iter().find_map(|(rest, part)| {
            if let Some((x, y)) = product(part) {
                return Some((Join::SumOfProduct(x, y, rest), part, None));
            }
            let inner = negative(part)?;
            Some(match product(inner) {
                Some((x, y)) => (Join::LessProduct(x, y, rest), part, Some(inner)),
                None => (Join::Difference(rest, inner), part, None),
            })
        });
        if let Some((join, part, inner)) = join {
            found.insert(*id, join);
            found.insert(part, Join::Within);
            inner.map(|inner| found.insert(inner, Join::Within));
        }
    }
    found
}
