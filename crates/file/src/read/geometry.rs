//! Mistakes of shapes at the key that causes them.

use super::reader::Reader;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_shape::{GeometryError, plausible_density};
use lanchester_units::Dimension;

impl<'a> Reader<'a> {
    /// A number that a shape cannot have, in the unit of its key.
    pub(super) fn impossible_number(&mut self, section: &Section, key: &str, error: &GeometryError) {
        self.impossible_size(section, key, section.value_span(key), error);
    }

    /// As [`Reader::impossible_number`], with another place.
    pub(super) fn impossible_size(
        &mut self,
        section: &Section,
        key: &str,
        span: Span,
        error: &GeometryError,
    ) {
        let GeometryError::Number { needed, got, hint, .. } = error else {
            self.impossible_shape(span, error);
            return;
        };
        let got = match section.dimension(key) {
            Some(dimension) => lanchester_units::readable(*got, dimension),
            None => got.to_string(),
        };
        let message = format!("`{key}` must be {needed}, got {got}");
        self.mistakes.push(Mistake::error("E0108", span, message).label("out of range").hint(*hint));
    }

    /// A shape that cannot be, with the place in the shape.
    pub(super) fn impossible_shape(&mut self, span: Span, error: &GeometryError) {
        let text = error.to_string();
        let (message, hint) = text.split_once("\nhint: ").unwrap_or((&text, ""));
        let mut mistake = Mistake::error("E0901", span, message);
        if !hint.is_empty() {
            mistake = mistake.hint(hint);
        }
        self.mistakes.push(mistake);
    }

    /// The density of a material; the outer `None` says bad.
    pub(super) fn density(&mut self, section: &Section) -> Option<Option<f64>> {
        let spot = match section.number("density") {
            Field::Given(spot) => spot,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        if let Err(GeometryError::Number { needed, hint, .. }) = plausible_density(spot.value) {
            let got = lanchester_units::readable(spot.value, Dimension::Density);
            let message = format!("`density` must be {needed} (in kg/m3), got {got}");
            self.mistakes
                .push(Mistake::error("E0903", spot.span, message).label("no such material").hint(hint));
            return None;
        }
        Some(Some(spot.value))
    }

    /// One value, or the least and the most; the outer `None` says bad, the inner one absent.
    pub(super) fn range_of(&mut self, section: &Section, key: &str) -> Option<Option<[f64; 2]>> {
        let spot = match section.numbers(key) {
            Field::Given(spot) => spot,
            Field::Absent => return Some(None),
            Field::Bad => return None,
        };
        match spot.value.as_slice() {
            [one] => Some(Some([one.value; 2])),
            [least, most] if least.value <= most.value => Some(Some([least.value, most.value])),
            [least, most] => {
                let [low, high] = [least, most].map(|spot| {
                    let dimension = section.dimension(key);
                    dimension
                        .map_or(String::new(), |dimension| lanchester_units::readable(spot.value, dimension))
                });
                self.mistakes.push(
                    Mistake::error("E0305", spot.span, format!("`{key}` runs from {low} to {high}"))
                        .label("least first")
                        .hint("write the least value first, then the most"),
                );
                None
            }
            other => {
                let message = format!("`{key}` needs one or two values, got {}", other.len());
                self.mistakes.push(Mistake::error("E0206", spot.span, message).hint(section.example(key)));
                None
            }
        }
    }
}
