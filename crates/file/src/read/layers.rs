//! Keys of one part over the keys that hold for all.

use crate::document::{Field, Section, Span};

/// Tables that say something about one part, the nearest first.
#[derive(Debug, Clone)]
pub(super) struct Layers<'a> {
    pub(super) sections: Vec<&'a Section>,
    /// The table of defaults is there but no table: nothing can be called missing.
    pub(super) broken: bool,
    /// Name of the table of defaults.
    pub(super) default: &'static str,
}

impl<'a> Layers<'a> {
    /// The nearest table that has one of the keys.
    pub(super) fn with_any(&self, keys: &[&str]) -> Option<&'a Section> {
        self.sections.iter().copied().find(|section| keys.iter().any(|key| section.has(key)))
    }

    pub(super) fn number(&self, key: &str) -> Field<f64> {
        self.with_any(&[key]).map_or(Field::Absent, |section| section.number(key))
    }

    /// Where a missing key would best be written: the table of defaults, else the part's own, else the start.
    pub(super) fn place(&self) -> Span {
        self.sections.last().map_or(0..0, |section| section.span.clone())
    }
}
