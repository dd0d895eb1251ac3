//! The engine file as it is read: its values, its mistakes, the engine in short.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::summary::{EngineSummary, summary};
use lanchester::file::{self, Diagnostic, Edit, EngineFile, FileEntry, Related, file_entries};
use lanchester::model::Engine;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A text, and what is to be changed in it first.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EditedText {
    /// The engine file.
    text: String,
    /// Keys that change, one after the other.
    #[serde(default)]
    edits: Vec<Edit>,
}

/// A text.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct EngineText {
    /// The engine file.
    pub(crate) text: String,
}

/// A text as an answer.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct NewText {
    /// The engine file.
    pub(crate) text: String,
}

/// What stands in an engine file. All places are in UTF-16 units, as the page counts them.
#[derive(Debug, Serialize, JsonSchema)]
struct Reading {
    /// The text with its changes.
    text: String,
    /// Mistakes and warnings.
    diagnostics: Vec<PlacedDiagnostic>,
    /// Every value of the file with its place.
    entries: Vec<FileEntry>,
    /// The engine, if there is one.
    engine: Option<EngineSummary>,
}

/// A diagnostic and the key that it is about.
#[derive(Debug, Serialize, JsonSchema)]
struct PlacedDiagnostic {
    /// Path of the value at its place, if there is one.
    path: Option<String>,
    #[serde(flatten)]
    diagnostic: Diagnostic,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/engine", "Changes keys of an engine file and reads it.", reading).post(
        "/api/expanded",
        "The general form of an engine file.",
        expanded,
    )
}

fn reading(_: &Asker, question: EditedText) -> Result<Reading, Problem> {
    let text = match question.edits[..] {
        [] => question.text,
        _ => file::edit(&question.text, &question.edits).map_err(Problem::refused)?,
    };
    let read = file::read(&text);
    let mut places = Utf16::new(&text);
    let entries = file_entries(&text);
    let diagnostics = read.diagnostics.into_iter().map(|diagnostic| {
        let path = at(&text, &entries, &diagnostic.span);
        PlacedDiagnostic { path, diagnostic: places.diagnostic(diagnostic) }
    });
    let diagnostics = diagnostics.collect();
    let entries =
        entries.into_iter().map(|entry| FileEntry { span: places.span(&entry.span), ..entry }).collect();
    Ok(Reading { diagnostics, entries, engine: read.file.as_ref().map(|file| summary(file, &text)), text })
}

/// The innermost value that holds the place, or begins there.
fn at(text: &str, entries: &[FileEntry], span: &Range<usize>) -> Option<String> {
    let holds = |entry: &&FileEntry| {
        entry.span.start <= span.start && span.start < entry.span.end.max(entry.span.start + 1)
    };
    let holding = entries.iter().filter(holds).min_by_key(|entry| entry.span.len());
    // A key that is wrong itself stands before its value; what is missing has no place of its own.
    let is_behind = |entry: &&FileEntry| {
        !span.is_empty() && text.get(span.end..entry.span.start).is_some_and(|between| between.trim() == "=")
    };
    holding.or_else(|| entries.iter().find(is_behind)).map(|entry| entry.path.clone())
}

fn expanded(_: &Asker, question: EngineText) -> Result<NewText, Problem> {
    Ok(NewText { text: file::expanded(&engine_file(&question.text)?) })
}

/// The engine of a text, or its mistakes.
pub(crate) fn engine(text: &str) -> Result<Engine, Problem> {
    engine_file(text).map(|file| file.engine)
}

/// The engine of a text and what is asked of it, or its mistakes.
pub(crate) fn engine_file(text: &str) -> Result<EngineFile, Problem> {
    let read = file::read(text);
    read.file.ok_or_else(|| {
        let mut places = Utf16::new(text);
        Problem::mistakes(
            read.diagnostics.into_iter().map(|diagnostic| places.diagnostic(diagnostic)).collect(),
        )
    })
}

/// Mistakes with their places in UTF-16 units.
pub(crate) fn in_utf16(text: &str, mistakes: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut places = Utf16::new(text);
    mistakes.into_iter().map(|mistake| places.diagnostic(mistake)).collect()
}

/// From bytes to UTF-16 units.
struct Utf16<'a> {
    text: &'a str,
    /// Places are mostly asked for in rising order: where the last one was.
    byte: usize,
    unit: usize,
}

impl<'a> Utf16<'a> {
    fn new(text: &'a str) -> Utf16<'a> {
        Utf16 { text, byte: 0, unit: 0 }
    }

    fn place(&mut self, byte: usize) -> usize {
        let byte = self.text.floor_char_boundary(byte);
        if byte < self.byte {
            (self.byte, self.unit) = (0, 0);
        }
        self.unit += self.text[self.byte..byte].chars().map(char::len_utf16).sum::<usize>();
        self.byte = byte;
        self.unit
    }

    fn span(&mut self, span: &Range<usize>) -> Range<usize> {
        self.place(span.start)..self.place(span.end)
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) -> Diagnostic {
        let span = self.span(&diagnostic.span);
        let related =
            diagnostic.related.into_iter().map(|other| Related { span: self.span(&other.span), ..other });
        Diagnostic { span, related: related.collect(), ..diagnostic }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_as_the_page_counts() {
        let text = "a = \"ü𝄞\" # x";
        let mut places = Utf16::new(text);
        let hash = text.find('#').unwrap();
        assert_eq!(places.place(hash), text[..hash].encode_utf16().count());
        assert_eq!(places.place(2), 2);
        assert_eq!(places.place(10_000), text.encode_utf16().count());
    }

    #[test]
    fn a_mistake_tells_its_key() {
        let text = "name = \"A\"\nspeed = \"3 kg\"\n[crank]\nstroke = 3\n";
        let entries = file_entries(text);
        let read = file::read(text);
        let paths: Vec<_> = read.diagnostics.iter().filter_map(|d| at(text, &entries, &d.span)).collect();
        assert!(
            paths.contains(&"speed".to_string()) && paths.contains(&"crank.stroke".to_string()),
            "{paths:?}"
        );
    }
}
