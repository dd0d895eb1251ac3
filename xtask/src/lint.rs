//! Lints and documentation: no warning passes.

use crate::command::{cargo, quiet};
use crate::workspace::root;
use anyhow::Result;

/// Clippy over all targets.
pub fn clippy() -> Result<()> {
    let arguments = ["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"];
    quiet(cargo().args(arguments).current_dir(root())).map(drop)
}

/// Documentation of all crates, private items too.
pub fn documentation() -> Result<()> {
    let arguments = ["doc", "--workspace", "--no-deps", "--document-private-items", "--quiet"];
    let mut command = cargo();
    quiet(command.args(arguments).env("RUSTDOCFLAGS", "--deny warnings").current_dir(root())).map(drop)
}
