//! Our equations against those that a Modelica compiler makes of the exported text, and against those of BondGraphTools.

use lanchester_bondgraph::{EngineRequest, Equations, Graph, engine_graph, equations, modelica};
use lanchester_file::read;
use serde_json::Value;

fn compare(graph: &str, model: &str, curves: &str) {
    let graph = Graph::read(graph).expect("a shipped graph");
    compare_equations(&equations(&graph).expect("no conflict"), model, curves);
}

fn compare_equations(found: &Equations, model: &str, curves: &str) {
    assert_eq!(modelica(found), model, "the exported text is the one that was run");
    let curves: Value = serde_json::from_str(curves).expect("stored curves");
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().expect("a list").iter().map(|v| v.as_f64().expect("a number")).collect()
    };
    let time = numbers(&curves["time"]);
    let mut request = found.request();
    request.duration = *time.last().expect("samples");
    request.samples = time.len() - 1;
    let run = found.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    let mut compared = 0;
    for (name, values) in curves.as_object().expect("a table") {
        let Some(series) = run.series.iter().find(|series| series.name.replace('.', "_") == *name) else {
            continue;
        };
        let theirs = numbers(values);
        let largest = theirs.iter().fold(0.0f64, |most, v| most.max(v.abs()));
        for (sample, (ours, theirs)) in series.values.iter().zip(&theirs).enumerate() {
            assert!((run.time[sample] - time[sample]).abs() < 1e-12, "the same times");
            let off = (ours - theirs).abs() / largest;
            assert!(off < 1e-6, "{name} at {} s: {ours} here, {theirs} there, {off:e}", time[sample]);
        }
        compared += 1;
    }
    assert!(compared >= 2, "curves were compared");
}

macro_rules! external {
    ($test:ident, $name:literal) => {
        #[test]
        fn $test() {
            compare(
                include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml")),
                include_str!(concat!("../../../../validation/external/rumoca/", $name, ".mo")),
                include_str!(concat!("../../../../validation/external/rumoca/", $name, ".json")),
            );
        }
    };
}

external!(ext_rumoca_mass_spring_damper, "mass-spring-damper");
external!(ext_rumoca_dc_motor, "dc-motor");
external!(ext_rumoca_slider_crank, "slider-crank");

/// An engine: `lanchester bondgraph export examples/three-cylinder.toml --block fixed --inertia-only --load none`.
#[test]
fn ext_rumoca_three_cylinder() {
    let engine =
        read(include_str!("../../../../examples/three-cylinder.toml")).engine().expect("it has no mistakes");
    let request = EngineRequest {
        crankshaft_inertia: vec![3.009],
        gravity: 9.80665,
        ..EngineRequest::free(engine.speed.highest, 2.0)
    };
    let description = engine_graph(&engine, &request).expect("it has what it needs");
    let graph = Graph::new(&description).expect("units fit");
    compare_equations(
        &equations(&graph).expect("no conflict"),
        include_str!("../../../../validation/external/rumoca/three-cylinder.mo"),
        include_str!("../../../../validation/external/rumoca/three-cylinder.json"),
    );
}

/// State equations of every linear graph of the course that has one-ports and plain two-ports alone.
#[test]
fn ext_bondgraphtools_linear_graphs() {
    let table: Value =
        serde_json::from_str(include_str!("../../../../validation/external/bondgraphtools/matrices.json"))
            .expect("stored matrices");
    let names = |value: &Value| -> Vec<String> {
        value.as_array().expect("a list").iter().map(|v| v.as_str().expect("a name").to_owned()).collect()
    };
    let rows = |value: &Value| -> Vec<Vec<f64>> {
        let row = |row: &Value| {
            row.as_array().expect("a row").iter().map(|v| v.as_f64().expect("a number")).collect()
        };
        value.as_array().expect("rows").iter().map(row).collect()
    };
    macro_rules! shipped {
        ($($name:literal),*) => {
            [$(($name, include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml")))),*]
        };
    }
    for (name, text) in shipped![
        "mass-spring-damper",
        "dc-motor",
        "two-tanks",
        "torsion-chain",
        "gear-train",
        "hydraulic-press"
    ] {
        let graph = Graph::read(text).expect("a shipped graph");
        let linear = equations(&graph).expect("no conflict").linear().expect("linear");
        let theirs = &table["graphs"][name];
        let states = names(&theirs["states"]);
        let place = |own: &String| {
            let store = own.split('.').next().unwrap_or_default();
            states.iter().position(|state| state == store).unwrap_or_else(|| panic!("{name}: no {own}"))
        };
        let order: Vec<usize> = linear.states.iter().map(place).collect();
        assert_eq!(order.len(), states.len(), "{name}: as many states");
        let inputs: Vec<usize> = names(&theirs["inputs"])
            .iter()
            .map(|input| {
                let is_it = |own: &String| own.split('.').next() == Some(input);
                linear.inputs.iter().position(is_it).unwrap_or_else(|| panic!("{name}: no {input}"))
            })
            .collect();
        let (a, b) = (rows(&theirs["a"]), rows(&theirs["b"]));
        for (ours, row) in order.iter().enumerate() {
            // Numbers of different units stand in one row: each entry is held against itself.
            let mut pairs: Vec<(f64, f64)> =
                order.iter().enumerate().map(|(k, column)| (linear.a[ours][k], a[*row][*column])).collect();
            pairs.extend(inputs.iter().enumerate().map(|(k, own)| (linear.b[ours][*own], b[*row][k])));
            for (ours, theirs) in pairs {
                assert!((ours - theirs).abs() <= 1e-8 * theirs.abs(), "{name}: {ours} here, {theirs} there");
            }
        }
    }
}
