//! Where things are: the root, the target folder, the tracked files, the program itself.

use crate::command::{cargo, quiet};
use anyhow::{Context, Result};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Root of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("invariant: xtask lies in the workspace")
}

/// What `cargo metadata` says of the workspace's own packages.
pub fn metadata() -> Result<Value> {
    let text = quiet(cargo().args(["metadata", "--no-deps", "--format-version", "1"]).current_dir(root()))?;
    serde_json::from_str(&text).context("cargo metadata did not print JSON")
}

/// The target folder.
pub fn target() -> Result<PathBuf> {
    let metadata = metadata()?;
    let folder = metadata["target_directory"].as_str().context("cargo metadata names no target folder")?;
    Ok(PathBuf::from(folder))
}

/// An empty scratch folder below the target folder.
pub fn scratch(name: &str) -> Result<PathBuf> {
    let folder = target()?.join("xtask").join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// How tests and program are compiled.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Profile {
    /// Compiled anew in seconds after a change: for the next change.
    Dev,
    /// What users get: for the whole of CI, so that nothing is compiled in two profiles.
    Release,
}

impl Profile {
    /// Its option of cargo's.
    pub fn arguments(self) -> &'static [&'static str] {
        match self {
            Profile::Dev => &[],
            Profile::Release => &["--release"],
        }
    }

    /// Its folder below the target folder.
    fn folder(self) -> &'static str {
        match self {
            Profile::Dev => "debug",
            Profile::Release => "release",
        }
    }
}

/// The program `lanchester`, built as the tests build it: same features, nothing compiled twice. Features of the tests' own dependencies
/// count where a test is built too: one small one is.
pub fn program(profile: Profile) -> Result<PathBuf> {
    let mut build = cargo();
    build.args(["build", "--workspace", "--bins", "--test", "new_file"]).args(profile.arguments());
    quiet(build.current_dir(root()))?;
    let name = format!("lanchester{}", std::env::consts::EXE_SUFFIX);
    Ok(target()?.join(profile.folder()).join(name))
}

/// Files that git tracks or would track, relative to the root, with `/`, by name: a new file has its place before it is added.
pub fn files() -> Result<Vec<String>> {
    let listing = quiet(
        Command::new("git")
            .args(["ls-files", "--cached", "--others", "--exclude-standard"])
            .current_dir(root()),
    )?;
    let mut files: Vec<String> =
        listing.lines().filter(|file| root().join(file).is_file()).map(str::to_owned).collect();
    files.sort_unstable();
    Ok(files)
}

/// Text of a file given relative to the root; `None` if it is not UTF-8 text.
pub fn text(file: &str) -> Result<Option<String>> {
    let bytes = std::fs::read(root().join(file)).with_context(|| format!("cannot read {file}"))?;
    Ok(String::from_utf8(bytes).ok())
}
