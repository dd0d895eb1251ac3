//! Counterweights that reach over journals and pins, inserts, holes, chamfers; crankshafts that cannot be meshed, and why.

use crate::crank::one_throw;
use crate::crank_kinds::{check_closed, differences};
use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_model::Engine;

const SIZES: CrankMeshOptions = CrankMeshOptions { size: 12e-3, fillet_elements: 2, fillets: true };
const FILLETS: &str = "pin_fillet = \"3 mm\"\njournal_fillet = \"3 mm\"\n";

/// A counterweight on web 1, opposite to the pin: its inner edge this far from the axis, so thick, with what else it has. The web is 20 mm thick.
fn weight(inner: &str, thickness: &str, more: &str) -> String {
    format!(
        r#"[[counterweight]]
web = 1
[counterweight.shape]
thickness = "{thickness}"
outline = [{{ x = "{inner}", y = "-36 mm" }}, {{ x = "72 mm", y = "-30 mm", bulge = 0.2 }}, {{ x = "72 mm", y = "30 mm" }}, {{ x = "{inner}", y = "36 mm" }}]
{more}
"#
    )
}

fn engine(weights: &str) -> Engine {
    one_throw(&format!("{FILLETS}{weights}"))
}

/// The mesh with fillets, which conforms, and without, which has the mass of the exact body.
fn meshed(name: &str, engine: &Engine) -> CrankMesh {
    meshed_to(name, engine, 1e-5)
}

/// The same, to this share.
fn meshed_to(name: &str, engine: &Engine, most: f64) -> CrankMesh {
    let mesh = |fillets: bool| crank_mesh(engine, 0, CrankMeshOptions { fillets, ..SIZES });
    let sharp = mesh(false).unwrap_or_else(|error| panic!("{name}: {error}"));
    check_closed(name, &sharp);
    let off = differences(engine, &sharp);
    assert!(off.iter().all(|off| *off < most), "{name}: {off:?}");
    let crank = mesh(true).unwrap_or_else(|error| panic!("{name}: {error}"));
    check_closed(name, &crank);
    println!("{name}: {off:?} {:?} {:?}", crank.quality, crank.left_out);
    crank
}

fn refused(name: &str, engine: &Engine, wanted: &[&str]) {
    let error = crank_mesh(engine, 0, SIZES).expect_err(name);
    let words = error.to_string();
    assert!(matches!(error, FlexError::Mesh { .. }), "{name}: {words}");
    for wanted in wanted.iter().chain(&["hint:"]) {
        assert!(words.contains(wanted), "{name}: {wanted} in {words}");
    }
}

#[test]
fn counterweight_over_journal_and_pin_is_meshed() {
    let thin = meshed("no thicker than the web", &engine(&weight("33 mm", "20 mm", "")));
    let thick = meshed("5 mm over the journal and 5 mm over the pin", &engine(&weight("33 mm", "30 mm", "")));
    let thinner = meshed("thinner than the web", &engine(&weight("33 mm", "12 mm", "")));
    assert!(thinner.quality.mass < thin.quality.mass && thin.quality.mass < thick.quality.mass);
    // The fillets are where they were.
    for (one, two) in thin.corners.iter().zip(&thick.corners) {
        assert!(one.name == two.name && one.radius == two.radius && !two.nodes.is_empty());
    }
}

#[test]
fn inserts_and_holes_are_regions_of_their_own() {
    let slugs = "inserts = [{ x = \"56 mm\", y = \"0 mm\", radius = \"7 mm\", density = \"18000 kg/m3\" }, \
                 { x = \"58 mm\", y = \"20 mm\", radius = \"5 mm\" }, \
                 { x = \"58 mm\", y = \"-20 mm\", radius = \"5 mm\", density = \"11000 kg/m3\", face = \"front\", depth = \"8 mm\" }, \
                 { x = \"58 mm\", y = \"-20 mm\", radius = \"5 mm\", density = \"11000 kg/m3\", face = \"rear\", depth = \"8 mm\" }]";
    for thickness in ["20 mm", "28 mm"] {
        let crank = meshed(thickness, &engine(&weight("33 mm", thickness, slugs)));
        let densities: Vec<f64> = crank.mesh.materials.iter().map(|material| material.density).collect();
        assert_eq!(densities, [7850.0, 18000.0, 11000.0]);
        assert!(crank.left_out.iter().any(|words| words.contains("elastic constants of inserts")));
    }
}

#[test]
fn chamfers_are_left_out_and_told() {
    let chamfer = "chamfers = [{ face = \"front\", angle = \"45 deg\", radius = \"72 mm\" }]";
    let engine = engine(&weight("33 mm", "20 mm", chamfer));
    let crank = crank_mesh(&engine, 0, SIZES).unwrap();
    check_closed("chamfer", &crank);
    let words = crank.left_out.join("; ");
    assert!(words.contains("chamfers of") && words.contains("kg less"), "{words}");
    let exact = lanchester_geometry::crankshaft::crankshaft(&engine, 0).unwrap().mass.mass;
    assert!(crank.body_mass > exact, "{} {exact}", crank.body_mass);
}

#[test]
fn what_is_not_meshed_is_named_with_its_cause() {
    refused(
        "a thick counterweight too near to the journal's fillet",
        &engine(&weight("25 mm", "30 mm", "")),
        &["beyond the web's face", "no thicker than its web"],
    );
    refused(
        "a counterweight of another metal",
        &engine(&weight("33 mm", "20 mm", "density = \"11000 kg/m3\"")),
        &["11000 kg/m3", "inserts"],
    );
    refused(
        "an insert at the edge",
        &engine(&weight(
            "33 mm",
            "20 mm",
            "inserts = [{ x = \"65.9 mm\", y = \"0 mm\", radius = \"12 mm\", density = \"18000 kg/m3\" }]",
        )),
        &["insert or hole of 24.00 mm"],
    );
}

/// Nose and flange are meshed, thinner and thicker than the journals, with the mass of the exact body and its centre; a bore is filled, and told.
#[test]
fn nose_and_flange_are_meshed() {
    let ends = |nose: &str, flange: &str| {
        engine(&format!(
            "[[crank.body.nose]]\nlength = \"30 mm\"\ndiameter = \"{nose}\"\n[[crank.body.flange]]\nlength = \"12 mm\"\ndiameter = \"{flange}\"\n"
        ))
    };
    let bare = meshed("no ends", &engine(""));
    for (nose, flange) in [("36 mm", "96 mm"), ("34 mm", "40 mm"), ("80 mm", "70 mm"), ("55 mm", "55 mm")] {
        let name = format!("{nose} and {flange}");
        // Parabolas over some 20 degrees of a nose enclose less than its arcs.
        let crank = meshed_to(&name, &ends(nose, flange), 3e-5);
        assert!(crank.left_out.is_empty(), "{name}: {:?}", crank.left_out);
        let z = |set: &str| crank.mesh.nodes[crank.mesh.set(set).unwrap().nodes[0] as usize][2];
        let length = z("FLYWHEEL") - z("FREE_END");
        assert!((length - (0.048 + 0.02 + 0.05 + 0.042)).abs() < 1e-9, "{name}: {length}");
        // No line of theirs runs through pins and webs.
        let webs = |crank: &CrankMesh| crank.webs.iter().map(|web| web.nodes.len()).sum::<usize>();
        assert_eq!(webs(&crank), webs(&bare), "{name}");
        assert_eq!(crank.corners.len(), bare.corners.len(), "{name}");
    }
    // 52 mm is nearer to the journal's 55 mm than an element is wide: the flange alone is meshed.
    let crank = crank_mesh(&ends("52 mm", "96 mm"), 0, SIZES).unwrap();
    assert_eq!(crank.left_out, ["nose 1 (no room for its elements)"]);
    let fillets: f64 = crank.corners.iter().map(|corner| corner.volume()).sum();
    assert!((crank.quality.mass / (crank.body_mass + 7850.0 * fillets) - 1.0).abs() < 1e-5);
    let bored = engine("[[crank.body.flange]]\nlength = \"12 mm\"\ndiameter = \"96 mm\"\nbore = \"22 mm\"\n");
    let crank = crank_mesh(&bored, 0, SIZES).unwrap();
    assert_eq!(crank.left_out, ["bore of flange 1"]);
    assert!((crank.quality.mass / (crank.body_mass + 7850.0 * fillets) - 1.0).abs() < 1e-5);
}
