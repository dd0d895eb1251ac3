//! The groups of a DXF text: a code and a value on a line of its own each.

use super::{DrawingError, Place};
use std::borrow::Cow;

/// A group.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tag<'a> {
    /// What the value means.
    pub code: i32,
    /// The value without blanks around it.
    pub value: &'a str,
    /// Line of the code, counted from 1.
    pub line: usize,
}

impl Tag<'_> {
    /// The value as a finite number.
    pub fn number(&self) -> Result<f64, DrawingError> {
        let number = self.value.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| self.wrong("a finite number"))
    }

    /// The value as a whole number.
    pub fn integer(&self) -> Result<i64, DrawingError> {
        self.value.parse().map_err(|_| self.wrong("a whole number"))
    }

    /// Something else was needed.
    pub fn wrong(&self, needed: &'static str) -> DrawingError {
        DrawingError::Syntax { line: self.line + 1, needed, got: Place::new(self.value, 0).entity }
    }
}

/// The text of the bytes: UTF-8, else each byte a character, which leaves all that matters here but the names of layers.
pub(super) fn text(bytes: &[u8]) -> Result<Cow<'_, str>, DrawingError> {
    let not_text = |why| {
        let hint = "save it as ASCII DXF, release 12 or 2000";
        Err(DrawingError::NotText { format: "DXF", why, hint })
    };
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return not_text("it is a binary DXF file");
    }
    if bytes.starts_with(b"AC10") {
        return not_text("it is a DWG file");
    }
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return not_text("it is empty");
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|byte| char::from(*byte)).collect()),
    })
}

/// All groups up to `EOF`, without comments, and the comments.
pub(super) fn tags(text: &str) -> Result<(Vec<Tag<'_>>, Vec<&str>), DrawingError> {
    let mut lines = text.lines().zip(1..);
    let (mut tags, mut comments) = (Vec::new(), Vec::new());
    while let Some((code, line)) = lines.next() {
        let code = code.trim();
        let Some((value, _)) = lines.next() else {
            // Blank lines may follow the end.
            if code.is_empty() {
                break;
            }
            return Err(DrawingError::Syntax { line: line + 1, needed: "a value", got: String::new() });
        };
        let tag = Tag { code: 0, value: value.trim(), line };
        let code: i32 = code.parse().map_err(|_| DrawingError::Syntax {
            line,
            needed: "the code of a group",
            got: Place::new(code, 0).entity,
        })?;
        match (code, tag.value) {
            (0, "EOF") => break,
            (999, comment) => comments.push(comment),
            _ => tags.push(Tag { code, ..tag }),
        }
    }
    Ok((tags, comments))
}

/// An entity, or an entry of a table: the groups from one code 0 to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record<'a> {
    /// Its kind.
    pub name: &'a str,
    /// Line where it begins.
    pub line: usize,
    /// Its groups, without the first.
    pub tags: &'a [Tag<'a>],
}

impl<'a> Record<'a> {
    /// The records of groups that begin with a code 0.
    pub fn all(tags: &'a [Tag<'a>]) -> impl Iterator<Item = Record<'a>> {
        let same = |_: &Tag, next: &Tag| next.code != 0;
        tags.chunk_by(same).filter(|group| group[0].code == 0).map(|group| Record {
            name: group[0].value,
            line: group[0].line,
            tags: &group[1..],
        })
    }

    pub fn place(&self) -> Place {
        Place::new(self.name, self.line)
    }

    /// The first group of this code.
    pub fn tag(&self, code: i32) -> Option<&'a Tag<'a>> {
        self.tags.iter().find(|tag| tag.code == code)
    }

    /// A number that may be absent.
    pub fn optional(&self, code: i32) -> Result<Option<f64>, DrawingError> {
        self.tag(code).map(Tag::number).transpose()
    }

    /// A number that must be there.
    pub fn number(&self, code: i32, missing: &'static str) -> Result<f64, DrawingError> {
        self.optional(code)?.ok_or(DrawingError::Missing { entity: self.place(), missing })
    }

    /// A whole number, zero where it is absent.
    pub fn integer(&self, code: i32) -> Result<i64, DrawingError> {
        self.tag(code).map_or(Ok(0), Tag::integer)
    }

    /// The layer, `0` where none is named.
    pub fn layer(&self) -> &'a str {
        self.tag(8).map_or("0", |tag| tag.value)
    }

    /// An error about it.
    pub fn unsupported(&self, why: &'static str, hint: &'static str) -> DrawingError {
        DrawingError::Unsupported { entity: self.place(), why, hint }
    }
}
