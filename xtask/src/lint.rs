//! Lints and documentation: no warning passes.

use crate::command::{cargo, quiet};
use crate::workspace::{Profile, root};
use anyhow::Result;

/// Clippy over all targets. Derive macros and build scripts are compiled for one profile alone.
pub fn clippy(profile: Profile) -> Result<()> {
    let mut command = cargo();
    command.args(["clippy", "--workspace", "--all-targets", "--quiet"]).args(profile.arguments());
    quiet(command.args(["--", "--deny", "warnings"]).current_dir(root())).map(drop)
}

/// Documentation of all crates, private items too.
pub fn documentation(profile: Profile) -> Result<()> {
    let arguments = ["doc", "--workspace", "--no-deps", "--document-private-items", "--quiet"];
    let mut command = cargo();
    command.args(arguments).args(profile.arguments());
    quiet(command.env("RUSTDOCFLAGS", "--deny warnings").current_dir(root())).map(drop)
}
