//! Meshes with results for ParaView: VTK's XML file of an unstructured grid, values as raw appended bytes.

use crate::mesh::Mesh;
use std::fmt::Write;

/// Values at the nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeField {
    /// Its name.
    pub name: String,
    /// How many numbers each node has.
    pub components: usize,
    /// Node after node.
    pub values: Vec<f64>,
}

/// A mesh with fields at its nodes as a `.vtu` file [m], quadratic cells.
///
/// VTK numbers the nodes of these cells as CalculiX does: corners, lower edges, upper edges, edges between.
pub fn write_vtu(mesh: &Mesh, fields: &[NodeField]) -> Vec<u8> {
    let mut blocks: Vec<Vec<u8>> = Vec::new();
    let mut head = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
    );
    let _ = writeln!(
        head,
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
        mesh.nodes.len(),
        mesh.elements.len()
    );
    let mut offset = 0usize;
    let mut array = |head: &mut String, kind: &str, name: &str, components: usize, bytes: Vec<u8>| {
        let name = name.replace(['"', '<', '&'], "_");
        let _ = writeln!(
            head,
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>"
        );
        offset += 8 + bytes.len();
        blocks.push(bytes);
    };
    head.push_str("<PointData>\n");
    for field in fields {
        let bytes = field.values.iter().flat_map(|value| value.to_le_bytes()).collect();
        array(&mut head, "Float64", &field.name, field.components, bytes);
    }
    head.push_str("</PointData>\n<Points>\n");
    let places = mesh.nodes.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
    array(&mut head, "Float64", "Points", 3, places);
    head.push_str("</Points>\n<Cells>\n");
    let nodes = mesh.elements.iter().flat_map(|element| &element.nodes);
    array(
        &mut head,
        "Int32",
        "connectivity",
        1,
        nodes.flat_map(|node| (*node as i32).to_le_bytes()).collect(),
    );
    let mut end = 0i32;
    let ends = mesh.elements.iter().flat_map(|element| {
        end += element.nodes.len() as i32;
        end.to_le_bytes()
    });
    let ends = ends.collect();
    array(&mut head, "Int32", "offsets", 1, ends);
    array(
        &mut head,
        "UInt8",
        "types",
        1,
        mesh.elements.iter().map(|element| element.kind.vtk_type()).collect(),
    );
    head.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    let mut file = head.into_bytes();
    for block in blocks {
        file.extend((block.len() as u64).to_le_bytes());
        file.extend(block);
    }
    file.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
    file
}

/// A collection of files over time for ParaView (`.pvd`): time and name of each.
pub fn write_collection(files: &[(f64, String)]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for (time, name) in files {
        let name = name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        let _ = writeln!(text, "<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{name}\"/>");
    }
    text.push_str("</Collection>\n</VTKFile>\n");
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::element::ElementKind;
    use crate::mesh::mapped_block;

    #[test]
    fn every_array_is_where_the_head_says() {
        let mesh = mapped_block(ElementKind::Wedge, [1, 1, 1], Material::steel(), |x| x);
        let values: Vec<f64> = (0..3 * mesh.nodes.len()).map(|k| k as f64).collect();
        let field = NodeField { name: "displacement".to_owned(), components: 3, values: values.clone() };
        let file = write_vtu(&mesh, &[field]);
        let start = file.windows(2).position(|pair| pair == b"\n_").unwrap() + 2;
        let head = String::from_utf8(file[..start].to_vec()).unwrap();
        let offsets: Vec<usize> = head
            .match_indices("offset=\"")
            .map(|(at, key)| head[at + key.len()..].split('"').next().unwrap().parse().unwrap())
            .collect();
        assert_eq!(offsets.len(), 5);
        let length = |offset: usize| {
            let bytes: [u8; 8] = file[start + offset..start + offset + 8].try_into().unwrap();
            u64::from_le_bytes(bytes) as usize
        };
        let wanted = [24 * mesh.nodes.len(), 24 * mesh.nodes.len(), 4 * 30, 4 * 2, 2];
        for (offset, wanted) in offsets.iter().zip(wanted) {
            assert_eq!(length(*offset), wanted);
        }
        let first = start + offsets[0] + 8;
        assert_eq!(f64::from_le_bytes(file[first + 8..first + 16].try_into().unwrap()), values[1]);
        assert_eq!(&file[start + offsets[4] + 8..][..2], [26, 26]);
        assert!(file.ends_with(b"</VTKFile>\n"));
    }

    #[test]
    fn names_of_a_collection_are_escaped() {
        let text = write_collection(&[(7.5, "a & b-1.vtu".to_owned())]);
        assert!(
            text.contains("<DataSet timestep=\"7.5\" group=\"\" part=\"0\" file=\"a &amp; b-1.vtu\"/>"),
            "{text}"
        );
    }
}
