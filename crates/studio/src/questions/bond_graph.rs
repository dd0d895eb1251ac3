//! A bond graph beside its file: strokes, equations, poles and the power through each bond.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{engine_file, in_utf16};
use lanchester::bondgraph::{
    Equation, Graph, Notation, Placed, Simulation, SimulationRequest, causality_text, equations, graph_file,
    mathml, placed,
};
use lanchester::file::Diagnostic;
use lanchester::{BondGraphRequest, engine_bond_graph};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Samples of a run that are shown at most.
const MOST_SAMPLES: usize = 400;
/// Evaluations of a run that somebody waits for.
const MOST_EVALUATIONS: u64 = 200_000;

/// Graphs of the course, to start from: name and file.
const EXAMPLES: [(&str, &str); 14] = [
    ("mass-spring-damper", include_str!("../../../../examples/bond-graphs/mass-spring-damper.toml")),
    ("dc-motor", include_str!("../../../../examples/bond-graphs/dc-motor.toml")),
    ("two-tanks", include_str!("../../../../examples/bond-graphs/two-tanks.toml")),
    ("two-tanks-turbulent", include_str!("../../../../examples/bond-graphs/two-tanks-turbulent.toml")),
    ("gear-train", include_str!("../../../../examples/bond-graphs/gear-train.toml")),
    ("slider-crank", include_str!("../../../../examples/bond-graphs/slider-crank.toml")),
    ("slider-crank-elastic", include_str!("../../../../examples/bond-graphs/slider-crank-elastic.toml")),
    ("double-pendulum", include_str!("../../../../examples/bond-graphs/double-pendulum.toml")),
    ("double-pendulum-stiff", include_str!("../../../../examples/bond-graphs/double-pendulum-stiff.toml")),
    ("prismatic-pair", include_str!("../../../../examples/bond-graphs/prismatic-pair.toml")),
    ("hydraulic-press", include_str!("../../../../examples/bond-graphs/hydraulic-press.toml")),
    ("thermal-chain", include_str!("../../../../examples/bond-graphs/thermal-chain.toml")),
    ("torsion-chain", include_str!("../../../../examples/bond-graphs/torsion-chain.toml")),
    ("single-cylinder", include_str!("../../../../examples/bond-graphs/single-cylinder.toml")),
];

/// A graph file.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphExample {
    name: String,
    text: String,
}

/// A graph to look at.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct GraphQuestion {
    /// The graph file.
    text: String,
}

/// An engine whose graph is wanted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EngineGraphQuestion {
    /// The engine file.
    text: String,
}

/// The graph of an engine as a graph file.
#[derive(Debug, Serialize, JsonSchema)]
struct EngineGraphAnswer {
    /// The graph file.
    text: String,
    /// What was assumed.
    notes: Vec<String>,
}

/// A graph, looked at.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphAnswer {
    name: String,
    /// Size of the drawing [px].
    size: [f64; 2],
    elements: Vec<GraphElement>,
    bonds: Vec<GraphBond>,
    /// The causality, step by step, in words.
    causality: String,
    /// Equations by what they belong to.
    equations: Vec<EquationList>,
    /// Poles of a linear graph.
    poles: Vec<GraphPole>,
    /// Why there are no poles.
    not_linear: Option<String>,
    /// Samples of a run [s].
    time: Vec<f64>,
    /// How the run ended.
    ended: String,
    /// Whether it reached its end.
    complete: bool,
}

/// An element in its place.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphElement {
    name: String,
    kind: String,
    at: [f64; 2],
    /// Whether it is a store that follows others.
    follows: bool,
}

/// A bond in its place, with what it carries.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphBond {
    name: String,
    /// Its ends along the half arrow [px].
    line: [[f64; 2]; 2],
    /// End of the barb at its head [px].
    barb: [f64; 2],
    /// Ends of the causal stroke [px].
    stroke: [[f64; 2]; 2],
    follows: bool,
    free: bool,
    /// Units of effort and flow.
    units: [String; 2],
    /// At the samples.
    effort: Vec<f64>,
    /// At the samples.
    flow: Vec<f64>,
    /// At the samples [W].
    power: Vec<f64>,
}

/// Equations under one title.
#[derive(Debug, Serialize, JsonSchema)]
struct EquationList {
    title: String,
    /// Each as MathML, with its unit.
    lines: Vec<EquationLine>,
}

/// One equation.
#[derive(Debug, Serialize, JsonSchema)]
struct EquationLine {
    /// Whose law it is.
    of: String,
    mathml: String,
    unit: String,
}

/// A pole of a linear graph.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphPole {
    /// Real part [1/s].
    real: f64,
    /// Imaginary part [rad/s].
    imaginary: f64,
    /// Damping ratio.
    damping: f64,
    /// Natural frequency [Hz].
    hertz: f64,
}

pub(crate) fn questions(api: Api) -> Api {
    let api = api.get("/api/bondgraph/examples", "Bond graphs to start from.", |_| {
        let own = |(name, text): &(&str, &str)| GraphExample { name: (*name).into(), text: (*text).into() };
        Ok(EXAMPLES.iter().map(own).collect::<Vec<_>>())
    });
    let api = api.post(
        "/api/bondgraph",
        "A bond graph: drawing with causal strokes, equations, poles, power through each bond.",
        look,
    );
    api.post("/api/bondgraph/engine", "The bond graph of an engine as a graph file.", of_engine)
}

fn of_engine(asker: &Asker, question: EngineGraphQuestion) -> Result<EngineGraphAnswer, Problem> {
    let file = engine_file(&question.text)?;
    let traces = asker.studio.folder.traces(&file.engine)?;
    let request = BondGraphRequest {
        simulation: file.tasks.simulation.as_deref().cloned().unwrap_or_default(),
        ..BondGraphRequest::default()
    };
    let found = engine_bond_graph(&file.engine, &traces, &request).map_err(Problem::refused)?;
    Ok(EngineGraphAnswer { text: graph_file(&found.description), notes: found.notes })
}

fn look(_: &Asker, question: GraphQuestion) -> Result<GraphAnswer, Problem> {
    answer(&question.text)
}

fn answer(text: &str) -> Result<GraphAnswer, Problem> {
    let refuse = |mistakes: Vec<Diagnostic>| Problem::graph(in_utf16(text, mistakes));
    // Other graphs are looked for among the examples alone: a page cannot read files.
    let part = |name: &str| {
        let name = name.strip_suffix(".toml").unwrap_or(name);
        EXAMPLES.iter().find(|(own, _)| *own == name).map(|(_, text)| (*text).to_owned())
    };
    let graph = Graph::read_with(text, &part).map_err(refuse)?;
    let found = equations(&graph).map_err(refuse)?;
    let asked = found.request();
    let samples = asked.samples.min(MOST_SAMPLES);
    let asked = SimulationRequest { samples, most_evaluations: MOST_EVALUATIONS, ..asked };
    let run = found.simulate(&asked);
    let shown = found.shown(Notation::Latex);
    let (poles, not_linear) = match found.linear() {
        Ok(linear) => (linear.poles, None),
        Err(reason) => (Vec::new(), Some(reason.in_words().join(": "))),
    };
    let Placed { size, elements, bonds, .. } = placed(&graph, &found.causality);
    Ok(GraphAnswer {
        name: run.graph.clone(),
        size,
        elements: (elements.into_iter())
            .map(|own| GraphElement { name: own.name, kind: own.kind, at: own.at, follows: own.follows })
            .collect(),
        bonds: (bonds.into_iter())
            .map(|own| {
                let [effort, flow, power] =
                    ["effort", "flow", "power"].map(|what| series(&run, &own.name, what));
                GraphBond {
                    name: own.name,
                    line: own.line,
                    barb: own.barb,
                    stroke: own.stroke,
                    follows: own.follows,
                    free: own.free,
                    units: [effort.0, flow.0],
                    effort: effort.1,
                    flow: flow.1,
                    power: power.1,
                }
            })
            .collect(),
        causality: causality_text(&graph, &found.causality),
        equations: [
            ("State equations", &shown.rates),
            ("Common parts", &shown.common),
            ("Laws of the elements", &shown.elements),
            ("Laws of the junctions", &shown.junctions),
            ("Signals", &shown.signals),
            ("Parameters", &shown.parameters),
        ]
        .into_iter()
        .filter(|(_, list)| !list.is_empty())
        .map(|(title, list)| EquationList { title: title.into(), lines: list.iter().map(line).collect() })
        .collect(),
        poles: (poles.into_iter())
            .map(|own| GraphPole {
                real: own.real,
                imaginary: own.imaginary,
                damping: own.damping,
                hertz: own.hertz,
            })
            .collect(),
        not_linear,
        time: run.time,
        ended: run.ended,
        complete: run.complete,
    })
}

/// Unit and values of a bond's series.
fn series(run: &Simulation, bond: &str, what: &str) -> (String, Vec<f64>) {
    let name = format!("{bond}.{what}");
    let found = run.series.iter().find(|series| series.name == name);
    // No number has a place in JSON that is none.
    let number = |value: &f64| if value.is_finite() { *value } else { 0.0 };
    found.map_or_else(Default::default, |series| {
        (series.unit.clone(), series.values.iter().map(number).collect())
    })
}

fn line(equation: &Equation) -> EquationLine {
    EquationLine {
        of: equation.of.clone(),
        mathml: mathml(&format!("{} = {}", equation.left, equation.right)),
        unit: equation.unit.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_drawn_and_runs() {
        for (name, text) in EXAMPLES {
            let found = answer(text).unwrap_or_else(|problem| panic!("{name}: {problem:?}"));
            assert!(found.complete, "{name}: {}", found.ended);
            assert!(found.bonds.iter().all(|bond| bond.power.len() == found.time.len()), "{name}");
            assert!(found.equations[0].lines.iter().all(|line| line.mathml.starts_with("<math")), "{name}");
        }
    }

    /// What a teacher does: a stiffer spring moves the poles of mass, spring and damper.
    #[test]
    fn another_number_moves_the_poles() {
        let (_, text) = EXAMPLES[0];
        let before = answer(text).expect("it is good");
        let changed = text.replace("3 N s/m", "6 N s/m");
        assert_ne!(changed, text);
        let after = answer(&changed).expect("it is good");
        assert_eq!(before.poles.len(), 2);
        // m s^2 + R s + k: the real part is -R/2m.
        assert!((after.poles[0].real / before.poles[0].real - 2.0).abs() < 1e-9);
    }

    #[test]
    fn mistakes_are_told_with_their_places() {
        let (_, text) = EXAMPLES[0];
        let problem = answer(&text.replace("3 N s/m", "3 N")).expect_err("a wrong unit");
        assert!(problem.diagnostics.iter().any(|mistake| mistake.code == "E1705"), "{problem:?}");
    }
}
