//! Events that set states, and pads before stores that would follow: against exact motions.

use lanchester_bondgraph::{Graph, SimulationRequest, equations, graph_file};

const BALL: &str = r#"
name = "ball"
[parameters]
m = "0.2 kg"
g = "9.81 m/s2"
[elements]
ball = { kind = "1", domain = "translation" }
mass = { kind = "I", inertia = "m" }
weight = { kind = "Se", effort = "-m*g" }
[signals]
height = { integral_of = "ball.flow", start = "1 m" }
bounces = { integral_of = "0 Hz", start = "0" }
[[event]]
when = "-height"
set = { "mass.momentum" = "-0.8*mass.momentum", bounces = "bounces + 1" }
[bonds]
list = ["ball > mass", "weight > ball"]
[simulation]
duration = "3 s"
"#;

/// A ball that keeps 0.8 of its speed: it meets the ground at t_0, t_0 (1 + 2 0.8), t_0 (1 + 2 0.8 + 2 0.8^2), ...
#[test]
fn a_ball_bounces_where_its_height_falls_through_zero() {
    let graph = Graph::read(BALL).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).expect("no conflict");
    let run = found.simulate(&SimulationRequest { tolerance: 1e-11, ..found.request() });
    assert!(run.complete, "{}", run.ended);
    let first = (2.0f64 / 9.81).sqrt();
    let mut at = first;
    let hits: Vec<f64> = run.events.iter().filter(|event| event.on).map(|event| event.time).collect();
    assert!(hits.len() >= 4, "{hits:?}");
    for (k, hit) in hits.iter().enumerate() {
        assert!((hit - at).abs() < 1e-9, "bounce {k} at {hit} s instead of {at} s");
        at += 2.0 * first * 0.8f64.powi(k as i32 + 1);
    }
    let counted = run.values("bounces").and_then(<[f64]>::last).copied().expect("a signal");
    assert_eq!(counted, hits.len() as f64);
}

#[test]
fn events_are_shown_and_checked() {
    let found = equations(&Graph::read(BALL).expect("it is good")).expect("no conflict");
    let text = lanchester_bondgraph::equations_text(&found.shown(lanchester_bondgraph::Notation::Text));
    assert!(text.contains("-height rises through 0: mass.momentum becomes"), "{text}");
    let modelica = lanchester_bondgraph::modelica(&found);
    assert!(modelica.contains("when (-height) > 0 then\n    reinit(mass_momentum,"), "{modelica}");
    for (from, to, code) in [
        ("-0.8*mass.momentum", "-0.8*height", "E1705"),
        ("\"mass.momentum\" =", "\"weight.effort\" =", "E1706"),
        ("when = \"-height\"", "when = \"-hight\"", "E1706"),
        ("when = \"-height\"\n", "", "E1709"),
        ("bounces = \"bounces + 1\"", "ball.flow = 3", "E1701"),
    ] {
        let text = BALL.replacen(from, to, 1);
        assert_ne!(text, BALL);
        let mistakes = Graph::read(&text).expect_err(to);
        assert!(mistakes.iter().any(|mistake| mistake.code == code), "{to}: {mistakes:#?}");
    }
}

#[test]
fn events_stand_in_the_written_file() {
    let graph = lanchester_bondgraph::Description::new("ball")
        .element("ball", "1", &[("domain", "translation")])
        .element("mass", "I", &[("inertia", "1 kg")])
        .signal("height", &[("integral_of", "ball.flow"), ("start", "1 m")])
        .bonds(&["ball > mass"])
        .event("-height", &[("mass.momentum", "-mass.momentum")]);
    let text = graph_file(&graph);
    let again = Graph::read(&text).unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:#?}"));
    let shown = equations(&again).expect("no conflict").shown(lanchester_bondgraph::Notation::Text);
    assert_eq!(shown.events.len(), 1);
}

/// Two masses on one shaft, the second on a pad: the stiffer the pad, the nearer to both as one, by its stiffness.
#[test]
fn a_pad_frees_a_store_that_follows() {
    let text = |stiffness: &str| {
        format!(
            "[elements]\nshaft = {{ kind = \"1\", domain = \"rotation\" }}\nwheel = {{ kind = \"I\", inertia = \"2 kg m2\" }}\n\
             gear = {{ kind = \"TF\", ratio = \"3\" }}\nfast = {{ kind = \"1\", domain = \"rotation\" }}\n\
             disc = {{ kind = \"I\", inertia = \"0.5 kg m2\" }}\ntorque = {{ kind = \"Se\", effort = \"13 N m\" }}\n\
             [bonds]\nlist = [\"torque > shaft\", \"shaft > wheel\", \"shaft > gear.1\", \"gear.2 > fast\", \"fast > disc\"]\n\
             [simulation]\nduration = \"2 s\"\n{stiffness}"
        )
    };
    let run = |stiffness: &str| {
        let graph = Graph::read(&text(stiffness)).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
        let found = equations(&graph).expect("no conflict");
        let run = found.simulate(&SimulationRequest { tolerance: 1e-11, ..found.request() });
        (
            found.causality.followers.len(),
            run.values("shaft.flow").and_then(<[f64]>::last).copied().expect("a run"),
        )
    };
    // (2 + 9 0.5) w' = 13
    let (followers, ideal) = run("");
    assert_eq!((followers, (ideal - 4.0).abs() < 1e-9), (1, true), "{ideal}");
    let off = |stiffness: &str| {
        let pad = format!(
            "[relax]\ndisc = {{ stiffness = \"{stiffness} N m/rad\", damping = \"200 N m s/rad\" }}\n"
        );
        let (followers, speed) = run(&pad);
        assert_eq!(followers, 0);
        (speed - ideal).abs()
    };
    let (soft, stiff) = (off("1e4"), off("1e5"));
    assert!(soft < 0.05 && stiff < 0.05, "{soft}, {stiff}");
    for (bad, code) in [
        ("gear = { stiffness = \"1 N m/rad\" }", "E1706"),
        ("disc = { damping = \"1 N m s/rad\" }", "E1709"),
        ("disc = { stiffness = \"1 N/m\" }", "E1705"),
        ("disc = { stiffness = \"1 N m/rad\", soft = \"1\" }", "E1702"),
    ] {
        let mistakes = Graph::read(&text(&format!("[relax]\n{bad}\n"))).expect_err(bad);
        assert!(mistakes.iter().any(|mistake| mistake.code == code), "{bad}: {mistakes:#?}");
    }
}

/// A table stands in the Modelica text as a function of its pieces.
#[test]
fn tables_stand_in_the_modelica_text() {
    let text = "[tables.push]\npoints = [[0, 0], [1, 2], [3, 0]]\nperiodic = true\nx_unit = \"s\"\ny_unit = \"N\"\n\
                [elements]\nforce = { kind = \"Se\", effort = \"table(push, t)\" }\ncar = { kind = \"1\", domain = \"translation\" }\n\
                mass = { kind = \"I\", inertia = \"1 kg\" }\n[bonds]\nlist = [\"force > car\", \"car > mass\"]\n";
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let modelica = lanchester_bondgraph::modelica(&equations(&graph).expect("no conflict"));
    for part in [
        "function push",
        "constant Real starts[2] = {0.0, 1.0};",
        "{{0.0, 2.0, 0.0, 0.0}, {2.0, -1.0, 0.0, 0.0}}",
        "0.0 + mod(x - (0.0), 3.0)",
        "force_effort = push(time)",
    ] {
        assert!(modelica.contains(part), "no {part} in\n{modelica}");
    }
}

/// Events stand in the text with their time and the condition as the graph writes it, the first dozen of them.
#[test]
fn events_are_listed_with_their_conditions() {
    let text = r#"
name = "rattle"
[elements]
push = { kind = "Se", effort = "1 N*sin(40*t/(1 s))" }
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1 kg" }
stop = { kind = "C", law = "if(q > 1 mm, 200 N/m*(q - 1 mm), 0 N)" }
rub = { kind = "R", effort = "0.3 N*tanh(f/(1 mm/s)) + 1 N s/m*max(f, 2 mm/s)" }
[signals]
x = { integral_of = "v.flow", start = "0 mm" }
[[event]]
when = "t - 0.25 s"
set = { "m.momentum" = "0 N s" }
[bonds]
list = ["push > v", "v > m", "v > stop", "v > rub"]
[simulation]
duration = "2 s"
"#;
    let found = equations(&Graph::read(text).expect("good")).expect("no conflict");
    let run = found.simulate(&found.request());
    assert!(run.complete, "{}", run.ended);
    let own = |expression: &str| run.events.iter().filter(|event| event.expression == expression).count();
    assert_eq!(own("t - 0.25 > 0"), 1, "{:#?}", run.events);
    assert!(own("stop.displacement - 0.001 > 0") > 0 && own("rub.flow - 0.002 > 0") > 0, "{:#?}", run.events);
    let text = lanchester_bondgraph::simulation_text(&run);
    assert!(text.contains("0.250000000 s  t - 0.25 > 0 becomes true"), "{text}");
    assert!(run.events.len() > 12, "{}", run.events.len());
    assert!(text.contains(&format!("and {} more", run.events.len() - 12)), "{text}");
}
