//! Laws of elements: their keys, expressions and units.

use super::Checker;
use crate::description::Text;
use crate::expression::{Id, Parsed, Var, parse};
use crate::graph::{Element, Kind, Law, StorePort};
use crate::unit::Unit;
use std::collections::HashMap;

/// Longest expression of a drawing.
const LONGEST_VALUE: usize = 22;

/// A number with four digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

impl Checker<'_> {
    /// The law of an element.
    pub(super) fn law(&mut self, index: usize) {
        let element = self.elements[index].clone();
        let entry = self.entry(index).clone();
        let (laws, others): (&[&str], &[&str]) = match element.kind {
            Kind::Se => (&["effort"], &[]),
            Kind::Sf => (&["flow"], &[]),
            Kind::R => (&["resistance", "effort", "flow"], &[]),
            Kind::C => (&["capacitance", "stiffness", "law", "energy"], &["effort", "displacement"]),
            Kind::I => (&["inertia", "law", "energy", "coenergy"], &["flow", "momentum"]),
            Kind::IC => (&["energy"], &["displacement", "momentum"]),
            Kind::Gas => (&["gas_constant"], &["heat_capacity", "volume", "pressure", "temperature"]),
            Kind::TF => (&["ratio", "matrix"], &[]),
            Kind::GY => (&["ratio"], &[]),
            Kind::Zero | Kind::One => (&[], &[]),
        };
        for (key, _) in &entry.keys {
            let name = key.text.as_str();
            if !laws.contains(&name) && !others.contains(&name) && name != "kind" && name != "domain" {
                let all: Vec<&str> = laws.iter().chain(others).copied().chain(["domain"]).collect();
                let message = format!("`{}` ({}) has no key `{name}`", element.name, element.written);
                self.mistakes.push("E1702", &key.span, message, format!("it has {}", all.join(", ")));
            }
        }
        let given: Vec<(&str, Text)> =
            laws.iter().filter_map(|key| entry.get(key).map(|text| (*key, text.clone()))).collect();
        if !laws.is_empty() && given.len() != 1 {
            let count = if given.is_empty() { "no law" } else { "two laws" };
            let message = format!("`{}` ({}) has {count}", element.name, element.written);
            self.mistakes.push("E1709", &element.span, message, format!("give one of {}", laws.join(", ")));
            return;
        }
        if !self.is_bonded(index) {
            // What it says of its bonds cannot be read.
            return;
        }
        let law = match (element.kind, given.first()) {
            (Kind::Zero | Kind::One, _) | (_, None) => Some(Law::Junction),
            (Kind::Se | Kind::Sf, Some((_, text))) => {
                let domain = self.bonds[element.ports[0]].domain;
                let unit = if element.kind == Kind::Se { domain.effort() } else { domain.flow() };
                self.of_unit(text, unit, &element.name).map(Law::Source)
            }
            (Kind::Gas, Some((_, text))) => self.gas(index, text),
            (Kind::R, Some((key, text))) if element.ports.len() > 1 => {
                self.resistors(&element.ports, key, text, &element.name)
            }
            (Kind::R, Some((key, text))) => self.resistor(element.ports[0], key, text, &element.name),
            (Kind::TF, Some(("matrix", text))) => self.matrix(&element.ports, text, &element.name),
            (Kind::TF, Some((_, text))) => {
                let [first, second] =
                    [element.ports[0], element.ports[1]].map(|bond| self.bonds[bond].domain);
                self.of_unit(text, second.flow().over(first.flow()), &element.name).map(Law::Ratio)
            }
            (Kind::GY, Some((_, text))) => {
                let [first, second] =
                    [element.ports[0], element.ports[1]].map(|bond| self.bonds[bond].domain);
                self.of_unit(text, first.effort().over(second.flow()), &element.name).map(Law::Ratio)
            }
            (_, Some(("energy", text))) => self.field(index, text),
            (_, Some(("coenergy", text))) => self.following_field(index, text),
            (_, Some((key, text))) => self.store(index, key, text),
        };
        if let Some(law) = law {
            self.elements[index].law = law;
            self.elements[index].value = given.first().and_then(|(key, text)| self.value(index, key, text));
        }
    }

    /// What a drawing says of a law: the number of a constant in SI, or the expression where it is short.
    fn value(&mut self, index: usize, key: &str, text: &Text) -> Option<String> {
        let is_short = text.text.chars().count() <= LONGEST_VALUE && key != "matrix" && key != "gas_constant";
        match self.coefficient(index, key) {
            Some((id, unit))
                if self.pool.variables(&[id]).iter().all(|var| matches!(var, Var::Parameter(_))) =>
            {
                let value = short(self.number(id));
                Some(if unit == "1" { value } else { format!("{value} {unit}") })
            }
            _ => is_short.then(|| text.text.clone()),
        }
    }

    /// The one number of a law, with its unit.
    fn coefficient(&mut self, index: usize, key: &str) -> Option<(Id, String)> {
        let element = self.elements[index].clone();
        let bond = element.ports[0];
        let domain = self.bonds[bond].domain;
        let number = bond as u32;
        let [resistance, capacitance, inertia, stiffness] = domain.coefficient_names();
        let (law, var, unit) = match (&element.law, key) {
            (Law::Source(value), _) => {
                return Some((*value, domain.unit_names()[usize::from(element.kind == Kind::Sf)].to_owned()));
            }
            (Law::Ratio(ratio), _) => {
                let second = self.bonds[element.ports[1]].domain;
                let is_transformer = element.kind == Kind::TF;
                let above = if is_transformer { second.flow() } else { domain.effort() };
                let below = if is_transformer { domain.flow() } else { second.flow() };
                return Some((*ratio, above.over(below).to_string()));
            }
            (Law::Resistor { effort: Some(law), .. }, "resistance") => (*law, Var::Flow(number), resistance),
            (Law::Store(ports), "inertia") => (ports[0].inverse?, Var::Flow(number), inertia),
            (Law::Store(ports), "capacitance") => (ports[0].inverse?, Var::Effort(number), capacitance),
            (Law::Store(ports), "stiffness") => (ports[0].effort?, Var::Displacement(number), stiffness),
            _ => return None,
        };
        Some((self.pool.derivative(law, var, &mut HashMap::new()), unit.to_owned()))
    }

    /// An expression that must have a unit.
    fn of_unit(&mut self, text: &Text, needed: Unit, name: &str) -> Option<Id> {
        let parsed = parse(text, self)?;
        self.check_unit(text, parsed, needed, name);
        Some(parsed.id)
    }

    fn check_unit(&mut self, text: &Text, parsed: Parsed, needed: Unit, name: &str) {
        if let Some(unit) = parsed.unit
            && unit != needed
        {
            let message = format!("`{name}` needs a value in {needed}, got `{}` in {unit}", text.text);
            self.mistakes.push("E1705", &text.span, message, format!("write it in {needed}"));
        }
    }

    /// A number of a unit, from parameters alone.
    fn start(&mut self, text: Option<&Text>, needed: Unit, name: &str) -> Option<f64> {
        let text = text?;
        self.numbers_only = true;
        let parsed = parse(text, self);
        self.numbers_only = false;
        let parsed = parsed?;
        self.check_unit(text, parsed, needed, name);
        let value = self.number(parsed.id);
        if !value.is_finite() {
            let message = format!("the start of `{name}` is no finite number");
            self.mistakes.push("E1704", &text.span, message, "check divisions and roots in it");
        }
        Some(value)
    }

    /// Notes a constant that is not positive.
    fn positive(&mut self, id: Id, text: &Text, name: &str, what: &str) {
        let vars = self.pool.variables(&[id]);
        if vars.iter().all(|var| matches!(var, Var::Parameter(_))) {
            let value = self.number(id);
            if value.is_nan() || value <= 0.0 {
                let message = format!("`{name}` has the {what} {value}, it must be positive");
                self.mistakes.push(
                    "E1712",
                    &text.span,
                    message,
                    "check the number; take the element out where there is none",
                );
            }
        }
    }

    fn resistor(&mut self, bond: usize, key: &str, text: &Text, name: &str) -> Option<Law> {
        let domain = self.bonds[bond].domain;
        let (effort, flow) = (Var::Effort(bond as u32), Var::Flow(bond as u32));
        let (effort, flow) = (self.pool.var(effort), self.pool.var(flow));
        match key {
            "resistance" => {
                let resistance = self.of_unit(text, domain.effort().over(domain.flow()), name)?;
                if self.pool.value(resistance) != Some(0.0) {
                    self.positive(resistance, text, name, "resistance");
                }
                Some(Law::Resistor {
                    effort: Some(self.pool.product(resistance, flow)),
                    flow: Some(self.pool.quotient(effort, resistance)),
                })
            }
            "effort" => {
                self.local = HashMap::from([("f".into(), Parsed { id: flow, unit: Some(domain.flow()) })]);
                let law = self.of_unit(text, domain.effort(), name);
                self.local.clear();
                Some(Law::Resistor { effort: Some(law?), flow: None })
            }
            _ => {
                self.local =
                    HashMap::from([("e".into(), Parsed { id: effort, unit: Some(domain.effort()) })]);
                let law = self.of_unit(text, domain.flow(), name);
                self.local.clear();
                Some(Law::Resistor { effort: None, flow: Some(law?) })
            }
        }
    }

    /// A resistor of several ports: a list of flows by `e1`, `e2`, or of efforts by `f1`, `f2`.
    fn resistors(&mut self, ports: &[usize], key: &str, text: &Text, name: &str) -> Option<Law> {
        let gives_flows = key == "flow";
        let mut local = HashMap::new();
        for (port, bond) in ports.iter().enumerate() {
            let domain = self.bonds[*bond].domain;
            let number = *bond as u32;
            let (var, unit, letter) = if gives_flows {
                (Var::Effort(number), domain.effort(), "e")
            } else {
                (Var::Flow(number), domain.flow(), "f")
            };
            local
                .insert(format!("{letter}{}", port + 1), Parsed { id: self.pool.var(var), unit: Some(unit) });
        }
        let mut laws = Vec::new();
        for (bond, part) in ports.iter().zip(text.text.split(';')) {
            let domain = self.bonds[*bond].domain;
            let unit = if gives_flows { domain.flow() } else { domain.effort() };
            self.local.clone_from(&local);
            let law =
                self.of_unit(&Text { text: part.trim().to_owned(), span: text.span.clone() }, unit, name);
            self.local.clear();
            laws.push(law?);
        }
        Some(Law::Resistors { gives_flows, laws })
    }

    /// A perfect gas: ports of volume (that is taken from it), mass and energy.
    ///
    /// ```text
    /// V = V_0 - q_1    P = R E/(c_v V) at ports 1 and 2    T = E/(m c_v) at port 3    E' = f_3 + P f_1
    /// ```
    fn gas(&mut self, index: usize, text: &Text) -> Option<Law> {
        let element = self.elements[index].clone();
        let entry = self.entry(index).clone();
        let name = element.name.as_str();
        let per_mass = Unit::of([2, 0, -2, 0, -1]);
        let constant = self.of_unit(text, per_mass, name)?;
        self.positive(constant, text, name, "gas constant");
        let needed = |checker: &mut Self, key: &str| -> Option<Text> {
            let text = entry.get(key).cloned();
            if text.is_none() {
                let message = format!("`{name}` (Gas) has no {key}");
                checker.mistakes.push("E1709", &element.span, message, format!("add {key}"));
            }
            text
        };
        let capacity_text = needed(self, "heat_capacity")?;
        let (volume, pressure, temperature) =
            (needed(self, "volume")?, needed(self, "pressure")?, needed(self, "temperature")?);
        let capacity = self.of_unit(&capacity_text, per_mass, name)?;
        self.positive(capacity, &capacity_text, name, "heat capacity");
        let mut starts = [0.0; 3];
        let units = [Unit::of([3, 0, 0, 0, 0]), Unit::of([-1, 1, -2, 0, 0]), Unit::of([0, 0, 0, 0, 1])];
        for (k, (text, what)) in [(&volume, "volume"), (&pressure, "pressure"), (&temperature, "temperature")]
            .into_iter()
            .enumerate()
        {
            starts[k] = self.start(Some(text), units[k], name)?;
            if starts[k] <= 0.0 {
                let message = format!("`{name}` starts with the {what} {}, it must be positive", starts[k]);
                self.mistakes.push("E1712", &text.span, message, "a vacuum has a small pressure");
            }
        }
        let [volume, pressure, temperature] = starts;
        let [a, b, c] = [element.ports[0], element.ports[1], element.ports[2]].map(|bond| bond as u32);
        let [taken, mass, energy] = [a, b, c].map(|bond| self.pool.var(Var::Displacement(bond)));
        let whole = self.pool.constant(volume);
        let left = self.pool.difference(whole, taken);
        let above = self.pool.product(constant, energy);
        let below = self.pool.product(capacity, left);
        let gas_pressure = self.pool.quotient(above, below);
        let below = self.pool.product(mass, capacity);
        let gas_temperature = self.pool.quotient(energy, below);
        let rate = self.pool.var(Var::Flow(a));
        let work = self.pool.product(gas_pressure, rate);
        let (constant, capacity) = (self.number(constant), self.number(capacity));
        let start_mass = pressure * volume / (constant * temperature);
        let port = |effort: Id, gain: Option<Id>, start: f64| StorePort {
            effort: Some(effort),
            flow: None,
            inverse: None,
            gain,
            start: [start, 0.0],
        };
        Some(Law::Store(vec![
            port(gas_pressure, None, 0.0),
            port(gas_pressure, None, start_mass),
            port(gas_temperature, Some(work), start_mass * capacity * temperature),
        ]))
    }

    fn matrix(&mut self, ports: &[usize], text: &Text, name: &str) -> Option<Law> {
        let rows: Vec<Vec<&str>> =
            text.text.split('|').map(|row| row.split(';').map(str::trim).collect()).collect();
        let columns = rows[0].len();
        if rows.iter().any(|row| row.len() != columns) {
            let message = format!("the rows of the matrix of `{name}` differ in length");
            self.mistakes.push("E1709", &text.span, message, "give every row the same number of entries");
            return None;
        }
        let mut law = Vec::new();
        for (row, entries) in rows.iter().enumerate() {
            let mut ids = Vec::new();
            for (column, entry) in entries.iter().enumerate() {
                let out = self.bonds[ports[columns + row]].domain;
                let into = self.bonds[ports[column]].domain;
                let entry = Text { text: (*entry).to_owned(), span: text.span.clone() };
                ids.push(self.of_unit(&entry, out.flow().over(into.flow()), name)?);
            }
            law.push(ids);
        }
        Some(Law::Matrix(law))
    }

    fn store(&mut self, index: usize, key: &str, text: &Text) -> Option<Law> {
        let element = self.elements[index].clone();
        let entry = self.entry(index).clone();
        let (name, bond) = (element.name.as_str(), element.ports[0]);
        let domain = self.bonds[bond].domain;
        let number = bond as u32;
        let capacitor = element.kind == Kind::C;
        let (across, through) =
            if capacitor { (domain.effort(), domain.flow()) } else { (domain.flow(), domain.effort()) };
        let stored = through.times(Unit::SECOND);
        let content = if capacitor { Var::Displacement(number) } else { Var::Momentum(number) };
        let co_variable = if capacitor { Var::Effort(number) } else { Var::Flow(number) };
        let (content, co_variable) = (self.pool.var(content), self.pool.var(co_variable));
        let (law, inverse, measure) = match key {
            "capacitance" | "inertia" => {
                let measure = self.of_unit(text, stored.over(across), name)?;
                self.positive(measure, text, name, key);
                let (law, inverse) =
                    (self.pool.quotient(content, measure), self.pool.product(measure, co_variable));
                (law, Some(inverse), Some(measure))
            }
            "stiffness" => {
                let stiffness = self.of_unit(text, across.over(stored), name)?;
                self.positive(stiffness, text, name, key);
                let (law, inverse) =
                    (self.pool.product(stiffness, content), self.pool.quotient(co_variable, stiffness));
                let one = self.pool.constant(1.0);
                (law, Some(inverse), Some(self.pool.quotient(one, stiffness)))
            }
            _ => {
                let local = if capacitor { "q" } else { "p" };
                self.local = HashMap::from([(local.into(), Parsed { id: content, unit: Some(stored) })]);
                let law = self.of_unit(text, across, name);
                self.local.clear();
                (law?, None, None)
            }
        };
        let (by_content, by_co_variable) =
            if capacitor { ("displacement", "effort") } else { ("momentum", "flow") };
        let content_start = self.start(entry.get(by_content), stored, name);
        let co_start = self.start(entry.get(by_co_variable), across, name);
        let start = match (content_start, co_start, measure) {
            (Some(_), Some(_), _) => {
                let message = format!("`{name}` starts with both {by_content} and {by_co_variable}");
                self.mistakes.push("E1709", &element.span, message, "give one of them");
                0.0
            }
            (Some(value), None, _) => value,
            (None, Some(value), Some(measure)) => {
                let vars = self.pool.variables(&[measure]);
                if !vars.iter().all(|var| matches!(var, Var::Parameter(_))) {
                    let message = format!("`{name}` starts with a {by_co_variable}, but its {key} varies");
                    self.mistakes.push("E1709", &element.span, message, format!("give its {by_content}"));
                }
                value * self.number(measure)
            }
            (None, Some(_), None) => {
                let message = format!("`{name}` has a law of its own: its start is a {by_content}");
                self.mistakes.push("E1709", &element.span, message, format!("give {by_content} instead"));
                0.0
            }
            (None, None, _) => 0.0,
        };
        Some(Law::Store(vec![if capacitor {
            StorePort { effort: Some(law), flow: None, inverse, gain: None, start: [start, 0.0] }
        } else {
            StorePort { effort: None, flow: Some(law), inverse, gain: None, start: [0.0, start] }
        }]))
    }

    /// A field by its energy: efforts are derivatives by the displacements, flows by the momenta.
    fn field(&mut self, index: usize, text: &Text) -> Option<Law> {
        let element = self.elements[index].clone();
        let entry = self.entry(index).clone();
        let mut local = HashMap::new();
        for (port, bond) in element.ports.iter().enumerate() {
            let domain = self.bonds[*bond].domain;
            let number = *bond as u32;
            for (letter, var, unit) in [
                ("q", Var::Displacement(number), domain.flow()),
                ("p", Var::Momentum(number), domain.effort()),
            ] {
                let parsed = Parsed { id: self.pool.var(var), unit: Some(unit.times(Unit::SECOND)) };
                local.insert(format!("{letter}{}", port + 1), parsed);
                if element.ports.len() == 1 {
                    local.insert(letter.to_owned(), parsed);
                }
            }
        }
        self.local = local;
        let energy = self.of_unit(text, Unit::JOULE, &element.name);
        self.local.clear();
        let energy = energy?;
        let vars = self.pool.variables(&[energy]);
        let starts = |key: &str| -> Vec<Text> {
            let text = entry.get(key).cloned().unwrap_or_default();
            text.text
                .split(';')
                .map(|part| Text { text: part.trim().to_owned(), span: text.span.clone() })
                .collect()
        };
        let (displacements, momenta) = (starts("displacement"), starts("momentum"));
        let mut ports = Vec::new();
        for (port, bond) in element.ports.iter().enumerate() {
            let domain = self.bonds[*bond].domain;
            let number = *bond as u32;
            let (q, p) = (Var::Displacement(number), Var::Momentum(number));
            let has =
                [vars.contains(&q) && element.kind != Kind::I, vars.contains(&p) && element.kind != Kind::C];
            if !has[0] && !has[1] {
                let message =
                    format!("the energy of `{}` does not depend on port {}", element.name, port + 1);
                let hint = format!("name q{0} or p{0} in it, or leave the port out", port + 1);
                self.mistakes.push("E1709", &text.span, message, hint);
            }
            let mut slope = |var: Var| self.pool.derivative(energy, var, &mut HashMap::new());
            let (effort, flow) = (has[0].then(|| slope(q)), has[1].then(|| slope(p)));
            let given = |list: &[Text]| list.get(port).filter(|text| !text.text.is_empty()).cloned();
            let start_q =
                self.start(given(&displacements).as_ref(), domain.flow().times(Unit::SECOND), &element.name);
            let start_p =
                self.start(given(&momenta).as_ref(), domain.effort().times(Unit::SECOND), &element.name);
            let start = [start_q.unwrap_or(0.0), start_p.unwrap_or(0.0)];
            ports.push(StorePort { effort, flow, inverse: None, gain: None, start });
        }
        self.positive_inertia(&element, &ports, text);
        self.elements[index].energy = Some(energy);
        Some(Law::Store(ports))
    }

    /// Notes a momentum whose flow falls as it rises, at the start: no inertia is negative. (A spring may be, about an unstable place.)
    fn positive_inertia(&mut self, element: &Element, ports: &[StorePort], text: &Text) {
        for (port, law) in ports.iter().enumerate() {
            let Some(flow) = law.flow else { continue };
            let momentum = Var::Momentum(element.ports[port] as u32);
            let slope = self.pool.derivative(flow, momentum, &mut HashMap::new());
            let start = |bond: u32, which: usize| {
                let port = element.ports.iter().position(|own| *own as u32 == bond);
                port.map_or(f64::NAN, |port| ports[port].start[which])
            };
            let value = self.pool.evaluate(slope, &|var| match var {
                Var::Parameter(index) => self.parameters[index as usize].value,
                Var::Displacement(bond) => start(bond, 0),
                Var::Momentum(bond) => start(bond, 1),
                _ => f64::NAN,
            });
            if value < 0.0 {
                let message = format!(
                    "the flow of port {} of `{}` falls as its momentum rises: an inertia must be positive",
                    port + 1,
                    element.name
                );
                self.mistakes.push("E1712", &text.span, message, "check the signs of the energy");
            }
        }
    }

    /// A field of inertias by its co-energy: momenta are derivatives by the flows, so every port follows.
    fn following_field(&mut self, index: usize, text: &Text) -> Option<Law> {
        let element = self.elements[index].clone();
        let entry = self.entry(index).clone();
        for key in ["flow", "momentum"] {
            if let Some(given) = entry.get(key) {
                let message = format!("`{}` follows the flows of its bonds: it has no start", element.name);
                self.mistakes.push("E1709", &given.span, message, format!("take `{key}` out"));
            }
        }
        let mut local = HashMap::new();
        for (port, bond) in element.ports.iter().enumerate() {
            let unit = Some(self.bonds[*bond].domain.flow());
            let parsed = Parsed { id: self.pool.var(Var::Flow(*bond as u32)), unit };
            local.insert(format!("f{}", port + 1), parsed);
            if element.ports.len() == 1 {
                local.insert("f".to_owned(), parsed);
            }
        }
        self.local = local;
        let coenergy = self.of_unit(text, Unit::JOULE, &element.name);
        self.local.clear();
        let coenergy = coenergy?;
        let mut ports = Vec::new();
        // Energy = sum of p f - coenergy.
        let mut energy = self.pool.negative(coenergy);
        for (port, bond) in element.ports.iter().enumerate() {
            let momentum = self.pool.derivative(coenergy, Var::Flow(*bond as u32), &mut HashMap::new());
            if self.pool.is_zero(momentum) {
                let message =
                    format!("the co-energy of `{}` does not depend on port {}", element.name, port + 1);
                let hint = format!("name f{} in it, or leave the port out", port + 1);
                self.mistakes.push("E1709", &text.span, message, hint);
            }
            let flow = self.pool.var(Var::Flow(*bond as u32));
            let product = self.pool.product(momentum, flow);
            energy = self.pool.sum(energy, product);
            ports.push(StorePort {
                effort: None,
                flow: None,
                inverse: Some(momentum),
                gain: None,
                start: [0.0; 2],
            });
        }
        self.elements[index].energy = Some(energy);
        Some(Law::Store(ports))
    }
}
