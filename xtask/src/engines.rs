//! Every shipped engine through the commands that a user would give.

use crate::command::quiet;
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

/// Every example and every template through `check`, `loads` and `report`.
pub fn run(program: &Path) -> Result<String> {
    let folder = scratch("engines")?;
    let examples = examples()?;
    let mut files = examples.clone();
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
        quiet(Command::new(program).arg("report").arg(file).arg("--output").arg(&report))?;
        let page = std::fs::read_to_string(&report).context("no report was written")?;
        ensure!(page.contains("<svg"), "the report of {} has no figure", file.display());
        // One file that opens without a network: nothing is fetched from elsewhere.
        for fetched in ["src=\"http", "<link rel=\"stylesheet\"", "@import", "url(http"] {
            ensure!(!page.contains(fetched), "the report of {} fetches: {fetched}", file.display());
        }
        std::fs::remove_file(&report)?;
    }
    Ok(format!("{} examples, {} templates", examples.len(), templates.len()))
}

/// Names of the templates.
fn templates(program: &Path) -> Result<Vec<String>> {
    let text = quiet(Command::new(program).args(["new", "--list", "--format", "json"]))?;
    let list: serde_json::Value = serde_json::from_str(&text).context("`new --list` did not print JSON")?;
    let entries = list["templates"].as_array().or(list.as_array()).context("`new --list` printed no list")?;
    let names = entries.iter().map(|entry| entry["name"].as_str().map(str::to_owned));
    names.collect::<Option<Vec<String>>>().context("a template has no name")
}
