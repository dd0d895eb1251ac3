//! A bond graph beside its file: strokes, equations, poles and the power through each bond.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::{engine_file, in_utf16};
use lanchester::bondgraph::{
    CompliantJoints, EngineBlock, EngineJoints, Graph, LabelAnchor, Notation, PartLine, Placed,
    ShownEquations, Simulation, SimulationRequest, causality_text, equations, graph_file, mathml, placed,
};
use lanchester::file::Diagnostic;
use lanchester::{BondGraphRequest, engine_bond_graph};
use lanchester_data::BOND_GRAPHS;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Samples of a run that are shown at most.
const MOST_SAMPLES: usize = 400;
/// Evaluations of a run that somebody waits for.
const MOST_EVALUATIONS: u64 = 200_000;

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
    /// Texts of the graphs that it uses and of the files of its tables, by the names that it has for them.
    #[serde(default)]
    parts: BTreeMap<String, String>,
}

/// An engine whose graph is wanted.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EngineGraphQuestion {
    /// The engine file.
    text: String,
    /// How the block moves; default: in space on its mounts where the file gives them with viscous damping.
    #[serde(default)]
    block: Option<BlockOf>,
    /// Whether the joints are springs and dampers instead of ideal.
    #[serde(default)]
    compliant: bool,
    /// Whether the gas is states with valves and heat release; otherwise as the file says.
    #[serde(default)]
    gas_states: bool,
    /// Whether the speed is imposed; otherwise as the file says.
    #[serde(default)]
    imposed: bool,
    /// Whether the balance shafts are left out.
    #[serde(default)]
    without_shafts: bool,
}

/// How the block of an engine's graph moves.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum BlockOf {
    /// Not at all.
    Fixed,
    /// In the plane across the crank.
    Plane,
    /// In space.
    Space,
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
    /// Tiles of an engine's graph; none of any other.
    tiles: Vec<GraphTile>,
    elements: Vec<GraphElement>,
    bonds: Vec<GraphBond>,
    /// The causality, step by step, in words.
    causality: String,
    /// Equations by what they belong to.
    equations: Vec<EquationList>,
    /// Poles of a linear graph.
    poles: Vec<GraphPole>,
    /// From each source to what stores give, of a linear graph.
    transfer: Vec<GraphTransfer>,
    /// Why there are no poles.
    not_linear: Option<String>,
    /// Samples of a run [s].
    time: Vec<f64>,
    /// How the run ended.
    ended: String,
    /// Whether it reached its end.
    complete: bool,
}

/// A tile of an engine's graph: block and crank, a cylinder, a rotor, a mount.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphTile {
    title: String,
    /// Its upper left corner [px].
    corner: [f64; 2],
    size: [f64; 2],
}

/// What a bond to another tile leads to.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphEnd {
    /// Where its name stands [px].
    at: [f64; 2],
    name: String,
}

/// An element in its place.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphElement {
    name: String,
    kind: String,
    /// Its middle [px].
    at: [f64; 2],
    /// Middle and base line of the letters of its kind [px].
    kind_at: [f64; 2],
    /// Its name, and its value where a number or a short expression says its law.
    labels: Vec<GraphLabel>,
    /// Whether it is a store that follows others.
    follows: bool,
}

/// Words beside an element.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphLabel {
    /// Their base line, at the side that `anchor` names [px].
    at: [f64; 2],
    anchor: LabelAnchor,
    text: String,
    /// Whether they are the value; else the name.
    is_value: bool,
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
    /// Where it leads, if that is in another tile.
    leads_to: Option<GraphEnd>,
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

/// A transfer function.
#[derive(Debug, Serialize, JsonSchema)]
struct GraphTransfer {
    input: String,
    output: String,
    /// A fraction in powers of s, as MathML.
    mathml: String,
}

pub(crate) fn questions(api: Api) -> Api {
    let api = api.get("/api/bondgraph/examples", "Bond graphs to start from.", |_| {
        let own = |(name, text): &(&str, &str)| GraphExample { name: (*name).into(), text: (*text).into() };
        Ok(BOND_GRAPHS.iter().map(own).collect::<Vec<_>>())
    });
    let api = api.post(
        "/api/bondgraph",
        "A bond graph: drawing with causal strokes, equations, poles, power through each bond.",
        look,
    );
    api.post("/api/bondgraph/engine", "The bond graph of an engine as a graph file.", of_engine)
}

fn of_engine(asker: &Asker, question: EngineGraphQuestion) -> Result<EngineGraphAnswer, Problem> {
    let mut file = asker.studio.with_torques(engine_file(&question.text)?)?;
    if question.without_shafts {
        file.engine = file.engine.without_shafts();
    }
    let traces = asker.studio.traces(&file.engine)?;
    let request = BondGraphRequest {
        block: question.block.map(|block| match block {
            BlockOf::Fixed => EngineBlock::Fixed,
            BlockOf::Plane => EngineBlock::Plane,
            BlockOf::Space => EngineBlock::Space,
        }),
        joints: match question.compliant {
            true => EngineJoints::Compliant(CompliantJoints::default()),
            false => EngineJoints::Ideal,
        },
        gas_as_states: question.gas_states,
        imposed: question.imposed.then_some(true),
        simulation: file.tasks.simulation.as_deref().cloned().unwrap_or_default(),
        ..BondGraphRequest::default()
    };
    let found = engine_bond_graph(&file.engine, &traces, &request).map_err(Problem::refused)?;
    Ok(EngineGraphAnswer { text: graph_file(&found.description), notes: found.notes })
}

fn look(_: &Asker, question: GraphQuestion) -> Result<GraphAnswer, Problem> {
    answer(&question.text, &question.parts)
}

fn answer(text: &str, parts: &BTreeMap<String, String>) -> Result<GraphAnswer, Problem> {
    let refuse = |mistakes: Vec<Diagnostic>| Problem::graph(in_utf16(text, mistakes));
    // Other graphs and tables are those that came with the question, then the examples: a page cannot read files.
    let part = |name: &str| {
        if let Some(text) = parts.get(name.rsplit('/').next().unwrap_or(name)) {
            return Some(text.clone());
        }
        let name = name.strip_suffix(".toml").unwrap_or(name);
        BOND_GRAPHS.iter().find(|(own, _)| *own == name).map(|(_, text)| (*text).to_owned())
    };
    let graph = Graph::read_with(text, &part).map_err(refuse)?;
    let found = equations(&graph).map_err(refuse)?;
    let asked = found.request();
    let samples = asked.samples.min(MOST_SAMPLES);
    let asked = SimulationRequest { samples, most_evaluations: MOST_EVALUATIONS, ..asked };
    let run = found.simulate(&asked);
    let shown = found.shown(Notation::Latex);
    let (poles, transfer, not_linear) = match found.linear() {
        Ok(linear) => (linear.poles, linear.transfer, None),
        Err(reason) => (Vec::new(), Vec::new(), Some(reason.in_words().join(": "))),
    };
    let Placed { size, elements, bonds, tiles } = placed(&graph, &found.causality);
    Ok(GraphAnswer {
        name: run.graph.clone(),
        size,
        tiles: (tiles.into_iter())
            .map(|own| GraphTile { title: own.title, corner: own.corner, size: own.size })
            .collect(),
        elements: (elements.into_iter())
            .map(|own| GraphElement {
                name: own.name,
                kind: own.kind,
                at: own.at,
                kind_at: own.kind_at,
                labels: (own.labels.into_iter())
                    .map(|own| GraphLabel {
                        at: own.at,
                        anchor: own.anchor,
                        text: own.text,
                        is_value: own.is_value,
                    })
                    .collect(),
                follows: own.follows,
            })
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
                    leads_to: own.leads_to.map(|end| GraphEnd { at: end.at, name: end.name }),
                    units: [effort.0, flow.0],
                    effort: effort.1,
                    flow: flow.1,
                    power: power.1,
                }
            })
            .collect(),
        causality: causality_text(&graph, &found.causality),
        equations: equation_lists(&shown),
        poles: (poles.into_iter())
            .map(|own| GraphPole {
                real: own.real,
                imaginary: own.imaginary,
                damping: own.damping,
                hertz: own.hertz,
            })
            .collect(),
        transfer: (transfer.into_iter())
            .map(|own| GraphTransfer { mathml: mathml(&own.latex()), input: own.input, output: own.output })
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

/// The equations under their titles, the state equations first.
fn equation_lists(shown: &ShownEquations) -> Vec<EquationList> {
    let mut parts = shown.parts();
    parts.sort_by_key(|part| part.title != "State equations");
    let line = |line: &PartLine| EquationLine {
        of: line.equation.of.clone(),
        mathml: mathml(&line.formula(Notation::Latex)),
        unit: line.equation.unit.clone(),
    };
    (parts.iter())
        .map(|part| EquationList { title: part.title.into(), lines: part.lines.iter().map(line).collect() })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_drawn_and_runs() {
        for (name, text) in BOND_GRAPHS {
            let found =
                answer(text, &BTreeMap::new()).unwrap_or_else(|problem| panic!("{name}: {problem:?}"));
            assert!(found.complete, "{name}: {}", found.ended);
            assert!(found.bonds.iter().all(|bond| bond.power.len() == found.time.len()), "{name}");
            assert!(found.equations[0].lines.iter().all(|line| line.mathml.starts_with("<math")), "{name}");
        }
    }

    /// What a teacher does: a stiffer spring moves the poles of mass, spring and damper.
    #[test]
    fn another_number_moves_the_poles() {
        let (_, text) = BOND_GRAPHS[0];
        let before = answer(text, &BTreeMap::new()).expect("it is good");
        let changed = text.replace("3 N s/m", "6 N s/m");
        assert_ne!(changed, text);
        let after = answer(&changed, &BTreeMap::new()).expect("it is good");
        assert_eq!(before.poles.len(), 2);
        // 1/m s / (s^2 + R/m s + k/m): from the push to the speed of the car.
        let fraction =
            &after.transfer.iter().find(|own| own.output == "mass.flow").expect("an output").mathml;
        assert!(
            fraction.contains("<mn>0.833333</mn><mi>s</mi>") && fraction.contains("<mn>208.333</mn>"),
            "{fraction}"
        );
        // m s^2 + R s + k: the real part is -R/2m.
        assert!((after.poles[0].real / before.poles[0].real - 2.0).abs() < 1e-9);
    }

    /// Tables and graphs that came with the question are found by their names.
    #[test]
    fn parts_come_with_the_question() {
        let text = "name = \"a\"\n[tables.push]\nfile = \"push.csv\"\nx_unit = \"s\"\ny_unit = \"N\"\n[[use]]\ngraph = \"parts/mass.toml\"\n\
                    as = \"own\"\n[elements]\nhand = { kind = \"MSe\", effort = \"table(push, t)\" }\n[bonds]\nlist = [\"hand > own_v\"]\n";
        let mass = "name = \"mass\"\n[elements]\nv = { kind = \"1\", domain = \"translation\" }\nm = { kind = \"I\", inertia = \"2 kg\" }\n\
                    [bonds]\nlist = [\"v > m\"]\n";
        let mut parts = BTreeMap::from([("push.csv".to_owned(), "0,0\n1,4\n".to_owned())]);
        assert!(answer(text, &parts).is_err(), "its mass is not there");
        parts.insert("mass.toml".to_owned(), mass.to_owned());
        let found = answer(text, &parts).unwrap_or_else(|problem| panic!("{problem:?}"));
        let bond = found.bonds.iter().find(|bond| bond.name == "hand").expect("its bond");
        // 4 N/s for a second on 2 kg: t^2 m/s.
        let last = bond.flow.len() - 1;
        assert!((bond.flow[last] - found.time[last].powi(2)).abs() < 1e-8, "{} m/s", bond.flow[last]);
    }

    #[test]
    fn an_engine_has_its_tiles_and_their_titles() {
        let text = include_str!("../../../../examples/in-line-4.toml");
        let file = engine_file(text).expect("it is valid");
        let found =
            engine_bond_graph(&file.engine, &[], &BondGraphRequest::default()).expect("it has a graph");
        let found = answer(&graph_file(&found.description), &BTreeMap::new()).expect("it is good");
        assert!(found.tiles.iter().any(|tile| tile.title == "Cylinder 4"));
        assert!(found.bonds.iter().any(|bond| bond.leads_to.is_some()));
    }

    #[test]
    fn mistakes_are_told_with_their_places() {
        let (_, text) = BOND_GRAPHS[0];
        let problem = answer(&text.replace("3 N s/m", "3 N"), &BTreeMap::new()).expect_err("a wrong unit");
        assert!(problem.diagnostics.iter().any(|mistake| mistake.code == "E1705"), "{problem:?}");
    }
}
