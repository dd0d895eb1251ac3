//! Causality of textbook graphs: states, followers, loops, and every kind of conflict.

use lanchester_bondgraph::{Causality, Description, Graph, Method, Preference, causality, equations};

/// A graph of elements `name: kind` and bonds; every element gets a plain law of its kind.
pub(crate) fn graph(elements: &str, bonds: &str) -> Graph {
    let mut description = Description::new("test");
    for element in elements.split(',').map(str::trim) {
        let (name, kind) = element.split_once(':').expect("name: kind");
        let keys: &[(&str, &str)] = match kind.trim() {
            "Se" => &[("effort", "1 N")],
            "Sf" => &[("flow", "1 m/s")],
            "R" => &[("resistance", "2 N s/m")],
            "Re" => &[("effort", "2 N*tanh(f/(1 m/s))")],
            "Rf" => &[("flow", "2 m/s*tanh(e/(1 N))")],
            "C" => &[("stiffness", "3 N/m")],
            "Cq" => &[("law", "3 N/m*q + 1 N/m^3*q^3")],
            "I" => &[("inertia", "4 kg")],
            "Ip" => &[("law", "p/(4 kg)")],
            "TF" => &[("ratio", "5")],
            "GY" => &[("ratio", "6 N s/m")],
            "TFm" => &[("matrix", "2 | 3")],
            "If" => &[("coenergy", "2 kg*f1^2")],
            "Rr" => &[("flow", "1 m/s*tanh((e1 - e2)/(1 N)) ; 1 m/s*tanh((e2 - e1)/(1 N))")],
            _ => &[("domain", "translation")],
        };
        let kind = match kind.trim() {
            "Re" | "Rf" => "R",
            "Cq" => "C",
            "Ip" | "If" => "I",
            "TFm" => "TF",
            "Rr" => "R",
            kind => kind,
        };
        description = description.element(name.trim(), kind, keys);
    }
    let bonds: Vec<&str> = bonds.split(',').map(str::trim).collect();
    let mut description = description.bonds(&bonds);
    for entry in &mut description.elements {
        if entry.get("domain").is_none() && !["TF", "GY"].contains(&entry.keys[0].1.text.as_str()) {
            entry.keys.push(("domain".into(), "translation".into()));
        }
    }
    Graph::new(&description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

fn assigned(elements: &str, bonds: &str) -> Causality {
    causality(&graph(elements, bonds), Preference::Integral).unwrap_or_else(|m| panic!("{m:#?}"))
}

#[test]
fn followers_name_their_path() {
    let found = assigned("s: Se, j: 1, m: I, t: TF, g: 1, n: I", "s > j, j > m, j > t.1, t.2 > g, g > n");
    assert_eq!(found.followers[0].path, ["m", "j", "t", "g", "n"]);
    let found = assigned("s: Sf, j: 1, m: I", "s > j, j > m");
    assert_eq!(found.followers[0].path, ["s", "j", "m"]);
}

#[test]
fn every_kind_of_conflict_is_an_error_with_its_elements_and_a_hint() {
    let cases = [
        ("s: Sf, z: Sf, j: 1, m: I", "s > j, z > j, j > m", "s and z both set the flow of `j`"),
        ("s: Se, z: Se, j: 0, k: C", "s > j, z > j, j > k", "s and z both set the effort of `j`"),
        ("s: Se, z: Se, j: 1", "s > j, z > j", "nothing sets the flow of `j`"),
        ("s: Sf, z: Sf, j: 0", "s > j, z > j", "nothing sets the effort of `j`"),
        ("s: Sf, t: TF, z: Sf", "s > t.1, t.2 > z", "both set"),
        ("s: Se, y: GY, z: Sf", "s > y.1, y.2 > z", "both set"),
        ("s: Se, j: 0, e: Re", "s > j, j > e", "`e`"),
        ("s: Sf, j: 1, e: Rf", "s > j, j > e", "`e`"),
        ("s: Sf, j: 1, m: Ip", "s > j, j > m", "`m` has a law that cannot be turned round"),
        ("s: Se, j: 0, k: Cq", "s > j, j > k", "`k` has a law that cannot be turned round"),
        ("s: Sf, z: Sf", "s > z", "both set the flow"),
        ("s: Se, t: TF, z: Se", "s > t.1, t.2 > z", "both set"),
        ("s: Sf, y: GY, z: Se", "s > y.1, y.2 > z", "both set"),
        ("s: Se, z: Se", "s > z", "both set the effort"),
        ("s: Se, z: Sf, j: 1, o: 0, y: Sf", "s > j, z > j, j > o, y > o", "nothing sets the effort of `o`"),
        // A transformer by a matrix gives flows: a source of flow behind it is one too many.
        (
            "s: Se, a: 1, m: I, t: TFm, b: 1, n: I, z: Sf, c: 1, d: R",
            "s > a, a > m, a > t.1, t.2 > b, b > n, z > b, t.3 > c, c > d",
            "`t` multiplies flows by its matrix, efforts by the transposed, so it needs the effort",
        ),
        // A resistor of two ports that gives flows by efforts needs an effort at each.
        ("s: Sf, q: Rr, o: 0, k: C", "s > q.1, o > q.2, o > k", "`q` gives its flows by its efforts"),
        ("s: Se, j: 0, m: If", "s > j, j > m", "`m` gives its momenta by its flows alone"),
    ];
    for (elements, bonds, words) in cases {
        let mistakes = causality(&graph(elements, bonds), Preference::Integral).expect_err(elements);
        let all: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
        assert!(all.iter().any(|message| message.contains(words)), "{elements}: {all:?}");
        for mistake in &mistakes {
            assert_eq!(mistake.code, "E1713");
            assert!(mistake.hint.as_ref().is_some_and(|hint| hint.len() > 10), "{mistake:?}");
        }
    }
    let two = graph(
        "s: Sf, z: Sf, j: 1, m: I, p: Se, q: Se, o: 0, k: C",
        "s > j, z > j, j > m, p > o, q > o, o > k",
    );
    assert_eq!(causality(&two, Preference::Integral).expect_err("two conflicts").len(), 2, "both at once");
}

#[test]
fn the_dual_lets_stores_follow() {
    let graph = graph("s: Se, j: 1, m: I, d: R", "s > j, j > m, j > d");
    let dual = causality(&graph, Preference::Derivative).expect("no conflict");
    assert_eq!((dual.states.len(), dual.followers.len()), (0, 1));
}

#[test]
fn linear_loops_are_solved_by_symbols() {
    // Two resistors divide an effort: the flow through both is 1 N / (2 + 2) N s/m.
    let graph = graph("s: Se, j: 1, r: R, o: 0, q: R", "s > j, j > r, j > o, o > q");
    let run = equations(&graph).expect("solved").simulate(&equations(&graph).expect("solved").request());
    let flow = &run.series.iter().find(|series| series.name == "q.flow").expect("there").values;
    assert!(flow.iter().all(|flow| (flow - 0.25).abs() < 1e-15), "{:?}", &flow[..2]);
}

#[test]
fn nonlinear_loop_is_solved_at_each_evaluation() {
    // f = 2 tanh(e) and e = 1 - 2 f - k: two laws that need each other, beside a spring that fills.
    let graph = graph("s: Se, j: 1, r: Rf, d: R, k: C", "s > j, j > r, j > d, j > k");
    let found = equations(&graph).expect("index 1");
    let run = found.simulate(&found.request());
    assert!(run.complete, "{}", run.ended);
    let at = |name: &str| run.series.iter().find(|series| series.name == name).expect("there").values.clone();
    for ((e, f), k) in at("r.effort").iter().zip(at("r.flow")).zip(at("k.effort")) {
        assert!((f - 2.0 * e.tanh()).abs() < 1e-12, "{e} {f}");
        assert!((e + 2.0 * f + k - 1.0).abs() < 1e-12, "{e} {f} {k}");
    }
    assert!(at("k.effort").last().is_some_and(|k| *k > 0.3), "the spring fills");
    assert!(found.linear().is_err(), "and has no poles");
}

#[test]
fn stiff_graph_goes_on_implicitly_and_says_so() {
    // A kilogram in oil: the speed settles within a microsecond, the spring behind it within a second.
    let description = Description::new("stiff")
        .element("s", "Se", &[("effort", "10 N*sin(3 1/s*t)")])
        .element("j", "1", &[("domain", "translation")])
        .element("m", "I", &[("inertia", "1 kg"), ("flow", "1 m/s")])
        .element("d", "R", &[("resistance", "1e6 N s/m")])
        .element("k", "C", &[("stiffness", "1e6 N/m")])
        .bonds(&["s > j", "j > m", "j > d", "j > k"]);
    let found = equations(&Graph::new(&description).expect("good")).expect("no conflict");
    let mut request = found.request();
    request.duration = 2.0;
    let run = found.simulate(&request);
    assert!(run.complete && run.stiff_from.is_some_and(|t| t < 0.1), "{} {:?}", run.ended, run.stiff_from);
    assert_eq!(run.methods, [Method::Explicit, Method::Implicit]);
    assert!(run.statistics.evaluations < 50_000, "{:?}", run.statistics);
    // The displacement's slow part: k q + d q' = F within 1e-6 of it, forced at 3 rad/s, from the start's kick v m/d.
    let q = &run.series.iter().find(|series| series.name == "k.displacement").expect("there").values;
    let (w, f) = (3.0, 10.0 / 1e6);
    let amplitude = f / (1.0 + w * w);
    for (t, q) in run.time.iter().zip(q).skip(1) {
        let forced = amplitude * ((w * t).sin() - w * (w * t).cos());
        let exact = forced + (amplitude * w + 1e-6) * (-t).exp();
        assert!((q - exact).abs() < 2e-11, "at {t} s: {q:e} instead of {exact:e}");
    }
}

#[test]
fn singular_loop_is_an_error_that_names_it() {
    // The pump gives exactly what the tank takes: that holds for any flow.
    let description = Description::new("loop")
        .element("pump", "MSf", &[("flow", "tank.flow")])
        .element("node", "0", &[("domain", "hydraulic")])
        .element("tank", "C", &[("capacitance", "1e-6 m3/Pa")])
        .bonds(&["pump > node", "node > tank"]);
    let graph = Graph::new(&description).expect("well formed");
    let mistakes = equations(&graph).expect_err("singular");
    assert_eq!(mistakes.len(), 1, "{mistakes:?}");
    assert_eq!(mistakes[0].code, "E1714");
    assert!(mistakes[0].message.contains(".flow is singular"), "{mistakes:?}");
    // Half of what the tank takes is no such circle: only a flow of nothing meets it.
    let half = Description { elements: Vec::new(), ..description.clone() }.element(
        "pump",
        "MSf",
        &[("flow", "0.5*tank.flow")],
    );
    let half = Description {
        elements: half.elements.into_iter().chain(description.elements.into_iter().skip(1)).collect(),
        ..half
    };
    let found = equations(&Graph::new(&half).expect("well formed")).expect("regular");
    let run = found.simulate(&found.request());
    let flow = &run.series.iter().find(|series| series.name == "tank.flow").expect("there").values;
    assert!(run.complete && flow.iter().all(|flow| *flow == 0.0), "{}", run.ended);
}
