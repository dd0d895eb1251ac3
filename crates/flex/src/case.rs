//! What holds a body and what loads it.

use crate::FlexError;
use crate::mesh::Mesh;
use crate::sparse::DenseTerm;
use serde::{Deserialize, Serialize};

/// A displacement that is given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Fixed {
    /// Index of the node.
    pub node: u32,
    /// Axis: 0 x, 1 y, 2 z.
    pub axis: u8,
    /// Displacement [m].
    pub value: f64,
}

/// A spring between a weighted sum of displacements and the ground.
///
/// ```text
/// u_m = SUM w_i . u_i        F = k u_m, shared among the nodes by w: adds no stiffness of its own          (book, eq. 43.6)
/// ```
/// Vectors `w_i` along one direction that add up to length one hold a mean displacement; tangential ones that add up to zero hold a mean
/// rotation times a radius.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Spring {
    /// What it is called.
    pub name: String,
    /// Stiffness [N/m].
    pub stiffness: f64,
    /// Nodes and their weights along x, y and z.
    pub nodes: Vec<(u32, [f64; 3])>,
}

impl Spring {
    /// A spring on the mean displacement along a direction of length one, of nodes with weights that add up to one.
    pub fn on_mean(name: &str, stiffness: f64, direction: [f64; 3], nodes: &[(u32, f64)]) -> Spring {
        let nodes = nodes.iter().map(|(node, weight)| (*node, direction.map(|n| weight * n))).collect();
        Spring { name: name.to_owned(), stiffness, nodes }
    }

    /// Weighted sum of displacements [m].
    pub fn displacement(&self, displacements: &[[f64; 3]]) -> f64 {
        self.nodes
            .iter()
            .map(|(node, weight)| {
                let u = displacements[*node as usize];
                (0..3).map(|axis| weight[axis] * u[axis]).sum::<f64>()
            })
            .sum()
    }
}

/// A force on a node [N].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct NodeForce {
    /// Index of the node.
    pub node: u32,
    /// Its components [N].
    pub force: [f64; 3],
}

/// A static case.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct StaticCase {
    /// Its name.
    pub name: String,
    /// Given displacements.
    pub fixed: Vec<Fixed>,
    /// Springs to the ground.
    pub springs: Vec<Spring>,
    /// Forces.
    pub forces: Vec<NodeForce>,
    /// Speed about the z axis [rad/s], whose centrifugal field loads the body.
    pub speed: f64,
    /// Rate of that speed [rad/s^2], whose field of tangential inertia loads the body.
    #[serde(default)]
    pub acceleration: f64,
    /// Whether the loads are balanced by accelerations of the body as a whole.
    pub inertia_relief: bool,
}

impl StaticCase {
    /// Whether its turning loads the body, so that its mass counts.
    pub fn turns(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Holds every axis of these nodes.
    pub fn clamp(mut self, nodes: &[u32]) -> StaticCase {
        for axis in 0..3 {
            self = self.hold(nodes, axis, 0.0);
        }
        self
    }

    /// Gives the displacement [m] of these nodes along an axis.
    pub fn hold(mut self, nodes: &[u32], axis: u8, value: f64) -> StaticCase {
        self.fixed.extend(nodes.iter().map(|node| Fixed { node: *node, axis, value }));
        self
    }

    /// Adds a force [N] shared among nodes by weights.
    pub fn push(mut self, nodes: &[(u32, f64)], force: [f64; 3]) -> StaticCase {
        let shared =
            nodes.iter().map(|(node, weight)| NodeForce { node: *node, force: force.map(|f| weight * f) });
        self.forces.extend(shared);
        self
    }

    /// Terms of its springs in the stiffness.
    pub fn terms(&self) -> Vec<DenseTerm> {
        let term = |spring: &Spring| {
            let mut unknowns = Vec::new();
            let mut weights = Vec::new();
            for (node, weight) in &spring.nodes {
                for (axis, weight) in weight.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                    unknowns.push(3 * node + axis as u32);
                    weights.push(*weight);
                }
            }
            let values =
                weights.iter().flat_map(|a| weights.iter().map(move |b| spring.stiffness * a * b)).collect();
            DenseTerm { unknowns, values }
        };
        self.springs.iter().map(term).collect()
    }

    /// Refuses nodes that the mesh does not have, numbers that are none, and supports that leave a motion of the whole body free.
    ///
    /// # Errors
    /// [`FlexError::Missing`], [`FlexError::Number`], [`FlexError::FreeMotion`].
    pub fn check(&self, mesh: &Mesh) -> Result<(), FlexError> {
        let count = mesh.nodes.len() as u32;
        let springs = self.springs.iter().flat_map(|spring| spring.nodes.iter().map(|(node, _)| *node));
        let nodes = self.fixed.iter().map(|fixed| fixed.node).chain(springs);
        for node in nodes.chain(self.forces.iter().map(|force| force.node)) {
            if node >= count {
                let hint = "supports and loads act on nodes of the mesh";
                return Err(FlexError::Missing { what: "node", name: (node + 1).to_string(), hint });
            }
        }
        let numbers = self.fixed.iter().map(|fixed| fixed.value).chain([self.speed, self.acceleration]);
        for number in numbers.chain(self.forces.iter().flat_map(|force| force.force)) {
            if !number.is_finite() {
                return Err(FlexError::Number {
                    quantity: format!("a load or displacement of {}", self.name),
                    needed: "finite".to_owned(),
                    got: number,
                    hint: "give a number",
                });
            }
        }
        for spring in &self.springs {
            if !(spring.stiffness > 0.0 && spring.stiffness.is_finite()) {
                return Err(FlexError::Number {
                    quantity: format!("stiffness of the support {} [N/m]", spring.name),
                    needed: "above zero".to_owned(),
                    got: spring.stiffness,
                    hint: "leave the support out for none",
                });
            }
        }
        if self.inertia_relief { Ok(()) } else { self.check_motions(mesh) }
    }

    /// Six motions of a rigid body against what holds it: a combination that nothing resists is free.
    fn check_motions(&self, mesh: &Mesh) -> Result<(), FlexError> {
        let modes = rigid_motions(mesh);
        let mut gram = vec![0.0; 36];
        let mut add = |motion: [f64; 6]| {
            for a in 0..6 {
                for b in 0..6 {
                    gram[6 * a + b] += motion[a] * motion[b];
                }
            }
        };
        for fixed in &self.fixed {
            add(std::array::from_fn(|k| modes[k][fixed.node as usize][fixed.axis as usize]));
        }
        for spring in &self.springs {
            add(std::array::from_fn(|k| spring.displacement(&modes[k])));
        }
        let (values, vectors) = crate::eigen::symmetric_eigen(&gram, 6);
        let largest = values[5];
        if values[0] > 1e-12 * largest && largest > 0.0 {
            return Ok(());
        }
        let names = ["along x", "along y", "along z", "about x", "about y", "about z"];
        let weight = |k: usize| vectors[k].abs();
        let main = (0..6).max_by(|a, b| weight(*a).total_cmp(&weight(*b))).unwrap_or(0);
        Err(FlexError::FreeMotion {
            motion: format!("mostly {} (through the middle of the nodes)", names[main]),
        })
    }
}

/// Displacements of the six motions of a mesh as a rigid body: along x, y, z, about x, y, z through the middle of its nodes, the turns in
/// units of the largest distance from it, so that all six are numbers of one size.
pub fn rigid_motions(mesh: &Mesh) -> [Vec<[f64; 3]>; 6] {
    let count = mesh.nodes.len() as f64;
    let middle: [f64; 3] =
        std::array::from_fn(|k| mesh.nodes.iter().map(|node| node[k]).sum::<f64>() / count);
    let from = |node: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| node[k] - middle[k]) };
    let reach =
        mesh.nodes.iter().map(|node| from(node).iter().map(|x| x * x).sum::<f64>()).fold(0.0, f64::max);
    let size = if reach > 0.0 { reach.sqrt() } else { 1.0 };
    let field =
        |motion: &dyn Fn([f64; 3]) -> [f64; 3]| mesh.nodes.iter().map(|node| motion(from(node))).collect();
    [
        field(&|_| [1.0, 0.0, 0.0]),
        field(&|_| [0.0, 1.0, 0.0]),
        field(&|_| [0.0, 0.0, 1.0]),
        field(&|[_, y, z]| [0.0, -z / size, y / size]),
        field(&|[x, _, z]| [z / size, 0.0, -x / size]),
        field(&|[x, y, _]| [-y / size, x / size, 0.0]),
    ]
}
