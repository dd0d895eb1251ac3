//! The surface of a mesh as triangles.

use crate::mesh::{Mesh, surface};
use std::collections::HashMap;

/// Triangles through the nodes of a surface, mid-side nodes included, seen from outside against the clock.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Skin {
    /// Indices of the nodes of the mesh.
    pub nodes: Vec<u32>,
    /// Corners of the triangles, by their place in `nodes`.
    pub triangles: Vec<[u32; 3]>,
}

/// Corners before the middles that follow them: a triangle becomes four, a quadrilateral six.
const TRIANGLE: [[usize; 3]; 4] = [[0, 3, 5], [1, 4, 3], [2, 5, 4], [3, 4, 5]];
const QUADRILATERAL: [[usize; 3]; 6] = [[0, 4, 7], [1, 5, 4], [2, 6, 5], [3, 7, 6], [4, 5, 6], [4, 6, 7]];

/// The surface of a mesh.
pub fn skin(mesh: &Mesh) -> Skin {
    let (faces, _) = surface(mesh);
    let mut places: HashMap<u32, u32> = HashMap::new();
    let mut skin = Skin::default();
    for face in faces {
        let cuts: &[[usize; 3]] = if face.nodes.len() == 6 { &TRIANGLE } else { &QUADRILATERAL };
        for cut in cuts {
            let corners = cut.map(|k| {
                let node = face.nodes[k];
                *places.entry(node).or_insert_with(|| {
                    skin.nodes.push(node);
                    skin.nodes.len() as u32 - 1
                })
            });
            skin.triangles.push(corners);
        }
    }
    skin
}
