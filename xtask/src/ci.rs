//! `cargo xtask ci`: one list of steps, in one target folder, stopping at the first failure.

use crate::command::{cargo, in_view, quiet};
use crate::workspace::{program, root};
use crate::{book, browser, claims, documents, engines, generate, hostile, notices, page, supply, tidy};
use anyhow::{Context, Result};
use std::time::{Duration, Instant};

/// What the random cases of the tests are drawn from: a change is judged by its own cases only (decision 20).
const SEED: &str = "1";

/// Runs every step.
pub fn run() -> Result<()> {
    let mut steps = Steps::default();
    steps.run("formatting", || {
        quiet(cargo().args(["fmt", "--all", "--check"]).current_dir(root())).map(|_| String::new())
    })?;
    steps.run("rules of the house", tidy::sources)?;
    steps.run("page of the studio: types, lint, format, unit tests", page::check)?;
    steps.run("built page is fresh", page::check_built)?;
    steps.run("licences, sources and advisories of others", || supply::check(true))?;
    steps.run("notices of third parties are fresh", notices::check)?;
    steps.run("clippy, all targets, no warning", || {
        let mut clippy = cargo();
        clippy.args(["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"]);
        in_view(clippy.current_dir(root())).map(|()| String::new())
    })?;
    steps.run("tests, with the kept fuzz corpus", || {
        let mut test = cargo();
        test.args(["test", "--workspace", "--no-fail-fast"]).env("PROPTEST_RNG_SEED", SEED);
        in_view(test.current_dir(root())).map(|()| String::new())
    })?;
    let program = program().context("the program does not build")?;
    steps.run("every example and template: check, loads, balance, report", || engines::run(&program))?;
    steps.run("mutated files, kills, laws, attacks: a short round", || hostile::short(&program))?;
    steps.run("engine files of the README and the book", || documents::engines(&program))?;
    steps.run("claims of the README and the book", || claims::check(&program))?;
    steps.run("published numbers", || {
        let text = quiet(std::process::Command::new(&program).arg("validate").current_dir(root()))?;
        Ok(text.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default().trim().to_owned())
    })?;
    steps.run("generated pages are fresh", || generate::check(&program))?;
    steps.run("API documentation, no warning", || {
        let mut doc = cargo();
        doc.args(["doc", "--workspace", "--no-deps", "--document-private-items", "--quiet"]);
        quiet(doc.env("RUSTDOCFLAGS", "--deny warnings").current_dir(root())).map(|_| String::new())
    })?;
    steps.run("book", || book::build().map(|()| String::new()))?;
    steps.run("report in a browser", || browser::check_reports(&program))?;
    steps.run("studio in a browser", || page::try_in_browser(&program))?;
    steps.run("commands of the README", documents::commands)?;
    steps.print();
    Ok(())
}

#[derive(Default)]
struct Steps {
    done: Vec<(&'static str, Duration, String)>,
}

impl Steps {
    /// Runs one step; what it returns is a remark for the list, what it fails with is its output.
    fn run(&mut self, name: &'static str, step: impl FnOnce() -> Result<String>) -> Result<()> {
        println!("== {name}");
        let start = Instant::now();
        let remark = step().with_context(|| format!("step failed: {name}"))?;
        let time = start.elapsed();
        println!("   {:.1} s  {remark}", time.as_secs_f64());
        self.done.push((name, time, remark));
        Ok(())
    }

    fn print(&self) {
        println!("\nall steps passed");
        for (name, time, remark) in &self.done {
            println!("{:8.1} s  {name:50} {remark}", time.as_secs_f64());
        }
        let total: Duration = self.done.iter().map(|(_, time, _)| *time).sum();
        println!("{:8.1} s  in all", total.as_secs_f64());
    }
}
