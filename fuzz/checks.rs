//! What must hold for any input: shared by the fuzz targets and by the test that replays the kept corpus.

use lanchester::multibody::{Samples, Wrench};
use lanchester::{SimulateRequest, simulate_watched};
use lanchester_balance::{Outcome, optimise};
use lanchester_bondgraph::{Graph, SimulationRequest, drawing, equations, modelica};
use lanchester_file::workshop::read_sheet;
use lanchester_file::{EngineFile, expanded, read as read_text, render, templates};
use lanchester_mechanism::{LoadError, LoadRequest, loads as loads_of};
use lanchester_model::Engine;
use lanchester_results::LoadSet;
use lanchester_workshop::{correction, drilling, grade};
use std::cell::Cell;

/// Any bytes, read as an engine file: mistakes can be shown, and what is accepted survives its expanded form.
pub fn read(data: &[u8]) {
    accepted(&String::from_utf8_lossy(data));
}

/// A template with some of its lines changed: whatever is accepted has finite loads.
pub fn loads(data: &[u8]) {
    let all: Vec<&str> = templates().iter().map(|template| template.text).chain([PARTS]).collect();
    let text = changed(&all, &ADDITIONS, data);
    let Some(engine) = accepted(&text) else { return };
    // Few angles: the kernels are the same for each.
    let request = LoadRequest { samples: 24, ..LoadRequest::default() };
    let loads = match loads_of(&engine, &request) {
        Ok(loads) => loads,
        // A valid engine may still be too large for the range of numbers, or repeat too late.
        Err(LoadError::NotFinite { .. } | LoadError::PeriodTooLong { .. }) => return,
        Err(error) => panic!("the reader accepts what the loads refuse: {error}\n{text}"),
    };
    assert!(finite(&loads.total), "loads that are not finite of\n{text}");
    for part in &loads.parts {
        assert!(finite(&part.loads), "{:?} is not finite of\n{text}", part.part);
    }
}

/// A worked workshop sheet with some of its lines changed: whatever is read is answered with finite numbers or refused.
pub fn workshop(data: &[u8]) {
    let text = changed(&SHEETS, &SHEET_ADDITIONS, data);
    let reading = read_sheet(&text);
    let Some(sheet) = reading.sheet else {
        assert!(!reading.diagnostics.is_empty(), "refused without a reason:\n{text}");
        return;
    };
    if let Ok(found) = correction(&sheet) {
        for plane in &found.planes {
            assert!(plane.unbalance.is_finite() && plane.left.is_finite(), "{plane:?} of\n{text}");
        }
    }
    if let Ok(found) = drilling(&sheet) {
        for plane in &found.planes {
            let far = plane.left.norm() > plane.wanted.norm() * (1.0 + 1e-9);
            assert!(plane.left.is_finite() && !far, "holes make it worse: {plane:?} of\n{text}");
        }
    }
    if let Ok(found) = grade(&sheet) {
        assert!(found.permissible.is_finite(), "{found:?} of\n{text}");
    }
}

/// A small engine with some of its lines and of its section `[balance]` changed: an optimum keeps its own limits and is
/// finite, whatever is read.
pub fn balance(data: &[u8]) {
    let text = changed(&TASKS, &TASK_ADDITIONS, data);
    let Some(EngineFile { engine, tasks }) = accepted_file(&text) else { return };
    let Some(task) = &tasks.balance else { return };
    // Choices multiply, and this must end soon.
    if engine.cylinders.len() > 4 || task.weights.len() > 8 {
        return;
    }
    let Ok(answer) = optimise(&engine, task) else { return };
    let found = answer.weights.iter().all(|weight| weight.unbalance.is_finite() && weight.z.is_finite());
    assert!(found, "weights that are not finite: {:?} of\n{text}", answer.weights);
    if answer.outcome != Outcome::Optimal {
        return;
    }
    for stage in &answer.stages {
        let terms: f64 = stage.terms.iter().map(|(_, value)| value.abs()).sum();
        assert!(
            stage.value.is_finite() && stage.lower_bound <= stage.value + 1e-6 * terms,
            "{stage:?} of\n{text}"
        );
    }
}

/// A bond graph with some of its lines changed: it is refused with a fix for each mistake, or runs to an end within its bound.
pub fn graph(data: &[u8]) {
    let text = changed(&GRAPHS, &GRAPH_ADDITIONS, data);
    let graph = match Graph::read(&text) {
        Ok(graph) => graph,
        Err(mistakes) => {
            let fixed = !mistakes.is_empty() && mistakes.iter().all(|mistake| mistake.hint.is_some());
            assert!(fixed, "refused without a reason or a fix: {mistakes:?}\n{text}");
            return;
        }
    };
    let Ok(found) = equations(&graph) else { return };
    assert!(drawing(&graph, &found.causality).starts_with("<svg") && modelica(&found).starts_with("model "));
    if let Ok(linear) = found.linear() {
        assert!(linear.a.iter().flatten().all(|entry| entry.is_finite()), "A of\n{text}");
    }
    let asked = SimulationRequest { samples: 3, audit: true, most_evaluations: 3000, ..found.request() };
    let run = found.simulate(&asked);
    let states = found.causality.states.len();
    for series in run.series.iter().take(states) {
        assert!(
            series.values.iter().all(|value| value.is_finite()),
            "{} is not finite of\n{text}",
            series.name
        );
    }
}

/// An engine with some of its keys of runs in time changed: what is read is refused with words, or runs within its bound, and every sample is finite.
pub fn simulate(data: &[u8]) {
    let text = changed(&RUNS, &RUN_ADDITIONS, data);
    let Some(file) = accepted_file(&text) else { return };
    // Samples by the million are another matter than keys.
    let step = file.tasks.simulation.as_ref().and_then(|simulation| simulation.step);
    if step.is_some_and(|step| step < 1e-3) {
        return;
    }
    let steps = Cell::new(0);
    let watch = |_| {
        steps.set(steps.get() + 1);
        steps.get() < 1500
    };
    let found = match simulate_watched(&file, &[], &SimulateRequest::default(), &watch) {
        Ok(found) => found,
        Err(error) => {
            assert!(!error.to_string().is_empty(), "refused without a reason:\n{text}");
            return;
        }
    };
    if let Some(what) = infinite(&found.run.samples) {
        panic!("{what} is not finite ({:?}) of\n{text}", found.run.outcome);
    }
}

/// A series of a run that is not finite.
fn infinite(samples: &Samples) -> Option<&'static str> {
    let numbers = |series: &[f64]| series.iter().all(|value| value.is_finite());
    let vectors = |series: &[[f64; 3]]| series.iter().flatten().all(|value| value.is_finite());
    let wrench = |wrench: &Wrench| vectors(&[wrench.force, wrench.moment]);
    let reactions = samples.reactions.iter().all(|own| {
        own.cylinders
            .iter()
            .all(|cylinder| [cylinder.wall, cylinder.piston_pin, cylinder.lower_pin].iter().all(wrench))
            && own.rotors.iter().all(|rotor| wrench(&rotor.bearings) && rotor.gear_torque.is_finite())
            && wrench(&own.on_block)
            && own.shaft_torque.is_finite()
    });
    let mounts = samples.mounts.iter().all(|mounts| vectors(mounts));
    let checked = [
        ("time", numbers(&samples.time)),
        ("crank angle", numbers(&samples.theta)),
        ("speed", numbers(&samples.speed)),
        ("acceleration", numbers(&samples.acceleration)),
        ("torque of the load", numbers(&samples.load_torque)),
        ("place of the block", vectors(&samples.position)),
        ("spin of the block", vectors(&samples.spin)),
        ("force of the mounts", mounts),
        ("a reaction", reactions),
    ];
    checked.into_iter().find(|(_, is_finite)| !is_finite).map(|(what, _)| what)
}

/// What an empty input leaves as it is must be accepted: a check of texts that are all refused would check nothing.
#[cfg(test)]
pub fn unchanged() {
    let templates = templates().iter().map(|template| template.text);
    for text in templates.chain([PARTS]).chain(RUNS).chain(TASKS) {
        assert!(accepted(text).is_some(), "refused:\n{}", {
            let reading = read_text(text);
            render(&reading.diagnostics, "engine.toml", text, false)
        });
    }
    for text in SHEETS {
        assert!(read_sheet(text).sheet.is_some(), "refused:\n{text}");
    }
    for text in GRAPHS {
        assert!(Graph::read(text).is_ok(), "refused:\n{text}");
    }
    for text in TASKS {
        let file = accepted_file(text).unwrap();
        let answer = optimise(&file.engine, file.tasks.balance.as_ref().unwrap());
        assert!(answer.is_ok_and(|answer| answer.outcome == Outcome::Optimal), "no optimum of\n{text}");
    }
}

/// Engines with what runs in time have.
const RUNS: [&str; 3] = [
    include_str!("runs/governed.toml"),
    include_str!("runs/imposed.toml"),
    include_str!("runs/driveline.toml"),
];
const RUN_ADDITIONS: [&str; 9] = [
    "\n[[simulation.event]]\nwhen = \"speed rises to 1000 rpm\"\ndo = \"load none\"\n",
    "\n[[simulation.event]]\nwhen = \"0 s\"\ndo = \"fuel 0 %\"\n",
    "\n[[simulation.event]]\nwhen = \"400 deg\"\ndo = \"clutch open\"\n",
    "\n[[driveline]]\ninertia = \"0.2 kg m2\"\nstiffness = \"9 kN m/rad\"\n",
    "\n[load]\ntype = \"viscous\"\ntorque = \"20 N m\"\nat = \"1000 rpm\"\n",
    "\n[starter]\nstall_torque = \"9 N m\"\nfree_speed = \"3000 rpm\"\nratio = 10\nuntil = \"300 rpm\"\n",
    "\n[governor]\nspeed = \"1200 rpm\"\ngain = \"0.01 1/rpm\"\n",
    "\n[friction]\nfmep = \"0.8 bar\"\npiston_damping = \"30 N s/m\"\n",
    "\n[gas]\ncompression_ratio = 8\n[gas.cycle]\ntype = \"sealed\"\npressure = \"2 bar\"\n",
];

/// Shipped graphs.
const GRAPHS: [&str; 14] = [
    include_str!("../examples/bond-graphs/mass-spring-damper.toml"),
    include_str!("../examples/bond-graphs/dc-motor.toml"),
    include_str!("../examples/bond-graphs/two-tanks.toml"),
    include_str!("../examples/bond-graphs/two-tanks-turbulent.toml"),
    include_str!("../examples/bond-graphs/slider-crank.toml"),
    include_str!("../examples/bond-graphs/slider-crank-elastic.toml"),
    include_str!("../examples/bond-graphs/torsion-chain.toml"),
    include_str!("../examples/bond-graphs/gear-train.toml"),
    include_str!("../examples/bond-graphs/hydraulic-press.toml"),
    include_str!("../examples/bond-graphs/thermal-chain.toml"),
    include_str!("../examples/bond-graphs/double-pendulum.toml"),
    include_str!("../examples/bond-graphs/double-pendulum-stiff.toml"),
    include_str!("../examples/bond-graphs/prismatic-pair.toml"),
    include_str!("../examples/bond-graphs/single-cylinder.toml"),
];
const GRAPH_ADDITIONS: [&str; 9] = [
    "\n[tables.more]\npoints = [[0, 1], [2, 3], [4, 1]]\nperiodic = true\n",
    "\n[tables.more]\npieces = [[0, 1, 2, 3, 4], [1, 0, 0, 0, 0]]\nend = 2\ny_unit = \"N m\"\n",
    "\n[elements.more]\nkind = \"Gas\"\ngas_constant = \"287 J/kg/K\"\nheat_capacity = \"720 J/kg/K\"\nvolume = \"1 l\"\n",
    "\n[elements.other]\nkind = \"R\"\nflow = [\"e1 - e2\", \"e2 - e1\"]\n",
    "\n[elements.field]\nkind = \"I\"\ncoenergy = \"2 kg*f1*f2\"\n",
    "\n[signals.level]\nintegral_of = \"1 - level\"\nstart = \"0 s\"\n",
    "\n[[event]]\nwhen = \"t - 0.1 s\"\nset = { \"mass.momentum\" = \"-mass.momentum\" }\n",
    "\n[relax]\npiston = { stiffness = \"1e8 N/m\", damping = \"100 N s/m\" }\n",
    "\n[[use]]\ngraph = \"part.toml\"\nas = \"own\"\n",
];

/// Worked sheets.
const SHEETS: [&str; 2] = [
    include_str!("../examples/workshop/two-plane-crank.toml"),
    include_str!("../examples/workshop/machine-display.toml"),
];
const SHEET_ADDITIONS: [&str; 6] = [
    "\n[[plane]]\nname = \"third\"\nz = \"150 mm\"\nradius = \"40 mm\"\n",
    "\n[[run]]\nspeed = \"1500 rpm\"\nreadings = [{ sensor = \"front\", velocity = \"3 mm/s\", phase = \"10 deg\" }]\n",
    "\n[[run]]\nspeed = \"1500 rpm\"\nweights = [{ plane = \"rear\", mass = \"3 g\", angle = \"9 deg\", kept = true }]\n\
     readings = [{ sensor = \"rear\", velocity = \"0 mm/s\", phase = \"1 deg\" }]\n",
    "\n[[display]]\nkind = \"couple\"\nplanes = [\"0 mm\", \"90 mm\"]\nunbalance = \"7 g mm\"\nangle = \"3 deg\"\n",
    "\n[[sensor]]\nname = \"side\"\ndetector = \"peak\"\nlimit = { displacement = \"5 um\" }\n",
    "\n[plane.drill]\ndirection = \"axial\"\ndiameters = [\"5 mm\"]\nmax_depth = \"9 mm\"\ndensity = \"7.85 g/cm3\"\nland = \"1 mm\"\nspacing = \"8 mm\"\n",
];

/// Small engines with a section `[balance]`.
const TASKS: [&str; 3] = [
    "name = \"single\"\nspeed = \"6000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\nspacing = \"90 mm\"\n\
     [crank]\nstroke = \"66 mm\"\nunbalance = \"10 g m\"\n[piston]\nmass = \"0.3 kg\"\n[rod]\nlength = \"120 mm\"\nmass = \"0.35 kg\"\n\
     [[mount]]\nx = \"0 mm\"\ny = \"-80 mm\"\nz = \"0 mm\"\n[[mount]]\nx = \"0 mm\"\ny = \"90 mm\"\nz = \"40 mm\"\n\
     [balance]\nminimise = [\"force\"]\nlimits = { \"roll moment\" = \"120 N m\" }\n\
     [[balance.counterweight]]\nthrow = 1\nmost = \"30 g m\"\n\
     [[balance.shaft]]\nratio = -1\nx = \"10 mm\"\ny = \"70 mm\"\nweights = [{ z = \"0 mm\", most = \"9 g m\" }]\n",
    "name = \"twin\"\nspeed = \"7000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 2\nspacing = \"90 mm\"\n\
     crank_angles = [\"0 deg\", \"180 deg\"]\n[crank]\nstroke = \"66 mm\"\n[piston]\nmass = \"0.3 kg\"\n\
     [rod]\nlength = \"120 mm\"\nmass = \"0.35 kg\"\n\
     [balance]\nminimise = [\"couple\", \"added unbalance\"]\nlimits = { force = \"9000 N\" }\n\
     [[balance.counterweight]]\nname = \"front\"\nthrow = 1\nline = \"180 deg\"\n\
     [[balance.counterweight]]\nname = \"rear\"\nthrow = 2\nmirrored_to = \"front\"\n",
    "name = \"three\"\nspeed = \"6000 rpm\"\n[firing]\norder = [1, 3, 2]\n[layout]\ntype = \"in-line\"\ncylinders = 3\nspacing = \"82 mm\"\n\
     [crank]\nstroke = \"81 mm\"\n[piston]\nmass = \"0.32 kg\"\n[rod]\nlength = \"138 mm\"\nmass = \"0.45 kg\"\n\
     [balance]\nminimise = [{ couple = \"100 N m\", \"bending moment\" = \"300 N m\" }]\nmost_optional = 1\n\
     [[balance.counterweight]]\nthrow = 1\nmost = \"30 g m\"\noptional = true\n\
     [[balance.counterweight]]\nthrow = 3\nleast = \"1 g m\"\nmost = \"30 g m\"\noptional = true\n",
];
const TASK_ADDITIONS: [&str; 6] = [
    "\n[[balance.counterweight]]\nz = [\"-60 mm\", \"60 mm\"]\nmost = \"20 g m\"\n",
    "\n[[balance.counterweight]]\nz = \"12 mm\"\nangle = \"30 deg\"\n",
    "\n[[balance.shaft]]\nratio = -2\ny = \"80 mm\"\nweights = [{ z = \"-50 mm\" }, { z = \"50 mm\" }]\n",
    "\n[[balance.shaft]]\nratio = 2\ny = \"-80 mm\"\noptional = true\nweights = [{ z = \"0 mm\", most = \"3 g m\" }]\n",
    "\n[[balance.inertia]]\nratio = 2.5\ncrank_inertia = \"0.2 kg m2\"\nmost = \"0.02 kg m2\"\n",
    "\n[[counterweight]]\nthrow = 1\nunbalance = \"9 g m\"\n",
];

/// Reads a file; what is refused has a reason that can be shown, what is accepted has an equal expanded form.
fn accepted(text: &str) -> Option<Engine> {
    accepted_file(text).map(|file| file.engine)
}

/// As [`accepted`], with what is asked of the engine.
fn accepted_file(text: &str) -> Option<EngineFile> {
    let reading = read_text(text);
    let shown = render(&reading.diagnostics, "engine.toml", text, false);
    let Some(file) = reading.file else {
        assert!(!shown.is_empty(), "refused without a reason:\n{text}");
        return None;
    };
    let form = expanded(&file);
    let again = read_text(&form);
    let mistakes = render(&again.diagnostics, "expanded.toml", &form, false);
    assert_eq!(
        again.file.as_ref(),
        Some(&file),
        "the expanded form reads differently\n{mistakes}\n{text}\n---\n{form}"
    );
    Some(file)
}

fn finite(loads: &LoadSet) -> bool {
    let trace = &loads.trace;
    let curves = [
        &trace.force_x,
        &trace.force_y,
        &trace.couple_x,
        &trace.couple_y,
        &trace.roll_moment,
        &trace.shaft_torque,
    ];
    curves.iter().all(|curve| curve.iter().all(|value| value.is_finite()))
        && loads.orders.iter().all(|order| {
            order.force_forward.is_finite()
                && order.force_backward.is_finite()
                && order.couple_forward.is_finite()
                && order.couple_backward.is_finite()
                && order.roll_moment.is_finite()
                && order.shaft_torque.is_finite()
        })
        && [&loads.peaks.force, &loads.peaks.couple, &loads.peaks.roll_moment, &loads.peaks.shaft_torque]
            .iter()
            .all(|peak| peak.max.value.is_finite() && peak.min.value.is_finite())
}

const NUMBERS: [&str; 20] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "3",
    "0.5",
    "1/2",
    "-2/3",
    "1e-300",
    "1e300",
    "-1e300",
    "1e-12",
    "1e9",
    "nan",
    "inf",
    "79,5",
    "360",
    "99999999999999999999",
    "0x10",
];
const UNITS: [&str; 12] = ["mm", "m", "in", "kg", "g", "deg", "rad", "rpm", "kg m", "%", "kg mm2", "furlong"];
const WORDS: [&str; 16] = [
    "in-line",
    "v",
    "boxer",
    "flat",
    "vr",
    "w",
    "radial",
    "shared",
    "split",
    "separate",
    "side-by-side",
    "fork-and-blade",
    "articulated",
    "webs",
    "alternating",
    "reverse",
];
/// A crankshaft as a body, and counterweights as parts.
const PARTS: &str = include_str!("../crates/file/tests/files/crank-as-body.toml");
const ADDITIONS: [&str; 9] = [
    "\n[counterweights]\nreciprocating_share = \"50 %\"\n",
    "\n[[counterweight]]\nthrow = 2\nmass = \"1 kg\"\nradius = \"40 mm\"\nangle = \"170 deg\"\n",
    "\n[[shaft]]\nratio = \"-3/2\"\ny = \"80 mm\"\nx = \"-20 mm\"\nweights = [{ z = \"10 mm\", unbalance = \"2 g m\" }]\n",
    "\n[[cylinder]]\nnumber = 2\noffset = \"11 mm\"\nrod = { mass = \"0.7 kg\", inertia = \"3000 kg mm2\" }\n",
    "\n[[mount]]\nx = \"1 in\"\ny = \"0 mm\"\nz = \"-88 mm\"\n",
    "\n[cylinders]\noffset = \"8 mm\"\n",
    "\n[crank.body]\ndensity = \"7850 kg/m3\"\njournal_diameter = \"30 mm\"\npin_diameter = \"30 mm\"\nweb_thickness = \"9 mm\"\n\
     web_radius = \"30 mm\"\npin_end_radius = \"25 mm\"\nend_journals = \"20 mm\"\n",
    "\n[[counterweight]]\nweb = 2\n[counterweight.shape]\nthickness = \"12 mm\"\ndensity = \"7.2 g/cm3\"\nweb_radius = \"30 mm\"\n\
     rectangle_height = \"12 mm\"\nshoulder_height = \"9 mm\"\narc_radius = \"60 mm\"\narc_angle = \"120 deg\"\n",
    "\n[[counterweight]]\nthrow = 1\nshape = { thickness = \"9 mm\", density = \"7.2 g/cm3\", outline = [{ x = \"9 mm\", y = \"-9 mm\" }, \
     { x = \"50 mm\", y = \"0 mm\", bulge = 0.3 }, { x = \"9 mm\", y = \"9 mm\" }], inserts = [{ x = \"20 mm\", y = \"0 mm\", radius = \"3 mm\" }] }\n",
];

/// The first byte chooses the text; each further three bytes make one change: kind, line, argument.
fn changed(all: &[&str], more: &[&str], data: &[u8]) -> String {
    let first = data.first().copied().unwrap_or(0);
    let mut lines: Vec<String> = all[usize::from(first) % all.len()].lines().map(str::to_owned).collect();
    let mut additions = String::new();
    for change in data.get(1..).unwrap_or_default().chunks_exact(3).take(16) {
        let (kind, argument) = (change[0] % 8, usize::from(change[2]));
        let at = usize::from(change[1]) % lines.len().max(1);
        let Some(line) = lines.get(at).cloned() else { break };
        match kind {
            // Most changes keep the file plausible, so that the load path is reached.
            0..=2 => {
                lines[at] =
                    with_number(&line, |number| format!("{:.4}", number * (0.25 + argument as f64 / 128.0)))
            }
            3 => lines[at] = with_number(&line, |_| NUMBERS[argument % NUMBERS.len()].to_owned()),
            4 => lines[at] = with_word(&line, argument),
            5 => {
                lines.remove(at);
            }
            6 => lines.insert(at, line),
            _ => additions += more[argument % more.len()],
        }
    }
    lines.join("\n") + "\n" + &additions
}

/// The line with the first number behind its `=` replaced.
fn with_number(line: &str, change: impl Fn(f64) -> String) -> String {
    let Some(equals) = line.find('=') else { return line.to_owned() };
    let digit = |c: char| c.is_ascii_digit() || c == '.';
    let Some(start) = line[equals..].find(digit).map(|start| start + equals) else { return line.to_owned() };
    let end = line[start..].find(|c: char| !digit(c)).map_or(line.len(), |end| end + start);
    let number = line[start..end].parse().unwrap_or(1.0);
    format!("{}{}{}", &line[..start], change(number), &line[end..])
}

/// The line with its unit, or its first quoted word, replaced.
fn with_word(line: &str, argument: usize) -> String {
    let Some(open) = line.find('"') else { return line.to_owned() };
    let Some(close) = line[open + 1..].find('"').map(|close| close + open + 1) else {
        return line.to_owned();
    };
    let inner = &line[open + 1..close];
    let replaced = match inner.split_once(' ') {
        Some((number, _)) if number.starts_with(|c: char| c.is_ascii_digit() || c == '-') => {
            format!("{number} {}", UNITS[argument % UNITS.len()])
        }
        _ => WORDS[argument % WORDS.len()].to_owned(),
    };
    format!("{}{replaced}{}", &line[..open + 1], &line[close..])
}
