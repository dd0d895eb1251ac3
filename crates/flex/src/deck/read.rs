//! A deck as a mesh with its cases.

use super::springs::{Equation, springs};
use crate::case::{Fixed, NodeForce, StaticCase};
use crate::element::ElementKind;
use crate::mesh::{Element, Mesh, NodeSet};
use crate::{FlexError, Material};
use std::collections::{BTreeMap, BTreeSet};

/// What a step computes.
#[derive(Debug, Clone, PartialEq)]
pub enum DeckStep {
    /// A static case.
    Static(StaticCase),
    /// So many natural modes with the supports of this case.
    Frequency(usize, StaticCase),
}

/// A deck.
#[derive(Debug, Clone, PartialEq)]
pub struct Deck {
    /// Its mesh, in SI units. Nodes and elements are numbered anew in the order of the deck.
    pub mesh: Mesh,
    /// Its steps.
    pub steps: Vec<DeckStep>,
    /// The number of each node in the deck.
    pub node_numbers: Vec<u32>,
    /// The number of each element in the deck.
    pub element_numbers: Vec<u32>,
}

/// Cards that only ask for output.
const OUTPUTS: [&str; 6] =
    ["*NODE PRINT", "*EL PRINT", "*NODE FILE", "*EL FILE", "*NODE OUTPUT", "*ELEMENT OUTPUT"];

struct Card {
    line: usize,
    name: String,
    options: BTreeMap<String, String>,
}

/// Parameters that each card may have; what is not here would change the answer and is refused, but for cards of output.
const PARAMETERS: [(&str, &[&str]); 16] = [
    ("*NODE", &["NSET"]),
    ("*ELEMENT", &["TYPE", "ELSET"]),
    ("*NSET", &["NSET", "GENERATE"]),
    ("*ELSET", &["ELSET", "GENERATE"]),
    ("*MATERIAL", &["NAME"]),
    ("*ELASTIC", &["TYPE"]),
    ("*DENSITY", &[]),
    ("*SOLID SECTION", &["ELSET", "MATERIAL"]),
    ("*BOUNDARY", &[]),
    ("*EQUATION", &[]),
    ("*SPRING", &["ELSET"]),
    ("*CLOAD", &[]),
    ("*STEP", &["INC"]),
    ("*STATIC", &["SOLVER", "DIRECT"]),
    ("*FREQUENCY", &["SOLVER"]),
    ("*END STEP", &[]),
];

impl Card {
    /// Refuses a parameter that is not read.
    fn check(&self) -> Result<(), FlexError> {
        let Some((_, known)) = PARAMETERS.iter().find(|(name, _)| *name == self.name) else { return Ok(()) };
        let is_read = |key: &str, value: &str| {
            key.is_empty() || known.contains(&key) || (key, value) == ("NLGEOM", "NO")
        };
        let mut unknown = self.options.iter().filter(|(key, value)| !is_read(key, value));
        let Some((unknown, _)) = unknown.next() else { return Ok(()) };
        let read = match known {
            [] => "it has none that is read".to_owned(),
            known => format!("read are {}", known.join(", ")),
        };
        Err(wrong(
            self.line,
            format!("{} with the parameter {unknown}, which is not read: {read}", self.name),
        ))
    }
}

#[derive(Default)]
struct Reader {
    nodes: BTreeMap<u32, u32>,
    numbers: Vec<u32>,
    elements: BTreeMap<u32, u32>,
    mesh: Mesh,
    node_sets: BTreeMap<String, Vec<u32>>,
    element_sets: BTreeMap<String, Vec<u32>>,
    is_section: Vec<bool>,
    case: StaticCase,
    held: BTreeSet<(u32, u8)>,
    step: Option<(usize, Option<usize>, bool)>,
    steps: Vec<DeckStep>,
    equations: Vec<(usize, Equation)>,
    /// Line, set and node of each SPRING1 element, and the stiffness of each set.
    spring_elements: Vec<(usize, String, u32)>,
    stiffnesses: BTreeMap<String, f64>,
}

/// Reads a deck in N, mm, tonne, s, MPa.
///
/// # Errors
/// [`FlexError::Deck`] with the line of the first mistake; as [`Mesh::check`] where the mesh it makes is none.
pub fn read_deck(text: &str) -> Result<Deck, FlexError> {
    read_cards(text)?.finish()
}

/// As [`read_deck`], of a mesh: elements without a section have this material.
///
/// # Errors
/// As [`read_deck`].
pub fn read_mesh(text: &str, material: &Material) -> Result<Deck, FlexError> {
    let mut reader = read_cards(text)?;
    if reader.is_section.contains(&false) {
        let own = reader.mesh.materials.len() as u32;
        reader.mesh.materials.push(material.clone());
        for (element, is_section) in reader.mesh.elements.iter_mut().zip(&mut reader.is_section) {
            if !*is_section {
                (element.material, *is_section) = (own, true);
            }
        }
    }
    reader.finish()
}

fn read_cards(text: &str) -> Result<Reader, FlexError> {
    let mut reader = Reader::default();
    let mut card: Option<Card> = None;
    let mut data: Vec<(usize, Vec<String>)> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let (line, number) = (line.trim(), index + 1);
        if line.is_empty() || line.starts_with("**") {
            continue;
        }
        if !line.starts_with('*') {
            let fields =
                line.trim_end_matches(',').split(',').map(|field| field.trim().to_uppercase()).collect();
            data.push((number, fields));
            continue;
        }
        if let Some(card) = card.take() {
            reader.card(&card, &data)?;
        } else if let Some((line, _)) = data.first() {
            return Err(wrong(*line, "data before the first card; a deck begins with a card such as *NODE"));
        }
        data.clear();
        let mut parts = line.split(',').map(str::trim);
        let name = parts.next().unwrap_or_default().to_uppercase();
        let option = |part: &str| match part.split_once('=') {
            Some((key, value)) => (key.trim().to_uppercase(), value.trim().to_uppercase()),
            None => (part.to_uppercase(), String::new()),
        };
        card = Some(Card { line: number, name, options: parts.map(option).collect() });
    }
    if let Some(card) = card.take() {
        reader.card(&card, &data)?;
    }
    Ok(reader)
}

fn wrong(line: usize, message: impl Into<String>) -> FlexError {
    FlexError::Deck { line, message: message.into() }
}

fn number(line: usize, field: Option<&String>, what: &str) -> Result<f64, FlexError> {
    let field = field.ok_or_else(|| wrong(line, format!("{what} is missing")))?;
    let value = field.replace('D', "E").parse::<f64>().ok().filter(|value| value.is_finite());
    value.ok_or_else(|| wrong(line, format!("{what} must be a number, got \"{field}\"")))
}

fn index(line: usize, field: &str, what: &str) -> Result<u32, FlexError> {
    let value = field.parse::<u32>().ok().filter(|value| *value > 0);
    value.ok_or_else(|| wrong(line, format!("{what} must be a whole number above zero, got \"{field}\"")))
}

impl Reader {
    fn card(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        card.check()?;
        match card.name.as_str() {
            "*HEADING" => {
                self.case.name = data.first().map(|(_, fields)| fields.join(", ")).unwrap_or_default();
                Ok(())
            }
            "*NODE" => self.read_nodes(card, data),
            "*ELEMENT" => self.read_elements(card, data),
            "*NSET" | "*ELSET" => self.read_set(card, data),
            "*MATERIAL" => {
                let name =
                    card.options.get("NAME").ok_or_else(|| wrong(card.line, "*MATERIAL needs NAME="))?;
                let none =
                    Material { name: name.clone(), youngs_modulus: 0.0, poisson_ratio: 0.0, density: 0.0 };
                self.mesh.materials.push(none);
                Ok(())
            }
            "*ELASTIC" | "*DENSITY" => self.read_constants(card, data),
            "*SOLID SECTION" => self.read_section(card),
            "*BOUNDARY" => self.read_boundary(data),
            "*EQUATION" => self.read_equation(card, data),
            "*SPRING" => self.read_spring(card, data),
            "*CLOAD" => self.read_forces(card, data),
            "*STEP" => {
                if self.step.is_some() {
                    return Err(wrong(card.line, "a *STEP within a step; end the one before with *END STEP"));
                }
                self.step = Some((card.line, None, false));
                Ok(())
            }
            "*STATIC" => {
                if let Some(step) = &mut self.step {
                    step.2 = true;
                    return Ok(());
                }
                Err(wrong(card.line, "*STATIC outside a step; it follows *STEP"))
            }
            "*FREQUENCY" => {
                let Some((line, fields)) = data.first() else {
                    return Err(wrong(card.line, "*FREQUENCY needs the number of modes in the next line"));
                };
                let count = index(*line, fields.first().map_or("", String::as_str), "the number of modes")?;
                let step = self.step.as_mut().ok_or_else(|| wrong(card.line, "*FREQUENCY outside a step"))?;
                step.1 = Some(count as usize);
                Ok(())
            }
            "*END STEP" => self.end_step(card),
            name if OUTPUTS.contains(&name) => Ok(()),
            name => Err(wrong(
                card.line,
                format!(
                    "unknown card {name}; read are *NODE, *ELEMENT, *NSET, *ELSET, *MATERIAL, *ELASTIC, *DENSITY, *SOLID SECTION, *BOUNDARY, *EQUATION, *SPRING, *CLOAD, *STEP, *STATIC, *FREQUENCY, *END STEP"
                ),
            )),
        }
    }

    fn read_nodes(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let mut set = Vec::new();
        for (line, fields) in data {
            let name = index(*line, &fields[0], "the number of a node")?;
            let mut place = [0.0; 3];
            for (k, place) in place.iter_mut().enumerate() {
                *place = 1e-3 * number(*line, fields.get(k + 1), "a coordinate")?;
            }
            if self.nodes.insert(name, self.mesh.nodes.len() as u32).is_some() {
                return Err(wrong(*line, format!("node {name} is there twice; number each node once")));
            }
            set.push(self.mesh.nodes.len() as u32);
            self.mesh.nodes.push(place);
            self.numbers.push(name);
        }
        if let Some(name) = card.options.get("NSET") {
            self.node_sets.entry(name.clone()).or_default().extend(set);
        }
        Ok(())
    }

    fn read_elements(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let name = card.options.get("TYPE").ok_or_else(|| wrong(card.line, "*ELEMENT needs TYPE="))?;
        if name == "SPRING1" {
            return self.read_spring_elements(card, data);
        }
        let kind = ElementKind::ALL.into_iter().find(|kind| kind.deck_name() == name).ok_or_else(|| {
            wrong(card.line, format!("unknown element type {name}; read are C3D10, C3D15, C3D20 and SPRING1: leave out elements of lines and surfaces, and make linear ones quadratic"))
        })?;
        let mut set = Vec::new();
        let mut fields: Vec<u32> = Vec::new();
        for (line, more) in data {
            for field in more {
                fields.push(index(*line, field, "the number of an element or node")?);
            }
            if fields.len() > kind.nodes() + 1 {
                let (got, needed) = (fields.len() - 1, kind.nodes());
                return Err(wrong(
                    *line,
                    format!("element {} of type {name} has {got} nodes, needed {needed}", fields[0]),
                ));
            }
            if fields.len() < kind.nodes() + 1 {
                continue;
            }
            let find = |node: &u32| {
                let unknown =
                    || wrong(*line, format!("element {} names node {node}, which is not there", fields[0]));
                self.nodes.get(node).copied().ok_or_else(unknown)
            };
            let nodes = fields[1..].iter().map(find).collect::<Result<Vec<u32>, FlexError>>()?;
            let index = self.mesh.elements.len() as u32;
            if self.elements.insert(fields[0], index).is_some() {
                return Err(wrong(
                    *line,
                    format!("element {} is there twice; number each element once", fields[0]),
                ));
            }
            set.push(index);
            self.mesh.elements.push(Element { kind, nodes, material: 0 });
            self.is_section.push(false);
            fields.clear();
        }
        if let Some(element) = fields.first() {
            let (got, needed) = (fields.len() - 1, kind.nodes());
            return Err(wrong(
                card.line,
                format!("element {element} of type {name} has {got} nodes, needed {needed}"),
            ));
        }
        if let Some(name) = card.options.get("ELSET") {
            self.element_sets.entry(name.clone()).or_default().extend(set);
        }
        Ok(())
    }

    fn read_set(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let is_node = card.name == "*NSET";
        let key = if is_node { "NSET" } else { "ELSET" };
        let name =
            card.options.get(key).ok_or_else(|| wrong(card.line, format!("{} needs {key}=", card.name)))?;
        let mut members = Vec::new();
        for (line, fields) in data {
            if card.options.contains_key("GENERATE") {
                let from = index(*line, &fields[0], "the first number")?;
                let to = index(*line, fields.get(1).map_or("", String::as_str), "the last number")?;
                let step = match fields.get(2) {
                    Some(field) => index(*line, field, "the step")?,
                    None => 1,
                };
                if to < from {
                    return Err(wrong(*line, format!("the last number {to} is below the first one {from}")));
                }
                let numbers = if is_node { &self.nodes } else { &self.elements };
                for number in (from..=to).step_by(step as usize) {
                    members.push(*numbers.get(&number).ok_or_else(|| {
                        wrong(*line, format!("set {name} names number {number}, which is not there"))
                    })?);
                }
                continue;
            }
            for field in fields {
                members.extend(self.members(*line, field, is_node)?);
            }
        }
        let sets = if is_node { &mut self.node_sets } else { &mut self.element_sets };
        sets.entry(name.clone()).or_default().extend(members);
        Ok(())
    }

    /// A number or the name of a set, as indices.
    fn members(&self, line: usize, field: &str, is_node: bool) -> Result<Vec<u32>, FlexError> {
        let (numbers, sets, what) = if is_node {
            (&self.nodes, &self.node_sets, "node")
        } else {
            (&self.elements, &self.element_sets, "element")
        };
        if let Ok(number) = field.parse::<u32>() {
            let found = numbers.get(&number).copied();
            return found
                .map(|index| vec![index])
                .ok_or_else(|| wrong(line, format!("{what} {number} is not there")));
        }
        let found = sets.get(field).filter(|set| !set.is_empty()).cloned();
        found.ok_or_else(|| wrong(line, format!("{what} set {field} is missing or empty")))
    }

    fn read_constants(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let Some(material) = self.mesh.materials.last_mut() else {
            return Err(wrong(card.line, format!("{} before a *MATERIAL", card.name)));
        };
        let Some((line, fields)) = data.first() else {
            return Err(wrong(card.line, format!("{} needs numbers in the next line", card.name)));
        };
        if let Some(kind) = card.options.get("TYPE").filter(|kind| *kind != "ISO") {
            return Err(wrong(
                card.line,
                format!("elasticity of type {kind}: only isotropic materials are read"),
            ));
        }
        if card.name == "*DENSITY" {
            material.density = 1e12 * number(*line, fields.first(), "the density")?;
            return Ok(());
        }
        material.youngs_modulus = 1e6 * number(*line, fields.first(), "Young's modulus")?;
        material.poisson_ratio = number(*line, fields.get(1), "Poisson's ratio")?;
        if data.len() > 1 {
            return Err(wrong(data[1].0, "elasticity over temperature is not read; give one line"));
        }
        material.check().map_err(|source| wrong(*line, source.to_string()))
    }

    fn read_section(&mut self, card: &Card) -> Result<(), FlexError> {
        let option = |key: &str| {
            card.options.get(key).ok_or_else(|| wrong(card.line, format!("*SOLID SECTION needs {key}=")))
        };
        let (set, name) = (option("ELSET")?, option("MATERIAL")?);
        let place = self.mesh.materials.iter().position(|material| material.name == *name);
        let material = place.ok_or_else(|| wrong(card.line, format!("material {name} is not there")))? as u32;
        for element in self.members(card.line, set, false)? {
            self.mesh.elements[element as usize].material = material;
            self.is_section[element as usize] = true;
        }
        Ok(())
    }

    fn read_boundary(&mut self, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        for (line, fields) in data {
            let first =
                index(*line, fields.get(1).map_or("", String::as_str), "the first degree of freedom")?;
            let last = match fields.get(2).filter(|field| !field.is_empty()) {
                Some(field) => index(*line, field, "the last degree of freedom")?,
                None => first,
            };
            if first > last || last > 3 {
                return Err(wrong(
                    *line,
                    format!("degrees of freedom are 1, 2 and 3, got {first} to {last}"),
                ));
            }
            let value =
                if fields.len() > 3 { 1e-3 * number(*line, fields.get(3), "a displacement")? } else { 0.0 };
            for node in self.members(*line, &fields[0], true)? {
                for axis in first..=last {
                    let axis = (axis - 1) as u8;
                    if self.held.insert((node, axis)) {
                        self.case.fixed.push(Fixed { node, axis, value });
                        continue;
                    }
                    // A later line goes before an earlier one.
                    let own = |fixed: &&mut Fixed| (fixed.node, fixed.axis) == (node, axis);
                    if let Some(fixed) = self.case.fixed.iter_mut().find(own) {
                        fixed.value = value;
                    }
                }
            }
        }
        Ok(())
    }

    fn read_equation(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let mut fields =
            data.iter().flat_map(|(line, fields)| fields.iter().map(move |field| (*line, field)));
        while let Some((line, count)) = fields.next() {
            let count = index(line, count, "the number of terms")?;
            let mut equation = Equation::new();
            for _ in 0..count {
                let (Some((line, node)), Some((_, axis)), Some((_, factor))) =
                    (fields.next(), fields.next(), fields.next())
                else {
                    return Err(wrong(card.line, format!("an equation of {count} terms ends too early")));
                };
                let axis = index(line, axis, "the degree of freedom")?;
                if axis > 3 {
                    return Err(wrong(line, format!("degrees of freedom are 1, 2 and 3, got {axis}")));
                }
                let factor = number(line, Some(factor), "a factor")?;
                let node = index(line, node, "the number of a node")?;
                let found = self.nodes.get(&node).copied();
                let node = found.ok_or_else(|| wrong(line, format!("node {node} is not there")))?;
                equation.push((node, (axis - 1) as u8, factor));
            }
            self.equations.push((card.line, equation));
        }
        Ok(())
    }

    fn read_spring_elements(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let set =
            card.options.get("ELSET").ok_or_else(|| wrong(card.line, "SPRING1 elements need ELSET="))?;
        for (line, fields) in data {
            index(*line, &fields[0], "the number of an element")?;
            let node = index(*line, fields.get(1).map_or("", String::as_str), "the number of a node")?;
            let found = self.nodes.get(&node).copied();
            let node = found.ok_or_else(|| wrong(*line, format!("node {node} is not there")))?;
            self.spring_elements.push((*line, set.clone(), node));
        }
        Ok(())
    }

    fn read_spring(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        let set = card.options.get("ELSET").ok_or_else(|| wrong(card.line, "*SPRING needs ELSET="))?;
        let [(line, axis), (stiffness_line, stiffness)] = data else {
            return Err(wrong(
                card.line,
                "*SPRING needs its degree of freedom and, in the next line, its stiffness",
            ));
        };
        if axis.first().map(String::as_str) != Some("1") {
            return Err(wrong(*line, "a spring is read along degree of freedom 1 of a reference node"));
        }
        let stiffness = 1e3 * number(*stiffness_line, stiffness.first(), "the stiffness")?;
        self.stiffnesses.insert(set.clone(), stiffness);
        Ok(())
    }

    /// Takes reference nodes out of the mesh, and gives every step its springs.
    fn take_springs(&mut self) -> Result<(), FlexError> {
        let mut used = vec![false; self.mesh.nodes.len()];
        for node in self.mesh.elements.iter().flat_map(|element| &element.nodes) {
            used[*node as usize] = true;
        }
        let mut references = Vec::new();
        for (line, set, node) in &self.spring_elements {
            if used[*node as usize] {
                return Err(wrong(
                    *line,
                    "a SPRING1 element is read on a reference node that no other element uses",
                ));
            }
            let stiffness = self.stiffnesses.get(set);
            let stiffness = stiffness.ok_or_else(|| wrong(*line, format!("set {set} has no *SPRING")))?;
            references.push((*node, *stiffness, set.clone()));
        }
        let springs = springs(&self.equations, &references)?;
        if references.is_empty() {
            return Ok(());
        }
        let mut number = vec![u32::MAX; used.len()];
        let mut count = 0;
        for (node, number) in number.iter_mut().enumerate() {
            if references.iter().all(|(own, ..)| *own as usize != node) {
                *number = count;
                count += 1;
            }
        }
        let kept = |node: &u32| number[*node as usize] != u32::MAX;
        let mut place = 0..;
        self.mesh.nodes.retain(|_| place.next().is_some_and(|node: u32| kept(&node)));
        let mut place = 0..;
        self.numbers.retain(|_| place.next().is_some_and(|node: u32| kept(&node)));
        for node in self.mesh.elements.iter_mut().flat_map(|element| &mut element.nodes) {
            *node = number[*node as usize];
        }
        for nodes in self.node_sets.values_mut() {
            nodes.retain(kept);
            nodes.iter_mut().for_each(|node| *node = number[*node as usize]);
        }
        self.node_sets.retain(|_, nodes| !nodes.is_empty());
        for step in &mut self.steps {
            let (DeckStep::Static(case) | DeckStep::Frequency(_, case)) = step;
            case.fixed.retain(|fixed| kept(&fixed.node));
            case.forces.retain(|force| kept(&force.node));
            case.fixed.iter_mut().for_each(|fixed| fixed.node = number[fixed.node as usize]);
            case.forces.iter_mut().for_each(|force| force.node = number[force.node as usize]);
            case.springs.clone_from(&springs);
            for (node, _) in case.springs.iter_mut().flat_map(|spring| &mut spring.nodes) {
                *node = number[*node as usize];
            }
        }
        Ok(())
    }

    fn read_forces(&mut self, card: &Card, data: &[(usize, Vec<String>)]) -> Result<(), FlexError> {
        if self.step.is_none() {
            return Err(wrong(card.line, "*CLOAD outside a step; it follows *STATIC"));
        }
        for (line, fields) in data {
            let axis = index(*line, fields.get(1).map_or("", String::as_str), "the degree of freedom")?;
            if axis > 3 {
                return Err(wrong(*line, format!("degrees of freedom are 1, 2 and 3, got {axis}")));
            }
            let value = number(*line, fields.get(2), "a force")?;
            for node in self.members(*line, &fields[0], true)? {
                let mut force = [0.0; 3];
                force[axis as usize - 1] = value;
                self.case.forces.push(NodeForce { node, force });
            }
        }
        Ok(())
    }

    fn end_step(&mut self, card: &Card) -> Result<(), FlexError> {
        let Some((_, frequency, is_static)) = self.step.take() else {
            return Err(wrong(card.line, "*END STEP without *STEP"));
        };
        match (frequency, is_static) {
            (Some(count), _) => self.steps.push(DeckStep::Frequency(count, self.case.clone())),
            (None, true) => self.steps.push(DeckStep::Static(self.case.clone())),
            (None, false) => return Err(wrong(card.line, "the step has neither *STATIC nor *FREQUENCY")),
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Deck, FlexError> {
        if let Some((line, ..)) = self.step {
            return Err(wrong(line, "the step that begins here has no *END STEP"));
        }
        if let Some(element) = self.is_section.iter().position(|is_section| !is_section) {
            let number = self.elements.iter().find(|(_, index)| **index as usize == element);
            return Err(FlexError::Missing {
                what: "material of element",
                name: number.map_or(0, |(number, _)| *number).to_string(),
                hint: "a *SOLID SECTION names its set and its material",
            });
        }
        self.take_springs()?;
        for (name, mut nodes) in std::mem::take(&mut self.node_sets) {
            nodes.sort_unstable();
            nodes.dedup();
            self.mesh.sets.push(NodeSet { name, nodes });
        }
        let mut element_numbers = vec![0; self.mesh.elements.len()];
        for (number, index) in &self.elements {
            element_numbers[*index as usize] = *number;
        }
        // Whoever made the deck knows its own numbers.
        self.mesh.check().map_err(|error| match error {
            FlexError::Inverted { element, at, jacobian, needed } => {
                FlexError::Inverted { element: element_numbers[element - 1] as usize, at, jacobian, needed }
            }
            FlexError::FreeNode { node } => FlexError::FreeNode { node: self.numbers[node - 1] as usize },
            other => other,
        })?;
        Ok(Deck { mesh: self.mesh, steps: self.steps, node_numbers: self.numbers, element_numbers })
    }
}
