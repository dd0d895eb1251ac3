//! Pages of the book that the program writes.

use crate::command::quiet;
use crate::workspace::{program, root};
use anyhow::{Context, Result, bail};
use std::path::Path;
use std::process::Command;

/// Each page and the arguments that make the program print it.
const PAGES: [(&str, &[&str]); 2] = [
    ("docs/src/engine-file.md", &["schema", "--markdown"]),
    ("docs/src/validation.md", &["validate", "--markdown"]),
];

/// Writes every page.
pub fn write() -> Result<()> {
    let program = program()?;
    for (page, arguments) in PAGES {
        std::fs::write(root().join(page), text(&program, arguments)?)?;
        println!("{page}");
    }
    Ok(())
}

/// Fails where a page is not what the program prints now.
pub fn check(program: &Path) -> Result<String> {
    let mut stale = Vec::new();
    for (page, arguments) in PAGES {
        let kept =
            std::fs::read_to_string(root().join(page)).with_context(|| format!("cannot read {page}"))?;
        if kept != text(program, arguments)? {
            stale.push(page);
        }
    }
    if !stale.is_empty() {
        bail!("stale pages: {}; run `cargo xtask generate`", stale.join(", "));
    }
    Ok(format!("{} generated pages", PAGES.len()))
}

fn text(program: &Path, arguments: &[&str]) -> Result<String> {
    quiet(Command::new(program).args(arguments).current_dir(root()))
}
