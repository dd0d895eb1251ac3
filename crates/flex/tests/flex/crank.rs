//! The mesh of a crankshaft and its static case.

use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, CrankSupport, PinLoad, PinPressure, crank_cases};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::mesh::surface;
use lanchester_flex::sparse::Precision;
use lanchester_flex::statics::{SolveOptions, as_node_forces};
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::Engine;
use std::f64::consts::{PI, TAU};

/// A crankshaft of one throw: mains 55 mm, pin 48 mm, fillets as given.
pub fn one_throw(change: &str) -> Engine {
    throws("cylinders = 1", change)
}

/// The same with as many throws as the layout says.
pub fn throws(layout: &str, change: &str) -> Engine {
    let text = format!(
        r#"
name = "single"
speed = "4000 rpm"
[layout]
type = "in-line"
{layout}
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
    CrankMeshOptions { size: 16e-3, fillet_elements: 2, fillets }
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
fn examples_with_counterweights_and_with_single_elements_are_meshed() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut meshed = Vec::new();
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
                meshed.push(name);
            }
            Err(error) => println!("{name}: {error}"),
        }
    }
    for name in ["in-line-3-counterweights", "in-line-4-crank-by-elements"] {
        assert!(meshed.iter().any(|meshed| meshed == name), "{name} is meshed: {meshed:?}");
    }
}

#[test]
fn fillets_that_do_not_fit_are_told() {
    let engine = one_throw("pin_fillet = \"11.9 mm\"\njournal_fillet = \"3 mm\"");
    let error = crank_mesh(&engine, 0, CrankMeshOptions::default()).unwrap_err();
    assert!(matches!(error, FlexError::Mesh { .. }), "{error}");
}

#[test]
fn static_case_of_a_crankshaft_is_in_balance() {
    let engine = one_throw("pin_fillet = \"4 mm\"\njournal_fillet = \"4 mm\"");
    let load = PinLoad { pin: 1, force: [-65e3 * 0.992, 65e3 * 0.122] };
    let loads = [CrankLoad { pins: vec![load], ..CrankLoad::default() }];
    let solve = |fillet_elements: usize, support: CrankSupport, precision: Precision| {
        let crank = crank_mesh(&engine, 0, CrankMeshOptions { fillet_elements, ..coarse(true) }).unwrap();
        let options = SolveOptions { precision, ..SolveOptions::default() };
        let mut cases = solve_crank(&crank, &support, &loads, options).unwrap();
        cases.remove(0)
    };
    let journals = solve(2, CrankSupport::Journals, Precision::Single);
    for axis in 0..2 {
        let solution = &journals.solution;
        assert!((solution.load[axis] - load.force[axis]).abs() < 1e-6, "the load is what was asked for");
        assert!(
            (solution.reaction[axis] + solution.load[axis]).abs() < 1e-9 * 65e3,
            "{:?}",
            solution.reaction
        );
    }
    let clamped = solve(2, CrankSupport::ClampedEnds, Precision::Single);
    let energy = clamped.solution.energy;
    assert!(journals.solution.energy > energy, "journals that may tilt are softer than clamped ends");
    let double = solve(2, CrankSupport::ClampedEnds, Precision::Double);
    assert!((double.solution.energy / energy - 1.0).abs() < 1e-9, "single precision is refined to double");
    assert_eq!(clamped.peaks.len(), 4);
    // The throw is bent in its own plane: the two webs are mirror images, and the largest fillet stress is at the pin or journal
    // between them, some hundred MPa.
    let peak = |k: usize| clamped.peaks[k].stress.unwrap().von_mises;
    assert!((peak(0) / peak(3) - 1.0).abs() < 0.05 && (peak(1) / peak(2) - 1.0).abs() < 0.05);
    assert!((20e6..600e6).contains(&peak(1)));
}

/// A pressure p_0 cos(a - a_F) over 180 degrees pushes the half of the pin that faces it, p_0 = 2 F/(pi r L), and pulls nowhere; an even one,
/// p = F/(2 r L), does the same with more of it at the ends of the half.
#[test]
fn pressure_of_a_load_acts_on_one_half_of_the_pin() {
    // INT cos^4 / INT cos^2 and INT cos^3 / INT cos over the half.
    for (pressure, wanted) in [(PinPressure::Cosine, 3.0 / 4.0), (PinPressure::Uniform, 2.0 / 3.0)] {
        let spread = spread_of_a_load(pressure);
        assert!((spread - wanted).abs() < 0.01, "{pressure:?}: {spread}");
    }
}

/// Second moment of the force along itself, by the distance from the axis of the pin along it in radii.
fn spread_of_a_load(pressure: PinPressure) -> f64 {
    let engine = one_throw("");
    let crank = crank_mesh(&engine, 0, coarse(false)).unwrap();
    let force = [-65e3, 10.66e3];
    let load = CrankLoad { pins: vec![PinLoad { pin: 1, force }], pressure, ..CrankLoad::default() };
    let case = crank_cases(&crank, &CrankSupport::Journals, &[load]).unwrap().remove(0);
    let size = f64::hypot(force[0], force[1]);
    let along = force.map(|force| force / size);
    let (mut facing, mut spread, mut sum) = (0.0, 0.0, [0.0; 2]);
    for own in &case.forces {
        let at = crank.mesh.nodes[own.node as usize];
        let place = [at[0] - 0.5 * 0.0955, at[1]];
        let ahead = (place[0] * along[0] + place[1] * along[1]) / 0.024;
        let part = (own.force[0] * along[0] + own.force[1] * along[1]) / size;
        facing += if ahead < 1e-9 { part } else { 0.0 };
        spread += part * ahead * ahead;
        sum = [sum[0] + own.force[0], sum[1] + own.force[1]];
    }
    assert!((facing - 1.0).abs() < 1e-9, "{facing} of the load pushes");
    assert!((0..2).all(|k| (sum[k] - force[k]).abs() < 1e-9 * size), "{sum:?}");
    spread
}

#[test]
fn sharp_corner_has_no_stress() {
    let engine = one_throw("");
    let crank = crank_mesh(&engine, 0, coarse(true)).unwrap();
    let load = CrankLoad {
        pins: vec![PinLoad { pin: 1, force: [-1e4, 0.0] }],
        speed: 100.0,
        ..CrankLoad::default()
    };
    let cases = solve_crank(&crank, &CrankSupport::Free, &[load], SolveOptions::default()).unwrap();
    assert!(cases[0].peaks.iter().all(|peak| peak.stress.is_none()));
    let mass = crank.quality.mass;
    let acceleration = cases[0].solution.accelerations.unwrap();
    let wanted = (-1e4 + 100.0 * 100.0 * mass * crank.quality.centre[0]) / mass;
    // The force and the centre of mass are in the plane of the throw and in its middle: the body does not turn.
    assert!((acceleration[0] / wanted - 1.0).abs() < 1e-5, "{acceleration:?} {wanted}");
    assert!(acceleration[3..].iter().all(|turn| turn.abs() < 1e-4 * wanted.abs()), "{acceleration:?}");
}

/// A crankshaft that speeds up is held back by its own inertia, `W' I_zz` about its axis; free, it follows without any stress.
#[test]
fn a_crankshaft_that_speeds_up_is_loaded_by_its_inertia() {
    let engine = one_throw("pin_fillet = \"4 mm\"\njournal_fillet = \"4 mm\"");
    let crank = crank_mesh(&engine, 0, coarse(true)).unwrap();
    let load = CrankLoad { acceleration: 2e4, ..CrankLoad::default() };
    let solve = |support: CrankSupport| {
        solve_crank(&crank, &support, std::slice::from_ref(&load), SolveOptions::default()).unwrap().remove(0)
    };
    let held = solve(CrankSupport::ClampedEnds);
    let torque = |forces: &[[f64; 3]]| {
        forces.iter().zip(&crank.mesh.nodes).map(|(f, at)| at[0] * f[1] - at[1] * f[0]).sum::<f64>()
    };
    let wanted = 2e4 * crank.quality.inertia[2];
    let found = torque(&held.solution.reactions);
    assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    // Across the throw, against the sense in which it speeds up.
    let across = -2e4 * crank.quality.mass * crank.quality.centre[0];
    assert!((held.solution.load[1] / across - 1.0).abs() < 1e-9, "{:?} {across}", held.solution.load);
    let largest = |case: &CrankCase| {
        case.peaks.iter().filter_map(|peak| peak.stress).map(|own| own.von_mises).fold(0.0, f64::max)
    };
    let free = solve(CrankSupport::Free);
    assert!(largest(&free) < 1e-7 * largest(&held), "{} {}", largest(&free), largest(&held));
    let plain = as_node_forces(
        &crank.mesh,
        &crank_cases(&crank, &CrankSupport::ClampedEnds, std::slice::from_ref(&load)).unwrap()[0],
    );
    let given: Vec<[f64; 3]> =
        plain.unwrap().forces.iter().fold(vec![[0.0; 3]; crank.mesh.nodes.len()], |mut all, own| {
            all[own.node as usize] = own.force;
            all
        });
    assert!((torque(&given) / wanted + 1.0).abs() < 1e-9, "as forces on nodes {} {wanted}", torque(&given));
}
