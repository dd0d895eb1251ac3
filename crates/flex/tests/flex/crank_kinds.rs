//! Meshes of the crankshafts of all layouts: joined without gaps, with the mass, centre and inertia of the exact body.

use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::mesh::surface;
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::Engine;

/// A ready-made engine whose point weights and masses of pins and webs give way to a body.
fn with_body(template: &str, body: &str, changes: &[(&str, &str)]) -> Engine {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../file/templates");
    let text = std::fs::read_to_string(format!("{folder}/{template}.toml")).unwrap();
    let mut kept = String::new();
    let mut section = String::new();
    for line in text.lines() {
        if line.starts_with('[') {
            if section == "[crank]" {
                kept.push_str(&format!("[crank.body]\ndensity = \"7850 kg/m3\"\n{body}\n"));
            }
            section = line.trim().to_owned();
        }
        let by_mass = ["pin_mass", "web_mass", "web_radius"].iter().any(|key| line.starts_with(key));
        let changed = changes.iter().find(|(key, _)| line.starts_with(key));
        let line = changed.map_or(line.to_owned(), |(key, value)| format!("{key} = \"{value}\""));
        if section != "[counterweights]" && !(section == "[crank]" && by_mass) {
            kept.push_str(&line);
            kept.push('\n');
        }
    }
    let reading = lanchester_file::read(&kept);
    let diagnostics = format!("{:?}", reading.diagnostics);
    reading.engine().unwrap_or_else(|| panic!("{template}: {diagnostics}"))
}

const COARSE: CrankMeshOptions = CrankMeshOptions { size: 16e-3, fillet_elements: 2, fillets: false };

/// Every inner face is shared by two elements: what is left closes, and holds the volume of the elements.
pub fn check_closed(name: &str, crank: &CrankMesh) {
    let (faces, _) = surface(&crank.mesh);
    let areas = lanchester_flex::mesh::surface_areas(&crank.mesh, &faces);
    let all: f64 = areas.values().map(|a| a.iter().map(|x| x * x).sum::<f64>().sqrt()).sum();
    for axis in 0..3 {
        let sum: f64 = areas.values().map(|area| area[axis]).sum();
        assert!(sum.abs() < 1e-10 * all, "{name}: open along {axis} by {sum} of {all} m2");
    }
}

/// Mass, centre and inertia tensor of mesh and exact body, as shares of the mass, of the root of the polar inertia over the mass, and of
/// the trace of the tensor.
pub fn differences(engine: &Engine, crank: &CrankMesh) -> [f64; 3] {
    let (exact, mesh) = (crankshaft(engine, 0).unwrap().mass, &crank.quality);
    let tensor = exact.inertia_about_axis;
    let trace = tensor[0][0] + tensor[1][1] + tensor[2][2];
    let length = (tensor[2][2] / exact.mass).sqrt();
    let centre = (0..3).map(|k| (mesh.centre[k] - exact.centre[k]).abs() / length).fold(0.0, f64::max);
    // Products of inertia stand with their minus sign in the tensor, with plus sign in the mesh.
    let [xx, yy, zz, xy, yz, zx] = mesh.inertia;
    let own = [[xx, -xy, -zx], [-xy, yy, -yz], [-zx, -yz, zz]];
    let pairs = own.iter().flatten().zip(tensor.iter().flatten());
    let inertia = pairs.map(|(a, b)| (a - b).abs() / trace).fold(0.0, f64::max);
    [(mesh.mass / exact.mass - 1.0).abs(), centre, inertia]
}

const CAR: &str = r#"journal_diameter = "60 mm"
pin_diameter = "50 mm"
web_thickness = "16 mm"
web_radius = "44 mm"
pin_end_radius = "36 mm"
end_journals = ["24 mm", "26 mm"]
pin_fillet = "2 mm"
journal_fillet = "2 mm""#;

/// A crankshaft of a radial engine, with journals of this diameter.
fn radial(journal: &str) -> String {
    CAR.replace("16 mm", "22 mm")
        .replace("50 mm", "64 mm")
        .replace("60 mm", journal)
        .replace("44 mm", "58 mm")
        .replace("36 mm", "48 mm")
}

/// Template, body of its crankshaft, keys that change.
type Case<'a> = (&'a str, &'a str, &'a [(&'a str, &'a str)]);

#[test]
fn prop_meshes_of_all_layouts_have_the_mass_of_the_exact_body() {
    let large = radial("84 mm");
    let webs = format!(
        "{CAR}\n[[crank.body.web]]\nnumbers = [1]\nthickness = \"20 mm\"\nradius = \"48 mm\"\n\
         [[crank.body.pin]]\nnumbers = [2]\ndiameter = \"46 mm\"\nbore = \"12 mm\""
    );
    // Split pins and boxers: one web between the two pins of a pair, as far from the middle of each as the throws are apart.
    let thin = CAR.replace("16 mm", "10 mm");
    let one_web: &[(&str, &str)] = &[("bank_stagger", "40 mm"), ("web_distance", "40 mm")];
    // Journals of 76 mm and pins of 64 mm on a crank radius of 70 mm touch in projection.
    let touching = radial("76 mm");
    let cases: [Case; 14] = [
        ("single", CAR, &[]),
        ("in-line-4", &webs, &[]),
        ("in-line-5", CAR, &[]),
        ("in-line-6", CAR, &[]),
        ("v2-90", CAR, &[]),
        ("v2-60-split", &thin, &[("web_distance", "28 mm")]),
        ("v6-60", &thin, &[("web_distance", "36 mm")]),
        ("v8-crossplane", CAR, &[]),
        ("boxer-4", CAR, one_web),
        ("boxer-6", CAR, one_web),
        ("vr6-15", CAR, &[]),
        ("radial-7", &large, &[]),
        ("radial-7", &touching, &[]),
        ("radial-14", &large, &[]),
    ];
    let mut faults = Vec::new();
    for (name, body, changes) in cases {
        let engine = with_body(name, body, changes);
        match crank_mesh(&engine, 0, COARSE) {
            Ok(crank) => {
                check_closed(name, &crank);
                let off = differences(&engine, &crank);
                println!("{name}: {off:?} {:?}", crank.quality);
                if off.iter().any(|off| *off > 1e-5) {
                    faults.push(format!("{name}: {off:?}"));
                }
            }
            Err(error) => faults.push(format!("{name}: {error}")),
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn crankshaft_without_a_body_is_refused() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../file/templates");
    let text = std::fs::read_to_string(format!("{folder}/v6-60.toml")).unwrap();
    let engine = lanchester_file::read(&text).engine().unwrap();
    let error = crank_mesh(&engine, 0, COARSE).unwrap_err();
    assert!(matches!(error, FlexError::Crankshaft(_)), "{error}");
}
