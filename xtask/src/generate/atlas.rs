//! The atlas of the sources' figures: its page, and the pictures of this version alone.

use crate::command::quiet;
use crate::workspace::{root, scratch};
use anyhow::Result;
use std::path::Path;
use std::process::Command;

const PAGE: &str = "docs/src/atlas.md";
const PICTURES: &str = "docs/src/images/atlas";

/// Writes them.
pub fn write(program: &Path) -> Result<()> {
    let new = scratch("atlas")?;
    let arguments = ["validate", "--markdown", "--figures"];
    let page = quiet(Command::new(program).args(arguments).arg(&new).current_dir(root()))?;
    std::fs::write(root().join(PAGE), page)?;
    let kept = root().join(PICTURES);
    if kept.is_dir() {
        std::fs::remove_dir_all(&kept)?;
    }
    std::fs::create_dir_all(&kept)?;
    for picture in std::fs::read_dir(&new)? {
        let picture = picture?.path();
        let is_picture = picture.extension().is_some_and(|ending| ending == "svg");
        if let (Some(name), true) = (picture.file_name(), is_picture) {
            std::fs::copy(&picture, kept.join(name))?;
        }
    }
    println!("{PAGE}, {PICTURES}");
    Ok(())
}
