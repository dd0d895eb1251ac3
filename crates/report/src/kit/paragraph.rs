//! Paragraphs of plain text.

const WIDTH: usize = 96;

/// A paragraph broken at spaces, the first line behind `bullet`, the others indented below it.
pub(crate) fn push_wrapped(out: &mut String, bullet: &str, text: &str) {
    let indent = bullet.chars().count();
    let mut column = 0;
    for word in text.split_whitespace() {
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
        out.push_str(word);
        column += length;
    }
    if column > 0 {
        out.push('\n');
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn paragraphs_break_before_the_margin() {
        let mut out = String::new();
        super::push_wrapped(&mut out, "  - ", &"second order ".repeat(20));
        assert!(out.lines().all(|l| l.chars().count() <= super::WIDTH), "{out}");
        assert!(out.lines().skip(1).all(|l| l.starts_with("    s") || l.starts_with("    o")), "{out}");
    }
}
