//! `lanchester merge`: the parts of a run become the table that the run would have written.

use crate::commands::explore::{self, answer_of};
use crate::commands::scatter::{self, answer_of_samples, sample_study};
use crate::failure::{DONE, Failure};
use crate::files::print;
use crate::format::Format;
use crate::run::{Head, Held, is_free, join_tables, read_held};
use clap::Args;
use lanchester::file::{EngineFile, read};
use lanchester::study::explore::Explorer;
use lanchester::{LayoutStudy, SavedScatter, SavedSearch};
use lanchester_files::shown;
use serde::de::DeserializeOwned;
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
    /// Rows of the table in the text, of parts of `explore`.
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
                format_args!("{} and {} are not parts of one run", shown(first_path), shown(path)),
                "parts have one engine file, the same options and one version of lanchester",
            ));
        }
    }
    all_there(&parts, of)?;
    is_free(&arguments.output)?;
    let file = read(&head.engine).file.ok_or_else(|| {
        Failure::input("the engine file that the parts hold is not valid for this version", "run them again")
    })?;
    let parts = Parts { paths: parts.into_iter().map(|(_, path)| path).collect(), head, of, file };
    match parts.head.study.as_str() {
        "explore" => parts.explored(arguments),
        "scatter" => parts.scattered(arguments),
        other => Err(Failure::input(
            format_args!("this version of lanchester cannot merge parts of `{other}`"),
            "merge them with the version that wrote them",
        )),
    }
}

/// All parts of a run, in the order of their blocks.
struct Parts {
    paths: Vec<PathBuf>,
    head: Head,
    /// Blocks of the run.
    of: u64,
    file: EngineFile,
}

impl Parts {
    fn request<R: DeserializeOwned>(&self) -> Result<R, Failure> {
        serde_json::from_str(&self.head.request).map_err(|error| {
            Failure::input(format_args!("the request of the parts cannot be read: {error}"), "run them again")
        })
    }

    fn explored(&self, arguments: &MergeArguments) -> Result<u8, Failure> {
        let saved: SavedSearch = self.request()?;
        let explorer = Explorer::new(saved.request).map_err(Failure::refused)?;
        let study = LayoutStudy { explorer, rows: saved.rows };
        let kept = join_tables(&study, &self.head, &self.paths, 0..self.of, &arguments.output)?;
        let answer = answer_of(&self.file.engine, &study.explorer, &kept, saved.notes)?;
        print(&explore::said(&answer, arguments.format, arguments.rows, false)?)?;
        Ok(DONE)
    }

    fn scattered(&self, arguments: &MergeArguments) -> Result<u8, Failure> {
        let saved: SavedScatter = self.request()?;
        let study = sample_study(&saved, &self.file, true)?;
        let tally = join_tables(&study, &self.head, &self.paths, 0..self.of, &arguments.output)?;
        let Some(answer) = answer_of_samples(&saved, &study, &tally)? else {
            return Err(Failure::input("the parts hold no sample", "run them again"));
        };
        print(&scatter::said(&answer, arguments.format)?)?;
        Ok(scatter::status(&answer))
    }
}

/// Refuses parts that leave blocks out, or have some twice.
fn all_there(parts: &[(Held, PathBuf)], of: u64) -> Result<(), Failure> {
    let mut next = 0;
    for (held, path) in parts {
        if held.blocks.start < next {
            return Err(Failure::input(
                format_args!("{} holds blocks that another part holds too", shown(path)),
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
