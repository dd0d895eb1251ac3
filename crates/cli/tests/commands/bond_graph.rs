//! Bond graphs on the command line: graph files and engine files.

use crate::program::{example, folder, lanchester, message, number, output, output_json};

fn graph(name: &str) -> String {
    example(&format!("bond-graphs/{name}"))
}

#[test]
fn a_graph_file_shows_causality_equations_and_poles() {
    let folder = folder("bond-graph");
    let text = output(&folder, 0, &["bondgraph", &graph("slider-crank")]);
    assert!(text.contains("piston follows crank through shaft, slider, guide"), "{text}");
    assert!(text.contains("State equations, M x' = f"), "{text}");
    let latex = output(&folder, 0, &["bondgraph", "equations", &graph("dc-motor"), "--notation", "latex"]);
    assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{latex}");
    assert!(latex.contains("\\subsection*{Laws of the junctions}"), "{latex}");
    let dual = output(&folder, 0, &["bondgraph", "causality", &graph("two-tanks"), "--prefer", "derivative"]);
    assert!(dual.contains("is made to follow"), "{dual}");
    let poles =
        output_json(&folder, 0, &["bondgraph", "linear", &graph("mass-spring-damper"), "--format", "json"]);
    let frequency = number(&poles, "/poles/0/frequency");
    assert!((frequency * frequency - 250.0 / 1.2).abs() < 1e-9 * 250.0, "{frequency}");
}

#[test]
fn a_run_has_samples_and_an_audit() {
    let folder = folder("bond-graph-run");
    let run = ["bondgraph", "simulate", &graph("mass-spring-damper"), "--for", "2 s", "--samples", "50"];
    let csv = output(&folder, 0, &[&run[..], &["--format", "csv"]].concat());
    assert_eq!(csv.lines().count(), 52, "a head, the start and fifty samples");
    let json = output_json(&folder, 0, &[&run[..], &["--format", "json", "--tolerance", "1e-11"]].concat());
    assert_eq!(json["complete"], true);
    assert_eq!(json["time"].as_array().map(Vec::len), Some(51));
    let implicit = output(&folder, 0, &[&run[..], &["--method", "implicit"]].concat());
    assert!(implicit.contains("implicit"), "{implicit}");
    let audit = output(&folder, 0, &["bondgraph", "audit", &graph("two-tanks-turbulent")]);
    assert!(audit.contains("whole"), "{audit}");
    let drawing = output(&folder, 0, &["bondgraph", "draw", &graph("dc-motor")]);
    assert!(drawing.starts_with("<svg"), "{drawing}");
}

/// The engine of the bond-graph thesis from its engine file, and the same graph from the graph file that it is exported to.
#[test]
fn an_engine_file_is_a_graph() {
    let folder = folder("bond-graph-engine");
    let engine = example("three-cylinder");
    let text = output(&folder, 0, &["bondgraph", "causality", &engine]);
    assert!(text.contains("piston1_x follows"), "{text}");
    assert!(text.contains("States: block_x, block_y, block_z"), "{text}");
    let plain = ["--block", "fixed", "--inertia-only", "--no-gravity", "--speed", "1000 rpm"];
    let json = ["--for", "0.1 s", "--format", "json"];
    let run = output_json(&folder, 0, &[&["bondgraph", "simulate", &engine], &plain[..], &json[..]].concat());
    assert_eq!(run["complete"], true);
    let exported =
        output(&folder, 0, &[&["bondgraph", "export", &engine, "--to", "graph"], &plain[..]].concat());
    std::fs::write(folder.join("engine-graph.toml"), exported).unwrap();
    let again =
        output_json(&folder, 0, &[&["bondgraph", "simulate", "engine-graph.toml"], &json[..]].concat());
    assert_eq!(run["series"], again["series"], "the graph file is the same graph");
    let states = ["bondgraph", "simulate", &engine, "--block", "fixed", "--gas-states", "--for", "0.06 s"];
    let run = output_json(&folder, 0, &[&states[..], &["--format", "json"]].concat());
    assert_eq!(run["complete"], true);
    // Without a load in the file it is the mean torque of the engine, and that is said.
    let notes = |arguments: &[&str]| String::from_utf8(lanchester(&folder, arguments).stderr).unwrap();
    assert!(!notes(&states).contains("note: Load: "), "the file says its load");
    let text = std::fs::read_to_string(&engine).unwrap();
    std::fs::write(folder.join("no-load.toml"), text.split("[load]").next().unwrap()).unwrap();
    let states = states.map(|own| if own == engine { "no-load.toml" } else { own });
    assert!(notes(&states).contains("note: Load: "));
}

/// The engine on its mounts with gas as states, and a graph file: an oscillator under a force, whose multipliers are exp(poles T).
#[test]
fn a_periodic_motion_is_found() {
    let folder = folder("bond-graph-periodic");
    let until = ["--until", "periodic", "--format", "json"];
    let engine = example("three-cylinder");
    let run = output_json(&folder, 0, &[&["bondgraph", "simulate", &engine], &until[..]].concat());
    assert_eq!(run["complete"], true);
    assert_eq!(run["periodic"]["outcome"], "stable", "{}", run["periodic"]);
    assert!(number(&run, "/periodic/residual") < 1e-8, "{}", run["periodic"]);
    // Two revolutions at about 2000 rpm, after which the block is back.
    assert!((number(&run, "/periodic/period") - 0.06).abs() < 5e-4, "{}", run["periodic"]);
    let series = run["series"].as_array().unwrap();
    let block = series.iter().find(|own| own["name"] == "block_y.momentum").unwrap();
    let values: Vec<f64> = block["values"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    let most = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    assert!(most > 0.1, "it moves: {most}");
    assert!((values[0] - values[values.len() - 1]).abs() < 1e-7 * most);

    let forced = "[elements]\nv = { kind = \"1\", domain = \"translation\" }\n\
         m = { kind = \"I\", inertia = \"1.2 kg\" }\nk = { kind = \"C\", stiffness = \"250 N/m\" }\n\
         r = { kind = \"R\", resistance = \"3 N s/m\" }\n\
         push = { kind = \"MSe\", effort = \"10 N*cos(20 rad/s*t)\" }\n\
         [bonds]\nlist = [\"push > v\", \"v > m\", \"v > k\", \"v > r\"]\n\
         [simulation]\nperiod = \"0.31415926535897932 s\"\n";
    std::fs::write(folder.join("forced.toml"), forced).unwrap();
    let run = output_json(&folder, 0, &[&["bondgraph", "simulate", "forced.toml"], &until[..]].concat());
    assert_eq!(run["periodic"]["outcome"], "stable", "{}", run["periodic"]);
    let (real, imaginary) =
        (number(&run, "/periodic/multipliers/0/0"), number(&run, "/periodic/multipliers/0/1"));
    let exact = (-3.0 / 2.4 * std::f64::consts::PI / 10.0).exp();
    assert!((real.hypot(imaginary) - exact).abs() < 1e-6, "{real} {imaginary} against {exact}");
    let endless = ["bondgraph", "simulate", &graph("dc-motor"), "--until", "periodic"];
    assert!(message(&folder, 2, &endless).contains("period"));
}

#[test]
fn what_is_wrong_is_said() {
    let folder = folder("bond-graph-bad");
    let has = |arguments: &[&str], words: &str| {
        let text = message(&folder, 2, arguments);
        assert!(text.contains(words), "{arguments:?}\n{text}");
    };
    has(&["bondgraph", "causality"], "needs a graph file");
    has(&["bondgraph", "paint", &graph("dc-motor")], "has no action \"paint\"");
    has(&["bondgraph", "simulate", &graph("dc-motor"), "--for", "2 m"], "--for needs a time");
    has(&["bondgraph", "simulate", &graph("dc-motor"), "--tolerance", "1"], "outside 1e-13 to 0.01");
    has(&["bondgraph", "draw", &graph("dc-motor"), "--format", "csv"], "CSV");
    has(&["bondgraph", &graph("dc-motor"), "--speed", "1000 rpm"], "a graph file says itself");
    has(&["bondgraph", &example("in-line-4-mounts"), "--block", "space"], "stiffness and viscous damping");
    has(&["bondgraph", &example("in-line-4"), "--block", "space"], "no [block]");
    has(&["bondgraph", &example("three-cylinder"), "--speed", "1000"], "--speed");
    has(&["bondgraph", &example("v6-60"), "--gas-states"], "gas as states needs");
    let text = std::fs::read_to_string(graph("slider-crank")).unwrap();
    std::fs::write(folder.join("bad.toml"), text.replace("effort = \"5 N m\"", "effort = \"5 N\"")).unwrap();
    has(&["bondgraph", "bad.toml"], "error[E1705]");
    let conflict = "[elements]\na = { kind = \"Sf\", flow = \"1 rad/s\" }\nb = { kind = \"Sf\", flow = \"2 rad/s\" }\n\
                    s = { kind = \"1\", domain = \"rotation\" }\n[bonds]\nlist = [\"a > s\", \"b > s\"]\n";
    std::fs::write(folder.join("conflict.toml"), conflict).unwrap();
    has(&["bondgraph", "conflict.toml"], "E1713");
    has(&["bondgraph", "missing.toml"], "missing.toml");
    let used = "[[use]]\ngraph = \"part.toml\"\nas = \"a\"\n[elements]\ns = { kind = \"Se\", effort = \"1 N m\" }\n[bonds]\n\
         list = [\"s > a_shaft\"]\n";
    std::fs::write(folder.join("uses.toml"), used).unwrap();
    has(&["bondgraph", "uses.toml"], "[[use]] names it");
    let part = "[elements]\nshaft = { kind = \"1\", domain = \"rotation\" }\n\
         wheel = { kind = \"I\", inertia = \"1 kg m2\" }\n[bonds]\nlist = [\"shaft > wheel\"]\n";
    std::fs::write(folder.join("part.toml"), part).unwrap();
    assert!(output(&folder, 0, &["bondgraph", "uses.toml"]).contains("States: a_wheel"));
}

/// Transfer functions to outputs of one's choice; what cannot be is refused by its name.
#[test]
fn outputs_and_preferences_are_checked() {
    let folder = folder("bond-graph-options");
    let motor = graph("dc-motor");
    let text = output(&folder, 0, &["bondgraph", "linear", &motor, "--output", "coil.effort,shaft.flow"]);
    assert!(text.contains("coil.effort / battery.effort = (") && text.contains("shaft.flow / "), "{text}");
    assert!(!text.contains("flywheel.flow"), "{text}");
    for (arguments, words) in [
        (&["linear", &motor, "--output", "coil.speed"][..], "no quantity `coil.speed`"),
        (&["simulate", &motor, "--output", "coil.flow"], "use it with `bondgraph linear`"),
        (&["equations", &motor, "--prefer", "derivative"], "use it with `bondgraph causality`"),
    ] {
        let said = message(&folder, 2, &[&["bondgraph"], arguments].concat());
        assert!(said.contains(words), "{said}");
    }
    let dual = output(&folder, 0, &["bondgraph", "causality", &motor, "--prefer", "derivative"]);
    assert!(dual.contains("coil follows by choice") && !dual.contains("coil follows coil"), "{dual}");
}

/// An engine's graph and its run begin with what they say in short; all of it is one option away, and said.
#[test]
fn an_engine_is_shown_in_short() {
    let folder = folder("bond-graph-short");
    let engine = example("three-cylinder");
    let text = output(&folder, 0, &["bondgraph", &engine]);
    assert!(text.lines().count() < 20, "{text}");
    assert!(text.contains("182 elements and 353 bonds") && text.contains("bondgraph simulate "), "{text}");
    let run = output(&folder, 0, &["bondgraph", "simulate", &engine]);
    assert!(
        run.lines().nth(1).is_some_and(|line| line.starts_with("speed of crankshaft 1: 2000.0 rpm")),
        "{run}"
    );
    assert!(run.contains("torque of the load: 89.8 N m") && run.contains("block moves to and fro"), "{run}");
    assert!(run.lines().count() < 80 && run.contains("--all lists them"), "{run}");
    let all = output(&folder, 0, &["bondgraph", "simulate", &engine, "--all"]);
    assert!(all.contains("load.power [W]") && !run.contains("load.power"), "{all}");
    // A small graph is shown whole, with the same hint.
    let small = output(&folder, 0, &["bondgraph", &graph("two-tanks")]);
    assert!(small.contains("State equations") && small.contains("bondgraph simulate "), "{small}");
}

/// What would take too many evaluations is seen on the way, with an estimate and the option that lets it run.
#[test]
fn a_run_that_is_too_long_is_estimated() {
    let folder = folder("bond-graph-long");
    let text = "name = \"fast\"\n[elements]\nv = { kind = \"1\", domain = \"translation\" }\n\
                m = { kind = \"I\", inertia = \"1 kg\", flow = \"1 m/s\" }\nk = { kind = \"C\", stiffness = \"1e8 N/m\" }\n\
                [bonds]\nlist = [\"v > m\", \"v > k\"]\n";
    std::fs::write(folder.join("fast.toml"), text).unwrap();
    // Some 100 evaluations a period at 1592 Hz.
    let run = ["bondgraph", "simulate", "fast.toml", "--for", "2000 s", "--format", "json"];
    let said = lanchester(&folder, &run);
    let json: serde_json::Value = serde_json::from_slice(&said.stdout).unwrap();
    let needed = number(&json, "/evaluations_needed");
    assert!(needed > 2e7 && needed < 1e10, "{needed}");
    assert!(number(&json, "/statistics/evaluations") < 2e6, "it ends long before its limit");
    assert!(String::from_utf8(said.stderr).unwrap().contains("--long lets it run on"));
    // What it needs is true: a hundredth of the time takes a hundredth of it.
    let part = ["bondgraph", "simulate", "fast.toml", "--for", "20 s", "--long", "--format", "json"];
    let part = number(&output_json(&folder, 0, &part), "/statistics/evaluations");
    assert!((100.0 * part / needed - 1.0).abs() < 0.3, "{part} {needed}");
}

/// One curve has no legend: its name is the title.
#[test]
fn a_plot_of_one_curve_has_its_name() {
    let folder = folder("bond-graph-one-curve");
    let motor = graph("dc-motor");
    output(&folder, 0, &["bondgraph", "simulate", &motor, "--figures", "figures"]);
    let file = std::fs::read_dir(folder.join("figures")).unwrap().next().unwrap().unwrap().path();
    let svg = std::fs::read_to_string(file).unwrap();
    assert!(svg.contains("coil.momentum") && !svg.contains(">states"), "{svg}");
}
