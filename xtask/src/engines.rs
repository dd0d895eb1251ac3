//! Every shipped engine through the commands that a user would give.

use crate::command::{output, quiet};
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Engine files of `examples/`, by name.
pub fn examples() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(root().join("examples")).context("cannot read examples/")? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            files.push(path);
        }
    }
    ensure!(!files.is_empty(), "no engine in examples/");
    files.sort();
    Ok(files)
}

/// Engine files of `examples/real/`, by name.
fn real() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(root().join("examples/real")).context("cannot read examples/real/")? {
        files.push(entry?.path());
    }
    ensure!(!files.is_empty(), "no engine in examples/real");
    files.sort();
    Ok(files)
}

/// Every example and every template through `check`, `loads`, `balance` and `report`.
pub fn run(program: &Path) -> Result<String> {
    let folder = scratch("engines")?;
    let examples = examples()?;
    let mut files = examples.clone();
    let real = real()?;
    files.extend(real.iter().cloned());
    let templates = templates(program)?;
    for template in &templates {
        let file = folder.join(format!("{template}.toml"));
        quiet(Command::new(program).args(["new", template, "--output"]).arg(&file))?;
        files.push(file);
    }
    for file in &files {
        let report = folder.join("report.html");
        quiet(Command::new(program).arg("check").arg(file))?;
        let table = quiet(Command::new(program).arg("loads").arg(file))?;
        ensure!(!table.trim().is_empty(), "`loads` prints nothing for {}", file.display());
        balanced(program, file)?;
        quiet(Command::new(program).arg("report").arg(file).arg("--output").arg(&report))?;
        let page = std::fs::read_to_string(&report).context("no report was written")?;
        ensure!(page.contains("<svg"), "the report of {} has no figure", file.display());
        // One file that opens without a network: nothing is fetched from elsewhere.
        for fetched in ["src=\"http", "<link rel=\"stylesheet\"", "@import", "url(http"] {
            ensure!(!page.contains(fetched), "the report of {} fetches: {fetched}", file.display());
        }
        std::fs::remove_file(&report)?;
    }
    let sheets = sheets(program, &folder)?;
    Ok(format!(
        "{} examples, {} real engines, {} templates, {sheets} workshop sheets",
        examples.len(),
        real.len(),
        templates.len()
    ))
}

/// `balance` finds an optimum, proves it, and can write it into the file.
fn balanced(program: &Path, file: &Path) -> Result<()> {
    let answer = quiet(Command::new(program).arg("balance").arg(file).args(["--format", "json"]))?;
    let answer: serde_json::Value = serde_json::from_str(&answer).context("`balance` did not print JSON")?;
    let name = file.display();
    let unbalanced = |criterion: &serde_json::Value| {
        let effects = answer["effects"].as_array().into_iter().flatten();
        effects.filter(|e| e["criterion"] == *criterion).find_map(|e| e["without"].as_f64()).unwrap_or(0.0)
    };
    let stages = answer["stages"].as_array().with_context(|| format!("{name}: no optimum"))?;
    ensure!(!stages.is_empty(), "{name}: no optimum: {}", answer["outcome"]);
    for stage in stages {
        let (value, gap) = (stage["value"].as_f64(), stage["gap"].as_f64());
        let (value, gap) = value.zip(gap).with_context(|| format!("{name}: a stage without a value"))?;
        let terms = stage["terms"].as_array().into_iter().flatten();
        // Nothing to balance: rounding of the engine's own loads is all that is left.
        let scale = terms.map(|term| 1e-6 * unbalanced(&term[0])).fold(value.max(1e-6), f64::max);
        ensure!(gap <= 1e-8 * scale, "{name}: gap {gap:e} of {value:e}");
    }
    let difference = quiet(Command::new(program).arg("balance").arg(file).arg("--dry-run"))?;
    ensure!(difference.is_empty() || difference.starts_with("--- "), "{name}: {difference}");
    Ok(())
}

/// What every sheet of `examples/workshop/` is asked, and the exit status that it must have.
const SHEETS: [(&str, &str, i32); 10] = [
    ("two-plane-crank", "correct", 0),
    ("two-plane-crank", "drill", 0),
    ("two-plane-crank", "grade", 0),
    ("machine-display", "correct", 1),
    ("machine-display", "drill", 0),
    ("machine-display", "grade", 1),
    ("v8-bobweight", "bobweight", 0),
    ("v6-90-odd-bobweight", "bobweight", 0),
    ("v6-90-odd-wrong-share", "bobweight", 0),
    ("v8-slugs", "internal", 0),
];

/// Every workshop sheet through the commands that a user would give; how many there are.
fn sheets(program: &Path, folder: &Path) -> Result<usize> {
    let examples = root().join("examples/workshop");
    let mut count = 0;
    for entry in std::fs::read_dir(&examples).context("cannot read examples/workshop/")? {
        let path = entry?.path();
        // `engines/` holds the engines that sheets name.
        if path.is_dir() {
            continue;
        }
        let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
        ensure!(SHEETS.iter().any(|(sheet, ..)| *sheet == name), "no command for {}", path.display());
        count += 1;
    }
    for (name, command, status) in SHEETS {
        let figure = folder.join("vibration.svg");
        let mut run = Command::new(program);
        run.args(["workshop", command]).arg(examples.join(format!("{name}.toml")));
        if command == "correct" {
            run.arg("--figure").arg(&figure);
        }
        let finished = output(&mut run)?;
        let said = format!("{}{}", finished.stdout, finished.stderr);
        ensure!(
            finished.status == status,
            "`workshop {command}` of {name} ends with {}:\n{said}",
            finished.status
        );
        ensure!(finished.stderr.is_empty() && !finished.stdout.is_empty(), "{name}: {said}");
        if command == "correct" {
            let drawn = std::fs::read_to_string(&figure).context("no figure was written")?;
            ensure!(drawn.starts_with("<svg"), "the figure of {name} is no SVG");
            std::fs::remove_file(&figure)?;
        }
    }
    Ok(count)
}

/// Names of the templates.
fn templates(program: &Path) -> Result<Vec<String>> {
    let text = quiet(Command::new(program).args(["new", "--list", "--format", "json"]))?;
    let list: serde_json::Value = serde_json::from_str(&text).context("`new --list` did not print JSON")?;
    let entries = list["templates"].as_array().or(list.as_array()).context("`new --list` printed no list")?;
    let names = entries.iter().map(|entry| entry["name"].as_str().map(str::to_owned));
    names.collect::<Option<Vec<String>>>().context("a template has no name")
}
