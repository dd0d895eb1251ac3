//! Mistakes of TOML syntax.

use super::section::Span;
use lanchester_diagnostic::Mistake;

pub(super) fn line_of(text: &str, at: usize) -> &str {
    let at = text.floor_char_boundary(at.min(text.len()));
    let start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    text[start..].lines().next().unwrap_or("").trim_start_matches('\u{feff}')
}

/// The first line of the span, to its end.
fn line_from(text: &str, span: Span) -> &str {
    text.get(span).and_then(|text| text.lines().next()).unwrap_or("")
}

/// What stands behind the `=` of the line, if it is a bare text or a bare number with a unit.
fn unquoted_value(text: &str, at: usize) -> Option<&str> {
    let (_, value) = line_of(text, at).split_once('=')?;
    let value = value.split('#').next().unwrap_or("").trim();
    let is_bare = value.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '-' || c == '+' || c == '.');
    (is_bare && value.len() < 60 && !value.contains('"')).then_some(value)
}

pub(super) fn mistake(error: &toml_spanner::Error, text: &str) -> Mistake {
    use toml_spanner::ErrorKind;
    let kind = error.kind();
    let code = match kind {
        ErrorKind::DuplicateKey { .. } | ErrorKind::DuplicateTable { .. } => "E0002",
        _ => "E0001",
    };
    let span = error.span().range();
    let message = match kind {
        ErrorKind::DuplicateKey { .. } => {
            format!("duplicate key `{}` in one table", text.get(span.clone()).unwrap_or(""))
        }
        ErrorKind::DuplicateTable { name, .. } => {
            format!("duplicate table `{}`", text.get(name.range()).unwrap_or(""))
        }
        ErrorKind::OutOfRange { .. } => "too deeply nested".to_string(),
        _ => error.message(text),
    };
    let mut mistake = Mistake::error(code, span, message);
    if let Some((_, label)) = error.primary_label() {
        mistake = mistake.label(label);
    }
    if let Some((span, label)) = error.secondary_label() {
        let first_line = span.range().start..span.range().start + line_from(text, span.range()).len();
        mistake = mistake.related(first_line, label);
    }
    match kind {
        ErrorKind::DuplicateKey { .. } => mistake.hint("keep one of the two"),
        ErrorKind::DuplicateTable { .. } => {
            mistake.hint("write its keys under one header; tables that may repeat have [[two brackets]]")
        }
        ErrorKind::UnquotedString | ErrorKind::Wanted { .. } | ErrorKind::InvalidInteger(_) => {
            match unquoted_value(text, error.span().start as usize) {
                Some(value) => mistake.hint(format!("write texts and quantities in quotes: \"{value}\"")),
                None => mistake,
            }
        }
        ErrorKind::UnterminatedString(_) => {
            mistake.hint("close the text with the same quote on the same line")
        }
        _ => mistake,
    }
}
