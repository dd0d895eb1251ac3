//! What stands at an element of a drawing: its name, and its value where one number says its law.

use crate::causality::Causality;
use crate::graph::{Element, Graph};

/// Width of a letter of a name [px].
const LETTER: f64 = 6.2;

/// Name and value of an element, and the space that they take from its middle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Label {
    pub(crate) name: String,
    pub(crate) value: Option<String>,
    /// To the left [px].
    pub(crate) left: f64,
    /// To the right [px].
    pub(crate) right: f64,
}

impl Label {
    /// Width of its name [px].
    pub(crate) fn name_width(&self) -> f64 {
        LETTER * self.name.chars().count() as f64
    }
}

/// Labels of all elements.
pub(crate) fn labels(graph: &Graph, causality: &Causality) -> Vec<Label> {
    graph
        .elements
        .iter()
        .enumerate()
        .map(|(index, element)| label(graph, causality, index, element))
        .collect()
}

fn label(graph: &Graph, causality: &Causality, index: usize, element: &Element) -> Label {
    let name = match follows(graph, causality, index) {
        true => format!("{} (follows)", element.name),
        false => element.name.clone(),
    };
    let letters = |text: &str| LETTER * text.chars().count() as f64;
    let [of_name, of_value] = [letters(&name), element.value.as_deref().map_or(0.0, letters)];
    let [left, right] = match element.ports.len() {
        1 => [of_name.max(of_value) / 2.0; 2],
        // From its letters on, above bonds, on one line.
        _ => [20.0, of_name + of_value],
    };
    Label { name, value: element.value.clone(), left, right }
}

/// Whether an element is a store that follows others.
pub(crate) fn follows(graph: &Graph, causality: &Causality, index: usize) -> bool {
    let ports = &graph.elements[index].ports;
    ports.iter().any(|bond| causality.following_bonds.contains(bond) && graph.bonds[*bond].to == index)
}
