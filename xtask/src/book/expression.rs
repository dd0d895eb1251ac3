//! What a formula says: tokens to operands with their scripts, brackets, sums and roots.

use super::tokens::{Kind, Token, tokens};
use anyhow::{Context, Result, bail};
use std::ops::Range;

/// A part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// One letter, perhaps with an accent.
    Letter(String),
    /// The d of a derivative.
    Upright(String),
    /// A number.
    Number(String),
    /// A word of text, or a quantity that is named by a word.
    Word(String),
    /// A key of a file.
    Code(String),
    /// A function without its argument.
    Function(String),
    /// `dθ`, `∂S`.
    Differential(String, Box<Node>),
    /// A bracket and what it holds.
    Group(Bracket, Vec<Item>),
    /// Rows of cells in brackets.
    Matrix(Vec<Vec<Vec<Item>>>),
    /// A root of all that is given.
    Root(Vec<Item>),
    /// What carries subscripts and superscripts, in their order.
    Scripts(Box<Node>, Vec<Script>),
    /// A name with its argument in brackets.
    Applied(Box<Node>, Box<Node>),
    /// A sum, a product, an integral, a least or a largest value with its limits: below, above.
    Limits(Box<Node>, Vec<Item>, Vec<Item>),
    /// The sign of a sum, a product or an integral.
    Big(String),
    /// A fraction that is stacked.
    Fraction(Vec<Item>, Vec<Item>),
    /// `+`, `=`, ...
    Operator(String),
    /// `/`
    Slash,
    /// `,`, `;`, `:`
    Punctuation(String),
}

/// The brackets of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `( )`
    Round,
    /// `[ ]`
    Square,
    /// `{ }`
    Brace,
    /// `| |`
    Bar,
}

impl Bracket {
    /// Both its signs.
    pub fn signs(self) -> (&'static str, &'static str) {
        match self {
            Bracket::Round => ("(", ")"),
            Bracket::Square => ("[", "]"),
            Bracket::Brace => ("{", "}"),
            Bracket::Bar => ("|", "|"),
        }
    }

    fn opened_by(sign: &str) -> Bracket {
        match sign {
            "[" => Bracket::Square,
            "{" => Bracket::Brace,
            "|" => Bracket::Bar,
            _ => Bracket::Round,
        }
    }
}

/// A subscript or superscript.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// Whether it is a superscript.
    pub raised: bool,
    /// What it says.
    pub content: Vec<Item>,
}

/// A node with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What stands there.
    pub node: Node,
    /// Whether a space stands before it.
    pub spaced: bool,
    /// Its bytes in the formula.
    pub at: Range<usize>,
}

impl Node {
    /// Whether it is a factor, complete in itself.
    pub fn is_operand(&self) -> bool {
        match self {
            Node::Operator(_) | Node::Slash | Node::Punctuation(_) => false,
            Node::Big(_) | Node::Limits(..) | Node::Function(_) => false,
            Node::Scripts(base, _) => base.is_operand(),
            _ => true,
        }
    }

    /// Whether it is a function that waits for its argument.
    pub fn is_function(&self) -> bool {
        match self {
            Node::Function(_) => true,
            Node::Scripts(base, _) => base.is_function(),
            _ => false,
        }
    }
}

/// The parts of a formula.
pub fn expression(formula: &str) -> Result<Vec<Item>> {
    let tokens = tokens(formula)?;
    let mut parser = Parser { formula, tokens, next: 0, in_bars: false };
    let items = parser.sequence(Stop::End)?;
    match parser.peek() {
        Some(token) => bail!("{:?} closes nothing in {formula:?}", token.text),
        None => Ok(items),
    }
}

/// Where a sequence ends; what ends it is not taken.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stop<'a> {
    End,
    Close,
    Bar,
    Word(&'a str),
}

struct Parser<'a> {
    formula: &'a str,
    tokens: Vec<Token>,
    next: usize,
    /// Whether the innermost bracket is a bar, so that the next one may close it.
    in_bars: bool,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next)
    }

    fn is_next(&self, kind: Kind, text: &str) -> bool {
        self.peek().is_some_and(|token| token.kind == kind && token.text == text)
    }

    /// Whether a token of this kind follows without a space.
    fn touches(&self, kind: Kind) -> bool {
        self.peek().is_some_and(|token| token.kind == kind && !token.spaced)
    }

    fn sequence(&mut self, stop: Stop<'_>) -> Result<Vec<Item>> {
        let around = self.in_bars;
        self.in_bars = match stop {
            Stop::Bar => true,
            Stop::Word(_) => around,
            Stop::End | Stop::Close => false,
        };
        let items = self.items(stop);
        self.in_bars = around;
        items
    }

    fn items(&mut self, stop: Stop<'_>) -> Result<Vec<Item>> {
        let mut items: Vec<Item> = Vec::new();
        while let Some(token) = self.peek() {
            let operand_before = items.last().is_some_and(|item| item.node.is_operand());
            match (token.kind, stop) {
                (Kind::Close, _) => break,
                (Kind::Bar, Stop::Bar) if operand_before => break,
                (Kind::Word, Stop::Word(word)) if token.text == word => break,
                _ => {}
            }
            let (spaced, start) = (token.spaced, token.at.start);
            // The bar of "given that" has operands and spaces on both sides.
            let given = token.kind == Kind::Bar
                && operand_before
                && spaced
                && self.tokens.get(self.next + 1).is_some_and(|next| next.spaced);
            let node = if given {
                self.next += 1;
                Node::Operator("|".to_owned())
            } else {
                self.node()?
            };
            let end = self.tokens[self.next - 1].at.end;
            items.push(Item { node, spaced, at: start..end });
        }
        derivatives(&mut items);
        Ok(items)
    }

    /// The next token with all that belongs to it.
    fn node(&mut self) -> Result<Node> {
        let token = self.take()?;
        let text = token.text.clone();
        Ok(match token.kind {
            Kind::Operator => Node::Operator(text),
            Kind::Slash => Node::Slash,
            Kind::Punctuation => Node::Punctuation(text),
            Kind::Big => self.limits(Node::Big(text))?,
            Kind::Differential => {
                let of = self.take()?;
                let of = self.operand(&of)?;
                Node::Differential(text, Box::new(of))
            }
            Kind::Function => {
                let function = self.scripts(Node::Function(text.clone()))?;
                if matches!(text.as_str(), "min" | "max") && self.is_next(Kind::Word, "over") {
                    self.limits(function)?
                } else {
                    self.applied(function, true)?
                }
            }
            _ => {
                let differential = token.kind == Kind::Letter && text == "d";
                let named = matches!(token.kind, Kind::Letter | Kind::Word | Kind::Number);
                let operand = self.operand(&token)?;
                if named { self.applied(operand, differential)? } else { operand }
            }
        })
    }

    fn take(&mut self) -> Result<Token> {
        let token = self
            .peek()
            .cloned()
            .with_context(|| format!("something is missing at the end of {:?}", self.formula))?;
        self.next += 1;
        Ok(token)
    }

    /// A letter, number, word, bracket or root with its scripts.
    fn operand(&mut self, token: &Token) -> Result<Node> {
        let text = token.text.clone();
        let node = match token.kind {
            Kind::Letter => Node::Letter(text),
            Kind::Number => Node::Number(text),
            Kind::Word => Node::Word(text),
            Kind::Code => Node::Code(text),
            Kind::Open | Kind::Bar => self.group(token)?,
            Kind::Root => {
                let of = self.take()?;
                match self.bare(&of)? {
                    Node::Group(Bracket::Round, items) => Node::Root(items),
                    other => Node::Root(vec![Item { node: other, spaced: false, at: of.at }]),
                }
            }
            _ => bail!("{:?} cannot stand there in {:?}", token.text, self.formula),
        };
        self.scripts(node)
    }

    /// An operand without scripts.
    fn bare(&mut self, token: &Token) -> Result<Node> {
        match token.kind {
            Kind::Open | Kind::Bar => self.group(token),
            Kind::Letter => Ok(Node::Letter(token.text.clone())),
            Kind::Number => Ok(Node::Number(token.text.clone())),
            _ => bail!(
                "a root of {:?} in {:?}: it needs a letter, a number or a bracket",
                token.text,
                self.formula
            ),
        }
    }

    fn group(&mut self, open: &Token) -> Result<Node> {
        let bracket = Bracket::opened_by(&open.text);
        let (_, close) = bracket.signs();
        let (stop, kind) =
            if bracket == Bracket::Bar { (Stop::Bar, Kind::Bar) } else { (Stop::Close, Kind::Close) };
        let items = self.sequence(stop)?;
        if !self.is_next(kind, close) {
            bail!("{:?} is not closed in {:?}", open.text, &self.formula[open.at.start..]);
        }
        self.next += 1;
        let rows = items.iter().any(|item| item.node == Node::Punctuation(";".to_owned()));
        if bracket == Bracket::Square && rows {
            let row = |items: &[Item]| {
                items
                    .split(|item| item.node == Node::Punctuation(",".to_owned()))
                    .map(<[Item]>::to_vec)
                    .collect()
            };
            let rows = items.split(|item| item.node == Node::Punctuation(";".to_owned())).map(row).collect();
            return Ok(Node::Matrix(rows));
        }
        Ok(Node::Group(bracket, items))
    }

    /// Subscripts and superscripts behind an operand.
    fn scripts(&mut self, base: Node) -> Result<Node> {
        let mut scripts = Vec::new();
        while self.touches(Kind::Lower) || self.touches(Kind::Raise) {
            let token = self.take()?;
            let content = if token.text.is_empty() {
                let open = self.take()?;
                match self.group(&open)? {
                    Node::Group(_, items) => items,
                    matrix => vec![Item { node: matrix, spaced: false, at: open.at }],
                }
            } else {
                indices(&token.text, token.at.clone())
            };
            scripts.push(Script { raised: token.kind == Kind::Raise, content });
        }
        Ok(if scripts.is_empty() { base } else { Node::Scripts(Box::new(base), scripts) })
    }

    /// A name with the bracket that follows it without a space; bars are brackets of some.
    fn applied(&mut self, name: Node, bars: bool) -> Result<Node> {
        if !(self.touches(Kind::Open) || bars && !self.in_bars && self.touches(Kind::Bar)) {
            return Ok(name);
        }
        let open = self.take()?;
        let argument = self.operand(&open)?;
        Ok(Node::Applied(Box::new(name), Box::new(argument)))
    }

    /// "over j of", "from 0 to θ of" or "of" behind a sum, an integral or a largest value.
    fn limits(&mut self, big: Node) -> Result<Node> {
        let mut above = Vec::new();
        let below = if self.is_next(Kind::Word, "over") && self.comes("of") {
            self.next += 1;
            self.sequence(Stop::Word("of"))?
        } else if self.is_next(Kind::Word, "from") && self.comes("to") && self.comes("of") {
            self.next += 1;
            let below = self.sequence(Stop::Word("to"))?;
            self.next += 1;
            above = self.sequence(Stop::Word("of"))?;
            below
        } else {
            self.next += usize::from(self.is_next(Kind::Word, "of"));
            return Ok(big);
        };
        self.next += 1;
        Ok(Node::Limits(Box::new(big), below, above))
    }

    /// Whether this word follows before the bracket closes.
    fn comes(&self, word: &str) -> bool {
        let mut depth = 0;
        for token in &self.tokens[self.next..] {
            match token.kind {
                Kind::Open => depth += 1,
                Kind::Close if depth == 0 => return false,
                Kind::Close => depth -= 1,
                Kind::Word if depth == 0 && token.text == word => return true,
                _ => {}
            }
        }
        false
    }
}

/// The d above a derivative's line, as in `d(V W)/dp` and `d f_n/dp`, is upright like the one below.
fn derivatives(items: &mut [Item]) {
    fn leading(node: &mut Node) -> Option<&mut Node> {
        match node {
            Node::Letter(letter) if letter == "d" => Some(node),
            Node::Scripts(base, _) | Node::Applied(base, _) => leading(base),
            _ => None,
        }
    }
    for slash in 1..items.len().saturating_sub(1) {
        let below = &items[slash + 1].node;
        if items[slash].node != Node::Slash || !matches!(below, Node::Differential(..)) {
            continue;
        }
        let mut first = slash - 1;
        while first > 0 && !items[first].spaced && items[first - 1].node.is_operand() {
            first -= 1;
        }
        let apart = first > 0 && items[first - 1].node == Node::Letter("d".to_owned());
        if let Some(letter) = leading(&mut items[if apart { first - 1 } else { first }].node) {
            *letter = Node::Upright("d".to_owned());
        }
    }
}

/// What stands after `_` without a bracket: `top,i` is a word and an index, `ij` two indices, `2` a number.
fn indices(text: &str, at: Range<usize>) -> Vec<Item> {
    let mut nodes = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let digits = first.is_ascii_digit();
        let letters = first.is_alphabetic() && first != 'ᵀ';
        let same = |c: char| {
            if digits { c.is_ascii_digit() || c == '.' } else { letters && c.is_alphabetic() && c != 'ᵀ' }
        };
        let length = rest.find(|c| !same(c)).unwrap_or(rest.len()).max(first.len_utf8());
        let (run, after) = rest.split_at(length);
        rest = after;
        match first {
            _ if digits => nodes.push(Node::Number(run.to_owned())),
            'ᵀ' => nodes.push(Node::Upright("T".to_owned())),
            _ if letters && is_name(run) => nodes.push(Node::Word(run.to_owned())),
            _ if letters => nodes.extend(run.chars().map(|c| Node::Letter(c.to_string()))),
            ',' => nodes.push(Node::Punctuation(run.to_owned())),
            _ => nodes.push(Node::Operator(run.to_owned())),
        }
    }
    nodes.into_iter().map(|node| Item { node, spaced: false, at: at.clone() }).collect()
}

/// Whether letters in a script are a word and not indices one by one.
fn is_name(run: &str) -> bool {
    let vowel = run.contains(['a', 'e', 'i', 'o', 'u']);
    let capitals = run.chars().all(|c| c.is_ascii_uppercase());
    let long = run.len() > 3 || run.len() == 3 && vowel;
    run.is_ascii() && run.len() > 1 && (capitals || ["up", "to"].contains(&run) || long)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_named() {
        let said = |formula| expression(formula).unwrap_err().to_string();
        assert!(said("a (b + c").contains("\"(\" is not closed in \"(b + c\""));
        assert!(said("a b)").contains("\")\" closes nothing"));
        assert!(said("a # b").contains("'#' has no meaning"));
        assert!(said("ab + c").contains("\"ab\" is neither a word nor a function"));
        assert!(said("a + _b").contains("\"_b\" has nothing before it"));
        assert!(said("x_").contains("nothing follows"));
        assert!(said("√").contains("something is missing at the end"));
        assert!(said("√ + 1").contains("a root of \"+\""));
        assert!(said("|a").contains("is not closed"));
        assert!(said("`key").contains("is not closed"));
    }
}
