//! Quantities in sentences: a number with its unit behind it, and lists of numbers with one unit behind the last.

use crate::kit::number::{NO_BREAK, decimals, terminal};
use crate::kit::us_unit::{Us, leading};

/// A unit of a number, and where in the text it stands, where it stands behind that number.
type Found = (Us, Option<(usize, usize)>);

/// A number as printed: where it stands, what it is, how many digits it shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Printed {
    /// First byte, its sign included.
    pub from: usize,
    /// First byte behind it.
    pub to: usize,
    /// Value.
    pub value: f64,
    /// Decimals that are printed.
    pub decimals: usize,
    /// Whether it is printed with a power of ten.
    pub powers: bool,
}

impl Printed {
    /// Digits that it shows, leading zeros apart.
    pub fn significant(&self) -> i32 {
        significant(self.value, self.decimals)
    }

    /// The number in another unit, with as many digits.
    fn in_unit(&self, us: Us) -> String {
        let value = us.of(self.value);
        if self.powers {
            return format!("{value:.*e}", self.decimals);
        }
        terminal(value, decimals(value.abs(), self.significant().clamp(3, 6)))
    }
}

/// Digits of a value that is printed with so many decimals, leading zeros apart; at least one.
pub(super) fn significant(value: f64, decimals: usize) -> i32 {
    if value == 0.0 {
        return 1;
    }
    (value.abs().log10().floor() as i32 + 1 + decimals as i32).max(1)
}

/// The number that begins at `from`.
pub(super) fn number_at(text: &str, from: usize) -> Option<Printed> {
    let sign = text[from..].chars().next().filter(|letter| matches!(letter, '-' | '\u{2212}' | '+'));
    let start = from + sign.map_or(0, char::len_utf8);
    let mut end = start;
    let (mut digits, mut places) = (String::new(), None);
    let mut letters = text[start..].char_indices().peekable();
    while let Some((at, letter)) = letters.next() {
        let next_is_digit = letters.peek().is_some_and(|(_, next)| next.is_ascii_digit());
        match letter {
            '0'..='9' => {
                digits.push(letter);
                places = places.map(|count: usize| count + 1);
            }
            '.' if places.is_none() && next_is_digit && !digits.is_empty() => {
                digits.push(letter);
                places = Some(0);
            }
            NO_BREAK | '\u{202f}' if places.is_none() && next_is_digit && !digits.is_empty() => {}
            'e' if !digits.is_empty() => {
                let power = &text[start + at + 1..];
                let length = power
                    .char_indices()
                    .find(|(k, c)| !(c.is_ascii_digit() || *k == 0 && *c == '-'))
                    .map_or(power.len(), |(k, _)| k);
                let value: f64 = format!("{digits}e{}", &power[..length]).parse().ok()?;
                let value = if matches!(sign, Some('-' | '\u{2212}')) { -value } else { value };
                let to = start + at + 1 + length;
                return Some(Printed { from, to, value, decimals: places.unwrap_or(0), powers: true });
            }
            _ => break,
        }
        end = start + at + letter.len_utf8();
    }
    let value: f64 = digits.parse().ok()?;
    let value = if matches!(sign, Some('-' | '\u{2212}')) { -value } else { value };
    Some(Printed { from, to: end, value, decimals: places.unwrap_or(0), powers: false })
}

/// All numbers of a text that are words of their own.
fn numbers(text: &str) -> Vec<Printed> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let letter = text[at..].chars().next().unwrap_or(' ');
        let behind = text[..at].chars().next_back();
        let apart = behind.is_none_or(|b| match b {
            '_' | '.' | '+' | '-' | '\u{2212}' | '^' | '/' => false,
            other => !other.is_alphanumeric(),
        });
        let begins = letter.is_ascii_digit() || matches!(letter, '-' | '\u{2212}' | '+');
        match number_at(text, at).filter(|_| apart && begins) {
            Some(number) => {
                // What stands between backquotes is a name or a line of the file, as it is written there.
                if text[..at].matches('`').count().is_multiple_of(2) {
                    found.push(number);
                }
                at = number.to;
            }
            None => at += letter.len_utf8(),
        }
    }
    found
}

/// What may stand between numbers that have one unit, behind the last of them.
fn is_between(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    matches!(
        words.as_slice(),
        [","] | ["and"] | ["to"] | [".."] | ["or"] | [",", "y" | "z", "="] | ["and", "y" | "z", "="]
    ) || matches!(words.as_slice(), ["\u{d7}"])
}

/// Sentences in units of the United States.
pub(super) fn sentence(text: &str) -> String {
    let numbers = numbers(text);
    // The unit of each number, and where it stands if that is behind this number.
    let mut units: Vec<Option<Found>> = vec![None; numbers.len()];
    for index in 0..numbers.len() {
        let behind = &text[numbers[index].to..];
        let Some(space) = behind.chars().next().filter(|letter| letter.is_whitespace()) else { continue };
        let from = numbers[index].to + space.len_utf8();
        let Some((length, us)) = leading(&text[from..]) else { continue };
        units[index] = Some((us, Some((from, from + length))));
        for earlier in (0..index).rev() {
            let (one, next) = (numbers[earlier], numbers[earlier + 1]);
            // A whole number before a comma may count something: orders, cylinders, webs.
            let counts =
                one.decimals == 0 && !one.powers && one.value != 0.0 && text[one.to..].starts_with(',');
            if units[earlier].is_some() || counts || !is_between(&text[one.to..next.from]) {
                break;
            }
            units[earlier] = Some((us, None));
        }
    }
    let mut out = String::with_capacity(text.len() + 16);
    let mut told = 0;
    for (number, unit) in numbers.iter().zip(units) {
        let Some((us, place)) = unit else { continue };
        out.push_str(&text[told..number.from]);
        out.push_str(&number.in_unit(us));
        told = number.to;
        if let Some((from, to)) = place {
            out.push_str(&text[told..from]);
            out.push_str(us.unit);
            told = to;
        }
    }
    out.push_str(&text[told..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_keep_their_digits_and_their_other_words() {
        for (si, us) in [
            ("force 16\u{a0}733 N (340 N as given)", "force 3761.7 lbf (76.4 lbf as given)"),
            ("16.3 kN of second order at 6500 rpm", "3664 lbf of second order at 6500 rpm"),
            ("2.500, 3.800 and\n2.300 kg m\u{b2} about x", "59.33, 90.18 and\n54.58 lb ft^2 about x"),
            ("at x = 68.10, y = 0, z = 0 mm: ", "at x = 2.681, y = 0, z = 0 in: "),
            ("no. 2, 80 mm", "no. 2, 3.15 in"),
            ("at most ±86.5 MPa", "at most ±12.5 ksi"),
            ("within -1.5e-3 kg m2", "within -3.6e-2 lb ft^2"),
            ("4.00 Hz and 30 deg", "4.00 Hz and 30 deg"),
            ("`-1 @ 0 mm, 100 mm` has 5 N", "`-1 @ 0 mm, 100 mm` has 1.12 lbf"),
        ] {
            assert_eq!(sentence(si), us);
        }
    }
}
