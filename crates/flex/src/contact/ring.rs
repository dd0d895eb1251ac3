//! A ring around a pin or journal, meshed on the faces of its surface.

use super::pair::ContactFace;
use crate::FlexError;
use crate::element::ElementKind;
use crate::mesh::{Element, Mesh, SurfaceFace};
use std::collections::{HashMap, HashSet};

/// What a ring is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RingShape {
    /// Outer less inner radius [m].
    pub thickness: f64,
    /// Elements through it.
    pub layers: usize,
    /// Index of its material.
    pub material: u32,
}

/// A ring of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ring {
    /// Where it touches the bar.
    pub contact: Vec<ContactFace>,
    /// Its outer surface.
    pub outer: Vec<SurfaceFace>,
}

impl Ring {
    /// Nodes of its outer surface, rising.
    pub fn outer_nodes(&self) -> Vec<u32> {
        let mut nodes: Vec<u32> = self.outer.iter().flat_map(|face| face.nodes.iter().copied()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }
}

/// Adds a ring around the surface that the nodes of `set` make of a mesh; `faces` is the surface of the whole mesh. The ring's inner nodes
/// lie where those of the bar do, and are others.
///
/// # Errors
/// [`FlexError::Missing`] where the set holds no face, [`FlexError::Mesh`] where its nodes lie on no cylinder about z.
pub(crate) fn add_ring(
    mesh: &mut Mesh,
    faces: &[SurfaceFace],
    set: &str,
    shape: RingShape,
) -> Result<Ring, FlexError> {
    let own: HashSet<u32> = mesh.set(set)?.nodes.iter().copied().collect();
    let faces: Vec<&SurfaceFace> =
        faces.iter().filter(|face| face.nodes.iter().all(|node| own.contains(node))).collect();
    if faces.is_empty() {
        let hint = "a node set of that name must hold all nodes of at least one face";
        return Err(FlexError::Missing { what: "bearing surface", name: set.to_owned(), hint });
    }
    let places: Vec<[f64; 3]> = own.iter().map(|node| mesh.nodes[*node as usize]).collect();
    let centre = centre(&places);
    let distance = |at: &[f64; 3]| (at[0] - centre[0]).hypot(at[1] - centre[1]);
    let radius = places.iter().map(distance).sum::<f64>() / places.len() as f64;
    if places.iter().any(|at| (distance(at) - radius).abs() > 1e-3 * radius) {
        return Err(FlexError::Mesh {
            place: set.to_owned(),
            message:
                "its nodes do not lie on a cylinder about an axis along z, so that no ring fits around it"
                    .to_owned(),
            hint: "another support, or a set that holds the bearing surface alone",
        });
    }
    let mut numbers: HashMap<(u32, usize), u32> = HashMap::new();
    let mut node = |mesh: &mut Mesh, bar: u32, level: usize| {
        *numbers.entry((bar, level)).or_insert_with(|| {
            let at = mesh.nodes[bar as usize];
            let grown = 1.0 + shape.thickness * level as f64 / (2 * shape.layers) as f64 / distance(&at);
            let [x, y] = [0, 1].map(|k| centre[k] + grown * (at[k] - centre[k]));
            mesh.nodes.push([x, y, at[2]]);
            mesh.nodes.len() as u32 - 1
        })
    };
    let mut ring = Ring { contact: Vec::new(), outer: Vec::new() };
    for face in faces {
        let corners = face.nodes.len() / 2;
        let kind = if corners == 3 { ElementKind::Wedge } else { ElementKind::Hexahedron };
        let (edge, middle) = face.nodes.split_at(corners);
        for layer in 0..shape.layers {
            let (low, between, high) = (2 * layer, 2 * layer + 1, 2 * layer + 2);
            let mut nodes = Vec::with_capacity(kind.nodes());
            for (bars, level) in [(edge, low), (edge, high), (middle, low), (middle, high), (edge, between)] {
                nodes.extend(bars.iter().map(|bar| node(mesh, *bar, level)));
            }
            mesh.elements.push(Element { kind, nodes, material: shape.material });
        }
        let inner = face.nodes.iter().map(|bar| node(mesh, *bar, 0)).collect();
        let outer = face.nodes.iter().map(|bar| node(mesh, *bar, 2 * shape.layers)).collect();
        ring.contact.push(ContactFace { bar: face.nodes.clone(), ring: inner, centre });
        ring.outer.push(SurfaceFace { element: mesh.elements.len() as u32 - 1, nodes: outer });
    }
    Ok(ring)
}

/// Centre of the circle that fits points seen along z best: `x^2 + y^2 + a x + b y + c = 0` in the least squares.
fn centre(places: &[[f64; 3]]) -> [f64; 2] {
    let count = places.len() as f64;
    let mean: [f64; 2] = [0, 1].map(|k| places.iter().map(|at| at[k]).sum::<f64>() / count);
    let (mut xx, mut xy, mut yy, mut xs, mut ys) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for at in places {
        let [x, y] = [at[0] - mean[0], at[1] - mean[1]];
        let square = x * x + y * y;
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
        (xs, ys) = (xs + x * square, ys + y * square);
    }
    // With the mean as origin the constant drops out of the other two normal equations.
    let determinant = xx * yy - xy * xy;
    if determinant <= 0.0 {
        return mean;
    }
    let x = (xs * yy - ys * xy) / (2.0 * determinant);
    let y = (ys * xx - xs * xy) / (2.0 * determinant);
    [mean[0] + x, mean[1] + y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circle_through_uneven_points_has_its_centre() {
        let angles = [0.0f64, 0.3, 0.5, 2.0, 2.2, 4.0];
        let places: Vec<[f64; 3]> =
            angles.iter().map(|a| [0.04 + 0.024 * a.cos(), -0.01 + 0.024 * a.sin(), 0.3]).collect();
        let [x, y] = centre(&places);
        assert!((x - 0.04).abs() < 1e-12 && (y + 0.01).abs() < 1e-12, "{x} {y}");
    }
}
