//! The studio's page: checked, built, compared with what stands in the repository, tried in a browser.

pub mod web;

use crate::browser::chromium;
use crate::command::{exists, in_view, quiet};
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, bail, ensure};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Most that the built page may weigh, compressed [bytes].
const HEAVIEST: u64 = 1_500_000;

fn folder() -> PathBuf {
    root().join("crates/studio/page")
}

fn npm(arguments: &[&str]) -> Command {
    let mut command = Command::new("npm");
    command.args(arguments).current_dir(folder());
    command
}

/// Installs what the page is built with.
pub fn install() -> Result<()> {
    ensure!(exists("npm"), "npm is missing: install Node.js 20.19 or newer, and run again");
    // What the lock file names stands there already where nothing changed since.
    let (lock, installed) =
        (folder().join("package-lock.json"), folder().join("node_modules/.package-lock.json"));
    let time = |path: &Path| path.metadata().and_then(|data| data.modified());
    if time(&installed).is_ok_and(|installed| time(&lock).is_ok_and(|lock| lock <= installed)) {
        return Ok(());
    }
    quiet(&mut npm(&["ci", "--no-audit", "--no-fund"])).map(|_| ())
}

/// Types, lint, format and unit tests.
pub fn check() -> Result<String> {
    install()?;
    quiet(&mut npm(&["run", "check"]))?;
    quiet(&mut npm(&["run", "unit"])).map(|_| String::new())
}

/// Builds the page into the repository, where the program takes it from.
pub fn build() -> Result<()> {
    install()?;
    quiet(&mut npm(&["run", "build"])).map(|_| ())
}

/// Builds the page that answers by itself, with this module, into a folder.
pub fn build_in_browser(mode: &str, module: &Path, folder: &Path) -> Result<()> {
    let mut command = npm(&["run", "build", "--", "--mode", mode, "--emptyOutDir", "--outDir"]);
    quiet(command.arg(folder).env("LANCHESTER_MODULE", module)).map(|_| ())
}

/// Fails where the built page is not what its source gives now, or too heavy.
pub fn check_built() -> Result<String> {
    let fresh = scratch("page")?;
    quiet(npm(&["run", "build", "--", "--outDir"]).arg(&fresh).arg("--emptyOutDir"))?;
    let (fresh, kept) = (files(&fresh)?, files(&root().join("crates/studio/dist"))?);
    if fresh != kept {
        bail!("the built page is stale; run `cargo xtask page`");
    }
    let packed = scratch("page-weight")?.join("page.tar.gz");
    quiet(
        Command::new("tar").arg("czf").arg(&packed).arg("-C").arg(root().join("crates/studio")).arg("dist"),
    )?;
    let weight = packed.metadata()?.len();
    ensure!(weight <= HEAVIEST, "the page weighs {weight} bytes compressed, more than {HEAVIEST}");
    Ok(format!("{} files, {} kB compressed", kept.len(), weight / 1000))
}

/// All files of a folder with what they hold.
fn files(folder: &Path) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).with_context(|| format!("cannot read {}", next.display()))? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                found.insert(path.strip_prefix(folder)?.to_path_buf(), std::fs::read(&path)?);
            }
        }
    }
    Ok(found)
}

/// The stories of the page in a browser.
pub fn try_in_browser(program: &Path) -> Result<String> {
    in_browser("browser", program).map(|()| String::new())
}

/// The stories of the page that answers by itself, beside the program: of the folder on a file server, or of one file from the disk.
pub fn try_built(place: &Path, program: &Path) -> Result<()> {
    let mut command = npm(&["run", "web"]);
    command.env("LANCHESTER_WEB", place).env("LANCHESTER_PROGRAM", program);
    in_view(command.env("CHROMIUM", full_path(&chromium()?)?))
}

/// Draws the pictures of the studio's guide anew.
pub fn draw(program: &Path) -> Result<()> {
    install()?;
    in_browser("pictures", program)
}

/// Runs a script of the page that drives a browser.
fn in_browser(script: &str, program: &Path) -> Result<()> {
    let mut command = npm(&["run", script]);
    command.env("LANCHESTER_PROGRAM", program).env("CHROMIUM", full_path(&chromium()?)?);
    in_view(&mut command)
}

/// Where a program on the path stands.
fn full_path(program: &Path) -> Result<PathBuf> {
    if program.is_absolute() {
        return Ok(program.to_path_buf());
    }
    let paths = std::env::var_os("PATH").context("there is no PATH")?;
    let found = std::env::split_paths(&paths).map(|folder| folder.join(program)).find(|path| path.is_file());
    found.with_context(|| format!("{} is not on the path", program.display()))
}
