//! The text as a tree of typed values: TOML syntax, known keys, kinds, units. What the values mean together is for
//! [`read`](crate::read).

mod criteria;
mod section;
mod syntax;
mod value;
mod walk;

pub(crate) use section::{Field, Section, Span, Spot, Term};

use crate::schema::Table;
use lanchester_diagnostic::{Mistake, Mistakes};
use walk::Walk;

/// Bytes of the longest file that is read.
const LONGEST_FILE: usize = 4 * 1024 * 1024;

/// The file as a tree, and whether its syntax is whole: if not, nothing can be called missing.
#[derive(Debug)]
pub(crate) struct Document {
    pub(crate) root: Section,
    pub(crate) whole: bool,
}

/// Parses the text as a file whose tables and keys `file` describes. Mistakes of syntax, keys, kinds and units are
/// added to `mistakes`.
pub(crate) fn parse(text: &str, file: &'static Table, mistakes: &mut Mistakes) -> Document {
    let empty = || Section { table: file, span: 0..0, entries: Vec::new() };
    if text.len() > LONGEST_FILE {
        let message =
            format!("the file has {} bytes, more than the {LONGEST_FILE} that it may have", text.len());
        mistakes.push(Mistake::error("E0003", 0..0, message).hint("check that this is the right file"));
        return Document { root: empty(), whole: false };
    }
    let arena = toml_spanner::Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    for error in document.errors() {
        mistakes.push(syntax::mistake(error, text));
    }
    let whole = document.errors().is_empty();
    // Keys below a header that cannot be read end up in the root: they are not its own.
    let foreign_from = document
        .errors()
        .iter()
        .map(|error| error.span().start as usize)
        .filter(|at| syntax::line_of(text, *at).trim_start().starts_with('['))
        .min()
        .unwrap_or(usize::MAX);
    let mut walk = Walk { text, file, mistakes, foreign_from };
    let root = walk.section(file, document.table(), 0..0);
    Document { root, whole }
}
