//! Binary STL: the surface, deformed or not, in millimetres.

use super::skin::skin;
use crate::FlexError;
use crate::mesh::Mesh;

/// What the file begins with; it must not begin with "solid", which a text file does.
const TITLE: &[u8] = b"binary STL of a meshed crankshaft, millimetres";

/// The bytes of a binary STL file of a mesh's surface [mm], each node moved by `factor` times its displacement.
///
/// # Errors
/// [`FlexError::File`] for more triangles than the format can count.
pub fn stl(mesh: &Mesh, displacements: &[[f64; 3]], factor: f64) -> Result<Vec<u8>, FlexError> {
    let skin = skin(mesh);
    let place = |node: u32| -> [f64; 3] {
        let (at, moved) = (mesh.nodes[node as usize], displacements.get(node as usize));
        std::array::from_fn(|k| 1e3 * (at[k] + factor * moved.map_or(0.0, |moved| moved[k])))
    };
    let points: Vec<[f64; 3]> = skin.nodes.iter().map(|node| place(*node)).collect();
    let mut file = TITLE.to_vec();
    file.resize(80, b' ');
    let count = u32::try_from(skin.triangles.len()).map_err(|_| FlexError::File {
        what: "STL file",
        message: "it has more triangles than the format can count".to_owned(),
    })?;
    file.extend(count.to_le_bytes());
    for triangle in &skin.triangles {
        let [a, b, c] = triangle.map(|corner| points[corner as usize]);
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
        let normal = if length > 0.0 { cross.map(|x| x / length) } else { [0.0; 3] };
        for number in normal.iter().chain([a, b, c].as_flattened()) {
            file.extend((*number as f32).to_le_bytes());
        }
        file.extend([0, 0]);
    }
    Ok(file)
}
