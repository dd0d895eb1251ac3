//! Meshes of crankshafts whose circles of journals, pins, bores and fillets nearly touch, seen along the crank.

use crate::crank::one_throw;
use crate::crank_kinds::check_closed;
use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_model::Engine;

/// Smallest scaled Jacobian that these meshes have.
const SOUND: f64 = 0.4;

/// The mesh with true fillets: sound, closed, its mass that of the body and its fillets.
fn meshed(name: &str, engine: &Engine, fillet_elements: usize) -> CrankMesh {
    let options = CrankMeshOptions { size: 16e-3, fillet_elements, fillets: true };
    let crank = crank_mesh(engine, 0, options).unwrap_or_else(|error| panic!("{name}: {error}"));
    check_closed(name, &crank);
    assert!(crank.quality.least_jacobian > SOUND, "{name}: {:?}", crank.quality);
    let fillets: f64 = crank.corners.iter().map(|corner| corner.volume()).sum();
    let fillets = crank.mesh.materials[0].density * fillets;
    let wanted = crank.body_mass + fillets;
    let off = (crank.quality.mass / wanted - 1.0).abs();
    // Parabolas over 90/n degrees enclose less than arcs: of the fillet (1 - pi/4) R^2 by 0.31 % with n = 2, and as n^-4.
    let parabolas = 0.0031 * (2.0 / fillet_elements as f64).powi(4) * fillets / wanted;
    assert!(off < 5e-6 + parabolas, "{name}: mass off by {off}, {parabolas} by its fillets");
    crank
}

/// A throw with another crank radius [mm] and bore of the pin [mm].
fn throw(radius: f64, bore: f64, fillets: [f64; 2]) -> Engine {
    let [pin, journal] = fillets;
    let mut parts = one_throw(&format!(
        "pin_fillet = \"{pin} mm\"\njournal_fillet = \"{journal} mm\"\npin_bore = \"{bore} mm\""
    ))
    .into_parts();
    for throw in &mut parts.throws {
        throw.radius = 1e-3 * radius;
    }
    Engine::new(parts).unwrap()
}

/// Pins of 48 mm and journals of 55 mm with fillets of 3 mm: crank radii at which a surface or the end of a fillet touches another from
/// outside (51.5, 54.5, 57.5 mm) or within (9.5 mm is that of a pin's fillet and the journal's), and a little off.
#[test]
fn prop_throws_of_any_crank_radius_are_meshed() {
    let touching = [51.5, 54.5, 57.5];
    let near = touching.iter().flat_map(|radius| [radius - 0.3, *radius, radius + 0.02, radius + 0.9]);
    for radius in near.chain([20.0, 27.5, 33.1, 44.0]) {
        meshed(&format!("crank radius {radius} mm"), &throw(radius, 0.0, [3.0, 3.0]), 2);
    }
    for (radius, elements) in [(27.5, 4), (51.6, 4), (54.4, 6), (48.63, 8)] {
        let name = format!("crank radius {radius} mm, {elements} elements");
        meshed(&name, &throw(radius, 0.0, [3.0, 3.0]), elements);
    }
}

/// A pin's bore of 28 mm comes within a millimetre of the journal's surface in projection, and lines of three circles meet.
#[test]
fn bores_and_unequal_fillets_are_meshed() {
    for (radius, bore, fillets) in [
        (41.0, 28.0, [2.0, 3.0]),
        (42.4, 28.0, [3.0, 2.9]),
        (50.68, 0.0, [4.0, 1.5]),
        (30.13, 20.0, [2.0, 3.0]),
    ] {
        let name = format!("crank radius {radius} mm, bore {bore} mm, fillets {fillets:?} mm");
        meshed(&name, &throw(radius, bore, fillets), 2);
    }
}

/// The layers of fillets on journals of 55 and 57 mm alternate: rings 0.25 mm apart with 8 elements across a fillet.
#[test]
fn journals_of_slightly_different_diameters_are_meshed() {
    let fillets = "pin_fillet = \"3 mm\"\njournal_fillet = \"3 mm\"";
    let own = "[[crank.body.journal]]\nnumbers = [2]\ndiameter";
    for (diameter, elements) in [("57 mm", 6), ("59 mm", 8), ("55.1 mm", 4)] {
        let engine = one_throw(&format!("{fillets}\n{own} = \"{diameter}\""));
        let crank = meshed(&format!("journals of 55 mm and {diameter}"), &engine, elements);
        assert_eq!(crank.corners.iter().filter(|corner| !corner.nodes.is_empty()).count(), 4);
    }
}

/// Layouts of the gallery with typical values that were refused, or had inverted elements.
#[test]
fn completed_engines_of_the_gallery_are_meshed() {
    for name in ["single", "radial-9", "v2-60-split", "v6-60", "in-line-4-crossplane"] {
        let template = lanchester_file::template(name).unwrap();
        let completed = lanchester_file::complete(template.text, &[], None).unwrap();
        let engine = lanchester_file::read(&completed.text).engine().unwrap();
        meshed(name, &engine, 2);
    }
}

#[test]
fn fillets_without_room_say_by_how_much() {
    let refused = |change: &str, wanted: &[&str]| {
        let engine = one_throw(change);
        let error = crank_mesh(&engine, 0, CrankMeshOptions::default()).unwrap_err();
        let words = error.to_string();
        assert!(matches!(error, FlexError::Mesh { .. }), "{words}");
        for wanted in wanted {
            assert!(words.contains(wanted), "{wanted} in {words}");
        }
    };
    refused(
        "pin_fillet = \"6 mm\"\njournal_fillet = \"3 mm\"\npin_bore = \"36 mm\"",
        &["pin 1", "fillet of 6.00 mm", "wall of 6.00 mm", "by 0.60 mm", "hint: a smaller fillet"],
    );
    refused(
        "pin_fillet = \"10 mm\"\njournal_fillet = \"9 mm\"",
        &["web 1", "10.00 mm", "9.00", "thickness of 20.00 mm, by 1.00 mm", "hint: smaller fillets"],
    );
}
