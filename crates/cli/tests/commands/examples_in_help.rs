//! Every example in `--help` runs as it is printed, with the files that it names beside it.

use crate::program::{example, folder, output};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// Engines of the gallery, completed with typical values, under the names that examples give them.
const OF_THE_GALLERY: [(&str, &str); 6] = [
    ("four", "in-line-4"),
    ("three", "in-line-3"),
    ("v6", "v6-60"),
    ("boxer", "boxer-2"),
    ("single", "single"),
    ("v8", "v8-crossplane"),
];

/// Files that are shipped, under the names that examples give them.
const SHIPPED: [(&str, &str); 9] = [
    ("twin", "twin-in-line-in-phase"),
    ("lanchester", "in-line-4-shafts"),
    ("six", "in-line-6-torsion"),
    ("three-cylinder", "three-cylinder"),
    ("dc-motor", "bond-graphs/dc-motor"),
    ("slider-crank", "bond-graphs/slider-crank"),
    ("slugs", "workshop/v8-slugs"),
    ("crank", "workshop/two-plane-crank"),
    ("rotor", "workshop/two-plane-crank"),
];

/// Examples that do not run here, and why.
const ELSEWHERE: [(&str, &str); 4] = [
    ("lanchester validate", "takes minutes; a step of CI of its own"),
    ("lanchester studio", "a server that does not end; `studio.rs` starts it"),
    ("lanchester export fmu ", "needs the binary of units beside the program; `export_unit.rs` makes it"),
    (
        "lanchester stress ",
        "finite elements of a whole crankshaft take minutes; `flexible` solves small ones",
    ),
];

/// What does not keep a rule ends with status 1, and that is its answer: a typical crankshaft at its own torsional vibration.
const ANSWERS_NO: [&str; 1] = ["lanchester stress rule four.toml"];

/// Whether an example is one of those; what is quick of them runs here.
fn runs_elsewhere(example: &str) -> bool {
    let is_rule = example.starts_with("lanchester stress rule ") && !example.contains(" --finite-elements");
    // Filters of the published numbers and what the studio prints and ends with are quick.
    let is_quick = example.starts_with("lanchester studio --describe")
        || example.starts_with("lanchester validate twin");
    !is_rule && !is_quick && ELSEWHERE.iter().any(|(beginning, _)| example.starts_with(beginning))
}

/// The examples of a help text, those of several lines joined.
fn examples(help: &str) -> Vec<String> {
    let Some((_, block)) = help.split_once("Examples:\n") else { return Vec::new() };
    let mut found: Vec<String> = Vec::new();
    for line in block.lines().map(str::trim).take_while(|line| !line.is_empty()) {
        match (line.starts_with("lanchester "), found.last_mut()) {
            (false, Some(last)) => *last += &format!(" {line}"),
            _ => found.push(line.to_owned()),
        }
    }
    found
}

/// The commands that a help text lists.
fn commands(help: &str) -> Vec<String> {
    let Some((_, block)) = help.split_once("Commands:\n") else { return Vec::new() };
    let names = block.lines().take_while(|line| !line.is_empty());
    let names = names.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = names.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help");
    names.map(str::to_owned).collect()
}

/// Every command with its examples, commands of commands included, in the order of the help.
fn all_examples(folder: &Path) -> Vec<(String, Vec<String>)> {
    let help = |words: &[&str]| output(folder, 0, &[words, &["--help"]].concat());
    let mut all = Vec::new();
    for command in commands(&help(&[])) {
        let own = help(&[&command]);
        let mut found = examples(&own);
        for below in commands(&own) {
            found.extend(examples(&help(&[&command, &below])));
        }
        all.push((command, found));
    }
    all
}

/// The files that examples name.
fn files(folder: &Path) {
    let completed = |name: &str| {
        output(folder, 0, &["complete", name, "--write"]);
    };
    for (name, layout) in OF_THE_GALLERY {
        let text = output(folder, 0, &["new", layout, "--complete"]);
        fs::write(folder.join(format!("{name}.toml")), text).unwrap();
    }
    for (name, shipped) in SHIPPED {
        fs::copy(example(shipped), folder.join(format!("{name}.toml"))).unwrap();
    }
    completed("twin.toml");
    // The sheet of the book asks for the engine beside it.
    fs::copy(example("workshop/v8-bobweight"), folder.join("v8-sheet.toml")).unwrap();
    fs::create_dir_all(folder.join("engines")).unwrap();
    for name in ["v8-crossplane", "four"] {
        let from = if name == "four" { "four.toml" } else { "v8.toml" };
        fs::copy(folder.join(from), folder.join(format!("engines/{name}.toml"))).unwrap();
    }
    fs::write(folder.join("cases.csv"), "rod.length [mm]\n140\n150\n").unwrap();
    let number = |value: f64| vec![lanchester_sheet::Cell::Number(value)];
    let book =
        lanchester_sheet::workbook("cases", &["rod.length [mm]".to_owned()], &[number(140.0), number(150.0)]);
    fs::write(folder.join("cases.xlsx"), book.unwrap()).unwrap();
}

/// A folder with all that another one holds.
fn copied(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let place = to.join(entry.file_name());
        match entry.file_type().unwrap().is_dir() {
            true => copied(&entry.path(), &place),
            false => drop(fs::copy(entry.path(), place).unwrap()),
        }
    }
}

/// Runs a line in a shell, in whose path the program is; data and messages where it fails.
fn failure(folder: &Path, line: &str) -> Option<String> {
    let program = Path::new(env!("CARGO_BIN_EXE_lanchester"));
    let path =
        format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap_or_default());
    // What another program makes of a file is not ours to try.
    let ours = line.split(" && ").next().unwrap_or(line);
    let run = Command::new("sh")
        .args(["-c", ours])
        .current_dir(folder)
        .env("PATH", path)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let answers_no = run.status.code() == Some(1) && ANSWERS_NO.contains(&line);
    (!run.status.success() && !answers_no).then(|| {
        let [out, err] = [run.stdout, run.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        let tail: Vec<&str> = out.lines().chain(err.lines()).rev().take(4).collect();
        format!("`{line}` ends with {:?}:\n    {}", run.status.code(), tail.join("\n    "))
    })
}

#[test]
fn every_example_in_the_help_runs_as_it_is_printed() {
    let listing = folder("every_example_in_the_help_runs_as_it_is_printed");
    let all = all_examples(&listing);
    let count: usize = all.iter().map(|(_, examples)| examples.len()).sum();
    assert!(all.len() > 20 && count > 150, "{} commands with {count} examples were found", all.len());
    let without: Vec<&str> =
        all.iter().filter(|(_, examples)| examples.is_empty()).map(|(command, _)| command.as_str()).collect();
    assert_eq!(without, Vec::<&str>::new(), "commands without an example");
    let (mut ran, mut failures) = (0, Vec::new());
    let named = listing.join("files");
    fs::create_dir_all(&named).unwrap();
    files(&named);
    for (command, examples) in &all {
        // What one example writes the next may read.
        let own = listing.join(command);
        copied(&named, &own);
        for example in examples.iter().filter(|example| !runs_elsewhere(example)) {
            // It never overwrites: the engine of that name is its own.
            if let Some(("lanchester new", name)) = example.split_once(" in-line-3 --output ") {
                fs::remove_file(own.join(name)).unwrap();
            }
            failures.extend(failure(&own, example));
            ran += 1;
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(ran > 120, "{ran} ran");
}

#[test]
fn what_runs_elsewhere_is_in_the_help() {
    let listing = folder("what_runs_elsewhere_is_in_the_help");
    let all: Vec<String> = all_examples(&listing).into_iter().flat_map(|(_, examples)| examples).collect();
    for (beginning, why) in ELSEWHERE {
        assert!(
            all.iter().any(|example| example.starts_with(beginning)),
            "{beginning} ({why}) is in no help"
        );
    }
}

#[test]
fn an_example_that_fails_is_found() {
    let folder = folder("an_example_that_fails_is_found");
    let said = failure(&folder, "lanchester loads nowhere.toml").unwrap();
    assert!(said.contains("Some(2)") && said.contains("nowhere.toml"), "{said}");
    assert_eq!(failure(&folder, "lanchester new --list > list.txt && false"), None, "only ours is run");
    let wrapped =
        "Usage\n\nExamples:\n  lanchester a b\n  lanchester c --long\n      more\n\nExit status 1: no.\n";
    assert_eq!(examples(wrapped), ["lanchester a b", "lanchester c --long more"]);
}
