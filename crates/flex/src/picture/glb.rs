//! Binary glTF 2.0 (GLB): the surface with a colour at each node, deformations as morph targets with an animation each.
//!
//! Metres; one mesh under a node that turns the crank frame so that x points along the viewer's up, which is Y in glTF; z stays along the
//! crank axis. Without normals, so that a viewer shades each facet by itself.

use super::skin::skin;
use crate::FlexError;
use crate::mesh::Mesh;
use serde_json::{Value, json};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// Component types and targets of the specification.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_BYTE: u32 = 5121;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// Instants of an animation, and its length [s].
const INSTANTS: usize = 33;
const SECONDS: f64 = 2.0;

/// A deformation of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Morph<'a> {
    /// Its name.
    pub name: &'a str,
    /// Displacements of all nodes of the mesh [m].
    pub displacements: &'a [[f64; 3]],
    /// By which they are multiplied.
    pub factor: f64,
    /// Whether it swings to both sides, as a mode does; else it grows from nothing and goes back.
    pub swings: bool,
}

/// Bytes and where they are.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    fn add(&mut self, bytes: Vec<u8>, target: Option<u32>, accessor: Value) -> usize {
        let mut view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.views.push(view);
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let mut accessor = accessor;
        accessor["bufferView"] = json!(self.views.len() - 1);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn vectors(&mut self, values: &[[f32; 3]]) -> usize {
        let bound = |choose: fn(f32, f32) -> f32| {
            let first = values.first().copied().unwrap_or_default();
            values.iter().fold(first, |bound, value| std::array::from_fn(|k| choose(bound[k], value[k])))
        };
        let (min, max): ([f32; 3], [f32; 3]) = (bound(f32::min), bound(f32::max));
        let accessor =
            json!({ "componentType": FLOAT, "count": values.len(), "type": "VEC3", "min": min, "max": max });
        self.add(
            values.iter().flatten().flat_map(|x| x.to_le_bytes()).collect(),
            Some(ARRAY_BUFFER),
            accessor,
        )
    }

    fn numbers(&mut self, values: &[f32], with_bounds: bool) -> usize {
        let mut accessor = json!({ "componentType": FLOAT, "count": values.len(), "type": "SCALAR" });
        if with_bounds {
            accessor["min"] = json!([values.iter().copied().fold(f32::INFINITY, f32::min)]);
            accessor["max"] = json!([values.iter().copied().fold(f32::NEG_INFINITY, f32::max)]);
        }
        self.add(values.iter().flat_map(|x| x.to_le_bytes()).collect(), None, accessor)
    }
}

/// The bytes of a GLB file of a mesh's surface. `colours`: red, green and blue of each node of the mesh as a screen shows them.
///
/// # Errors
/// [`FlexError::File`] for a surface larger than the format can hold.
pub fn glb(mesh: &Mesh, name: &str, colours: &[[f64; 3]], morphs: &[Morph]) -> Result<Vec<u8>, FlexError> {
    let skin = skin(mesh);
    let single = |value: [f64; 3]| value.map(|x| x as f32);
    let mut buffer = Buffer::default();
    let points: Vec<[f32; 3]> = skin.nodes.iter().map(|node| single(mesh.nodes[*node as usize])).collect();
    let position = buffer.vectors(&points);
    let grey = [0.6; 3];
    let byte = |x: f64| (255.0 * linear(x)).round().clamp(0.0, 255.0) as u8;
    let colour = |node: &u32| {
        let [r, g, b] = colours.get(*node as usize).copied().unwrap_or(grey).map(byte);
        [r, g, b, 255]
    };
    let colour = buffer.add(
        skin.nodes.iter().flat_map(colour).collect(),
        Some(ARRAY_BUFFER),
        json!({ "componentType": UNSIGNED_BYTE, "normalized": true, "count": skin.nodes.len(), "type": "VEC4" }),
    );
    let indices = buffer.add(
        skin.triangles.iter().flatten().flat_map(|corner| corner.to_le_bytes()).collect(),
        Some(ELEMENT_ARRAY_BUFFER),
        json!({ "componentType": UNSIGNED_INT, "count": 3 * skin.triangles.len(), "type": "SCALAR" }),
    );
    let targets: Vec<Value> = morphs
        .iter()
        .map(|morph| {
            let moved = |node: &u32| {
                let u = morph.displacements.get(*node as usize).copied().unwrap_or_default();
                single(u.map(|u| morph.factor * u))
            };
            let moved: Vec<[f32; 3]> = skin.nodes.iter().map(moved).collect();
            json!({ "POSITION": buffer.vectors(&moved) })
        })
        .collect();
    let animations: Vec<Value> = (0..morphs.len()).map(|k| animation(&mut buffer, morphs, k)).collect();
    let mut primitive = json!({
        "attributes": { "POSITION": position, "COLOR_0": colour }, "indices": indices, "material": 0
    });
    let mut shape = json!({ "name": name });
    if !morphs.is_empty() {
        primitive["targets"] = json!(targets);
        shape["weights"] = json!(vec![0.0; morphs.len()]);
        shape["extras"] = json!({ "targetNames": morphs.iter().map(|morph| morph.name).collect::<Vec<_>>() });
    }
    shape["primitives"] = json!([primitive]);
    let mut document = json!({
        "asset": { "version": "2.0", "generator": "lanchester" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [
            { "name": "crank frame", "rotation": [0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2], "children": [1] },
            { "name": name, "mesh": 0 }
        ],
        "meshes": [shape],
        "materials": [{ "doubleSided": false, "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.8 } }],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{ "byteLength": buffer.bytes.len() }],
    });
    if !animations.is_empty() {
        document["animations"] = json!(animations);
    }
    packed(&document, &buffer.bytes)
}

/// The animation of one deformation, the others at rest.
fn animation(buffer: &mut Buffer, morphs: &[Morph], own: usize) -> Value {
    let part = |k: usize| k as f64 / (INSTANTS - 1) as f64;
    let times: Vec<f32> = (0..INSTANTS).map(|k| (SECONDS * part(k)) as f32).collect();
    let weight = |k: usize| {
        let turn = TAU * part(k);
        if morphs[own].swings { turn.sin() } else { (1.0 - turn.cos()) / 2.0 }
    };
    let at = |k: usize| (0..morphs.len()).map(move |morph| if morph == own { weight(k) as f32 } else { 0.0 });
    let weights: Vec<f32> = (0..INSTANTS).flat_map(at).collect();
    let (input, output) = (buffer.numbers(&times, true), buffer.numbers(&weights, false));
    json!({
        "name": morphs[own].name,
        "samplers": [{ "input": input, "output": output, "interpolation": "LINEAR" }],
        "channels": [{ "sampler": 0, "target": { "node": 1, "path": "weights" } }],
    })
}

fn packed(document: &Value, binary: &[u8]) -> Result<Vec<u8>, FlexError> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = |bytes: usize| {
        u32::try_from(bytes).map_err(|_| FlexError::File {
            what: "GLB file",
            message: format!("its {bytes} bytes are more than the format can hold"),
        })
    };
    let all = 12 + 8 + json.len() + 8 + binary.len();
    let mut file = b"glTF".to_vec();
    for number in [2, length(all)?, length(json.len())?] {
        file.extend(number.to_le_bytes());
    }
    file.extend(b"JSON");
    file.extend(json);
    file.extend(length(binary.len())?.to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(binary);
    Ok(file)
}

/// Light of a screen's value, after IEC 61966-2-1.
fn linear(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::element::ElementKind;
    use crate::mesh::mapped_block;
    use crate::picture::stl;

    fn word(bytes: &[u8], at: usize) -> usize {
        u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
    }

    fn float(bytes: &[u8], at: usize) -> f32 {
        f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
    }

    #[test]
    fn file_holds_the_surface_its_colours_and_its_deformation() {
        let mesh = mapped_block(ElementKind::Wedge, [2, 1, 1], Material::steel(), |x| {
            [0.2 * x[0], 0.1 * x[1], 0.3 * x[2]]
        });
        let moved: Vec<[f64; 3]> = mesh.nodes.iter().map(|at| [0.0, 1e-3 * at[2], 0.0]).collect();
        let colours: Vec<[f64; 3]> = mesh.nodes.iter().map(|at| [at[0] / 0.2, 0.0, 1.0]).collect();
        let morph = Morph { name: "bending \"1\"", displacements: &moved, factor: 50.0, swings: true };
        let file = glb(&mesh, "crank", &colours, &[morph]).unwrap();
        assert_eq!((&file[..4], word(&file, 4), word(&file, 8)), (&b"glTF"[..], 2, file.len()));
        let json_length = word(&file, 12);
        let document: Value = serde_json::from_slice(&file[20..20 + json_length]).unwrap();
        let binary = &file[28 + json_length..];
        assert_eq!(word(&file, 20 + json_length), binary.len());
        assert_eq!(document["buffers"][0]["byteLength"], binary.len());
        let count = document["accessors"][0]["count"].as_u64().unwrap() as usize;
        assert!(count > 20 && document["accessors"][1]["count"] == count);
        // All accessors lie within their views, and views within the buffer.
        for accessor in document["accessors"].as_array().unwrap() {
            let view = &document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
            let width = match (
                accessor["componentType"].as_u64().unwrap() as u32,
                accessor["type"].as_str().unwrap(),
            ) {
                (FLOAT, "VEC3") => 12,
                (_, "VEC4" | "SCALAR") => 4,
                other => panic!("{other:?}"),
            };
            assert_eq!(view["byteLength"], accessor["count"].as_u64().unwrap() * width);
            assert!(
                view["byteOffset"].as_u64().unwrap() + view["byteLength"].as_u64().unwrap()
                    <= binary.len() as u64
            );
        }
        let offset = |accessor: usize| {
            let view = document["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
            document["bufferViews"][view]["byteOffset"].as_u64().unwrap() as usize
        };
        let target =
            document["meshes"][0]["primitives"][0]["targets"][0]["POSITION"].as_u64().unwrap() as usize;
        for k in 0..count {
            let z = float(binary, offset(0) + 12 * k + 8);
            let y = float(binary, offset(target) + 12 * k + 4);
            assert!((y - 0.05 * z).abs() < 1e-7, "{y} {z}");
            let red = binary[offset(1) + 4 * k];
            assert!(red == 0 || float(binary, offset(0) + 12 * k) > 0.0);
        }
        assert_eq!(document["animations"][0]["name"], "bending \"1\"");
        assert_eq!(document["meshes"][0]["extras"]["targetNames"][0], "bending \"1\"");
    }

    #[test]
    fn stl_encloses_the_volume_of_the_deformed_body() {
        let mesh = mapped_block(ElementKind::Hexahedron, [2, 1, 1], Material::steel(), |x| {
            [0.2 * x[0], 0.1 * x[1], 0.3 * x[2]]
        });
        let stretched: Vec<[f64; 3]> = mesh.nodes.iter().map(|at| [0.01 * at[0], 0.0, 0.0]).collect();
        for (factor, wanted) in [(0.0, 6e6), (10.0, 6.6e6)] {
            let file = stl(&mesh, &stretched, factor).unwrap();
            let count = word(&file, 80);
            assert_eq!(file.len(), 84 + 50 * count);
            let corner = |k: usize, c: usize| -> [f64; 3] {
                std::array::from_fn(|a| f64::from(float(&file, 84 + 50 * k + 12 * (c + 1) + 4 * a)))
            };
            let volume: f64 = (0..count)
                .map(|k| {
                    let [a, b, c] = [0, 1, 2].map(|c| corner(k, c));
                    (a[0] * (b[1] * c[2] - b[2] * c[1])
                        + a[1] * (b[2] * c[0] - b[0] * c[2])
                        + a[2] * (b[0] * c[1] - b[1] * c[0]))
                        / 6.0
                })
                .sum();
            assert!((volume / wanted - 1.0).abs() < 1e-6, "{volume} mm3");
        }
    }
}
