//! Writes the commit into the program, so that a report tells what made it.

use std::path::Path;
use std::process::Command;

/// What cargo writes into a package of the commit that it was made from.
const PACKED_FROM: &str = ".cargo_vcs_info.json";
/// Digits of a commit that are shown.
const DIGITS: usize = 12;

fn main() {
    let commit = match Path::new(PACKED_FROM).exists() {
        true => packed_from(),
        false => checked_out(),
    };
    let commit = commit.as_deref().unwrap_or("unknown commit");
    println!("cargo::rustc-env=LANCHESTER_COMMIT={commit}");
}

/// The commit of a clone.
fn checked_out() -> Option<String> {
    println!("cargo::rerun-if-changed=../../.git/HEAD");
    println!("cargo::rerun-if-changed=../../.git/refs/heads");
    let words = ["rev-parse", &format!("--short={DIGITS}"), "HEAD"];
    let output = Command::new("git").args(words).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}

/// The commit of a package: a repository that a package happens to lie in is another's.
fn packed_from() -> Option<String> {
    println!("cargo::rerun-if-changed={PACKED_FROM}");
    let text = std::fs::read_to_string(PACKED_FROM).ok()?;
    let (_, after) = text.split_once("\"sha1\": \"")?;
    after.get(..DIGITS).map(str::to_owned)
}
