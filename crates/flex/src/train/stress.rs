//! Stress at the fillets from coordinates and loads.
//!
//! ```text
//! s = SUM S_j q_j + SUM |F_i| (T_i0 + T_i2 cos 2a_i + T_i2' sin 2a_i + T_i4 cos 4a_i + T_i4' sin 4a_i)                   (book, eq. 51.11)
//! ```
//! The first sum has the cosine part of every pressure, which moves the body; the second what a pressure over one half has beside it, which deforms the bar
//! where it acts.

use crate::crank_mesh::CrankMesh;
use crate::element::Stress;
use crate::mesh::Mesh;
use crate::statics::node_stresses;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeSet;

/// Stress of unit coordinates at the nodes of fillets.
#[derive(Debug, Clone)]
pub struct StressBasis {
    /// Name, middle of the bar and nodes (by their place in `states`) of each fillet that has a radius.
    fillets: Vec<BasisFillet>,
    /// Place [m] of each node.
    places: Vec<[f64; 3]>,
    /// By node and column, the six components [Pa].
    states: Vec<Vec<[f64; 6]>>,
}

#[derive(Debug, Clone)]
struct BasisFillet {
    name: String,
    radius: f64,
    centre: [f64; 2],
    nodes: Vec<usize>,
}

/// The largest stress of a fillet over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletCycle {
    /// "pin 1 at web 2".
    pub name: String,
    /// Radius [m].
    pub radius: f64,
    /// Largest von Mises stress over cycle and fillet [Pa].
    pub peak: f64,
    /// Principal stress of the largest size there and then [Pa], tension positive.
    pub principal: f64,
    /// Index of the instant.
    pub instant: usize,
    /// Place [m], in the frame of the crankshaft.
    pub at: [f64; 3],
    /// Angle about the bar's middle [rad].
    pub angle: f64,
    /// Largest von Mises stress of the fillet at every instant [Pa].
    pub over_cycle: Vec<f64>,
}

/// Coordinates and loads of one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct StressInstant {
    /// Coordinates of the body.
    pub coordinates: Vec<f64>,
    /// Force on each bearing surface in the frame of the crankshaft [N].
    pub forces: Vec<[f64; 2]>,
}

impl StressInstant {
    /// Factors of all columns.
    fn factors(&self) -> Vec<f64> {
        let mut factors = self.coordinates.clone();
        for [x, y] in &self.forces {
            let (size, angle) = (x.hypot(*y), y.atan2(*x));
            factors.push(size);
            for order in [2.0, 4.0] {
                factors.push(size * (order * angle).cos());
                factors.push(size * (order * angle).sin());
            }
        }
        factors
    }
}

impl StressBasis {
    /// Of displacement fields of coordinates, and of patterns under 1000 N.
    pub(crate) fn new(
        crank: &CrankMesh,
        fields: &[Vec<[f64; 3]>],
        patterns: &[Vec<[f64; 3]>],
    ) -> StressBasis {
        let nodes: BTreeSet<u32> =
            crank.corners.iter().flat_map(|corner| corner.nodes.iter().copied()).collect();
        let nodes: Vec<u32> = nodes.into_iter().collect();
        // Only elements at the fillets are evaluated.
        let touches = |element: &&crate::mesh::Element| {
            element.nodes.iter().any(|node| nodes.binary_search(node).is_ok())
        };
        let near = Mesh {
            nodes: crank.mesh.nodes.clone(),
            elements: crank.mesh.elements.iter().filter(touches).cloned().collect(),
            materials: crank.mesh.materials.clone(),
            ..Mesh::default()
        };
        let mut states: Vec<Vec<[f64; 6]>> = nodes.iter().map(|_| Vec::new()).collect();
        let scaled =
            fields.iter().map(|field| (field, 1.0)).chain(patterns.iter().map(|field| (field, 1e-3)));
        for (field, scale) in scaled {
            let all = node_stresses(&near, field);
            for (node, state) in nodes.iter().zip(&mut states) {
                state.push(all[*node as usize].stress.0.map(|s| scale * s));
            }
        }
        let place = |node: &u32| nodes.binary_search(node).unwrap_or_default();
        let fillets =
            crank.corners.iter().filter(|corner| !corner.nodes.is_empty()).map(|corner| BasisFillet {
                name: corner.name.clone(),
                radius: corner.radius,
                centre: [corner.centre.x, corner.centre.y],
                nodes: corner.nodes.iter().map(place).collect(),
            });
        StressBasis {
            fillets: fillets.collect(),
            places: nodes.iter().map(|node| crank.mesh.nodes[*node as usize]).collect(),
            states,
        }
    }

    /// Number of nodes at which stress is known.
    pub fn nodes(&self) -> usize {
        self.places.len()
    }

    /// Stress tensor of a node at an instant.
    fn state(&self, node: usize, factors: &[f64]) -> Stress {
        let mut sum = [0.0; 6];
        for (own, factor) in self.states[node].iter().zip(factors) {
            for (sum, own) in sum.iter_mut().zip(own) {
                *sum += factor * own;
            }
        }
        Stress(sum)
    }

    /// Peaks of all fillets over the instants of a cycle.
    pub fn over_cycle(&self, instants: &[StressInstant]) -> Vec<FilletCycle> {
        let factors: Vec<Vec<f64>> = instants.iter().map(StressInstant::factors).collect();
        // By column, so that the inner loop runs over instants.
        let columns = factors.first().map_or(0, Vec::len);
        let by_column: Vec<Vec<f64>> =
            (0..columns).map(|column| factors.iter().map(|own| own[column]).collect()).collect();
        let fillet = |fillet: &BasisFillet| {
            let mut largest = vec![(0.0f64, 0usize); instants.len()];
            let mut sums: [Vec<f64>; 6] = std::array::from_fn(|_| vec![0.0; instants.len()]);
            for node in &fillet.nodes {
                for (component, sum) in sums.iter_mut().enumerate() {
                    sum.fill(0.0);
                    for (state, factors) in self.states[*node].iter().zip(&by_column) {
                        let own = state[component];
                        sum.iter_mut().zip(factors).for_each(|(sum, factor)| *sum += own * factor);
                    }
                }
                for (instant, best) in largest.iter_mut().enumerate() {
                    let value = Stress(std::array::from_fn(|c| sums[c][instant])).von_mises();
                    if value > best.0 {
                        *best = (value, *node);
                    }
                }
            }
            let instant =
                (0..largest.len()).max_by(|a, b| largest[*a].0.total_cmp(&largest[*b].0)).unwrap_or(0);
            let (peak, node) = largest.get(instant).copied().unwrap_or_default();
            let at = self.places.get(node).copied().unwrap_or_default();
            FilletCycle {
                name: fillet.name.clone(),
                radius: fillet.radius,
                peak,
                principal: factors.get(instant).map_or(0.0, |own| self.state(node, own).dominant()),
                instant,
                at,
                angle: (at[1] - fillet.centre[1]).atan2(at[0] - fillet.centre[0]),
                over_cycle: largest.iter().map(|own| own.0).collect(),
            }
        };
        self.fillets.par_iter().map(fillet).collect()
    }
}
