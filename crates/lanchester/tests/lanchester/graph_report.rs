//! The chapter of the report on the engine as a bond graph.

use lanchester::bond_graph_report;
use lanchester::file::read;
use lanchester::report::bond_graph_section;

#[test]
fn the_chapter_shows_drawing_causality_equations_energy_and_curves() {
    let text = include_str!("../../../../examples/three-cylinder.toml");
    let engine = read(text).engine().expect("the example has no mistakes");
    let found = bond_graph_report(&engine, &[], None, 209.0).expect("it has what it needs");
    assert!(found.run.complete, "{}", found.run.ended);
    let audit = found.run.audit.as_ref().expect("asked for");
    assert!(audit.whole < 1e-6, "{:e}", audit.whole);
    let section = bond_graph_section(&found);
    let figures: Vec<&str> = section.figures().map(|figure| figure.id.as_str()).collect();
    assert_eq!(figures, ["bond-graph", "bond-graph-curves", "bond-graph-energy"]);
    // Tiles that are alike are drawn once: one of three cylinders, one mount.
    let drawing = section.figures().next().expect("the drawing");
    let titles: Vec<&str> =
        drawing.panels.iter().filter_map(|panel| panel.description.split(':').next()).collect();
    assert!(titles.contains(&"Block and crank") && titles.contains(&"Cylinder 1"), "{titles:?}");
    assert!(!titles.contains(&"Cylinder 2") && !titles.contains(&"Mount 2"), "{titles:?}");
    let (csv, html) = (section.csv(), section.html());
    let text = section.text().replace('\n', " ");
    // The energy of the stores is compared with what they took in up to the very end of the run.
    let stores = audit.elements.iter().filter_map(|element| element.error).fold(0.0, f64::max);
    assert!(stores < 1e-6, "{stores:e}");
    for needed in ["crankshaft.momentum", "piston1_x", "d(theta)/dt = ", "stores hold what they took in"] {
        assert!(text.contains(needed), "{needed} is missing in\n{text}");
    }
    for table in ["states", "followers", "laws", "junctions", "signals", "equations", "energy"] {
        assert!(csv.contains(&format!("# bond-graph-{table}\n")), "{table}");
    }
    assert!(html.contains("causal stroke") && html.len() < 2_000_000, "{} bytes", html.len());
    assert!(serde_json::to_string(&found).is_ok());
}
