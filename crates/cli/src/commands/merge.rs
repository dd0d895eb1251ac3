//! `lanchester merge`: the parts of a run become the table that the run would have written.

use crate::commands::explore::{SavedSearch, answer_of, said};
use crate::explore_request::refused;
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::run::{Held, is_free, join_tables, read_held};
use clap::Args;
use lanchester::LayoutStudy;
use lanchester::model::read;
use lanchester::study::explore::Explorer;
use std::path::PathBuf;

/// `merge`
#[derive(Debug, Args)]
pub struct MergeArguments {
    /// The parts, in any order: tables written with --part.
    #[arg(required = true, value_name = "PART")]
    pub parts: Vec<PathBuf>,
    /// The whole table, .parquet or .csv; never overwrites.
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
    /// Rows of the table in the text.
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub rows: usize,
    /// Form of the answer.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

pub fn run(arguments: &MergeArguments) -> Result<u8, Failure> {
    let mut parts = Vec::with_capacity(arguments.parts.len());
    for path in &arguments.parts {
        parts.push((read_held(path)?, path.clone()));
    }
    parts.sort_by_key(|(held, _)| (held.blocks.start, held.blocks.end));
    let (first, first_path) = &parts[0];
    let head = first.head.clone();
    let of = first.of;
    for (held, path) in &parts {
        if held.head != head || held.of != of {
            return Err(Failure::input(
                format_args!("{} and {} are not parts of one run", first_path.display(), path.display()),
                "parts have one engine file, the same options and one version of lanchester",
            ));
        }
    }
    all_there(&parts, of)?;
    is_free(&arguments.output)?;
    if head.study != "explore" {
        return Err(Failure::input(
            format_args!("this version of lanchester cannot merge parts of `{}`", head.study),
            "merge them with the version that wrote them",
        ));
    }
    let saved: SavedSearch = serde_json::from_str(&head.request).map_err(|error| {
        Failure::input(format_args!("the request of the parts cannot be read: {error}"), "run them again")
    })?;
    let explorer = Explorer::new(saved.request.clone()).map_err(refused)?;
    let study = LayoutStudy { explorer, rows: saved.rows };
    let paths: Vec<PathBuf> = parts.iter().map(|(_, path)| path.clone()).collect();
    let kept = join_tables(&study, &head, &paths, 0..of, &arguments.output)?;
    let engine = read(&head.engine).engine.ok_or_else(|| {
        Failure::input("the engine file that the parts hold is not valid for this version", "run them again")
    })?;
    let answer = answer_of(&engine, &study.explorer, &kept, saved.notes)?;
    print(&said(&answer, arguments.format, arguments.rows, false)?)?;
    Ok(DONE)
}

/// Refuses parts that leave blocks out, or have some twice.
fn all_there(parts: &[(Held, PathBuf)], of: u64) -> Result<(), Failure> {
    let mut next = 0;
    for (held, path) in parts {
        if held.blocks.start < next {
            return Err(Failure::input(
                format_args!("{} holds blocks that another part holds too", path.display()),
                "name every part once",
            ));
        }
        if held.blocks.start > next {
            break;
        }
        next = held.blocks.end;
    }
    if next == of {
        return Ok(());
    }
    let missing = parts.iter().map(|(held, _)| held.blocks.start).find(|start| *start > next).unwrap_or(of);
    Err(Failure::input(
        format_args!("a part is missing: blocks {next} to {missing} of {of} are in none of them"),
        "run that part, or name its table too",
    ))
}
