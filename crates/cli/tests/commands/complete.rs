//! Typical values: every command works on every engine of the gallery once it is completed, or says why that layout cannot have it.

use crate::program::{examples, folder, lanchester, message, output, output_json};
use lanchester::file::templates;
use std::fs;
use std::path::Path;

/// All rods on one throw.
const SINGLE_ROW_RADIALS: [&str; 4] = ["radial-3", "radial-5", "radial-7", "radial-9"];
/// One web between two crankpins.
const SHARED_WEBS: [&str; 4] = ["boxer-2", "v2-60-split", "v6-60", "v6-90"];

/// Commands with cheap settings.
const COMMANDS: [&[&str]; 14] = [
    &["check"],
    &["loads"],
    &["torque"],
    &["bearings"],
    &["mounts", "--steps", "5"],
    &["torsion"],
    &["scatter", "--samples", "200", "--orders-only"],
    &["sensitivity"],
    &["simulate", "--for", "2 ms"],
    &["bondgraph"],
    &["counterweight", "check"],
    &["counterweight", "design"],
    &["stress", "rule"],
    &["explore", "--max-cases", "20000"],
];

/// The exit status and the words with which a command refuses an engine, where it cannot answer; the reason stands with each.
fn exception(command: &str, engine: &str) -> Option<(i32, &'static str)> {
    let is = |names: &[&str]| names.contains(&engine);
    match command {
        // A web between two crankpins carries no counterweight, and the short form would put one there.
        "counterweight design" if is(&SHARED_WEBS) => Some((2, "no counterweight stands on a web")),
        // It has no counterweights.
        "counterweight design" if engine == "w12-broad-arrow" => {
            Some((2, "no counterweight stands on a web"))
        }
        // Short rods and one large weight a web: the pistons leave room for less. Real ones are balanced outside the case, too.
        "counterweight design" if is(&["v8-crossplane", "square-4"]) => {
            Some((1, "No shape meets all limits"))
        }
        // The formulas are for one throw between two main bearings.
        "stress rule" if is(&SHARED_WEBS) => Some((2, "the rule covers one throw between two main bearings")),
        // Nothing to permute.
        "explore" if is(&SINGLE_ROW_RADIALS) => Some((2, "one throw: nothing to permute")),
        _ => None,
    }
}

/// Engines with so many layouts that a search through all of them is no cheap setting.
fn has_many_layouts(engine: &str) -> bool {
    let many = [
        "in-line-5",
        "in-line-6",
        "in-line-8",
        "flat-12",
        "v8-crossplane",
        "v8-flat-plane",
        "vr6-15",
        "w12-broad-arrow",
        "radial-14",
    ];
    many.contains(&engine) || ["v10-", "v12-", "v16-"].iter().any(|start| engine.starts_with(start))
}

/// Walks all commands over part of the gallery.
fn walk(part: usize, parts: usize) {
    let folder = folder(&format!("complete-{part}"));
    let mut wrong = String::new();
    for template in templates().iter().skip(part).step_by(parts) {
        let file = format!("{}.toml", template.name);
        output(&folder, 0, &["new", template.name, "--complete", "--output", &file]);
        for command in COMMANDS {
            let options = command.iter().position(|word| word.starts_with("--")).unwrap_or(command.len());
            let name = command[..options].join(" ");
            if name == "explore" && has_many_layouts(template.name) {
                continue;
            }
            let run = [&command[..options], &[file.as_str()], &command[options..]].concat();
            let done = lanchester(&folder, &run);
            let said =
                format!("{}{}", String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
            let status = done.status.code();
            let is_right = match exception(&name, template.name) {
                Some((expected, words)) => status == Some(expected) && said.contains(words),
                // A crankshaft that is too weak, or outside the range of the formulas, is an answer.
                None if name == "stress rule" => status == Some(0) || status == Some(1),
                None => status == Some(0),
            };
            if !is_right || said.contains("NaN") || said.contains("warning[") {
                wrong += &format!(
                    "{} {name}: {status:?}\n{}\n",
                    template.name,
                    said.lines().take(12).collect::<Vec<_>>().join("\n")
                );
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn every_command_works_on_completed_engines_first_part() {
    walk(0, 2);
}

#[test]
fn every_command_works_on_completed_engines_second_part() {
    walk(1, 2);
}

#[test]
fn what_takes_long_works_on_a_few_completed_engines() {
    let folder = folder("complete-few");
    for name in ["single", "in-line-3-shaft", "boxer-2"] {
        let file = format!("{name}.toml");
        output(&folder, 0, &["new", name, "--complete", "--output", &file]);
        output(&folder, 0, &["balance", &file]);
        output(&folder, 0, &["report", &file, "--output", "page.html"]);
        let page = fs::read_to_string(folder.join("page.html")).unwrap();
        assert!(!page.contains("NaN") && page.contains("Torsional vibration"), "{name}");
    }
    output(&folder, 0, &["counterweight", "front", "single.toml", "--designs", "3"]);
}

/// Parts of force, couple, roll moment and torque of all orders, of the engine alone.
fn orders(folder: &Path, file: &str) -> Vec<(String, Vec<f64>)> {
    let loads = output_json(folder, 0, &["loads", file, "--format", "json"]);
    let orders = loads["total"]["orders"].as_array().unwrap();
    let values = |key: &str| {
        let parts = orders.iter().map(|order| &order[key]);
        parts.flat_map(|part| part.as_array().unwrap().iter().map(|x| x.as_f64().unwrap())).collect()
    };
    let keys = ["force_forward", "force_backward", "couple_forward", "couple_backward"];
    keys.map(|key| (key.to_string(), values(key))).to_vec()
}

/// The loads of the completed file are those of the file.
fn is_the_same_engine(folder: &Path, before: &str, after: &str) {
    for ((key, was), (_, is)) in orders(folder, before).into_iter().zip(orders(folder, after)) {
        assert!(!was.is_empty() && was.len() == is.len(), "{before}: {key}");
        let size = was.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
        for (was, is) in was.iter().zip(&is) {
            // Weights on the webs in place of one at the throw: sums of other terms, the same to rounding.
            assert!((was - is).abs() <= 1e-9 * size, "{before}, {key}: {was} became {is}");
        }
    }
}

#[test]
fn nothing_that_the_file_says_is_changed() {
    let folder = folder("complete-keeps");
    for template in templates() {
        let file = format!("{}.toml", template.name);
        fs::write(folder.join(&file), template.text).unwrap();
        let full = format!("full-{file}");
        output(&folder, 0, &["complete", &file, "--output", &full]);
        let text = fs::read_to_string(folder.join(&full)).unwrap();
        // Lines that are added stand between those of the file.
        let mut lines = text.lines();
        for line in template.text.lines() {
            assert!(lines.any(|other| other == line), "{}: {line}", template.name);
        }
        is_the_same_engine(&folder, &file, &full);
        // A complete file has nothing to complete, but for what the engine cannot have.
        let again = lanchester(&folder, &["complete", &full]);
        assert_eq!(String::from_utf8_lossy(&again.stdout), text, "{}", template.name);
    }
}

#[test]
fn single_sections_are_completed_in_place() {
    let folder = folder("complete-sections");
    let text = "name = \"x\" # mine\nspeed = \"3000 rpm\"\nlayout = { type = \"in-line\", cylinders = 1 }\n\
                crank = { stroke = \"80 mm\" }\npiston = { mass = \"0.3 kg\" }\nrod = { length = \"140 mm\", mass = \"0.4 kg\" }\n\
                firing = { order = [1] }\n";
    fs::write(folder.join("x.toml"), text).unwrap();
    let bore = output(&folder, 0, &["complete", "x.toml", "--section", "piston.bore", "--dry-run"]);
    assert!(bore.contains("+piston = { mass = \"0.3 kg\", bore = \"96 mm\" }"), "{bore}");
    assert_eq!(fs::read_to_string(folder.join("x.toml")).unwrap(), text);
    let car = [
        "complete",
        "x.toml",
        "--section",
        "piston.bore",
        "--section",
        "gas",
        "--kind",
        "car-petrol",
        "--write",
    ];
    output(&folder, 0, &car);
    let written = fs::read_to_string(folder.join("x.toml")).unwrap();
    assert!(written.contains("bore = \"76 mm\"") && written.contains("[gas.cycle]"), "{written}");
    assert!(!written.contains("[flywheel]") && written.contains("# mine"), "{written}");
    // What the engine cannot have is said, with status 1 where it was asked for.
    let told = lanchester(&folder, &["complete", "x.toml", "--section", "shaft_weight_design"]);
    assert_eq!(told.status.code(), Some(1));
    assert!(
        String::from_utf8_lossy(&told.stderr)
            .contains("shaft_weight_design is left out: the engine has no balance shafts")
    );
    let refused = message(&folder, 2, &["complete", "x.toml", "--section", "gearbox"]);
    assert!(refused.contains("gearbox") && refused.contains("crank.body"), "{refused}");
    let refused = message(&folder, 2, &["complete", "-", "--write"]);
    assert!(refused.contains("--write needs a file"), "{refused}");
}

#[test]
fn real_engines_are_completed_too() {
    let folder = folder("complete-real");
    let mut files: Vec<_> =
        fs::read_dir(examples().join("real")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(files.len() >= 7, "{files:?}");
    for file in files {
        let file = file.display().to_string();
        output(&folder, 0, &["check", &file]);
        let text = output(&folder, 0, &["complete", &file]);
        fs::write(folder.join("full.toml"), text).unwrap();
        for command in ["loads", "torque", "bearings", "torsion"] {
            output(&folder, 0, &[command, "full.toml"]);
        }
    }
}
