//! Runs and drawings of bond graphs.

use crate::atlas::list::{GraphEntry, RunEntry};
use crate::files::Source;
use lanchester::bondgraph::{
    CompliantJoints, Description, EngineBlock, EngineJoints, Equations, Graph, drawing, equations,
};
use lanchester::file::{Diagnostic, EngineFile, read};
use lanchester::report::{Figure, bond_graph_figures};
use lanchester::{BondGraphRequest, engine_bond_graph};
use lanchester_data::BOND_GRAPHS;
use std::f64::consts::PI;

fn in_words(mistakes: Vec<Diagnostic>) -> String {
    mistakes.iter().map(|mistake| mistake.message.clone()).collect::<Vec<_>>().join("; ")
}

fn engine_file(source: &Source, name: &str) -> Result<EngineFile, String> {
    let text = source.engines.get(name).ok_or_else(|| format!("no engine file is called {name:?}"))?;
    let reading = read(text);
    reading.file.ok_or_else(|| in_words(reading.diagnostics))
}

fn described(file: &EngineFile, request: &BondGraphRequest) -> Result<Description, String> {
    let simulation = file.tasks.simulation.as_deref().cloned().unwrap_or_default();
    let request = BondGraphRequest { simulation, ..request.clone() };
    let found = engine_bond_graph(&file.engine, &[], &request).map_err(|error| error.to_string())?;
    Ok(found.description)
}

fn with_equations(graph: &Graph) -> Result<Equations, String> {
    equations(graph).map_err(in_words)
}

/// One of the figures of a run.
pub(crate) fn run(source: &Source, entry: &RunEntry) -> Result<Figure, String> {
    let mut file = engine_file(source, &entry.engine)?;
    if entry.without_shafts {
        file.engine = file.engine.without_shafts();
    }
    let block = match (entry.fixed, entry.held) {
        (true, _) => Some(EngineBlock::Fixed),
        (_, true) => Some(EngineBlock::Held),
        _ => None,
    };
    let joints = entry.skirt_offset.map_or(EngineJoints::Ideal, |skirt_offset| {
        EngineJoints::Compliant(CompliantJoints { skirt_offset, ..CompliantJoints::default() })
    });
    let request = BondGraphRequest {
        speed: entry.speed.map(|rpm| rpm * PI / 30.0),
        block,
        joints,
        imposed: entry.imposed.then_some(true),
        gravity: !entry.held,
        ..BondGraphRequest::default()
    };
    let graph = Graph::new(&described(&file, &request)?).map_err(in_words)?;
    let found = with_equations(&graph)?;
    let mut request = found.request();
    if let Some(duration) = entry.duration {
        request.duration = duration;
        request.periodic = None;
    }
    if let Some(samples) = entry.samples {
        request.samples = samples;
    }
    let run = found.simulate(&request);
    if !run.complete {
        return Err(format!("the run ended early: {}", run.ended));
    }
    let figures = bond_graph_figures(&run);
    let figure = figures.into_iter().find(|figure| figure.id == entry.figure);
    figure.ok_or_else(|| format!("the run has no figure {:?}", entry.figure))
}

/// The drawing of a graph, a document of its own.
pub(crate) fn drawn(source: &Source, entry: &GraphEntry) -> Result<String, String> {
    let graph = match (&entry.engine, &entry.graph) {
        (Some(engine), None) => {
            let described = described(&engine_file(source, engine)?, &BondGraphRequest::default())?;
            Graph::new(&described).map_err(in_words)?
        }
        (None, Some(name)) => {
            let graph = BOND_GRAPHS.iter().find(|(own, _)| own == name);
            let (_, text) = graph.ok_or_else(|| format!("no graph is called {name:?}"))?;
            Graph::read(text).map_err(in_words)?
        }
        _ => return Err("a drawing needs an engine or a graph".to_string()),
    };
    Ok(drawing(&graph, &with_equations(&graph)?.causality))
}
