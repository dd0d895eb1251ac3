//! State equations by causality: every variable of every bond as an expression in states, time and unknowns.

use crate::causality::{Causality, Preference, causality};
use crate::expression::{Id, Node, Pool, Var};
use crate::graph::{Graph, Kind, Law};
use crate::mistake::Mistakes;
use crate::unit::Unit;
use lanchester_diagnostic::Diagnostic;
use std::collections::HashMap;

/// Unknowns beyond this number are not eliminated by symbols but solved at every evaluation.
const MOST_ELIMINATED: usize = 4;

/// Difference of two starts of one store that counts as rounding, as a share.
const SAME_START: f64 = 1e-6;

/// A state: momentum or displacement of a store, or a signal.
#[derive(Debug, Clone)]
pub(crate) struct State {
    pub(crate) name: String,
    /// What it is called as a variable: `crank.momentum`.
    pub(crate) symbol: String,
    pub(crate) unit: Unit,
    pub(crate) unit_name: String,
    pub(crate) start: f64,
    /// Its rate in states, time and unknowns.
    pub(crate) rate: Id,
}

/// A variable that the states do not give directly.
#[derive(Debug, Clone)]
pub(crate) struct Unknown {
    pub(crate) name: String,
    pub(crate) bond: usize,
    pub(crate) what: What,
    /// The expression that it must equal.
    pub(crate) value: Id,
    /// Its closed form, where it was eliminated.
    pub(crate) solved: Option<Id>,
}

/// Why a variable is unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum What {
    /// Rate of a store that follows; the expression is what it holds, by states and time.
    Following(Id),
    /// Cuts an algebraic loop.
    Tear,
}

/// The equations of a graph.
#[derive(Debug, Clone)]
pub struct Equations {
    pub(crate) graph: Graph,
    /// The causality that they follow.
    pub causality: Causality,
    pub(crate) states: Vec<State>,
    pub(crate) unknowns: Vec<Unknown>,
    /// Effort and flow of each bond by states, time and unknowns that were not eliminated.
    pub(crate) efforts: Vec<Id>,
    pub(crate) flows: Vec<Id>,
    pub(crate) signals: Vec<Id>,
    /// What happens where a quantity rises through zero: the quantity, states and their new values.
    pub(crate) rules: Vec<(Id, Vec<(u32, Id)>)>,
    /// What ratios of transformers and gyrators are divided by: element, divisor.
    pub(crate) divisors: Vec<(usize, Id)>,
    /// Mass matrix and right-hand side, where stores follow: M x' = f.
    pub(crate) mass: Option<(Vec<Vec<Id>>, Vec<Id>)>,
}

struct Resolver<'a> {
    graph: &'a Graph,
    pool: Pool,
    strokes: &'a [bool],
    memory: HashMap<Var, Id>,
    busy: Vec<Var>,
    /// States by the variable of the store.
    state_of: HashMap<Var, u32>,
    unknown_of: HashMap<Var, u32>,
    unknowns: Vec<Unknown>,
    expanded: HashMap<Id, Id>,
    mistakes: Mistakes,
}

/// The equations of a graph.
///
/// # Errors
/// Conflicts of causality, and loops or followers that stay singular, each with its elements and a hint.
pub fn equations(graph: &Graph) -> Result<Equations, Vec<Diagnostic>> {
    let causality = causality(graph, Preference::Integral)?;
    let mut resolver = Resolver {
        graph,
        pool: graph.pool.clone(),
        strokes: &causality.stroke_at_head,
        memory: HashMap::new(),
        busy: Vec::new(),
        state_of: HashMap::new(),
        unknown_of: HashMap::new(),
        unknowns: Vec::new(),
        expanded: HashMap::new(),
        mistakes: Mistakes::default(),
    };
    let (mut states, rates) = resolver.states(&causality);
    resolver.followers_and_tears(&causality);
    for (state, rate) in states.iter_mut().zip(rates) {
        state.rate = resolver.expand(rate);
    }
    let count = graph.bonds.len() as u32;
    let mut efforts: Vec<Id> = (0..count).map(|bond| resolver.resolve(Var::Effort(bond))).collect();
    let mut flows: Vec<Id> = (0..count).map(|bond| resolver.resolve(Var::Flow(bond))).collect();
    let mut signals: Vec<Id> =
        (0..graph.signals.len() as u32).map(|signal| resolver.resolve(Var::Signal(signal))).collect();
    let mut rules = resolver.rules();
    let mut divisors = resolver.divisors();
    // Linear loops first: a store may follow through one.
    let mut outputs: Vec<&mut Id> = states.iter_mut().map(|state| &mut state.rate).collect();
    outputs.extend(efforts.iter_mut().chain(&mut flows).chain(&mut signals));
    outputs.extend(of_rules(&mut rules));
    outputs.extend(divisors.iter_mut().map(|(_, divisor)| divisor));
    resolver.eliminate(&mut outputs, true);
    drop(outputs);
    resolver.follow(&states);
    let mass = resolver.mass(&states);
    let mut outputs: Vec<&mut Id> = states.iter_mut().map(|state| &mut state.rate).collect();
    outputs.extend(efforts.iter_mut().chain(&mut flows).chain(&mut signals));
    outputs.extend(of_rules(&mut rules));
    outputs.extend(divisors.iter_mut().map(|(_, divisor)| divisor));
    resolver.eliminate(&mut outputs, false);
    resolver.starts_of_followers(&states);
    let Resolver { pool, unknowns, mistakes, .. } = resolver;
    if mistakes.any() {
        return Err(mistakes.into_diagnostics(&graph.source));
    }
    let mut graph = graph.clone();
    graph.pool = pool;
    Ok(Equations { graph, causality, states, unknowns, efforts, flows, signals, rules, divisors, mass })
}

/// All expressions of events.
fn of_rules(rules: &mut [(Id, Vec<(u32, Id)>)]) -> impl Iterator<Item = &mut Id> {
    rules
        .iter_mut()
        .flat_map(|(when, set)| std::iter::once(when).chain(set.iter_mut().map(|(_, value)| value)))
}

impl Resolver<'_> {
    /// What the ratios of transformers and gyrators are divided by.
    fn divisors(&mut self) -> Vec<(usize, Id)> {
        let graph = self.graph;
        let mut found = Vec::new();
        for (index, element) in graph.elements.iter().enumerate() {
            let ratios: Vec<Id> = match &element.law {
                Law::Ratio(ratio) => vec![*ratio],
                Law::Matrix(rows) => rows.iter().flatten().copied().collect(),
                _ => continue,
            };
            for ratio in ratios {
                let ratio = self.expand(ratio);
                for divisor in self.pool.divisors(ratio) {
                    if !found.contains(&(index, divisor)) {
                        found.push((index, divisor));
                    }
                }
            }
        }
        found
    }

    /// Notes stores that follow and are given another start than that of what they follow.
    fn starts_of_followers(&mut self, states: &[State]) {
        let graph = self.graph;
        for unknown in &self.unknowns {
            let What::Following(held) = unknown.what else { continue };
            let element = &graph.elements[graph.bonds[unknown.bond].to];
            let Law::Store(ports) = &element.law else { continue };
            let port = element.ports.iter().position(|bond| *bond == unknown.bond).unwrap_or(0);
            let [displacement, momentum] = ports[port].start;
            let given = if element.kind == Kind::C { displacement } else { momentum };
            let found = self.pool.evaluate(held, &|var| match var {
                Var::State(state) => states[state as usize].start,
                Var::Parameter(index) => graph.parameters[index as usize].value,
                Var::Time => 0.0,
                _ => f64::NAN,
            });
            if given != 0.0 && (given - found).abs() > SAME_START * given.abs().max(found.abs()) {
                let name = &element.name;
                let unit = graph.bonds[unknown.bond].domain.unit_names()
                    [if element.kind == Kind::C { 2 } else { 3 }];
                let message = format!(
                    "`{name}` follows other stores, which start it with {found} {unit}, but is given {given} {unit}"
                );
                let hint = "take its start out, change theirs, or put a resistor between";
                self.mistakes.push("E1714", &element.span, message, hint);
            }
        }
    }

    /// Events by states.
    fn rules(&mut self) -> Vec<(Id, Vec<(u32, Id)>)> {
        let graph = self.graph;
        let mut rules = Vec::new();
        for rule in &graph.rules {
            let when = self.expand(rule.when);
            let mut set = Vec::new();
            for (var, value) in &rule.set {
                let value = self.expand(*value);
                match self.state_of.get(var) {
                    Some(state) => set.push((*state, value)),
                    None => {
                        let message = "the event sets a store that follows others";
                        let hint = "set the store that it follows";
                        self.mistakes.push("E1714", &rule.span, message, hint);
                    }
                }
            }
            rules.push((when, set));
        }
        rules
    }

    /// The states, and their rates in the variables of the bonds.
    fn states(&mut self, causality: &Causality) -> (Vec<State>, Vec<Id>) {
        let (mut states, mut rates): (Vec<State>, Vec<Id>) = (Vec::new(), Vec::new());
        let graph = self.graph;
        let zero = self.pool.constant(0.0);
        for element in &graph.elements {
            let Law::Store(ports) = &element.law else { continue };
            for (port, law) in ports.iter().enumerate() {
                let bond = element.ports[port];
                if causality.following_bonds.contains(&bond) {
                    continue;
                }
                let number = bond as u32;
                let domain = graph.bonds[bond].domain;
                let units = domain.unit_names();
                let name = graph.bond_name(bond);
                let mut add = |var: Var, what: &str, unit: Unit, unit_name: &str, start: f64, rate: Id| {
                    self.state_of.insert(var, states.len() as u32);
                    states.push(State {
                        name: name.clone(),
                        symbol: format!("{name}.{what}"),
                        unit: unit.times(Unit::SECOND),
                        unit_name: unit_name.to_owned(),
                        start,
                        rate: zero,
                    });
                    rates.push(rate);
                };
                let (effort, flow) = (Var::Effort(number), Var::Flow(number));
                let (effort, flow) = (self.pool.var(effort), self.pool.var(flow));
                if law.flow.is_some() {
                    let rate = match law.effort {
                        Some(spring) => self.pool.difference(effort, spring),
                        None => effort,
                    };
                    add(Var::Momentum(number), "momentum", domain.effort(), units[3], law.start[1], rate);
                }
                if law.effort.is_some() {
                    let rate = match law.gain {
                        Some(gain) => self.pool.sum(flow, gain),
                        None => flow,
                    };
                    add(
                        Var::Displacement(number),
                        "displacement",
                        domain.flow(),
                        units[2],
                        law.start[0],
                        rate,
                    );
                }
            }
        }
        for (index, signal) in graph.signals.iter().enumerate() {
            let Some(start) = signal.start else { continue };
            self.state_of.insert(Var::Signal(index as u32), states.len() as u32);
            states.push(State {
                name: signal.name.clone(),
                symbol: signal.name.clone(),
                unit: signal.unit,
                unit_name: signal.unit.to_string(),
                start,
                rate: zero,
            });
            rates.push(signal.value);
        }
        (states, rates)
    }

    /// Unknowns that causality announces: rates of followers, outputs of free resistors.
    fn followers_and_tears(&mut self, causality: &Causality) {
        let graph = self.graph;
        for bond in &causality.following_bonds {
            let number = *bond as u32;
            let element = graph.bonds[*bond].to;
            let capacitor = graph.elements[element].kind == Kind::C;
            let var = if capacitor { Var::Flow(number) } else { Var::Effort(number) };
            let name = format!("{}.{}", graph.bond_name(*bond), if capacitor { "flow" } else { "effort" });
            self.unknown(var, name, *bond, true);
        }
        for cut in &causality.cuts {
            let (name, bond) = self.named(*cut);
            self.unknown(*cut, name, bond, false);
        }
        let mut known: Vec<(Var, u32)> = self.unknown_of.iter().map(|(var, index)| (*var, *index)).collect();
        known.sort_by_key(|(_, index)| *index);
        for (var, index) in known {
            let index = index as usize;
            let bond = self.unknowns[index].bond;
            if let What::Following(_) = self.unknowns[index].what {
                let element = &graph.elements[graph.bonds[bond].to];
                let Law::Store(ports) = &element.law else { continue };
                let port = element.ports.iter().position(|b| *b == bond).unwrap_or(0);
                if let Some(inverse) = ports[port].inverse {
                    let held = self.expand(inverse);
                    self.unknowns[index].what = What::Following(held);
                }
            } else {
                self.unknowns[index].value = self.computed(var);
            }
        }
    }

    fn unknown(&mut self, var: Var, name: String, bond: usize, following: bool) -> Id {
        let zero = self.pool.constant(0.0);
        let index = self.unknowns.len() as u32;
        let what = if following { What::Following(zero) } else { What::Tear };
        self.unknowns.push(Unknown { name, bond, what, value: zero, solved: None });
        self.unknown_of.insert(var, index);
        self.pool.var(Var::Unknown(index))
    }

    /// An expression in variables of bonds to one in states, time and unknowns.
    fn expand(&mut self, id: Id) -> Id {
        if let Some(done) = self.expanded.get(&id) {
            return *done;
        }
        let new = match self.pool.node(id) {
            Node::Var(Var::Time | Var::Parameter(_) | Var::State(_) | Var::Unknown(_) | Var::Named(_))
            | Node::Constant(_) => id,
            Node::Var(var) => self.resolve(var),
            _ => {
                let operands: Vec<Id> = self.pool.operands(id).collect();
                let new: HashMap<Id, Id> =
                    operands.into_iter().map(|operand| (operand, self.expand(operand))).collect();
                self.pool.with_operands(id, |_, operand| new[&operand])
            }
        };
        self.expanded.insert(id, new);
        new
    }

    /// A variable by states, time and unknowns.
    fn resolve(&mut self, var: Var) -> Id {
        if let Some(state) = self.state_of.get(&var) {
            let state = *state;
            return self.pool.var(Var::State(state));
        }
        if let Some(index) = self.unknown_of.get(&var) {
            let index = *index;
            return self.pool.var(Var::Unknown(index));
        }
        if let Some(id) = self.memory.get(&var) {
            return *id;
        }
        if self.busy.contains(&var) {
            // A loop that causality alone does not show: this variable cuts it.
            let (name, bond) = self.named(var);
            return self.unknown(var, name, bond, false);
        }
        self.busy.push(var);
        let id = self.computed(var);
        self.busy.pop();
        if let Some(index) = self.unknown_of.get(&var) {
            let index = *index as usize;
            self.unknowns[index].value = id;
            return self.pool.var(Var::Unknown(index as u32));
        }
        self.memory.insert(var, id);
        id
    }

    fn named(&self, var: Var) -> (String, usize) {
        match var {
            Var::Effort(bond) => (format!("{}.effort", self.graph.bond_name(bond as usize)), bond as usize),
            Var::Flow(bond) => (format!("{}.flow", self.graph.bond_name(bond as usize)), bond as usize),
            Var::Signal(signal) => (self.graph.signals[signal as usize].name.clone(), 0),
            _ => ("a store".to_owned(), 0),
        }
    }

    /// A variable by the law of the element that sets it.
    fn computed(&mut self, var: Var) -> Id {
        let graph = self.graph;
        let (bond, wants_effort) = match var {
            Var::Effort(bond) => (bond as usize, true),
            Var::Flow(bond) => (bond as usize, false),
            Var::Signal(signal) => return self.expand(graph.signals[signal as usize].value),
            Var::Displacement(bond) | Var::Momentum(bond) => return self.held(bond as usize),
            _ => return self.pool.var(var),
        };
        // The stroke stands where the effort arrives: the other end sets it.
        let ends = &graph.bonds[bond];
        let setter = if wants_effort == self.strokes[bond] { ends.from } else { ends.to };
        let element = &graph.elements[setter];
        let port = element.ports.iter().position(|b| *b == bond).unwrap_or(0);
        match &element.law {
            Law::Source(value) => self.expand(*value),
            Law::Resistor { effort, flow } => {
                let law = if wants_effort { *effort } else { *flow };
                let law = law.unwrap_or_else(|| self.pool.constant(f64::NAN));
                self.expand(law)
            }
            Law::Resistors { laws, .. } => self.expand(laws[port]),
            Law::Store(ports) => {
                let law = if wants_effort { ports[port].effort } else { ports[port].flow };
                let law = law.unwrap_or_else(|| self.pool.constant(f64::NAN));
                self.expand(law)
            }
            Law::Ratio(ratio) => {
                let ratio = self.expand(*ratio);
                let other = element.ports[1 - port] as u32;
                if element.kind == Kind::TF {
                    // f2 = ratio f1, e1 = ratio e2
                    let there =
                        self.resolve(if wants_effort { Var::Effort(other) } else { Var::Flow(other) });
                    if wants_effort == (port == 0) {
                        self.pool.product(ratio, there)
                    } else {
                        self.pool.quotient(there, ratio)
                    }
                } else {
                    // e1 = ratio f2, e2 = ratio f1
                    let there =
                        self.resolve(if wants_effort { Var::Flow(other) } else { Var::Effort(other) });
                    if wants_effort {
                        self.pool.product(ratio, there)
                    } else {
                        self.pool.quotient(there, ratio)
                    }
                }
            }
            Law::Matrix(rows) => {
                let columns = rows[0].len();
                let mut sum = self.pool.constant(0.0);
                if wants_effort {
                    for (row, entries) in rows.iter().enumerate() {
                        let entry = self.expand(entries[port]);
                        if self.pool.is_zero(entry) {
                            continue;
                        }
                        let there = self.resolve(Var::Effort(element.ports[columns + row] as u32));
                        let term = self.pool.product(entry, there);
                        sum = self.pool.sum(sum, term);
                    }
                } else {
                    for (column, entry) in rows[port - columns].iter().enumerate() {
                        let entry = self.expand(*entry);
                        if self.pool.is_zero(entry) {
                            continue;
                        }
                        let there = self.resolve(Var::Flow(element.ports[column] as u32));
                        let term = self.pool.product(entry, there);
                        sum = self.pool.sum(sum, term);
                    }
                }
                sum
            }
            Law::Junction => self.junction(setter, bond, wants_effort),
        }
    }

    /// What a store that follows holds, by its inverse law.
    fn held(&mut self, bond: usize) -> Id {
        let element = &self.graph.elements[self.graph.bonds[bond].to];
        let port = element.ports.iter().position(|b| *b == bond).unwrap_or(0);
        match &element.law {
            Law::Store(ports) if ports[port].inverse.is_some() => {
                let inverse = ports[port].inverse.unwrap_or(0);
                self.expand(inverse)
            }
            _ => self.pool.constant(f64::NAN),
        }
    }

    /// The common variable from the deciding bond, or the balance of the other.
    fn junction(&mut self, junction: usize, bond: usize, wants_effort: bool) -> Id {
        let element = &self.graph.elements[junction];
        let var = |bond: usize, effort: bool| {
            if effort { Var::Effort(bond as u32) } else { Var::Flow(bond as u32) }
        };
        let common_is_effort = element.kind == Kind::Zero;
        if wants_effort == common_is_effort {
            let deciding = element.ports.iter().copied().find(|other| {
                let at_junction = self.strokes[*other] == (self.graph.bonds[*other].to == junction);
                *other != bond && at_junction == common_is_effort
            });
            return match deciding {
                Some(other) => self.resolve(var(other, wants_effort)),
                None => self.pool.constant(f64::NAN),
            };
        }
        let mut sum = self.pool.constant(0.0);
        let mine = self.graph.bonds[bond].sign_into(junction);
        for other in &element.ports {
            if *other != bond {
                let term = self.resolve(var(*other, wants_effort));
                let sign = -mine * self.graph.bonds[*other].sign_into(junction);
                sum = if sign > 0.0 { self.pool.sum(sum, term) } else { self.pool.difference(sum, term) };
            }
        }
        sum
    }

    /// Replaces an unknown in all expressions at hand.
    fn replace(&mut self, index: u32, by: Id, outputs: &mut [&mut Id]) {
        let mut known = HashMap::new();
        let swap = |var: Var| (var == Var::Unknown(index)).then_some(by);
        for output in outputs.iter_mut() {
            **output = self.pool.substitute(**output, &mut known, &swap);
        }
        for unknown in &mut self.unknowns {
            unknown.value = self.pool.substitute(unknown.value, &mut known, &swap);
            if let What::Following(held) = &mut unknown.what {
                *held = self.pool.substitute(*held, &mut known, &swap);
            }
            if let Some(solved) = &mut unknown.solved {
                *solved = self.pool.substitute(*solved, &mut known, &swap);
            }
        }
    }

    /// The rate of what followers hold: `d/dt phi(x, t)` along the states. Loops that are linear are solved first, because a
    /// follower may hang on one.
    fn follow(&mut self, states: &[State]) {
        let mut by_time = HashMap::new();
        let mut by_state: Vec<HashMap<Id, Id>> = vec![HashMap::new(); states.len()];
        for index in 0..self.unknowns.len() {
            let What::Following(held) = self.unknowns[index].what else { continue };
            let vars = self.pool.variables(&[held]);
            let mut rate = self.pool.derivative(held, Var::Time, &mut by_time);
            for var in vars {
                match var {
                    Var::State(state) => {
                        let slope = self.pool.derivative(held, var, &mut by_state[state as usize]);
                        let term = self.pool.product(slope, states[state as usize].rate);
                        rate = self.pool.sum(rate, term);
                    }
                    Var::Unknown(other) => {
                        let bond = self.unknowns[index].bond;
                        let Unknown { name, .. } = &self.unknowns[other as usize];
                        let place = self.graph.place(self.graph.bonds[bond].to);
                        let message =
                            format!("`{}` follows through an algebraic loop with {name}", place.text);
                        let hint =
                            "put a spring, or an inertia, where it follows, so that it becomes a state";
                        self.mistakes.push("E1714", &place.span, message, hint);
                    }
                    _ => {}
                }
            }
            self.unknowns[index].value = rate;
        }
    }

    /// M and f of `M x' = f`, where stores follow and no loop is left: M = 1 - G Phi, with G the influence of the followers' rates
    /// on the states' rates and Phi the slopes of what they hold.
    fn mass(&mut self, states: &[State]) -> Option<(Vec<Vec<Id>>, Vec<Id>)> {
        let all_follow = self.unknowns.iter().all(|unknown| matches!(unknown.what, What::Following(_)));
        if self.unknowns.is_empty() || !all_follow || states.len() > 12 {
            return None;
        }
        let zero = self.pool.constant(0.0);
        let (mut mass, mut right) = (Vec::new(), Vec::new());
        for (i, state) in states.iter().enumerate() {
            let mut row = vec![zero; states.len()];
            row[i] = self.pool.constant(1.0);
            let mut known = HashMap::new();
            let mut f = self
                .pool
                .substitute(state.rate, &mut known, &|var| matches!(var, Var::Unknown(_)).then_some(zero));
            for index in 0..self.unknowns.len() {
                let What::Following(held) = self.unknowns[index].what else { continue };
                let influence =
                    self.pool.derivative(state.rate, Var::Unknown(index as u32), &mut HashMap::new());
                if self.pool.is_zero(influence) {
                    continue;
                }
                if self.pool.depends(influence, |var| matches!(var, Var::Unknown(_))) {
                    return None;
                }
                for (j, entry) in row.iter_mut().enumerate() {
                    let slope = self.pool.derivative(held, Var::State(j as u32), &mut HashMap::new());
                    // The angle's own rate is known: what it brings goes to the right-hand side.
                    let known_rate = !self.pool.depends(states[j].rate, |var| matches!(var, Var::Unknown(_)));
                    let term = self.pool.product(influence, slope);
                    if known_rate {
                        let term = self.pool.product(term, states[j].rate);
                        f = self.pool.sum(f, term);
                    } else {
                        *entry = self.pool.difference(*entry, term);
                    }
                }
                let direct = self.pool.derivative(held, Var::Time, &mut HashMap::new());
                let term = self.pool.product(influence, direct);
                f = self.pool.sum(f, term);
            }
            mass.push(row);
            right.push(f);
        }
        Some((mass, right))
    }

    /// Solves what is linear and small by symbols, one unknown after the other; what is left is solved at each evaluation.
    fn eliminate(&mut self, outputs: &mut [&mut Id], loops: bool) {
        let of_kind = |unknown: &Unknown| (unknown.what == What::Tear) == loops && unknown.solved.is_none();
        let count = self.unknowns.iter().filter(|unknown| of_kind(unknown)).count();
        if count > MOST_ELIMINATED && !loops {
            // Solved together at each evaluation: what is singular among them shows there.
            return;
        }
        for index in 0..self.unknowns.len() {
            if !of_kind(&self.unknowns[index]) {
                continue;
            }
            let me = Var::Unknown(index as u32);
            let value = self.unknowns[index].value;
            let slope = self.pool.derivative(value, me, &mut HashMap::new());
            let one = self.pool.constant(1.0);
            let rest = self.pool.difference(one, slope);
            if self.pool.is_zero(rest) {
                self.refuse_singular(index);
                continue;
            }
            let linear = !self.pool.depends(slope, |var| var == me);
            if !linear || count > MOST_ELIMINATED {
                continue;
            }
            let zero = self.pool.constant(0.0);
            let without =
                self.pool.substitute(value, &mut HashMap::new(), &|var| (var == me).then_some(zero));
            let solved = self.pool.quotient(without, rest);
            self.replace(index as u32, solved, outputs);
            self.unknowns[index].solved = Some(solved);
        }
    }

    fn refuse_singular(&mut self, index: usize) {
        let Unknown { name, bond, .. } = &self.unknowns[index];
        let place = self.graph.place(self.graph.bonds[*bond].to);
        let message = format!("the algebraic loop through {name} is singular: it holds for any value");
        let hint = "two ideal elements say the same thing: take one out, or put a resistor between";
        self.mistakes.push("E1714", &place.span, message, hint);
    }
}
