//! Surfaces that follow a reference point as rigid bodies.

use crate::FlexError;
use crate::mesh::Mesh;
use serde::{Deserialize, Serialize};
use std::collections::HashSet;

/// A surface that moves with a reference point as a rigid body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Interface {
    /// Name of its node set.
    pub name: String,
    /// Its reference point, the middle of its nodes' extent [m].
    pub point: [f64; 3],
    /// Indices of its nodes.
    pub nodes: Vec<u32>,
}

impl Interface {
    /// Displacement of a place for a unit of coordinate `axis`: 0 to 2 translation along x, y, z, 3 to 5 rotation about them [1, m].
    pub fn motion(&self, axis: usize, at: [f64; 3]) -> [f64; 3] {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|k| at[k] - self.point[k]);
        match axis {
            0 => [1.0, 0.0, 0.0],
            1 => [0.0, 1.0, 0.0],
            2 => [0.0, 0.0, 1.0],
            3 => [0.0, -z, y],
            4 => [z, 0.0, -x],
            _ => [-y, x, 0.0],
        }
    }
}

/// The interfaces of node sets, in their order. A node of several sets belongs to the first of them.
///
/// # Errors
/// [`FlexError::Missing`] for a set that the mesh does not have; [`FlexError::Number`] for one of fewer than three nodes of its own.
pub fn interfaces(mesh: &Mesh, sets: &[String]) -> Result<Vec<Interface>, FlexError> {
    let mut taken: HashSet<u32> = HashSet::new();
    let one = |name: &String| {
        let nodes: Vec<u32> =
            mesh.set(name)?.nodes.iter().copied().filter(|node| taken.insert(*node)).collect();
        if nodes.len() < 3 {
            return Err(FlexError::Number {
                quantity: format!("the number of nodes of {name}"),
                needed: "at least 3 that no set before it has".to_owned(),
                got: nodes.len() as f64,
                hint: "a reference point needs a surface of its own",
            });
        }
        let extent = |axis: usize| {
            let along = nodes.iter().map(|node| mesh.nodes[*node as usize][axis]);
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let point = std::array::from_fn(|axis| extent(axis).iter().sum::<f64>() / 2.0);
        Ok(Interface { name: name.clone(), point, nodes })
    };
    sets.iter().map(one).collect()
}
