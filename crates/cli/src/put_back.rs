//! What was found, put into the engine file.

use crate::commands::Opened;
use crate::failure::Failure;
use crate::files::{print, rewrite};
use lanchester::file::{WriteBackError, difference, render, write_back};
use lanchester::model::Engine;
use std::path::Path;

/// What `--write` and `--dry-run` ask of a file.
pub struct PutBack<'a> {
    /// The engine file.
    pub path: &'a Path,
    /// Whether it is written.
    pub write: bool,
    /// Whether the difference is shown instead.
    pub dry_run: bool,
    /// What was found, in a word: "weights".
    pub what: &'static str,
}

impl PutBack<'_> {
    /// The file gets the weights, shapes and shafts of `after`, or the difference is shown and all is said (`true`).
    pub fn run(&self, opened: &Opened, after: &Engine, colour: bool) -> Result<bool, Failure> {
        let PutBack { path, write, dry_run, what } = *self;
        if !(write || dry_run) {
            return Ok(false);
        }
        if write && path == Path::new("-") {
            return Err(Failure::input(
                "--write needs a file, got standard input",
                "give the path of the engine file",
            ));
        }
        let (name, before) = (&opened.source.name, &opened.source.text);
        let text = write_back(before, after).map_err(|error| {
            if let WriteBackError::Weights { text, diagnostics } = &error {
                eprint!("{}", render(diagnostics, &format!("the file with its {what}"), text, colour));
            }
            let hint = format!("the file is as it was; the found {what} stand in the output without --write");
            Failure::input(error, hint)
        })?;
        let same = text == *before;
        if same {
            eprintln!("{name} already holds these {what}");
        }
        if dry_run {
            print(&difference(before, &text, name))?;
            return Ok(true);
        }
        if !same {
            rewrite(path, before, &text)?;
            eprintln!("{what} written into {name}");
        }
        Ok(false)
    }
}
