//! Scenes against the mechanism's own places and the solids that they show.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::file::{read, templates};
use lanchester::geometry::crankshaft::crankshaft_pieces;
use lanchester::mechanism::RodLinkage;
use lanchester::model::Engine;
use lanchester::{Scene, SceneKind, SceneMesh, SceneMotion, ScenePart, scene};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

/// Templates and examples with their names.
fn engines() -> Vec<(String, Engine)> {
    let mut texts: Vec<(String, String)> =
        templates().iter().map(|template| (template.name.to_owned(), template.text.to_owned())).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            texts.push((
                path.file_name().unwrap().to_string_lossy().into_owned(),
                std::fs::read_to_string(&path).unwrap(),
            ));
        }
    }
    texts.sort();
    let engines = texts.into_iter().filter_map(|(name, text)| Some((name, read(&text).engine()?)));
    engines.collect()
}

fn named(name: &str) -> Engine {
    engines().into_iter().find(|(other, _)| other == name).unwrap().1
}

fn corner(mesh: &SceneMesh, index: u32) -> [f64; 3] {
    let at = 3 * index as usize;
    [mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]]
}

/// Volume that a closed surface has inside [m^3].
fn volume(mesh: &SceneMesh) -> f64 {
    let of = |triangle: &[u32]| {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(|index| corner(mesh, index));
        let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        (0..3).map(|axis| a[axis] * cross[axis]).sum::<f64>() / 6.0
    };
    mesh.indices.chunks_exact(3).map(of).sum()
}

/// Edges that no other triangle has backwards.
fn open_edges(mesh: &SceneMesh) -> usize {
    let key = |index: u32| corner(mesh, index).map(|value| (1e6 * value).round() as i64);
    let mut edges: BTreeMap<_, i64> = BTreeMap::new();
    for triangle in mesh.indices.chunks_exact(3) {
        for k in 0..3 {
            let (from, to) = (key(triangle[k]), key(triangle[(k + 1) % 3]));
            *edges.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    edges.values().filter(|count| **count != 0).count()
}

fn of_kind(scene: &Scene, kind: SceneKind) -> Vec<&ScenePart> {
    scene.parts.iter().filter(|part| part.kind == kind).collect()
}

#[test]
fn every_engine_has_a_scene_of_closed_surfaces() {
    let engines = engines();
    assert!(engines.len() >= 50, "{}", engines.len());
    for (name, engine) in engines {
        let scene = scene(&engine);
        for kind in [SceneKind::Rod, SceneKind::Piston, SceneKind::Bore] {
            assert_eq!(of_kind(&scene, kind).len(), engine.cylinders.len(), "{name}: {kind:?}");
        }
        assert_eq!(of_kind(&scene, SceneKind::Crankpin).len(), engine.throws.len(), "{name}");
        assert!(
            !of_kind(&scene, SceneKind::Web).is_empty() && !of_kind(&scene, SceneKind::Journal).is_empty(),
            "{name}"
        );
        assert_eq!(of_kind(&scene, SceneKind::Shaft).len(), engine.shafts.len(), "{name}");
        for (index, weight) in engine.counterweights.iter().enumerate() {
            let shown = scene.parts.iter().filter(|part| part.weight == Some(index)).count();
            assert_eq!(shown > 0, weight.unbalance > 0.0, "{name}: {}", weight.name);
        }
        for (index, mesh) in scene.meshes.iter().enumerate() {
            let user = &scene.parts.iter().find(|part| part.mesh == index).unwrap().name;
            assert_eq!(open_edges(mesh), 0, "{name}: {user} is open");
            assert!(volume(mesh) > 0.0, "{name}: {user} is inside out");
            assert_eq!(mesh.positions.len(), mesh.normals.len(), "{name}: {user}");
            for triangle in mesh.indices.chunks_exact(3) {
                let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(|index| corner(mesh, index));
                let (ab, ac) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
                let face = [
                    ab[1] * ac[2] - ab[2] * ac[1],
                    ab[2] * ac[0] - ab[0] * ac[2],
                    ab[0] * ac[1] - ab[1] * ac[0],
                ];
                let normal = &mesh.normals[3 * triangle[0] as usize..][..3];
                let along: f64 = (0..3).map(|k| face[k] * normal[k]).sum();
                let size = face.iter().map(|x| x * x).sum::<f64>().sqrt();
                // Triangles near the rounding of a micrometre have no direction of their own.
                assert!(along > 0.0 || size < 1e-9, "{name}: {user}: a normal points inwards");
            }
        }
        let bytes = serde_json::to_string(&scene).unwrap().len();
        assert!(bytes < 1_200_000, "{name}: {bytes} bytes");
        println!(
            "{name}: {} parts, {} meshes, {} triangles, {} kB",
            scene.parts.len(),
            scene.meshes.len(),
            scene.parts.iter().map(|part| scene.meshes[part.mesh].indices.len() / 3).sum::<usize>(),
            bytes / 1000
        );
    }
}

/// Place and turn of a part at `theta` where `theta` is a step of it.
fn at_step(scene: &Scene, motion: &SceneMotion, step: usize) -> (f64, [f64; 2], f64) {
    match motion {
        SceneMotion::Slide { x, y, angle, period, travel, .. } => {
            let (sin, cos) = angle.sin_cos();
            assert_eq!(travel.len(), scene.steps);
            (
                period * step as f64 / scene.steps as f64,
                [x + travel[step] * cos, y + travel[step] * sin],
                *angle,
            )
        }
        SceneMotion::Swing { x, y, angle, period, .. } => {
            assert_eq!([x.len(), y.len(), angle.len()], [scene.steps; 3]);
            (period * step as f64 / scene.steps as f64, [x[step], y[step]], angle[step])
        }
        SceneMotion::Fixed { .. } | SceneMotion::Turn { .. } => panic!("it has no steps"),
    }
}

#[test]
fn rods_and_pistons_stand_where_the_linkages_put_them() {
    for name in ["in-line-4", "vr6-15", "radial-9", "square-4", "opposed-piston-3", "v8-crossplane", "v2-90"]
    {
        let engine = named(name);
        let scene = scene(&engine);
        for (rod, piston) in
            of_kind(&scene, SceneKind::Rod).into_iter().zip(of_kind(&scene, SceneKind::Piston))
        {
            let index = rod.cylinder.unwrap() - 1;
            assert_eq!(piston.cylinder, rod.cylinder);
            let cylinder = &engine.cylinders[index];
            let shaft = &engine.crankshafts[engine.throws[cylinder.throw].crankshaft];
            let linkage = RodLinkage::new(&engine, index).unwrap();
            for step in (0..scene.steps).step_by(7) {
                let (theta, at, angle) = at_step(&scene, &rod.motion, step);
                let place = linkage.at(theta);
                // Rounded to a micrometre and a millionth of a radian.
                assert!((at[0] - shaft.x - place.lower_pin[0].re).abs() < 1e-6, "{name}: {}", rod.name);
                assert!((at[1] - shaft.y - place.lower_pin[0].im).abs() < 1e-6, "{name}: {}", rod.name);
                assert!((angle - place.direction[0]).abs() < 1e-6, "{name}: {}", rod.name);
                let small_end =
                    [at[0] + cylinder.rod.length * angle.cos(), at[1] + cylinder.rod.length * angle.sin()];
                let (_, foot, axis) = at_step(&scene, &piston.motion, step);
                let (sin, cos) = axis.sin_cos();
                let pin = [foot[0] - cylinder.pin_offset * sin, foot[1] + cylinder.pin_offset * cos];
                let apart = (pin[0] - small_end[0]).hypot(pin[1] - small_end[1]);
                assert!(apart < 4e-6, "{name}: {} is {apart} m from its rod", piston.name);
            }
        }
    }
}

#[test]
fn pins_and_shafts_turn_with_their_ratios() {
    for name in ["in-line-4-lanchester", "square-4", "opposed-piston-3", "single-two-shafts"] {
        let engine = named(name);
        let scene = scene(&engine);
        for part in of_kind(&scene, SceneKind::Crankpin) {
            let SceneMotion::Turn { x, y, angle, ratio, .. } = part.motion else {
                panic!("{name}: a pin turns")
            };
            let number = part.name.split([' ', ',']).nth(1).unwrap().parse::<usize>().unwrap();
            let throw = &engine.throws[number - 1];
            let shaft = &engine.crankshafts[throw.crankshaft];
            assert!((x - shaft.x).abs() < 1e-6 && (y - shaft.y).abs() < 1e-6, "{name}");
            let mesh = &scene.meshes[part.mesh];
            let count = (mesh.positions.len() / 3) as f64;
            let centre = [0, 1].map(|axis| mesh.positions.iter().skip(axis).step_by(3).sum::<f64>() / count);
            assert!((centre[0] - throw.radius).abs() < 1e-5 && centre[1].abs() < 1e-5, "{name}: {centre:?}");
            for theta in [0.0, 1.0, 5.0] {
                let off = angle + ratio * theta - engine.pin_angle(number - 1, theta);
                assert!((off - TAU * (off / TAU).round()).abs() < 1e-6, "{name}: {}", part.name);
            }
        }
        for (part, shaft) in of_kind(&scene, SceneKind::Shaft).into_iter().zip(&engine.shafts) {
            let SceneMotion::Turn { x, y, ratio, .. } = part.motion else { panic!("{name}: a shaft turns") };
            assert_eq!([x, y, ratio], [shaft.x, shaft.y, shaft.ratio.value()], "{name}");
        }
    }
}

#[test]
fn a_crankshaft_that_is_a_body_is_shown_with_its_own_solids() {
    let engine = named("in-line-3-counterweights.toml");
    let scene = scene(&engine);
    let pieces = crankshaft_pieces(&engine, 0).unwrap();
    for piece in &pieces {
        let part = scene.parts.iter().find(|part| part.name.ends_with(&piece.placed.name)).unwrap();
        let solid = piece.placed.part.mass_properties().mass / piece.placed.part.density();
        let shown = volume(&scene.meshes[part.mesh]);
        // Chords of thirty facets a turn lose 0.8 % of a round bar.
        assert!(shown <= solid * (1.0 + 1e-6) && shown > 0.99 * solid, "{}: {shown} of {solid}", part.name);
    }
    assert!(scene.parts.iter().filter(|part| part.kind == SceneKind::Counterweight).count() == 4);
    assert!(scene.parts.iter().any(|part| part.name.contains("symbolic")), "the weights are numbers still");
}

#[test]
fn symbolic_weights_grow_with_their_unbalance() {
    let mut engine = named("v8-crossplane");
    let size = |engine: &Engine| {
        let scene = scene(engine);
        let part = scene.parts.iter().find(|part| part.weight == Some(0)).unwrap();
        volume(&scene.meshes[part.mesh])
    };
    let before = size(&engine);
    engine = engine
        .with(|engine| {
            engine.counterweights[0].unbalance *= 0.5;
        })
        .unwrap();
    assert!(size(&engine) < 0.9 * before, "half of the unbalance is smaller");
}
