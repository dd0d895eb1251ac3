//! Binary glTF 2.0 (GLB): named meshes with normals and colours.
//!
//! One node and mesh a solid, under one node that turns the crank frame so that x points along the viewer's up, which is Y in glTF;
//! z stays along the crank axis. Metres. A point where faces meet stands once for each normal, with the same coordinates.

use super::mesh::{Mesh, meshes};
use super::surface::SurfaceMesh;
use super::{ExportError, Solid};
use serde::Serialize;
use std::f32::consts::FRAC_1_SQRT_2;

/// Component types and targets of the specification.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Document {
    asset: Asset,
    scene: usize,
    scenes: [Scene; 1],
    nodes: Vec<Node>,
    meshes: Vec<NamedMesh>,
    materials: Vec<Material>,
    accessors: Vec<Accessor>,
    buffer_views: Vec<BufferView>,
    buffers: [Buffer; 1],
}

#[derive(Serialize, schemars::JsonSchema)]
struct Asset {
    version: &'static str,
    generator: &'static str,
}

#[derive(Serialize, schemars::JsonSchema)]
struct Scene {
    nodes: [usize; 1],
}

#[derive(Serialize, schemars::JsonSchema)]
struct Node {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    rotation: Option<[f32; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<usize>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    children: Vec<usize>,
}

#[derive(Serialize, schemars::JsonSchema)]
struct NamedMesh {
    name: String,
    primitives: [Primitive; 1],
}

#[derive(Serialize, schemars::JsonSchema)]
struct Primitive {
    attributes: Attributes,
    indices: usize,
    material: usize,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "UPPERCASE")]
struct Attributes {
    position: usize,
    normal: usize,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Material {
    pbr_metallic_roughness: Surface,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Surface {
    base_color_factor: [f32; 4],
    metallic_factor: f32,
    roughness_factor: f32,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Accessor {
    buffer_view: usize,
    component_type: u32,
    count: usize,
    #[serde(rename = "type")]
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    min: Option<[f32; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    max: Option<[f32; 3]>,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct BufferView {
    buffer: usize,
    byte_offset: usize,
    byte_length: usize,
    target: u32,
}

#[derive(Serialize, schemars::JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Buffer {
    byte_length: usize,
}

/// The bytes of a GLB file of solids ([`super::solids`]), in metres, whose chords stay within `facet_error` [m] of the arcs.
///
/// # Errors
/// Where the facet error is too small or too large, facets would cross, a solid is too small against the whole for 32-bit floats, or
/// the format cannot hold them ([`ExportError`]).
pub fn glb(solids: &[Solid], facet_error: f64) -> Result<Vec<u8>, ExportError> {
    let meshes = meshes(solids, facet_error, 1.0)?;
    let mut binary = Vec::new();
    let mut document = Document {
        asset: Asset { version: "2.0", generator: "lanchester" },
        scene: 0,
        scenes: [Scene { nodes: [0] }],
        // From the crank's x to Y: a quarter turn about z.
        nodes: vec![Node {
            name: "crank frame".to_string(),
            rotation: Some([0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]),
            mesh: None,
            children: (1..=meshes.len()).collect(),
        }],
        meshes: Vec::new(),
        materials: Vec::new(),
        accessors: Vec::new(),
        buffer_views: Vec::new(),
        buffers: [Buffer { byte_length: 0 }],
    };
    for (number, (solid, mesh)) in solids.iter().zip(&meshes).enumerate() {
        let name = solid.name().to_string();
        document.nodes.push(Node {
            name: name.clone(),
            rotation: None,
            mesh: Some(number),
            children: Vec::new(),
        });
        let [red, green, blue] = solid.colour().map(linear);
        document.materials.push(Material {
            pbr_metallic_roughness: Surface {
                base_color_factor: [red, green, blue, 1.0],
                metallic_factor: 0.5,
                roughness_factor: 0.5,
            },
        });
        let (attributes, indices) = document.mesh(mesh, &mut binary);
        document
            .meshes
            .push(NamedMesh { name, primitives: [Primitive { attributes, indices, material: number }] });
    }
    document.buffers[0].byte_length = binary.len();
    let mut json = serde_json::to_vec(&document).expect("invariant: plain structs become JSON");
    json.resize(json.len().next_multiple_of(4), b' ');
    let bytes = 12 + 8 + json.len() + 8 + binary.len();
    let length = |bytes: usize| u32::try_from(bytes).map_err(|_| ExportError::TooLarge { bytes });
    let mut file = b"glTF".to_vec();
    for number in [2, length(bytes)?, length(json.len())?] {
        file.extend(number.to_le_bytes());
    }
    file.extend(b"JSON");
    file.extend(json);
    file.extend(length(binary.len())?.to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(binary);
    Ok(file)
}

impl Document {
    /// Writes points, normals and triangles of a mesh and says where they are.
    fn mesh(&mut self, mesh: &Mesh, binary: &mut Vec<u8>) -> (Attributes, usize) {
        let SurfaceMesh { points, normals, triangles } = SurfaceMesh::of(mesh);
        let indices = triangles.as_flattened();
        let bound = |choose: fn(f32, f32) -> f32| {
            let first = points[0];
            points.iter().fold(first, |bound, point| [0, 1, 2].map(|i| choose(bound[i], point[i])))
        };
        let (min, max) = (Some(bound(f32::min)), Some(bound(f32::max)));
        let floats = |values: &[[f32; 3]]| values.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let count = points.len();
        let position = self.accessor(binary, floats(&points), ARRAY_BUFFER);
        self.accessors.push(Accessor {
            buffer_view: position,
            component_type: FLOAT,
            count,
            kind: "VEC3",
            min,
            max,
        });
        let normal = self.accessor(binary, floats(&normals), ARRAY_BUFFER);
        self.accessors.push(Accessor {
            buffer_view: normal,
            component_type: FLOAT,
            count,
            kind: "VEC3",
            min: None,
            max: None,
        });
        let corners: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()).collect();
        let order = self.accessor(binary, corners, ELEMENT_ARRAY_BUFFER);
        self.accessors.push(Accessor {
            buffer_view: order,
            component_type: UNSIGNED_INT,
            count: indices.len(),
            kind: "SCALAR",
            min: None,
            max: None,
        });
        (Attributes { position, normal }, order)
    }

    /// Puts bytes at the end of the buffer: the number of their view, which is that of the accessor that follows.
    fn accessor(&mut self, binary: &mut Vec<u8>, bytes: Vec<u8>, target: u32) -> usize {
        let (byte_offset, byte_length) = (binary.len(), bytes.len());
        binary.extend(bytes);
        self.buffer_views.push(BufferView { buffer: 0, byte_offset, byte_length, target });
        self.buffer_views.len() - 1
    }
}

/// The linear light of a colour as a screen shows it (the curve of sRGB, IEC 61966-2-1).
fn linear(shown: f64) -> f32 {
    let light = if shown <= 0.04045 { shown / 12.92 } else { ((shown + 0.055) / 1.055).powf(2.4) };
    light as f32
}
