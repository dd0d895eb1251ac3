//! Equations as a LaTeX document.

use crate::output::parts::{EquationPart, PartLine};
use crate::output::shown::{Notation, ShownEquations};
use std::fmt::Write;

/// Width from which a sum goes on in the next line, in signs.
const WIDEST: usize = 90;
/// From a line of a sum to the next.
const GOES_ON: &str = " \\\\\n&\\quad ";

/// All equations as a document that LaTeX compiles, with what [`crate::equations_text`] has; of equations in [`Notation::Latex`].
///
/// ```
/// let graph = lanchester_bondgraph::Graph::read(
///     "name = \"cart\"\n[elements]\npush = { kind = \"Se\", domain = \"translation\", effort = \"2 N\" }\ncart = { kind = \"I\", inertia = \"3 kg\" }\n\
///      [bonds]\nlist = [\"push > cart\"]\n",
/// );
/// let found = lanchester_bondgraph::equations(&graph.expect("it is good")).expect("no conflict");
/// let text = lanchester_bondgraph::equations_latex(&found.shown(lanchester_bondgraph::Notation::Latex));
/// assert!(text.contains("\\subsection*{State equations}"));
/// ```
pub fn equations_latex(shown: &ShownEquations) -> String {
    let mut out = format!(
        "\\documentclass[a4paper,landscape]{{article}}\n\\usepackage[margin=15mm]{{geometry}}\n\\usepackage{{amsmath}}\n\
         \\allowdisplaybreaks\n\\begin{{document}}\n\\section*{{{}}}\n",
        escaped(&shown.graph)
    );
    for EquationPart { title, lines } in shown.parts() {
        let lines: Vec<String> = lines.iter().map(line).collect();
        let _ = writeln!(
            out,
            "\\subsection*{{{title}}}\n\\begin{{align*}}\n{}\n\\end{{align*}}",
            lines.join(" \\\\\n")
        );
    }
    out + "\\end{document}\n"
}

fn line(line: &PartLine) -> String {
    let equation = &line.equation;
    let mut out = match line.when {
        Some(_) => format!("& {}", line.formula(Notation::Latex)),
        None if width(&equation.left) > WIDEST => {
            format!("& {}", in_lines(&line.formula(Notation::Latex)).join(GOES_ON))
        }
        None => format!("{} &= {}", equation.left, in_lines(&equation.right).join(GOES_ON)),
    };
    if !equation.unit.is_empty() {
        let _ = write!(out, " && [{}]", unit(&equation.unit));
    }
    if let Some(why) = &line.why {
        let _ = write!(out, " && \\text{{{}}}", escaped(why));
    }
    out
}

/// A formula in lines: a long sum goes on at a sign that stands in no bracket.
fn in_lines(text: &str) -> Vec<String> {
    let (mut lines, mut from, mut depth) = (Vec::new(), 0, 0i32);
    for (at, sign) in text.char_indices() {
        let rest = &text[at..];
        depth += i32::from(sign == '{' || rest.starts_with("\\left("));
        depth -= i32::from(sign == '}' || rest.starts_with("\\right)"));
        let goes_on = [" + ", " - ", " = "].iter().any(|sign| rest.starts_with(sign));
        if depth == 0 && goes_on && width(&text[from..at]) > WIDEST {
            lines.push(text[from..at].to_owned());
            from = at + 1;
        }
    }
    lines.push(text[from..].to_owned());
    lines
}

/// How many signs a formula has, commands and brackets of LaTeX left out.
fn width(text: &str) -> usize {
    let in_command = |(count, command): (usize, bool), sign: char| match sign {
        '\\' => (count, true),
        '{' | '}' | ' ' | '_' | '^' => (count, false),
        sign if command && sign.is_ascii_alphabetic() => (count, true),
        _ => (count + 1, false),
    };
    text.chars().fold((0, false), in_command).0
}

/// A unit upright, with its exponents.
fn unit(text: &str) -> String {
    let mut out = String::from("\\mathrm{");
    let mut letters = text.replace("Ohm", "\\Omega ").replace(' ', "\\,").replace("\\Omega\\,", "\\Omega ");
    let mut before = None;
    letters.push(' ');
    let mut exponent = false;
    for sign in letters.trim_end_matches(' ').chars() {
        let digit = sign.is_ascii_digit() || (exponent && sign == '.');
        if digit && !exponent && before.is_some_and(char::is_alphabetic) {
            out += "^{";
            exponent = true;
        } else if exponent && !digit {
            out.push('}');
            exponent = false;
        }
        out.push(sign);
        before = Some(sign);
    }
    out += if exponent { "}}" } else { "}" };
    out
}

/// Words as they stand.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for sign in text.chars() {
        match sign {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', sign]),
            sign => out.push(sign),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_exponents() {
        for (text, latex) in [
            ("kg m2/s2", "\\mathrm{kg\\,m^{2}/s^{2}}"),
            ("1/s", "\\mathrm{1/s}"),
            ("N m s", "\\mathrm{N\\,m\\,s}"),
            ("Ohm", "\\mathrm{\\Omega}"),
            ("1", "\\mathrm{1}"),
            ("m2.5", "\\mathrm{m^{2.5}}"),
        ] {
            assert_eq!(unit(text), latex, "{text}");
        }
    }

    #[test]
    fn a_long_sum_goes_on_in_the_next_line_outside_brackets_alone() {
        let term = format!("\\left({}\\right)", vec!["a + b"; 40].join(" + "));
        let lines = in_lines(&format!("{term} - {term} + c"));
        assert_eq!(lines, [term.clone(), format!("- {term}"), "+ c".into()]);
        assert_eq!(in_lines("a + b - c"), ["a + b - c"]);
    }
}
