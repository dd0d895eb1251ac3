//! Writing a formula as MathML Core, which browsers set without a script.

use crate::book::expression::{Bracket, Item, Node, Script};
use crate::book::fractions::stack;
use crate::book::tokens::is_accent;

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
    let content = sequence(items, size);
    if items.len() == 1 { content } else { element("mrow", &content) }
}

fn sequence(items: &[Item], size: Size) -> String {
    let stacked = if size == Size::Full { stack(items) } else { items.to_vec() };
    let mut content = String::new();
    let mut before: Option<&Item> = None;
    for (index, item) in stacked.iter().enumerate() {
        if let Some(space) = before.and_then(|before| space(before, item)) {
            content += &format!("<mspace width=\"{space}em\"/>");
        }
        let no_operand = |before: &Item| matches!(before.node, Node::Operator(_) | Node::Punctuation(_) | Node::Slash);
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
        || matches!(item.node, Node::Differential(..) | Node::Number(_) | Node::Group(..) | Node::Applied(..))
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
