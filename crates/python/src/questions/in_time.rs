//! The crank train in time, and the closed form against runs and bond graph.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::guard::Watch;
use crate::options::Options;
use crate::question::{How, Question, Run};
use lanchester::bondgraph::{
    Cancel, CompliantJoints, EngineBlock, EngineJoints, Equations, Graph, Method, Notation, Simulation,
    SimulationRequest, causality_text, drawing, equations, equations_latex, equations_text, graph_file,
    modelica,
};
use lanchester::file::{StartOfRun, event_from_words, start_from_words};
use lanchester::model::NamedPoint;
use lanchester::multibody::{LoadLaw, ReactsOn};
use lanchester::report::{
    Condition, CrossCheck, SimulationResult, Table, bond_graph_figures, causality_tables, crosscheck_text,
    simulation_figures, simulation_tables, simulation_text,
};
use lanchester::{
    BondGraphRequest, CrossCheckRequest, RunLength, SimulateRequest, crosscheck, engine_bond_graph,
    simulate_watched,
};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

pub(super) const QUESTIONS: [Question; 3] = [
    Question::of::<SimulationResult>("simulate", How::Long, read_simulate),
    Question::of::<CrossCheck>("crosscheck", How::Long, read_crosscheck),
    Question::of::<BondGraph>("bondgraph", How::Long, read_bondgraph),
];

/// How long a run is by `revolutions`, `duration` or `periodic`; `None` where none of them is given.
fn run_length(options: &Options<'_>) -> Result<Option<RunLength>, Failure> {
    let positive = |value: Option<f64>, name: &str, of: &str| match value {
        Some(value) if value <= 0.0 => Err(Failure::option(
            format_args!("`{name}` needs {of} above 0, got {value}"),
            format_args!("leave `{name}` out for its usual value"),
        )),
        value => Ok(value),
    };
    let turns = positive(options.number("revolutions")?, "revolutions", "a number")?;
    let time = positive(options.time("duration")?, "duration", "a time")?;
    let periodic = options.flag("periodic")?.unwrap_or(false);
    match (periodic, turns, time) {
        (false, None, None) => Ok(None),
        (true, None, None) => Ok(Some(RunLength::Periodic)),
        (false, Some(turns), None) => Ok(Some(RunLength::Revolutions(turns))),
        (false, None, Some(time)) => Ok(Some(RunLength::Time(time))),
        _ => Err(Failure::option(
            "`revolutions`, `duration` and `periodic` each say how long a run is, and more than one is given",
            "give one of them",
        )),
    }
}

fn read_simulate(options: &Options<'_>) -> Result<Run, Failure> {
    let length = run_length(options)?;
    let load = load_law(options)?;
    let misfire = options.wholes("misfire", 1, 10_000)?;
    let start = options.text("start")?.map_or(Ok(StartOfRun::default()), |text| {
        start_from_words(&text)
            .map_err(|(message, hint)| Failure::option(format_args!("`start`: {message}"), hint))
    })?;
    let (speed, start_angle) = (options.start_speed("speed")?, options.angle("start_angle")?);
    for (name, twice) in [
        ("speed", speed.is_some() && start.speed.is_some()),
        ("start_angle", start_angle.is_some() && start.angle.is_some()),
    ] {
        if twice {
            return Err(Failure::option(
                format_args!("`{name}` and `start` both say the same of the start"),
                "give it in one of them",
            ));
        }
    }
    let events = options.texts("events")?;
    let points = options.points("points")?.into_iter();
    let points = points.map(|at| NamedPoint { name: at.map(|own| format!("{own} m")).join(", "), at });
    let request = SimulateRequest {
        speed: speed.or(start.speed),
        start_block: start.block,
        points: points.collect(),
        length,
        imposed: options.flag("imposed")?,
        on_mounts: options.flag("on_mounts")?,
        gravity: options.flag("gravity")?,
        gas: options.flag("gas")?,
        load,
        reacts_on: options.flag("load_on_block")?.unwrap_or(false).then_some(ReactsOn::Block),
        misfire: misfire.iter().map(|number| *number as usize - 1).collect(),
        step: options.angle("step")?,
        tolerance: options.number("tolerance")?,
        start_angle: start_angle.or(start.angle),
        long: options.flag("long")?.unwrap_or(false),
        ..SimulateRequest::default()
    };
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let count = own.engine().cylinders.len();
        if let Some(number) = request.misfire.iter().find(|number| **number >= count) {
            return Err(Failure::option(
                format_args!("`misfire` needs numbers of cylinders, from 1 to {count}, got {}", number + 1),
                "cylinders are numbered as in the file",
            ));
        }
        let mut request = request.clone();
        for text in &events {
            let (when, action) = text.split_once(':').ok_or_else(|| {
                Failure::option(
                    format_args!("`events` needs a moment and what happens, got \"{text}\""),
                    "write it like events=[\"3 revolutions: misfire 1\"]",
                )
            })?;
            let event = event_from_words(when, action, count)
                .map_err(|(message, hint)| Failure::option(format_args!("`events`: {message}"), hint))?;
            request.events.push(event);
        }
        let in_file = own.file.tasks.simulation.as_ref().and_then(|input| input.gas);
        let traces = match request.gas.or(in_file) {
            Some(false) => &[],
            _ => own.traces()?,
        };
        let found = simulate_watched(&own.file, traces, &request, &|_| watch.goes_on());
        Ok(Data::new(
            Simulated(found.map_err(Failure::refused)?),
            own,
            Shown {
                text: |Simulated(found), _| simulation_text(found),
                tables: |Simulated(found), _| simulation_tables(found),
                figures: |Simulated(found), _| simulation_figures(found, None),
                ..Shown::default()
            },
        ))
    }))
}

/// A run whose data are the samples that were asked for, and whose text and pictures know those between.
struct Simulated(SimulationResult);

impl Serialize for Simulated {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.written().serialize(serializer)
    }
}

fn read_crosscheck(options: &Options<'_>) -> Result<Run, Failure> {
    let conditions = [
        ("a", Condition::LikeForLike),
        ("b", Condition::FreeSpeed),
        ("c", Condition::MovingBlock),
        ("d", Condition::AllFree),
        ("e", Condition::FlexibleCrank),
    ];
    let bar = options.number("bar")?;
    if let Some(bar) = bar.filter(|bar| *bar <= 0.0) {
        return Err(Failure::option(
            format_args!("`bar` needs a share above 0, got {bar}"),
            "write it like 1e-10",
        ));
    }
    let request = CrossCheckRequest {
        speed: options.speed("speed")?,
        conditions: options.words("condition", &conditions)?,
        max_order: options.whole("orders", 1, 100)?.map_or(4, |order| order as u32),
        bar,
        simulation: None,
    };
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = CrossCheckRequest { simulation: own.file.tasks.simulation.clone(), ..request.clone() };
        let found = crosscheck(own.engine(), own.traces()?, &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| crosscheck_text(found),
                tables: |found, _| found.conditions.iter().map(|condition| condition.table()).collect(),
                ..Shown::default()
            },
        ))
    }))
}

/// The bond graph of an engine: its file, its causality and its equations.
#[derive(Debug, Serialize, JsonSchema)]
struct BondGraph {
    /// Name of the engine.
    engine: String,
    /// The graph file.
    graph: String,
    /// What the engine file does not say and was assumed.
    notes: Vec<String>,
    /// The causality, step by step, in words.
    causality: String,
    /// The equations as text.
    equations: String,
    /// The equations as a LaTeX document.
    latex: String,
    /// The graph as a model of Modelica.
    modelica: String,
    /// The drawing of the graph with its causality, as SVG.
    drawing: String,
    /// A run of the graph, where one is asked for.
    run: Option<Simulation>,
    /// States, and stores that follow others.
    #[serde(skip)]
    #[schemars(skip)]
    tables: Vec<Table>,
}

/// A run of the graph that is asked for.
#[derive(Clone, Copy)]
struct AskedRun {
    length: Option<RunLength>,
    samples: Option<usize>,
    tolerance: Option<f64>,
    audit: bool,
    method: Option<Method>,
}

impl AskedRun {
    fn read(options: &Options<'_>) -> Result<AskedRun, Failure> {
        let asked = AskedRun {
            length: run_length(options)?,
            samples: options.whole("samples", 1, 1_000_000)?.map(|count| count as usize),
            tolerance: options.number("tolerance")?,
            audit: options.flag("audit")?.unwrap_or(false),
            method: options
                .word("method", &[("explicit", Method::Explicit), ("implicit", Method::Implicit)])?,
        };
        if let Some(tolerance) = asked.tolerance.filter(|own| !(1e-13..=1e-2).contains(own)) {
            return Err(Failure::option(
                format_args!("`tolerance` is outside 1e-13 to 0.01, got {tolerance}"),
                "for example tolerance=1e-9",
            ));
        }
        let of_run = [
            ("samples", asked.samples.is_some()),
            ("tolerance", asked.tolerance.is_some()),
            ("audit", asked.audit),
            ("method", asked.method.is_some()),
        ];
        match of_run.into_iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) if asked.length.is_none() => Err(Failure::option(
                format_args!("`{name}` is that of a run, and none is asked for"),
                "add revolutions=2, duration=\"0.1 s\" or periodic=True",
            )),
            _ => Ok(asked),
        }
    }

    fn request(self, solved: &Equations, watch: &Watch) -> SimulationRequest {
        let usual = solved.request();
        SimulationRequest {
            samples: self.samples.unwrap_or(usual.samples),
            tolerance: self.tolerance.unwrap_or(usual.tolerance),
            audit: self.audit,
            method: self.method,
            cancel: Some(Cancel(watch.flag())),
            ..usual
        }
    }
}

/// A constant torque, `"none"`, or nothing.
fn load_law(options: &Options<'_>) -> Result<Option<LoadLaw>, Failure> {
    Ok(match options.text("load") {
        Ok(Some(text)) if text.trim() == "none" => Some(LoadLaw::None),
        _ => options.torque("load")?.map(LoadLaw::Constant),
    })
}

/// Joints of the crank train in a bond graph.
fn joints(options: &Options<'_>) -> Result<EngineJoints, Failure> {
    let compliant = options.word("joints", &[("ideal", false), ("compliant", true)])?.unwrap_or(false);
    if !compliant {
        let of_compliant = ["joint_stiffness", "skirt_stiffness", "skirt_offset", "joint_damping"];
        return match of_compliant.into_iter().find(|name| options.is_given(name)) {
            Some(name) => Err(Failure::option(
                format_args!("`{name}` is that of compliant joints"),
                format_args!("add joints=\"compliant\", or leave `{name}` out"),
            )),
            None => Ok(EngineJoints::Ideal),
        };
    }
    let usual = CompliantJoints::default();
    let damping_ratio = options.number("joint_damping")?.unwrap_or(usual.damping_ratio);
    if !(0.0..=10.0).contains(&damping_ratio) {
        return Err(Failure::option(
            format_args!("`joint_damping` is outside 0 to 10, got {damping_ratio}"),
            "for example joint_damping=0.2",
        ));
    }
    Ok(EngineJoints::Compliant(CompliantJoints {
        stiffness: options.stiffness("joint_stiffness")?.unwrap_or(usual.stiffness),
        skirt_stiffness: options.stiffness("skirt_stiffness")?.unwrap_or(usual.skirt_stiffness),
        skirt_offset: options.length("skirt_offset")?.unwrap_or(usual.skirt_offset),
        damping_ratio,
        ..usual
    }))
}

fn read_bondgraph(options: &Options<'_>) -> Result<Run, Failure> {
    let blocks = [
        ("fixed", EngineBlock::Fixed),
        ("plane", EngineBlock::Plane),
        ("space", EngineBlock::Space),
        ("held", EngineBlock::Held),
    ];
    let plain = BondGraphRequest {
        speed: options.speed("speed")?,
        block: options.word("block", &blocks)?,
        joints: joints(options)?,
        gas: options.flag("gas")?.unwrap_or(true),
        gas_as_states: options.flag("gas_states")?.unwrap_or(false),
        gravity: options.flag("gravity")?.unwrap_or(true),
        imposed: options.flag("imposed")?,
        load: load_law(options)?,
        load_on_block: options.flag("load_on_block")?.unwrap_or(false),
        ..BondGraphRequest::default()
    };
    let asked = AskedRun::read(options)?;
    Ok(Box::new(move |engines, watch| {
        let own = &engines[0];
        let mut simulation = own.file.tasks.simulation.as_deref().cloned().unwrap_or_default();
        simulation.duration = asked.length.or(simulation.duration);
        let request = BondGraphRequest { simulation, ..plain.clone() };
        let traces = if request.gas { own.traces()? } else { &[] };
        let found = engine_bond_graph(own.engine(), traces, &request).map_err(Failure::refused)?;
        let file = graph_file(&found.description);
        let mistakes =
            |diagnostics| Failure::Mistakes { name: "bond graph".into(), text: file.clone(), diagnostics };
        let graph = Graph::new(&found.description).map_err(mistakes)?;
        let solved = equations(&graph).map_err(mistakes)?;
        let shown = solved.shown(Notation::Text);
        let answer = BondGraph {
            tables: causality_tables(&shown, &solved.causality),
            engine: own.engine().name.clone(),
            notes: found.notes,
            causality: causality_text(&graph, &solved.causality),
            equations: equations_text(&shown),
            latex: equations_latex(&solved.shown(Notation::Latex)),
            modelica: modelica(&solved),
            drawing: drawing(&graph, &solved.causality),
            run: asked.length.map(|_| solved.simulate(&asked.request(&solved, watch))),
            graph: file.clone(),
        };
        Ok(Data::new(
            answer,
            own,
            Shown {
                text: |found, _| {
                    let words = format!("{}\n{}", found.causality, found.equations);
                    match &found.run {
                        Some(run) => format!("{words}\n{}", lanchester::bondgraph::simulation_text(run)),
                        None => words,
                    }
                },
                tables: |found, _| found.tables.clone(),
                figures: |found, _| found.run.as_ref().map_or_else(Vec::new, bond_graph_figures),
                drawing: |found| {
                    let title = format!("Bond graph of {}", found.engine);
                    Some(["bond-graph".to_owned(), title, found.drawing.clone()])
                },
                ..Shown::default()
            },
        ))
    }))
}
