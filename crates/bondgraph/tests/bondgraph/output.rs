//! Drawings and exports say of the graph what it is.

use lanchester_bondgraph::{Equations, Graph, drawing, equations, graphml, modelica};

const SHIPPED: [&str; 7] = [
    include_str!("../../../../examples/bond-graphs/mass-spring-damper.toml"),
    include_str!("../../../../examples/bond-graphs/dc-motor.toml"),
    include_str!("../../../../examples/bond-graphs/two-tanks.toml"),
    include_str!("../../../../examples/bond-graphs/two-tanks-turbulent.toml"),
    include_str!("../../../../examples/bond-graphs/slider-crank.toml"),
    include_str!("../../../../examples/bond-graphs/slider-crank-elastic.toml"),
    include_str!("../../../../examples/bond-graphs/torsion-chain.toml"),
];

fn read(text: &str) -> (Graph, Equations) {
    let graph = Graph::read(text).expect("shipped graphs have no mistake");
    let found = equations(&graph).expect("nor a conflict");
    (graph, found)
}

#[test]
fn drawing_has_a_half_arrow_and_a_stroke_for_each_bond_and_every_name_once() {
    for text in SHIPPED {
        let (graph, found) = read(text);
        let svg = drawing(&graph, &found.causality);
        assert_eq!(svg.matches("stroke-width=\"2.6\"").count(), graph.bond_count(), "strokes");
        assert_eq!(svg.matches("stroke-width=\"1.4\"").count(), graph.bond_count(), "half arrows");
        for name in graph.element_names() {
            let plain = svg.matches(&format!(">{name}<")).count();
            let following = svg.matches(&format!(">{name} (follows)<")).count();
            assert_eq!(plain + following, 1, "{name}");
        }
        // No two letters of elements stand on one another.
        let mut places: Vec<(f64, f64)> = Vec::new();
        for part in svg.split("<text ").filter(|part| part.contains("font-size=\"18\"")) {
            let number = |key: &str| -> f64 {
                let from = part.find(key).expect("there") + key.len();
                part[from..].split('"').next().expect("closed").parse().expect("a number")
            };
            places.push((number("x=\""), number("y=\"")));
        }
        assert_eq!(places.len(), graph.element_names().count());
        for (i, a) in places.iter().enumerate() {
            for b in &places[i + 1..] {
                assert!((a.0 - b.0).hypot(a.1 - b.1) > 40.0, "{a:?} {b:?}");
            }
        }
    }
}

#[test]
fn modelica_has_as_many_equations_as_variables() {
    for text in SHIPPED {
        let (_, found) = read(text);
        let text = modelica(&found);
        let (head, body) = text.split_once("equation\n").expect("both parts");
        let variables = head.lines().filter(|line| line.trim_start().starts_with("Real ")).count();
        let laws = body.lines().filter(|line| line.contains(" = ") && line.ends_with(';')).count();
        assert_eq!(variables, laws, "{text}");
    }
}

#[test]
fn graphml_has_every_element_and_bond() {
    let (graph, found) = read(SHIPPED[4]);
    let text = graphml(&found);
    assert_eq!(text.matches("<node ").count(), graph.element_names().count());
    assert_eq!(text.matches("<edge ").count(), graph.bond_count());
    assert!(text.contains("source=\"motor\" target=\"shaft\""), "{text}");
}
