//! A number as a plain decimal text.

/// `1.25e-1` times `10^exponent` without an exponent where that is short, without trailing zeros.
pub(super) fn decimal(scientific: &str, exponent: i32) -> String {
    let (mantissa, own) = scientific.split_once('e').unwrap_or((scientific, "0"));
    let exponent = own.parse::<i32>().unwrap_or(0) + exponent;
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(mantissa) => ("-", mantissa),
        None => ("", mantissa),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_end_matches('0');
    if digits.is_empty() {
        return format!("{sign}0");
    }
    let point = exponent + whole.len() as i32;
    let count = digits.len() as i32;
    match point {
        -5..=0 => format!("{sign}0.{}{digits}", "0".repeat(-point as usize)),
        1..=16 if point >= count => format!("{sign}{digits}{}", "0".repeat((point - count) as usize)),
        1..=16 => format!("{sign}{}.{}", &digits[..point as usize], &digits[point as usize..]),
        _ if count == 1 => format!("{sign}{digits}e{}", point - 1),
        _ => format!("{sign}{}.{}e{}", &digits[..1], &digits[1..], point - 1),
    }
}
