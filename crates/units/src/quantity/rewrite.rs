//! A quantity written anew in the unit that a text has.

use super::decimal::decimal;
use super::number::split;
use super::unit::find_unit;
use super::{Dimension, parse};

/// Digits behind the first that a double may need.
const MOST_DIGITS: usize = 16;

/// `text` with another number, in its own unit and spelling: the shortest that reads back as one that `fits`, the
/// nearest to `value` [SI] if none does. `None` if the text is no quantity of the dimension.
pub fn rewritten(text: &str, value: f64, dimension: Dimension, fits: impl Fn(f64) -> bool) -> Option<String> {
    parse(text, dimension, "").ok()?;
    let trimmed = text.trim();
    let (number, name) = split(trimmed);
    let rest = &trimmed[number.len()..];
    let unit = find_unit(name)?;
    // No negative zero.
    let number = (value - unit.zero) / unit.factor + 0.0;
    (0..=MOST_DIGITS)
        .map(|digits| format!("{}{rest}", decimal(&format!("{number:.digits$e}"), -unit.exponent)))
        .find(|text| parse(text, dimension, "").is_ok_and(&fits))
        .or_else(|| Some(format!("{}{rest}", decimal(&format!("{number:e}"), -unit.exponent))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_and_its_spelling_stay() {
        let near = |wanted: f64| move |read: f64| (read - wanted).abs() <= 1e-11 * wanted.abs();
        let rewrite = |text, value, dimension| rewritten(text, value, dimension, near(value));
        assert_eq!(
            rewrite("500 g mm", 0.0123456789, Dimension::Unbalance).as_deref(),
            Some("12345.6789 g mm")
        );
        assert_eq!(rewrite("1kg·m", 0.02, Dimension::Unbalance).as_deref(), Some("0.02kg·m"));
        assert_eq!(rewrite("1  oz in", 0.0, Dimension::Unbalance).as_deref(), Some("0  oz in"));
        assert_eq!(rewrite("0 deg", std::f64::consts::PI, Dimension::Angle).as_deref(), Some("180 deg"));
        assert_eq!(rewrite("1 mm", 1.0, Dimension::Angle), None);
        assert_eq!(rewrite("mm", 1.0, Dimension::Length), None);
        let third = rewrite("1 in", 1.0 / 3.0, Dimension::Length).expect("a length");
        assert!(parse(&third, Dimension::Length, "").is_ok_and(near(1.0 / 3.0)), "{third}");
    }
}
