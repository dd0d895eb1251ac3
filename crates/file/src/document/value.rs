//! Values: texts, words, numbers, quantities with their units.

use super::section::{Spot, Value};
use super::walk::Walk;
use crate::schema::Key;
use lanchester_diagnostic::Mistake;
use lanchester_model::Ratio;
use lanchester_units::nearest;
use lanchester_units::{Bound, Dimension, LARGEST, Refusal, SMALLEST, within};
use std::ops::Range;
use toml_spanner::{Item, Value as Toml};

/// Texts up to this length are names, which stand in one line of a table or a picture.
const LONGEST_NAME: usize = 200;
/// Longest list of values.
pub(super) const LONGEST_LIST: usize = 256;
/// Largest numerator and denominator of a speed ratio: periods stay short and orders few.
const LARGEST_NUMERATOR: i64 = 64;
const LARGEST_DENOMINATOR: i64 = 64;

impl Walk<'_> {
    pub(super) fn text(&mut self, key: &Key, text: &str, item: &Item<'_>, most: usize) -> Option<Value> {
        let span = item.span().range();
        let length = text.chars().count();
        if text.trim().is_empty() {
            self.mistakes.push(
                Mistake::error("E0108", span, format!("`{}` is empty", key.name))
                    .hint(format!("for example {} = {}", key.name, key.example)),
            );
            return None;
        }
        if most <= LONGEST_NAME && text.contains(char::is_control) {
            let message = format!("`{}` holds a control character such as a line end", key.name);
            self.mistakes.push(Mistake::error("E0108", span, message).hint("write it in one line"));
            return None;
        }
        if length > most {
            let message = format!("`{}` has {length} characters, more than {most}", key.name);
            self.mistakes.push(Mistake::error("E0108", span, message).hint("write it shorter"));
            return None;
        }
        Some(Value::Text(text.to_string()))
    }

    pub(super) fn word(
        &mut self,
        key: &Key,
        text: &str,
        item: &Item<'_>,
        words: &'static [&'static str],
    ) -> Option<Value> {
        if let Some(word) = words.iter().find(|word| **word == text) {
            return Some(Value::Word(word));
        }
        let near = nearest(text, words.iter().copied());
        let all = lanchester_units::one_of(words.iter().copied());
        let shown: String = text.chars().take(60).collect();
        self.mistakes.push(
            Mistake::error(
                "E0109",
                item.span().range(),
                format!("unknown value \"{shown}\" for `{}`", key.name),
            )
            .label("unknown word")
            .hint(match near {
                Some(near) => format!("did you mean \"{near}\"? it is one of {all}"),
                None if words.len() == 1 => format!("write \"{all}\""),
                None => format!("write one of {all}"),
            }),
        );
        None
    }

    pub(super) fn whole(&mut self, key: &Key, item: &Item<'_>, least: i64, most: i64) -> Option<Spot<i64>> {
        let span = item.span().range();
        let Some(number) = item.as_i128() else {
            let message = format!("`{}` needs {}", key.name, key.kind.wanted());
            self.mistakes.push(
                Mistake::error("E0107", span, message)
                    .hint(format!("for example {} = {}", key.name, key.example)),
            );
            return None;
        };
        match i64::try_from(number) {
            Ok(value) if (least..=most).contains(&value) => Some(Spot { value, span }),
            _ => {
                let message =
                    format!("`{}` needs a whole number from {least} to {most}, got {number}", key.name);
                self.out_of_range(key, span, message);
                None
            }
        }
    }

    /// A number that a key does not take, with one that it does.
    fn out_of_range(&mut self, key: &Key, span: Range<usize>, message: String) {
        let hint = format!("for example {} = {}", key.name, key.example);
        self.mistakes.push(Mistake::error("E0108", span, message).label("out of range").hint(hint));
    }

    pub(super) fn whole_choice(
        &mut self,
        key: &Key,
        item: &Item<'_>,
        choices: &'static [i64],
    ) -> Option<Value> {
        let number = item.as_i128()?;
        if let Some(choice) = choices.iter().find(|choice| i128::from(**choice) == number) {
            return Some(Value::Whole(*choice));
        }
        let message = format!("`{}` needs {}, got {number}", key.name, key.kind.wanted());
        self.out_of_range(key, item.span().range(), message);
        None
    }

    pub(super) fn list<T>(
        &mut self,
        key: &Key,
        item: &Item<'_>,
        mut element: impl FnMut(&mut Self, &Item<'_>) -> Option<Spot<T>>,
    ) -> Option<Vec<Spot<T>>> {
        let array = item.as_array()?;
        if array.len() > LONGEST_LIST {
            self.too_many(key, array.len(), LONGEST_LIST, item.span().range());
            return None;
        }
        // All elements are looked at, so that every mistake is told.
        let values: Vec<Option<Spot<T>>> = array.iter().map(|item| element(self, item)).collect();
        values.into_iter().collect()
    }

    pub(super) fn quantity(
        &mut self,
        key: &Key,
        item: &Item<'_>,
        dimension: Dimension,
        bound: Bound,
    ) -> Option<Spot<f64>> {
        let span = item.span().range();
        let source = self.text.get(span.clone()).unwrap_or("");
        let result = match item.value() {
            Toml::String(text) => lanchester_units::parse(text, dimension, key.name),
            Toml::Float(number) if !number.is_finite() => Err(lanchester_units::not_finite(key.name)),
            Toml::Integer(_) | Toml::Float(_) => {
                Err(lanchester_units::missing_unit(source, dimension, key.name))
            }
            _ => {
                self.wrong_kind(key, item, &span);
                return None;
            }
        };
        let got = item.as_str().unwrap_or(source);
        let example = format!("{} = {}", key.name, key.example);
        match result.and_then(|value| within(value, dimension, bound, key.name, got, Some(&example))) {
            Ok(value) => Some(Spot { value, span }),
            Err(Refusal { code, message, label, hint }) => {
                self.mistakes.push(Mistake::error(code, span, message).label(label).hint(hint));
                None
            }
        }
    }

    /// A percentage, or a bare fraction.
    pub(super) fn share(&mut self, key: &Key, item: &Item<'_>) -> Option<Spot<f64>> {
        match item.value() {
            Toml::Integer(_) | Toml::Float(_) => self.bare_share(key, item),
            _ => self.quantity(key, item, Dimension::Share, Bound::NotNegative),
        }
    }

    /// A component of a direction: a bare number.
    pub(super) fn component(&mut self, key: &Key, item: &Item<'_>) -> Option<Spot<f64>> {
        let span = item.span().range();
        match item.as_f64() {
            Some(value) if value.is_finite() && value.abs() <= LARGEST => Some(Spot { value, span }),
            _ => {
                self.wrong_kind(key, item, &span);
                None
            }
        }
    }

    pub(super) fn bare_share(&mut self, key: &Key, item: &Item<'_>) -> Option<Spot<f64>> {
        let span = item.span().range();
        let value = item.as_f64()?;
        if !value.is_finite() || value < 0.0 {
            let message = format!("`{}` needs a share of 0 or more, got {value}", key.name);
            self.out_of_range(key, span, message);
            return None;
        }
        Some(Spot { value, span })
    }

    pub(super) fn bare_number(&mut self, key: &Key, item: &Item<'_>, bound: Bound) -> Option<Value> {
        let span = item.span().range();
        let value = item.as_f64()?;
        let good = match bound {
            Bound::Any => true,
            Bound::NotNegative => value >= 0.0,
            Bound::Positive => value > 0.0,
        };
        if !good || !value.is_finite() || value.abs() > LARGEST || (value != 0.0 && value.abs() < SMALLEST) {
            let wanted = match bound {
                Bound::Any => "a number",
                Bound::NotNegative => "a number of 0 or more",
                Bound::Positive => "a number above 0",
            };
            let message = format!(
                "`{}` needs {wanted}, up to {LARGEST:e} and no closer to 0 than {SMALLEST:e}, got {value}",
                key.name
            );
            self.out_of_range(key, span, message);
            return None;
        }
        Some(Value::Number(value))
    }

    /// The order of a harmonic as a fraction in a text: `"3/2"`.
    pub(super) fn order(&mut self, key: &Key, item: &Item<'_>) -> Option<Value> {
        let span = item.span().range();
        let order = item.as_str().and_then(fraction).map(|(over, under)| over as f64 / under as f64);
        match order.filter(|order| *order == 0.0 || (SMALLEST..=LARGEST).contains(order)) {
            Some(order) => Some(Value::Number(order)),
            None => {
                self.wrong_kind(key, item, &span);
                None
            }
        }
    }

    pub(super) fn ratio(&mut self, key: &Key, item: &Item<'_>) -> Option<Value> {
        let span = item.span().range();
        let parts = match item.value() {
            Toml::Integer(number) => number.as_i64().map(|number| (number, 1)),
            Toml::String(text) => fraction(text),
            _ => None,
        };
        let Some((numerator, denominator)) = parts else {
            let message = format!("`{}` needs {}", key.name, key.kind.wanted());
            let hint = "write a whole number, or a fraction as text: \"1/2\"";
            self.mistakes.push(Mistake::error("E0107", span, message).label("no ratio").hint(hint));
            return None;
        };
        if numerator == 0 || denominator == 0 {
            let message = format!("`{}` must not be 0", key.name);
            let hint =
                "a shaft of ratio 0 stands still: leave it out, or give its speed over that of crankshaft 1";
            self.mistakes.push(Mistake::error("E0110", span, message).label("stands still").hint(hint));
            return None;
        }
        let in_range = numerator.checked_abs().is_some_and(|size| size <= LARGEST_NUMERATOR)
            && (1..=LARGEST_DENOMINATOR).contains(&denominator);
        let ratio = match (i32::try_from(numerator), u32::try_from(denominator)) {
            (Ok(numerator), Ok(denominator)) if in_range => Ratio::new(numerator, denominator),
            _ => None,
        };
        if ratio.is_none() {
            let message = format!(
                "`{}` needs a numerator up to {LARGEST_NUMERATOR} and a denominator from 1 to {LARGEST_DENOMINATOR}, \
                 got {numerator}/{denominator}",
                key.name
            );
            self.out_of_range(key, span, message);
        }
        ratio.map(Value::Ratio)
    }
}

/// `"-3/2"` or `"2"`.
fn fraction(text: &str) -> Option<(i64, i64)> {
    match text.split_once('/') {
        Some((numerator, denominator)) => {
            Some((numerator.trim().parse().ok()?, denominator.trim().parse().ok()?))
        }
        None => Some((text.trim().parse().ok()?, 1)),
    }
}
