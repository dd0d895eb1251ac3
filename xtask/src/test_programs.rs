//! The tests: every test program of the workspace, built once, with the time of each test.
//!
//! The programs are run here and not by `cargo test`, so that two of them share the processors where one waits for its last long test,
//! and so that the slowest tests are known.

use crate::command::{cargo, quiet};
use crate::workspace::{Profile, root, target};
use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// What the random cases of the tests are drawn from: a change is judged by its own cases only (decision 20).
const SEED: &str = "1";
/// How many of the slowest tests are listed.
const LISTED: usize = 10;
/// Tests that took longer in the last whole run are left out of a quick one [s].
const QUICK: f64 = 1.0;
/// Test programs that run at a time.
const AT_A_TIME: usize = 2;
/// Tests that each of them runs at a time: where one waits for its last, the other has the processors.
const THREADS: usize = 2;

/// Packages whose tests factor large matrices. The tests at a time fill the processors, and factors on two threads wait for each other by spinning: where
/// four tests factor at once, a quarter of the time. What is to be the same on any number of threads asks for its own.
const FACTORING: [&str; 4] = ["cli", "flex", "lanchester", "validation"];

/// One test program.
pub struct TestProgram {
    /// Where it stands.
    pub path: PathBuf,
    /// The folder it runs in: its package's.
    pub folder: PathBuf,
    /// Its package and target: "balance balance", "mechanism lib".
    name: String,
}

/// Builds all test programs of the workspace.
pub fn programs(profile: Profile) -> Result<Vec<TestProgram>> {
    let mut build = cargo();
    build.args(["test", "--workspace", "--no-run", "--message-format", "json-render-diagnostics"]);
    build.args(profile.arguments());
    let said = quiet(build.current_dir(root()))?;
    let mut found = Vec::new();
    for message in said.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok()) {
        let (Some(program), Some(manifest)) =
            (message["executable"].as_str(), message["manifest_path"].as_str())
        else {
            continue;
        };
        if message["profile"]["test"].as_bool() != Some(true) {
            continue;
        }
        let folder = Path::new(manifest).parent().context("a manifest stands in no folder")?;
        let package = folder.file_name().unwrap_or_default().to_string_lossy();
        let kind = message["target"]["kind"][0].as_str().unwrap_or_default();
        let target = message["target"]["name"].as_str().unwrap_or_default();
        let name = format!("{package} {}", if kind == "test" { target } else { kind });
        found.push(TestProgram { path: program.into(), folder: folder.to_path_buf(), name });
    }
    Ok(found)
}

impl TestProgram {
    /// Names of its tests.
    pub fn tests(&self) -> Result<Vec<String>> {
        let mut list = Command::new(&self.path);
        let names = quiet(list.args(["--list", "--format", "terse"]).current_dir(&self.folder))?;
        Ok(names.lines().filter_map(|line| line.strip_suffix(": test")).map(str::to_owned).collect())
    }

    /// Runs its tests but those to be left out.
    ///
    /// A program tells each test as it ends and begins the next one of its list at that moment: so much is known of when each began.
    fn run(&self, seed: Option<&str>, left_out: &[&str]) -> Result<Vec<Test>> {
        let names = self.tests()?;
        let mut waiting = names.iter().map(String::as_str).filter(|name| !left_out.contains(name));
        let mut program = Command::new(&self.path);
        program.args(["--exact", "--test-threads", &THREADS.to_string()]);
        program.args(left_out.iter().flat_map(|name| ["--skip", name]));
        program.env("CARGO_MANIFEST_DIR", &self.folder).current_dir(&self.folder);
        program.envs(seed.map(|seed| ("PROPTEST_RNG_SEED", seed)));
        if FACTORING.iter().any(|package| self.name.starts_with(&format!("{package} "))) {
            program.env("RAYON_NUM_THREADS", "1");
        }
        let mut child = program
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .context("cannot start a test program")?;
        let errors = child.stderr.take().context("invariant: its errors are a pipe")?;
        let errors = std::thread::spawn(move || std::io::read_to_string(errors).unwrap_or_default());
        let mut running: Vec<(&str, Instant)> =
            waiting.by_ref().take(THREADS).map(|name| (name, Instant::now())).collect();
        let (mut found, mut said) = (Vec::new(), String::new());
        let lines = BufReader::new(child.stdout.take().context("invariant: its output is a pipe")?).lines();
        for line in lines {
            let line = line?;
            let Some(name) = ended(&line) else {
                said.push_str(&line);
                said.push('\n');
                continue;
            };
            let place = running.iter().position(|(known, _)| *known == name);
            let time = place.map_or(0.0, |place| running.swap_remove(place).1.elapsed().as_secs_f64());
            running.extend(waiting.next().map(|next| (next, Instant::now())));
            found.push(Test { name: format!("{} {name}", self.name), time });
        }
        let status = child.wait()?;
        said.push_str(&errors.join().unwrap_or_default());
        ensure!(status.success(), "the test program `{}` ended with {status}\n{said}", self.name);
        Ok(found)
    }
}

/// What a test took.
struct Test {
    /// Program and test.
    name: String,
    /// [s]
    time: f64,
}

/// Name of the test of whose end a line tells; `None` where it tells of none.
fn ended(line: &str) -> Option<&str> {
    let (name, outcome) = line.strip_prefix("test ")?.rsplit_once(" ... ")?;
    let is_end = matches!(outcome.split(',').next(), Some("ok" | "ignored" | "FAILED"));
    is_end.then(|| name.strip_suffix(" - should panic").unwrap_or(name))
}

/// All tests with the cases of CI, documentation's too; the slowest are listed, and their times kept for `quick`.
pub fn all(profile: Profile) -> Result<String> {
    let programs = programs(profile)?;
    let tests = run(&programs, Some(SEED), &[])?;
    let times: BTreeMap<&str, f64> = tests.iter().map(|test| (test.name.as_str(), test.time)).collect();
    let kept = times_file()?;
    std::fs::create_dir_all(kept.parent().context("invariant: it stands in a folder")?)?;
    std::fs::write(&kept, json!(times).to_string())?;
    println!("{}", slowest(&tests));
    let mut documentation = cargo();
    documentation.args(["test", "--workspace", "--doc", "--quiet"]).args(profile.arguments());
    documentation.env("PROPTEST_RNG_SEED", SEED);
    quiet(documentation.current_dir(root()))?;
    Ok(format!("{} tests in {} programs, and the examples of the documentation", tests.len(), programs.len()))
}

/// The tests that took a second at most in the last whole run, and those that were not there.
pub fn quick() -> Result<String> {
    let programs = programs(Profile::Dev)?;
    let times = match std::fs::read_to_string(times_file()?) {
        Ok(text) => serde_json::from_str(&text)?,
        Err(_) => BTreeMap::<String, f64>::new(),
    };
    let slow: Vec<&str> =
        times.iter().filter(|(_, time)| **time > QUICK).map(|(name, _)| name.as_str()).collect();
    let tests = run(&programs, Some(SEED), &slow)?;
    if times.is_empty() {
        return Ok(format!("{} tests; `cargo xtask test` tells which are slow", tests.len()));
    }
    Ok(format!("{} tests, {} slow ones left out", tests.len(), slow.len()))
}

/// What each test took in the last whole run.
fn times_file() -> Result<PathBuf> {
    Ok(target()?.join("xtask").join("test-times.json"))
}

/// Runs test programs, some at a time; fails with what all failed tests printed.
fn run(programs: &[TestProgram], seed: Option<&str>, left_out: &[&str]) -> Result<Vec<Test>> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    // The largest programs first: the last ones fill what is left.
    let mut order: Vec<&TestProgram> = programs.iter().collect();
    order.sort_by_key(|program| std::cmp::Reverse(program.path.metadata().map_or(0, |data| data.len())));
    std::thread::scope(|scope| {
        for _ in 0..AT_A_TIME {
            scope.spawn(|| {
                while let Some(program) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let prefix = format!("{} ", program.name);
                    let own: Vec<&str> =
                        left_out.iter().filter_map(|name| name.strip_prefix(&prefix)).collect();
                    let tests = program.run(seed, &own);
                    done.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push(tests);
                }
            });
        }
    });
    let (mut tests, mut broken) = (Vec::new(), Vec::new());
    for result in done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()) {
        match result {
            Ok(of_program) => tests.extend(of_program),
            Err(error) => broken.push(format!("{error:#}")),
        }
    }
    if !broken.is_empty() {
        bail!("{} of {} test programs failed\n{}", broken.len(), programs.len(), broken.join("\n"));
    }
    Ok(tests)
}

/// A list of the slowest tests.
fn slowest(tests: &[Test]) -> String {
    let mut tests: Vec<&Test> = tests.iter().collect();
    tests.sort_by(|a, b| b.time.total_cmp(&a.time));
    let total: f64 = tests.iter().map(|test| test.time).sum();
    let lines: Vec<String> =
        tests.iter().take(LISTED).map(|test| format!("   {:6.1} s  {}", test.time, test.name)).collect();
    format!("   slowest of {} tests, {total:.0} s together:\n{}", tests.len(), lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_read_and_the_slowest_are_listed() {
        assert_eq!(ended("test a::b ... ok"), Some("a::b"));
        assert_eq!(ended("test a::b - should panic ... FAILED"), Some("a::b"));
        assert_eq!(ended("test slow ... ignored, needs a server"), Some("slow"));
        for noise in [
            "running 3 tests",
            "test result: ok. 3 passed",
            "test a has been running for over 60 seconds",
            "",
        ] {
            assert_eq!(ended(noise), None, "{noise}");
        }
        let tests = [("x lib a", 0.25), ("x lib b", 1.5)];
        let tests = tests.map(|(name, time)| Test { name: name.to_owned(), time });
        let list = slowest(&tests);
        assert!(list.contains("slowest of 2 tests, 2 s together"), "{list}");
        assert!(list.find("x lib b").unwrap() < list.find("x lib a").unwrap(), "{list}");
    }
}
