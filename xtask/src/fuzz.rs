//! `cargo xtask fuzz`: libFuzzer on the reader, the loads, workshop sheets, bond graphs, small optima and runs in time, started from the kept corpus.

use crate::command::{exists, in_view, quiet};
use crate::workspace::root;
use anyhow::{Context, Result, bail, ensure};
use std::process::Command;

const TARGETS: [&str; 6] = ["read", "loads", "workshop", "graph", "balance", "simulate"];

/// Options: `--seconds N` for each target (60), `--target T` for one alone.
pub fn run(arguments: &[String]) -> Result<()> {
    let mut seconds = 60_u32;
    let mut targets = TARGETS.to_vec();
    let mut arguments = arguments.iter();
    while let Some(option) = arguments.next() {
        let value = arguments.next().with_context(|| format!("`{option}` needs a value"))?;
        match option.as_str() {
            "--seconds" => {
                seconds = value.parse().with_context(|| format!("`{value}` is no number of seconds"))?;
            }
            "--target" => {
                targets.retain(|target| target == value);
                ensure!(!targets.is_empty(), "no target `{value}`; there are {}", TARGETS.join(", "));
            }
            _ => bail!("unknown option `{option}`; there are --seconds and --target"),
        }
    }
    ready()?;
    for target in targets {
        println!("== fuzz {target} for {seconds} s");
        let corpus = root().join("fuzz/corpus").join(target);
        std::fs::create_dir_all(&corpus)?;
        let mut fuzz = Command::new("cargo");
        fuzz.args(["+nightly", "fuzz", "run", target])
            .arg(&corpus)
            .arg(root().join("fuzz/seeds").join(target));
        fuzz.arg("--").arg(format!("-max_total_time={seconds}")).args(["-timeout=10", "-rss_limit_mb=2048"]);
        in_view(fuzz.current_dir(root())).with_context(|| {
            format!("{target} failed: mend it, then keep the input that fuzz/artifacts/{target} holds in fuzz/seeds/{target}")
        })?;
    }
    Ok(())
}

/// Nightly and cargo-fuzz, the second installed where it is missing.
fn ready() -> Result<()> {
    quiet(Command::new("cargo").args(["+nightly", "--version"]))
        .context("fuzzing needs a nightly toolchain: `rustup toolchain install nightly`")?;
    if !exists("cargo-fuzz") {
        println!("   cargo-fuzz is missing: installing it");
        quiet(Command::new("cargo").args([
            "install",
            "cargo-fuzz",
            "--version",
            "0.13.2",
            "--locked",
            "--quiet",
        ]))?;
    }
    Ok(())
}
