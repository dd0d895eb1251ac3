//! Names that tell parts of a kind apart.

use super::reader::Reader;
use crate::document::{Section, Span};
use lanchester_diagnostic::Mistake;

/// Where the name of a part stands: the name itself, or the table of a part that has its name from its place.
pub(super) fn name_span(section: &Section) -> Span {
    if section.has("name") { section.value_span("name") } else { section.span.clone() }
}

impl Reader<'_> {
    /// Refuses a name that two parts of a kind have: what is found for one of them would be written to the other.
    pub(super) fn check_unique(&mut self, kind: &str, names: &[(String, Span)]) {
        self.refuse_same_names("E0514", kind, names);
    }

    /// Refuses, under `code`, a name that another of its kind has already.
    pub(crate) fn refuse_same_names(&mut self, code: &'static str, kind: &str, names: &[(String, Span)]) {
        for (index, (name, span)) in names.iter().enumerate() {
            let Some((_, first)) = names[..index].iter().find(|(other, _)| other == name) else { continue };
            let shown: String = name.chars().take(60).collect();
            self.mistakes.push(
                Mistake::error(code, span.clone(), format!("two {kind}s are called \"{shown}\""))
                    .label("second of this name")
                    .related(first.clone(), "first of this name")
                    .hint("give each its own name"),
            );
        }
    }

    /// As [`Reader::check_unique`], of tables that became parts.
    pub(super) fn check_unique_parts<T>(
        &mut self,
        kind: &str,
        sections: &[Section],
        parts: &[Option<T>],
        name: impl Fn(&T) -> &str,
    ) {
        let named = sections.iter().zip(parts).filter_map(|(section, part)| Some((section, part.as_ref()?)));
        let names: Vec<(String, Span)> =
            named.map(|(section, part)| (name(part).to_string(), name_span(section))).collect();
        self.check_unique(kind, &names);
    }
}
