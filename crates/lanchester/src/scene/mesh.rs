//! Triangles of the parts, each shape once.

use lanchester_geometry::export::{PlacedPart, solids, surface_meshes};
use lanchester_geometry::{Outline, Part, Point};
use serde::Serialize;
use std::f64::consts::TAU;

/// Density of solids that are only drawn; any of a material does [kg/m^3].
const ANY: f64 = 7850.0;
/// Facets of a turned surface.
const AROUND: usize = 32;

/// A closed surface of triangles in the frame of its parts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct SceneMesh {
    /// x, y, z of each point [m], to the micrometre.
    pub positions: Vec<f64>,
    /// Normal of the surface at each point, outwards, of length 1 to three decimals.
    pub normals: Vec<f64>,
    /// Numbers of the three points of each triangle, anticlockwise as seen from outside.
    pub indices: Vec<u32>,
}

/// A ring of a turned surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    /// Where along the axis [m].
    pub along: f64,
    /// Its radius [m]; 0 on the axis.
    pub radius: f64,
}

impl SceneMesh {
    /// Solids as they would be exported, one with the other; `None` where they cannot be.
    pub(super) fn of(parts: &[PlacedPart], facet_error: f64) -> Option<SceneMesh> {
        let surfaces = surface_meshes(&solids(parts).ok()?, facet_error).ok()?;
        let mut mesh = SceneMesh::default();
        for surface in surfaces {
            let first = mesh.count();
            for (point, normal) in surface.points.iter().zip(&surface.normals) {
                mesh.point(point.map(f64::from), normal.map(f64::from));
            }
            for corners in surface.triangles {
                mesh.triangle(corners.map(|corner| first + corner));
            }
        }
        Some(mesh)
    }

    /// A plate across the crank with its middle in the plane `z` [m].
    pub(super) fn plate(outline: &Outline, thickness: f64, z: f64, facet_error: f64) -> Option<SceneMesh> {
        let part = Part::new(outline.clone(), thickness, ANY).ok()?;
        SceneMesh::of(&[PlacedPart::new("plate", part).moved(z)], facet_error)
    }

    /// A surface turned about x through rings, with the material on the right of the way from one to the next, seen with the
    /// radius upwards. It begins and ends on the axis, or where it began.
    pub(super) fn turned(rings: &[Ring]) -> SceneMesh {
        let mut mesh = SceneMesh::default();
        for pair in rings.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let way = Point::new(to.along - from.along, to.radius - from.radius);
            let length = way.norm();
            if length == 0.0 {
                continue;
            }
            // To the left of the way.
            let out = Point::new(-way.y, way.x) * (1.0 / length);
            let first = mesh.count();
            for k in 0..=AROUND {
                // The last is the first: sines of a whole turn are not those of none.
                let (sin, cos) = (TAU * (k % AROUND) as f64 / AROUND as f64).sin_cos();
                let normal = [out.x, out.y * cos, out.y * sin];
                for ring in [from, to] {
                    mesh.point([ring.along, ring.radius * cos, ring.radius * sin], normal);
                }
            }
            for k in 0..AROUND as u32 {
                let [a, b, c, d] = [0, 2, 3, 1].map(|corner| first + 2 * k + corner);
                mesh.triangle([a, b, c]);
                mesh.triangle([a, c, d]);
            }
        }
        mesh
    }

    /// With another one.
    pub(super) fn with(mut self, other: &SceneMesh) -> SceneMesh {
        let first = self.count();
        self.positions.extend(&other.positions);
        self.normals.extend(&other.normals);
        self.indices.extend(other.indices.iter().map(|index| first + index));
        self
    }

    /// Moved by this much.
    pub(super) fn moved(mut self, by: [f64; 3]) -> SceneMesh {
        for place in self.positions.chunks_exact_mut(3) {
            for (value, by) in place.iter_mut().zip(by) {
                *value = rounded(*value + by);
            }
        }
        self
    }

    /// What was x, y, z is y, z, x then: a plate across z stands across x.
    pub(super) fn rolled(mut self) -> SceneMesh {
        for place in self.positions.chunks_exact_mut(3).chain(self.normals.chunks_exact_mut(3)) {
            place.rotate_right(1);
        }
        self
    }

    /// Turned half a turn about x.
    pub(super) fn turned_over(mut self) -> SceneMesh {
        for place in self.positions.chunks_exact_mut(3).chain(self.normals.chunks_exact_mut(3)) {
            place[1] = rounded(-place[1]);
            place[2] = rounded(-place[2]);
        }
        self
    }

    fn count(&self) -> u32 {
        (self.positions.len() / 3) as u32
    }

    fn point(&mut self, place: [f64; 3], normal: [f64; 3]) {
        self.positions.extend(place.map(rounded));
        self.normals.extend(normal.map(|part| rounded((part * 1e3).round() / 1e3)));
    }

    /// Triangles that rounding draws together to a line are left out, which leaves the surface closed.
    fn triangle(&mut self, corners: [u32; 3]) {
        let place = |corner: u32| &self.positions[3 * corner as usize..][..3];
        let [a, b, c] = corners.map(place);
        if a != b && b != c && c != a {
            self.indices.extend(corners);
        }
    }
}

/// The shapes of a scene.
pub(super) struct Meshes {
    /// Each once.
    pub all: Vec<SceneMesh>,
    /// How far chords may be from their arcs [m].
    pub facet_error: f64,
}

impl Meshes {
    pub fn new(facet_error: f64) -> Meshes {
        Meshes { all: Vec::new(), facet_error }
    }

    /// The index of this shape.
    pub fn index(&mut self, mesh: SceneMesh) -> usize {
        self.all.iter().position(|known| *known == mesh).unwrap_or_else(|| {
            self.all.push(mesh);
            self.all.len() - 1
        })
    }
}

/// Rounded to a micrometre, or to a millionth of a radian.
pub(super) fn rounded(value: f64) -> f64 {
    let rounded = (value * 1e6).round() / 1e6;
    // No negative zero, which reads as a mistake.
    if rounded == 0.0 { 0.0 } else { rounded }
}
