//! Mistakes in a graph as they are found: all at once, each with its place and a hint.

use lanchester_diagnostic::{Diagnostic, Severity};
use std::ops::Range;

/// More than these help nobody.
const MOST: usize = 100;

/// Mistakes of one graph.
#[derive(Debug, Clone, Default)]
pub(crate) struct Mistakes {
    found: Vec<(&'static str, Range<usize>, String, String)>,
}

impl Mistakes {
    /// Notes a mistake: its code, its place in the text, what was needed and got, what mends it.
    pub(crate) fn push(
        &mut self,
        code: &'static str,
        span: &Range<usize>,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        let mistake = (code, span.clone(), message.into(), hint.into());
        if !self.found.contains(&mistake) && self.found.len() < 10 * MOST {
            self.found.push(mistake);
        }
    }

    /// Code, message and fix of each mistake.
    pub(crate) fn said(&self) -> impl Iterator<Item = (&'static str, &str, &str)> {
        self.found.iter().map(|(code, _, message, hint)| (*code, message.as_str(), hint.as_str()))
    }

    pub(crate) fn any(&self) -> bool {
        !self.found.is_empty()
    }

    pub(crate) fn count(&self) -> usize {
        self.found.len()
    }

    /// The mistakes in the order of their places.
    pub(crate) fn into_diagnostics(mut self, text: &str) -> Vec<Diagnostic> {
        self.found.sort_by_key(|(_, span, ..)| span.start);
        self.found.truncate(MOST);
        self.found
            .into_iter()
            .map(|(code, span, message, hint)| {
                let start = text.floor_char_boundary(span.start.min(text.len()));
                let end = text.ceil_char_boundary(span.end.clamp(start, text.len()));
                let before = &text[..start];
                let line_start = before.rfind('\n').map_or(0, |at| at + 1);
                Diagnostic {
                    severity: Severity::Error,
                    code,
                    message,
                    span: start..end,
                    line: before.matches('\n').count() + 1,
                    column: before[line_start..].chars().count() + 1,
                    label: String::new(),
                    related: Vec::new(),
                    hint: Some(hint).filter(|hint| !hint.is_empty()),
                }
            })
            .collect()
    }
}

/// Every code that a diagnostic of a graph may have, and what it says.
pub fn diagnostic_codes() -> &'static [(&'static str, &'static str)] {
    &[
        ("E1701", "the text is no TOML, or not of a graph file's form"),
        ("E1702", "unknown kind of element, key or domain"),
        ("E1703", "a name that is given twice, or no name at all"),
        ("E1704", "an expression that cannot be read"),
        ("E1705", "unit of another quantity"),
        ("E1706", "unknown name in an expression"),
        ("E1707", "a bond that names no element or port"),
        ("E1708", "a port that is bonded twice or never, or against the arrow that its element needs"),
        (
            "E1709",
            "an element without its law, or with two; a graph without elements; a periodic motion without period",
        ),
        ("E1710", "a junction that joins different domains, or has none"),
        ("E1711", "signals or parameters that need each other in a circle"),
        ("E1712", "an inertia, capacitance or resistance that is not positive"),
        ("E1713", "a conflict of causality"),
        (
            "E1714",
            "an algebraic loop or a following store that stays singular, or a following store that an event sets or that starts otherwise than what it follows",
        ),
        ("E1715", "too much: elements, bonds or brackets"),
    ]
}
