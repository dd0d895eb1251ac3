//! The reader of the tree of values, and the mistakes that every table may have.

use super::layers::Layers;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::{Mistake, Mistakes};

/// Tables whose keys hold for many parts: a key of them that no part needs is a doubt, not a mistake.
const DEFAULTS: [&str; 5] = ["crank", "piston", "rod", "articulated_rod", "cylinders"];

/// Reads the tree, collecting mistakes.
pub(crate) struct Reader<'a> {
    pub(crate) root: &'a Section,
    /// Whether the syntax is whole; if not, nothing can be called missing.
    pub(crate) whole: bool,
    pub(crate) mistakes: &'a mut Mistakes,
}

impl<'a> Reader<'a> {
    /// The value; a mistake if the key is not there.
    pub(crate) fn required<T>(&mut self, section: &Section, key: &str, field: Field<T>) -> Option<T> {
        match field {
            Field::Given(spot) => Some(spot.value),
            Field::Bad => None,
            Field::Absent => {
                let header = section.title();
                self.missing(
                    section.span.clone(),
                    format!("`{key}` is missing in {header}"),
                    section.example(key),
                );
                None
            }
        }
    }

    /// Something that has to be there is not; no mistake if it may hide behind a mistake of syntax.
    pub(crate) fn missing(&mut self, span: Span, message: String, hint: String) {
        if self.whole {
            self.mistakes.push(Mistake::error("E0202", span, message).hint(hint));
        } else {
            // The engine is lost all the same: the mistake of syntax stands for this one.
            debug_assert!(self.mistakes.any_error());
        }
    }

    /// Neither the part nor the table of defaults says something that every part must have.
    pub(super) fn missing_in(&mut self, layers: &Layers<'a>, what: &str, example: &str) {
        let default = layers.default;
        if layers.broken {
            return;
        }
        if layers.sections.is_empty() {
            // One sentence for all that it would hold.
            self.missing(0..0, format!("[{default}] is missing"), format!("add [{default}] with {example}"));
        } else {
            self.missing(
                layers.place(),
                format!("{what} is missing"),
                format!("add {example} to [{default}]"),
            );
        }
    }

    /// Two keys that say the same thing.
    pub(crate) fn two_sources(&mut self, section: &Section, keep: &str, other: &str, what: &str) {
        self.mistakes.push(
            Mistake::error(
                "E0203",
                section.key_span(other),
                format!("`{keep}` and `{other}` both give {what}"),
            )
            .label("second source")
            .related(section.key_span(keep), "first source")
            .hint("keep one of the two"),
        );
    }

    /// A key that means nothing beside what else the file says.
    pub(crate) fn without_effect(&mut self, section: &Section, key: &str, why: &str, hint: &str) {
        self.mistakes.push(
            Mistake::error("E0204", section.key_span(key), format!("`{key}` has no effect: {why}"))
                .hint(hint),
        );
    }

    /// A key that nothing uses as the file stands, but that other data or another question would: told, and kept.
    pub(crate) fn unused_as_it_stands(&mut self, section: &Section, key: &str, why: &str, hint: &str) {
        self.mistakes.push(
            Mistake::warning("W0204", section.key_span(key), format!("`{key}` has no effect: {why}"))
                .hint(hint),
        );
    }

    pub(crate) fn report_unused(&mut self) {
        for (path, span) in self.root.unused() {
            let table = path.split('.').next().unwrap_or("");
            if DEFAULTS.contains(&table) {
                let (message, hint) = if path == table {
                    (format!("[{table}] is never used"), "leave it out")
                } else {
                    (
                        format!("`{path}` is never used"),
                        "every part that it could hold for has its own value, or is not there; leave it out",
                    )
                };
                self.mistakes.push(Mistake::warning("W0204", span, message).hint(hint));
            } else {
                let message = format!("`{path}` has no effect");
                self.mistakes.push(Mistake::error("E0204", span, message).hint("leave it out"));
            }
        }
    }

    /// A table of the root, `None` if it is not there; the flag says that it is there but bad.
    pub(crate) fn section(&self, name: &str) -> (Option<&'a Section>, bool) {
        match self.root.table(name) {
            Field::Given(spot) => (Some(spot.value), false),
            Field::Absent => (None, false),
            Field::Bad => (None, true),
        }
    }

    /// The tables that say something about one part, the nearest first.
    pub(super) fn layers(&self, own: &[Option<&'a Section>], default: &'static str) -> Layers<'a> {
        let (section, broken) = self.section(default);
        let sections: Vec<&Section> = own.iter().copied().flatten().chain(section).collect();
        Layers { sections, broken, default }
    }
}
