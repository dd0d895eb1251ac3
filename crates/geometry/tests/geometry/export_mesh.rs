//! STL and glTF files read back: watertight, and as large as the facet error allows.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::random_part::{any_part, volumes};
use lanchester_geometry::export::{ExportError, PlacedPart, Solid, glb, solids, stl};
use lanchester_geometry::{
    Contour, Corner, Insert, Outline, Part, Point, ShaftWeightPart, ShaftWeightShape, shaft_solids,
};
use lanchester_model::{BalanceShaft, Ratio, ShaftWeight};
use proptest::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;

/// A triangle by the places of its corners [m].
type Triangle = [[f32; 3]; 3];

fn float(bytes: &[u8]) -> f32 {
    f32::from_le_bytes(bytes[..4].try_into().unwrap())
}

fn whole(bytes: &[u8]) -> usize {
    u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize
}

/// The triangles of a binary STL file [mm]; each normal is that of its corners.
fn read_stl(bytes: &[u8]) -> Vec<Triangle> {
    assert!(!bytes.starts_with(b"solid"));
    assert_eq!(bytes.len(), 84 + 50 * whole(&bytes[80..]));
    let triangle = |record: &[u8]| {
        let [normal, a, b, c] = [0, 12, 24, 36].map(|at| [0, 4, 8].map(|k| float(&record[at + k..])));
        let cross = cross([a, b, c]);
        let along = (0..3).map(|i| cross[i] * f64::from(normal[i])).sum::<f64>();
        let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!(length == 0.0 || (along / length - 1.0).abs() < 1e-6, "{normal:?}");
        assert_eq!(record[48..], [0, 0]);
        [a, b, c]
    };
    bytes[84..].chunks_exact(50).map(triangle).collect()
}

fn cross(triangle: Triangle) -> [f64; 3] {
    let [a, b, c] = triangle.map(|corner| corner.map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// A mesh of a glTF file.
struct Named {
    name: String,
    colour: Vec<f64>,
    triangles: Vec<Triangle>,
    normals: Vec<Triangle>,
}

/// The meshes of a GLB file [m], by its nodes below the outermost one, whose turn is checked.
fn read_glb(bytes: &[u8]) -> Vec<Named> {
    assert_eq!((&bytes[..4], whole(&bytes[4..]), whole(&bytes[8..])), (&b"glTF"[..], 2, bytes.len()));
    let json = whole(&bytes[12..]);
    assert_eq!((&bytes[16..20], json % 4), (&b"JSON"[..], 0));
    let document: Value = serde_json::from_slice(&bytes[20..20 + json]).unwrap();
    let binary = &bytes[20 + json..];
    assert_eq!((&binary[4..8], whole(binary) + 8, binary.len() % 4), (&b"BIN\0"[..], binary.len(), 0));
    let binary = &binary[8..];
    assert_eq!(document["asset"]["version"], "2.0");
    assert_eq!(document["buffers"][0]["byteLength"], binary.len());
    let number = |value: &Value| value.as_u64().unwrap() as usize;
    let bytes_of = |accessor: &Value| {
        let view = &document["bufferViews"][number(&accessor["bufferView"])];
        let from = number(&view["byteOffset"]);
        assert_eq!(from % 4, 0);
        &binary[from..from + number(&view["byteLength"])]
    };
    let vectors = |index: &Value| -> Vec<[f32; 3]> {
        let accessor = &document["accessors"][number(index)];
        assert_eq!((&accessor["componentType"], &accessor["type"]), (&5126.into(), &"VEC3".into()));
        let all: Vec<[f32; 3]> =
            bytes_of(accessor).chunks_exact(12).map(|v| [0, 4, 8].map(|k| float(&v[k..]))).collect();
        assert_eq!(number(&accessor["count"]), all.len());
        for (key, choose) in [("min", f32::min as fn(f32, f32) -> f32), ("max", f32::max)] {
            if let Some(bound) = accessor.get(key) {
                let ours = all.iter().fold(all[0], |b, v| [0, 1, 2].map(|i| choose(b[i], v[i])));
                let theirs = [0, 1, 2].map(|i| bound[i].as_f64().unwrap() as f32);
                assert_eq!(ours, theirs);
            }
        }
        all
    };
    let root = &document["nodes"][number(&document["scenes"][0]["nodes"][0])];
    // A quarter turn about z: from x to y, which is up in glTF.
    let turn: Vec<f64> = (0..4).map(|i| root["rotation"][i].as_f64().unwrap()).collect();
    assert!(turn.iter().zip([0.0, 0.0, 0.5f64.sqrt(), 0.5f64.sqrt()]).all(|(a, b)| (a - b).abs() < 1e-7));
    let mesh = |child: &Value| {
        let node = &document["nodes"][number(child)];
        let mesh = &document["meshes"][number(&node["mesh"])];
        let primitive = &mesh["primitives"][0];
        assert!(document["accessors"][number(&primitive["attributes"]["POSITION"])].get("min").is_some());
        let points = vectors(&primitive["attributes"]["POSITION"]);
        let normals = vectors(&primitive["attributes"]["NORMAL"]);
        let accessor = &document["accessors"][number(&primitive["indices"])];
        assert_eq!((&accessor["componentType"], &accessor["type"]), (&5125.into(), &"SCALAR".into()));
        let order: Vec<usize> = bytes_of(accessor).chunks_exact(4).map(whole).collect();
        let corners =
            |from: &[[f32; 3]]| order.chunks_exact(3).map(|t| [0, 1, 2].map(|k| from[t[k]])).collect();
        let material = &document["materials"][number(&primitive["material"])]["pbrMetallicRoughness"];
        let colour = material["baseColorFactor"].as_array().unwrap();
        Named {
            name: node["name"].as_str().unwrap().to_string(),
            colour: colour.iter().map(|c| c.as_f64().unwrap()).collect(),
            triangles: corners(&points),
            normals: corners(&normals),
        }
    };
    root["children"].as_array().unwrap().iter().map(mesh).collect()
}

/// Whether every edge is used as often in one sense as in the other; `once` where twice in all.
fn is_watertight(triangles: &[Triangle], once: bool) -> bool {
    let mut uses: BTreeMap<[[u32; 3]; 2], [usize; 2]> = BTreeMap::new();
    for triangle in triangles {
        let corners = triangle.map(|corner| corner.map(f32::to_bits));
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            if a == b {
                return false;
            }
            uses.entry([a.min(b), a.max(b)]).or_default()[usize::from(a < b)] += 1;
        }
    }
    uses.values().all(|[there, back]| there == back && (!once || *there == 1))
}

/// Volume and centroid within triangles.
fn volume(triangles: &[Triangle]) -> (f64, [f64; 3]) {
    let mut sums = [0.0; 4];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| corner.map(f64::from));
        let n = cross(*triangle);
        // Tetrahedra to the origin.
        let volume = (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6.0;
        sums[0] += volume;
        for i in 0..3 {
            sums[i + 1] += volume * (a[i] + b[i] + c[i]) / 4.0;
        }
    }
    (sums[0], [1, 2, 3].map(|i| sums[i] / sums[0]))
}

/// Length of all arcs of a part [m], the bores counted as often as there are inserts.
fn arcs(part: &Part) -> f64 {
    let edges = part.outline().contours().flat_map(|contour| contour.edges());
    let outline: f64 = edges.filter(|edge| edge.bulge != 0.0).map(|edge| edge.length()).sum();
    outline + part.inserts().iter().map(|insert| std::f64::consts::TAU * insert.radius).sum::<f64>()
}

/// Between arc and chord lies at most two thirds of length times facet error, and rounding moves the surface by half a step.
fn assert_as_large(read: (f64, [f64; 3]), exact: (f64, [f64; 3]), part: &Part, facet_error: f64, what: &str) {
    let reach = part.outline().swept_radius() + part.thickness() + part.faces()[1].abs();
    let surface = 2.0 * part.outline().moments().area
        + part.outline().contours().map(Contour::length).sum::<f64>() * part.thickness();
    let surface = surface + arcs(part) * (part.thickness() + 0.1);
    let lost = 2.0 / 3.0 * facet_error * arcs(part) * part.thickness() + 1.2e-7 * reach * surface;
    assert!((read.0 - exact.0).abs() <= lost, "{what}: {read:?} against {exact:?}, {lost:e} may be lost");
    // What is lost lies within the reach of the part.
    for i in 0..3 {
        let moment = (read.0 * read.1[i] - exact.0 * exact.1[i]).abs();
        assert!(moment <= lost * reach, "{what}: {read:?} against {exact:?}, coordinate {i}");
    }
}

fn in_metres(triangles: &[Triangle]) -> (f64, [f64; 3]) {
    let (volume, centroid) = volume(triangles);
    (volume * 1e-9, centroid.map(|x| x * 1e-3))
}

fn web(part: &Part) -> Vec<Solid> {
    solids(&[PlacedPart::new("web", part.clone())]).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    #[test]
    fn prop_meshes_are_watertight_and_within_the_facet_error(part in any_part(), power in -6.0..-3.5f64) {
        let facet_error = 10f64.powf(power);
        let made = web(&part);
        // Coarse facets may cross a thin wall: then it is said, and a finer mesh is right.
        let (facet_error, bytes) = match stl(&made, facet_error) {
            Ok(bytes) => (facet_error, bytes),
            Err(ExportError::FacetsCross { .. }) => (2e-7, stl(&made, 2e-7).unwrap()),
            Err(other) => panic!("{other}"),
        };
        let exact = volumes(&part);
        let all = read_stl(&bytes);
        prop_assert!(is_watertight(&all, false));
        let meshes = read_glb(&glb(&made, facet_error).unwrap());
        prop_assert_eq!(meshes.len(), exact.len());
        prop_assert_eq!(all.len(), meshes.iter().map(|mesh| mesh.triangles.len()).sum::<usize>());
        for (mesh, exact) in meshes.iter().zip(&exact) {
            prop_assert!(is_watertight(&mesh.triangles, true));
            assert_as_large(volume(&mesh.triangles), *exact, &part, facet_error, "glTF");
        }
        let first = &all[..meshes[0].triangles.len()];
        prop_assert!(is_watertight(first, true));
        assert_as_large(in_metres(first), exact[0], &part, facet_error, "STL");
    }

    #[test]
    fn prop_shafts_are_watertight_and_within_the_facet_error(
        shaft_radius in 0.005..0.02f64, beyond in 0.003..0.04f64, share in 0.02..0.98f64, phase in -7.0..7.0f64,
        x in -0.1..0.1f64, y in -0.1..0.1f64, power in -6.0..-4.0f64,
    ) {
        let radius = shaft_radius + beyond;
        let shape = ShaftWeightShape { shaft_radius, radius, chord: -radius + share * (radius + shaft_radius) };
        let part = ShaftWeightPart { shape, length: 0.03, density: 7850.0, wanted: None };
        let weight = |z| ShaftWeight { z, unbalance: part.unbalance(), phase, part: Some(part) };
        let weights = vec![weight(-0.05), weight(0.06)];
        let ratio = Ratio::new(-1, 1).unwrap();
        let shaft = BalanceShaft { name: "left".to_string(), ratio, x, y, weights, inertia: None };
        let parts = shaft_solids(&shaft).unwrap();
        let (made, facet_error) = (solids(&parts).unwrap(), 10f64.powf(power));
        let Ok(bytes) = stl(&made, facet_error) else { return Ok(()) };
        let meshes = read_glb(&glb(&made, facet_error).unwrap());
        let mut all = &read_stl(&bytes)[..];
        prop_assert_eq!(meshes.len(), 3);
        for (mesh, placed) in meshes.iter().zip(&parts) {
            let (volume_of, [x, y, z]) = volumes(&placed.part)[0];
            let exact = (volume_of, [x, y, z + placed.z]);
            let (own, rest) = all.split_at(mesh.triangles.len());
            all = rest;
            prop_assert!(is_watertight(&mesh.triangles, true) && is_watertight(own, true));
            assert_as_large(volume(&mesh.triangles), exact, &placed.part, facet_error, "glTF");
            assert_as_large(in_metres(own), exact, &placed.part, facet_error, "STL");
        }
    }

    #[test]
    fn prop_points_lie_on_the_part_and_chords_within_the_facet_error(part in any_part()) {
        let facet_error = 1e-5;
        let made = solids(&[PlacedPart::new("web", part.clone())]).unwrap();
        let Ok(bytes) = glb(&made, facet_error) else { return Ok(()) };
        let rim = |at: Point| {
            let bores = part.inserts().iter().map(|insert| ((insert.centre - at).norm() - insert.radius).abs());
            bores.fold(part.outline().nearest(at).0, f64::min)
        };
        let [front, rear] = part.faces().map(|z| z as f32);
        for triangle in read_glb(&bytes).iter().flat_map(|mesh| &mesh.triangles) {
            let flat = triangle.map(|corner| Point::new(f64::from(corner[0]), f64::from(corner[1])));
            for k in 0..3 {
                // Single precision of 0.15 m.
                prop_assert!(rim(flat[k]) < 2e-8);
                prop_assert!(triangle[k][2] >= front && triangle[k][2] <= rear);
            }
            // Walls: their chords are the facets.
            let is_wall = triangle.iter().any(|corner| corner[2] != triangle[0][2]);
            for k in 0..3 {
                let middle = (flat[k] + flat[(k + 1) % 3]) * 0.5;
                prop_assert!(!is_wall || rim(middle) < facet_error + 2e-8, "{}", rim(middle));
            }
        }
    }
}

#[test]
fn a_finer_facet_error_brings_the_volume_nearer() {
    // Second order in the chord, so first order in its height: the loss of a disc is 2/3 of circumference times error at most.
    let part = Part::new(Contour::circle(Point::ORIGIN, 0.05).unwrap().into(), 0.02, 7850.0).unwrap();
    let exact = volumes(&part)[0].0;
    let loss = |facet_error: f64| {
        let found = exact - in_metres(&read_stl(&stl(&web(&part), facet_error).unwrap())).0;
        found / (2.0 / 3.0 * facet_error * arcs(&part) * 0.02)
    };
    for facet_error in [1e-4, 1e-5, 1e-6] {
        let part = loss(facet_error);
        assert!(part <= 1.0 + 1e-2 && part > 0.9, "{facet_error}: {part}");
    }
}

#[test]
fn normals_are_those_of_the_cylinder() {
    let ring = Outline::new(
        Contour::circle(Point::ORIGIN, 0.05).unwrap(),
        vec![Contour::circle(Point::ORIGIN, 0.03).unwrap()],
    );
    let part = Part::new(ring.unwrap(), 0.02, 7850.0).unwrap();
    let meshes = read_glb(&glb(&web(&part), 1e-4).unwrap());
    let mut seen = [0; 3];
    for (triangle, normals) in meshes[0].triangles.iter().zip(&meshes[0].normals) {
        for (at, normal) in triangle.iter().zip(normals) {
            let radius = at[0].hypot(at[1]);
            let along = (at[0] * normal[0] + at[1] * normal[1]) / radius;
            let expected = if normal[2] != 0.0 {
                0.0
            } else if radius > 0.04 {
                1.0
            } else {
                -1.0
            };
            assert!((along - expected).abs() < 1e-6, "{at:?} {normal:?}");
            assert!(normal[2] == 0.0 || (normal[2] > 0.0) == (at[2] > 0.0));
            seen[(expected + 1.0) as usize] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 50));
}

#[test]
fn an_assembly_stands_at_its_places_with_its_names() {
    let slug =
        Insert { centre: Point::new(0.03, 0.0), radius: 0.005, from: 0.0, to: 0.02, density: 18_000.0 };
    let web = Part::new(Contour::circle(Point::new(0.02, 0.0), 0.05).unwrap().into(), 0.02, 7850.0).unwrap();
    let web = web.with_insert(slug).unwrap();
    let parts = [
        PlacedPart::new("web \"1\"", web.clone()).moved(0.1).coloured([1.0, 0.0, 0.5]),
        PlacedPart::new("web 2", web.clone()).moved(0.3).turned(std::f64::consts::PI),
    ];
    let solids = solids(&parts).unwrap();
    let bytes = glb(&solids, 1e-6).unwrap();
    assert_eq!(bytes, glb(&solids, 1e-6).unwrap());
    assert_eq!(stl(&solids, 1e-6).unwrap(), stl(&solids, 1e-6).unwrap());
    let meshes = read_glb(&bytes);
    let names: Vec<&str> = meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["web \"1\"", "web \"1\", insert 1", "web 2", "web 2, insert 1"]);
    // The curve of sRGB at 0.5.
    assert!((meshes[0].colour[2] - 0.214_041).abs() < 1e-6 && meshes[0].colour[0] == 1.0);
    let exact = volumes(&web);
    for (mesh, (k, sign, z)) in
        meshes.iter().zip([(0, 1.0, 0.1), (1, 1.0, 0.1), (0, -1.0, 0.3), (1, -1.0, 0.3)])
    {
        let (found, centroid) = volume(&mesh.triangles);
        assert!((found / exact[k].0 - 1.0).abs() < 5e-4, "facets of 1e-6 on a radius of 5 mm");
        assert!((centroid[0] - sign * exact[k].1[0]).abs() < 1e-6, "{centroid:?}");
        assert!(centroid[1].abs() < 1e-7 && (centroid[2] - z).abs() < 1e-7, "{centroid:?}");
    }
}

#[test]
fn facets_that_would_cross_and_impossible_errors_are_refused() {
    // A bore that leaves 10 um: the rim's chords of 0.1 mm height would cut into it.
    let rim = Insert { centre: Point::new(0.04, 0.0), radius: 0.00999, from: 0.0, to: 0.02, density: 0.0 };
    let disc = Contour::circle(Point::new(0.0, 0.0), 0.05).unwrap().turned(0.1);
    let part = Part::new(disc.into(), 0.02, 7850.0).unwrap().with_insert(rim).unwrap();
    let error = stl(&web(&part), 3e-3).unwrap_err();
    assert!(matches!(error, ExportError::FacetsCross { facet_error: 3e-3, .. }), "{error}");
    assert!(is_watertight(&read_stl(&stl(&web(&part), 1e-6).unwrap()), true));
    // A bore within a segment that coarse facets cut off altogether: nothing crosses.
    let speck = Insert { centre: Point::new(0.0494, 0.0), radius: 2e-4, from: 0.0, to: 0.02, density: 0.0 };
    let disc = Contour::circle(Point::ORIGIN, 0.05).unwrap().turned(std::f64::consts::FRAC_PI_8);
    let part = Part::new(disc.into(), 0.02, 7850.0).unwrap().with_insert(speck).unwrap();
    let error = stl(&web(&part), 3e-3).unwrap_err();
    assert!(matches!(error, ExportError::FacetsCross { .. }), "{error}");
    for facet_error in [0.0, -1.0, f64::NAN, 1e-12, 1.0] {
        let error = glb(&web(&part), facet_error).unwrap_err();
        assert!(matches!(error, ExportError::FacetError { .. }), "{error}");
    }
    let speck = Part::new(Contour::circle(Point::new(1.0, 0.0), 2e-8).unwrap().into(), 0.02, 7850.0).unwrap();
    let error = stl(&web(&speck), 1e-6).unwrap_err();
    assert!(matches!(error, ExportError::LostInRounding { .. }), "{error}");
}

#[test]
fn corners_on_a_straight_line_leave_no_gap() {
    let corner = |x: f64, y: f64| Corner { at: Point::new(x, y), bulge: 0.0 };
    let corners: Vec<Corner> =
        [(0.0, 0.0), (0.03, 0.0), (0.07, 0.0), (0.1, 0.0), (0.1, 0.1), (0.05, 0.1), (0.0, 0.1)]
            .map(|(x, y)| corner(x, y))
            .into();
    let part = Part::new(Contour::new(&corners).unwrap().into(), 0.02, 7850.0).unwrap();
    let triangles = read_stl(&stl(&web(&part), 1e-5).unwrap());
    assert!(is_watertight(&triangles, true));
    assert_eq!(triangles.len(), 2 * 5 + 2 * 7);
}

#[test]
fn a_gap_or_a_turned_triangle_would_be_seen() {
    let part = Part::new(Contour::circle(Point::ORIGIN, 0.05).unwrap().into(), 0.02, 7850.0).unwrap();
    let triangles = read_stl(&stl(&web(&part), 1e-4).unwrap());
    assert!(is_watertight(&triangles, true));
    assert!(!is_watertight(&triangles[1..], true));
    let mut turned = triangles.clone();
    turned[3].swap(0, 1);
    assert!(!is_watertight(&turned, true));
}
