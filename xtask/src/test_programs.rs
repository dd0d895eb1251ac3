//! The tests: every test program of the workspace, built once, with the time of each test.
//!
//! The programs are run here and not by `cargo test`, so that two of them share the processors where one waits for its last long test,
//! and so that the slowest tests are known.

use crate::command::{cargo, quiet};
use crate::workspace::{root, target};
use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What the random cases of the tests are drawn from: a change is judged by its own cases only (decision 20).
const SEED: &str = "1";
/// How many of the slowest tests are listed.
const LISTED: usize = 10;
/// Tests that took longer in the last whole run are left out of a quick one [s].
const QUICK: f64 = 1.0;
/// Test programs that run at a time, each with a thread a processor.
const AT_A_TIME: usize = 2;

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
pub fn programs() -> Result<Vec<TestProgram>> {
    let mut build = cargo();
    build.args(["test", "--workspace", "--no-run", "--message-format", "json-render-diagnostics"]);
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
    fn run(&self, seed: Option<&str>, left_out: &[&str]) -> Result<Vec<Test>> {
        let mut program = Command::new(&self.path);
        // What a test takes is known to libtest, which tells it only to who says that it need not stay so. The program is compiled
        // already: nothing of ours may use what is not stable.
        program.env("RUSTC_BOOTSTRAP", "1").args(["-Z", "unstable-options", "--format", "json"]);
        program.arg("--report-time").arg("--exact");
        program.args(left_out.iter().flat_map(|name| ["--skip", name]));
        program.env("CARGO_MANIFEST_DIR", &self.folder).current_dir(&self.folder);
        program.envs(seed.map(|seed| ("PROPTEST_RNG_SEED", seed)));
        let mut child = program.stdout(Stdio::piped()).spawn().context("cannot start a test program")?;
        let mut found = Vec::new();
        let lines = BufReader::new(child.stdout.take().context("invariant: its output is a pipe")?).lines();
        for line in lines {
            found.extend(test(&self.name, &line?));
        }
        let status = child.wait()?;
        // A program that is killed or stops by itself reports no failed test.
        ensure!(
            status.success() || found.iter().any(|test| test.failure.is_some()),
            "the test program `{}` ended with {status}",
            self.name
        );
        Ok(found)
    }
}

/// How a test went.
struct Test {
    /// Program and test.
    name: String,
    /// [s]
    time: f64,
    /// What it printed, where it failed.
    failure: Option<String>,
}

/// Reads a line of the report of a test program; `None` where it is no result of a test.
fn test(program: &str, line: &str) -> Option<Test> {
    let line: Value = serde_json::from_str(line).ok()?;
    let failed = match (line["type"].as_str()?, line["event"].as_str()?) {
        ("test", "ok") => false,
        ("test", "failed" | "timeout") => true,
        _ => return None,
    };
    let said = line["stdout"].as_str().unwrap_or("it printed nothing").to_owned();
    Some(Test {
        name: format!("{program} {}", line["name"].as_str()?),
        time: line["exec_time"].as_f64().unwrap_or_default(),
        failure: failed.then_some(said),
    })
}

/// All tests with the cases of CI, documentation's too; the slowest are listed, and their times kept for `quick`.
pub fn all() -> Result<String> {
    let programs = programs()?;
    let tests = run(&programs, Some(SEED), &[])?;
    let times: BTreeMap<&str, f64> = tests.iter().map(|test| (test.name.as_str(), test.time)).collect();
    let kept = times_file()?;
    std::fs::create_dir_all(kept.parent().context("invariant: it stands in a folder")?)?;
    std::fs::write(&kept, json!(times).to_string())?;
    println!("{}", slowest(&tests));
    let mut documentation = cargo();
    documentation.args(["test", "--workspace", "--doc", "--quiet"]).env("PROPTEST_RNG_SEED", SEED);
    quiet(documentation.current_dir(root()))?;
    Ok(format!("{} tests in {} programs, and the examples of the documentation", tests.len(), programs.len()))
}

/// The tests that took a second at most in the last whole run, and those that were not there.
pub fn quick() -> Result<String> {
    let programs = programs()?;
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
    let failed =
        tests.iter().filter_map(|test| Some(format!("-- {}\n{}", test.name, test.failure.as_ref()?)));
    broken.extend(failed);
    if !broken.is_empty() {
        bail!("{} of {} tests failed\n{}", broken.len(), tests.len(), broken.join("\n"));
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
        let ok = r#"{ "type": "test", "name": "a::b", "event": "ok", "exec_time": 0.25 }"#;
        let failed =
            r#"{ "type": "test", "name": "c", "event": "failed", "exec_time": 1.5, "stdout": "left\n" }"#;
        let started = r#"{ "type": "test", "event": "started", "name": "a::b" }"#;
        let suite = r#"{ "type": "suite", "event": "ok", "passed": 1 }"#;
        assert!(test("x", started).is_none() && test("x", suite).is_none() && test("x", "noise").is_none());
        let tests: Vec<Test> = [ok, failed].iter().filter_map(|line| test("x lib", line)).collect();
        assert_eq!(
            (tests[0].name.as_str(), tests[0].time, tests[0].failure.as_deref()),
            ("x lib a::b", 0.25, None)
        );
        assert_eq!(tests[1].failure.as_deref(), Some("left\n"));
        assert_eq!(
            slowest(&tests),
            "   slowest of 2 tests, 2 s together:\n      1.5 s  x lib c\n      0.2 s  x lib a::b"
        );
    }
}
