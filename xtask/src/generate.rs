//! Pages and pictures that the program writes.

use crate::command::quiet;
use crate::documents::file_of;
use crate::tolerances;
use crate::workspace::{Profile, program, root, scratch};
use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The page of published numbers.
const PUBLISHED: &str = "docs/src/validation.md";

/// The page of the sources' figures, and its pictures.
const ATLAS: &str = "docs/src/atlas.md";
const ATLAS_PICTURES: &str = "docs/src/images/atlas";

/// Pages and pictures of the book, and the picture of the README.
const WRITTEN: [Written; 35] = [
    Written {
        file: "crates/studio/page/src/api/types.ts",
        head: "",
        input: None,
        arguments: &["studio", "--describe", "typescript"],
        figure: None,
    },
    Written {
        file: "crates/studio/openapi.json",
        head: "",
        input: None,
        arguments: &["studio", "--describe", "openapi"],
        figure: None,
    },
    Written {
        file: "docs/src/engine-file.md",
        head: "# The engine file\n\nEvery table and key, as the reader knows them. `lanchester schema` gives the same to an editor.\n\n",
        input: None,
        arguments: &["schema", "--markdown"],
        figure: None,
    },
    Written {
        file: "docs/src/workshop-sheet.md",
        head: "# The workshop sheet\n\nEvery table and key. `lanchester schema --sheet` gives the same to an editor; the guide shows one [step by \
               step](guide/workshop.md).\n\n",
        input: None,
        arguments: &["schema", "--sheet", "--markdown"],
        figure: None,
    },
    Written {
        file: "validation/suite.schema.json",
        head: "",
        input: None,
        arguments: &["schema", "--suite"],
        figure: None,
    },
    Written { file: PUBLISHED, head: "", input: None, arguments: &["validate", "--markdown"], figure: None },
    Written {
        file: "docs/images/twin-spectrum.svg",
        head: "",
        input: None,
        arguments: &["report", "examples/twin-in-line-in-phase.toml", "--output", "-"],
        figure: Some("force-spectrum.svg"),
    },
    Written {
        file: "docs/src/images/production.svg",
        head: "",
        input: None,
        arguments: &["scatter", "examples/in-line-4-production.toml"],
        figure: Some("scatter.svg"),
    },
    Written {
        file: "docs/src/images/arrangements.svg",
        head: "",
        input: None,
        arguments: &TWIN_SEARCH,
        figure: Some("arrangements.svg"),
    },
    Written {
        file: "docs/src/images/arrangement-drives.svg",
        head: "",
        input: None,
        arguments: &TWIN_SEARCH,
        figure: Some("drives.svg"),
    },
    Written {
        file: "docs/src/images/counterweight.svg",
        head: "",
        input: None,
        arguments: &["counterweight", "design", "examples/in-line-3-counterweights.toml"],
        figure: Some("counterweight-web-1-web-2.svg"),
    },
    Written {
        file: "docs/src/images/counterweight-front.svg",
        head: "",
        input: None,
        arguments: &["counterweight", "front", "examples/in-line-3-counterweights.toml"],
        figure: Some("counterweight-front.svg"),
    },
    Written {
        file: "docs/src/images/layout-front.svg",
        head: "",
        input: None,
        arguments: &V6_SEARCH,
        figure: Some("layout-front.svg"),
    },
    drawn("docs/src/images/bond-graph-slider-crank.svg", &DRAWN_SLIDER),
    drawn("docs/src/images/bond-graph-prismatic-pair.svg", &DRAWN_PAIR),
    drawn("docs/src/images/bond-graph-three-cylinder.svg", &DRAWN_ENGINE),
    graph_run("docs/src/images/bond-graph-pressures.svg", &RUN_UP, "bond-graph-pressures.svg"),
    graph_run("docs/src/images/bond-graph-loops.svg", &RUN_UP, "bond-graph-loops.svg"),
    graph_run("docs/src/images/bond-graph-speed.svg", &RUN_UP, "bond-graph-speed.svg"),
    graph_run("docs/src/images/bond-graph-pressures-four.svg", &RUN_UP_FOUR, "bond-graph-pressures.svg"),
    graph_run("docs/src/images/bond-graph-loops-four.svg", &RUN_UP_FOUR, "bond-graph-loops.svg"),
    graph_run("docs/src/images/bond-graph-speed-four.svg", &RUN_UP_FOUR, "bond-graph-speed.svg"),
    graph_run("docs/src/images/bond-graph-tilt.svg", &TILT, "bond-graph-tilt.svg"),
    graph_run("docs/src/images/bond-graph-block-without.svg", &ROCKING_WITHOUT, "bond-graph-block.svg"),
    graph_run("docs/src/images/bond-graph-block-with.svg", &ROCKING_WITH, "bond-graph-block.svg"),
    graph_run("docs/src/images/bond-graph-second-order.svg", &SHAFT_FORCES, "bond-graph-second-order.svg"),
    graph_run("docs/src/images/bond-graph-shafts.svg", &SHAFT_FORCES, "bond-graph-shafts.svg"),
    simulated("docs/src/images/simulated-speed.svg", "simulated-speed.svg"),
    simulated("docs/src/images/simulated-energy.svg", "simulated-energy.svg"),
    story("docs/src/images/balanced-twin.svg", "twin.toml"),
    story("docs/src/images/balanced-three.svg", "three.toml"),
    story("docs/src/images/balanced-v6.svg", "v6.toml"),
    blind("docs/src/images/counterweights-four.svg", &BLIND_FOUR),
    blind("docs/src/images/counterweights-six.svg", &BLIND_SIX),
    blind("docs/src/images/counterweights-v8.svg", &BLIND_V8),
];

/// An engine of the gallery with the lightest weights that leave the least force and couple, before and after.
const fn blind(file: &'static str, arguments: &'static [&'static str]) -> Written {
    Written { file, head: "", input: None, arguments, figure: Some("consequences.svg") }
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
    Written { file, head: "", input: None, arguments, figure: None }
}

const DRAWN_SLIDER: [&str; 3] = ["bondgraph", "draw", "examples/bond-graphs/slider-crank.toml"];
const DRAWN_ENGINE: [&str; 5] = ["bondgraph", "draw", "examples/three-cylinder.toml", "--block", "fixed"];
const DRAWN_PAIR: [&str; 3] = ["bondgraph", "draw", "examples/bond-graphs/prismatic-pair.toml"];

/// Curves of the bond graphs of a thesis, as the guide's page on it asks for them.
const fn graph_run(file: &'static str, arguments: &'static [&'static str], figure: &'static str) -> Written {
    Written { file, head: "", input: None, arguments, figure: Some(figure) }
}

const RUN_UP: [&str; 11] = run_up("examples/three-cylinder.toml");
const RUN_UP_FOUR: [&str; 11] = run_up("validation/three-four-cylinder-thesis/four-cylinder-simulated.toml");

/// An engine with its block fixed, from 1000 rpm on.
const fn run_up(engine: &'static str) -> [&'static str; 11] {
    [
        "bondgraph",
        "simulate",
        engine,
        "--block",
        "fixed",
        "--speed",
        "1000 rpm",
        "--for",
        "5 s",
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
    Written { file, head: "", input: None, arguments: &STORY, figure: Some(figure) }
}

/// The optimum of an engine of the guide's page on balancing.
const fn story(file: &'static str, engine: &'static str) -> Written {
    Written {
        file,
        head: "",
        input: Some(("docs/src/guide/balancing.md", engine)),
        arguments: &["balance", "-"],
        figure: Some("optimum.svg"),
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

/// A file that the program writes.
struct Written {
    file: &'static str,
    /// What stands above it.
    head: &'static str,
    /// The page and the file on it that the program reads on standard input.
    input: Option<(&'static str, &'static str)>,
    /// What makes the program print it.
    arguments: &'static [&'static str],
    /// The figure of the report that it is, where it is one.
    figure: Option<&'static str>,
}

/// Folders of figures by what the program was asked for: several pictures come of one run.
type Figures = BTreeMap<(Option<(&'static str, &'static str)>, &'static [&'static str]), PathBuf>;

impl Written {
    fn text(&self, program: &Path, figures: &mut Figures) -> Result<String> {
        let Some(figure) = self.figure else {
            return Ok(format!("{}{}", self.head, quiet(&mut self.command(program)?)?));
        };
        let asked = (self.input, self.arguments);
        let folder = match figures.get(&asked) {
            Some(folder) => folder.clone(),
            None => {
                let folder = scratch(&format!("figures-{}", figures.len()))?;
                quiet(self.command(program)?.arg("--figures").arg(&folder))?;
                figures.insert(asked, folder.clone());
                folder
            }
        };
        let body =
            std::fs::read_to_string(folder.join(figure)).with_context(|| format!("no figure {figure}"))?;
        Ok(format!("{}{body}", self.head))
    }

    fn command(&self, program: &Path) -> Result<Command> {
        let mut command = Command::new(program);
        command.args(self.arguments).current_dir(root());
        if let Some((page, name)) = self.input {
            let input = scratch("input")?.join(name);
            std::fs::write(&input, file_of(page, name)?)?;
            command.stdin(std::fs::File::open(&input)?);
        }
        Ok(command)
    }
}

/// Writes every file.
pub fn write(profile: Profile) -> Result<()> {
    tolerances::write()?;
    let program = program(profile)?;
    let mut figures = Figures::new();
    for written in &WRITTEN {
        std::fs::write(root().join(written.file), written.text(&program, &mut figures)?)?;
        println!("{}", written.file);
    }
    write_atlas(&program)
}

/// The atlas: its page, and the pictures of this version alone.
fn write_atlas(program: &Path) -> Result<()> {
    let new = scratch("atlas")?;
    let arguments = ["validate", "--markdown", "--figures"];
    let page = quiet(Command::new(program).args(arguments).arg(&new).current_dir(root()))?;
    std::fs::write(root().join(ATLAS), page)?;
    let kept = root().join(ATLAS_PICTURES);
    if kept.is_dir() {
        std::fs::remove_dir_all(&kept)?;
    }
    std::fs::create_dir_all(&kept)?;
    for picture in std::fs::read_dir(&new)? {
        let picture = picture?.path();
        if let (Some(name), Some("svg")) = (picture.file_name(), picture.extension().and_then(|e| e.to_str()))
        {
            std::fs::copy(&picture, kept.join(name))?;
        }
    }
    println!("{ATLAS}, {ATLAS_PICTURES}");
    Ok(())
}

/// Fails where a file is not what the program writes now.
///
/// The page of published numbers takes a minute of two processors; tests of the crate `validation`, which need all numbers and figures in any
/// case, hold it and the atlas.
pub fn check(program: &Path) -> Result<String> {
    let (mut stale, mut figures) = (Vec::new(), Figures::new());
    let held_here = WRITTEN.iter().filter(|written| written.file != PUBLISHED);
    for written in held_here {
        let kept = std::fs::read_to_string(root().join(written.file));
        if kept.with_context(|| format!("cannot read {}", written.file))?
            != written.text(program, &mut figures)?
        {
            stale.push(written.file);
        }
    }
    if !stale.is_empty() {
        bail!("stale: {}; run `cargo xtask generate`", stale.join(", "));
    }
    Ok(format!("{} files", WRITTEN.len() - 1))
}
