//! Where points lie in a mesh.

use super::Mesh;
use crate::element::{ElementKind, gradients, local_coordinates, shape_values};

/// Steps of the search for the coordinates of a point within an element.
const STEPS: usize = 12;
/// Change of these coordinates at which the search ends.
const SETTLED: f64 = 1e-12;
/// Share of an element by which a point may lie outside the mesh, whose faces are parabolas where the body's are arcs.
const OUTSIDE: f64 = 0.05;

/// A point within an element: nodes with the values of their shape functions there.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaceInMesh(Vec<(u32, f64)>);

impl PlaceInMesh {
    /// Of the nodes of the elements, which one a point lies in, or next to by no more than 5 % of an element: the first of those that hold it
    /// best. `None`: outside.
    pub fn find(mesh: &Mesh, elements: &[usize], point: [f64; 3]) -> Option<PlaceInMesh> {
        let mut best: Option<(f64, PlaceInMesh)> = None;
        for index in elements {
            let element = &mesh.elements[*index];
            let nodes = mesh.places(element);
            let is_near = (0..3).all(|axis| {
                let (low, high) = nodes
                    .iter()
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), n| (a.min(n[axis]), b.max(n[axis])));
                let room = 0.1 * (high - low);
                (low - room..=high + room).contains(&point[axis])
            });
            if !is_near {
                continue;
            }
            let Some((outside, values)) = within(element.kind, &nodes, point) else { continue };
            if outside < OUTSIDE && best.as_ref().is_none_or(|(least, _)| outside < *least) {
                let weights = element.nodes.iter().copied().zip(values);
                best = Some((outside, PlaceInMesh(weights.collect())));
            }
            if outside <= 0.0 {
                break;
            }
        }
        best.map(|(_, place)| place)
    }

    /// Value there of a quantity that is known at the nodes.
    pub fn value(&self, at: impl Fn(u32) -> f64) -> f64 {
        self.0.iter().map(|(node, weight)| weight * at(*node)).sum()
    }
}

/// How far outside an element a point lies, in the element's own coordinates (0 and below: within), and the shape functions there.
fn within(kind: ElementKind, nodes: &[[f64; 3]], point: [f64; 3]) -> Option<(f64, Vec<f64>)> {
    let mut at = match kind {
        ElementKind::Tetrahedron => [0.25; 3],
        ElementKind::Wedge => [1.0 / 3.0, 1.0 / 3.0, 0.0],
        ElementKind::Hexahedron => [0.0; 3],
    };
    let own: Vec<[f64; 3]> = (0..nodes.len()).map(|node| local_coordinates(kind, node)).collect();
    for _ in 0..STEPS {
        let shape = shape_values(kind, at);
        let (determinant, slopes) = gradients(nodes, &shape);
        if determinant <= 0.0 {
            return None;
        }
        let here = |axis: usize| nodes.iter().zip(&shape.n).map(|(node, n)| n * node[axis]).sum::<f64>();
        let rest: [f64; 3] = std::array::from_fn(|axis| point[axis] - here(axis));
        // The element's coordinates are a field of their own, linear in themselves: their slopes in space are those of its shape functions.
        let step: [f64; 3] = std::array::from_fn(|k| {
            let slope = |axis: usize| own.iter().zip(&slopes).map(|(own, g)| own[k] * g[axis]).sum::<f64>();
            (0..3).map(|axis| slope(axis) * rest[axis]).sum()
        });
        for (at, step) in at.iter_mut().zip(step) {
            *at += step;
        }
        if step.iter().all(|step| step.abs() < SETTLED) {
            break;
        }
        if at.iter().any(|at| at.abs() > 3.0) {
            return None;
        }
    }
    let [r, s, t] = at;
    let outside = match kind {
        ElementKind::Tetrahedron => (-r).max(-s).max(-t).max(r + s + t - 1.0),
        ElementKind::Wedge => (-r).max(-s).max(r + s - 1.0).max(t.abs() - 1.0),
        ElementKind::Hexahedron => r.abs().max(s.abs()).max(t.abs()) - 1.0,
    };
    Some((outside, shape_values(kind, at).n[..nodes.len()].to_vec()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::mesh::mapped_block;

    /// A field that the elements carry exactly is found at any point of a bent block.
    #[test]
    fn linear_fields_are_found_in_all_elements() {
        for kind in ElementKind::ALL {
            let bend = |[a, b, c]: [f64; 3]| [a + 0.1 * b * b, b, c + 0.05 * a];
            let mesh = mapped_block(kind, [3, 2, 2], Material::steel(), bend);
            let all: Vec<usize> = (0..mesh.elements.len()).collect();
            for at in [[0.21, 0.43, 0.77], [0.5, 0.5, 0.5], [0.99, 0.01, 0.3], [0.0, 0.0, 0.0]] {
                let point = bend(at);
                let place = PlaceInMesh::find(&mesh, &all, point).expect("it is within");
                for axis in 0..3 {
                    let found = place.value(|node| mesh.nodes[node as usize][axis]);
                    assert!((found - point[axis]).abs() < 1e-12, "{kind:?} {at:?} {axis} {found}");
                }
            }
            assert_eq!(PlaceInMesh::find(&mesh, &all, [2.0, 0.5, 0.5]), None);
        }
    }
}
