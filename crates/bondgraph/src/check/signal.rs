//! Signals: values and integrals, which may name one another in any order.

use super::{Checker, Progress};
use crate::description::Text;
use crate::expression::{Parsed, Var, parse};
use crate::unit::Unit;

impl Checker<'_> {
    /// A signal by its index, read where it is not yet; none where it is wrong.
    pub(super) fn signal(&mut self, index: usize) -> Option<Parsed> {
        if let Progress::Done(parsed) = self.signal_progress[index] {
            return parsed;
        }
        let entry = &self.description.signals[index];
        let name = &entry.name;
        let symbol = self.pool.var(Var::Signal(index as u32));
        if self.signal_progress[index] == Progress::Reading {
            if self.own_integrand == Some((index, self.depth)) {
                // Its unit is that of the rest of the integrand.
                return Some(Parsed { id: symbol, unit: None });
            }
            if entry.get("integral_of").is_some() {
                let message = format!(
                    "the unit of `{}` is not known: it needs itself through another signal",
                    name.text
                );
                let hint = "give its start a unit, for example start = \"0 rad\"";
                self.mistakes.push("E1711", &name.span, message, hint);
                return None;
            }
            let message = format!("signal `{}` needs itself", name.text);
            self.mistakes.push("E1711", &name.span, message, "break the circle with an integral");
            return None;
        }
        for (key, _) in &entry.keys {
            if !["value", "integral_of", "start"].contains(&key.text.as_str()) {
                let hint = "a signal has value, or integral_of and start";
                self.mistakes.push("E1702", &key.span, format!("a signal has no `{}`", key.text), hint);
            }
        }
        self.signal_progress[index] = Progress::Reading;
        let parsed = match (entry.get("value"), entry.get("integral_of")) {
            (Some(text), None) => {
                self.depth += 1;
                let parsed = parse(text, self);
                self.depth -= 1;
                parsed.map(|value| {
                    self.signals[index].value = value.id;
                    value.unit
                })
            }
            (None, Some(_)) => {
                let start = self.start_of(index);
                let parsed = parse(&start, self);
                self.numbers_only = false;
                let unit = parsed.and_then(|value| value.unit);
                let value = parsed.map_or(f64::NAN, |value| self.number(value.id));
                if parsed.is_some() && !value.is_finite() {
                    let message = format!("the start of `{}` is no finite number", name.text);
                    self.mistakes.push("E1704", &start.span, message, "check divisions and roots in it");
                }
                self.signals[index].start = Some(value);
                if unit.is_some() {
                    // The unit is known: the integrand may name the signal itself, or one that is being read just now.
                    let parsed = Some(Parsed { id: symbol, unit });
                    self.signals[index].unit = unit.unwrap_or(Unit::NONE);
                    self.signal_progress[index] = Progress::Done(parsed);
                    if self.depth > 0 {
                        self.deferred.push(index);
                    } else {
                        self.integrand(index);
                    }
                    return parsed;
                }
                self.integrand(index)
            }
            _ => {
                let message = format!("signal `{}` needs a value or an integral", name.text);
                let hint = "for example theta = { integral_of = \"shaft.flow\", start = \"0 rad\" }";
                self.mistakes.push("E1709", &name.span, message, hint);
                None
            }
        };
        let parsed = parsed.map(|unit| Parsed { id: symbol, unit });
        self.signals[index].unit = parsed.and_then(|parsed| parsed.unit).unwrap_or(Unit::NONE);
        self.signal_progress[index] = Progress::Done(parsed);
        parsed
    }

    /// Text of the start of an integral; only numbers may be named in it.
    fn start_of(&mut self, index: usize) -> Text {
        self.numbers_only = true;
        self.description.signals[index].get("start").cloned().unwrap_or_else(|| Text::from("0"))
    }

    /// Reads what a signal is the integral of; the unit of the signal, as far as it is known.
    pub(super) fn integrand(&mut self, index: usize) -> Option<Option<Unit>> {
        let entry = &self.description.signals[index];
        let (text, start) = (entry.get("integral_of")?, entry.get("start"));
        let start_unit = match self.signal_progress[index] {
            Progress::Done(parsed) => parsed.and_then(|parsed| parsed.unit),
            _ => None,
        };
        self.depth += 1;
        let before = self.own_integrand.replace((index, self.depth));
        let mut integrand = parse(text, self);
        self.own_integrand = before;
        if let (Progress::Reading, Some(Parsed { unit: Some(unit), .. })) =
            (self.signal_progress[index], integrand)
        {
            // Now that its unit is known, that of each part is checked.
            let symbol = self.pool.var(Var::Signal(index as u32));
            let own = Parsed { id: symbol, unit: Some(unit.times(Unit::SECOND)) };
            self.signal_progress[index] = Progress::Done(Some(own));
            integrand = parse(text, self);
            self.signal_progress[index] = Progress::Reading;
        }
        self.depth -= 1;
        integrand.map(|integrand| {
            self.signals[index].value = integrand.id;
            let unit = integrand.unit.map(|unit| unit.times(Unit::SECOND));
            if let (Some(a), Some(b)) = (unit, start_unit)
                && a != b
            {
                let message =
                    format!("signal `{}` is an integral in {a}, but starts in {b}", entry.name.text);
                let span = start.map_or(entry.name.span.clone(), |start| start.span.clone());
                self.mistakes.push("E1705", &span, message, format!("give the start in {a}"));
            }
            start_unit.or(unit)
        })
    }
}
