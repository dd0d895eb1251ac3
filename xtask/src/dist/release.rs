//! Which release it is.

use crate::command::quiet;
use crate::workspace::root;
use anyhow::Result;
use std::process::Command;

/// Version of the workspace, which all its crates have.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Seconds since 1970 of the last commit: what is packed from it is the same whenever it is packed.
pub fn commit_time() -> Result<String> {
    let time = quiet(Command::new("git").args(["log", "-1", "--format=%ct"]).current_dir(root()))?;
    Ok(time.trim().to_owned())
}
