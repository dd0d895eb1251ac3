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

    /// What `judge` says of every fillet over the instants of a cycle, in parallel.
    pub fn each_fillet<T: Send>(
        &self,
        instants: &[StressInstant],
        judge: impl Fn(&FilletNodes<'_>) -> T + Sync,
    ) -> Vec<T> {
        let factors: Vec<Vec<f64>> = instants.iter().map(StressInstant::factors).collect();
        // By column, so that the inner loop runs over instants.
        let columns = factors.first().map_or(0, Vec::len);
        let by_column: Vec<Vec<f64>> =
            (0..columns).map(|column| factors.iter().map(|own| own[column]).collect()).collect();
        let of = |fillet| FilletNodes { basis: self, fillet, by_column: &by_column, count: instants.len() };
        self.fillets.par_iter().map(|fillet| judge(&of(fillet))).collect()
    }
}

/// The nodes of a fillet with their stress over the cycle.
#[derive(Debug, Clone, Copy)]
pub struct FilletNodes<'a> {
    basis: &'a StressBasis,
    fillet: &'a BasisFillet,
    by_column: &'a [Vec<f64>],
    /// Instants.
    count: usize,
}

impl FilletNodes<'_> {
    /// Place of a node [m] and its angle about the middle of the bar [rad].
    pub fn place(&self, node: usize) -> ([f64; 3], f64) {
        let at = self.basis.places[self.fillet.nodes[node]];
        (at, (at[1] - self.fillet.centre[1]).atan2(at[0] - self.fillet.centre[0]))
    }

    /// Stress of a node at every instant: xx, yy, zz, xy, yz, zx [Pa].
    pub fn history(&self, node: usize) -> Vec<[f64; 6]> {
        let states = &self.basis.states[self.fillet.nodes[node]];
        let mut sum = vec![0.0; self.count];
        let mut history = vec![[0.0; 6]; self.count];
        for component in 0..6 {
            sum.fill(0.0);
            for (state, factors) in states.iter().zip(self.by_column) {
                let own = state[component];
                sum.iter_mut().zip(factors).for_each(|(sum, factor)| *sum += own * factor);
            }
            history.iter_mut().zip(&sum).for_each(|(state, sum)| state[component] = *sum);
        }
        history
    }

    /// The largest stress; `see` sees the history of every node in turn.
    pub fn cycle(&self, mut see: impl FnMut(usize, &[[f64; 6]])) -> FilletCycle {
        let mut over_cycle = vec![0.0f64; self.count];
        let (mut peak, mut instant, mut node, mut principal) = (0.0, 0, 0, 0.0);
        for own in 0..self.fillet.nodes.len() {
            let history = self.history(own);
            for (k, (state, most)) in history.iter().zip(&mut over_cycle).enumerate() {
                let value = Stress(*state).von_mises();
                *most = most.max(value);
                if value > peak {
                    (peak, instant, node) = (value, k, own);
                    principal = Stress(*state).dominant();
                }
            }
            see(own, &history);
        }
        let (at, angle) = self.place(node);
        FilletCycle {
            name: self.fillet.name.clone(),
            radius: self.fillet.radius,
            peak,
            principal,
            instant,
            at,
            angle,
            over_cycle,
        }
    }
}
