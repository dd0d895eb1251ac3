//! What ends the period of a periodic motion: `"20 ms"`, or `"720 deg of theta"`.

use super::Checker;
use crate::description::Text;
use crate::expression::parse;
use crate::graph::Period;
use crate::unit::Unit;

/// A duration of one period of the motion that repeats.
const PERIODIC: &str = "periodic";

/// Between an amount and the state that advances by it.
const OF: &str = " of ";

impl Checker<'_> {
    /// Whether a periodic motion is asked for.
    pub(super) fn is_periodic(&self) -> bool {
        let keys = &self.description.simulation;
        keys.iter().any(|(key, text)| key.text == "duration" && text.text == PERIODIC)
    }

    /// The period of `[simulation]`, which must have one where it is `needed`.
    pub(super) fn period(&mut self, needed: bool) -> Option<Period> {
        let description = self.description;
        let hint = "for example period = \"20 ms\", or period = \"720 deg of theta\" with a signal theta that is an integral";
        let Some((_, text)) = description.simulation.iter().find(|(key, _)| key.text == "period") else {
            if !needed {
                return None;
            }
            let span = description.simulation.first().map_or(0..0, |(_, text)| text.span.clone());
            self.mistakes.push("E1709", &span, "duration = \"periodic\" needs a `period`", hint);
            return None;
        };
        let (amount, state) = match text.text.split_once(OF) {
            Some((amount, state)) => (amount.trim(), Some(state.trim())),
            None => (text.text.as_str(), None),
        };
        let found = match state {
            None => Some((None, Unit::SECOND)),
            Some(name) => {
                let found = self.state(name).map(|(var, unit)| (Some(var), unit.unwrap_or(Unit::NONE)));
                if found.is_none() {
                    let message = format!("`{name}` is no state whose advance ends a period");
                    let hint =
                        "there are signals that are integrals, momentum of an I and displacement of a C";
                    self.mistakes.push("E1706", &text.span, message, hint);
                }
                found
            }
        };
        self.numbers_only = true;
        let parsed = parse(&Text { text: amount.to_owned(), span: text.span.clone() }, self);
        self.numbers_only = false;
        let ((of, needed), parsed) = (found?, parsed?);
        let advance = self.number(parsed.id);
        if let Some(unit) = parsed.unit.filter(|unit| *unit != needed && advance != 0.0) {
            let message = format!("`period` needs {needed}, got {unit}");
            self.mistakes.push("E1705", &text.span, message, hint);
            return None;
        }
        if !advance.is_finite() || advance.abs() > 1e12 || (of.is_none() && advance <= 0.0) {
            let message = format!("`period` is out of range, got {}", text.text);
            self.mistakes.push("E1712", &text.span, message, "a time is above 0");
            return None;
        }
        Some(Period { of, advance })
    }
}
