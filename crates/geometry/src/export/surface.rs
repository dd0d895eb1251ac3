//! The surface of a solid as a viewer draws it: points with normals, and triangles between them.

use super::mesh::{Mesh, meshes};
use super::{ExportError, Solid};
use std::collections::BTreeMap;

/// Triangles over points that each have one normal: a point where faces meet stands once for each normal, with the same coordinates.
///
/// The mesh is closed: over equal points, every edge of a triangle is that of another one backwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SurfaceMesh {
    /// Points [m], in the frame of the solids.
    pub points: Vec<[f32; 3]>,
    /// Normal of the surface at each point, outwards, of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Numbers of the corners of each triangle, anticlockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl SurfaceMesh {
    pub(super) fn of(mesh: &Mesh) -> SurfaceMesh {
        let mut numbers = BTreeMap::new();
        let mut surface = SurfaceMesh::default();
        for triangle in &mesh.triangles {
            let corner = |k: usize| {
                let normal = triangle.normals[k].map(|x| x as f32);
                let key = (triangle.corners[k], normal.map(f32::to_bits));
                let next = numbers.len() as u32;
                let number = *numbers.entry(key).or_insert(next);
                if number == next {
                    surface.points.push(mesh.points[triangle.corners[k]]);
                    surface.normals.push(normal);
                }
                number
            };
            let corners = [0, 1, 2].map(corner);
            surface.triangles.push(corners);
        }
        surface
    }
}

/// The surface of each solid, whose chords stay within `facet_error` [m] of the arcs.
///
/// # Errors
/// Where the facet error is too small or too large, facets would cross, or a solid is too small against the whole for 32-bit floats
/// ([`ExportError`]).
pub fn surface_meshes(solids: &[Solid], facet_error: f64) -> Result<Vec<SurfaceMesh>, ExportError> {
    Ok(meshes(solids, facet_error, 1.0)?.iter().map(SurfaceMesh::of).collect())
}
