//! What goes wrong with runs in time and with bond graphs, one named row each: refused with its place or its key and what fixes it, or run to an outcome that says so;
//! never a panic, never a hang.

use crate::program::{examples, folder, lanchester};
use std::fs;
use std::path::Path;

const SET: &str = "generator-set-3.toml";
const FOUR: &str = "in-line-4.toml";
const MOUNTED: &str = "in-line-4-mounts.toml";
const SLIDER: &str = "bond-graphs/slider-crank.toml";

/// One row: an example with one change, how it is run, how that ends and what is said.
struct Row {
    name: &'static str,
    file: &'static str,
    change: &'static [(&'static str, &'static str)],
    arguments: &'static [&'static str],
    status: i32,
    words: &'static [&'static str],
}

const ROWS: &[Row] = &[
    Row {
        name: "a load of constant power at rest",
        file: SET,
        change: &[("type = \"none\"", "type = \"power\"\npower = \"5 kW\"")],
        arguments: &["simulate"],
        status: 2,
        words: &["least_speed", "engine.toml:", "hint:"],
    },
    Row {
        name: "a load of constant power that is driven through rest",
        file: SET,
        change: &[("type = \"none\"", "type = \"power\"\npower = \"2 kW\"\nleast_speed = \"600 rpm\"")],
        arguments: &["simulate", "--for", "1 s", "--block", "fixed"],
        status: 0,
        words: &["Run:"],
    },
    Row {
        name: "no inertia of the crankshaft",
        file: FOUR,
        change: &[],
        arguments: &["simulate"],
        status: 2,
        words: &["moment of inertia", "[flywheel]", "[crank.body]"],
    },
    Row {
        name: "a starter too weak for the first compression",
        file: SET,
        change: &[("\"6 N m\"", "\"0.5 N m\"")],
        arguments: &["simulate", "--for", "2 s", "--block", "fixed"],
        status: 0,
        words: &["the crank comes to rest at", "deg", "are left against", "N m of friction and load"],
    },
    Row {
        name: "a load above the torque of the engine",
        file: SET,
        change: &[],
        arguments: &[
            "simulate", "--for", "20 s", "--block", "fixed", "--speed", "900 rpm", "--load", "300 N m",
        ],
        status: 0,
        words: &["the crank comes to rest at", "It ends after"],
    },
    Row {
        name: "a load above the torque of the engine, on mounts",
        file: SET,
        change: &[],
        arguments: &["simulate", "--start", "1500 rpm", "--load", "200 N m", "--for", "3 s"],
        status: 0,
        words: &["The crank stands from", "friction and load hold"],
    },
    Row {
        name: "a start that cannot be read",
        file: SET,
        change: &[],
        arguments: &["simulate", "--start", "soon"],
        status: 2,
        words: &["--start: a start is a crank angle", "hint:"],
    },
    Row {
        name: "a crank that is held still and never gets round",
        file: SET,
        change: &[],
        arguments: &["simulate", "--imposed", "--start", "0 rpm", "--for", "2 revolutions"],
        status: 2,
        words: &["imposed speed of a run over revolutions", "above 0, or a run over a time"],
    },
    Row {
        name: "teeth of a shaft that is not there",
        file: SET,
        change: &[(
            "[simulation]",
            "[simulation]\nmesh = [{ shaft = \"nobody\", pressure_angle = \"20 deg\", z = \"0 mm\" }]",
        )],
        arguments: &["simulate"],
        status: 2,
        words: &["the gear of \"nobody\" has no line of action"],
    },
    Row {
        name: "a crankshaft that is no body",
        file: SET,
        change: &[("[simulation]", "[simulation]\ncrankshaft = \"body\"")],
        arguments: &["simulate"],
        status: 2,
        words: &["cannot turn as a body"],
    },
    Row {
        name: "a block lighter than the parts in it",
        file: SET,
        change: &[("mass = \"190 kg\"", "mass = \"2 kg\"")],
        arguments: &["simulate", "--for", "0.1 s"],
        status: 2,
        words: &["the block less", "a mass [kg]", "moving_parts"],
    },
    Row {
        name: "a block with less inertia than its rotors",
        file: SET,
        change: &[("\"5.5 kg m2\"]", "\"0.5 kg m2\"]")],
        arguments: &["simulate", "--for", "0.1 s"],
        status: 2,
        words: &["moment of inertia [kg m^2]"],
    },
    Row {
        name: "a loss factor that no chain of springs and dashpots follows",
        file: MOUNTED,
        change: &[("\"430 N/mm\"", "\"43 N/mm\"")],
        arguments: &["simulate", "--imposed", "--block", "mounts"],
        status: 2,
        words: &["come no closer than", "10 %", "damping"],
    },
    Row {
        name: "mounts that leave a motion of the block free",
        file: SET,
        change: &[("[\"140 N/mm\", \"60 N/mm\", \"60 N/mm\"]", "[\"140 N/mm\", \"0 N/mm\", \"0 N/mm\"]")],
        arguments: &["simulate", "--for", "0.1 s"],
        status: 2,
        words: &["leave a motion of it free"],
    },
    Row {
        name: "an event that never comes",
        file: SET,
        change: &[],
        arguments: &["simulate", "--for", "1 s"],
        status: 0,
        words: &["Event 3 (load 40 N m) never came."],
    },
    Row {
        name: "a duration of more than ten million evaluations",
        file: SET,
        change: &[],
        arguments: &["simulate", "--for", "1000000 revolutions"],
        status: 2,
        words: &["evaluations", "long run"],
    },
    Row {
        name: "more samples than fit",
        file: SET,
        change: &[],
        arguments: &["simulate", "--for", "100 revolutions", "--step", "0.001 deg"],
        status: 2,
        words: &["samples"],
    },
    Row {
        name: "a profile that does not rise in time",
        file: FOUR,
        change: &[(
            "name = ",
            "simulation.speed = \"imposed\"\nsimulation.imposed = [{ at = \"1 s\", speed = \"9 rpm\" }, { at = \"0 s\", speed = \"9 rpm\" }]\nname = ",
        )],
        arguments: &["simulate"],
        status: 2,
        words: &["must rise", "hint:"],
    },
    Row {
        name: "a governor without gas",
        file: FOUR,
        change: &[(
            "name = ",
            "governor = { speed = \"1500 rpm\", gain = \"0.02 1/rpm\", delay = \"20 ms\" }\nname = ",
        )],
        arguments: &["simulate"],
        status: 2,
        words: &["`governor` has no effect", "[gas]"],
    },
    Row {
        name: "a cylinder that does not exist misfires",
        file: SET,
        change: &[("misfire 2", "misfire 7")],
        arguments: &["simulate"],
        status: 2,
        words: &["no cylinder 7", "from 1 to 3"],
    },
    Row {
        name: "an unknown element in a bond",
        file: SLIDER,
        change: &[("\"motor > shaft\"", "\"motor > shat\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["no element `shat`", "hint:"],
    },
    Row {
        name: "an unknown port in a bond",
        file: SLIDER,
        change: &[("\"slider.2 > guide\"", "\"slider.3 > guide\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["no port", "hint:"],
    },
    Row {
        name: "a port that is bonded twice",
        file: SLIDER,
        change: &[("\"shaft > rub\"", "\"shaft > rub\", \"guide > rub\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["bonded twice"],
    },
    Row {
        name: "a port without a bond",
        file: SLIDER,
        change: &[("\"shaft > rub\", ", "")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["`rub` has no bond"],
    },
    Row {
        name: "an element without a law",
        file: SLIDER,
        change: &[("effort = \"5 N m\"", "")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["no law"],
    },
    Row {
        name: "the unit of an expression",
        file: SLIDER,
        change: &[("effort = \"5 N m\"", "effort = \"5 N\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["needs a value in N m"],
    },
    Row {
        name: "a signal that needs itself",
        file: SLIDER,
        change: &[("integral_of = \"shaft.flow\", start = \"0.3 rad\"", "value = \"theta\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["needs itself"],
    },
    Row {
        name: "two sources that set one flow",
        file: SLIDER,
        change: &[
            (
                "rub    = { kind = \"R\", resistance = \"0.02 N m s\" }",
                "rub = { kind = \"Sf\", flow = \"1 rad/s\" }\nbrake = { kind = \"Sf\", flow = \"2 rad/s\" }",
            ),
            ("\"shaft > rub\"", "\"rub > shaft\", \"brake > shaft\""),
        ],
        arguments: &["bondgraph", "causality"],
        status: 2,
        words: &["both set the flow of"],
    },
    Row {
        name: "a store without inertia",
        file: SLIDER,
        change: &[("inertia = \"m\"", "inertia = \"0 kg\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["positive"],
    },
    Row {
        name: "a modulus that becomes infinite on the way",
        file: SLIDER,
        change: &[("resistance = \"0.02 N m s\"", "effort = \"0.02 N m s*f/sqrt(1 - t/(0.5 s))\"")],
        arguments: &["bondgraph", "simulate"],
        status: 1,
        words: &["0.4"],
    },
    Row {
        name: "a junction that joins two domains",
        file: SLIDER,
        change: &[("\"slider.2 > guide\"", "\"slider.2 > guide\", \"guide > shaft\"")],
        arguments: &["bondgraph"],
        status: 2,
        words: &["joins"],
    },
];

#[test]
fn every_row_is_told() {
    let mut failed = Vec::new();
    for (index, row) in ROWS.iter().enumerate() {
        let folder = folder(&format!("bad-simulation-{index}"));
        if let Err(why) = holds(row, &folder) {
            failed.push(format!("{}: {why}", row.name));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
}

fn holds(row: &Row, folder: &Path) -> Result<(), String> {
    let mut text = fs::read_to_string(examples().join(row.file)).unwrap();
    for (from, to) in row.change {
        if !text.contains(from) {
            return Err(format!("the example has no {from}"));
        }
        text = text.replacen(from, to, if row.file == SET && from.starts_with('[') { 9 } else { 1 });
    }
    fs::write(folder.join("engine.toml"), &text).unwrap();
    let mut arguments = row.arguments.to_vec();
    // Options stand behind the file.
    let place = arguments.iter().position(|argument| argument.starts_with("--")).unwrap_or(arguments.len());
    arguments.insert(place, "engine.toml");
    let output = lanchester(folder, &arguments);
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    // Lines are wrapped at the width of a page.
    let told = format!("{out}{err}").split_whitespace().collect::<Vec<_>>().join(" ");
    if output.status.code() != Some(row.status) {
        return Err(format!("ends with {:?}, not {}: {told}", output.status.code(), row.status));
    }
    if row.status == 2 && !out.is_empty() {
        return Err(format!("has data although it is refused: {out}"));
    }
    match row.words.iter().find(|words| !told.contains(**words)) {
        Some(words) => Err(format!("does not say \"{words}\": {told}")),
        None => Ok(()),
    }
}
