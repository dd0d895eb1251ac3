//! Lints and documentation: no warning passes.

use crate::command::{cargo, quiet};
use crate::workspace::{Profile, root};
use anyhow::Result;
use std::path::Path;
use std::process::Command;

/// Clippy over all targets. Derive macros and build scripts are compiled for one profile alone.
pub fn clippy(profile: Profile) -> Result<()> {
    let mut command = cargo();
    command.args(["clippy", "--workspace", "--all-targets", "--quiet"]).args(profile.arguments());
    quiet(command.args(["--", "--deny", "warnings"]).current_dir(root())).map(drop)
}

/// Documentation of all crates, private items too. Each crate is checked by Clippy's compiler with Clippy's arguments, as [`clippy`] has
/// checked it: so it is checked once for both.
pub fn documentation(profile: Profile) -> Result<()> {
    let arguments = ["doc", "--workspace", "--no-deps", "--document-private-items", "--quiet"];
    let mut command = cargo();
    command.args(arguments).args(profile.arguments());
    let place = quiet(Command::new("rustc").args(["--print", "sysroot"]))?;
    let driver =
        Path::new(place.trim()).join("bin").join(format!("clippy-driver{}", std::env::consts::EXE_SUFFIX));
    command.env("RUSTC_WORKSPACE_WRAPPER", driver);
    command.env("CLIPPY_ARGS", "--deny__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__");
    quiet(command.env("RUSTDOCFLAGS", "--deny warnings").current_dir(root())).map(drop)
}
