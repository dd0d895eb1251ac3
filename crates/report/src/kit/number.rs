//! Numbers as people read them: few digits, grouped thousands, a true minus, never "NaN" and never "-0".

use std::f64::consts::TAU;

/// What stands where a number is missing or not finite.
pub const MISSING: &str = "\u{2013}";

/// Decimals with which numbers up to `largest` show `significant` digits: 0 to 6, from 10 up not more than 2.
pub fn decimals(largest: f64, significant: i32) -> usize {
    if !largest.is_finite() || largest <= 0.0 {
        return 0;
    }
    let leading = largest.abs().log10().floor() as i32;
    (significant - 1 - leading).clamp(0, if leading > 0 { 2 } else { 6 }) as usize
}

/// `value` with a fixed number of decimals, plain ASCII, thousands not grouped. What rounds to zero is "0".
pub fn plain(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "-".to_owned();
    }
    let text = format!("{value:.decimals$}");
    let vanishes = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if vanishes { "0".to_owned() } else { text }
}

/// `value` with a fixed number of decimals for the eye: true minus, thin groups from five digits on.
pub fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return MISSING.to_owned();
    }
    grouped(&plain(value, decimals), '\u{202f}').replace('-', "\u{2212}")
}

/// The space between groups of three digits on a terminal: no line breaks there, and every font has it.
pub const NO_BREAK: char = '\u{a0}';

/// As [`fixed`], for a terminal: ASCII minus, groups apart by [`NO_BREAK`].
pub fn terminal(value: f64, decimals: usize) -> String {
    grouped(&plain(value, decimals), NO_BREAK)
}

/// A whole number for a terminal, in groups from five digits on.
pub fn whole(value: u128) -> String {
    grouped(&value.to_string(), NO_BREAK)
}

/// `value` with about `significant` digits, for running text and labels.
pub fn short(value: f64, significant: i32) -> String {
    fixed(value, decimals(value.abs(), significant))
}

/// As [`short`], without zeros at its end: "87.5", not "87.50".
pub fn trimmed(value: f64, significant: i32) -> String {
    let text = short(value, significant);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// Revolutions a minute from rad/s.
pub fn rpm(speed: f64) -> f64 {
    speed * 60.0 / TAU
}

/// With a capital at its beginning.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Degrees from radians, folded to (-180, 180].
pub fn phase_degrees(radians: f64) -> f64 {
    let folded = radians.to_degrees().rem_euclid(360.0);
    // A hair beyond 180 is 180: what is printed as 180.00 must not flip its sign by rounding.
    if folded > 180.0 + 0.005 { folded - 360.0 } else { folded }
}

/// An order: "2", "0.5", "1.33".
pub fn order(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.replace('-', "\u{2212}")
}

/// "first", "second" for the low whole orders, "order 2.5" for the others.
pub fn order_word(value: f64) -> String {
    const WORDS: [&str; 8] = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"];
    for (index, word) in WORDS.iter().enumerate() {
        if (value - (index + 1) as f64).abs() < 1e-9 {
            return format!("{word} order");
        }
    }
    format!("order {}", order(value))
}

/// Cylinder or throw numbers as a list with runs joined: "1–4, 6".
pub fn list(numbers: &[usize]) -> String {
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    let mut parts: Vec<String> = Vec::new();
    let mut start = 0;
    while start < sorted.len() {
        let mut end = start;
        while end + 1 < sorted.len() && sorted[end + 1] == sorted[end] + 1 {
            end += 1;
        }
        match end - start {
            0 => parts.push(sorted[start].to_string()),
            1 => parts.push(format!("{}, {}", sorted[start], sorted[end])),
            _ => parts.push(format!("{}\u{2013}{}", sorted[start], sorted[end])),
        }
        start = end + 1;
    }
    parts.join(", ")
}

/// A unit with its prefix, and what a value in SI is divided by to be printed in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Divisor.
    pub divisor: f64,
    /// Prefix and unit.
    pub unit: String,
}

impl Scale {
    /// The prefix that keeps numbers up to `largest` between 0.1 and 10 000.
    pub fn of(largest: f64, unit: &str) -> Scale {
        let (divisor, prefix) = match largest.abs() {
            v if v >= 1e7 => (1e6, "M"),
            v if v >= 1e4 => (1e3, "k"),
            v if v >= 0.1 || v <= 0.0 || v.is_nan() => (1.0, ""),
            v if v >= 1e-4 => (1e-3, "m"),
            _ => (1e-6, "\u{b5}"),
        };
        Scale { divisor, unit: format!("{prefix}{unit}") }
    }
}

fn grouped(text: &str, separator: char) -> String {
    let (sign, digits) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
    let (whole, fraction) = digits.split_once('.').map_or((digits, None), |(w, f)| (w, Some(f)));
    let mut out = String::with_capacity(text.len() + 8);
    out.push_str(sign);
    for (index, digit) in whole.chars().enumerate() {
        if whole.len() >= 5 && index > 0 && (whole.len() - index).is_multiple_of(3) {
            out.push(separator);
        }
        out.push(digit);
    }
    if let Some(fraction) = fraction {
        out.push('.');
        out.push_str(fraction);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_is_zero_and_nothing_is_nan() {
        assert_eq!(plain(-0.001, 2), "0");
        assert_eq!(fixed(0.0, 3), "0");
        assert_eq!(fixed(f64::NAN, 2), MISSING);
        assert_eq!(fixed(f64::NEG_INFINITY, 2), MISSING);
        assert_eq!(terminal(f64::NAN, 2), "-");
    }

    #[test]
    fn thousands_are_grouped_from_five_digits() {
        assert_eq!(terminal(12345.0, 0), "12\u{a0}345");
        assert_eq!(terminal(-1234567.25, 1), "-1\u{a0}234\u{a0}567.2");
        assert_eq!(terminal(4719.74, 2), "4719.74");
        assert_eq!(fixed(-12345.0, 0), "\u{2212}12\u{202f}345");
    }

    #[test]
    fn significant_digits() {
        assert_eq!(decimals(9535.5, 5), 1);
        assert_eq!(decimals(0.0456, 3), 4);
        assert_eq!(decimals(0.0, 3), 0);
        assert_eq!(decimals(f64::NAN, 3), 0);
        assert_eq!(short(0.020624, 4), "0.02062");
        assert_eq!(decimals(52.4826, 6), 2);
        assert_eq!((trimmed(87.5, 4), trimmed(120.0, 4)), ("87.5".to_owned(), "120".to_owned()));
    }

    #[test]
    fn orders_lists_and_scales() {
        assert_eq!(order(0.5), "0.5");
        assert_eq!(order(2.0), "2");
        assert_eq!(order_word(4.0), "fourth order");
        assert_eq!(order_word(2.5), "order 2.5");
        assert_eq!(list(&[4, 1, 2, 3, 6]), "1\u{2013}4, 6");
        assert_eq!(list(&[6, 1]), "1, 6");
        assert_eq!(Scale::of(12e3, "N").unit, "kN");
        assert_eq!(Scale::of(0.0, "N").divisor, 1.0);
        assert_eq!(Scale::of(0.02, "N m").unit, "mN m");
        assert!((phase_degrees(-std::f64::consts::PI) - 180.0).abs() < 1e-12);
    }
}
