//! `lanchester bondgraph`: a graph's causality, equations, poles, simulation, audit, drawing and exports.

use crate::commands::json;
use crate::failure::{DONE, Failure, NOT_AS_EXPECTED};
use crate::figures::write_figures;
use crate::files::{Source, print, read_bytes, read_source, tell};
use crate::format::Format;
use crate::options::bondgraph::{
    BondgraphArguments, EngineBlockOption, EngineOptions, ExportOption, JointsOption, MethodOption,
    NotationOption, PreferOption,
};
use crate::simulation_watch::Interruptible;
use crate::trace_files::{read_torques, trace_files};
use lanchester::bondgraph::{
    Cancel, CompliantJoints, Description, EngineBlock, EngineJoints, Equations, Graph, LoadLaw, Method,
    Notation, Preference, Simulation, SimulationRequest, audit_text, causality, causality_text, drawing,
    equations, equations_latex, equations_text, graph_file, graph_text, graphml, is_graph_file, linear_text,
    modelica, moving_drawing, simulation_csv, simulation_text, simulation_text_in_short, used_graphs,
};
use lanchester::file::{Diagnostic, read, render};
use lanchester::report::bond_graph_figures;
use lanchester::task::option;
use lanchester::{BondGraphRequest, RunLength, engine_bond_graph};
use std::collections::BTreeMap;
use std::path::Path;

/// How long a moving drawing takes [s].
const MOVING_SECONDS: f64 = 10.0;

/// Causality and equations of more lines are left to their own actions.
const MOST_LINES: usize = 150;

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
    if arguments.figures.is_some() && action != "simulate" {
        return Err(Failure::input(
            "--figures shows a run",
            "use it with `bondgraph simulate`; `bondgraph draw` draws the graph",
        ));
    }
    if arguments.format == Format::Csv && action != "simulate" {
        return Err(Failure::input(
            "only the samples of `bondgraph simulate` have a CSV form",
            "use --format json or text",
        ));
    }
    if !arguments.output.is_empty() && action != "linear" {
        return Err(Failure::input(
            "--output chooses the outputs of transfer functions",
            "use it with `bondgraph linear`",
        ));
    }
    if arguments.prefer == PreferOption::Derivative && action != "causality" {
        return Err(Failure::input(
            "--prefer derivative shows a causality: equations need stores as states",
            "use it with `bondgraph causality`",
        ));
    }
    let source = read_source(Path::new(file))?;
    let refuse = |mistakes: Vec<Diagnostic>| diagnosed(&mistakes, &source, colour);
    let (description, graph) = if is_graph_file(&source.text) {
        if arguments.engine != EngineOptions::default() {
            return Err(Failure::input(
                "a graph file says itself how it starts, what drives it and what moves",
                "leave out --speed, --block, --joints and what belongs to it, --imposed, --load, --load-on-block, --gas-states, --inertia-only, --without-shafts and --no-gravity",
            ));
        }
        (None, Graph::read_with(&source.text, &parts(Path::new(file), &source.text)?).map_err(refuse)?)
    } else {
        let description = of_engine(arguments, Path::new(file), &source, colour)?;
        let graph = Graph::new(&description).map_err(refuse)?;
        (Some(description), graph)
    };
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
    let as_file = || description.as_ref().map_or_else(|| source.text.clone(), graph_file);
    show(arguments, action, &graph, &found, as_file)
}

/// Texts of the graphs that a graph file uses, and of those that they use, by name from the folder of the file.
fn parts(file: &Path, text: &str) -> Result<impl Fn(&str) -> Option<String> + use<>, Failure> {
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut found: BTreeMap<String, String> = BTreeMap::new();
    let mut waiting = used_graphs(text);
    while let Some(name) = waiting.pop() {
        if found.contains_key(&name) {
            continue;
        }
        let bytes = read_bytes(
            &folder.join(&name),
            "[[use]] names it, or a table: give its place from the folder of the graph file",
        )?;
        let Ok(text) = String::from_utf8(bytes) else {
            return Err(Failure::input(format!("{name} is not UTF-8 text"), "save the graph file in UTF-8"));
        };
        waiting.extend(used_graphs(&text));
        found.insert(name, text);
    }
    Ok(move |name: &str| found.get(name).cloned())
}

/// The graph of an engine file.
fn of_engine(
    arguments: &BondgraphArguments,
    file: &Path,
    source: &Source,
    colour: bool,
) -> Result<Description, Failure> {
    let reading = read(&source.text);
    if !reading.diagnostics.is_empty() {
        eprint!("{}", render(&reading.diagnostics, &source.name, &source.text, colour));
    }
    let mut engine_file = reading.file.ok_or_else(Failure::diagnosed)?;
    read_torques(&mut engine_file, file)?;
    let options = &arguments.engine;
    if options.without_shafts {
        engine_file.engine = engine_file.engine.without_shafts();
    }
    let engine = &engine_file.engine;
    let load = match options.load.as_deref().map(str::trim) {
        None => None,
        Some("none") => Some(LoadLaw::None),
        Some(text) => Some(LoadLaw::Constant(option::torque(text, "--load")?)),
    };
    let mut simulation = engine_file.tasks.simulation.as_deref().cloned().unwrap_or_default();
    if arguments.until.is_some() {
        simulation.duration = Some(RunLength::Periodic);
    }
    let request = BondGraphRequest {
        speed: options.speed.as_deref().map(|text| option::speed(text, "--speed")).transpose()?,
        block: options.block.map(|block| match block {
            EngineBlockOption::Fixed => EngineBlock::Fixed,
            EngineBlockOption::Plane => EngineBlock::Plane,
            EngineBlockOption::Space => EngineBlock::Space,
            EngineBlockOption::Held => EngineBlock::Held,
        }),
        joints: joints(options)?,
        imposed: options.imposed.then_some(true),
        gravity: !options.no_gravity,
        gas: !options.inertia_only,
        gas_as_states: options.gas_states,
        load,
        load_on_block: options.load_on_block,
        simulation,
        ..BondGraphRequest::default()
    };
    let traces = if request.gas { trace_files(engine, file)? } else { Vec::new() };
    let found = engine_bond_graph(engine, &traces, &request).map_err(Failure::refused)?;
    for note in &found.notes {
        tell(format_args!("note: {note}"));
    }
    Ok(found.description)
}

/// Joints of the crank train.
fn joints(options: &EngineOptions) -> Result<EngineJoints, Failure> {
    let is_compliant = options.joints == Some(JointsOption::Compliant);
    if !is_compliant {
        let given = [
            ("--joint-stiffness", options.joint_stiffness.is_some()),
            ("--skirt-stiffness", options.skirt_stiffness.is_some()),
            ("--skirt-offset", options.skirt_offset.is_some()),
            ("--joint-damping", options.joint_damping.is_some()),
        ];
        return match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) => {
                Err(Failure::input(format!("`{name}` needs compliant joints"), "add --joints compliant"))
            }
            None => Ok(EngineJoints::Ideal),
        };
    }
    let mut joints = CompliantJoints::default();
    if let Some(text) = &options.joint_stiffness {
        joints.stiffness = option::stiffness(text, "--joint-stiffness")?;
    }
    if let Some(text) = &options.skirt_stiffness {
        joints.skirt_stiffness = option::stiffness(text, "--skirt-stiffness")?;
    }
    if let Some(text) = &options.skirt_offset {
        joints.skirt_offset = option::length(text, "--skirt-offset")?;
    }
    if let Some(ratio) = options.joint_damping {
        if !(0.0..=10.0).contains(&ratio) {
            let message = format!("--joint-damping is outside 0 to 10, got {ratio}");
            return Err(Failure::input(message, "for example --joint-damping 0.2"));
        }
        joints.damping_ratio = ratio;
    }
    Ok(EngineJoints::Compliant(joints))
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
    as_file: impl Fn() -> String,
) -> Result<u8, Failure> {
    let as_json = arguments.format == Format::Json;
    let notation = match arguments.notation {
        NotationOption::Text => Notation::Text,
        NotationOption::Latex => Notation::Latex,
    };
    match action {
        "linear" => {
            let linear = found.linear_to(&arguments.output).map_err(|reason| {
                let [message, hint] = reason.in_words();
                Failure::input(message, hint)
            })?;
            print(&if as_json { json(&linear)? } else { linear_text(&linear) })?;
        }
        "draw" if arguments.moving => {
            let run = found.simulate(&request(arguments, found, false)?);
            print(&moving_drawing(graph, &found.causality, &run, MOVING_SECONDS))?;
        }
        "draw" => print(&drawing(graph, &found.causality))?,
        "export" => print(&match arguments.to {
            ExportOption::Modelica => modelica(found),
            ExportOption::Graphml => graphml(found),
            ExportOption::Graph => as_file(),
            ExportOption::Json => json(
                &serde_json::json!({ "causality": found.causality, "equations": found.shown(notation) }),
            )?,
        })?,
        "simulate" | "audit" => {
            let run = found.simulate(&request(arguments, found, action == "audit")?);
            if let (Some(folder), Some(file)) = (&arguments.figures, arguments.words.last()) {
                write_figures(folder, Path::new(file), &bond_graph_figures(&run))?;
            }
            print(&match (arguments.format, action) {
                (Format::Json, _) => json(&run)?,
                (Format::Csv, _) => simulation_csv(&run),
                (Format::Text, "audit") => audit_text(&run),
                (Format::Text, _) if arguments.all => simulation_text(&run),
                (Format::Text, _) => in_short(&run),
            })?;
            if !run.complete {
                tell(format_args!("the run ended early: {}", run.ended));
                if run.evaluations_needed.is_some() {
                    tell(format_args!(
                        "hint: --long lets it run on, a larger --tolerance or a shorter --for need less"
                    ));
                }
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
            if !action.is_empty() || as_json || notation != Notation::Text {
                print(&text)?;
            } else {
                let causality = causality_text(graph, &found.causality);
                let is_long = causality.lines().count() + text.lines().count() > MOST_LINES;
                let all = format!("{causality}\n{text}");
                let file = arguments.words.last().map_or("FILE", String::as_str);
                print(&format!(
                    "{}\n{}",
                    if is_long { graph_text(graph, &found.causality) } else { all },
                    next(file, is_long)
                ))?;
            }
        }
    }
    Ok(DONE)
}

/// What else there is to see of a graph.
fn next(file: &str, is_long: bool) -> String {
    let file = if file.contains(' ') { format!("'{file}'") } else { file.to_owned() };
    let mut out = String::new();
    if is_long {
        out += &format!("causality step by step:  lanchester bondgraph causality {file}\n");
        out += &format!("equations:               lanchester bondgraph equations {file}\n");
    }
    out += &format!("a run with its curves:   lanchester bondgraph simulate {file} --figures figures\n");
    out += &format!("the drawing:             lanchester bondgraph draw {file} > graph.svg\n");
    out
}

/// A run with its states alone where it has many quantities, and how all are seen.
fn in_short(run: &Simulation) -> String {
    let (mut text, left_out) = simulation_text_in_short(run);
    if left_out > 0 {
        text += &format!(
            "and {left_out} more quantities: --all lists them, --figures draws curves, --format csv writes every sample\n"
        );
    }
    text
}

fn request(
    arguments: &BondgraphArguments,
    found: &Equations,
    audit: bool,
) -> Result<SimulationRequest, Failure> {
    let mut request = found.request();
    request.audit = audit;
    request.cancel = Some(Cancel(Interruptible::listening().flag()));
    if arguments.until.is_some() {
        let none = || {
            Failure::input(
                "the graph file does not say after what its motion repeats",
                "add period = \"20 ms\", or for example period = \"720 deg of theta\", to its [simulation]",
            )
        };
        request.periodic = Some(found.period().ok_or_else(none)?);
    }
    if let Some(text) = &arguments.duration {
        request.duration = lanchester::bondgraph::duration(text).ok_or_else(|| {
            Failure::input(format!("--for needs a time above 0, got \"{text}\""), "for example --for '2 s'")
        })?;
        request.periodic = None;
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
    if arguments.long {
        request.most_evaluations = u64::MAX;
    }
    request.method = arguments.method.map(|method| match method {
        MethodOption::Explicit => Method::Explicit,
        MethodOption::Implicit => Method::Implicit,
    });
    Ok(request)
}
