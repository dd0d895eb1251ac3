//! Meshes of bodies that are mapped from a block, for checks and for rings.

use super::{Element, Mesh};
use crate::Material;
use crate::element::ElementKind;
use std::collections::BTreeMap;

/// A block of `divisions` cells along its own three coordinates from 0 to 1, each cell cut into elements of this kind, all nodes mapped to
/// their places [m] by `map`. Where `map` brings nodes of one plane together exactly as another (a closed ring), they are one.
pub fn mapped_block(
    kind: ElementKind,
    divisions: [usize; 3],
    material: Material,
    map: impl Fn([f64; 3]) -> [f64; 3],
) -> Mesh {
    let mut mesh = Mesh { materials: vec![material], ..Mesh::default() };
    let mut numbers: BTreeMap<[usize; 3], u32> = BTreeMap::new();
    let mut places: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    // Twice as many steps as cells, so that mid-side nodes have whole numbers.
    let steps = divisions.map(|count| 2 * count);
    let corner = |k: usize| [k & 1, (k >> 1) & 1, k >> 2];
    let cuts: &[&[usize]] = match kind {
        ElementKind::Hexahedron => &[&[0, 1, 3, 2, 4, 5, 7, 6]],
        ElementKind::Wedge => &[&[0, 1, 3, 4, 5, 7], &[0, 3, 2, 4, 7, 6]],
        ElementKind::Tetrahedron => {
            &[&[0, 1, 3, 7], &[0, 3, 2, 7], &[0, 2, 6, 7], &[0, 6, 4, 7], &[0, 4, 5, 7], &[0, 5, 1, 7]]
        }
    };
    let mut unit = 0.0f64;
    for k in 0..8 {
        unit = map(corner(k).map(|x| x as f64)).iter().fold(unit, |sum, value| sum.max(value.abs()));
    }
    let unit = if unit > 0.0 { unit * 1e-9 } else { 1e-12 };
    for cell in 0..divisions.iter().product() {
        let first =
            [cell % divisions[0], (cell / divisions[0]) % divisions[1], cell / (divisions[0] * divisions[1])];
        for cut in cuts {
            let steps_of =
                |k: usize| -> [usize; 3] { std::array::from_fn(|a| 2 * (first[a] + corner(cut[k])[a])) };
            let middles = kind.edges().iter().map(|[a, b]| {
                let (a, b) = (steps_of(*a), steps_of(*b));
                std::array::from_fn(|k| (a[k] + b[k]) / 2)
            });
            let lattice: Vec<[usize; 3]> = (0..kind.corners()).map(steps_of).chain(middles).collect();
            let nodes = lattice.into_iter().map(|at| {
                *numbers.entry(at).or_insert_with(|| {
                    let place = map(std::array::from_fn(|k| at[k] as f64 / steps[k] as f64));
                    let key = place.map(|x| (x / unit).round() as i64);
                    *places.entry(key).or_insert_with(|| {
                        mesh.nodes.push(place);
                        mesh.nodes.len() as u32 - 1
                    })
                })
            });
            let nodes = nodes.collect();
            mesh.elements.push(Element { kind, nodes, material: 0 });
        }
    }
    mesh
}
