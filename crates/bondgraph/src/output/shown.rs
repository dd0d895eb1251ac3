//! Equations as a textbook writes them: element laws, junction laws, state equations in causal order.

use crate::equations::{Equations, Unknown, What};
use crate::expression::{Id, Pool, Printed, Style, Var, identifier};
use crate::graph::{Graph, Kind, Law};
use crate::output::greek::GREEK;
use serde::Serialize;
use std::collections::HashMap;

/// Common parts of at least this many operations get a name.
const WORTH_A_NAME: usize = 6;
/// Longest equation that is written out.
const LONGEST: usize = 3000;

/// How equations are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Notation {
    /// Plain text.
    Text,
    /// LaTeX.
    Latex,
}

/// All equations of a graph.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShownEquations {
    /// Version of this structure.
    pub version: u32,
    /// Name of the graph.
    pub graph: String,
    /// How they are written.
    pub notation: Notation,
    /// Parameters with value and unit.
    pub parameters: Vec<Equation>,
    /// Laws of the elements, in the form that causality asks for.
    pub elements: Vec<Equation>,
    /// Laws of the junctions.
    pub junctions: Vec<Equation>,
    /// Signals.
    pub signals: Vec<Equation>,
    /// What events set: whose zero they wait for, the state and its new value.
    pub events: Vec<Equation>,
    /// States with unit and start.
    pub states: Vec<ShownState>,
    /// Variables that cut loops, and rates of stores that follow.
    pub unknowns: Vec<ShownUnknown>,
    /// Common parts of the state equations.
    pub common: Vec<Equation>,
    /// The state equations, explicit.
    pub rates: Vec<Equation>,
    /// Where stores follow: M x' = f, row by row, with `0` where nothing stands.
    pub mass: Option<Vec<Vec<String>>>,
    /// Its right-hand side.
    pub right: Option<Vec<String>>,
}

/// One equation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Equation {
    /// Whose law it is.
    pub of: String,
    /// Left side.
    pub left: String,
    /// Right side.
    pub right: String,
    /// Unit of both sides.
    pub unit: String,
}

/// A state.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShownState {
    /// Its symbol.
    pub symbol: String,
    /// Its unit.
    pub unit: String,
    /// Its start.
    pub start: f64,
    /// Its start as it is written.
    #[serde(skip)]
    pub written: String,
}

/// A variable that the states do not give directly.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShownUnknown {
    /// Its symbol.
    pub symbol: String,
    /// Why it is unknown.
    pub why: String,
    /// What it equals: of a store that follows the derivative of what it holds, then that derivative written out.
    pub value: String,
    /// The equation that it must meet: the symbol and its value.
    pub equation: String,
    /// Its unit.
    pub unit: String,
    /// Whether it was solved in closed form; otherwise it is solved at every evaluation.
    pub eliminated: bool,
}

impl Equations {
    /// The equations in a notation.
    pub fn shown(&self, notation: Notation) -> ShownEquations {
        let graph = &self.graph;
        let style = if notation == Notation::Latex { Style::Latex } else { Style::Text };
        let name = |var: Var| self.variable_name(var, style);
        let mut pool = graph.pool.clone();
        let mut closed: Vec<Id> = self.states.iter().map(|state| state.rate).collect();
        closed.extend(self.unknowns.iter().map(|unknown| unknown.solved.unwrap_or(unknown.value)));
        let (common, mut rates) = named_parts(&mut pool, &closed);
        let values = rates.split_off(self.states.len());
        let printed = Printed { pool: &pool, style, name, longest: LONGEST };
        let rate_left = |index: usize| {
            let symbol = self.variable_name(Var::State(index as u32), style);
            rate_of(&symbol, style)
        };
        let unit_of_rate = |index: usize| self.states[index].unit.over(crate::unit::Unit::SECOND).to_string();
        ShownEquations {
            version: 1,
            graph: graph.name.clone(),
            notation,
            parameters: graph
                .parameters
                .iter()
                .map(|parameter| Equation {
                    of: parameter.name.clone(),
                    left: self.plain_name(&parameter.name, style),
                    right: printed.number(parameter.value),
                    unit: parameter.written_unit.clone().unwrap_or_else(|| parameter.unit.to_string()),
                })
                .collect(),
            elements: self.element_laws(&printed),
            junctions: self.junction_laws(&printed),
            signals: graph
                .signals
                .iter()
                .enumerate()
                .map(|(index, signal)| {
                    let symbol = self.variable_name(Var::Signal(index as u32), style);
                    let left = if signal.start.is_some() { rate_of(&symbol, style) } else { symbol };
                    let unit = match signal.start {
                        Some(_) => signal.unit.over(crate::unit::Unit::SECOND),
                        None => signal.unit,
                    };
                    Equation {
                        of: signal.name.clone(),
                        left,
                        right: printed.text(signal.value),
                        unit: unit.to_string(),
                    }
                })
                .collect(),
            events: (graph.rules.iter())
                .flat_map(|rule| rule.set.iter().map(move |set| (rule.when, set)))
                .map(|(when, (var, value))| Equation {
                    of: printed.text(when),
                    left: (printed.name)(*var),
                    right: printed.text(*value),
                    unit: String::new(),
                })
                .collect(),
            states: self
                .states
                .iter()
                .enumerate()
                .map(|(index, state)| ShownState {
                    symbol: self.variable_name(Var::State(index as u32), style),
                    unit: state.unit_name.clone(),
                    start: state.start,
                    written: printed.number(state.start),
                })
                .collect(),
            unknowns: self
                .unknowns
                .iter()
                .enumerate()
                .map(|(index, unknown)| {
                    let symbol = self.variable_name(Var::Unknown(index as u32), style);
                    let written_out = printed.text(values[index]);
                    let (why, value) = match (unknown.what, style) {
                        (What::Tear, _) => ("cuts an algebraic loop", written_out),
                        (What::Following(held), Style::Latex) => {
                            let held = printed.text(held);
                            let derivative = format!("\\frac{{d}}{{dt}}\\left({held}\\right)");
                            ("rate of a store that follows", format!("{derivative} = {written_out}"))
                        }
                        (What::Following(held), _) => (
                            "rate of a store that follows",
                            format!("d/dt({}) = {written_out}", printed.text(held)),
                        ),
                    };
                    ShownUnknown {
                        equation: format!("{symbol} = {value}"),
                        symbol,
                        why: why.into(),
                        value,
                        unit: self.unit_of_unknown(index),
                        eliminated: unknown.solved.is_some(),
                    }
                })
                .collect(),
            common: common
                .iter()
                .enumerate()
                .map(|(index, id)| Equation {
                    of: String::new(),
                    left: self.variable_name(Var::Named(index as u32), style),
                    right: printed.text(*id),
                    unit: String::new(),
                })
                .collect(),
            rates: rates
                .iter()
                .enumerate()
                .map(|(index, id)| Equation {
                    of: self.states[index].name.clone(),
                    left: rate_left(index),
                    right: printed.text(*id),
                    unit: unit_of_rate(index),
                })
                .collect(),
            mass: self.mass.as_ref().map(|(mass, _)| {
                mass.iter().map(|row| row.iter().map(|id| printed.text(*id)).collect()).collect()
            }),
            right: self.mass.as_ref().map(|(_, right)| right.iter().map(|id| printed.text(*id)).collect()),
        }
    }

    fn unit_of_unknown(&self, index: usize) -> String {
        let Unknown { name, bond, .. } = &self.unknowns[index];
        if let Some(signal) = self.graph.signals.iter().find(|signal| signal.name == *name) {
            return signal.unit.to_string();
        }
        let units = self.graph.bonds[*bond].domain.unit_names();
        units[usize::from(name.ends_with(".flow"))].to_owned()
    }

    fn plain_name(&self, name: &str, style: Style) -> String {
        match style {
            Style::Latex => symbol(name),
            Style::Text => name.to_owned(),
            Style::Modelica => name.replace('.', "_"),
        }
    }

    /// What a variable is called.
    pub(crate) fn variable_name(&self, var: Var, style: Style) -> String {
        let graph = &self.graph;
        let of = |bond: u32, what: &str, letter: &str| {
            let bond = graph.bond_name(bond as usize);
            match style {
                Style::Latex => {
                    let bond = bond.replace(" > ", "\\to ").replace('_', "\\_");
                    format!("{letter}_{{\\mathrm{{{bond}}}}}")
                }
                Style::Text if bond.contains(" > ") => format!("({bond}).{what}"),
                Style::Text => format!("{bond}.{what}"),
                Style::Modelica if bond.contains(" > ") => format!("bond_{}_{what}", identifier(&bond)),
                Style::Modelica => format!("{}_{what}", identifier(&bond)),
            }
        };
        match var {
            Var::Time => if style == Style::Modelica { "time" } else { "t" }.to_owned(),
            Var::Parameter(index) => self.plain_name(&graph.parameters[index as usize].name, style),
            Var::Signal(index) => self.plain_name(&graph.signals[index as usize].name, style),
            Var::Effort(bond) => of(bond, "effort", "e"),
            Var::Flow(bond) => of(bond, "flow", "f"),
            Var::Displacement(bond) => of(bond, "displacement", "q"),
            Var::Momentum(bond) => of(bond, "momentum", "p"),
            Var::State(index) => {
                let symbol = &self.states[index as usize].symbol;
                match (symbol.rsplit_once('.'), style) {
                    (Some((bond, what)), Style::Latex) => {
                        let letter = if what == "momentum" { "p" } else { "q" };
                        format!("{letter}_{{\\mathrm{{{}}}}}", bond.replace('_', "\\_"))
                    }
                    (Some(_), Style::Modelica) => identifier(symbol),
                    (Some(_), Style::Text) => symbol.clone(),
                    (None, _) => self.plain_name(symbol, style),
                }
            }
            Var::Unknown(index) => {
                let name = &self.unknowns[index as usize].name;
                match (name.rsplit_once('.'), style) {
                    (Some((bond, what)), Style::Latex) => {
                        let letter = if what == "effort" { "e" } else { "f" };
                        format!("{letter}_{{\\mathrm{{{}}}}}", bond.replace('_', "\\_"))
                    }
                    (_, Style::Modelica) => identifier(name),
                    _ => name.clone(),
                }
            }
            Var::Named(index) => match style {
                Style::Latex => format!("c_{{{}}}", index + 1),
                _ => format!("c{}", index + 1),
            },
        }
    }

    fn element_laws<N: Fn(Var) -> String>(&self, printed: &Printed<N>) -> Vec<Equation> {
        let graph = &self.graph;
        let mut laws = Vec::new();
        for element in &graph.elements {
            let bond = element.ports[0];
            let effort = |bond: usize| (printed.name)(Var::Effort(bond as u32));
            let flow = |bond: usize| (printed.name)(Var::Flow(bond as u32));
            let at_head = self.causality.stroke_at_head[bond];
            let mut add = |left: String, right: String, unit: &str| {
                laws.push(Equation { of: element.name.clone(), left, right, unit: unit.to_owned() });
            };
            let units = |bond: usize| graph.bonds[bond].domain.unit_names();
            match &element.law {
                Law::Source(value) if element.kind == Kind::Se => {
                    add(effort(bond), printed.text(*value), units(bond)[0]);
                }
                Law::Source(value) => add(flow(bond), printed.text(*value), units(bond)[1]),
                Law::Resistor { effort: by_flow, flow: by_effort } => match (by_flow, by_effort, at_head) {
                    (Some(law), _, false) | (Some(law), None, _) => {
                        add(effort(bond), printed.text(*law), units(bond)[0]);
                    }
                    (_, Some(law), _) => add(flow(bond), printed.text(*law), units(bond)[1]),
                    (None, None, _) => {}
                },
                Law::Resistors { gives_flows, laws: list } => {
                    for (port, law) in element.ports.iter().zip(list) {
                        let (left, unit) = if *gives_flows {
                            (flow(*port), units(*port)[1])
                        } else {
                            (effort(*port), units(*port)[0])
                        };
                        add(left, printed.text(*law), unit);
                    }
                }
                Law::Store(ports) => {
                    for (port, law) in ports.iter().enumerate() {
                        let bond = element.ports[port];
                        let follows = self.causality.following_bonds.contains(&bond);
                        if let (true, Some(law)) = (follows, law.inverse) {
                            self.law_of_follower(printed, element.kind, bond, law, &mut add);
                        } else if let Some(law) = law.flow {
                            add(flow(bond), printed.text(law), units(bond)[1]);
                        } else if let Some(law) = law.effort {
                            add(effort(bond), printed.text(law), units(bond)[0]);
                        } else if let Some(law) = law.inverse {
                            let momentum = (printed.name)(Var::Momentum(bond as u32));
                            add(momentum, printed.text(law), units(bond)[3]);
                        }
                    }
                }
                Law::Ratio(ratio) => {
                    let (a, b) = (element.ports[0], element.ports[1]);
                    if element.kind == Kind::TF {
                        add(flow(b), printed.times(*ratio, &flow(a)), units(b)[1]);
                        add(effort(a), printed.times(*ratio, &effort(b)), units(a)[0]);
                    } else {
                        add(effort(a), printed.times(*ratio, &flow(b)), units(a)[0]);
                        add(effort(b), printed.times(*ratio, &flow(a)), units(b)[0]);
                    }
                }
                Law::Matrix(rows) => {
                    let columns = rows[0].len();
                    for (row, entries) in rows.iter().enumerate() {
                        let terms: Vec<String> = entries
                            .iter()
                            .enumerate()
                            .filter(|(_, id)| !graph.pool.is_zero(**id))
                            .map(|(k, id)| printed.times(*id, &flow(element.ports[k])))
                            .collect();
                        let out = element.ports[columns + row];
                        let sum = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
                        let sum = sum.replace("+ -", "- ");
                        add(flow(out), sum, units(out)[1]);
                    }
                }
                Law::Junction => {}
            }
        }
        laws
    }

    /// What a store in derivative causality holds by what it is given, and its rate.
    fn law_of_follower<N: Fn(Var) -> String>(
        &self,
        printed: &Printed<N>,
        kind: Kind,
        bond: usize,
        law: Id,
        add: &mut impl FnMut(String, String, &str),
    ) {
        let (number, units) = (bond as u32, self.graph.bonds[bond].domain.unit_names());
        let [held, rate] = match kind {
            Kind::C => [Var::Displacement(number), Var::Flow(number)],
            _ => [Var::Momentum(number), Var::Effort(number)],
        };
        let [held, rate] = [held, rate].map(&printed.name);
        let [unit, unit_of_rate] = if kind == Kind::C { [units[2], units[1]] } else { [units[3], units[0]] };
        add(held.clone(), printed.text(law), unit);
        add(rate, rate_of(&held, printed.style), unit_of_rate);
    }

    fn junction_laws<N: Fn(Var) -> String>(&self, printed: &Printed<N>) -> Vec<Equation> {
        let graph = &self.graph;
        let mut laws = Vec::new();
        for (index, element) in graph.elements.iter().enumerate() {
            if !element.is_junction() {
                continue;
            }
            let effort = |bond: &usize| (printed.name)(Var::Effort(*bond as u32));
            let flow = |bond: &usize| (printed.name)(Var::Flow(*bond as u32));
            let units = graph.bonds[element.ports[0]].domain.unit_names();
            let zero = element.kind == Kind::Zero;
            let common: Vec<String> =
                element.ports.iter().map(|bond| if zero { effort(bond) } else { flow(bond) }).collect();
            let mut sum = String::new();
            for bond in &element.ports {
                let plus = graph.bonds[*bond].sign_into(index) > 0.0;
                sum += match (sum.is_empty(), plus) {
                    (true, true) => "",
                    (true, false) => "-",
                    (false, true) => " + ",
                    (false, false) => " - ",
                };
                sum += &if zero { flow(bond) } else { effort(bond) };
            }
            let of = element.name.clone();
            if common.len() > 1 {
                laws.push(Equation {
                    of: of.clone(),
                    left: common[0].clone(),
                    right: common[1..].join(" = "),
                    unit: units[usize::from(!zero)].to_owned(),
                });
            }
            laws.push(Equation {
                of,
                left: sum,
                right: "0".into(),
                unit: units[usize::from(zero)].to_owned(),
            });
        }
        laws
    }
}

/// A name as a symbol of LaTeX: `mu_3`, `m_c` and `A1` have a subscript, words are upright.
fn symbol(name: &str) -> String {
    let is_greek = |word: &str| GREEK.iter().any(|(name, _)| *name == word);
    let of_word = |word: &str| -> String {
        match word {
            _ if word.chars().count() == 1 => word.to_owned(),
            _ if is_greek(word) => format!("\\{word}"),
            _ if word.chars().all(|c| c.is_ascii_digit()) => word.to_owned(),
            _ => format!("\\mathrm{{{word}}}"),
        }
    };
    let (base, mut below) = match name.split_once('_') {
        Some((base, below)) if !base.is_empty() => (base, vec![below]),
        _ => (name, Vec::new()),
    };
    if base.starts_with('_') || below.iter().any(|own| own.split('_').any(str::is_empty)) {
        return format!("\\mathrm{{{}}}", name.replace('_', "\\_"));
    }
    // A letter with a number behind it.
    let letters = base.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_letter = letters.chars().count() == 1 || is_greek(letters);
    let base = if is_letter && letters.len() < base.len() {
        below.insert(0, &base[letters.len()..]);
        letters
    } else {
        base
    };
    let below: Vec<String> = below.iter().flat_map(|own| own.split('_')).map(of_word).collect();
    match below.is_empty() {
        true => of_word(base),
        false => format!("{}_{{{}}}", of_word(base), below.join(",")),
    }
}

/// The rate of a variable.
fn rate_of(symbol: &str, style: Style) -> String {
    match style {
        // A point stands over one thing.
        Style::Latex if symbol.starts_with("\\mathrm") => format!("\\dot{{{symbol}}}"),
        Style::Latex => format!("\\dot {symbol}"),
        _ => format!("d({symbol})/dt"),
    }
}

/// Parts that stand more than once and are worth a name, and the expressions with those names.
fn named_parts(pool: &mut Pool, ids: &[Id]) -> (Vec<Id>, Vec<Id>) {
    let mut order = Vec::new();
    let mut uses: HashMap<Id, usize> = HashMap::new();
    let mut size: HashMap<Id, usize> = HashMap::new();
    for id in ids {
        visit(pool, *id, &mut uses, &mut size, &mut order);
    }
    let mut new: HashMap<Id, Id> = HashMap::new();
    let mut parts = Vec::new();
    for id in order {
        let rebuilt = pool.with_operands(id, |_, operand| new.get(&operand).copied().unwrap_or(operand));
        if uses[&id] > 1 && size[&id] >= WORTH_A_NAME {
            let named = pool.var(Var::Named(parts.len() as u32));
            parts.push(rebuilt);
            new.insert(id, named);
        } else {
            new.insert(id, rebuilt);
        }
    }
    (parts, ids.iter().map(|id| new[id]).collect())
}

fn visit(
    pool: &Pool,
    id: Id,
    uses: &mut HashMap<Id, usize>,
    size: &mut HashMap<Id, usize>,
    order: &mut Vec<Id>,
) {
    let count = uses.entry(id).or_insert(0);
    *count += 1;
    if *count > 1 {
        return;
    }
    let mut mine = 1usize;
    for operand in pool.operands(id) {
        visit(pool, operand, uses, size, order);
        mine = mine.saturating_add(size[&operand]);
    }
    size.insert(id, mine);
    order.push(id);
}

impl Graph {
    /// Number of bonds.
    pub fn bond_count(&self) -> usize {
        self.bonds.len()
    }
}
