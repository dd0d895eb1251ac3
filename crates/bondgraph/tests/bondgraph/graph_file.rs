//! A description written as a graph file and read again is the same graph.

use lanchester_bondgraph::{Curve, Description, Graph, Notation, Unit, equations, graph_file, used_graphs};

fn shown(graph: &Graph) -> String {
    let found = equations(graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    serde_json::to_string(&found.shown(Notation::Text)).expect("plain data")
}

#[test]
fn a_written_graph_is_read_again() {
    let units = [Unit::NONE, Unit::JOULE];
    let curve = Curve::straight(&[[0.0, 1.0], [1.0, 3.5], [2.0, 1.0]], true, units).expect("rising points");
    let description = Description::new("a \"driven\" wheel")
        .parameter("J", "0.2 kg m2")
        .table("torque curve", curve)
        .element("motor", "MSe", &[("effort", "table(\"torque curve\", theta)")])
        .element("shaft", "1", &[("domain", "rotation")])
        .element("wheel", "I", &[("inertia", "J"), ("flow", "3 rad/s")])
        .element("gears", "TF", &[("matrix", "2 ; 0.5 | 1 ; -1")])
        .element("other", "I", &[("inertia", "0.1 kg m2"), ("domain", "rotation")])
        .element("a", "I", &[("inertia", "0.3 kg m2"), ("domain", "rotation")])
        .element("b", "I", &[("inertia", "0.4 kg m2"), ("domain", "rotation")])
        .element("second", "1", &[("domain", "rotation")])
        .signal("theta", &[("integral_of", "shaft.flow"), ("start", "0.25 rad")])
        .bonds(&["motor > shaft", "shaft > wheel", "shaft > gears.1", "second > gears.2", "second > other"])
        .bonds(&["gears.3 > a", "gears.4 > b"]);
    let graph = Graph::new(&description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let text = graph_file(&description);
    let again = Graph::read(&text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}\n{text}"));
    assert_eq!(shown(&graph), shown(&again));
    let run = |graph: &Graph| {
        let found = equations(graph).expect("no conflict");
        let mut request = found.request();
        request.tolerance = 1e-11;
        found.simulate(&request)
    };
    assert_eq!(run(&graph), run(&again));
}

/// A torque in straight lines over the angle: the energy at the end is the area under them, although every corner is a kink.
#[test]
fn a_table_is_integrated_from_kink_to_kink() {
    let text = "[tables.torque]\npoints = [[0, 0], [1, 2], [3, 0]]\nperiodic = true\nx_unit = \"rad\"\ny_unit = \"N m\"\n\
                [elements]\nmotor = { kind = \"MSe\", effort = \"table(torque, theta)\" }\n\
                     shaft = { kind = \"1\", domain = \"rotation\" }\n\
                wheel = { kind = \"I\", inertia = \"0.5 kg m2\", flow = \"1 rad/s\" }\n\
                [signals]\ntheta = { integral_of = \"shaft.flow\", start = \"0 rad\" }\n[bonds]\n\
                     list = [\"motor > shaft\", \"shaft > wheel\"]\n";
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).expect("no conflict");
    let mut request = found.request();
    (request.duration, request.tolerance) = (3.0, 1e-12);
    let run = found.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    let (theta, speed) = (run.values("theta").expect("a state"), run.values("shaft.flow").expect("a flow"));
    assert!(*theta.last().expect("samples") > 9.0, "it turns through many kinks");
    for (theta, speed) in theta.iter().zip(speed) {
        let (turns, own) = ((theta / 3.0).floor(), theta.rem_euclid(3.0));
        let area = if own < 1.0 { own * own } else { 3.0 - (3.0 - own).powi(2) / 2.0 };
        let energy = 0.25 + 3.0 * turns + area;
        assert!((0.25 * speed * speed - energy).abs() < 1e-10 * energy, "{theta}: {speed}");
    }
    assert!(run.statistics.evaluations < 4000, "{:?}", run.statistics);
}

#[test]
fn bad_tables_are_refused() {
    for (part, code) in [
        ("points = [[0, 0]]", "E1709"),
        ("points = [[1, 0], [0, 1]]", "E1709"),
        ("points = [[0, 0, 0], [1, 1, 1]]", "E1702"),
        ("points = [[0, 0], [1, 1]]\nx_unit = \"mm\"", "E1702"),
        ("pieces = [[0, 1, 2, 3, 4]]", "E1709"),
        ("points = [[0, 0], [1, inf]]", "E1709"),
        ("heights = 3", "E1702"),
    ] {
        let text = format!("[tables.a]\n{part}\n[elements]\n");
        let mistakes = Graph::read(&text).expect_err(part);
        assert!(mistakes.iter().any(|m| m.code == code && m.hint.is_some()), "{part}: {mistakes:?}");
    }
}

/// The same torque from a file of two columns, looked up by its name.
#[test]
fn a_table_may_stand_in_a_file() {
    let text = "[tables.torque]\nfile = \"torque.csv\"\nperiodic = true\nx_unit = \"rad\"\ny_unit = \"N m\"\n\
                [elements]\nmotor = { kind = \"MSe\", effort = \"table(torque, theta)\" }\n\
                shaft = { kind = \"1\", domain = \"rotation\" }\nwheel = { kind = \"I\", inertia = \"0.5 kg m2\", flow = \"1 rad/s\" }\n\
                [signals]\ntheta = { integral_of = \"shaft.flow\", start = \"0 rad\" }\n[bonds]\n\
                list = [\"motor > shaft\", \"shaft > wheel\"]\n";
    assert_eq!(used_graphs(text), ["torque.csv"]);
    let read = |csv: &str| {
        let csv = csv.to_owned();
        Graph::read_with(text, &move |name| (name == "torque.csv").then(|| csv.clone()))
    };
    let graph =
        read("angle;torque\n# degrees of no sense\n0;0\n1;2\n3;0\n").unwrap_or_else(|e| panic!("{e:#?}"));
    let inline = text.replace("file = \"torque.csv\"", "points = [[0, 0], [1, 2], [3, 0]]");
    let inline = Graph::read(&inline).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    assert_eq!(shown(&graph), shown(&inline));
    for (csv, words) in [
        ("0,0\n1,x\n", "no table of two columns"),
        ("0,0,1\n", "two columns"),
        ("1,0\n0,1\n", "is no function"),
    ] {
        let mistakes = read(csv).expect_err(csv);
        assert!(
            mistakes.iter().any(|m| m.message.contains(words) && m.hint.is_some()),
            "{csv}: {mistakes:?}"
        );
    }
    let mistakes = Graph::read(text).expect_err("nothing is at hand");
    assert!(mistakes.iter().any(|m| m.message.contains("there is no file `torque.csv`")), "{mistakes:?}");
}

const SPRING: &str = "[parameters]\nk = \"100 N/m\"\nm = \"2 kg\"\n[elements]\nmove = { kind = \"1\", domain = \"translation\" }\n\
                      mass = { kind = \"I\", inertia = \"m\" }\n\
                           spring = { kind = \"C\", stiffness = \"k*(1 + 0*spring_at/(1 m))\", displacement = \"0.1 m\" }\n\
                      [signals]\nspring_at = { integral_of = \"move.flow\", start = \"0 m\" }\n[bonds]\n\
                           list = [\"move > mass\", \"move > spring\"]\n";

/// Two of the same graph, one with another stiffness, joined by a damper: the names of each have its prefix.
#[test]
fn a_graph_is_used_twice() {
    let text = "[[use]]\ngraph = \"spring.toml\"\nas = \"a\"\n[[use]]\ngraph = \"spring.toml\"\nas = \"b\"\nparameters = { k = \"k_b\" }\n\
                [parameters]\nk_b = \"400 N/m\"\n[elements]\nbetween = { kind = \"0\", domain = \"translation\" }\n\
                damper = { kind = \"R\", resistance = \"3 N s/m\" }\n[bonds]\n\
                     list = [\"a_move > between\", \"between > b_move\", \"between > damper\"]\n";
    assert_eq!(used_graphs(text), ["spring.toml", "spring.toml"]);
    let graph = Graph::read_with(text, &|name| (name == "spring.toml").then(|| SPRING.to_owned()))
        .unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).expect("no conflict");
    let rates: Vec<String> =
        found.shown(Notation::Text).rates.iter().map(|r| format!("{} = {}", r.left, r.right)).collect();
    assert!(
        rates[0].contains("a_k*a_spring.displacement") && rates[1].contains("a_mass.momentum/a_m"),
        "{rates:?}"
    );
    assert!(rates[2].contains("b_k*b_spring.displacement"), "{rates:?}");
    let mistakes = Graph::read(text).expect_err("nothing is at hand");
    assert!(
        mistakes.iter().any(|m| m.code == "E1702" && m.message.contains("no graph `spring.toml`")),
        "{mistakes:?}"
    );
    let endless = "[[use]]\ngraph = \"x\"\nas = \"a\"\n[elements]\n";
    let mistakes = Graph::read_with(endless, &|_| Some(endless.to_owned())).expect_err("it uses itself");
    assert!(mistakes.iter().any(|m| m.code == "E1715"), "{mistakes:?}");
    let wrong = text.replace("k = \"k_b\"", "c = \"k_b\"");
    let mistakes = Graph::read_with(&wrong, &|_| Some(SPRING.to_owned())).expect_err("no such parameter");
    assert!(
        mistakes.iter().any(|m| m.code == "E1706" && m.message.contains("no parameter `c`")),
        "{mistakes:?}"
    );
    let broken = SPRING.replace("\"100 N/m\"", "\"100 N/m");
    let mistakes = Graph::read_with(text, &|_| Some(broken.clone())).expect_err("it cannot be read");
    assert!(mistakes.iter().any(|m| m.message.starts_with("in `spring.toml`: ")), "{mistakes:?}");
}

/// A value that names an integral which names the value: in any order, where the start gives the unit.
#[test]
fn signals_may_name_integrals_in_any_order() {
    let lines = [
        "x = { integral_of = \"push - back\", start = \"2 m\" }",
        "push = \"-x/(1 s)\"",
        "back = \"0.5*push + 0*x/(1 s)\"",
    ];
    for order in [[0, 1, 2], [1, 0, 2], [2, 1, 0], [1, 2, 0]] {
        let signals = order.map(|index| lines[index]).join("\n");
        let text = format!(
            "name = \"x\"\n[elements]\nv = {{ kind = \"1\", domain = \"translation\" }}\nm = {{ kind = \"I\", inertia = \"1 kg\" }}\n\
             s = {{ kind = \"Se\", effort = \"0 N\" }}\n[signals]\n{signals}\n[bonds]\nlist = [\"s > v\", \"v > m\"]\n"
        );
        let graph = Graph::read(&text).unwrap_or_else(|e| panic!("{order:?}: {e:#?}"));
        let found = equations(&graph).unwrap_or_else(|e| panic!("{e:#?}"));
        let run = found.simulate(&found.request());
        let x = run.values("x").expect("its place");
        let want = 2.0 * (-0.5 * run.time[x.len() - 1]).exp();
        assert!((x[x.len() - 1] - want).abs() < 1e-8, "{order:?}");
    }
    let text = "name = \"x\"\n[elements]\nv = { kind = \"1\", domain = \"translation\" }\nm = { kind = \"I\", inertia = \"1 kg\" }\n\
                s = { kind = \"Se\", effort = \"0 N\" }\n[signals]\npush = \"x/(1 s)\"\nx = { integral_of = \"push*(1 s)\", start = \"2 m\" }\n\
                [bonds]\nlist = [\"s > v\", \"v > m\"]\n";
    let mistakes = Graph::read(text).expect_err("the integral is in m s");
    assert!(mistakes.iter().any(|mistake| mistake.code == "E1705"), "{mistakes:#?}");
}
