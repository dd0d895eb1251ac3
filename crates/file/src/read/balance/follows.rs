//! What a weight follows.

use super::Reader;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;

/// What a weight follows.
#[derive(Debug, Clone)]
pub(super) struct Follows {
    pub(super) leader_name: String,
    /// Index of the leader, once it is found.
    pub(super) leader: Option<usize>,
    pub(super) factor: f64,
    pub(super) mirrored: bool,
    /// The key that says so, and its value's place.
    pub(super) key: &'static str,
    pub(super) span: Span,
}

const KEYS: [&str; 3] = ["equal_to", "opposed_to", "mirrored_to"];

impl<'a> Reader<'a> {
    /// `Some(None)` if the weight is free.
    pub(super) fn follows(&mut self, section: &'a Section) -> Option<Option<Follows>> {
        let factor = section.number("factor");
        let leaders = KEYS.map(|key| (key, section.text(key)));
        let given: Vec<&str> = KEYS.into_iter().filter(|key| section.has(key)).collect();
        if let [first, second, ..] = given.as_slice() {
            self.two_sources(section, first, second, "what the weight follows");
            return None;
        }
        if leaders.iter().any(|(_, leader)| leader.is_bad()) {
            return None;
        }
        let factor_span = section.value_span("factor");
        let Some((key, leader)) = leaders.into_iter().find_map(|(key, leader)| match leader {
            Field::Given(leader) => Some((key, leader)),
            _ => None,
        }) else {
            if section.has("factor") {
                let why = "the weight follows no other";
                self.without_effect(section, "factor", why, "add equal_to, opposed_to or mirrored_to");
            }
            return Some(None);
        };
        let factor = factor.or(1.0)?;
        if factor == 0.0 {
            self.mistakes.push(
                Mistake::error("E0108", factor_span, "`factor` must not be 0")
                    .label("out of range")
                    .hint("leave the weight out"),
            );
            return None;
        }
        Some(Some(Follows {
            leader_name: leader.value,
            leader: None,
            factor: if key == "opposed_to" { -factor } else { factor },
            mirrored: key == "mirrored_to",
            key,
            span: leader.span,
        }))
    }
}
