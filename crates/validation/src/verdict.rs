//! A printed number, and how ours stands to it.

use crate::value::Value;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How ours stands to a printed number. Only [`Verdict::Match`] counts as a match.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub enum Verdict {
    /// Ours lies within half a unit of the last printed digit.
    #[serde(rename = "match")]
    Match,
    /// The printed number is among the results for all inputs that round to the printed ones.
    #[serde(rename = "within rounding of inputs")]
    WithinRounding,
    /// Ours agrees with an intermediate result rounded to the digits that the source prints elsewhere.
    #[serde(rename = "rounded intermediate")]
    RoundedIntermediate,
    /// Ours agrees after an assumption that was looked for to make it agree.
    #[serde(rename = "explained afterwards")]
    ExplainedAfterwards,
    /// Ours agrees, though the source computed something else.
    #[serde(rename = "agrees by accident")]
    Accident,
    /// The printed number is wrong.
    #[serde(rename = "source wrong")]
    SourceWrong,
    /// The source itself calls the number approximate.
    #[serde(rename = "stated loosely")]
    Loose,
    /// The number needs an input that the source does not print.
    #[serde(rename = "input not printed")]
    InputNotPrinted,
    /// The number is one of those that our input was fitted to.
    #[serde(rename = "residual of a fit")]
    Residual,
    /// Ours is an input of the computation, unchanged.
    #[serde(rename = "input itself")]
    InputItself,
    /// None of these.
    #[serde(rename = "differs")]
    Differs,
    /// Ours could not be computed.
    #[serde(rename = "not computed")]
    NotComputed,
}

impl Verdict {
    /// All of them, in the order of lists.
    pub const ALL: [Verdict; 12] = [
        Verdict::Match,
        Verdict::WithinRounding,
        Verdict::RoundedIntermediate,
        Verdict::ExplainedAfterwards,
        Verdict::Accident,
        Verdict::SourceWrong,
        Verdict::Loose,
        Verdict::InputNotPrinted,
        Verdict::Residual,
        Verdict::InputItself,
        Verdict::Differs,
        Verdict::NotComputed,
    ];

    /// What it says, for the page of the book.
    pub fn meaning(self) -> &'static str {
        match self {
            Verdict::Match => {
                "ours, from the printed inputs, lies within the tolerance: half a unit of the last printed digit"
            }
            Verdict::WithinRounding => {
                "ours lies outside; the results for all inputs that round to the printed ones include the printed number"
            }
            Verdict::RoundedIntermediate => {
                "ours lies outside, and within if an intermediate result is rounded as the source prints it elsewhere"
            }
            Verdict::ExplainedAfterwards => {
                "ours lies outside, and within after an assumption that the source does not print and that was looked for: an explanation, no match"
            }
            Verdict::Accident => "ours lies within the tolerance, but the source computed something else",
            Verdict::SourceWrong => {
                "the printed number is wrong; the reason says why, and ours must equal the correct one"
            }
            Verdict::Loose => "the source itself calls the number approximate",
            Verdict::InputNotPrinted => "the number needs an input that is not printed",
            Verdict::Residual => {
                "our input, the synthetic pressures, was fitted to this number among others: ours less printed is a residual, and what is correct is unknown"
            }
            Verdict::InputItself => "ours is an input of the computation, unchanged: nothing is compared",
            Verdict::Differs => "ours lies outside, and why is not known",
            Verdict::NotComputed => "ours could not be computed",
        }
    }

    /// Whether the data file must state it: no computation tells these from one another.
    pub(crate) fn is_stated(self) -> bool {
        matches!(self, Verdict::SourceWrong | Verdict::Loose | Verdict::InputNotPrinted)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Verdict::Match => "match",
            Verdict::WithinRounding => "within rounding of inputs",
            Verdict::RoundedIntermediate => "rounded intermediate",
            Verdict::ExplainedAfterwards => "explained afterwards",
            Verdict::Accident => "agrees by accident",
            Verdict::SourceWrong => "source wrong",
            Verdict::Loose => "stated loosely",
            Verdict::InputNotPrinted => "input not printed",
            Verdict::Residual => "residual of a fit",
            Verdict::InputItself => "input itself",
            Verdict::Differs => "differs",
            Verdict::NotComputed => "not computed",
        })
    }
}

/// A number as printed, with decimal comma or point, or a word.
pub(crate) enum Printed {
    Number { value: f64, last_place: f64, decimals: usize },
    Word(String),
}

impl Printed {
    /// Reads the printed text.
    pub fn read(text: &str) -> Printed {
        let point = text.replace(',', ".");
        let point = if point == "Zero" { "0" } else { &point };
        let Ok(value) = point.parse::<f64>() else { return Printed::Word(text.to_string()) };
        let decimals = point.split_once('.').map_or(0, |(_, digits)| digits.len());
        let last_place = 10f64.powi(-(decimals as i32));
        Printed::Number { value, last_place, decimals }
    }

    /// Whether ours lies within half a unit of the last digit, or is the same word.
    pub fn agrees(&self, ours: &Value) -> bool {
        /// Share of the last digit that keeps a tie a tie when its halves are not binary fractions.
        const TIE: f64 = 1e-9;
        match (self, ours) {
            (Printed::Number { value, last_place, .. }, Value::Number(ours)) => {
                (ours - value).abs() <= (0.5 + TIE) * last_place
            }
            (Printed::Word(word), Value::Word(ours)) => word == ours,
            _ => false,
        }
    }

    /// Half a unit of the last printed digit; `None` for a word.
    pub fn tolerance(&self) -> Option<f64> {
        match self {
            Printed::Number { last_place, .. } => Some(0.5 * last_place),
            Printed::Word(_) => None,
        }
    }

    /// Ours less the printed number.
    pub fn residual(&self, ours: &Value) -> Option<f64> {
        match (self, ours) {
            (Printed::Number { value, .. }, Value::Number(ours)) => Some(ours - value),
            _ => None,
        }
    }

    /// Whether some number that is printed like this one lies between two numbers.
    pub fn lies_between(&self, [low, high]: [f64; 2]) -> bool {
        match self {
            Printed::Number { value, last_place, .. } => {
                value + 0.5 * last_place >= low && value - 0.5 * last_place <= high
            }
            Printed::Word(_) => false,
        }
    }

    /// A number with `more` digits than printed.
    pub fn digits(&self, number: f64, more: usize) -> String {
        match self {
            Printed::Number { decimals, .. } => {
                let shown = format!("{:.*}", decimals + more, number);
                let is_zero = shown.chars().all(|c| matches!(c, '-' | '0' | '.'));
                shown.strip_prefix('-').filter(|_| is_zero).unwrap_or(&shown).to_string()
            }
            Printed::Word(_) => number.to_string(),
        }
    }

    /// Ours with two digits more than printed.
    pub fn show(&self, ours: &Value) -> String {
        match ours {
            Value::Word(word) => word.to_string(),
            Value::Number(ours) => self.digits(*ours, 2),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_unit_of_the_last_printed_digit() {
        let agrees = |text: &str, ours: f64| Printed::read(text).agrees(&Value::Number(ours));
        assert!(agrees("9535,49", 9535.4949) && agrees("9535.49", 9535.485) && !agrees("9535,49", 9535.4951));
        assert!(agrees("-20,0", -19.96) && !agrees("-20,0", -19.94));
        assert!(agrees("0,00", -1e-12) && agrees("Zero", 0.3) && !agrees("Zero", 0.6));
        assert!(agrees("0,5", 0.45) && agrees("0,5", 0.55));
    }

    #[test]
    fn words_must_be_the_same() {
        assert!(Printed::read("Yes").agrees(&Value::Word("Yes")));
        assert!(!Printed::read("Yes").agrees(&Value::Word("No")));
        assert!(!Printed::read("Yes").agrees(&Value::Number(1.0)));
    }

    #[test]
    fn tolerance_residual_and_range_follow_from_the_printed_digits() {
        let printed = Printed::read("117,46");
        assert_eq!(printed.tolerance(), Some(0.005));
        assert!((printed.residual(&Value::Number(118.98)).unwrap() - 1.52).abs() < 1e-12);
        assert!(printed.lies_between([117.0, 119.0]) && printed.lies_between([117.464, 119.0]));
        assert!(!printed.lies_between([117.466, 119.0]) && !printed.lies_between([110.0, 117.45]));
        assert_eq!(Printed::read("Yes").tolerance(), None);
        assert!(Printed::read("11000").tolerance() == Some(0.5), "zeros are digits");
    }

    #[test]
    fn names_are_those_of_the_files() {
        for verdict in Verdict::ALL {
            assert_eq!(serde_json::to_value(verdict).unwrap(), verdict.to_string());
            assert!(!verdict.meaning().is_empty());
        }
    }

    #[test]
    fn ours_is_shown_with_two_more_digits() {
        let show = |text: &str, ours: f64| Printed::read(text).show(&Value::Number(ours));
        assert_eq!(show("9535", 9535.4949), "9535.49");
        assert_eq!(show("0,00", -1e-12), "0.0000");
        assert_eq!(show("-62", -61.816), "-61.82");
    }
}
