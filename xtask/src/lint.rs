//! Lints and documentation, from one check of the workspace.
//!
//! `cargo clippy` is `cargo check` with clippy in the place of the compiler, for the workspace's own crates. Documentation needs a check
//! too: with the same compiler and the same words for it, cargo takes the one that is there.

use crate::command::{cargo, quiet};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// No warning passes. As `cargo clippy` hands words on to clippy.
const WORDS: &str = "--deny__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__";

/// Clippy over all targets.
pub fn clippy() -> Result<()> {
    checked(&["check", "--workspace", "--all-targets", "--quiet"], None)
}

/// Documentation of all crates, private items too.
pub fn documentation() -> Result<()> {
    let arguments = ["doc", "--workspace", "--no-deps", "--document-private-items", "--quiet"];
    checked(&arguments, Some(("RUSTDOCFLAGS", "--deny warnings")))
}

fn checked(arguments: &[&str], more: Option<(&str, &str)>) -> Result<()> {
    let mut command = cargo();
    command.args(arguments).env("RUSTC_WORKSPACE_WRAPPER", driver()?).env("CLIPPY_ARGS", WORDS).envs(more);
    quiet(command.current_dir(root())).map(drop)
}

/// Clippy itself, of the toolchain in use.
fn driver() -> Result<PathBuf> {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let folder = quiet(Command::new(compiler).args(["--print", "sysroot"]).current_dir(root()))?;
    let driver =
        Path::new(folder.trim()).join("bin").join(format!("clippy-driver{}", std::env::consts::EXE_SUFFIX));
    ensure!(driver.is_file(), "clippy is missing: run `rustup component add clippy`");
    driver.canonicalize().context("clippy cannot be found")
}
