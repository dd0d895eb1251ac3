//! `lanchester bondgraph`: a graph's causality, equations, poles, simulation, audit, drawing and exports.

use crate::bondgraph_arguments::{
    BondgraphArguments, ExportOption, MethodOption, NotationOption, PreferOption,
};
use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::files::{Source, print, read_source, tell};
use crate::format::Format;
use lanchester::bondgraph::{
    Equations, Graph, Method, Notation, Preference, SimulationRequest, audit_text, causality, causality_text,
    drawing, equations, equations_latex, equations_text, graphml, is_graph_file, linear_text, modelica,
    simulation_csv, simulation_text,
};
use lanchester::file::{Diagnostic, render};
use std::path::Path;

/// What the command shows.
const ACTIONS: [&str; 7] = ["causality", "equations", "linear", "simulate", "audit", "draw", "export"];

pub fn run(arguments: &BondgraphArguments, colour: bool) -> Result<u8, Failure> {
    let (action, file) = match arguments.words.as_slice() {
        [action, file] => (action.as_str(), file),
        [file] if ACTIONS.contains(&file.as_str()) => {
            return Err(Failure::input(
                format!("`bondgraph {file}` needs a graph file"),
                format!("for example lanchester bondgraph {file} examples/bond-graphs/dc-motor.toml"),
            ));
        }
        [file] => ("", file),
        _ => return Err(Failure::input("`bondgraph` needs a graph file", "give its path")),
    };
    if !action.is_empty() && !ACTIONS.contains(&action) {
        return Err(Failure::input(
            format!("`bondgraph` has no action \"{action}\""),
            format!("it has {}", ACTIONS.join(", ")),
        ));
    }
    if arguments.format == Format::Csv && action != "simulate" {
        return Err(Failure::input(
            "only the samples of `bondgraph simulate` have a CSV form",
            "use --format json or text",
        ));
    }
    let source = read_source(Path::new(file))?;
    if !is_graph_file(&source.text) {
        return Err(Failure::input(
            format!("{} is no graph file: it has no table [elements]", source.name),
            "examples/bond-graphs has graphs to start from; engine files are not drawn as graphs",
        ));
    }
    let refuse = |mistakes: Vec<Diagnostic>| diagnosed(&mistakes, &source, colour);
    let graph = Graph::read(&source.text).map_err(refuse)?;
    if action == "causality" {
        let preference = match arguments.prefer {
            PreferOption::Integral => Preference::Integral,
            PreferOption::Derivative => Preference::Derivative,
        };
        let found = causality(&graph, preference).map_err(refuse)?;
        let text = causality_text(&graph, &found);
        print(&if arguments.format == Format::Json { json(&found)? } else { text })?;
        return Ok(DONE);
    }
    let found = equations(&graph).map_err(refuse)?;
    show(arguments, action, &graph, &found)
}

fn diagnosed(mistakes: &[Diagnostic], source: &Source, colour: bool) -> Failure {
    eprint!("{}", render(mistakes, &source.name, &source.text, colour));
    Failure::diagnosed()
}

fn show(
    arguments: &BondgraphArguments,
    action: &str,
    graph: &Graph,
    found: &Equations,
) -> Result<u8, Failure> {
    let as_json = arguments.format == Format::Json;
    let notation = match arguments.notation {
        NotationOption::Text => Notation::Text,
        NotationOption::Latex => Notation::Latex,
    };
    match action {
        "linear" => {
            let linear = found.linear().map_err(|reason| {
                let [message, hint] = reason.in_words();
                Failure::input(message, hint)
            })?;
            print(&if as_json { json(&linear)? } else { linear_text(&linear) })?;
        }
        "draw" => print(&drawing(graph, &found.causality))?,
        "export" => print(&match arguments.to {
            ExportOption::Modelica => modelica(found),
            ExportOption::Graphml => graphml(found),
            ExportOption::Json => json(
                &serde_json::json!({ "causality": found.causality, "equations": found.shown(notation) }),
            )?,
        })?,
        "simulate" | "audit" => {
            let run = found.simulate(&request(arguments, found, action == "audit")?);
            print(&match (arguments.format, action) {
                (Format::Json, _) => json(&run)?,
                (Format::Csv, _) => simulation_csv(&run),
                (Format::Text, "audit") => audit_text(&run),
                (Format::Text, _) => simulation_text(&run),
            })?;
            if !run.complete {
                tell(format_args!("the run ended early: {}", run.ended));
                return Ok(NOT_AS_EXPECTED);
            }
        }
        _ => {
            let shown = found.shown(notation);
            let text = match (as_json, notation) {
                (true, _) => json(&shown)?,
                (false, Notation::Latex) => equations_latex(&shown),
                (false, Notation::Text) => equations_text(&shown),
            };
            if action.is_empty() && !as_json && notation == Notation::Text {
                print(&format!("{}\n", causality_text(graph, &found.causality)))?;
            }
            print(&text)?;
        }
    }
    Ok(DONE)
}

fn request(
    arguments: &BondgraphArguments,
    found: &Equations,
    audit: bool,
) -> Result<SimulationRequest, Failure> {
    let mut request = found.request();
    request.audit = audit;
    if let Some(text) = &arguments.duration {
        request.duration = lanchester::bondgraph::duration(text).ok_or_else(|| {
            Failure::input(format!("--for needs a time above 0, got \"{text}\""), "for example --for '2 s'")
        })?;
    }
    if let Some(samples) = arguments.samples {
        request.samples = samples as usize;
    }
    if let Some(tolerance) = arguments.tolerance {
        if !(1e-13..=1e-2).contains(&tolerance) {
            let message = format!("--tolerance is outside 1e-13 to 0.01, got {tolerance}");
            return Err(Failure::input(message, "for example --tolerance 1e-9"));
        }
        request.tolerance = tolerance;
    }
    request.method = arguments.method.map(|method| match method {
        MethodOption::Explicit => Method::Explicit,
        MethodOption::Implicit => Method::Implicit,
    });
    Ok(request)
}
