//! Typical values for what an engine file leaves out.
//!
//! Every value is scaled to the engine of the file (its stroke, bore, cylinders, speeds, layout and kind) and has a comment that says from
//! what. No value of the file is changed, and what the file says of a section stays as it is: missing keys and sections are added.
//! The ratios are usual practice, not measurements of one engine: they make a file with which every question can be asked, and are to be
//! replaced by the numbers of the real engine as they come to be known.

mod block;
mod crank;
mod design;
mod gas;
mod kind;
mod production;
mod running;
mod section;
mod sizes;
mod torsion;
mod words;

pub use kind::EngineKind;
pub use section::TypicalSection;

use crate::read::read_with_origin;
use crate::write_back::{Edit, EditError, edit};
use crate::{EngineFile, FileEntry, file_entries, read};
use lanchester_diagnostic::Diagnostic;
use serde::Serialize;
use serde_json::Value as Json;
use sizes::Sizes;
use words::Block;

/// An engine file with typical values in the place of what was missing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Completed {
    /// The text of the file with them.
    pub text: String,
    /// The kind of engine that they were taken for.
    pub kind: EngineKind,
    /// Sections that were added, in the order of the file.
    pub added: Vec<TypicalSection>,
    /// Sections that this engine cannot have, and why.
    pub left_out: Vec<LeftOut>,
}

/// A section that was not added.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LeftOut {
    /// Which.
    pub section: TypicalSection,
    /// Why.
    pub why: String,
}

/// Why a file was not completed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompleteError {
    /// The file itself cannot be read.
    #[error("the engine file has mistakes")]
    File(Vec<Diagnostic>),
    /// With the typical values the file would have mistakes: they do not fit what it says.
    #[error("the typical values of {section} do not fit this engine")]
    Unfit {
        /// The section that does not fit.
        section: TypicalSection,
        /// What the file would be.
        text: String,
        /// Its mistakes.
        diagnostics: Vec<Diagnostic>,
    },
}

/// What a section comes to.
enum Found {
    /// The file has it.
    There,
    /// The engine cannot have it.
    Not(String),
    /// Tables to append.
    Blocks(Vec<Block>),
    /// A key to set in a table that may be there: path, value, comment.
    Keys(Vec<(String, Json, String)>),
}

/// The text with typical values for `sections` (all of them, where it is empty), each only where the file has nothing of it.
/// `kind` is what the engine is taken for, else what its numbers say ([`EngineKind::of`]).
///
/// # Errors
/// [`CompleteError`] if the text is no engine file, or would be none with a section.
pub fn complete(
    text: &str,
    sections: &[TypicalSection],
    kind: Option<EngineKind>,
) -> Result<Completed, CompleteError> {
    let (reading, _) = read_with_origin(text);
    let Some(file) = reading.file else { return Err(CompleteError::File(reading.diagnostics)) };
    let kind = kind.unwrap_or_else(|| EngineKind::of(&file.engine));
    let wanted = |section: &TypicalSection| sections.is_empty() || sections.contains(section);
    let mut done = Completed { text: text.to_string(), kind, added: Vec::new(), left_out: Vec::new() };
    for section in TypicalSection::ALL.into_iter().filter(wanted) {
        let (reading, origin) = read_with_origin(&done.text);
        let (Some(file), Some(origin)) = (reading.file, origin) else {
            return Err(CompleteError::File(reading.diagnostics));
        };
        let from = From { file: &file, origin, entries: file_entries(&done.text), kind };
        let text = match from.found(section) {
            Found::There => continue,
            Found::Not(why) => {
                done.left_out.push(LeftOut { section, why });
                continue;
            }
            Found::Blocks(blocks) => with_blocks(&done.text, &blocks),
            Found::Keys(keys) => match with_keys(&done.text, &keys) {
                Ok(text) => text,
                Err(error) => {
                    done.left_out.push(LeftOut { section, why: error.to_string() });
                    continue;
                }
            },
        };
        let reading = read(&text);
        if reading.file.is_none() {
            return Err(CompleteError::Unfit { section, text, diagnostics: reading.diagnostics });
        }
        done.text = text;
        done.added.push(section);
    }
    Ok(done)
}

/// What the typical values come from.
struct From<'a> {
    file: &'a EngineFile,
    /// The z of the reference plane in the file [m].
    origin: f64,
    entries: Vec<FileEntry>,
    kind: EngineKind,
}

impl From<'_> {
    /// Whether the file says something below this path.
    fn has(&self, path: &str) -> bool {
        let is_below = |entry: &FileEntry| {
            entry.path.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        self.entries.iter().any(is_below)
    }

    fn found(&self, section: TypicalSection) -> Found {
        let sizes = Sizes::of(&self.file.engine, self.kind);
        match section {
            TypicalSection::Bore => self.bore(&sizes),
            TypicalSection::WebDistance => self.web_distance(&sizes),
            TypicalSection::CounterweightPlanes => self.counterweight_planes(&sizes),
            TypicalSection::CrankBody => self.crank_body(&sizes),
            TypicalSection::CrankMaterial => self.crank_material(),
            TypicalSection::Gas => self.gas(&sizes),
            TypicalSection::Friction => self.friction(),
            TypicalSection::Flywheel => self.flywheel(&sizes),
            TypicalSection::Bearings => self.bearings(&sizes),
            TypicalSection::Block => self.block(&sizes),
            TypicalSection::Mounts => self.mounts(&sizes),
            TypicalSection::Tolerances => self.tolerances(&sizes),
            TypicalSection::Balance => self.balance(&sizes),
            TypicalSection::CounterweightDesign => self.counterweight_design(&sizes),
            TypicalSection::Clearance => self.clearance(&sizes),
            TypicalSection::ShaftWeightDesign => self.shaft_weight_design(),
            TypicalSection::Torsion => self.torsion(&sizes),
            TypicalSection::Damper => self.damper(&sizes),
            TypicalSection::Simulation => self.simulation(),
        }
    }
}

/// The text with tables behind its last line.
fn with_blocks(text: &str, blocks: &[Block]) -> String {
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let mut out = text.to_string();
    if !out.is_empty() && !out.ends_with('\n') {
        out += end;
    }
    for block in blocks {
        out += end;
        out += &block.text(end);
    }
    out
}

/// The text with keys set, each with its comment where its line has room for one.
fn with_keys(text: &str, keys: &[(String, Json, String)]) -> Result<String, EditError> {
    let mut text = text.to_string();
    for (path, value, comment) in keys {
        let change = Edit { path: path.clone(), value: value.clone() };
        text = edit(&text, &[change])?;
        let Some(entry) = file_entries(&text).into_iter().find(|entry| entry.path == *path) else { continue };
        let stop = text[entry.span.end..].find(['\r', '\n']).map_or(text.len(), |at| entry.span.end + at);
        if text[entry.span.end..stop].trim().is_empty() {
            text.replace_range(entry.span.end..stop, &format!("  # typical: {comment}"));
        }
    }
    Ok(text)
}
