//! Writing a formula as MathML Core, which browsers set without a script.

use super::expression::{Bracket, Item, Node, Script};
use super::fractions::stack;
use super::tokens::is_accent;

/// Spaces between factors [em].
const THIN: f64 = 0.12;
const MEDIUM: f64 = 0.2;
const WIDE: f64 = 0.3;

/// Text with the characters replaced that XML reads as marks.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// `<math>` of these items, with their plain text as alternative.
pub fn math(items: &[Item], plain: &str) -> String {
    format!("<math displaystyle=\"true\" alttext=\"{}\">{}</math>", escape(plain), row(items, Size::Full))
}

/// How much room there is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Size {
    /// On the line: fractions are stacked.
    Full,
    /// In a fraction or a limit: they are not.
    Small,
    /// In a script: words are upright names.
    Script,
}

/// What is taller than a line: brackets around it grow.
const TALL: [&str; 9] =
    ["<mfrac", "<msqrt", "<munder", "<mtable", "<mo>∑", "<mo>∏", "<mo>∫", "<mo>∬", "<mo>∮"];

fn element(name: &str, content: &str) -> String {
    format!("<{name}>{content}</{name}>")
}

/// All items one behind the other, as one element.
fn row(items: &[Item], size: Size) -> String {
    let stacked = arranged(items, size);
    let content = in_line(&stacked, size);
    if stacked.len() == 1 { content } else { element("mrow", &content) }
}

/// All items one behind the other.
fn sequence(items: &[Item], size: Size) -> String {
    in_line(&arranged(items, size), size)
}

/// The items with their fractions, where there is room for them.
fn arranged(items: &[Item], size: Size) -> Vec<Item> {
    if size == Size::Full { stack(items) } else { items.to_vec() }
}

fn in_line(stacked: &[Item], size: Size) -> String {
    let mut content = String::new();
    let mut before: Option<&Item> = None;
    for (index, item) in stacked.iter().enumerate() {
        if let Some(space) = before.and_then(|before| space(before, item)) {
            content += &format!("<mspace width=\"{space}em\"/>");
        }
        let no_operand =
            |before: &Item| matches!(before.node, Node::Operator(_) | Node::Punctuation(_) | Node::Slash);
        let touches = stacked.get(index + 1).is_some_and(|next| !next.spaced);
        content += &match &item.node {
            Node::Operator(sign) if "+−±∓".contains(sign.as_str()) => {
                // Before its operand alone, or between two: what stands before it may be words.
                let prefix = before.is_some_and(no_operand) || touches && (before.is_none() || item.spaced);
                format!("<mo form=\"{}\">{sign}</mo>", if prefix { "prefix" } else { "infix" })
            }
            node => {
                let argument = index.checked_sub(1).is_some_and(|before| stacked[before].node.is_function());
                write(node, size, argument)
            }
        };
        before = Some(item);
    }
    content
}

/// The space between two items, where operators bring none of their own [em].
fn space(before: &Item, item: &Item) -> Option<f64> {
    let bare = |node: &Node| matches!(node, Node::Operator(_) | Node::Slash | Node::Punctuation(_));
    let word = |node: &Node| matches!(node, Node::Word(_) | Node::Code(_));
    let sum = |node: &Node| match node {
        Node::Limits(big, ..) => matches!(**big, Node::Big(_)),
        node => matches!(node, Node::Big(_)),
    };
    if integral(&before.node) {
        return Some(MEDIUM);
    }
    if sum(&before.node) || matches!(item.node, Node::Big(_)) {
        return None;
    }
    if let Node::Punctuation(_) = before.node {
        return item.spaced.then_some(MEDIUM);
    }
    if bare(&item.node) && word(&before.node) || bare(&before.node) && word(&item.node) {
        return None;
    }
    if !item.spaced || bare(&item.node) || bare(&before.node) {
        return None;
    }
    let wide = word(&before.node) || word(&item.node);
    let medium = before.node.is_function()
        || matches!(before.node, Node::Limits(..))
        || item.node.is_function()
        || matches!(
            item.node,
            Node::Differential(..) | Node::Number(_) | Node::Group(..) | Node::Applied(..)
        )
        || matches!(before.node, Node::Differential(..) | Node::Fraction(..));
    Some(if wide {
        WIDE
    } else if medium {
        MEDIUM
    } else {
        THIN
    })
}

/// Whether it is an integral, whose sign leans over what follows.
fn integral(node: &Node) -> bool {
    match node {
        Node::Big(sign) => sign != "Σ" && sign != "Π",
        Node::Limits(big, ..) => integral(big),
        _ => false,
    }
}

/// One node; `argument` if it is that of a function, which keeps its bracket.
fn write(node: &Node, size: Size, argument: bool) -> String {
    match node {
        Node::Letter(letter) => accented(letter),
        Node::Upright(letter) => format!("<mi mathvariant=\"normal\">{letter}</mi>"),
        Node::Number(number) if number == "½" && size == Size::Full => {
            element("mfrac", "<mn>1</mn><mn>2</mn>")
        }
        Node::Number(number) => element("mn", number),
        Node::Word(word) if size == Size::Script => element("mi", &escape(word)),
        Node::Word(word) => element("mtext", &escape(word)),
        Node::Code(code) => element("mtext", &element("code", &escape(code))),
        Node::Function(name) => element("mi", name),
        Node::Differential(mark, of) => {
            let mark = if mark == "d" { "<mi mathvariant=\"normal\">d</mi>" } else { "<mi>∂</mi>" };
            element("mrow", &format!("{mark}{}", write(of, size, false)))
        }
        Node::Group(bracket, items) => group(*bracket, items, size, argument),
        Node::Matrix(rows) => matrix(rows, size),
        Node::Root(items) => element("msqrt", &sequence(items, size)),
        Node::Scripts(base, scripts) => scripted(base, scripts, size),
        Node::Applied(name, argument) => {
            element("mrow", &format!("{}{}", write(name, size, false), write(argument, size, true)))
        }
        Node::Limits(big, below, above) => limits(big, below, above, size),
        Node::Fraction(above, below) => {
            element("mfrac", &format!("{}{}", row(above, Size::Small), row(below, Size::Small)))
        }
        Node::Big(sign) => element("mo", sign_of(sign)),
        Node::Operator(sign) if sign.starts_with(['′', '″']) => {
            format!("<mo lspace=\"0\" rspace=\"0\">{sign}</mo>")
        }
        Node::Operator(sign) => element("mo", &escape(sign)),
        Node::Slash => "<mo lspace=\"0.06em\" rspace=\"0.06em\">/</mo>".to_owned(),
        Node::Punctuation(sign) if sign == ":" => element("mtext", ":"),
        Node::Punctuation(sign) => element("mo", sign),
    }
}

/// The sign of a sum or product: the letters Σ and Π do not grow.
fn sign_of(sign: &str) -> &str {
    match sign {
        "Σ" => "∑",
        "Π" => "∏",
        other => other,
    }
}

/// A letter: names are italic, Δ and ∇ are not; accents stand over their letter.
fn accented(letter: &str) -> String {
    let base: String = letter.chars().filter(|c| !is_accent(*c)).collect();
    let name = match base.as_str() {
        "…" => "<mo>…</mo>".to_owned(),
        "Δ" | "∇" => format!("<mi mathvariant=\"normal\">{base}</mi>"),
        _ => element("mi", &base),
    };
    letter.chars().filter(|c| is_accent(*c)).fold(name, |name, accent| {
        let mark = match accent {
            '\u{308}' => "¨",
            '\u{304}' => "¯",
            _ => "˙",
        };
        format!("<mover accent=\"true\">{name}<mo stretchy=\"false\">{mark}</mo></mover>")
    })
}

fn group(bracket: Bracket, items: &[Item], size: Size, argument: bool) -> String {
    // A bracket around nothing but a fraction says what its line says.
    if size == Size::Full && bracket == Bracket::Round && !argument {
        let stacked = stack(items);
        if let [Item { node: fraction @ Node::Fraction(..), .. }] = stacked.as_slice() {
            return write(fraction, size, false);
        }
    }
    let (open, close) = bracket.signs();
    fenced(open, &sequence(items, size), close)
}

fn matrix(rows: &[Vec<Vec<Item>>], size: Size) -> String {
    let mut table = String::new();
    for cells in rows {
        let cells: String = cells.iter().map(|cell| element("mtd", &sequence(cell, size))).collect();
        table += &element("mtr", &cells);
    }
    fenced("[", &element("mtable", &table), "]")
}

/// Brackets around a content, as tall as it is.
fn fenced(open: &str, content: &str, close: &str) -> String {
    let grows = TALL.iter().any(|tall| content.contains(tall));
    let bracket = |form: &str, sign: &str| {
        format!("<mo form=\"{form}\" fence=\"true\" stretchy=\"{grows}\">{sign}</mo>")
    };
    element("mrow", &format!("{}{content}{}", bracket("prefix", open), bracket("postfix", close)))
}

/// Scripts in the order in which they are written: a subscript and then superscripts stand one above the other.
fn scripted(base: &Node, scripts: &[Script], size: Size) -> String {
    // The bracket of what is raised stays.
    let mut written = write(base, size, true);
    let mut rest = scripts;
    while let [first, ..] = rest {
        let lowered = usize::from(!first.raised);
        let raised = rest[lowered..].iter().take_while(|script| script.raised).count();
        let above: Vec<Item> =
            rest[lowered..lowered + raised].iter().flat_map(|script| script.content.clone()).collect();
        let (below, above) = (row(&first.content, Size::Script), row(&above, Size::Script));
        written = match (lowered, raised) {
            (0, _) => element("msup", &format!("{written}{above}")),
            (_, 0) => element("msub", &format!("{written}{below}")),
            _ => element("msubsup", &format!("{written}{below}{above}")),
        };
        rest = &rest[lowered + raised..];
    }
    written
}

fn limits(big: &Node, below: &[Item], above: &[Item], size: Size) -> String {
    let sign = write(big, size, false);
    let row = |items: &[Item]| element("mrow", &sequence(items, Size::Small));
    let below = row(below);
    if above.is_empty() {
        element("munder", &format!("{sign}{below}"))
    } else {
        element("munderover", &format!("{sign}{below}{}", row(above)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::expression::expression;
    use super::*;

    /// What stands in `<math>`, without the attributes of brackets and signs.
    fn set(formula: &str) -> String {
        let written = math(&expression(formula).unwrap(), formula);
        let inside = written.split_once('>').unwrap().1.strip_suffix("</math>").unwrap().to_owned();
        let plain =
            ["form=\"prefix\"", "form=\"postfix\"", "form=\"infix\"", "fence=\"true\"", "stretchy=\"false\""];
        plain.iter().fold(inside, |text, attribute| text.replace(&format!(" {attribute}"), ""))
    }

    fn sets(pairs: &[(&str, &str)]) {
        for (formula, expected) in pairs {
            assert_eq!(set(formula), *expected, "{formula}");
        }
    }

    #[test]
    fn scripts() {
        sets(&[
            ("F_x", "<msub><mi>F</mi><mi>x</mi></msub>"),
            ("c_{n+1}", "<msub><mi>c</mi><mrow><mi>n</mi><mo>+</mo><mn>1</mn></mrow></msub>"),
            ("M_(i−1)", "<msub><mi>M</mi><mrow><mi>i</mi><mo>−</mo><mn>1</mn></mrow></msub>"),
            ("s_top,i", "<msub><mi>s</mi><mrow><mi>top</mi><mo>,</mo><mi>i</mi></mrow></msub>"),
            ("f_−n", "<msub><mi>f</mi><mrow><mo>−</mo><mi>n</mi></mrow></msub>"),
            ("σ₁", "<msub><mi>σ</mi><mn>1</mn></msub>"),
            ("A2", "<msub><mi>A</mi><mn>2</mn></msub>"),
            ("b_rg", "<msub><mi>b</mi><mrow><mi>r</mi><mi>g</mi></mrow></msub>"),
            ("r⁻³", "<msup><mi>r</mi><mrow><mo>−</mo><mn>3</mn></mrow></msup>"),
            ("β′²", "<msup><mi>β</mi><mrow><mo lspace=\"0\" rspace=\"0\">′</mo><mn>2</mn></mrow></msup>"),
            ("q''", "<msup><mi>q</mi><mo lspace=\"0\" rspace=\"0\">″</mo></msup>"),
            ("B_jᵀ", "<msubsup><mi>B</mi><mi>j</mi><mi mathvariant=\"normal\">T</mi></msubsup>"),
            ("e^{inθ}", "<msup><mi>e</mi><mrow><mi>i</mi><mi>n</mi><mi>θ</mi></mrow></msup>"),
            ("D^−0.2", "<msup><mi>D</mi><mrow><mo>−</mo><mn>0.2</mn></mrow></msup>"),
            ("f*", "<msup><mi>f</mi><mo>*</mo></msup>"),
            (
                "(a b)_k",
                "<msub><mrow><mo>(</mo><mi>a</mi><mspace width=\"0.12em\"/><mi>b</mi><mo>)</mo></mrow><mi>k</mi></msub>",
            ),
            ("[v]×", "<msub><mrow><mo>[</mo><mi>v</mi><mo>]</mo></mrow><mo>×</mo></msub>"),
        ]);
    }

    #[test]
    fn letters_words_and_accents() {
        sets(&[
            ("nω", "<mrow><mi>n</mi><mi>ω</mi></mrow>"),
            ("s\u{308}", "<mover accent=\"true\"><mi>s</mi><mo>¨</mo></mover>"),
            ("ẇ", "<mover accent=\"true\"><mi>w</mi><mo>˙</mo></mover>"),
            ("ΔE", "<mrow><mi mathvariant=\"normal\">Δ</mi><mi>E</mi></mrow>"),
            ("dψ", "<mrow><mi mathvariant=\"normal\">d</mi><mi>ψ</mi></mrow>"),
            ("sin φ", "<mrow><mi>sin</mi><mspace width=\"0.2em\"/><mi>φ</mi></mrow>"),
            ("1 − droop", "<mrow><mn>1</mn><mo>−</mo><mtext>droop</mtext></mrow>"),
            ("a <= b", "<mrow><mi>a</mi><mo>≤</mo><mi>b</mi></mrow>"),
            ("-a", "<mrow><mo>−</mo><mi>a</mi></mrow>"),
        ]);
    }

    #[test]
    fn fractions_roots_and_matrices() {
        sets(&[
            ("π/4", "<mfrac><mi>π</mi><mn>4</mn></mfrac>"),
            ("½", "<mfrac><mn>1</mn><mn>2</mn></mfrac>"),
            ("(2/3)", "<mfrac><mn>2</mn><mn>3</mn></mfrac>"),
            (
                "r^(2/γ)",
                "<msup><mi>r</mi><mrow><mn>2</mn><mo lspace=\"0.06em\" rspace=\"0.06em\">/</mo><mi>γ</mi></mrow></msup>",
            ),
            ("√(a + b)", "<msqrt><mi>a</mi><mo>+</mo><mi>b</mi></msqrt>"),
            ("sqrt(λ)", "<msqrt><mi>λ</mi></msqrt>"),
            ("∂S/∂R", "<mfrac><mrow><mi>∂</mi><mi>S</mi></mrow><mrow><mi>∂</mi><mi>R</mi></mrow></mfrac>"),
            (
                "[a, 0; b, 1]",
                "<mrow><mo stretchy=\"true\">[</mo><mtable><mtr><mtd><mi>a</mi></mtd><mtd><mn>0</mn></mtd></mtr>\
                 <mtr><mtd><mi>b</mi></mtd><mtd><mn>1</mn></mtd></mtr></mtable><mo stretchy=\"true\">]</mo></mrow>",
            ),
        ]);
    }

    #[test]
    fn bars_pair() {
        let bars = |inside: &str| format!("<mrow><mo>|</mo>{inside}<mo>|</mo></mrow>");
        assert_eq!(set("|a|"), bars("<mi>a</mi>"));
        assert_eq!(set("|K||a|"), format!("<mrow>{}{}</mrow>", bars("<mi>K</mi>"), bars("<mi>a</mi>")));
        let nested = format!("{}<mo>−</mo>{}", bars("<mi>f</mi>"), bars("<mi>g</mi>"));
        assert_eq!(set("| |f| − |g| |"), bars(&nested));
        assert_eq!(
            set("E(y | p)"),
            "<mrow><mi>E</mi><mrow><mo>(</mo><mi>y</mi><mo>|</mo><mi>p</mi><mo>)</mo></mrow></mrow>"
        );
        assert_eq!(set("|d|²"), format!("<msup>{}<mn>2</mn></msup>", bars("<mi>d</mi>")));
    }

    #[test]
    fn sums_and_integrals() {
        sets(&[
            (
                "SUM over i of a_i",
                "<mrow><munder><mo>∑</mo><mrow><mi>i</mi></mrow></munder><msub><mi>a</mi><mi>i</mi></msub></mrow>",
            ),
            ("Σ a", "<mrow><mo>∑</mo><mi>a</mi></mrow>"),
            ("SUM of a", "<mrow><mo>∑</mo><mi>a</mi></mrow>"),
            (
                "∫ from 0 to θ of T",
                "<mrow><munderover><mo>∫</mo><mrow><mn>0</mn></mrow><mrow><mi>θ</mi></mrow></munderover>\
                 <mspace width=\"0.2em\"/><mi>T</mi></mrow>",
            ),
            (
                "INTEGRAL over a period of y",
                "<mrow><munder><mo>∫</mo><mrow><mtext>a</mtext><mspace width=\"0.3em\"/><mtext>period</mtext></mrow></munder>\
                 <mspace width=\"0.2em\"/><mi>y</mi></mrow>",
            ),
            (
                "max over m of F",
                "<mrow><munder><mi>max</mi><mrow><mi>m</mi></mrow></munder><mspace width=\"0.2em\"/><mi>F</mi></mrow>",
            ),
        ]);
    }

    #[test]
    fn the_plain_text_is_the_alternative() {
        let written = math(&expression("a < b").unwrap(), "a < b");
        assert!(written.starts_with("<math displaystyle=\"true\" alttext=\"a &lt; b\">"), "{written}");
    }

    #[test]
    fn brackets_grow_with_what_they_hold() {
        assert!(math(&expression("sin(α/2)").unwrap(), "").contains("stretchy=\"true\">("));
        assert!(math(&expression("f(x)").unwrap(), "").contains("stretchy=\"false\">("));
    }
}
