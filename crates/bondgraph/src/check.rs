//! A description to a graph: names, ports, domains, laws and their units.

use crate::description::{Description, Entry, Text};
use crate::domain::Domain;
use crate::expression::{Id, Node, Parsed, Pool, Scope, Var, parse, total};
use crate::graph::{Asked, Bond, Element, Graph, Kind, Law, Parameter, Signal};
use crate::mistake::Mistakes;
use crate::unit::{Unit, leading_unit};
use std::collections::HashMap;
use std::sync::Arc;

mod law;
mod period;
mod rule;
mod signal;

/// More elements or bonds are refused.
const MOST: usize = 5000;
/// Names with a meaning of their own.
const RESERVED: [&str; 7] = ["t", "time", "pi", "e", "f", "q", "p"];

/// How far a named expression is read.
#[derive(Clone, Copy, PartialEq)]
enum Progress {
    Waiting,
    Reading,
    Done(Option<Parsed>),
}

pub(crate) struct Checker<'a> {
    description: &'a Description,
    pool: Pool,
    mistakes: &'a mut Mistakes,
    parameters: Vec<Parameter>,
    parameter_progress: Vec<Progress>,
    signals: Vec<Signal>,
    signal_progress: Vec<Progress>,
    elements: Vec<Element>,
    bonds: Vec<Bond>,
    /// Names that the law at hand adds.
    local: HashMap<String, Parsed>,
    /// Whether only numbers may be named: parameters, starts.
    numbers_only: bool,
    /// Signals that are being read, one within the other.
    depth: usize,
    /// Bonds whose domain is not known, and elements whose bonds are not: mistakes that are told already.
    doubtful: Vec<bool>,
    incomplete: Vec<bool>,
    /// The integral that is being read, at its depth: it may contain itself.
    own_integrand: Option<(usize, usize)>,
    /// Integrals of a known unit that were named on the way: their integrands are read afterwards.
    deferred: Vec<usize>,
}

/// Checks a description; the graph may be wrong where a mistake was noted.
pub(crate) fn check(description: &Description, mistakes: &mut Mistakes) -> Option<Graph> {
    if description.elements.is_empty() {
        let hint = "for example [elements] with mass = { kind = \"I\", inertia = \"2 kg\" }";
        mistakes.push("E1709", &(0..0), "the graph has no elements", hint);
        return None;
    }
    if description.elements.len().max(description.bonds.len()).max(description.signals.len()) > MOST {
        mistakes.push(
            "E1715",
            &(0..0),
            format!("more than {MOST} elements, bonds or signals"),
            "part the graph",
        );
        return None;
    }
    let mut checker = Checker {
        description,
        pool: Pool::default(),
        mistakes,
        parameters: Vec::new(),
        parameter_progress: vec![Progress::Waiting; description.parameters.len()],
        signals: Vec::new(),
        signal_progress: vec![Progress::Waiting; description.signals.len()],
        elements: Vec::new(),
        bonds: Vec::new(),
        local: HashMap::new(),
        numbers_only: true,
        depth: 0,
        own_integrand: None,
        doubtful: Vec::new(),
        incomplete: Vec::new(),
        deferred: Vec::new(),
    };
    checker.names();
    checker.pool.curves =
        description.tables.iter().map(|(name, curve)| (name.text.clone(), Arc::new(curve.clone()))).collect();
    for (name, _) in &description.parameters {
        let nothing =
            Parameter { name: name.text.clone(), unit: Unit::NONE, written_unit: None, value: f64::NAN };
        checker.parameters.push(nothing);
    }
    for index in 0..description.parameters.len() {
        checker.parameter(index);
    }
    checker.kinds();
    let domains = checker.bond_list();
    checker.domains(domains);
    checker.numbers_only = false;
    let zero = checker.pool.constant(0.0);
    for entry in &description.signals {
        let name = entry.name.text.clone();
        checker.signals.push(Signal { name, unit: Unit::NONE, value: zero, start: None });
    }
    for index in 0..description.signals.len() {
        checker.signal(index);
        while let Some(deferred) = checker.deferred.pop() {
            checker.integrand(deferred);
        }
    }
    for index in 0..checker.elements.len() {
        checker.law(index);
    }
    let rules = checker.rules();
    let simulation = checker.asked();
    (!checker.mistakes.any()).then(|| Graph {
        name: description.name.clone(),
        pool: checker.pool,
        parameters: checker.parameters,
        elements: checker.elements,
        bonds: checker.bonds,
        signals: checker.signals,
        rules,
        simulation,
        source: String::new(),
    })
}

impl Checker<'_> {
    /// Every name once, none reserved, all of letters and digits.
    fn names(&mut self) {
        let mut seen: Vec<&str> = Vec::new();
        let names = (self.description.parameters.iter().map(|(name, _)| name))
            .chain(self.description.elements.iter().map(|entry| &entry.name))
            .chain(self.description.signals.iter().map(|entry| &entry.name));
        for name in names {
            let text = name.text.as_str();
            let good = text.starts_with(|c: char| c.is_alphabetic() || c == '_')
                && text.chars().all(|c| c.is_alphanumeric() || c == '_')
                && text.len() <= 60;
            if !good {
                let hint = "a name has letters, digits and _, and starts with a letter";
                self.mistakes.push("E1703", &name.span, format!("\"{text}\" is no name"), hint);
            } else if RESERVED.contains(&text) && !self.description.elements.iter().any(|e| e.name == *name) {
                let hint = "t is the time, e, f, q, p are the variables of a law: choose another name";
                self.mistakes.push("E1703", &name.span, format!("`{text}` has a meaning of its own"), hint);
            } else if seen.contains(&text) {
                let hint = "elements, signals and parameters share one list of names: rename one";
                self.mistakes.push("E1703", &name.span, format!("`{text}` is given twice"), hint);
            }
            seen.push(text);
        }
    }

    fn parameter(&mut self, index: usize) -> Option<Parsed> {
        if let Progress::Done(parsed) = self.parameter_progress[index] {
            return parsed;
        }
        let (name, text) = &self.description.parameters[index];
        if self.parameter_progress[index] == Progress::Reading {
            let message = format!("parameter `{}` needs itself", name.text);
            self.mistakes.push("E1711", &name.span, message, "break the circle with a number");
            return None;
        }
        self.parameter_progress[index] = Progress::Reading;
        let numbers_only = std::mem::replace(&mut self.numbers_only, true);
        let parsed = parse(text, self);
        self.numbers_only = numbers_only;
        if let Some(parsed) = parsed {
            let value = self.number(parsed.id);
            if !value.is_finite() {
                let message = format!("parameter `{}` is no finite number", name.text);
                self.mistakes.push("E1704", &text.span, message, "check divisions and roots in it");
            }
            self.parameters[index].value = value;
            self.parameters[index].unit = parsed.unit.unwrap_or(Unit::NONE);
            self.parameters[index].written_unit = written_unit(&text.text);
        }
        // The symbol stands for the value from here on.
        let parsed = parsed
            .map(|parsed| Parsed { id: self.pool.var(Var::Parameter(index as u32)), unit: parsed.unit });
        self.parameter_progress[index] = Progress::Done(parsed);
        parsed
    }

    /// Value of an expression of parameters. A sum that cancels to the rounding of its parts is 0.
    fn number(&self, id: Id) -> f64 {
        if let Node::Sum(a, b) = self.pool.node(id) {
            return total(self.number(a), self.number(b));
        }
        self.pool.evaluate(id, &|var| match var {
            Var::Parameter(index) => self.parameters[index as usize].value,
            _ => f64::NAN,
        })
    }

    fn kinds(&mut self) {
        for entry in &self.description.elements {
            let written = entry.get("kind").cloned().unwrap_or_default();
            let kind = match written.text.as_str() {
                "Se" | "MSe" => Kind::Se,
                "Sf" | "MSf" => Kind::Sf,
                "R" | "MR" => Kind::R,
                "C" => Kind::C,
                "I" => Kind::I,
                "IC" => Kind::IC,
                "Gas" => Kind::Gas,
                "TF" | "MTF" => Kind::TF,
                "GY" | "MGY" => Kind::GY,
                "0" => Kind::Zero,
                "1" => Kind::One,
                other => {
                    let message = if other.is_empty() {
                        format!("element `{}` has no kind", entry.name.text)
                    } else {
                        format!("`{other}` is no kind of element")
                    };
                    let span = if other.is_empty() { &entry.name.span } else { &written.span };
                    let hint =
                        "the kinds are Se, Sf, R, C, I, IC, Gas, TF, GY, 0, 1 and MSe, MSf, MR, MTF, MGY";
                    self.mistakes.push("E1702", span, message, hint);
                    continue;
                }
            };
            self.elements.push(Element {
                name: entry.name.text.clone(),
                written: written.text,
                kind,
                span: entry.name.span.clone(),
                ports: Vec::new(),
                law: Law::Junction,
                energy: None,
                value: None,
            });
        }
    }

    fn entry(&self, element: usize) -> &Entry {
        let name = &self.elements[element].name;
        self.description
            .elements
            .iter()
            .find(|entry| entry.name.text == *name)
            .expect("invariant: every element comes from an entry")
    }

    /// Number of ports of an element that is no junction; none where any number goes.
    fn port_count(&self, element: usize) -> Option<usize> {
        let entry = self.entry(element);
        match self.elements[element].kind {
            Kind::Zero | Kind::One => None,
            Kind::TF if entry.get("matrix").is_some() => {
                let text = entry.get("matrix").map_or("", |text| text.text.as_str());
                let rows: Vec<&str> = text.split('|').collect();
                Some(rows.len() + rows[0].split(';').count())
            }
            Kind::TF | Kind::GY => Some(2),
            Kind::Gas => Some(3),
            Kind::R => {
                let law = entry.get("flow").or_else(|| entry.get("effort"));
                Some(law.map_or(1, |text| text.text.split(';').count()))
            }
            Kind::C | Kind::I | Kind::IC => match (entry.get("energy"), entry.get("coenergy")) {
                (Some(energy), _) => Some(field_ports(energy, &['q', 'p'])),
                (None, Some(coenergy)) => Some(field_ports(coenergy, &['f'])),
                (None, None) => Some(1),
            },
            _ => Some(1),
        }
    }

    /// The bonds; gives, for each, nothing but its ends. Ports are filled.
    fn bond_list(&mut self) -> Vec<[usize; 2]> {
        let mut ends = Vec::new();
        let counts: Vec<Option<usize>> = (0..self.elements.len()).map(|e| self.port_count(e)).collect();
        let mut ports: Vec<Vec<Option<usize>>> =
            counts.iter().map(|count| vec![None; count.unwrap_or(0)]).collect();
        let description = self.description;
        for text in &description.bonds {
            let parts: Vec<&str> = text.text.split('>').map(str::trim).collect();
            if parts.len() != 2 {
                let message = format!("\"{}\" is no bond", text.text);
                self.mistakes.push("E1707", &text.span, message, "write it as \"from > to\"");
                continue;
            }
            let found = [self.end(parts[0], text, &counts), self.end(parts[1], text, &counts)];
            let [Some(from), Some(to)] = found else { continue };
            if from.0 == to.0 {
                let message = format!("\"{}\" bonds an element to itself", text.text);
                self.mistakes.push("E1707", &text.span, message, "a bond joins two elements");
                continue;
            }
            let bond = ends.len();
            for (is_to, (element, port)) in [(false, from), (true, to)] {
                self.arrow(element, port, is_to, text);
                match port {
                    None => self.elements[element].ports.push(bond),
                    Some(port) => {
                        if ports[element][port].is_some() {
                            let name = &self.elements[element].name;
                            let message = format!("port {} of `{name}` is bonded twice", port + 1);
                            let hint = "put a 0 or 1 junction between, or use the other port";
                            self.mistakes.push("E1708", &text.span, message, hint);
                        }
                        ports[element][port] = Some(bond);
                    }
                }
            }
            ends.push([from.0, to.0]);
        }
        for (element, ports) in ports.into_iter().enumerate() {
            for (port, bond) in ports.iter().enumerate() {
                if bond.is_none() {
                    let Text { text, span } = self.entry(element).name.clone();
                    let port =
                        if ports.len() == 1 { String::new() } else { format!("port {} of ", port + 1) };
                    let message = format!("{port}`{text}` has no bond");
                    self.mistakes.push(
                        "E1708",
                        &span,
                        message,
                        "add it to [bonds] list, or take the element out",
                    );
                }
            }
            self.incomplete.push(ports.iter().any(Option::is_none));
            if counts[element].is_some() {
                self.elements[element].ports = ports.into_iter().flatten().collect();
            } else if self.elements[element].ports.is_empty() {
                self.incomplete[element] = true;
                let Text { text, span } = self.entry(element).name.clone();
                let message = format!("junction `{text}` has no bond");
                self.mistakes.push("E1708", &span, message, "add it to [bonds] list, or take it out");
            }
        }
        ends
    }

    /// Element and port of an end.
    fn end(&mut self, end: &str, text: &Text, counts: &[Option<usize>]) -> Option<(usize, Option<usize>)> {
        let (name, port) = match end.split_once('.') {
            Some((name, port)) => (name, Some(port)),
            None => (end, None),
        };
        let Some(element) = self.elements.iter().position(|element| element.name == name) else {
            // An element of an unknown kind is a mistake already.
            if !self.description.elements.iter().any(|entry| entry.name.text == name) {
                let near = nearest(name, self.elements.iter().map(|element| element.name.as_str()));
                let hint = near
                    .map_or("name an element of [elements]".into(), |near| format!("did you mean {near}?"));
                self.mistakes.push("E1707", &text.span, format!("there is no element `{name}`"), hint);
            }
            return None;
        };
        match (counts[element], port) {
            (None, None) => Some((element, None)),
            (Some(1), None) => Some((element, Some(0))),
            (Some(count), Some(port))
                if port.parse().is_ok_and(|port: usize| (1..=count).contains(&port)) =>
            {
                Some((element, port.parse::<usize>().ok().map(|port| port - 1)))
            }
            (count, _) => {
                let hint = match count {
                    None => format!("a junction has no numbered ports: write {name}"),
                    Some(1) => format!("it has one port: write {name}"),
                    Some(count) => format!("it has ports {name}.1 to {name}.{count}"),
                };
                self.mistakes.push("E1707", &text.span, format!("`{end}` is no port of `{name}`"), hint);
                None
            }
        }
    }

    /// Half arrows point into stores and resistors, and through transformers and gyrators.
    fn arrow(&mut self, element: usize, port: Option<usize>, is_to: bool, text: &Text) {
        let needs_to = match self.elements[element].kind {
            Kind::R | Kind::C | Kind::I | Kind::IC | Kind::Gas => true,
            Kind::TF | Kind::GY => {
                let entry = self.entry(element);
                let first = entry
                    .get("matrix")
                    .map_or(1, |text| text.text.split('|').next().map_or(1, |row| row.split(';').count()));
                port.is_some_and(|port| port < first)
            }
            _ => return,
        };
        if needs_to != is_to {
            let name = &self.elements[element].name;
            let message = format!("\"{}\" has its half arrow against `{name}`", text.text);
            let hint = match self.elements[element].kind {
                Kind::TF | Kind::GY => "power goes in at port 1 and out at port 2: \"a > x.1\", \"x.2 > b\"",
                _ => "stores and resistors take power in: turn the bond round",
            };
            self.mistakes.push("E1708", &text.span, message, hint);
        }
    }

    /// Whether all bonds of an element, and their domains, are known.
    fn is_bonded(&self, element: usize) -> bool {
        let ports = &self.elements[element].ports;
        !self.incomplete[element] && ports.iter().all(|bond| !self.doubtful[*bond])
    }

    /// The domain of each bond, from the junctions and elements that name one.
    fn domains(&mut self, ends: Vec<[usize; 2]>) {
        let mut given: Vec<Option<Domain>> = Vec::new();
        for element in 0..self.elements.len() {
            let text = self.entry(element).get("domain").cloned();
            given.push(text.and_then(|text| {
                let found = Domain::ALL.into_iter().find(|domain| domain.name() == text.text);
                if found.is_none() {
                    let names: Vec<&str> = Domain::ALL.iter().map(|domain| domain.name()).collect();
                    let message = format!("`{}` is no domain", text.text);
                    self.mistakes.push(
                        "E1702",
                        &text.span,
                        message,
                        format!("there are {}", names.join(", ")),
                    );
                }
                found
            }));
        }
        let mut domains: Vec<Option<Domain>> = vec![None; ends.len()];
        for element in self.elements.iter().filter(|element| element.kind == Kind::Gas) {
            for (bond, domain) in element.ports.iter().zip([Domain::Hydraulic, Domain::Mass, Domain::Heat]) {
                domains[*bond] = Some(domain);
            }
        }
        // Domains spread along bonds, through junctions and one-ports, until nothing changes.
        // Behind a bond or a domain that cannot be read, or a conflict, what is missing is told already.
        let is_no_domain = |text: &Text| Domain::ALL.iter().all(|domain| domain.name() != text.text);
        let mut is_told =
            self.description.elements.iter().any(|entry| entry.get("domain").is_some_and(is_no_domain))
                || ends.len() < self.description.bonds.len()
                || self.elements.len() < self.description.elements.len();
        let mut conflict = false;
        let mut changed = true;
        while changed && !conflict {
            changed = false;
            for (bond, pair) in ends.iter().enumerate() {
                for element in *pair {
                    let shares =
                        self.elements[element].is_junction() || self.elements[element].ports.len() == 1;
                    // A field may join domains, unless it names the one of all its ports.
                    if !shares && given[element].is_none() {
                        continue;
                    }
                    match (given[element], domains[bond]) {
                        (Some(domain), None) => {
                            domains[bond] = Some(domain);
                            changed = true;
                        }
                        (None, Some(domain)) => {
                            given[element] = Some(domain);
                            changed = true;
                        }
                        (Some(a), Some(b)) if a != b => {
                            if conflict {
                                continue;
                            }
                            (conflict, is_told) = (true, true);
                            let Text { text, span } = self.entry(element).name.clone();
                            let message = format!("`{text}` joins {} and {}", a.name(), b.name());
                            let hint = "domains meet in a transformer or gyrator alone";
                            self.mistakes.push("E1710", &span, message, hint);
                        }
                        _ => {}
                    }
                }
            }
        }
        for (bond, [from, to]) in ends.into_iter().enumerate() {
            self.doubtful.push(conflict || domains[bond].is_none());
            let domain = domains[bond].unwrap_or_else(|| {
                if is_told {
                    return Domain::Translation;
                }
                let junction = if self.elements[to].is_junction() { to } else { from };
                let Text { text, span } = self.entry(junction).name.clone();
                let message = format!("the domain of `{text}` is not known");
                let hint = "add domain = \"translation\", \"rotation\", \"electric\", \"hydraulic\", \"thermal\", \"heat\" or \"mass\"";
                self.mistakes.push("E1710", &span, message, hint);
                Domain::Translation
            });
            self.bonds.push(Bond { from, to, domain });
        }
    }

    /// Duration, period, samples and tolerance.
    fn asked(&mut self) -> Asked {
        let description = self.description;
        let periodic = self.is_periodic();
        let period = self.period(periodic);
        let mut asked = Asked { duration: 1.0, period, periodic, samples: 200, tolerance: 1e-9 };
        self.numbers_only = true;
        for (key, text) in &description.simulation {
            if (key.text == "duration" && periodic) || key.text == "period" {
                continue;
            }
            let needed = match key.text.as_str() {
                "duration" => Unit::SECOND,
                "samples" | "tolerance" => Unit::NONE,
                other => {
                    let hint = "it has duration, period, samples and tolerance";
                    self.mistakes.push("E1702", &key.span, format!("[simulation] has no `{other}`"), hint);
                    continue;
                }
            };
            let Some(parsed) = parse(text, self) else { continue };
            let value = self.number(parsed.id);
            let good = match key.text.as_str() {
                "duration" => value > 0.0 && value < 1e12,
                "samples" => (1.0..=1e6).contains(&value),
                _ => (1e-13..=1e-2).contains(&value),
            };
            if parsed.unit.is_some_and(|unit| unit != needed) {
                let message = format!("`{}` needs {needed}, got {}", key.text, parsed.unit.unwrap_or(needed));
                self.mistakes.push("E1705", &text.span, message, "for example duration = \"2 s\"");
            } else if !good {
                let message = format!("`{}` is out of range, got {}", key.text, text.text);
                let hint = "duration above 0, samples 1 to 1000000, tolerance 1e-13 to 0.01";
                self.mistakes.push("E1712", &text.span, message, hint);
            }
            match key.text.as_str() {
                "duration" => asked.duration = value,
                "samples" => asked.samples = value as usize,
                _ => asked.tolerance = value,
            }
        }
        asked
    }
}

impl Scope for Checker<'_> {
    fn pool(&mut self) -> &mut Pool {
        &mut self.pool
    }

    fn mistakes(&mut self) -> &mut Mistakes {
        self.mistakes
    }

    fn table(&mut self, name: &str) -> Option<(u32, [Unit; 2])> {
        let place = self.pool.curves.iter().position(|(known, _)| known == name)?;
        Some((place as u32, self.pool.curves[place].1.units()))
    }

    fn name(&mut self, name: &str) -> Result<Parsed, Option<(String, String)>> {
        if let Some(parsed) = self.local.get(name) {
            return Ok(*parsed);
        }
        if name == "pi" {
            return Ok(Parsed { id: self.pool.constant(std::f64::consts::PI), unit: Some(Unit::NONE) });
        }
        if let Some(index) = self.description.parameters.iter().position(|(known, _)| known.text == name) {
            return self.parameter(index).ok_or(None);
        }
        if self.numbers_only {
            return Err(Some((
                format!("`{name}` is no parameter"),
                "parameters and start values are made of numbers and other parameters".into(),
            )));
        }
        if name == "t" || name == "time" {
            return Ok(Parsed { id: self.pool.var(Var::Time), unit: Some(Unit::SECOND) });
        }
        if let Some(index) = self.description.signals.iter().position(|entry| entry.name.text == name) {
            return self.signal(index).ok_or(None);
        }
        self.detector(name)
    }
}

impl Checker<'_> {
    /// `shaft.flow`, `slider.2.effort`, `spring.displacement`.
    fn detector(&mut self, name: &str) -> Result<Parsed, Option<(String, String)>> {
        let Some((path, what)) = name.rsplit_once('.') else {
            let known = (self.description.parameters.iter().map(|(name, _)| name.text.as_str()))
                .chain(self.description.signals.iter().map(|entry| entry.name.text.as_str()));
            let hint = match nearest(name, known) {
                Some(near) => format!("did you mean {near}?"),
                None => format!(
                    "add `{name}` to [parameters] or [signals]; a bond's variable is named like crank.flow"
                ),
            };
            return Err(Some((format!("`{name}` is not known"), hint)));
        };
        let (element_name, port) = match path.split_once('.') {
            Some((element, port)) => (element, port.parse::<usize>().ok()),
            None => (path, Some(1)),
        };
        let Some(index) = self.elements.iter().position(|element| element.name == element_name) else {
            if self.description.elements.iter().any(|entry| entry.name.text == element_name) {
                // Its kind is a mistake already.
                return Err(None);
            }
            return Err(Some((
                format!("there is no element `{element_name}`"),
                "name an element of [elements]".into(),
            )));
        };
        if !self.is_bonded(index) {
            return Err(None);
        }
        let element = &self.elements[index];
        let bond = port.and_then(|port| element.ports.get(port.checked_sub(1)?)).copied();
        let Some(bond) = bond else {
            return Err(Some((
                format!("`{path}` is no port"),
                format!("`{element_name}` has {} ports", element.ports.len()),
            )));
        };
        let shared = match element.kind {
            Kind::One => Some("flow"),
            Kind::Zero => Some("effort"),
            _ => None,
        };
        let domain = self.bonds[bond].domain;
        let number = bond as u32;
        let (var, unit) = match what {
            _ if shared.is_some_and(|shared| shared != what) => {
                let shared = shared.unwrap_or_default();
                let message = format!("junction `{element_name}` has one {shared}, no `{what}`");
                return Err(Some((
                    message,
                    format!("write {element_name}.{shared}, or name one of its elements"),
                )));
            }
            "effort" => (Var::Effort(number), domain.effort()),
            "flow" => (Var::Flow(number), domain.flow()),
            "displacement" if matches!(element.kind, Kind::C | Kind::Gas) => {
                (Var::Displacement(number), domain.flow().times(Unit::SECOND))
            }
            "momentum" if element.kind == Kind::I => {
                (Var::Momentum(number), domain.effort().times(Unit::SECOND))
            }
            _ => {
                let message = format!("`{element_name}` has no `{what}`");
                return Err(Some((
                    message,
                    "there are effort and flow, displacement of a C, momentum of an I".into(),
                )));
            }
        };
        Ok(Parsed { id: self.pool.var(var), unit: Some(unit) })
    }
}

/// The unit of `12.5 N m/A` as it is written, where it is one of SI as a whole.
fn written_unit(text: &str) -> Option<String> {
    let number = text.trim_start().trim_start_matches(['+', '-']);
    let digits = number.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+' | '-')))?;
    let rest = &number[digits..];
    let (length, factor, _) = leading_unit(rest)?;
    (factor == 1.0 && rest[length..].trim().is_empty()).then(|| rest.trim().to_owned())
}

/// Ports of a field: the largest number behind one of the letters in its energy.
fn field_ports(text: &Text, letters: &[char]) -> usize {
    let words = text.text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'));
    let number = |word: &str| -> Option<usize> {
        word.strip_prefix(letters)?.parse().ok().filter(|port| *port <= 100)
    };
    words.filter_map(number).max().unwrap_or(1)
}

/// The known word with the fewest edits, where that is a slip.
pub(crate) fn nearest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.to_lowercase().chars().take(41).collect();
    let distance = |other: &str| {
        let other: Vec<char> = other.to_lowercase().chars().collect();
        let mut last: Vec<usize> = (0..=other.len()).collect();
        for (i, letter) in letters.iter().enumerate() {
            let mut row = vec![i + 1; other.len() + 1];
            for j in 1..=other.len() {
                let replaced = last[j - 1] + usize::from(*letter != other[j - 1]);
                row[j] = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            }
            last = row;
        }
        last[other.len()]
    };
    known
        .map(|word| (distance(word), word))
        .filter(|(distance, word)| *distance <= word.len().max(3) / 3 && letters.len() <= 40)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}
