//! Laws of elements: their keys, expressions and units.

use super::Checker;
use crate::description::Text;
use crate::expression::{Id, Parsed, Var, parse};
use crate::graph::{Kind, Law, StorePort};
use crate::unit::Unit;
use std::collections::HashMap;

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
        let law = match (element.kind, given.first()) {
            (Kind::Zero | Kind::One, _) | (_, None) => Some(Law::Junction),
            (Kind::Se | Kind::Sf, Some((_, text))) => {
                let domain = self.bonds[element.ports[0]].domain;
                let unit = if element.kind == Kind::Se { domain.effort() } else { domain.flow() };
                self.of_unit(text, unit, &element.name).map(Law::Source)
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
        }
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
            StorePort { effort: Some(law), flow: None, inverse, start: [start, 0.0] }
        } else {
            StorePort { effort: None, flow: Some(law), inverse, start: [0.0, start] }
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
            ports.push(StorePort { effort, flow, inverse: None, start });
        }
        Some(Law::Store(ports))
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
        for (port, bond) in element.ports.iter().enumerate() {
            let momentum = self.pool.derivative(coenergy, Var::Flow(*bond as u32), &mut HashMap::new());
            if self.pool.is_zero(momentum) {
                let message =
                    format!("the co-energy of `{}` does not depend on port {}", element.name, port + 1);
                let hint = format!("name f{} in it, or leave the port out", port + 1);
                self.mistakes.push("E1709", &text.span, message, hint);
            }
            ports.push(StorePort { effort: None, flow: None, inverse: Some(momentum), start: [0.0; 2] });
        }
        Some(Law::Store(ports))
    }
}
