//! Quality of a mesh as data.

use super::Mesh;
use super::jacobian::{middle, scaled_jacobian};
use crate::FlexError;
use crate::element::{ElementKind, jacobian_determinant, mass_rule, shape_values};
use rayon::prelude::*;
use serde::Serialize;

/// Elements whose smallest determinant of the Jacobian is a smaller share of the mean one are refused.
pub const LEAST_JACOBIAN: f64 = 0.2;

/// What a mesh is like.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MeshQuality {
    /// Nodes.
    pub nodes: usize,
    /// Elements: tetrahedra, wedges, hexahedra.
    pub elements: [usize; 3],
    /// Smallest determinant of the Jacobian over its mean in the element, at nodes and integration points.
    pub least_jacobian: f64,
    /// Number of that element, from 1.
    pub worst_element: usize,
    /// Its middle [m].
    pub worst_place: [f64; 3],
    /// Smallest angle between two edges of a face at a corner [rad].
    pub least_angle: f64,
    /// Longest edge over the shortest one of the most stretched element.
    pub largest_aspect: f64,
    /// Volume [m^3].
    pub volume: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m].
    pub centre: [f64; 3],
    /// Moments of inertia xx, yy, zz and products xy, yz, zx about the origin, `INT x y dm` with plus sign [kg m^2].
    pub inertia: [f64; 6],
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Smallest angle of the faces at their corners, and longest over shortest edge.
fn angle_and_aspect(kind: ElementKind, nodes: &[[f64; 3]]) -> (f64, f64) {
    let mut least = f64::INFINITY;
    for face in kind.faces() {
        for k in 0..face.len() {
            let at = |k: usize| nodes[face[k % face.len()]];
            let (here, a, b) = (at(k), at(k + 1), at(k + face.len() - 1));
            let dot: f64 = (0..3).map(|k| (a[k] - here[k]) * (b[k] - here[k])).sum();
            let angle = (dot / (distance(a, here) * distance(b, here))).clamp(-1.0, 1.0).acos();
            least = least.min(angle);
        }
    }
    let lengths = kind.edges().iter().map(|[a, b]| distance(nodes[*a], nodes[*b]));
    let (short, long) = lengths.fold((f64::INFINITY, 0.0f64), |(s, l), x| (s.min(x), l.max(x)));
    (least, long / short)
}

/// Counts, shape and mass of a mesh.
///
/// # Errors
/// As [`Mesh::check`].
pub fn quality(mesh: &Mesh) -> Result<MeshQuality, FlexError> {
    mesh.check()?;
    let each: Vec<([f64; 3], [f64; 11])> = mesh
        .elements
        .par_iter()
        .map(|element| {
            let places = mesh.places(element);
            let (angle, aspect) = angle_and_aspect(element.kind, &places);
            let shape = [scaled_jacobian(element.kind, &places), angle, aspect];
            (shape, moments(element.kind, &places, mesh.materials[element.material as usize].density))
        })
        .collect();
    let mut quality = MeshQuality {
        nodes: mesh.nodes.len(),
        elements: [0; 3],
        least_jacobian: f64::INFINITY,
        worst_element: 0,
        worst_place: [0.0; 3],
        least_angle: f64::INFINITY,
        largest_aspect: 0.0,
        volume: 0.0,
        mass: 0.0,
        centre: [0.0; 3],
        inertia: [0.0; 6],
    };
    let mut sums = [0.0; 11];
    for (index, ([jacobian, angle, aspect], moments)) in each.into_iter().enumerate() {
        let element = &mesh.elements[index];
        quality.elements[element.kind as usize] += 1;
        if jacobian < quality.least_jacobian {
            quality.least_jacobian = jacobian;
            quality.worst_element = index + 1;
            quality.worst_place = middle(element.kind, &mesh.places(element));
        }
        quality.least_angle = quality.least_angle.min(angle);
        quality.largest_aspect = quality.largest_aspect.max(aspect);
        for (sum, value) in sums.iter_mut().zip(moments) {
            *sum += value;
        }
    }
    let [volume, mass, x, y, z, xx, yy, zz, xy, yz, zx] = sums;
    quality.volume = volume;
    quality.mass = mass;
    if mass > 0.0 {
        quality.centre = [x / mass, y / mass, z / mass];
    }
    quality.inertia = [yy + zz, zz + xx, xx + yy, xy, yz, zx];
    Ok(quality)
}

/// Volume, mass, first and second moments of mass of an element.
fn moments(kind: ElementKind, nodes: &[[f64; 3]], density: f64) -> [f64; 11] {
    let mut sums = [0.0; 11];
    for point in mass_rule(kind) {
        let shape = shape_values(kind, point.at);
        let mut place = [0.0; 3];
        for (node, at) in nodes.iter().enumerate() {
            for axis in 0..3 {
                place[axis] += shape.n[node] * at[axis];
            }
        }
        let volume = point.weight * jacobian_determinant(kind, nodes, point.at);
        let mass = density * volume;
        let [x, y, z] = place;
        let parts = [1.0, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x];
        sums[0] += volume;
        for (sum, part) in sums[1..].iter_mut().zip(parts) {
            *sum += mass * part;
        }
    }
    sums
}
