//! Binary STL: triangles in millimetres, as 32-bit floats, all solids one after the other.

use super::mesh::meshes;
use super::{ExportError, Solid};

/// What the file begins with; it must not begin with "solid", which a text file does.
const TITLE: &[u8] = b"binary STL of crankshaft parts, millimetres";

/// The bytes of a binary STL file of solids ([`super::solids`]), in millimetres, whose chords stay within `facet_error` [m] of the arcs.
///
/// Solids follow each other, each closed; the format has no names.
///
/// # Errors
/// Where the facet error is too small or too large, facets would cross, a solid is too small against the whole for 32-bit floats, or
/// the format cannot hold them ([`ExportError`]).
pub fn stl(solids: &[Solid], facet_error: f64) -> Result<Vec<u8>, ExportError> {
    let meshes = meshes(solids, facet_error, 1e3)?;
    let mut head = TITLE.to_vec();
    head.resize(80, b' ');
    let mut body = Vec::new();
    let mut count = 0usize;
    for mesh in &meshes {
        for triangle in &mesh.triangles {
            let corners = triangle.corners.map(|at| mesh.points[at]);
            for number in normal(corners).iter().chain(corners.iter().flatten()) {
                body.extend(number.to_le_bytes());
            }
            body.extend([0, 0]);
            count += 1;
        }
    }
    let count = u32::try_from(count).map_err(|_| ExportError::TooLarge { bytes: body.len() })?;
    head.extend(count.to_le_bytes());
    head.extend(body);
    Ok(head)
}

/// Unit normal of a triangle by its corners, zero where it has no area.
fn normal(corners: [[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = corners.map(|corner| corner.map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length == 0.0 { [0.0; 3] } else { cross.map(|x| (x / length) as f32) }
}
