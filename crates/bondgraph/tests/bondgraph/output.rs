//! Drawings and exports say of the graph what it is.

use lanchester_bondgraph::{Equations, Graph, drawing, equations, graphml, modelica, placed};

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

/// All that is shipped: no bond runs through the letters of an element that it does not join, and no drawing is a narrow strip.
#[test]
fn bonds_keep_clear_of_letters() {
    let more = [
        include_str!("../../../../examples/bond-graphs/double-pendulum.toml"),
        include_str!("../../../../examples/bond-graphs/double-pendulum-stiff.toml"),
        include_str!("../../../../examples/bond-graphs/gear-train.toml"),
        include_str!("../../../../examples/bond-graphs/hydraulic-press.toml"),
        include_str!("../../../../examples/bond-graphs/prismatic-pair.toml"),
        include_str!("../../../../examples/bond-graphs/prismatic-pair-printed.toml"),
        include_str!("../../../../examples/bond-graphs/single-cylinder.toml"),
        include_str!("../../../../examples/bond-graphs/thermal-chain.toml"),
    ];
    for text in SHIPPED.into_iter().chain(more) {
        let (graph, found) = read(text);
        let drawn = placed(&graph, &found.causality);
        let ratio = drawn.size[1] / drawn.size[0];
        assert!((0.25..2.0).contains(&ratio), "{ratio} of {:?}", drawn.elements[0].name);
        for bond in &drawn.bonds {
            let ends: Vec<&str> = bond.name.split(" > ").collect();
            for element in &drawn.elements {
                let joins = ends.iter().any(|end| end.split('.').next() == Some(element.name.as_str()));
                let half = [4.0 + 5.0 * element.kind.len() as f64, 9.0];
                let passes = (1..100).any(|k| {
                    let along = f64::from(k) / 100.0;
                    (0..2).all(|i| {
                        let at = bond.line[0][i] + along * (bond.line[1][i] - bond.line[0][i]);
                        (at - element.at[i]).abs() < half[i]
                    })
                });
                assert!(joins || !passes, "{} runs through {}", bond.name, element.name);
            }
        }
    }
}

/// Values in SI with their units beside the names: numbers of constants, also of parameters, and short expressions.
#[test]
fn drawings_say_values() {
    for (index, values) in [
        (0, ["10 N", "1.2 kg", "3 N s/m", "250 N/m"].as_slice()),
        (1, &["24 V", "0.002 H", "0.5 Ohm", "0.08 Wb", "3e-4 kg m2", "2e-4 N m s/rad", "-0.3 N m"]),
        (2, &["4e-4 m3/s", "1.2e7 Pa s/m3", "5.097e-6 m3/Pa"]),
        (6, &["0.05 kg m2", "2e5 N m/rad", "2 N m s/rad"]),
    ] {
        let (graph, found) = read(SHIPPED[index]);
        let svg = drawing(&graph, &found.causality);
        for value in values {
            assert!(svg.contains(&format!(">{value}<")), "{value} in {svg}");
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
