//! Nodes, elements, materials, sets.

use super::weight::CarriedWeight;
use crate::element::ElementKind;
use crate::{FlexError, Material};
use serde::{Deserialize, Serialize};

/// An element of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Element {
    /// Its kind.
    pub kind: ElementKind,
    /// Indices of its nodes, in the order of CalculiX.
    pub nodes: Vec<u32>,
    /// Index of its material.
    pub material: u32,
}

/// A named set of nodes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct NodeSet {
    /// Its name, in upper case.
    pub name: String,
    /// Indices of its nodes, rising.
    pub nodes: Vec<u32>,
}

/// A mesh in SI units.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Mesh {
    /// Places of the nodes [m].
    pub nodes: Vec<[f64; 3]>,
    /// Elements.
    pub elements: Vec<Element>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Sets of nodes.
    pub sets: Vec<NodeSet>,
    /// Weights without elements of their own, whose centrifugal forces load the body where it turns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub weights: Vec<CarriedWeight>,
}

impl Mesh {
    /// Places of an element's nodes [m].
    pub fn places(&self, element: &Element) -> Vec<[f64; 3]> {
        element.nodes.iter().map(|node| self.nodes[*node as usize]).collect()
    }

    /// The set of this name, in whatever case.
    ///
    /// # Errors
    /// [`FlexError::Missing`] where there is none, or an empty one.
    pub fn set(&self, name: &str) -> Result<&NodeSet, FlexError> {
        self.sets.iter().find(|set| set.name.eq_ignore_ascii_case(name) && !set.nodes.is_empty()).ok_or_else(
            || FlexError::Missing {
                what: "node set",
                name: name.to_owned(),
                hint: "a set with at least one node of that name must be there",
            },
        )
    }

    /// Nodes that a test picks, rising.
    pub fn pick(&self, is_in: impl Fn(&[f64; 3]) -> bool) -> Vec<u32> {
        (0..self.nodes.len() as u32).filter(|node| is_in(&self.nodes[*node as usize])).collect()
    }

    /// Refuses a mesh that names what it does not have, leaves nodes free or has inverted elements.
    ///
    /// # Errors
    /// The first of them.
    pub fn check(&self) -> Result<(), FlexError> {
        let missing =
            |what, number: u32, hint| Err(FlexError::Missing { what, name: (number + 1).to_string(), hint });
        if self.elements.is_empty() {
            return Err(FlexError::Missing {
                what: "element",
                name: "1".to_owned(),
                hint: "a mesh has elements",
            });
        }
        for material in &self.materials {
            material.check()?;
        }
        let mut used = vec![false; self.nodes.len()];
        for element in &self.elements {
            if element.material as usize >= self.materials.len() {
                return missing("material", element.material, "each element needs a material");
            }
            for node in &element.nodes {
                match used.get_mut(*node as usize) {
                    Some(used) => *used = true,
                    None => return missing("node", *node, "each node of an element must be there"),
                }
            }
        }
        for set in &self.sets {
            if let Some(node) = set.nodes.iter().find(|node| **node as usize >= self.nodes.len()) {
                return missing("node", *node, "each node of a set must be there");
            }
        }
        let carrying = self.weights.iter().flat_map(|weight| weight.forces.iter().map(|(node, _)| *node));
        if let Some(node) = carrying.into_iter().find(|node| *node as usize >= self.nodes.len()) {
            return missing("node", node, "each node that carries a weight must be there");
        }
        if let Some(node) = used.iter().position(|used| !used) {
            return Err(FlexError::FreeNode { node: node + 1 });
        }
        for (index, element) in self.elements.iter().enumerate() {
            super::jacobian::check_element(index, element.kind, &self.places(element), 0.0)?;
        }
        Ok(())
    }

    /// The same mesh with mid-side nodes in the middle of their edges.
    pub fn straightened(&self) -> Mesh {
        let mut mesh = self.clone();
        for element in &self.elements {
            for (place, [a, b]) in element.kind.edges().iter().enumerate() {
                let [a, b] = [a, b].map(|corner| self.nodes[element.nodes[*corner] as usize]);
                let middle = element.nodes[element.kind.corners() + place];
                mesh.nodes[middle as usize] = std::array::from_fn(|k| (a[k] + b[k]) / 2.0);
            }
        }
        mesh
    }
}
