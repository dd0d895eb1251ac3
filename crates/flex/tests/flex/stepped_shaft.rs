//! A crankshaft whose webs are discs about its axis is a stepped shaft: stress of its fillets in bending and torsion against an axisymmetric
//! computation by other means, converged to 0.02 % (`validation/external/stepped-shaft`).

use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::statics::{SolveOptions, StaticSystem, node_stresses};
use std::f64::consts::PI;

/// Diameter of the shaft [m].
const SHAFT: f64 = 50e-3;

/// Journals and a pin of 50 mm, and two discs of 60 mm as webs; the journals have fillets of 3 mm. The crank radius is next to nothing.
const ENGINE: &str = r#"
name = "stepped shaft"
speed = "1000 rpm"
[layout]
type = "in-line"
cylinders = 1
spacing = "300 mm"
[crank]
stroke = "50 mm"
web_distance = "70 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "50 mm"
pin_diameter = "50 mm"
web_thickness = "40 mm"
web_radius = "30 mm"
pin_end_radius = "30 mm"
end_journals = ["100 mm", "100 mm"]
journal_fillet = "3 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#;

fn shaft(fillet_elements: usize) -> CrankMesh {
    let reading = lanchester_file::read(ENGINE);
    assert!(reading.diagnostics.is_empty(), "{:?}", reading.diagnostics);
    let engine = reading.engine().unwrap().with(|parts| parts.throws[0].radius = 1e-5).unwrap();
    let options = CrankMeshOptions { size: 16e-3, fillet_elements, fillets: true };
    crank_mesh(&engine, 0, options).unwrap()
}

/// Largest von Mises stress of each fillet in pure bending about y and in torsion, over the nominal one at 50 mm: of its bending stress,
/// and of the von Mises stress of its shear.
fn factors(crank: &CrankMesh) -> [Vec<f64>; 2] {
    let mesh = &crank.mesh;
    let [front, rear] = ["FREE_END", "FLYWHEEL"].map(|set| mesh.set(set).unwrap().nodes.clone());
    let base = StaticCase::default().clamp(&rear);
    let places: Vec<[f64; 2]> =
        front.iter().map(|node| mesh.nodes[*node as usize]).map(|[x, y, _]| [x, y]).collect();
    let mean = |k: usize| places.iter().map(|place| place[k]).sum::<f64>() / places.len() as f64;
    let middle = [mean(0), mean(1)];
    let apart: Vec<[f64; 2]> = places.iter().map(|[x, y]| [x - middle[0], y - middle[1]]).collect();
    let second: f64 = apart.iter().map(|[x, _]| x * x).sum();
    let polar: f64 = apart.iter().map(|[x, y]| x * x + y * y).sum();
    let (mut bending, mut torsion) = (base.clone(), base.clone());
    // A moment and a torque of 1 kN m without any force: what differs from the shaft's own stress dies out within a diameter.
    for (node, [x, y]) in front.iter().zip(apart) {
        bending = bending.push(&[(*node, 1.0)], [0.0, 0.0, 1e3 * x / second]);
        torsion = torsion.push(&[(*node, 1.0)], [-1e3 * y / polar, 1e3 * x / polar, 0.0]);
    }
    let mut system = StaticSystem::new(mesh, &base, SolveOptions::default()).unwrap();
    let solved = system.solve(&[&bending, &torsion]).unwrap();
    let nominal = [32.0, 16.0 * 3.0f64.sqrt()].map(|k| k * 1e3 / (PI * SHAFT.powi(3)));
    std::array::from_fn(|case| {
        let stresses = node_stresses(mesh, &solved[case].displacements);
        let of = |node: &u32| stresses[*node as usize].stress.von_mises();
        let largest = |nodes: &Vec<u32>| nodes.iter().map(of).fold(0.0, f64::max);
        let round = crank.corners.iter().filter(|corner| corner.radius > 0.0);
        round.map(|corner| largest(&corner.nodes) / nominal[case]).collect()
    })
}

/// Von Mises factors in bending and torsion of the first shaft there, which has these sizes.
fn reference() -> [f64; 2] {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/external/stepped-shaft/shaft.json");
    let stored: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let own = &stored["shafts"][0];
    let sizes = ["d_mm", "D_mm", "R_mm"].map(|key| own[key].as_f64().unwrap());
    assert_eq!(sizes, [50.0, 60.0, 3.0]);
    ["bending", "torsion"].map(|load| own[load]["von_mises"].as_f64().unwrap())
}

/// Stress tends to the reference from below. With 6 elements it is 1.0 % low in bending and 0.4 % high in torsion, which is too much for a
/// test.
#[test]
fn fillets_of_a_stepped_shaft_tend_to_those_of_an_axisymmetric_computation() {
    let wanted = reference();
    // Elements, by how much bending and torsion are low.
    for (elements, low) in [(2, [0.225, 0.083]), (4, [0.039, 0.0015])] {
        let crank = shaft(elements);
        for ((found, wanted), low) in factors(&crank).iter().zip(wanted).zip(low) {
            assert_eq!(found.len(), 2, "both journals have a fillet");
            for factor in found {
                let off = 1.0 - factor / wanted;
                assert!((off - low).abs() < 0.005, "{elements} elements: {factor} of {wanted}, {off} low");
            }
        }
    }
}
