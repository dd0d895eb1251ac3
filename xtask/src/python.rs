//! The Python package: its wheel, and its types, tests, doctests and notebooks, in an environment of their own below the target folder.
//!
//! The wheel is built in the profile of the program and with the same features of the crates that both have, so that the commands of the README
//! have compiled all but its own crate before ([decision 52](../../docs/decisions/0052-python-package.md)).

use crate::command::{cargo, exists, quiet};
use crate::workspace::{root, scratch, target};
use anyhow::{Context, Result, bail, ensure};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What wheel, tests and notebooks need from PyPI. The oldest versions that are known to do; numpy's types need 2.
const PACKAGES: [&str; 20] = [
    "maturin>=1.16,<2",
    "numpy>=2",
    "pytest>=9",
    "mypy>=2",
    "matplotlib>=3.10",
    "pandas>=2.2",
    "pyarrow>=18",
    "duckdb>=1.1",
    "polars>=1",
    "nbclient>=0.10",
    "nbformat>=5.10",
    "ipykernel>=6",
    "distributed>=2024.8",
    "pyuff>=2.4; python_version >= '3.11'",
    "fmpy>=0.3.24",
    "libcosimpy>=0.0.5; python_version >= '3.11'",
    // What pyNastran needs but for NumPy.
    "scipy>=1.11",
    "cpylog>=1.4",
    "docopt-ng>=0.9",
    "colorama",
];

/// Read in tests alone, and installed without what it asks for: it names an older NumPy than the package is tested with, and reads its files with a newer one too.
const ALONE: [&str; 1] = ["pyNastran>=1.4"];

/// Packages that the package's tree has and the program's has not: what a Python module is made with.
const OWN: [&str; 6] =
    ["lanchester-python", "pyo3", "pyo3-build-config", "pyo3-ffi", "pyo3-macros", "pyo3-macros-backend"];

/// Everything that CI runs.
pub fn run(arguments: &[String]) -> Result<String> {
    let (mut dev, mut write) = (false, false);
    for argument in arguments {
        match argument.as_str() {
            "--dev" => dev = true,
            "--write" => write = true,
            other => bail!("`python` knows --dev and --write, got `{other}`"),
        }
    }
    shares_features()?;
    // Answers are compared with those of the command line.
    let mut program = cargo();
    program.args(["build", "--release", "--workspace", "--bin", "lanchester"]);
    quiet(program.current_dir(root()))?;
    // The binary of functional mock-up units, which FMPy loads; with the program it is built with the program's features.
    let mut units = cargo();
    units.args([
        "build",
        "--release",
        "--package",
        "lanchester-cli",
        "--package",
        "lanchester-fmu",
        "--bins",
        "--lib",
    ]);
    quiet(units.current_dir(root()))?;
    let program = target()?.join("release").join(format!("lanchester{}", std::env::consts::EXE_SUFFIX));
    let python = environment()?;
    let wheel = build(&python, dev)?;
    let install =
        ["-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", "--disable-pip-version-check"];
    quiet(Command::new(&python).args(install).arg(&wheel))?;
    written(&python, write)?;
    // Each of the two keeps one processor busy.
    let (tests, rest) = std::thread::scope(|scope| {
        let tests = scope.spawn(|| tests(&python, &program));
        let rest = types_and_notebooks(&python, write);
        (tests.join(), rest)
    });
    let tests = tests.unwrap_or_else(|cause| std::panic::resume_unwind(cause))?;
    let notebooks = rest?;
    let last =
        |text: &str| text.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default().trim().to_owned();
    Ok(format!("{}; {}", last(&tests), last(&notebooks)))
}

/// Tests and doctests of the package that is installed; answers are compared with those of `program`.
fn tests(python: &Path, program: &Path) -> Result<String> {
    let line =
        ["-m", "pytest", "--quiet", "crates/python/tests", "--doctest-modules", "--pyargs", "lanchester"];
    quiet(Command::new(python).args(line).env("LANCHESTER_PROGRAM", program).current_dir(root()))
}

/// Types of the sources and of the native module, and the notebooks; with `write` the lessons of the book, which are the notebooks as they ran.
fn types_and_notebooks(python: &Path, write: bool) -> Result<String> {
    let sources = [
        "-m",
        "mypy",
        "crates/python/python/lanchester",
        "crates/python/tests",
        "crates/python/generate.py",
        "crates/python/reference.py",
    ];
    quiet(Command::new(python).args(sources).current_dir(root()))?;
    let stubs = ["-m", "mypy.stubtest", "lanchester._native"];
    quiet(Command::new(python).args(stubs).current_dir(scratch("stubs")?))?;
    let mut execute = Command::new(python);
    execute.arg("crates/python/notebooks/execute.py").args(write.then_some("--lessons"));
    quiet(execute.current_dir(root()))
}

/// Builds the wheel into the folder `wheels` of the target folder.
pub fn wheel() -> Result<PathBuf> {
    build(&environment()?, false)
}

/// The interpreter of the environment, with all that is needed installed.
fn environment() -> Result<PathBuf> {
    ensure!(exists("python3"), "python3 is missing: install Python 3.10 or newer, and run again");
    let folder = target()?.join("xtask").join("python");
    let interpreter = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
    let (python, holds) = (folder.join(interpreter), folder.join("packages.txt"));
    let wanted = [&PACKAGES[..], &ALONE].concat().join("\n");
    if python.exists() && std::fs::read_to_string(&holds).is_ok_and(|has| has == wanted) {
        return Ok(python);
    }
    quiet(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))
        .context("no environment for Python can be made; on Debian and Ubuntu install python3-venv")?;
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    quiet(Command::new(&python).args(install).args(PACKAGES))?;
    quiet(Command::new(&python).args(install).arg("--no-deps").args(ALONE))?;
    std::fs::write(&holds, wanted)?;
    Ok(python)
}

fn build(python: &Path, dev: bool) -> Result<PathBuf> {
    let folder = target()?.join("wheels");
    let fresh = scratch("wheel")?;
    let profile = if dev { "dev" } else { "release" };
    let mut command = Command::new(python);
    command.args(["-m", "maturin", "build", "--quiet", "--profile", profile, "--interpreter"]).arg(python);
    quiet(command.arg("--out").arg(&fresh).current_dir(root()))?;
    let built = std::fs::read_dir(&fresh)?.next().context("maturin has built no wheel")??;
    std::fs::create_dir_all(&folder)?;
    let wheel = folder.join(built.file_name());
    std::fs::copy(built.path(), &wheel)?;
    Ok(wheel)
}

/// What is written from the package, each with its file: the types of results, which are those of the Rust types, and the reference of the book.
const WRITTEN: [(&[&str], &str); 3] = [
    (&["crates/python/generate.py"], "crates/python/python/lanchester/results.py"),
    (&["crates/python/reference.py", "functions"], "docs/src/guide/python-reference.md"),
    (&["crates/python/reference.py", "results"], "docs/src/guide/python-results.md"),
];

/// What is written is fresh, or becomes so.
fn written(python: &Path, write: bool) -> Result<()> {
    let mut stale = Vec::new();
    for (line, file) in WRITTEN {
        let place = root().join(file);
        let fresh = quiet(Command::new(python).args(line).current_dir(root()))?;
        if std::fs::read_to_string(&place).is_ok_and(|held| held == fresh) {
            continue;
        }
        stale.push(file);
        if write {
            std::fs::write(&place, fresh)?;
            // The reference shows the types that the package has.
            ensure!(
                !file.ends_with("results.py"),
                "the types of the Python package are written; run again to build a wheel with them"
            );
        }
    }
    ensure!(
        write || stale.is_empty(),
        "{} of the Python package {} stale; run `cargo xtask python --write`",
        stale.join(", "),
        if stale.len() == 1 { "is" } else { "are" }
    );
    Ok(())
}

/// Fails where a crate of the package's tree has other features than in the program's: everything above it would be compiled twice.
fn shares_features() -> Result<()> {
    let tree = |package: &str| {
        let arguments =
            ["tree", "--edges", "normal,build", "--prefix", "none", "--format", "{p} [{f}]", "-p", package];
        let text = quiet(cargo().args(arguments).current_dir(root()))?;
        let lines = text.lines().map(|line| line.trim_end_matches(" (*)").to_owned());
        Ok::<BTreeSet<String>, anyhow::Error>(lines.filter(|line| !line.is_empty()).collect())
    };
    let (package, program) = (tree("lanchester-python")?, tree("lanchester-cli")?);
    let is_own = |line: &String| OWN.iter().any(|own| line.starts_with(&format!("{own} ")));
    let other =
        package.difference(&program).filter(|line| !is_own(line) && !line.starts_with("target-lexicon "));
    let other: Vec<&String> = other.collect();
    ensure!(
        other.is_empty(),
        "the Python package gives these crates other features than the program does, so that both compile all that is above them: \
         {other:?}; name the program's features in crates/python/Cargo.toml"
    );
    Ok(())
}
