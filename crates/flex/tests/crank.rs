//! The mesh of a crankshaft and its static case.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::mesh::surface;
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// A crankshaft of one throw: mains 55 mm, pin 48 mm, fillets as given.
fn one_throw(change: &str) -> Engine {
    let text = format!(
        r#"
name = "single"
speed = "4000 rpm"
[layout]
type = "in-line"
cylinders = 1
spacing = "90 mm"
[crank]
stroke = "95.5 mm"
web_distance = "48 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "55 mm"
pin_diameter = "48 mm"
web_thickness = "20 mm"
web_radius = "40 mm"
pin_end_radius = "36 mm"
end_journals = ["25 mm", "25 mm"]
{change}
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#
    );
    read(&text)
}

fn read(text: &str) -> Engine {
    let reading = lanchester_file::read(text);
    assert!(reading.diagnostics.is_empty(), "{:?}", reading.diagnostics);
    reading.engine().unwrap()
}

fn coarse(fillets: bool) -> CrankMeshOptions {
    CrankMeshOptions { size: 12e-3, fillet_elements: 2, fillets }
}

/// Volume that a fillet adds: the corner square less a quarter disc, turned about the bar's axis (Pappus).
fn fillet_volume(bar: f64, radius: f64) -> f64 {
    let area = radius * radius * (1.0 - PI / 4.0);
    let moment = radius.powi(3) / 2.0 - PI * radius * radius / 4.0 * (radius - 4.0 * radius / (3.0 * PI));
    TAU * (area * bar + moment)
}

fn check_conforming(crank: &CrankMesh) {
    let (faces, crowded) = surface(&crank.mesh);
    assert_eq!(crowded, 0, "no face has three elements");
    // A closed surface: each of its edges belongs to two faces, so the vector sum of all areas is zero.
    let areas = lanchester_flex::mesh::surface_areas(&crank.mesh, &faces);
    for axis in 0..3 {
        let sum: f64 = areas.values().map(|area| area[axis]).sum();
        assert!(sum.abs() < 1e-12, "open along {axis}: {sum}");
    }
}

#[test]
fn mesh_has_the_mass_of_the_exact_body() {
    let engine = one_throw("pin_fillet = \"3 mm\"\njournal_fillet = \"3 mm\"");
    let exact = crankshaft(&engine, 0).unwrap().mass;
    let sharp = crank_mesh(&engine, 0, coarse(false)).unwrap();
    check_conforming(&sharp);
    assert!((sharp.quality.mass / exact.mass - 1.0).abs() < 1e-5, "{} {}", sharp.quality.mass, exact.mass);
    let filleted = crank_mesh(&engine, 0, CrankMeshOptions { fillet_elements: 6, ..coarse(true) }).unwrap();
    check_conforming(&filleted);
    let added = 2.0 * fillet_volume(0.024, 0.003) + 2.0 * fillet_volume(0.0275, 0.003);
    let wanted = exact.mass + 7850.0 * added;
    assert!((filleted.quality.mass / wanted - 1.0).abs() < 1e-5, "{} {wanted}", filleted.quality.mass);
    assert!(filleted.quality.least_jacobian > 0.4, "{:?}", filleted.quality);
    assert_eq!(filleted.corners.len(), 4);
    println!("{:?}", filleted.quality);
}

#[test]
fn every_example_with_a_body_is_meshed() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut meshed = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let Some(engine) = lanchester_file::read(&std::fs::read_to_string(&path).unwrap()).engine() else {
            continue;
        };
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        match crank_mesh(&engine, 0, coarse(true)) {
            Ok(crank) => {
                check_conforming(&crank);
                println!("{name}: {:?} {:?}", crank.quality, crank.left_out);
                meshed += 1;
            }
            Err(error) => println!("{name}: {error}"),
        }
    }
    assert!(meshed >= 1);
}

#[test]
fn fillets_that_do_not_fit_are_told() {
    let engine = one_throw("pin_fillet = \"11.9 mm\"\njournal_fillet = \"3 mm\"");
    let error = crank_mesh(&engine, 0, CrankMeshOptions::default()).unwrap_err();
    assert!(matches!(error, FlexError::Mesh { .. }), "{error}");
}
