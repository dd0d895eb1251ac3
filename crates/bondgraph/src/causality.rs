//! Causality by the sequential procedure.
//!
//! Each bond has one end that sets its effort and another that sets its flow; the causal stroke stands where the effort arrives.
//! Sources come first, then laws that have one form alone, then stores in integral causality in the order of the description, then
//! what is left; after each, junctions and two-ports hand on what follows. Where a choice ends in a conflict that the other choice does
//! not have, the other is taken. Source: Karnopp, Margolis, Rosenberg, *System Dynamics*,
//! 5th edition, section 3.4; van Dijk, Breedveld, Journal of the Franklin Institute 328 (1991), 747-764.

pub(crate) mod loops;

use crate::description::Text;
use crate::expression::Var;
use crate::graph::{Element, Graph, Kind, Law};
use crate::mistake::Mistakes;
use lanchester_diagnostic::Diagnostic;
use loops::{AlgebraicLoop, loops};
use serde::Serialize;

/// Which stores are assigned first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Preference {
    /// Stores become states.
    #[default]
    Integral,
    /// Stores follow: the dual, for study.
    Derivative,
}

/// The causality of a graph, in words and as strokes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Causality {
    /// For each bond: whether the stroke stands at the end that the half arrow points to.
    pub stroke_at_head: Vec<bool>,
    /// The steps of the procedure in words.
    pub steps: Vec<Step>,
    /// Stores in integral causality, by name.
    pub states: Vec<String>,
    /// Stores that follow others.
    pub followers: Vec<Follower>,
    /// Resistors and bonds whose causality was free: each is a sign of an algebraic loop, but loops of junctions, two-ports and signals
    /// have none.
    pub free: Vec<String>,
    /// Algebraic loops.
    pub loops: Vec<AlgebraicLoop>,
    /// Bonds of the ports of stores that follow.
    #[serde(skip)]
    pub(crate) following_bonds: Vec<usize>,
    /// Bonds whose causality was free.
    #[serde(skip)]
    pub(crate) free_bonds: Vec<usize>,
    /// Variables that cut all loops.
    #[serde(skip)]
    pub(crate) cuts: Vec<Var>,
}

/// One step of the procedure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// What was assigned and why.
    pub text: String,
    /// Bonds that were settled by it, the first by choice, the others by what follows.
    pub bonds: Vec<String>,
}

/// A store in derivative causality.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Follower {
    /// Its name.
    pub element: String,
    /// Elements through which it follows, the store or source that leads it first.
    pub path: Vec<String>,
}

#[derive(Clone)]
struct Procedure<'a> {
    graph: &'a Graph,
    /// Whether the stroke is at the head.
    strokes: Vec<Option<bool>>,
    /// Through which element and from which bond a bond was settled.
    causes: Vec<Option<(usize, usize)>>,
    broken: Vec<bool>,
    settled: Vec<usize>,
    mistakes: Mistakes,
    steps: Vec<Step>,
    /// Bonds whose causality was free.
    free: Vec<usize>,
}

/// Assigns causality.
///
/// # Errors
/// Every conflict, with the elements that cause it and what mends it.
pub fn causality(graph: &Graph, preference: Preference) -> Result<Causality, Vec<Diagnostic>> {
    let count = graph.bonds.len();
    let mut procedure = Procedure {
        graph,
        strokes: vec![None; count],
        causes: vec![None; count],
        broken: vec![false; graph.elements.len()],
        settled: Vec::new(),
        mistakes: Mistakes::default(),
        steps: Vec::new(),
        free: Vec::new(),
    };
    procedure.forced();
    let procedure = procedure.stores(preference).what_is_free();
    let (mut states, mut followers, mut following_bonds) = (Vec::new(), Vec::new(), Vec::new());
    for (index, element) in graph.elements.iter().enumerate() {
        let Law::Store(ports) = &element.law else { continue };
        for (port, law) in ports.iter().enumerate() {
            let bond = element.ports[port];
            let integral = !law.only_follows() && procedure.at(bond, index) == Some(law.flow.is_some());
            if integral {
                states.push(graph.bond_name(bond));
            } else {
                following_bonds.push(bond);
                followers
                    .push(Follower { element: graph.bond_name(bond), path: procedure.path(bond, index) });
            }
        }
    }
    if procedure.mistakes.any() {
        return Err(procedure.mistakes.into_diagnostics(&graph.source));
    }
    let Procedure { strokes, steps, free: free_bonds, .. } = procedure;
    let stroke_at_head: Vec<bool> = strokes.into_iter().map(|stroke| stroke.unwrap_or(true)).collect();
    let (loops, cuts) = loops(graph, &stroke_at_head, &following_bonds, &free_bonds);
    Ok(Causality {
        stroke_at_head,
        steps,
        states,
        followers,
        free: free_bonds.iter().map(|bond| graph.bond_name(*bond)).collect(),
        loops,
        following_bonds,
        free_bonds,
        cuts,
    })
}

/// Choices that are tried where a bond is free, before the conflict is told.
const MOST_TRIES: usize = 500;

impl Procedure<'_> {
    /// Sources, and laws that have one form alone.
    fn forced(&mut self) {
        let graph = self.graph;
        for (index, element) in graph.elements.iter().enumerate() {
            match element.kind {
                Kind::Se => self.assign(index, 0, false, "is a source of effort"),
                Kind::Sf => self.assign(index, 0, true, "is a source of flow"),
                _ => {}
            }
        }
        for (index, element) in graph.elements.iter().enumerate() {
            match &element.law {
                Law::Resistor { effort: None, .. } => {
                    self.assign(index, 0, true, "gives its flow by its effort alone");
                }
                Law::Resistor { flow: None, .. } => {
                    self.assign(index, 0, false, "gives its effort by its flow alone");
                }
                Law::Resistors { gives_flows, laws } => {
                    let what = if *gives_flows {
                        "gives its flows by its efforts"
                    } else {
                        "gives its efforts by its flows"
                    };
                    for port in 0..laws.len() {
                        self.assign(index, port, *gives_flows, what);
                    }
                }
                Law::Matrix(rows) => {
                    let columns = rows[0].len();
                    for port in 0..columns + rows.len() {
                        let what = "multiplies flows by its matrix, efforts by the transposed";
                        self.assign(index, port, port >= columns, what);
                    }
                }
                Law::Store(ports) => {
                    for (port, law) in ports.iter().enumerate() {
                        if law.only_follows() {
                            let what = "gives its momenta by its flows alone";
                            self.assign(index, port, false, what);
                        } else if law.inverse.is_none() {
                            let what = "has a law that cannot be turned round";
                            self.assign(index, port, law.flow.is_some(), what);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// Stores in the preferred causality, in the other where that alone is free of conflict.
    fn stores(mut self, preference: Preference) -> Self {
        let integral = preference == Preference::Integral;
        let [what, instead] = if integral {
            ["becomes a state", "cannot be a state without a conflict, and follows"]
        } else {
            ["is made to follow", "cannot follow without a conflict, and becomes a state"]
        };
        let graph = self.graph;
        for (index, element) in graph.elements.iter().enumerate() {
            let Law::Store(ports) = &element.law else { continue };
            for (port, law) in ports.iter().enumerate() {
                if law.inverse.is_none() || self.strokes[element.ports[port]].is_some() {
                    continue;
                }
                let stroke_here = law.flow.is_some() == integral;
                let before = self.clone();
                self.assign(index, port, stroke_here, what);
                if self.mistakes.count() > before.mistakes.count() {
                    let count = before.mistakes.count();
                    let mut other = before;
                    other.assign(index, port, !stroke_here, instead);
                    if other.mistakes.count() == count {
                        self = other;
                    }
                }
            }
        }
        self
    }

    /// Resistors and bonds that nothing has settled: the first choice, and where it ends in a conflict the others.
    fn what_is_free(self) -> Self {
        let count = self.mistakes.count();
        let mut first = self.clone();
        while let Some(choice) = first.next_free() {
            first.pick(choice, false);
        }
        first.hand_on_all();
        if first.mistakes.count() == count {
            return first;
        }
        let mut waiting = vec![self];
        for _ in 0..MOST_TRIES {
            let Some(mut at) = waiting.pop() else { break };
            let Some(choice) = at.next_free() else {
                at.hand_on_all();
                if at.mistakes.count() == count {
                    return at;
                }
                continue;
            };
            for other in [true, false] {
                let mut next = at.clone();
                next.pick(choice, other);
                if next.mistakes.count() == count {
                    waiting.push(next);
                }
            }
        }
        first
    }

    /// The next resistor, or bond, that nothing has settled: element and port.
    fn next_free(&self) -> Option<(usize, usize)> {
        let graph = self.graph;
        let is_free = |element: &Element| {
            matches!(element.law, Law::Resistor { .. }) && self.strokes[element.ports[0]].is_none()
        };
        if let Some(element) = graph.elements.iter().position(is_free) {
            return Some((element, 0));
        }
        let bond = self.strokes.iter().position(Option::is_none)?;
        let head = graph.bonds[bond].to;
        Some((head, graph.elements[head].ports.iter().position(|own| *own == bond).unwrap_or(0)))
    }

    /// Settles a free bond by the first choice or the other.
    fn pick(&mut self, (element, port): (usize, usize), other: bool) {
        self.free.push(self.graph.elements[element].ports[port]);
        let is_resistor = matches!(self.graph.elements[element].law, Law::Resistor { .. });
        let why = match (is_resistor, other) {
            (true, false) => "is free: it is given its flow, within an algebraic loop",
            (true, true) => "is free: it is given its effort, within an algebraic loop",
            (false, _) => "has a free bond, within an algebraic loop",
        };
        self.assign(element, port, is_resistor == other, why);
    }

    fn hand_on_all(&mut self) {
        for index in 0..self.graph.elements.len() {
            self.hand_on(index, &mut Vec::new());
        }
    }

    /// Whether the stroke of a bond stands at an element.
    fn at(&self, bond: usize, element: usize) -> Option<bool> {
        self.strokes[bond].map(|at_head| at_head == (self.graph.bonds[bond].to == element))
    }

    /// Settles a bond by choice and what follows; a step, if the bond was not settled before.
    fn assign(&mut self, element: usize, port: usize, stroke_here: bool, why: &str) {
        let bond = self.graph.elements[element].ports[port];
        let name = &self.graph.elements[element].name;
        match self.at(bond, element) {
            Some(here) if here == stroke_here => return,
            Some(_) => return self.refuse_forced(element, bond, stroke_here, why),
            None => {}
        }
        self.settled.clear();
        let mut waiting = Vec::new();
        self.set(bond, element, stroke_here, None, &mut waiting);
        while let Some(next) = waiting.pop() {
            self.hand_on(next, &mut waiting);
        }
        let bonds = self.settled.iter().map(|bond| self.graph.bond_name(*bond)).collect();
        let written = &self.graph.elements[element].written;
        self.steps.push(Step { text: format!("{name} ({written}) {why}"), bonds });
    }

    fn set(
        &mut self,
        bond: usize,
        element: usize,
        stroke_here: bool,
        cause: Option<(usize, usize)>,
        waiting: &mut Vec<usize>,
    ) {
        let ends = &self.graph.bonds[bond];
        self.strokes[bond] = Some(stroke_here == (ends.to == element));
        self.causes[bond] = cause;
        self.settled.push(bond);
        waiting.extend([ends.to, ends.from]);
    }

    /// What an element's settled bonds say of the others.
    fn hand_on(&mut self, element: usize, waiting: &mut Vec<usize>) {
        let graph = self.graph;
        let ports = &graph.elements[element].ports;
        if self.broken[element] {
            return;
        }
        match graph.elements[element].kind {
            Kind::Zero | Kind::One => {
                // The one bond that decides: at a 0 it brings the effort, at a 1 the flow.
                let decides = graph.elements[element].kind == Kind::Zero;
                let deciding: Vec<usize> =
                    ports.iter().copied().filter(|bond| self.at(*bond, element) == Some(decides)).collect();
                let open: Vec<usize> =
                    ports.iter().copied().filter(|bond| self.strokes[*bond].is_none()).collect();
                match (deciding.as_slice(), open.as_slice()) {
                    ([one], open) => {
                        for bond in open {
                            self.set(*bond, element, !decides, Some((element, *one)), waiting);
                        }
                    }
                    ([], [last]) => {
                        let mut others = ports.iter().copied().filter(|bond| bond != last);
                        let cause = others.next_back().map(|bond| (element, bond));
                        self.set(*last, element, decides, cause, waiting);
                    }
                    ([], []) => self.refuse_none(element),
                    ([], _) => {}
                    (several, _) => self.refuse_several(element, several),
                }
            }
            Kind::TF if matches!(graph.elements[element].law, Law::Ratio(_)) => {
                self.two_port(element, ports[0], ports[1], true, waiting);
            }
            Kind::GY => self.two_port(element, ports[0], ports[1], false, waiting),
            _ => {}
        }
    }

    fn two_port(&mut self, element: usize, a: usize, b: usize, turns: bool, waiting: &mut Vec<usize>) {
        match (self.at(a, element), self.at(b, element)) {
            (Some(here), None) => self.set(b, element, here != turns, Some((element, a)), waiting),
            (None, Some(here)) => self.set(a, element, here != turns, Some((element, b)), waiting),
            (Some(first), Some(second)) if (first != second) != turns => {
                self.broken[element] = true;
                let [first, second] = [self.origin(a), self.origin(b)];
                let Text { text, span } = self.graph.place(element);
                let what =
                    if turns { "the same variable at both sides of" } else { "effort and flow across" };
                let message = format!("{first} and {second} both set {what} `{text}`");
                let hint = "take one of them out, or put a spring, inertia or resistor beside it";
                self.mistakes.push("E1713", &span, message, hint);
            }
            _ => {}
        }
    }

    /// The element from which the causality of a bond comes.
    fn origin(&self, bond: usize) -> String {
        let mut at = bond;
        for _ in 0..self.causes.len() {
            match self.causes[at] {
                Some((_, before)) => at = before,
                None => break,
            }
        }
        self.graph.bond_name(at)
    }

    /// Elements from the one that leads to the store that follows.
    fn path(&self, bond: usize, store: usize) -> Vec<String> {
        let mut path = vec![self.graph.elements[store].name.clone()];
        let mut at = bond;
        for _ in 0..self.causes.len() {
            match self.causes[at] {
                Some((element, before)) => {
                    path.push(self.graph.elements[element].name.clone());
                    at = before;
                }
                None => break,
            }
        }
        match self.leaders(at, store) {
            Some((transformer, leaders)) => path.extend([transformer, leaders.join(", ")]),
            None => path.push(self.graph.bond_name(at)),
        }
        path.dedup();
        path.reverse();
        path
    }

    /// What sets the flow of a bond that an element takes: the one-port at the junction beyond it, where there is one.
    fn leader(&self, bond: usize, element: usize) -> String {
        let ends = &self.graph.bonds[bond];
        let beyond = if ends.from == element { ends.to } else { ends.from };
        let junction = &self.graph.elements[beyond];
        let decides = junction.kind == Kind::Zero;
        let deciding = junction.ports.iter().find(|other| {
            junction.is_junction() && **other != bond && self.at(**other, beyond) == Some(decides)
        });
        deciding.map_or_else(|| self.origin(bond), |other| self.graph.bond_name(*other))
    }

    /// The transformer by a matrix behind a bond, and what sets the flows that its row takes.
    fn leaders(&self, bond: usize, store: usize) -> Option<(String, Vec<String>)> {
        let ends = &self.graph.bonds[bond];
        let element = [ends.from, ends.to]
            .into_iter()
            .find(|end| *end != store && matches!(self.graph.elements[*end].law, Law::Matrix(_)))?;
        let Element { name, ports, law: Law::Matrix(rows), .. } = &self.graph.elements[element] else {
            return None;
        };
        let columns = rows[0].len();
        let row = rows.get(ports.iter().position(|port| *port == bond)?.checked_sub(columns)?)?;
        let mut leaders = Vec::new();
        for (entry, port) in row.iter().zip(ports) {
            let leader = self.leader(*port, element);
            if !self.graph.pool.is_zero(*entry) && !leaders.contains(&leader) {
                leaders.push(leader);
            }
        }
        Some((name.clone(), leaders))
    }

    fn refuse_several(&mut self, junction: usize, bonds: &[usize]) {
        self.broken[junction] = true;
        let mut names: Vec<String> = bonds.iter().map(|bond| self.origin(*bond)).collect();
        names.dedup();
        let Text { text, span } = self.graph.place(junction);
        let (what, hint) = match self.graph.elements[junction].kind {
            Kind::One => {
                ("flow", "only one element may set it: take one out, or put a spring (C on a 0) between them")
            }
            _ => (
                "effort",
                "only one element may set it: take one out, or put a resistor or inertia (on a 1) between them",
            ),
        };
        let message = format!("{} both set the {what} of `{text}`", names.join(" and "));
        self.mistakes.push("E1713", &span, message, hint);
    }

    fn refuse_none(&mut self, junction: usize) {
        self.broken[junction] = true;
        let ports = &self.graph.elements[junction].ports;
        let mut names: Vec<String> = ports.iter().map(|bond| self.origin(*bond)).collect();
        names.dedup();
        let Text { text, span } = self.graph.place(junction);
        let (what, given, hint) = match self.graph.elements[junction].kind {
            Kind::One => ("flow", "efforts", "add the inertia or resistor that limits the flow"),
            _ => ("effort", "flows", "add the capacitor or resistor that takes the difference of the flows"),
        };
        let message =
            format!("nothing sets the {what} of `{text}`: {} all set their {given}", names.join(" and "));
        self.mistakes.push("E1713", &span, message, hint);
    }

    fn refuse_forced(&mut self, element: usize, bond: usize, stroke_here: bool, why: &str) {
        let Text { text, span } = self.graph.place(element);
        let given = if stroke_here { "flow" } else { "effort" };
        let other = if stroke_here { "effort" } else { "flow" };
        if matches!(self.graph.elements[element].kind, Kind::Se | Kind::Sf) {
            let ends = &self.graph.bonds[bond];
            let neighbour = if ends.from == element { ends.to } else { ends.from };
            let origin = self.origin(bond);
            let place = &self.graph.elements[neighbour].name;
            let common = match self.graph.elements[neighbour].kind {
                Kind::One => "flow",
                Kind::Zero => "effort",
                _ => given,
            };
            let message = if common == given {
                format!("{origin} and {text} both set the {given} of `{place}`")
            } else {
                format!(
                    "nothing sets the {common} of `{place}`: {origin} and {text} both set a {given} there"
                )
            };
            let hint =
                "take one of the sources out, or put the resistor or store that is missing between them";
            self.mistakes.push("E1713", &span, message, hint);
            return;
        }
        let message = format!(
            "`{text}` {why}, so it needs the {other} of its bond, but {} sets the {given} there",
            self.origin(bond)
        );
        let hint = match self.graph.elements[element].kind {
            Kind::R => "give the law in its other form, or a resistance",
            _ => {
                "give a capacitance, stiffness or inertia, which can be turned round, or put a spring or inertia between"
            }
        };
        self.mistakes.push("E1713", &span, message, hint);
    }
}
