//! Numbers of equations and where they lead.

/// `43.2`: chapter and number.
pub fn is_equation_number(text: &str) -> bool {
    text.split_once('.').is_some_and(|(chapter, number)| {
        let digits = |part: &str| (1..=2).contains(&part.len()) && part.bytes().all(|b| b.is_ascii_digit());
        digits(chapter) && digits(number)
    })
}

/// `43.2` of `(43.2)`.
pub fn equation_number(text: &str) -> Option<&str> {
    text.strip_prefix('(')?.strip_suffix(')').filter(|number| is_equation_number(number))
}

/// Where an equation stands within its page.
pub fn anchor(number: &str) -> String {
    format!("eq-{}", number.replace('.', "-"))
}
