//! The studio that needs no server: the answers as a WebAssembly module, with the page in a folder for a file server and in one file.

use crate::command::{cargo, exists, output, quiet};
use crate::page;
use crate::workspace::{root, scratch, target};
use anyhow::{Context, Result, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

const TRIPLE: &str = "wasm32-unknown-unknown";
/// The profile, and the folder that it writes to.
const PROFILE: &str = "web";
const MODULE: &str = "lanchester_web.wasm";
/// The page that is one file.
const FILE: &str = "lanchester.html";
/// Vectors of 128 bits, which all browsers have since 2023, and room on the stack as a thread of the server has.
const FLAGS: &str = "-C target-feature=+simd128 -C link-arg=-zstack-size=4194304";
/// Most that the page in one file may weigh [bytes]: it is sent by mail.
const HEAVIEST: u64 = 12_000_000;

/// What compiles for WebAssembly here.
enum Toolchain {
    /// The one that runs this task, for which rustup has added the standard library.
    Own,
    /// Debian's, which compiles the standard library along.
    Debian,
}

impl Toolchain {
    /// What there is; `None` where nothing compiles for WebAssembly.
    fn find() -> Option<Toolchain> {
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let library = output(Command::new(rustc).args(["--print", "target-libdir", "--target", TRIPLE]));
        let is_there = |folder: &str| {
            let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
            files.into_iter().any(|file| file.file_name().to_string_lossy().starts_with("libstd-"))
        };
        if library.is_ok_and(|said| said.status == 0 && is_there(said.stdout.trim())) {
            return Some(Toolchain::Own);
        }
        let sources = Path::new("/usr/lib/rustlib/src/rust/library/std");
        let is_debian = sources.is_dir() && exists("/usr/bin/cargo") && exists("/usr/bin/rustc");
        is_debian.then_some(Toolchain::Debian)
    }

    /// Its cargo.
    fn cargo(&self) -> Result<Command> {
        let mut command = match self {
            Toolchain::Own => cargo(),
            Toolchain::Debian => {
                let mut command = Command::new("/usr/bin/cargo");
                // What the other toolchain sets for what it starts is not for this one.
                command.env_remove("CARGO").env_remove("RUSTUP_TOOLCHAIN").env_remove("RUSTC_WRAPPER");
                command.env("RUSTC", "/usr/bin/rustc").env("RUSTC_BOOTSTRAP", "1");
                command
            }
        };
        // A folder of its own: the other builds neither wait for this one nor find their crates compiled anew.
        command.args(["build", "--package", "lanchester-web", "--target", TRIPLE, "--profile", PROFILE]);
        command.arg("--target-dir").arg(target()?.join("wasm")).current_dir(root());
        if matches!(self, Toolchain::Debian) {
            command.args(["-Z", "build-std=std,panic_abort"]);
        }
        Ok(command)
    }
}

const INSTALL: &str = "the studio for the browser needs Rust for wasm32-unknown-unknown: `rustup target add wasm32-unknown-unknown`, or on Debian \
                       `apt-get install rustc-web cargo-web rust-web-src`; then run again";

/// Builds it into `target/web` and returns the folder.
pub fn build() -> Result<PathBuf> {
    page::install()?;
    let module = module()?;
    let folder = target()?.join("web");
    page::build_in_browser("web", &module, &folder)?;
    let file = scratch("web-file")?;
    page::build_in_browser("web-file", &module, &file)?;
    std::fs::copy(file.join(FILE), folder.join(FILE)).context("the page in one file was not built")?;
    std::fs::copy(root().join("crates/studio/third-party.txt"), folder.join("third-party.txt"))?;
    let weight = folder.join(FILE).metadata()?.len();
    ensure!(weight <= HEAVIEST, "{FILE} weighs {weight} bytes, more than {HEAVIEST}");
    Ok(folder)
}

/// Builds it and walks through it in a browser, beside the program, where something compiles for WebAssembly.
pub fn try_in_browser(program: &Path) -> Result<String> {
    if Toolchain::find().is_none() {
        return Ok(format!("left out: {INSTALL}"));
    }
    let folder = build()?;
    page::try_built(&folder, program)?;
    page::try_built(&folder.join(FILE), program)?;
    let kilobytes = |name: &str| folder.join(name).metadata().map(|data| data.len() / 1000);
    Ok(format!("module {} kB, one file {} kB", kilobytes("lanchester.wasm")?, kilobytes(FILE)?))
}

/// Compiles the module.
fn module() -> Result<PathBuf> {
    let Some(toolchain) = Toolchain::find() else { bail!(INSTALL) };
    let mut command = toolchain.cargo()?;
    command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", FLAGS);
    let commit = quiet(Command::new("git").args(["rev-parse", "--short=12", "HEAD"]).current_dir(root()));
    if let Ok(commit) = commit {
        command.env("LANCHESTER_COMMIT", commit.trim());
    }
    quiet(&mut command)?;
    Ok(target()?.join("wasm").join(TRIPLE).join(PROFILE).join(MODULE))
}
