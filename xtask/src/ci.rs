//! `cargo xtask ci`: one list of steps, in one target folder, stopping at the first failure (with `--to-the-end` all failures are told);
//! `cargo xtask quick` is what a change needs before the next one.
//!
//! Lints, tests, program and the README's commands share one profile, the one that users get, with one set of features
//! (`crates/cli/Cargo.toml` brings those that tests need): nothing is compiled twice.

use crate::command::{cargo, quiet};
use crate::steps::{Lane, Steps};
use crate::workspace::{Profile, program, root};
use crate::{
    book, browser, claims, dist, documents, engines, generate, hostile, lint, notices, page, python, supply,
    test_programs, tidy,
};
use anyhow::{Context, Result};

/// Runs every step of `steps`.
pub fn run(mut steps: Steps) -> Result<()> {
    // What compiles nothing, or what one processor compiles, stands beside what leaves processors idle.
    steps.beside(vec![
        Lane::new()
            .step("formatting", formatting)
            .step("rules of the house", tidy::sources)
            .step("packages of the crates", dist::crates::check)
            .step("licences, sources and advisories of others", || supply::check(true))
            .step("page of the studio: types, lint, format, unit tests", page::check)
            .step("built page is fresh", page::check_built)
            .step("notices of third parties are fresh", notices::check)
            .step("book", || book::build().map(|()| String::new())),
        Lane::new().step("clippy, all targets, no warning", || {
            lint::clippy(Profile::Release).map(|()| String::new())
        }),
    ])?;
    steps.run("tests, with the kept fuzz corpus", || test_programs::all(Profile::Release))?;
    let program = program(Profile::Release).context("the program does not build")?;
    steps.beside(vec![
        Lane::new()
            .step("every example and template: check, loads, balance, report", || engines::run(&program))
            .step("mutated files, kills, laws, attacks: a short round", || hostile::short(&program))
            .step("engine files of the README and the book", || documents::engines(&program))
            .step("claims of the README and the book", || claims::check(&program))
            .step("generated pages are fresh", || generate::check(&program))
            .step("report in a browser", || browser::check_reports(&program))
            .step("API documentation, no warning", || {
                lint::documentation(Profile::Release).map(|()| String::new())
            }),
        Lane::new()
            .step("commands of the README", documents::commands)
            // Behind the README's commands, whose optimised crates it shares.
            .step("Python package: wheel, types, tests, doctests, notebooks", || python::run(&[])),
    ])?;
    // They wait for frames, and have the processors for themselves.
    steps.run("studio in a browser", || page::try_in_browser(&program))?;
    steps.finish()
}

/// What a change needs before the next one: format, rules, lints, and the tests but the slow ones.
pub fn quick() -> Result<()> {
    let mut steps = Steps::default();
    steps.run("formatting", formatting)?;
    steps.run("rules of the house", tidy::sources)?;
    steps.run("clippy, all targets, no warning", || lint::clippy(Profile::Dev).map(|()| String::new()))?;
    steps.run("tests but the slow ones", test_programs::quick)?;
    steps.finish()
}

fn formatting() -> Result<String> {
    quiet(cargo().args(["fmt", "--all", "--check"]).current_dir(root())).map(|_| String::new())
}
