//! What is given to users: a release archive, and on Debian and its kin a package, both with the same tree of files.

pub mod crates;
mod debian;
mod release;
mod tree;

use crate::command::{cargo, quiet};
use crate::workspace::{root, target};
use anyhow::{Context, Result};
use release::{VERSION, commit_time};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Builds all of it into the folder `dist` of the target folder, and says what is there.
pub fn build() -> Result<String> {
    // As `cargo xtask python` builds them: the binary of units with the features of the program.
    let mut programs = cargo();
    programs.args(["build", "--release", "--package", "lanchester-cli", "--package", "lanchester-fmu"]);
    quiet(programs.args(["--bins", "--lib"]).current_dir(root()))?;
    crate::book::build()?;
    let folder = target()?.join("dist");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    let name = format!("lanchester-{VERSION}-{}-{}", std::env::consts::ARCH, std::env::consts::OS);
    let tree = folder.join(&name);
    tree::write(&tree)?;
    let archive = folder.join(format!("{name}.tar.gz"));
    pack(&folder, &name, &archive)?;
    let mut made = vec![archive];
    if cfg!(target_os = "linux") && crate::command::exists("dpkg-deb") {
        made.push(debian::package(&folder, &tree)?);
    }
    std::fs::remove_dir_all(&tree)?;
    let said = made.iter().map(|file| Ok(format!("{}, {:.1} MB", file.display(), megabytes(file)?)));
    Ok(said.collect::<Result<Vec<String>>>()?.join("\n"))
}

/// Packs the folder `name` below `above`, by name, as nobody's files.
fn pack(above: &Path, name: &str, archive: &Path) -> Result<()> {
    let time = format!("--mtime=@{}", commit_time()?);
    let mut tar = Command::new("tar");
    tar.args(["--create", "--gzip", "--sort=name", "--owner=0", "--group=0", "--numeric-owner"]);
    quiet(tar.arg(time).arg("--file").arg(archive).arg("--directory").arg(above).arg(name).env("GZIP", "-9n"))
        .context("the archive is made with GNU tar")
        .map(drop)
}

fn megabytes(file: &PathBuf) -> Result<f64> {
    Ok(std::fs::metadata(file)?.len() as f64 / 1e6)
}
