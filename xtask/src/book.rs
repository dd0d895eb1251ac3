//! Building the book with mdBook, which is installed below the target folder where it is missing.

use crate::command::{cargo, exists, quiet};
use crate::workspace::{root, target};
use anyhow::Result;
use std::path::PathBuf;
use std::process::Command;

const MDBOOK: &str = "0.4.52";

/// Builds `docs/book`.
pub fn build() -> Result<()> {
    quiet(Command::new(mdbook()?).args(["build", "docs"]).current_dir(root())).map(drop)
}

/// The mdBook on the path, or our own.
fn mdbook() -> Result<PathBuf> {
    if exists("mdbook") {
        return Ok("mdbook".into());
    }
    let tools = target()?.join("tools");
    let own = tools.join("bin").join(format!("mdbook{}", std::env::consts::EXE_SUFFIX));
    if !own.exists() {
        println!("   mdbook is missing: installing {MDBOOK} below {}", tools.display());
        let mut install = cargo();
        install.args(["install", "mdbook", "--version", MDBOOK, "--locked", "--quiet", "--debug"]);
        // It builds one book: neither server nor optimised code is worth the minutes.
        install.args(["--no-default-features", "--features", "search", "--root"]);
        quiet(install.arg(&tools).current_dir(root()))?;
    }
    Ok(own)
}
