//! Mistakes in a file that somebody wrote: collected, placed, rendered.
//!
//! A reader pushes every [`Mistake`] that it finds into [`Mistakes`]; with the text they become [`Diagnostic`]s, which have a line and a
//! column and are plain data; [`render`] shows them as a compiler does.
#![forbid(unsafe_code)]

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde::Serialize;
use std::ops::Range;

/// Whether a file with this diagnostic can be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// No engine can be made of the file.
    Error,
    /// Accepted, but something in the file is probably not meant.
    Warning,
}

/// Something about the file that its author should know.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// Stable code such as `E0103`; the book lists them.
    pub code: &'static str,
    /// What was needed and what was got.
    pub message: String,
    /// Place in the text, in bytes.
    pub span: Range<usize>,
    /// Line of the place, from 1.
    pub line: usize,
    /// Column of the place in characters, from 1.
    pub column: usize,
    /// What stands at the place, a few words; may be empty.
    pub label: String,
    /// Other places that matter.
    pub related: Vec<Related>,
    /// What to do.
    pub hint: Option<String>,
}

/// A second place that a diagnostic is about.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Related {
    /// Place in the text, in bytes.
    pub span: Range<usize>,
    /// What stands there.
    pub label: String,
}

/// More than this many diagnostics help nobody, and an adversary could ask for millions.
const MOST_DIAGNOSTICS: usize = 200;

/// A mistake before it has its line and column.
#[derive(Debug, Clone)]
#[must_use]
pub struct Mistake {
    severity: Severity,
    code: &'static str,
    message: String,
    span: Range<usize>,
    label: String,
    related: Vec<Related>,
    hint: Option<String>,
}

impl Mistake {
    /// A mistake at a place of the text [bytes].
    pub fn error(code: &'static str, span: Range<usize>, message: impl Into<String>) -> Mistake {
        Mistake {
            severity: Severity::Error,
            code,
            message: message.into(),
            span,
            label: String::new(),
            related: Vec::new(),
            hint: None,
        }
    }

    /// A doubt at a place of the text [bytes].
    pub fn warning(code: &'static str, span: Range<usize>, message: impl Into<String>) -> Mistake {
        Mistake { severity: Severity::Warning, ..Mistake::error(code, span, message) }
    }

    /// With a few words for the place.
    pub fn label(mut self, label: impl Into<String>) -> Mistake {
        self.label = label.into();
        self
    }

    /// With what to do.
    pub fn hint(mut self, hint: impl Into<String>) -> Mistake {
        self.hint = Some(hint.into());
        self
    }

    /// With another place that matters; the place of the mistake itself is none.
    pub fn related(mut self, span: Range<usize>, label: impl Into<String>) -> Mistake {
        if span != self.span {
            self.related.push(Related { span, label: label.into() });
        }
        self
    }
}

/// The mistakes of one file as they are found.
#[derive(Debug, Default)]
pub struct Mistakes {
    found: Vec<Mistake>,
}

impl Mistakes {
    /// One more.
    pub fn push(&mut self, mistake: Mistake) {
        self.found.push(mistake);
    }

    /// Whether one of them is an error.
    pub fn any_error(&self) -> bool {
        self.found.iter().any(|mistake| mistake.severity == Severity::Error)
    }

    /// Whether there are so many that the last of them are not shown and need no hint.
    pub fn crowded(&self) -> bool {
        self.found.len() > 4 * MOST_DIAGNOSTICS
    }

    /// Sorted by place, each once, with line and column, not more than 200 of them.
    pub fn into_diagnostics(self, text: &str) -> Vec<Diagnostic> {
        let mut found = self.found;
        for mistake in &mut found {
            mistake.span = on_characters(text, &mistake.span);
            for related in &mut mistake.related {
                related.span = on_characters(text, &related.span);
            }
        }
        found.sort_by(|a, b| {
            (a.span.start, a.span.end, a.code, &a.message).cmp(&(
                b.span.start,
                b.span.end,
                b.code,
                &b.message,
            ))
        });
        found.dedup_by(|a, b| a.span == b.span && a.code == b.code && a.message == b.message);
        let left_out = found.len().saturating_sub(MOST_DIAGNOSTICS);
        if left_out > 0 {
            found.truncate(MOST_DIAGNOSTICS);
            found.push(
                Mistake::error(
                    "E0005",
                    text.len()..text.len(),
                    format!("{left_out} more mistakes are not shown"),
                )
                .hint("mend the mistakes above first"),
            );
        }
        let mut places = Places::new(text);
        found
            .into_iter()
            .map(|mistake| {
                let (line, column) = places.line_and_column(mistake.span.start);
                Diagnostic {
                    severity: mistake.severity,
                    code: mistake.code,
                    message: mistake.message,
                    span: mistake.span,
                    line,
                    column,
                    label: mistake.label,
                    related: mistake.related,
                    hint: mistake.hint,
                }
            })
            .collect()
    }
}

/// Lines and columns of rising places, in one pass over the text.
struct Places<'a> {
    text: &'a str,
    place: usize,
    line: usize,
    line_start: usize,
}

impl<'a> Places<'a> {
    fn new(text: &'a str) -> Places<'a> {
        Places { text, place: 0, line: 1, line_start: bom_length(text) }
    }

    fn line_and_column(&mut self, place: usize) -> (usize, usize) {
        for (offset, byte) in self.text.as_bytes()[self.place..place].iter().enumerate() {
            if *byte == b'\n' {
                self.line += 1;
                self.line_start = self.place + offset + 1;
            }
        }
        self.place = place;
        let before = self.text.get(self.line_start..place).unwrap_or("");
        (self.line, before.chars().count() + 1)
    }
}

/// Bytes of a byte order mark at the start of the text: 3 or 0.
fn bom_length(text: &str) -> usize {
    if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 }
}

/// The span cut to the text and widened to whole characters, without trailing line ends.
fn on_characters(text: &str, span: &Range<usize>) -> Range<usize> {
    let start = text.floor_char_boundary(span.start.min(text.len())).max(bom_length(text).min(text.len()));
    let end = text.ceil_char_boundary(span.end.clamp(start, text.len()).max(start));
    let trimmed = text[start..end].trim_end_matches(['\n', '\r']).len();
    start..start + trimmed
}

/// Lines that are longer, or places further apart, are named but not shown.
const LONGEST_EXCERPT: usize = 16 * 1024;

/// The diagnostics as text for people: file, line, column, the text underlined, a hint.
///
/// `text` is the text that was read, `file_name` what its author calls it; `colour` adds ANSI colours.
pub fn render(diagnostics: &[Diagnostic], file_name: &str, text: &str, colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() }.decor_style(DecorStyle::Ascii);
    let mut out = String::new();
    for diagnostic in diagnostics {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let title = level.primary_title(&*diagnostic.message).id(diagnostic.code);
        let mut group = excerpt(Group::with_title(title), diagnostic, file_name, text);
        if let Some(hint) = &diagnostic.hint {
            let hint = annotate_snippets::normalize_untrusted_str(hint);
            group = group.element(Level::HELP.with_name("hint").message(hint));
        }
        out += &renderer.render(&[group]);
        out += "\n\n";
    }
    out
}

fn excerpt<'a>(group: Group<'a>, diagnostic: &'a Diagnostic, file_name: &'a str, text: &'a str) -> Group<'a> {
    let lines = |spans: &mut dyn Iterator<Item = &Range<usize>>| {
        let (first, last) =
            spans.fold((text.len(), 0), |(first, last), span| (first.min(span.start), last.max(span.end)));
        let (first, last) = (first.min(text.len()), last.min(text.len()));
        let before = text.get(..first).unwrap_or("");
        let start = before.rfind('\n').map_or(bom_length(text), |at| at + 1);
        let after = text.get(last..).unwrap_or("");
        let end = last + after.lines().next().map_or(0, str::len);
        start..end
    };
    let alone = lines(&mut std::iter::once(&diagnostic.span));
    let with_related = lines(
        &mut std::iter::once(&diagnostic.span).chain(diagnostic.related.iter().map(|other| &other.span)),
    );
    let (window, related) = if with_related.len() <= LONGEST_EXCERPT {
        (with_related, diagnostic.related.as_slice())
    } else {
        (alone, [].as_slice())
    };
    let (Some(source), true) = (text.get(window.clone()), window.len() <= LONGEST_EXCERPT) else {
        return group.element(Origin::path(file_name).line(diagnostic.line).char_column(diagnostic.column));
    };
    // Carriage returns would show as signs of their own: they go, and places behind them move up.
    let source = source.replace("\r\n", "\n");
    let within = |span: &Range<usize>| {
        let place = |at: usize| {
            let before = text.get(window.start..at.clamp(window.start, window.end)).unwrap_or("");
            before.len() - before.matches("\r\n").count()
        };
        place(span.start)..place(span.end)
    };
    let first_line = text[..window.start].bytes().filter(|byte| *byte == b'\n').count() + 1;
    let mut snippet = Snippet::source(source).line_start(first_line).path(file_name);
    let primary = AnnotationKind::Primary.span(within(&diagnostic.span));
    snippet = snippet.annotation(if diagnostic.label.is_empty() {
        primary
    } else {
        primary.label(diagnostic.label.as_str())
    });
    for other in related {
        snippet =
            snippet.annotation(AnnotationKind::Context.span(within(&other.span)).label(other.label.as_str()));
    }
    group.element(snippet)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagnostics(text: &str, mistakes: Vec<Mistake>) -> Vec<Diagnostic> {
        Mistakes { found: mistakes }.into_diagnostics(text)
    }

    #[test]
    fn sorted_by_place_and_none_twice() {
        let text = "a = 1\nb = 2\n";
        let second = Mistake::error("E0001", 6..7, "second");
        let first = Mistake::error("E0002", 0..1, "first");
        let found = diagnostics(text, vec![second.clone(), first, second]);
        let got: Vec<_> = found.iter().map(|d| (d.message.as_str(), d.line, d.column)).collect();
        assert_eq!(got, [("first", 1, 1), ("second", 2, 1)]);
    }

    #[test]
    fn columns_count_characters_after_a_byte_order_mark() {
        let text = "\u{feff}é = 1\r\nü = 2\r\n";
        let at = text.find('=').unwrap();
        let second = text.rfind('=').unwrap();
        let found = diagnostics(
            text,
            vec![Mistake::error("E0001", at..at + 1, "m"), Mistake::error("E0001", second..second + 1, "m")],
        );
        assert_eq!((found[0].line, found[0].column, found[1].line, found[1].column), (1, 3, 2, 3));
        assert!(render(&found, "e.toml", text, false).contains("e.toml:2:3"));
        assert!(render(&found, "e.toml", text, false).contains("e.toml:1:3"));
    }

    #[test]
    fn spans_outside_the_text_are_cut() {
        let found = diagnostics("é", vec![Mistake::error("E0001", 1..99, "m")]);
        assert_eq!(found[0].span, 0..2);
        render(&found, "e.toml", "", true);
    }

    #[test]
    fn a_flood_is_cut_off() {
        let text = "x".repeat(10_000);
        let many = (0..10_000).map(|at| Mistake::error("E0001", at..at + 1, "m")).collect();
        let found = diagnostics(&text, many);
        assert_eq!(found.len(), MOST_DIAGNOSTICS + 1);
        assert_eq!(found[MOST_DIAGNOSTICS].message, "9800 more mistakes are not shown");
    }
}
