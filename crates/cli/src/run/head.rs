//! What a table says of its own making: study, request, engine, blocks, and what is kept of them.

use crate::failure::{Failure, WRONG_INPUT};
use lanchester::table::{Source, TableReader};
use lanchester_files::shown;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::ops::Range;
use std::path::Path;

const STUDY: &str = "lanchester.study";
const VERSION: &str = "lanchester.version";
const REQUEST: &str = "lanchester.request";
const ENGINE: &str = "lanchester.engine";
const BLOCKS: &str = "lanchester.blocks";
const KEPT: &str = "lanchester.kept";

/// What all parts of a table have alike.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    /// Which study: the name of its command.
    pub study: String,
    /// The program that made it.
    pub version: String,
    /// The request, as JSON.
    pub request: String,
    /// The text of the engine file.
    pub engine: String,
}

impl Head {
    /// That of a study of this program.
    pub fn new(study: &str, request: &impl Serialize, engine: &str) -> Result<Head, Failure> {
        Ok(Head {
            study: study.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            request: serde_json::to_string(request).map_err(Failure::own)?,
            engine: engine.to_owned(),
        })
    }

    /// The metadata of a table with these of so many blocks.
    pub fn metadata(
        &self,
        blocks: Range<u64>,
        of: u64,
        kept: &impl Serialize,
    ) -> Result<Vec<(String, String)>, Failure> {
        let kept = serde_json::to_string(kept).map_err(Failure::own)?;
        let entries = [
            (STUDY, self.study.clone()),
            (VERSION, self.version.clone()),
            (REQUEST, self.request.clone()),
            (ENGINE, self.engine.clone()),
            (BLOCKS, format!("{} to {} of {of}", blocks.start, blocks.end)),
            (KEPT, kept),
        ];
        Ok(entries.map(|(key, value)| (key.to_owned(), value)).to_vec())
    }
}

/// What a table holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Held {
    pub head: Head,
    /// Its blocks, end excluded.
    pub blocks: Range<u64>,
    /// Blocks of the whole study.
    pub of: u64,
    kept: String,
}

impl Held {
    /// Of a table.
    pub fn of<R: Source + 'static>(reader: &TableReader<R>, path: &Path) -> Result<Held, Failure> {
        Held::found(|key| reader.metadata(key).map(str::to_owned), path)
    }

    /// Of the metadata that `get` finds.
    pub fn found(get: impl Fn(&str) -> Option<String>, path: &Path) -> Result<Held, Failure> {
        let held = || {
            let blocks = get(BLOCKS)?;
            let (range, of) = blocks.split_once(" of ")?;
            let (from, to) = range.split_once(" to ")?;
            Some(Held {
                head: Head {
                    study: get(STUDY)?,
                    version: get(VERSION)?,
                    request: get(REQUEST)?,
                    engine: get(ENGINE)?,
                },
                blocks: from.parse().ok()?..to.parse().ok()?,
                of: of.parse().ok()?,
                kept: get(KEPT)?,
            })
        };
        held().ok_or_else(|| {
            Failure::input(
                format_args!("{} does not say what it holds: lanchester has not written it", shown(path)),
                "choose another name, or remove it first",
            )
        })
    }

    /// What is kept of its blocks.
    pub fn kept<K: DeserializeOwned>(&self) -> Result<K, Failure> {
        serde_json::from_str(&self.kept).map_err(|error| Failure {
            status: WRONG_INPUT,
            message: format!(
                "error: what a table keeps of its blocks cannot be read: {error}\nhint: it is damaged; run that part again"
            ),
        })
    }
}

/// Blocks as people count them.
pub fn numbered(blocks: &Range<u64>, of: u64) -> String {
    if blocks.end == blocks.start + 1 {
        return format!("block {} of {of}", blocks.end);
    }
    format!("blocks {} to {} of {of}", blocks.start + 1, blocks.end)
}
