//! The pages and pictures that the program writes, but for those of the theory.

use super::written::Written;

/// The page of published numbers.
pub const PUBLISHED: &str = "docs/src/validation.md";

/// Pages and pictures of the book, and the picture of the README.
pub const WRITTEN: [Written; 38] = [
    Written::page("crates/studio/page/src/api/types.ts", "", &["studio", "--describe", "typescript"]),
    Written::page("crates/studio/openapi.json", "", &["studio", "--describe", "openapi"]),
    Written::page(
        "docs/src/engine-file.md",
        "# The engine file\n\nEvery table and key, as the reader knows them. `lanchester schema` gives the same to an editor.\n\n",
        &["schema", "--markdown"],
    ),
    Written::page(
        "docs/src/workshop-sheet.md",
        "# The workshop sheet\n\nEvery table and key. `lanchester schema --sheet` gives the same to an editor; the guide shows one [step by \
               step](guide/workshop.md).\n\n",
        &["schema", "--sheet", "--markdown"],
    ),
    Written::page("validation/suite.schema.json", "", &["schema", "--suite"]),
    Written::page(PUBLISHED, "", &["validate", "--markdown"]),
    Written::figure(
        "docs/images/twin-spectrum.svg",
        &["report", "examples/twin-in-line-in-phase.toml", "--output", "-"],
        "force-spectrum.svg",
    ),
    Written::figure(
        "docs/src/images/production.svg",
        &["scatter", "examples/in-line-4-production.toml"],
        "scatter.svg",
    ),
    Written::figure("docs/src/images/arrangements.svg", &TWIN_SEARCH, "arrangements.svg"),
    Written::figure("docs/src/images/arrangement-drives.svg", &TWIN_SEARCH, "drives.svg"),
    Written::figure(
        "docs/src/images/counterweight.svg",
        &["counterweight", "design", "examples/in-line-3-counterweights.toml"],
        "counterweight-web-1-web-2.svg",
    ),
    Written::figure(
        "docs/src/images/counterweight-front.svg",
        &["counterweight", "front", "examples/in-line-3-counterweights.toml"],
        "counterweight-front.svg",
    ),
    Written::figure("docs/src/images/layout-front.svg", &V6_SEARCH, "layout-front.svg"),
    drawn("docs/src/images/bond-graph-slider-crank.svg", &DRAWN_SLIDER),
    drawn("docs/src/images/bond-graph-prismatic-pair.svg", &DRAWN_PAIR),
    drawn("docs/src/images/bond-graph-three-cylinder.svg", &DRAWN_ENGINE),
    graph_run("docs/src/images/bond-graph-pressures.svg", &RUN_UP, "bond-graph-pressures.svg"),
    graph_run("docs/src/images/bond-graph-loops.svg", &RUN_UP, "bond-graph-loops.svg"),
    graph_run("docs/src/images/bond-graph-speed.svg", &TO_SPEED, "bond-graph-speed.svg"),
    graph_run("docs/src/images/bond-graph-pressures-four.svg", &RUN_UP_FOUR, "bond-graph-pressures.svg"),
    graph_run("docs/src/images/bond-graph-loops-four.svg", &RUN_UP_FOUR, "bond-graph-loops.svg"),
    graph_run("docs/src/images/bond-graph-speed-four.svg", &TO_SPEED_FOUR, "bond-graph-speed.svg"),
    graph_run("docs/src/images/bond-graph-tilt.svg", &TILT, "bond-graph-tilt.svg"),
    graph_run("docs/src/images/bond-graph-block-without.svg", &ROCKING_WITHOUT, "bond-graph-block.svg"),
    graph_run("docs/src/images/bond-graph-block-with.svg", &ROCKING_WITH, "bond-graph-block.svg"),
    graph_run("docs/src/images/bond-graph-second-order.svg", &SHAFT_FORCES, "bond-graph-second-order.svg"),
    graph_run("docs/src/images/bond-graph-shafts.svg", &SHAFT_FORCES, "bond-graph-shafts.svg"),
    simulated("docs/src/images/simulated-speed.svg", "simulated-speed.svg"),
    simulated("docs/src/images/simulated-events.svg", "simulated-events.svg"),
    simulated("docs/src/images/simulated-misfire.svg", "simulated-change-5.svg"),
    simulated("docs/src/images/simulated-energy.svg", "simulated-energy.svg"),
    Written::figure("docs/src/images/simulated-period-energy.svg", &PERIOD, "simulated-period-energy.svg"),
    story("docs/src/images/balanced-twin.svg", "twin.toml"),
    story("docs/src/images/balanced-three.svg", "three.toml"),
    story("docs/src/images/balanced-v6.svg", "v6.toml"),
    blind("docs/src/images/counterweights-four.svg", &BLIND_FOUR),
    blind("docs/src/images/counterweights-six.svg", &BLIND_SIX),
    blind("docs/src/images/counterweights-v8.svg", &BLIND_V8),
];

/// A run whose last period begins with the fuel.
const PERIOD: [&str; 2] = ["simulate", "examples/three-cylinder.toml"];

/// An engine of the gallery with the lightest weights that leave the least force and couple, before and after.
const fn blind(file: &'static str, arguments: &'static [&'static str]) -> Written {
    Written::figure(file, arguments, "consequences.svg")
}

const BLIND_FOUR: [&str; 5] = blind_to("crates/file/templates/in-line-4.toml");
const BLIND_SIX: [&str; 5] = blind_to("crates/file/templates/in-line-6.toml");
const BLIND_V8: [&str; 5] = blind_to("crates/file/templates/v8-crossplane.toml");

/// Force, couple and then the least weights: the main bearings are not asked.
const fn blind_to(engine: &'static str) -> [&'static str; 5] {
    ["balance", engine, "--minimise=force", "--minimise=couple", "--minimise=added unbalance"]
}

/// Bond graphs of the guide.
const fn drawn(file: &'static str, arguments: &'static [&'static str]) -> Written {
    Written::page(file, "", arguments)
}

const DRAWN_SLIDER: [&str; 3] = ["bondgraph", "draw", "examples/bond-graphs/slider-crank.toml"];
const DRAWN_ENGINE: [&str; 5] = ["bondgraph", "draw", "examples/three-cylinder.toml", "--block", "fixed"];
const DRAWN_PAIR: [&str; 3] = ["bondgraph", "draw", "examples/bond-graphs/prismatic-pair.toml"];

/// Curves of the bond graphs of a thesis, as the guide's page on it asks for them.
const fn graph_run(file: &'static str, arguments: &'static [&'static str], figure: &'static str) -> Written {
    Written::figure(file, arguments, figure)
}

const RUN_UP: [&str; 11] = run_up("examples/three-cylinder.toml", "5 s");
const RUN_UP_FOUR: [&str; 11] =
    run_up("validation/three-four-cylinder-thesis/four-cylinder-simulated.toml", "5 s");
/// The same until the speed is steady.
const TO_SPEED: [&str; 11] = run_up("examples/three-cylinder.toml", "15 s");
const TO_SPEED_FOUR: [&str; 11] =
    run_up("validation/three-four-cylinder-thesis/four-cylinder-simulated.toml", "15 s");

/// An engine with its block fixed, from 1000 rpm on, for some time.
const fn run_up(engine: &'static str, time: &'static str) -> [&'static str; 11] {
    [
        "bondgraph",
        "simulate",
        engine,
        "--block",
        "fixed",
        "--speed",
        "1000 rpm",
        "--for",
        time,
        "--samples",
        "24000",
    ]
}
const TILT: [&str; 14] = [
    "bondgraph",
    "simulate",
    "examples/three-cylinder.toml",
    "--imposed",
    "--joints",
    "compliant",
    "--skirt-offset",
    "-10 mm",
    "--block",
    "fixed",
    "--for",
    "0.12 s",
    "--samples",
    "1440",
];
const ROCKING_WITH: [&str; 8] = [
    "bondgraph",
    "simulate",
    "examples/three-cylinder.toml",
    "--imposed",
    "--for",
    "1.5 s",
    "--samples",
    "9000",
];
const ROCKING_WITHOUT: [&str; 9] = [
    "bondgraph",
    "simulate",
    "examples/three-cylinder.toml",
    "--imposed",
    "--for",
    "1.5 s",
    "--samples",
    "9000",
    "--without-shafts",
];
const SHAFT_FORCES: [&str; 6] = [
    "bondgraph",
    "simulate",
    "validation/three-four-cylinder-thesis/four-cylinder.toml",
    "--block",
    "held",
    "--no-gravity",
];

/// The story of the guide's page on simulation.
const fn simulated(file: &'static str, figure: &'static str) -> Written {
    const STORY: [&str; 2] = ["simulate", "examples/generator-set-3.toml"];
    Written::figure(file, &STORY, figure)
}

/// The optimum of an engine of the guide's page on balancing.
const fn story(file: &'static str, engine: &'static str) -> Written {
    Written {
        input: Some(("docs/src/guide/balancing.md", engine)),
        ..Written::figure(file, &["balance", "-"], "optimum.svg")
    }
}

/// The guide's choice among the arrangements of an in-line twin.
const TWIN_SEARCH: [&str; 11] = [
    "balance",
    "examples/twin-in-line-in-phase.toml",
    "--search",
    "--mount-spacing",
    "176 mm",
    "--reference",
    "examples/in-line-4-long-stroke.toml",
    "--share",
    "1/2",
    "--choose",
    "+1 -1",
];

/// The guide's search over V6 engines with shared pins.
const V6_SEARCH: [&str; 14] = [
    "explore",
    "examples/v6-60.toml",
    "--bank-angle",
    "60 deg .. 120 deg by 5 deg",
    "--split-angle",
    "0 deg",
    "--limit",
    "force order 1 = 1 N",
    "--limit",
    "force order 2 = 1 N",
    "--minimise",
    "uneven firing",
    "--minimise",
    "couple order 1",
];
