//! Equations as MathML, which browsers and reports draw without a program: from the LaTeX that [`crate::Equations::shown`] writes.

use crate::output::greek::GREEK;

/// An equation in LaTeX, of the commands that this crate writes, as one MathML element.
///
/// ```
/// let drawn = lanchester_bondgraph::mathml("\\frac{p}{m^{2}}");
/// assert!(drawn.contains("<mfrac><mi>p</mi><msup><mi>m</mi><mn>2</mn></msup></mfrac>"));
/// ```
pub fn mathml(latex: &str) -> String {
    let mut reader = Reader { text: latex, at: 0, depth: 0 };
    let mut rows = String::new();
    // A closing bracket that nothing opened ends no row here.
    while reader.at < latex.len() {
        rows += &reader.row();
        reader.at += reader.rest().chars().next().map_or(0, char::len_utf8);
    }
    format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow>{rows}</mrow></math>")
}

/// Brackets deeper than this are left out.
const DEEPEST: usize = 200;

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

/// Letters of a command's name with the sign for it.
const SIGNS: [(&str, &str); 6] =
    [("to", "→"), ("cdot", "·"), ("ldots", "…"), ("leftarrow", "←"), ("min", "min"), ("max", "max")];

impl Reader<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn take(&mut self, word: &str) -> bool {
        let found = self.rest().starts_with(word);
        if found {
            self.at += word.len();
        }
        found
    }

    /// Everything up to a closing bracket or the end.
    fn row(&mut self) -> String {
        let mut row = String::new();
        self.depth += 1;
        while self.depth < DEEPEST {
            let blanks = self.rest().len() - self.rest().trim_start().len();
            self.at += blanks;
            if self.rest().is_empty() || self.rest().starts_with('}') || self.rest().starts_with("\\right") {
                break;
            }
            row += &self.with_indices();
        }
        self.depth -= 1;
        row
    }

    /// One thing with what stands below and above it.
    fn with_indices(&mut self) -> String {
        let base = self.thing();
        let below = self.take("_").then(|| self.thing());
        let above = self.take("^").then(|| self.thing());
        match (below, above) {
            (None, None) => base,
            (Some(below), None) => format!("<msub>{base}{below}</msub>"),
            (None, Some(above)) => format!("<msup>{base}{above}</msup>"),
            (Some(below), Some(above)) => format!("<msubsup>{base}{below}{above}</msubsup>"),
        }
    }

    fn thing(&mut self) -> String {
        self.at += self.rest().len() - self.rest().trim_start().len();
        if self.rest().starts_with('{') {
            return self.group();
        }
        if self.take("\\left(") {
            let row = self.row();
            self.take("\\right)");
            return format!("<mrow><mo>(</mo>{row}<mo>)</mo></mrow>");
        }
        if self.take("\\") {
            return self.command();
        }
        let rest = self.rest();
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.').len();
        if digits > 0 {
            let number = format!("<mn>{}</mn>", &rest[..digits]);
            self.at += digits;
            return number;
        }
        let Some(sign) = rest.chars().next() else { return "<mrow></mrow>".into() };
        self.at += sign.len_utf8();
        match sign {
            '-' => "<mo>−</mo>".into(),
            sign if sign.is_alphabetic() => format!("<mi>{sign}</mi>"),
            sign => format!("<mo>{}</mo>", escaped(&sign.to_string())),
        }
    }

    /// What stands in braces, as one element.
    fn group(&mut self) -> String {
        if !self.take("{") {
            return self.thing();
        }
        let row = self.row();
        self.take("}");
        let one = row.starts_with("<m") && elements(&row) == 1;
        if one { row } else { format!("<mrow>{row}</mrow>") }
    }

    /// The letters in braces as they stand.
    fn word(&mut self) -> String {
        if !self.take("{") {
            return String::new();
        }
        let end = self.rest().find('}').unwrap_or(self.rest().len());
        let word = self.rest()[..end].replace("\\_", "_").replace("\\to ", " → ");
        self.at += end;
        self.take("}");
        escaped(&word)
    }

    fn command(&mut self) -> String {
        let rest = self.rest();
        let length = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
        let name = rest[..length].to_owned();
        self.at += length;
        if let Some((_, sign)) = GREEK.iter().chain(&SIGNS).find(|(own, _)| *own == name) {
            let is_letter = sign.chars().all(char::is_alphabetic);
            return if is_letter { format!("<mi>{sign}</mi>") } else { format!("<mo>{sign}</mo>") };
        }
        match name.as_str() {
            "frac" => {
                let above = self.group();
                let below = self.group();
                format!("<mfrac>{above}{below}</mfrac>")
            }
            "sqrt" => format!("<msqrt>{}</msqrt>", self.group()),
            // Over the letter alone, beside its index.
            "dot" => format!("<mover>{}<mo>˙</mo></mover>", self.thing()),
            "text" => format!("<mtext>{}</mtext>", self.word()),
            "mathrm" => format!("<mi mathvariant=\"normal\">{}</mi>", self.word()),
            "operatorname" => format!("<mi mathvariant=\"normal\">{}</mi><mo>&#x2061;</mo>", self.word()),
            // A blank, or a sign that LaTeX needs a stroke before.
            "" => {
                let sign = self.rest().chars().next().unwrap_or(' ');
                self.at += if self.rest().is_empty() { 0 } else { sign.len_utf8() };
                if sign == ',' {
                    "<mspace width=\"0.17em\"/>".into()
                } else {
                    format!("<mo>{}</mo>", escaped(&sign.to_string()))
                }
            }
            _ => format!("<mi mathvariant=\"normal\">{}</mi><mo>&#x2061;</mo>", escaped(&name)),
        }
    }
}

/// Number of elements side by side at the top of a text.
fn elements(text: &str) -> usize {
    let (mut depth, mut count) = (0usize, 0usize);
    for tag in text.split('<').skip(1) {
        if tag.starts_with('/') {
            depth = depth.saturating_sub(1);
        } else {
            if depth == 0 {
                count += 1;
            }
            let inside = tag.split('>').next().unwrap_or_default();
            if !inside.ends_with('/') {
                depth += 1;
            }
        }
    }
    count
}

fn escaped(text: &str) -> String {
    crate::output::export::escaped(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inner(latex: &str) -> String {
        let all = mathml(latex);
        let start = all.find("<mrow>").expect("a row") + 6;
        all[start..all.len() - "</mrow></math>".len()].to_owned()
    }

    #[test]
    fn what_the_crate_writes_is_drawn() {
        assert_eq!(
            inner("p_{\\mathrm{mass}}"),
            "<msub><mi>p</mi><mi mathvariant=\"normal\">mass</mi></msub>"
        );
        assert_eq!(inner("\\dot p_1"), "<msub><mover><mi>p</mi><mo>˙</mo></mover><mn>1</mn></msub>");
        assert_eq!(inner("\\dot \\theta"), "<mover><mi>θ</mi><mo>˙</mo></mover>");
        assert_eq!(
            inner("2 \\, \\left(a - 1.5\\right)"),
            "<mn>2</mn><mspace width=\"0.17em\"/><mrow><mo>(</mo><mi>a</mi><mo>−</mo><mn>1.5</mn><mo>)</mo></mrow>"
        );
        assert_eq!(inner("\\sqrt{a b}"), "<msqrt><mrow><mi>a</mi><mi>b</mi></mrow></msqrt>");
    }

    #[test]
    fn any_text_ends_and_is_balanced() {
        for text in ["}", "\\", "^", "_{", "\\frac", "a}b", "\\right)", "\\left(", "{{{{", "<&>", "\\dot"] {
            let drawn = mathml(text);
            let opened = drawn.matches('<').count() - drawn.matches("/>").count();
            let closed = drawn.matches("</").count();
            assert_eq!(opened, 2 * closed, "{text}: {drawn}");
        }
        let deep = "{".repeat(5000);
        assert!(mathml(&deep).ends_with("</math>"));
    }

    #[test]
    fn a_shipped_graph_is_drawn_whole() {
        let graph = crate::Graph::read(include_str!("../../../../examples/bond-graphs/slider-crank.toml"))
            .expect("it is good");
        let shown = crate::equations(&graph).expect("no conflict").shown(crate::Notation::Latex);
        for equation in shown.elements.iter().chain(&shown.rates).chain(&shown.common) {
            let drawn = mathml(&format!("{} = {}", equation.left, equation.right));
            assert!(!drawn.contains('\\') && !drawn.contains("{"), "{}: {drawn}", equation.right);
        }
    }
}
