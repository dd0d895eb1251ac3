//! What a table of a study says of its own making: study, request, engine, blocks, and what is kept of them.

use lanchester_table::{Source, TableReader};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::ops::Range;

const STUDY: &str = "lanchester.study";
const VERSION: &str = "lanchester.version";
const REQUEST: &str = "lanchester.request";
const ENGINE: &str = "lanchester.engine";
const BLOCKS: &str = "lanchester.blocks";
const KEPT: &str = "lanchester.kept";

/// Why the head of a table cannot be written or used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HeadError {
    /// A request or what is kept of blocks does not become JSON.
    #[error("what a table says of itself cannot be written: {0}")]
    Write(serde_json::Error),
    /// What a table keeps of its blocks is not what this version keeps.
    #[error("what a table keeps of its blocks cannot be read: {0}\nhint: it is damaged; run that part again")]
    Kept(serde_json::Error),
}

/// What all parts of a table have alike.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    /// Which study: its name.
    pub study: String,
    /// The version that made it.
    pub version: String,
    /// The request, as JSON.
    pub request: String,
    /// The text of the engine file.
    pub engine: String,
}

impl Head {
    /// That of a study of this version.
    ///
    /// # Errors
    /// Where the request does not become JSON.
    pub fn new(study: &str, request: &impl Serialize, engine: &str) -> Result<Head, HeadError> {
        Ok(Head {
            study: study.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            request: serde_json::to_string(request).map_err(HeadError::Write)?,
            engine: engine.to_owned(),
        })
    }

    /// The metadata of a table with these of so many blocks.
    ///
    /// # Errors
    /// Where what is kept does not become JSON.
    pub fn metadata(
        &self,
        blocks: Range<u64>,
        of: u64,
        kept: &impl Serialize,
    ) -> Result<Vec<(String, String)>, HeadError> {
        let kept = serde_json::to_string(kept).map_err(HeadError::Write)?;
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
    /// What all parts have alike.
    pub head: Head,
    /// Its blocks, end excluded.
    pub blocks: Range<u64>,
    /// Blocks of the whole study.
    pub of: u64,
    kept: String,
}

impl Held {
    /// Of a table; `None` where it does not say what it holds.
    pub fn of<R: Source + 'static>(reader: &TableReader<R>) -> Option<Held> {
        Held::found(|key| reader.metadata(key).map(str::to_owned))
    }

    /// Of the metadata that `get` finds; `None` where something is missing.
    pub fn found(get: impl Fn(&str) -> Option<String>) -> Option<Held> {
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
    }

    /// What is kept of its blocks.
    ///
    /// # Errors
    /// Where it is not what this version keeps.
    pub fn kept<K: DeserializeOwned>(&self) -> Result<K, HeadError> {
        serde_json::from_str(&self.kept).map_err(HeadError::Kept)
    }
}

/// Blocks as people count them.
pub fn numbered(blocks: &Range<u64>, of: u64) -> String {
    if blocks.end == blocks.start + 1 {
        return format!("block {} of {of}", blocks.end);
    }
    format!("blocks {} to {} of {of}", blocks.start + 1, blocks.end)
}
