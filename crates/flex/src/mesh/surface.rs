//! The surface of a mesh: faces that belong to one element alone.

use super::Mesh;
use crate::element::ElementKind;
use std::collections::BTreeMap;

/// A face of an element on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceFace {
    /// Index of the element.
    pub element: u32,
    /// Corners seen from outside against the clock, then the mid-side nodes after each: 6 or 8 nodes.
    pub nodes: Vec<u32>,
}

/// The surface of a mesh, by element and face. The second number: inner faces that do not belong to exactly two elements; zero of a
/// conforming mesh.
pub fn surface(mesh: &Mesh) -> (Vec<SurfaceFace>, usize) {
    let mut faces: BTreeMap<Vec<u32>, (u32, usize, usize)> = BTreeMap::new();
    for (index, element) in mesh.elements.iter().enumerate() {
        for (place, face) in element.kind.faces().iter().enumerate() {
            let mut key: Vec<u32> =
                face_nodes(element.kind, face).iter().map(|k| element.nodes[*k]).collect();
            key.sort_unstable();
            faces.entry(key).or_insert((index as u32, place, 0)).2 += 1;
        }
    }
    let crowded = faces.values().filter(|(_, _, count)| *count > 2).count();
    let mut outer: Vec<(u32, usize)> = faces
        .values()
        .filter(|(_, _, count)| *count == 1)
        .map(|(element, place, _)| (*element, *place))
        .collect();
    outer.sort_unstable();
    let face = |(element, place): (u32, usize)| {
        let source = &mesh.elements[element as usize];
        let local = face_nodes(source.kind, source.kind.faces()[place]);
        SurfaceFace { element, nodes: local.iter().map(|k| source.nodes[*k]).collect() }
    };
    (outer.into_iter().map(face).collect(), crowded)
}

/// Corners, then the mid-side node after each corner.
fn face_nodes(kind: ElementKind, face: &[usize]) -> Vec<usize> {
    let middle = |k: usize| kind.middle(face[k], face[(k + 1) % face.len()]);
    face.iter().copied().chain((0..face.len()).filter_map(middle)).collect()
}

/// For each node of faces the share of their area that its shape function carries, as a vector along the outward normal [m^2].
/// A pressure `p` gives the force `-p` times it.
pub fn surface_areas(mesh: &Mesh, faces: &[SurfaceFace]) -> BTreeMap<u32, [f64; 3]> {
    weighted_areas(mesh, faces, 1, &|_| 1.0)
}

/// As [`surface_areas`], each piece of the surface times a weight that depends on its place: with a pressure [Pa] the forces against it [N]. `parts`: the
/// pieces into which a side of a face is cut, for weights that change within it.
pub(crate) fn weighted_areas(
    mesh: &Mesh,
    faces: &[SurfaceFace],
    parts: usize,
    weight: &dyn Fn([f64; 3]) -> f64,
) -> BTreeMap<u32, [f64; 3]> {
    let mut areas: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for face in faces {
        for (at, share) in fine_face_rule(face.nodes.len(), parts) {
            let (n, d) = face_shape(face.nodes.len(), at);
            let (mut middle, mut tangents) = ([0.0; 3], [[0.0; 3]; 2]);
            for (k, node) in face.nodes.iter().enumerate() {
                let place = mesh.nodes[*node as usize];
                for axis in 0..3 {
                    middle[axis] += n[k] * place[axis];
                    tangents[0][axis] += d[k][0] * place[axis];
                    tangents[1][axis] += d[k][1] * place[axis];
                }
            }
            let share = share * weight(middle);
            let [a, b] = tangents;
            let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            for (k, node) in face.nodes.iter().enumerate() {
                let area = areas.entry(*node).or_default();
                for axis in 0..3 {
                    area[axis] += share * n[k] * normal[axis];
                }
            }
        }
    }
    areas
}

/// As [`surface_areas`], with the outward direction of length one beside: the share of a node may be negative, as that of the corners of a quadrilateral
/// is (-1/12 of its area), and then points inwards.
pub fn signed_areas(mesh: &Mesh, faces: &[SurfaceFace]) -> BTreeMap<u32, SignedArea> {
    let mut outward: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for face in faces {
        let places: Vec<[f64; 3]> = face.nodes.iter().map(|node| mesh.nodes[*node as usize]).collect();
        // Twice the vector area of the polygon of corners.
        let count = places.len() / 2;
        let mut normal = [0.0; 3];
        for k in 0..count {
            let (a, b) = (places[k], places[(k + 1) % count]);
            for (axis, normal) in normal.iter_mut().enumerate() {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                *normal += a[i] * b[j] - a[j] * b[i];
            }
        }
        for node in &face.nodes {
            let own = outward.entry(*node).or_default();
            (0..3).for_each(|axis| own[axis] += normal[axis]);
        }
    }
    let of = |(node, area): (u32, [f64; 3])| {
        let size = area.iter().map(|x| x * x).sum::<f64>().sqrt();
        let about = outward.get(&node).copied().unwrap_or_default();
        let sign = if (0..3).map(|k| area[k] * about[k]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let outward = area.map(|x| if size > 0.0 { sign * x / size } else { 0.0 });
        (node, SignedArea { size: sign * size, outward })
    };
    surface_areas(mesh, faces).into_iter().map(of).collect()
}

/// The share of a surface that a node carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignedArea {
    /// Its size [m^2]; below zero of the corners of quadrilaterals.
    pub size: f64,
    /// Outward normal of the surface there.
    pub outward: [f64; 3],
}

/// An integration point of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FacePoint {
    /// Shape functions of its nodes.
    pub shares: [f64; 8],
    /// Place [m].
    pub at: [f64; 3],
    /// Area that it stands for [m^2].
    pub area: f64,
}

/// Integration points of a face whose nodes are at these places [m].
pub(crate) fn face_points(places: &[[f64; 3]]) -> Vec<FacePoint> {
    let point = |(at, weight): ([f64; 2], f64)| {
        let (n, d) = face_shape(places.len(), at);
        let sum = |weights: &dyn Fn(usize) -> f64| -> [f64; 3] {
            std::array::from_fn(|axis| {
                places.iter().enumerate().map(|(k, place)| weights(k) * place[axis]).sum()
            })
        };
        let (a, b) = (sum(&|k| d[k][0]), sum(&|k| d[k][1]));
        let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let area = weight * normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        FacePoint { shares: n, at: sum(&|k| n[k]), area }
    };
    face_rule(places.len()).into_iter().map(point).collect()
}

/// Integration points of a triangle (6) or a quadrilateral (9).
fn face_rule(nodes: usize) -> Vec<([f64; 2], f64)> {
    if nodes == 6 {
        let rule = crate::element::mass_rule(ElementKind::Wedge);
        // One layer of the wedge's rule, whose weights add up to the triangle's area.
        return rule[6..12]
            .iter()
            .map(|point| ([point.at[0], point.at[1]], point.weight / (8.0 / 9.0)))
            .collect();
    }
    let rule = crate::element::stiffness_rule(ElementKind::Hexahedron);
    rule[9..18].iter().map(|point| ([point.at[0], point.at[1]], point.weight / (8.0 / 9.0))).collect()
}

/// The integration points of every piece of a face whose sides are cut into so many parts.
fn fine_face_rule(nodes: usize, parts: usize) -> Vec<([f64; 2], f64)> {
    let rule = face_rule(nodes);
    if parts <= 1 {
        return rule;
    }
    let count = parts as f64;
    let mut fine = Vec::new();
    for (i, j) in (0..parts).flat_map(|i| (0..parts).map(move |j| (i, j))) {
        let corner = [i as f64, j as f64];
        for ([r, s], weight) in &rule {
            let weight = weight / (count * count);
            if nodes != 6 {
                let at = [(*r, corner[0]), (*s, corner[1])]
                    .map(|(at, corner)| (2.0 * corner + 1.0 + at) / count - 1.0);
                fine.push((at, weight));
                continue;
            }
            // A triangle has one piece that stands and, but along its long side, one upside down beside each place.
            if i + j < parts {
                fine.push(([(corner[0] + r) / count, (corner[1] + s) / count], weight));
            }
            if i + j + 1 < parts {
                fine.push(([(corner[0] + 1.0 - r) / count, (corner[1] + 1.0 - s) / count], weight));
            }
        }
    }
    fine
}

/// Shape functions of a face and their derivatives by its two coordinates.
fn face_shape(nodes: usize, [r, s]: [f64; 2]) -> ([f64; 8], [[f64; 2]; 8]) {
    let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
    if nodes == 6 {
        let l = [1.0 - r - s, r, s];
        let dl = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
        for i in 0..3 {
            let j = (i + 1) % 3;
            n[i] = l[i] * (2.0 * l[i] - 1.0);
            n[3 + i] = 4.0 * l[i] * l[j];
            for k in 0..2 {
                d[i][k] = (4.0 * l[i] - 1.0) * dl[i][k];
                d[3 + i][k] = 4.0 * (dl[i][k] * l[j] + l[i] * dl[j][k]);
            }
        }
        return (n, d);
    }
    // The upper face of a hexahedron has these shape functions on itself; it is seen from outside in the order of its corners.
    let shape = crate::element::shape_values(ElementKind::Hexahedron, [r, s, 1.0]);
    for k in 0..4 {
        for (to, from) in [(k, 4 + k), (4 + k, 12 + k)] {
            n[to] = shape.n[from];
            d[to] = [shape.d[from][0], shape.d[from][1]];
        }
    }
    (n, d)
}
