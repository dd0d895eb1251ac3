//! Pages and pictures that the program writes, and sketches from computed coordinates.

mod atlas;
mod chart;
mod curves;
mod document;
mod list;
mod panels;
mod pen;
mod sketch;
mod theory;
mod written;

use crate::tolerances;
use crate::workspace::{Profile, program, root};
use anyhow::{Context, Result, bail};
use curves::CURVES;
use list::{PUBLISHED, WRITTEN};
use std::path::Path;
use theory::THEORY;
use written::{Figures, Written};

/// Writes every file.
pub fn write(profile: Profile) -> Result<()> {
    tolerances::write()?;
    let program = program(profile)?;
    write_all(&WRITTEN, &program)?;
    atlas::write(&program)?;
    write_pictures(&program)
}

/// Writes the pictures of the theory alone, which is soon done.
pub fn write_theory() -> Result<()> {
    write_pictures(&program(Profile::Release)?)
}

fn write_pictures(program: &Path) -> Result<()> {
    for sketch in sketch::all() {
        write_file(&sketch.file(), &sketch.svg())?;
    }
    for curve in &CURVES {
        write_file(&curve.file(), &curve.svg(program)?)?;
    }
    write_all(&THEORY, program)
}

fn write_all(list: &[Written], program: &Path) -> Result<()> {
    let mut figures = Figures::new();
    for written in list {
        write_file(written.file, &written.text(program, &mut figures)?)?;
    }
    Ok(())
}

fn write_file(file: &str, text: &str) -> Result<()> {
    std::fs::write(root().join(file), text)?;
    println!("{file}");
    Ok(())
}

/// Fails where a file is not what the program writes now.
///
/// The page of published numbers takes a minute of two processors; tests of the crate `validation`, which need all numbers and figures in any
/// case, hold it and the atlas.
pub fn check(program: &Path) -> Result<String> {
    let (mut stale, mut figures, mut files) = (Vec::new(), Figures::new(), 0);
    let mut hold = |file: &str, now: String| -> Result<()> {
        let kept =
            std::fs::read_to_string(root().join(file)).with_context(|| format!("cannot read {file}"))?;
        files += 1;
        if kept != now {
            stale.push(file.to_owned());
        }
        Ok(())
    };
    for sketch in sketch::all() {
        hold(&sketch.file(), sketch.svg())?;
    }
    for curve in &CURVES {
        hold(&curve.file(), curve.svg(program)?)?;
    }
    for written in WRITTEN.iter().chain(&THEORY).filter(|written| written.file != PUBLISHED) {
        hold(written.file, written.text(program, &mut figures)?)?;
    }
    if !stale.is_empty() {
        bail!("stale: {}; run `cargo xtask generate`", stale.join(", "));
    }
    Ok(format!("{files} files"))
}
