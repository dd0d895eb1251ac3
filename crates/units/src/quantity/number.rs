//! The number in front of a unit: decimal, or a fraction as workshops write it.

use super::{Dimension, Refusal};

/// Parts a text into its number and its unit, both without blanks around them.
///
/// The number is what is meant as one, with separators that are mistakes; `1/2` and `4 1/2` are fractions, while the `1` of
/// `5500 1/min` belongs to the unit.
pub(super) fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let mut end = decimal_length(text);
    let over =
        text[end..].strip_prefix('/').map_or(0, |rest| rest.bytes().take_while(u8::is_ascii_digit).count());
    if over > 0 && text[..end].ends_with(|last: char| last.is_ascii_digit()) {
        end += 1 + over;
    } else if text[end..].trim_start().starts_with('/')
        && let Some(number) = text[..end].strip_suffix('1')
        && number.ends_with(' ')
    {
        end = number.len();
    }
    (text[..end].trim_end(), text[end..].trim_start())
}

/// Bytes of the leading text that is meant as a decimal number: what it is made of, with separators that are mistakes.
fn decimal_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let is_exponent = matches!(bytes[end], b'e' | b'E')
            && end > 0
            && bytes[end - 1] != b'.'
            && match bytes.get(end + 1) {
                Some(b'+' | b'-') => bytes.get(end + 2).is_some_and(u8::is_ascii_digit),
                Some(digit) => digit.is_ascii_digit(),
                None => false,
            };
        let is_sign =
            matches!(bytes[end], b'+' | b'-') && (end == 0 || matches!(bytes[end - 1], b'e' | b'E'));
        let is_number =
            matches!(bytes[end], b'0'..=b'9' | b'.' | b',' | b'_' | b'\'') || is_exponent || is_sign;
        let is_group = bytes[end] == b' '
            && bytes.get(end + 1).is_some_and(u8::is_ascii_digit)
            && end > 0
            && bytes[end - 1].is_ascii_digit();
        if !is_number && !is_group {
            break;
        }
        end += 1;
    }
    // An apostrophe after the last digit is a (misspelled) unit, not a separator.
    while end > 0 && bytes[end - 1] == b'\'' {
        end -= 1;
    }
    end
}

/// `number * 10^exponent`, rounded once (of a fraction twice); `None` for what is no number.
pub(super) fn scaled(number: &str, exponent: i32) -> Option<f64> {
    if let Some((numerator, denominator)) = fraction(number) {
        return Some(scaled(&numerator.to_string(), exponent)? / denominator as f64);
    }
    let (mantissa, own) = match number.split_once(['e', 'E']) {
        Some((mantissa, own)) => (mantissa, own.parse::<i32>().ok()?),
        None => (number, 0),
    };
    format!("{mantissa}e{}", own.saturating_add(exponent)).parse().ok()
}

/// `1/2` as 1 and 2, `-4 1/2` as -9 and 2; `None` where it is no fraction, or one that nobody writes: `4 3/2`, `1/0`.
fn fraction(number: &str) -> Option<(i64, i64)> {
    /// Doubles hold larger whole numbers no more exactly.
    const LARGEST: i64 = 1 << 53;
    let (before, denominator) = number.split_once('/')?;
    let (unsigned, sign) = match before.strip_prefix('-') {
        Some(rest) => (rest, -1),
        None => (before.strip_prefix('+').unwrap_or(before), 1),
    };
    let whole_number = |text: &str| {
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        text.parse::<i64>().ok().filter(|value| digits && *value < LARGEST)
    };
    let denominator = whole_number(denominator).filter(|value| *value > 0)?;
    let numerator = match unsigned.split_once(' ') {
        Some((whole, numerator)) => {
            let numerator = whole_number(numerator.trim_start()).filter(|value| *value < denominator)?;
            whole_number(whole)?.checked_mul(denominator)?.checked_add(numerator)?
        }
        None => whole_number(unsigned)?,
    };
    (numerator < LARGEST).then_some((sign * numerator, denominator))
}

/// A fraction that is none, a decimal comma, separators between digits, or more than one point.
pub(super) fn misspelled(number: &str, unit: &str, dimension: Dimension) -> Option<Refusal> {
    let with_unit = |number: &str| {
        let unit = if unit.is_empty() { dimension.units().next().map_or("", |unit| unit.name) } else { unit };
        format!("\"{number} {unit}\"")
    };
    let example = || format!("write a plain decimal number such as {}", with_unit("12.5"));
    if number.contains('/') {
        return fraction(number).is_none().then(|| Refusal {
            code: "E0105",
            message: format!("{number} is no number"),
            label: "no fraction".into(),
            hint: format!("write a fraction like {} or {}", with_unit("1/2"), with_unit("4 1/2")),
        });
    }
    // "4-1/2 in": the fraction of a mixed number.
    if unit.starts_with('-')
        && unit[1..].starts_with(|first: char| first.is_ascii_digit())
        && unit.contains('/')
    {
        return Some(Refusal {
            code: "E0105",
            message: "a whole number and its fraction need a blank between them".into(),
            label: "hyphen in a number".into(),
            hint: format!("write \"{number} {}\"", &unit[1..]),
        });
    }
    let commas = number.matches(',').count();
    if commas == 1 && !number.contains(['.', ' ', '_', '\'']) {
        let mut hint = format!("write {}", with_unit(&number.replace(',', ".")));
        let after_comma = number.split(',').nth(1).unwrap_or("");
        if after_comma.len() == 3 && after_comma.bytes().all(|byte| byte.is_ascii_digit()) {
            hint += &format!(", or {} if the comma parts thousands", with_unit(&number.replace(',', "")));
        }
        return Some(Refusal {
            code: "E0104",
            message: "decimal comma".into(),
            label: "comma in a number".into(),
            hint,
        });
    }
    if number.contains([',', ' ', '_', '\'']) {
        return Some(Refusal {
            code: "E0105",
            message: "a number without separators between its digits is needed".into(),
            label: "separator in a number".into(),
            hint: ungrouped(number).map_or_else(example, |plain| format!("write {}", with_unit(&plain))),
        });
    }
    if number.parse::<f64>().is_err() {
        return Some(Refusal {
            code: "E0105",
            message: format!("{number} is no number"),
            label: "no number".into(),
            hint: example(),
        });
    }
    None
}

/// The number without the separators between its thousands, where all groups but the first have three digits: what it says
/// is beyond doubt. Of points and commas together the last is the decimal mark.
fn ungrouped(number: &str) -> Option<String> {
    let (mantissa, power) = number.split_at(number.find(['e', 'E']).unwrap_or(number.len()));
    let (points, commas) = (mantissa.matches('.').count(), mantissa.matches(',').count());
    let mark = match (points, commas) {
        (0, 0) => None,
        (1, 0) => Some('.'),
        (0, 1) => Some(','),
        (0, _) => None,
        _ => mantissa.rfind(['.', ',']).and_then(|at| mantissa[at..].chars().next()),
    };
    let (whole, decimals) = match mark {
        Some(mark) => mantissa.rsplit_once(mark)?,
        None => (mantissa, ""),
    };
    let (sign, whole) = whole.split_at(usize::from(whole.starts_with(['+', '-'])));
    let separators = [' ', '_', '\'', ',', '.'];
    let kinds = separators.iter().filter(|separator| whole.contains(**separator)).count();
    let groups: Vec<&str> = whole.split(separators).collect();
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let thousands = groups[1..].iter().all(|group| group.len() == 3) && (1..=3).contains(&groups[0].len());
    let good = kinds <= 1
        && groups.iter().all(|group| digits(group))
        && digits(decimals)
        && (thousands || groups.len() == 1 && !groups[0].is_empty());
    let point = if decimals.is_empty() { "" } else { "." };
    good.then(|| format!("{sign}{}{point}{decimals}{power}", groups.concat()))
}
