//! The chapter of the report on the engine as a bond graph.

use lanchester::bondgraph::{ElementEnergy, EngineBlock, Graph, Kind, Placed, equations};
use lanchester::file::read;
use lanchester::report::{bond_graph_figures, bond_graph_section};
use lanchester::{BondGraphRequest, bond_graph_report, engine_bond_graph};

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
    assert_eq!(figures, ["bond-graph-drawing", "bond-graph-curves", "bond-graph-energy"]);
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
    // Also of pistons, rods, shafts and unbalances, which follow block and crank.
    let is_open = |own: &&ElementEnergy| matches!(own.kind, Kind::I | Kind::C) && own.error.is_none();
    let open: Vec<&str> = audit.elements.iter().filter(is_open).map(|own| own.element.as_str()).collect();
    assert!(open.is_empty(), "{open:?}");
    for needed in ["crankshaft.momentum", "piston1_x", "d(theta)/dt = ", "stores hold what they took in"] {
        assert!(text.contains(needed), "{needed} is missing in\n{text}");
    }
    for table in ["states", "followers", "laws", "junctions", "signals", "unknowns", "equations", "energy"] {
        assert!(csv.contains(&format!("# bond-graph-{table}\n")), "{table}");
    }
    let crossed = crossed(&found.drawing);
    assert!(crossed.is_empty(), "{crossed:?}");
    let mut words = found.drawing.elements.iter().flat_map(|own| &own.labels);
    assert!(words.any(|own| own.is_value && own.text == "1.5 kg"));
    assert!(html.contains("causal stroke") && html.len() < 2_000_000, "{} bytes", html.len());
    assert!(serde_json::to_string(&found).is_ok());
    let ids: Vec<String> = bond_graph_figures(&found.run).into_iter().map(|figure| figure.id).collect();
    // The two unbalances of the shaft cancel: their sum is a line on the scale of both, no rounding under a lens.
    let shafts = bond_graph_figures(&found.run).pop().expect("the last").svg();
    assert!(shafts.contains("shaft 1, unbalance 2") && shafts.contains("together"), "{shafts}");
    assert!(!shafts.contains("µN") && shafts.contains("[N]"), "{shafts}");
    let parts = ["pressures", "speed", "block", "second-order", "shafts"];
    assert_eq!(ids, parts.map(|part| format!("bond-graph-{part}")));
}

/// Bonds that run through the letters of an element which they do not join.
fn crossed(drawing: &Placed) -> Vec<String> {
    let mut found = Vec::new();
    for bond in &drawing.bonds {
        let own: Vec<&str> = bond.name.split(" > ").filter_map(|end| end.split('.').next()).collect();
        for element in drawing.elements.iter().filter(|element| !own.contains(&element.name.as_str())) {
            let half = [4.0 + 5.0 * element.kind.len() as f64, 9.0];
            let passes = (0..=100).any(|k| {
                let at =
                    |i: usize| bond.line[0][i] + f64::from(k) / 100.0 * (bond.line[1][i] - bond.line[0][i]);
                (0..2).all(|i| (at(i) - element.at[i]).abs() < half[i])
            });
            if passes {
                found.push(format!("{} runs through {}", bond.name, element.name));
            }
        }
    }
    found
}

/// With the gas as states its loops are drawn too; a graph that is no engine shows states and powers.
#[test]
fn a_run_has_its_figures() {
    let text = include_str!("../../../../examples/three-cylinder.toml");
    let file = read(text).file.expect("the example has no mistakes");
    let request = BondGraphRequest {
        simulation: *file.tasks.simulation.expect("it says how it runs"),
        block: Some(EngineBlock::Fixed),
        ..BondGraphRequest::default()
    };
    let graph = engine_bond_graph(&file.engine, &[], &request).expect("it has what it needs");
    assert!(graph.notes.iter().all(|note| !note.contains("Left out")), "{:?}", graph.notes);
    let found = equations(&Graph::new(&graph.description).expect("units fit")).expect("no conflict");
    let figures = bond_graph_figures(&found.simulate(&found.request()));
    let ids: Vec<&str> = figures.iter().map(|figure| figure.id.as_str()).collect();
    assert_eq!(
        ids,
        ["bond-graph-pressures", "bond-graph-loops", "bond-graph-speed", "bond-graph-second-order"]
    );
    assert_eq!(figures[1].panels.len(), 3, "a loop for each cylinder");
    assert!(figures.iter().all(|figure| !figure.svg().contains("NaN")));
    let motor = Graph::read(include_str!("../../../../examples/bond-graphs/dc-motor.toml")).expect("shipped");
    let found = equations(&motor).expect("no conflict");
    let figures = bond_graph_figures(&found.simulate(&found.request()));
    assert_eq!(figures.len(), 1);
    // Flux linkage, angular momentum, power.
    assert_eq!(figures[0].panels.len(), 3);
}
