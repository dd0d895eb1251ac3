//! Exported parts as an independent CAD kernel measured them: validation/external/gmsh.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::sample_parts;

use crate::support::sample_parts::samples;
use lanchester_geometry::export::{PlacedPart, StepHeader, solids, step};
use lanchester_geometry::{Chamfer, Contour, Cut, Insert, MassMoments, Outline, Part, Point};
use serde_json::Value;
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../validation/external/gmsh")
}

fn exported(name: &str, parts: &[PlacedPart]) -> String {
    let header = StepHeader { title: name.to_string(), ..StepHeader::default() };
    step(&solids(parts).unwrap(), &header)
}

/// The words of a STEP file and its numbers, apart.
fn words_and_numbers(text: &str) -> (String, Vec<f64>) {
    let (mut words, mut numbers) = (String::new(), Vec::new());
    for token in text.split_inclusive([',', '(', ')', ';']) {
        let (body, end) = token.split_at(token.len() - 1);
        match body.parse() {
            Ok(number) => numbers.push(number),
            Err(_) => words.push_str(body),
        }
        words.push_str(end);
    }
    (words, numbers)
}

/// The files that were measured are what is exported now. Where the export is meant to change, the variable
/// `LANCHESTER_WRITE_STEP` writes them anew, and the script beside them measures them again.
#[test]
fn snap_step_files_are_those_that_were_measured() {
    for (name, parts) in samples() {
        let path = folder().join(format!("{name}.step"));
        let ours = exported(name, &parts);
        if std::env::var_os("LANCHESTER_WRITE_STEP").is_some() {
            std::fs::write(&path, &ours).unwrap();
        }
        let stored = std::fs::read_to_string(&path).unwrap();
        let ((words, numbers), (stored_words, stored_numbers)) =
            (words_and_numbers(&ours), words_and_numbers(&stored));
        assert_eq!(words, stored_words, "{name}");
        // Sine and cosine may differ in their last bit between machines; millimetres.
        let far = numbers.iter().zip(&stored_numbers).find(|(a, b)| (*a - *b).abs() > 1e-11);
        assert!(numbers.len() == stored_numbers.len() && far.is_none(), "{name}: {far:?}");
    }
}

/// Moments at density 1 of a part without its bores, then of each insert that has a material, in their frames in the assembly.
fn moments(placed: &PlacedPart) -> Vec<MassMoments> {
    const STEEL: f64 = 7850.0;
    let turned = |at: Point| at.turned(placed.turn);
    let part = &placed.part;
    let z = (part.faces()[0] + part.faces()[1]) / 2.0 + placed.z;
    let plate =
        |outline: Outline, thickness: f64, z: f64| Part::new(outline, thickness, STEEL).unwrap().at(z);
    let mut body = plate(part.outline().turned(placed.turn), part.thickness(), z);
    for chamfer in part.chamfers() {
        let cut = match chamfer.cut {
            Cut::Milled { direction, distance } => {
                Cut::Milled { direction: direction + placed.turn, distance }
            }
            turned => turned,
        };
        body = body.with_chamfer(Chamfer { cut, ..*chamfer }).unwrap();
    }
    let mut slugs = Vec::new();
    for insert in part.inserts() {
        let centre = turned(insert.centre);
        body = body.with_insert(Insert { centre, density: 0.0, ..*insert }).unwrap();
        if insert.density > 0.0 {
            let circle = Contour::circle(centre, insert.radius).unwrap();
            let middle = z - part.thickness() / 2.0 + (insert.from + insert.to) / 2.0;
            slugs.push(plate(circle.into(), insert.to - insert.from, middle));
        }
    }
    std::iter::once(&body).chain(&slugs).map(|part| part.moments() * (1.0 / STEEL)).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The largest relative difference of volume, centroid and inertia about the centroid.
fn difference(ours: &MassMoments, stored: &Value) -> f64 {
    let ours = ours.properties();
    let reach = 0.1;
    let volume = number(&stored["volume [mm3]"]) * 1e-9;
    let mut worst = (ours.mass / volume - 1.0).abs();
    let largest = (0..3).map(|i| ours.inertia_about_centre[i][i]).fold(0.0, f64::max);
    for i in 0..3 {
        let centroid = number(&stored["centroid [mm]"][i]) * 1e-3;
        worst = worst.max((ours.centre[i] - centroid).abs() / reach);
        for j in 0..3 {
            let inertia = number(&stored["inertia about the centroid [mm5]"][i][j]) * 1e-15;
            worst = worst.max((ours.inertia_about_centre[i][j] - inertia).abs() / largest);
        }
    }
    worst
}

/// OpenCASCADE opens the exported files, finds every solid by its name, and integrates over them what we do.
#[test]
fn ext_gmsh_mass_properties_of_exported_solids() {
    let json = std::fs::read_to_string(folder().join("solids.json")).unwrap();
    let stored: Value = serde_json::from_str(&json).unwrap();
    for (name, parts) in samples() {
        let measured = stored["files"][format!("{name}.step")].as_array().unwrap();
        let names: Vec<String> =
            solids(&parts).unwrap().iter().map(|solid| solid.name().to_string()).collect();
        let found: Vec<&str> = measured.iter().map(|solid| solid["name"].as_str().unwrap()).collect();
        assert_eq!(found, names, "{name}");
        let ours: Vec<MassMoments> = parts.iter().flat_map(moments).collect();
        for ((ours, stored), which) in ours.iter().zip(measured).zip(&names) {
            // The kernel's own integration is good to some 1e-9 of a solid with arcs, and to some 1e-7 of one with cones and splines.
            let good = if name == "chamfered-web" { 1e-6 } else { 1e-8 };
            let worst = difference(ours, stored);
            assert!(worst < good, "{name}, {which}: {worst:e}");
            let moved = ours.moved([good, 0.0, 0.0]);
            assert!(difference(&moved, stored) > 5.0 * good, "10 nm would be seen, of chamfers 1 um");
        }
    }
}
