//! Long runs: all cores, progress on standard error, stopped and gone on with at any block, in parts.
//!
//! While a run lasts, what is done lies in a folder beside the table, `TABLE.run`, as small tables of their own that anything can read:
//! each holds a stretch of blocks. At the end they become one table, whose bytes depend on the study alone.

mod folder;
mod head;
mod progress;
pub mod table_file;

pub use lanchester::run::{Head, Held};

use crate::failure::{Failure, NOT_AS_EXPECTED};
use folder::Folder;
use head::held_of;
use lanchester::run::{Study, part, stretch};
use lanchester::table::{Column, Form, Rows};
use lanchester_files::shown;
use progress::Progress;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// What is done is put on the disk when it is a tenth of the time of this run, at least and at most so long, or so many values: a
/// killed run loses little, a long one leaves no crowd of tables, and memory does not grow with it.
const PATIENCE: [Duration; 2] = [Duration::from_millis(250), Duration::from_secs(20)];
const MOST_VALUES: usize = 1 << 24;

/// Blocks for each thread between two looks at the clock.
const BLOCKS_PER_THREAD: u64 = 4;

/// `--part 2/3`: the second of three.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PartOf {
    pub part: u64,
    pub parts: u64,
}

impl std::str::FromStr for PartOf {
    type Err = String;

    fn from_str(text: &str) -> Result<PartOf, String> {
        let numbers = text.split_once('/').and_then(|(part, parts)| {
            Some((part.trim().parse::<u64>().ok()?, parts.trim().parse::<u64>().ok()?))
        });
        match numbers {
            Some((part, parts)) if (1..=parts).contains(&part) => Ok(PartOf { part, parts }),
            _ => Err(format!("a part is k/n with k from 1 to n, such as 2/3, got `{text}`")),
        }
    }
}

/// Runs a study without a table.
pub fn run_alone<S: Study>(study: &S) -> Result<S::Kept, Failure> {
    let blocks = 0..study.blocks();
    let progress = Progress::new(study.cases(blocks.clone()), 0);
    let mut kept = study.nothing();
    let mut next = 0;
    while next < blocks.end {
        let batch = next..blocks.end.min(next + batch());
        let (more, _) = stretch(study, batch.clone()).map_err(Failure::refused)?;
        kept = study.join(kept, more).map_err(Failure::refused)?;
        next = batch.end;
        progress.at(study.cases(0..next));
    }
    progress.done();
    Ok(kept)
}

/// Runs a study, or a part of it, into a table; goes on where an earlier run stopped.
pub fn run_into<S: Study>(
    study: &S,
    head: &Head,
    path: &Path,
    of: Option<PartOf>,
) -> Result<S::Kept, Failure> {
    let form = table_file::form(path)?;
    let PartOf { part: k, parts } = of.unwrap_or(PartOf { part: 1, parts: 1 });
    let blocks = part(study.blocks(), k, parts).expect("invariant: a part is from 1 to the number of parts");
    if parts > 1 && form == Form::Csv {
        return Err(Failure::input(
            "a part must be a Parquet file, so that it knows what it is a part of",
            "write parts as .parquet; merging them can write .csv",
        ));
    }
    if let Some(held) = table_file::held(path)? {
        if held.head == *head && held.blocks == blocks {
            eprintln!("{} holds this already; nothing is computed again", shown(path));
            return Ok(held.kept()?);
        }
        return Err(Failure::input(
            format_args!("{} holds something else and is not overwritten", shown(path)),
            "choose another name, or remove it first",
        ));
    }
    let folder = Folder::open(path, head, blocks.clone(), study.blocks())?;
    let stop = Arc::new(AtomicBool::new(false));
    let heard = Arc::clone(&stop);
    // Where signals cannot be heard, a stop costs what is not yet on the disk: no more than seconds.
    let _ = ctrlc::set_handler(move || heard.store(true, Ordering::Relaxed));
    let total = blocks.end - blocks.start;
    let mut done: u64 = folder.done().iter().map(|blocks| blocks.end - blocks.start).sum();
    let mut cases: u128 = folder.done().iter().map(|blocks| study.cases(blocks.clone())).sum();
    let progress = Progress::new(study.cases(blocks.clone()), cases);
    if done > 0 {
        progress.say(&format!("going on after {done} of {total} blocks"));
    }
    let began = Instant::now();
    let width = study.columns().len();
    for missing in folder.missing() {
        let mut next = missing.start;
        while next < missing.end {
            let started = Instant::now();
            let patience = (began.elapsed() / 10).clamp(PATIENCE[0], PATIENCE[1]);
            let from = next;
            let mut kept = study.nothing();
            let mut rows = Rows::empty(&study.columns());
            while next < missing.end {
                let batch = next..missing.end.min(next + batch());
                let (more, found) = stretch(study, batch.clone()).map_err(Failure::refused)?;
                kept = study.join(kept, more).map_err(Failure::refused)?;
                rows.append(found);
                next = batch.end;
                progress.at(cases + study.cases(from..next));
                if stop.load(Ordering::Relaxed)
                    || started.elapsed() > patience
                    || rows.len() * width >= MOST_VALUES
                {
                    break;
                }
            }
            folder.put(head, &study.columns(), from..next, &kept, rows)?;
            done += next - from;
            cases += study.cases(from..next);
            if stop.load(Ordering::Relaxed) && done < total {
                progress.done();
                return Err(Failure {
                    status: NOT_AS_EXPECTED,
                    message: format!(
                        "stopped after {done} of {total} blocks; what is done lies in {}\nhint: the same command goes on from there",
                        shown(folder.path())
                    ),
                });
            }
        }
    }
    progress.done();
    let kept = join_tables(study, head, &folder.tables()?, blocks, path)?;
    folder.remove()?;
    Ok(kept)
}

/// What a part holds.
pub fn read_held(path: &Path) -> Result<Held, Failure> {
    held_of(&table_file::open(path)?, path)
}

/// Refuses the name of a table that is no table's, or under which something stands.
pub fn is_free(path: &Path) -> Result<(), Failure> {
    table_file::form(path)?;
    match table_file::held(path)? {
        None => Ok(()),
        Some(_) => Err(Failure::input(
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name, or remove it first",
        )),
    }
}

/// Joins tables of one study, which follow one another, into one.
pub fn join_tables<S: Study>(
    study: &S,
    head: &Head,
    tables: &[PathBuf],
    blocks: Range<u64>,
    path: &Path,
) -> Result<S::Kept, Failure> {
    let form = table_file::form(path)?;
    let columns = study.columns();
    let mut kept = study.nothing();
    for table in tables {
        kept = study.join(kept, read_held(table)?.kept()?).map_err(Failure::refused)?;
    }
    let metadata = head.metadata(blocks, study.blocks(), &kept)?;
    let last = study.last_rows(&kept).map_err(Failure::refused)?;
    table_file::write(path, form, &columns, &metadata, |writer| {
        let cannot = |error| table_file::cannot_write(path, error);
        if let Some(rows) = last {
            return writer.push(rows).map_err(cannot);
        }
        for table in tables {
            let mut reader = table_file::open(table)?;
            let held = held_of(&reader, table)?;
            while let Some(rows) =
                reader.next(&columns).map_err(|error| table_file::cannot_read_rows(table, &held, error))?
            {
                writer.push(rows).map_err(cannot)?;
            }
        }
        Ok(())
    })?;
    Ok(kept)
}

/// Writes rows that are there already as a table, which must not exist.
pub fn write_rows(
    path: &Path,
    columns: &[Column],
    rows: Rows,
    metadata: &[(String, String)],
) -> Result<(), Failure> {
    let form = table_file::form(path)?;
    if std::fs::symlink_metadata(path).is_ok_and(|there| there.is_file()) {
        return Err(Failure::input(
            format_args!("{} exists and is not overwritten", shown(path)),
            "choose another name, or remove it first",
        ));
    }
    table_file::write(path, form, columns, metadata, |writer| {
        writer.push(rows).map_err(|error| table_file::cannot_write(path, error))
    })
}

fn batch() -> u64 {
    BLOCKS_PER_THREAD * rayon::current_num_threads() as u64
}
