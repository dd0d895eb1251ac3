//! Numbers in the text of a drawing.

/// The shortest decimals that give the number back, always with a point, never with an exponent. Below 1e-20 it is zero.
pub(super) fn decimal(number: f64) -> String {
    if number.abs() < 1e-20 {
        return "0.0".to_string();
    }
    let text = format!("{number}");
    if text.contains('.') { text } else { text + ".0" }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn numbers_are_given_back_without_exponent() {
        for number in [0.1, -3.0, 1e-12, 123_456_789.123, 1.0 / 3.0, -2.5e-19] {
            let text = decimal(number);
            assert!(text.contains('.') && !text.contains('e'), "{text}");
            assert_eq!(text.parse(), Ok(number));
        }
        assert_eq!(decimal(-0.0), "0.0");
        assert_eq!(decimal(3.0), "3.0");
    }
}
