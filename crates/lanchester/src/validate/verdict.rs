//! A printed number, and how far ours agrees with it.

use super::quantity::Value;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Largest difference over the printed number that is still called close.
const CLOSE: f64 = 0.005;

/// How ours agrees with a printed number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Verdict {
    /// Ours lies within half a unit of the last printed digit.
    #[serde(rename = "match")]
    Match,
    /// It does so with an input that the source rounded.
    #[serde(rename = "match with rounded input")]
    MatchWithRoundedInput,
    /// It does so with an input that the source does not print.
    #[serde(rename = "match with unprinted input")]
    MatchWithUnprintedInput,
    /// It does so with an input that the source does not print and that was fitted to this number, among others.
    #[serde(rename = "match with synthetic input")]
    MatchWithSyntheticInput,
    /// Within 0.5 %.
    #[serde(rename = "close")]
    Close,
    /// More than 0.5 % away.
    #[serde(rename = "differs")]
    Differs,
    /// Ours could not be computed.
    #[serde(rename = "not computed")]
    NotComputed,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Verdict::Match => "match",
            Verdict::MatchWithRoundedInput => "match with rounded input",
            Verdict::MatchWithUnprintedInput => "match with unprinted input",
            Verdict::MatchWithSyntheticInput => "match with synthetic input",
            Verdict::Close => "close",
            Verdict::Differs => "differs",
            Verdict::NotComputed => "not computed",
        })
    }
}

/// A number as printed, with decimal comma or point, or a word.
pub(super) enum Printed {
    Number { value: f64, last_place: f64, decimals: usize },
    Word(String),
}

impl Printed {
    /// Reads the printed text; `place` is the unit of its last digit where the text does not show it.
    pub fn read(text: &str, place: Option<f64>) -> Printed {
        let point = text.replace(',', ".");
        let point = if point == "Zero" { "0" } else { &point };
        let Ok(value) = point.parse::<f64>() else { return Printed::Word(text.to_string()) };
        let decimals = point.split_once('.').map_or(0, |(_, digits)| digits.len());
        let last_place = place.unwrap_or(10f64.powi(-(decimals as i32)));
        Printed::Number { value, last_place, decimals }
    }

    /// Whether ours lies within half a unit of the last digit, or is the same word.
    pub fn agrees(&self, ours: &Value) -> bool {
        // Keeps a tie a tie when its halves are not binary fractions.
        const TIE: f64 = 1e-9;
        match (self, ours) {
            (Printed::Number { value, last_place, .. }, Value::Number(ours)) => {
                (ours - value).abs() <= (0.5 + TIE) * last_place
            }
            (Printed::Word(word), Value::Word(ours)) => word == ours,
            _ => false,
        }
    }

    /// Whether ours lies within 0.5 %.
    pub fn is_close(&self, ours: &Value) -> bool {
        match (self, ours) {
            (Printed::Number { value, .. }, Value::Number(ours)) => {
                (ours - value).abs() <= CLOSE * value.abs()
            }
            _ => false,
        }
    }

    /// Ours with two digits more than printed.
    pub fn show(&self, ours: &Value) -> String {
        match (self, ours) {
            (_, Value::Word(word)) => word.to_string(),
            (Printed::Number { decimals, .. }, Value::Number(ours)) => {
                let shown = format!("{:.*}", decimals + 2, ours);
                let is_zero = shown.chars().all(|c| matches!(c, '-' | '0' | '.'));
                shown.strip_prefix('-').filter(|_| is_zero).unwrap_or(&shown).to_string()
            }
            (Printed::Word(_), Value::Number(ours)) => ours.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_unit_of_the_last_printed_digit() {
        let agrees = |text: &str, ours: f64| Printed::read(text, None).agrees(&Value::Number(ours));
        assert!(agrees("9535,49", 9535.4949) && agrees("9535.49", 9535.485) && !agrees("9535,49", 9535.4951));
        assert!(agrees("-20,0", -19.96) && !agrees("-20,0", -19.94));
        assert!(agrees("0,00", -1e-12) && agrees("Zero", 0.3) && !agrees("Zero", 0.6));
        assert!(agrees("0,5", 0.45) && agrees("0,5", 0.55));
        let thousands = Printed::read("11000", Some(1000.0));
        assert!(thousands.agrees(&Value::Number(11400.0)) && !thousands.agrees(&Value::Number(11600.0)));
    }

    #[test]
    fn words_must_be_the_same() {
        assert!(Printed::read("Yes", None).agrees(&Value::Word("Yes")));
        assert!(!Printed::read("Yes", None).agrees(&Value::Word("No")));
        assert!(!Printed::read("Yes", None).agrees(&Value::Number(1.0)));
    }

    #[test]
    fn close_is_half_a_per_cent_and_zero_has_no_neighbours() {
        let close = |text: &str, ours: f64| Printed::read(text, None).is_close(&Value::Number(ours));
        assert!(close("200", 200.9) && !close("200", 201.1) && !close("0", 0.6));
    }

    #[test]
    fn ours_is_shown_with_two_more_digits() {
        let show = |text: &str, ours: f64| Printed::read(text, None).show(&Value::Number(ours));
        assert_eq!(show("9535", 9535.4949), "9535.49");
        assert_eq!(show("0,00", -1e-12), "0.0000");
        assert_eq!(show("-62", -61.816), "-61.82");
    }
}
