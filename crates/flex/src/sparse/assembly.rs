//! Stiffness, mass and geometric stiffness of a mesh: the same bits for any number of threads.
//!
//! Blocks of element matrices are computed in parallel; then each range of columns, in parallel, takes its entries from them in the
//! order of the elements. So every sum has one order.

use super::matrix::{Pattern, SymmetricMatrix};
use super::order::{nested_dissection, postorder};
use crate::element::{
    ElementKind, ElementMatrix, IntegrationPoint, ShapeValues, geometric_matrix, mass_matrix, mass_rule,
    shape_values, stiffness_matrix, stiffness_rule,
};
use crate::mesh::Mesh;
use rayon::prelude::*;
use std::sync::Arc;

/// Elements whose matrices are held at a time.
const BLOCK: usize = 1024;
/// Ranges of columns: fixed, so that nothing depends on the number of threads.
const RANGES: usize = 8;

/// What is assembled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity<'a> {
    /// Stiffness [N/m].
    Stiffness,
    /// Consistent mass [kg], exact for elements with straight edges.
    Mass,
    /// Consistent mass with the rule of the stiffness, as CalculiX has it.
    CoarseMass,
    /// Geometric stiffness [N/m] under the stress of these displacements [m] of all nodes, with the rule of the stiffness.
    Geometric(&'a [[f64; 3]]),
}

/// A dense symmetric term between degrees of freedom, such as a spring between means of surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct DenseTerm {
    /// Three times the node, plus the axis.
    pub unknowns: Vec<u32>,
    /// Entries, row by row.
    pub values: Vec<f64>,
}

/// Order of a mesh's unknowns and where its matrices have entries.
#[derive(Debug, Clone)]
pub struct Structure {
    /// Place of each node in the order of elimination.
    pub place: Vec<u32>,
    /// For each place the places after it that share an element with it, rising: starts and places.
    starts: Vec<u32>,
    after: Vec<u32>,
    pattern: Arc<Pattern>,
}

impl Structure {
    /// Order and pattern of a mesh with further terms.
    pub fn new(mesh: &Mesh, terms: &[DenseTerm]) -> Structure {
        let coupled: Vec<Vec<u32>> = terms
            .iter()
            .map(|term| {
                let mut nodes: Vec<u32> = term.unknowns.iter().map(|unknown| unknown / 3).collect();
                nodes.sort_unstable();
                nodes.dedup();
                nodes
            })
            .collect();
        let mut cells: Vec<&[u32]> = mesh.elements.iter().map(|element| element.nodes.as_slice()).collect();
        cells.extend(coupled.iter().map(Vec::as_slice));
        let order = nested_dissection(&mesh.nodes, &cells);
        let neighbours = neighbours(mesh.nodes.len(), &cells);
        let order = postorder(&order, |node| &neighbours[node as usize]);
        let mut place = vec![0u32; order.len()];
        for (at, node) in order.iter().enumerate() {
            place[*node as usize] = at as u32;
        }
        let lists: Vec<Vec<u32>> = order
            .par_iter()
            .enumerate()
            .map(|(at, node)| {
                let mut list: Vec<u32> = neighbours[*node as usize]
                    .iter()
                    .map(|neighbour| place[*neighbour as usize])
                    .filter(|neighbour| *neighbour as usize > at)
                    .collect();
                list.sort_unstable();
                list
            })
            .collect();
        let mut starts = vec![0u32];
        let mut after = Vec::with_capacity(lists.iter().map(Vec::len).sum());
        let mut pattern = Pattern::default();
        pattern.starts.push(0);
        for (at, list) in lists.iter().enumerate() {
            after.extend_from_slice(list);
            starts.push(after.len() as u32);
            for axis in 0..3 {
                pattern.rows.extend((axis..3).map(|row| 3 * at as u32 + row));
                pattern.rows.extend(list.iter().flat_map(|other| [3 * other, 3 * other + 1, 3 * other + 2]));
                pattern.starts.push(pattern.rows.len() as u32);
            }
        }
        Structure { place, starts, after, pattern: Arc::new(pattern) }
    }

    /// Entries of the lower triangle.
    pub fn entries(&self) -> usize {
        self.pattern.rows.len()
    }

    /// Unknown of an axis of a node in the order of elimination.
    pub fn unknown(&self, node: u32, axis: usize) -> usize {
        3 * self.place[node as usize] as usize + axis
    }

    /// Three numbers for each node, in the order of elimination.
    pub fn gather(&self, field: &[[f64; 3]]) -> Vec<f64> {
        let mut vector = vec![0.0; 3 * field.len()];
        for (node, value) in field.iter().enumerate() {
            let at = 3 * self.place[node] as usize;
            vector[at..at + 3].copy_from_slice(value);
        }
        vector
    }

    /// The inverse of [`Structure::gather`].
    pub fn scatter(&self, vector: &[f64]) -> Vec<[f64; 3]> {
        self.place
            .iter()
            .map(|place| {
                let at = 3 * *place as usize;
                [vector[at], vector[at + 1], vector[at + 2]]
            })
            .collect()
    }

    /// A quantity of the mesh this is the structure of, all unknowns free.
    pub fn assemble(&self, mesh: &Mesh, quantity: Quantity<'_>, terms: &[DenseTerm]) -> SymmetricMatrix {
        let rules: Vec<Vec<(IntegrationPoint, ShapeValues)>> = ElementKind::ALL
            .iter()
            .map(|kind| {
                let rule = match quantity {
                    Quantity::Stiffness | Quantity::CoarseMass | Quantity::Geometric(_) => {
                        stiffness_rule(*kind)
                    }
                    Quantity::Mass => mass_rule(*kind),
                };
                rule.into_iter().map(|point| (point, shape_values(*kind, point.at))).collect()
            })
            .collect();
        let mut values = vec![0.0; self.pattern.rows.len()];
        let bounds = self.bounds();
        let mut matrices = vec![ElementMatrix::default(); BLOCK.min(mesh.elements.len())];
        for block in mesh.elements.chunks(BLOCK) {
            let matrices = &mut matrices[..block.len()];
            matrices.par_iter_mut().zip(block).for_each(|(matrix, element)| {
                let (rule, places) = (&rules[element.kind as usize], mesh.places(element));
                let material = &mesh.materials[element.material as usize];
                match quantity {
                    Quantity::Stiffness => stiffness_matrix(element.kind, &places, material, rule, matrix),
                    Quantity::Mass | Quantity::CoarseMass => {
                        mass_matrix(element.kind, &places, material.density, rule, matrix)
                    }
                    Quantity::Geometric(moved) => {
                        let moved: Vec<[f64; 3]> =
                            element.nodes.iter().map(|node| moved[*node as usize]).collect();
                        geometric_matrix(element.kind, &places, material, &moved, rule, matrix);
                    }
                }
            });
            let mut rest = values.as_mut_slice();
            let mut slices = Vec::with_capacity(RANGES);
            for pair in bounds.windows(2) {
                let [from, to] = [pair[0], pair[1]].map(|place| self.pattern.starts[3 * place] as usize);
                let (own, further) = rest.split_at_mut(to - from);
                slices.push((pair[0]..pair[1], from, own));
                rest = further;
            }
            slices.into_par_iter().for_each(|(range, first, own)| {
                for (matrix, element) in matrices.iter().zip(block) {
                    self.add(&element.nodes, matrix, range.clone(), first, own);
                }
            });
        }
        for term in terms.iter().filter(|_| quantity == Quantity::Stiffness) {
            self.add_term(term, &mut values);
        }
        SymmetricMatrix { pattern: self.pattern.clone(), values }
    }

    /// A matrix of this structure with further terms, whose nodes were known when it was made.
    pub fn with_terms(&self, matrix: &SymmetricMatrix, terms: &[DenseTerm]) -> SymmetricMatrix {
        let mut values = matrix.values.clone();
        for term in terms {
            self.add_term(term, &mut values);
        }
        SymmetricMatrix { pattern: matrix.pattern.clone(), values }
    }

    /// Places that part the columns into ranges of about as many entries.
    fn bounds(&self) -> Vec<usize> {
        let (count, all) = (self.place.len(), self.pattern.rows.len());
        let mut bounds = vec![0];
        for range in 1..RANGES {
            let wanted = (all / RANGES * range) as u32;
            let column = self.pattern.starts.partition_point(|start| *start < wanted);
            bounds.push((column / 3).clamp(bounds[range - 1], count));
        }
        bounds.push(count);
        bounds
    }

    /// Entry at which the rows of a later place begin in the first column of a place.
    fn find(&self, place: u32, other: u32) -> usize {
        let range = self.starts[place as usize] as usize..self.starts[place as usize + 1] as usize;
        let list = &self.after[range];
        list.binary_search(&other).expect("invariant: nodes of one element are neighbours")
    }

    fn add(
        &self,
        nodes: &[u32],
        matrix: &ElementMatrix,
        range: std::ops::Range<usize>,
        first: usize,
        values: &mut [f64],
    ) {
        for (j, node) in nodes.iter().enumerate() {
            let place = self.place[*node as usize];
            if !range.contains(&(place as usize)) {
                continue;
            }
            let starts =
                [0, 1, 2].map(|axis| self.pattern.starts[3 * place as usize + axis] as usize - first);
            for axis in 0..3 {
                for row in axis..3 {
                    values[starts[axis] + row - axis] +=
                        matrix.values[(3 * j + axis) * matrix.size + 3 * j + row];
                }
            }
            for (i, other) in nodes.iter().enumerate() {
                let other = self.place[*other as usize];
                if other <= place {
                    continue;
                }
                let offset = 3 * self.find(place, other);
                for axis in 0..3 {
                    let from = (3 * j + axis) * matrix.size + 3 * i;
                    let to = starts[axis] + 3 - axis + offset;
                    for row in 0..3 {
                        values[to + row] += matrix.values[from + row];
                    }
                }
            }
        }
    }

    fn add_term(&self, term: &DenseTerm, values: &mut [f64]) {
        let size = term.unknowns.len();
        for (j, column) in term.unknowns.iter().enumerate() {
            for (i, row) in term.unknowns.iter().enumerate() {
                let split = |unknown: u32| (self.place[unknown as usize / 3], unknown as usize % 3);
                let ((place, axis), (other, row)) = (split(*column), split(*row));
                let value = term.values[j * size + i];
                let start = self.pattern.starts[3 * place as usize + axis] as usize;
                if other == place && row >= axis {
                    values[start + row - axis] += value;
                } else if other > place {
                    values[start + 3 - axis + 3 * self.find(place, other) + row] += value;
                }
            }
        }
    }
}

/// For each node those that share a cell with it, rising, without itself.
fn neighbours(count: usize, cells: &[&[u32]]) -> Vec<Vec<u32>> {
    let mut starts = vec![0u32; count + 1];
    for node in cells.iter().flat_map(|cell| cell.iter()) {
        starts[*node as usize + 1] += 1;
    }
    for node in 0..count {
        starts[node + 1] += starts[node];
    }
    let mut next = starts.clone();
    let mut own = vec![0u32; starts[count] as usize];
    for (index, cell) in cells.iter().enumerate() {
        for node in *cell {
            own[next[*node as usize] as usize] = index as u32;
            next[*node as usize] += 1;
        }
    }
    (0..count)
        .into_par_iter()
        .map(|node| {
            let cells_of = &own[starts[node] as usize..starts[node + 1] as usize];
            let mut list: Vec<u32> =
                cells_of.iter().flat_map(|cell| cells[*cell as usize].iter().copied()).collect();
            list.sort_unstable();
            list.dedup();
            list.retain(|other| *other as usize != node);
            list
        })
        .collect()
}
