//! Paragraphs of plain text.

use crate::kit::number::NO_BREAK;
use crate::kit::us_unit::leading;

const WIDTH: usize = 96;

/// A paragraph broken at spaces, the first line behind `bullet`, the others indented below it. No line ends between the
/// groups of a number, nor between a number and its unit.
pub(crate) fn push_wrapped(out: &mut String, bullet: &str, text: &str) {
    let indent = bullet.chars().count();
    let mut column = 0;
    // What a page separates by a thin space a terminal separates by a common one.
    let text = text.replace('\u{202f}', &NO_BREAK.to_string());
    for word in unbroken(&text) {
        let length = word.chars().count();
        if column == 0 {
            out.push_str(bullet);
            column = indent;
        } else if column + 1 + length > WIDTH {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            column = indent;
        } else {
            out.push(' ');
            column += 1;
        }
        out.push_str(&word);
        column += length;
    }
    if column > 0 {
        out.push('\n');
    }
}

/// The words of a text, each number together with its unit.
fn unbroken(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = text.trim_ascii_start();
    while !rest.is_empty() {
        let mut end = rest.find(|letter: char| letter.is_ascii_whitespace()).unwrap_or(rest.len());
        let unit = rest[..end]
            .ends_with(|letter: char| letter.is_ascii_digit())
            .then(|| leading(rest[end..].trim_ascii_start()));
        if let Some((length, _)) = unit.flatten() {
            let from = rest.len() - rest[end..].trim_ascii_start().len() + length;
            end = from
                + rest[from..].find(|letter: char| letter.is_ascii_whitespace()).unwrap_or(rest.len() - from);
        }
        words.push(rest[..end].split_ascii_whitespace().collect::<Vec<_>>().join(" "));
        rest = rest[end..].trim_ascii_start();
    }
    words
}

#[cfg(test)]
mod tests {
    #[test]
    fn paragraphs_break_before_the_margin() {
        let mut out = String::new();
        super::push_wrapped(&mut out, "  - ", &"second order ".repeat(20));
        assert_eq!(
            super::unbroken("of 16\u{a0}733 N m, then\n 2 lines"),
            ["of", "16\u{a0}733 N m,", "then", "2", "lines"]
        );
        assert!(out.lines().all(|l| l.chars().count() <= super::WIDTH), "{out}");
        assert!(out.lines().skip(1).all(|l| l.starts_with("    s") || l.starts_with("    o")), "{out}");
    }
}
