//! The words of the book's plain notation: a formula as text to its tokens.

use anyhow::{Result, bail};
use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `0.42`
    Number,
    /// One letter, perhaps with an accent.
    Letter,
    /// Text, or a quantity that is named by a word.
    Word,
    /// `sin`: upright, with an argument.
    Function,
    /// The d of `dθ`, the ∂ of `∂S`: what follows without a space belongs to it.
    Differential,
    /// Sum, product or integral.
    Big,
    /// `√` or `sqrt`.
    Root,
    /// An opening bracket.
    Open,
    /// A closing bracket.
    Close,
    /// `|`, which opens or closes.
    Bar,
    /// `+`, `=`, `·`, ...
    Operator,
    /// `/`
    Slash,
    /// `,`, `;` or `:`.
    Punctuation,
    /// A subscript; where its text is empty the bracket that follows holds it.
    Lower,
    /// A superscript; where its text is empty the bracket that follows holds it.
    Raise,
    /// What stands between backticks.
    Code,
}

/// One token with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: Kind,
    /// Its text as it is set, not always as it is written: `''` is `″`.
    pub text: String,
    /// Whether a space stands before it.
    pub spaced: bool,
    /// Its bytes in the formula.
    pub at: Range<usize>,
}

const FUNCTIONS: [&str; 25] = [
    "sin", "cos", "tan", "cot", "asin", "acos", "atan", "arcsin", "arccos", "arctan", "exp", "ln", "log",
    "min", "max", "Re", "Im", "conj", "tr", "ceil", "lim", "arg", "lcm", "diag", "var",
];
const BIG: [(&str, &str); 3] = [("SUM", "Σ"), ("PRODUCT", "Π"), ("INTEGRAL", "∫")];
/// Words of two letters; any other two letters are a mistake, so that no product is set as a word.
const SHORT_WORDS: [&str; 19] = [
    "mm", "of", "at", "on", "in", "to", "is", "or", "it", "by", "up", "no", "if", "so", "as", "an", "TF",
    "GY", "kg",
];
/// What follows the letter a where it is a name and no article.
const NO_NOUNS: [&str; 12] =
    ["of", "and", "or", "from", "to", "at", "is", "in", "on", "with", "forward", "by"];
const OPERATORS: &str = "=<>≤≥+−-±∓·×∈∋∪∩→";
/// Operators of two characters that are set as one or as they are.
const PAIRS: [(&str, &str); 7] =
    [("<=", "≤"), (">=", "≥"), ("->", "→"), ("+=", "+="), ("−=", "−="), ("-=", "−="), ("..", "…")];
/// Raised and lowered characters and what they stand for.
const RAISED: [(char, &str); 19] = [
    ('⁰', "0"),
    ('¹', "1"),
    ('²', "2"),
    ('³', "3"),
    ('⁴', "4"),
    ('⁵', "5"),
    ('⁶', "6"),
    ('⁷', "7"),
    ('⁸', "8"),
    ('⁹', "9"),
    ('⁺', "+"),
    ('⁻', "−"),
    ('ⁿ', "n"),
    ('ᵀ', "ᵀ"),
    ('ᵏ', "k"),
    ('ᵖ', "p"),
    ('ᴴ', "H"),
    ('′', "′"),
    ('″', "″"),
];
const LOWERED: [(char, &str); 18] = [
    ('₀', "0"),
    ('₁', "1"),
    ('₂', "2"),
    ('₃', "3"),
    ('₄', "4"),
    ('₅', "5"),
    ('₆', "6"),
    ('₇', "7"),
    ('₈', "8"),
    ('₉', "9"),
    ('₊', "+"),
    ('₋', "−"),
    ('ₙ', "n"),
    ('ₘ', "m"),
    ('ₖ', "k"),
    ('ₚ', "p"),
    ('ᵢ', "i"),
    ('ⱼ', "j"),
];
/// Letters with an accent in one character, and the two that they are made of.
const ACCENTED: [(char, &str); 12] = [
    ('ẅ', "w\u{308}"),
    ('ẍ', "x\u{308}"),
    ('ÿ', "y\u{308}"),
    ('ẇ', "w\u{307}"),
    ('Ẇ', "W\u{307}"),
    ('ẋ', "x\u{307}"),
    ('ẏ', "y\u{307}"),
    ('ṁ', "m\u{307}"),
    ('ṡ', "s\u{307}"),
    ('ḋ', "d\u{307}"),
    ('ė', "e\u{307}"),
    ('ż', "z\u{307}"),
];

/// The other side of a table of characters.
fn found(table: &[(char, &'static str)], c: char) -> Option<&'static str> {
    table.iter().find(|(from, _)| *from == c).map(|(_, to)| *to)
}

/// Letters of names: Latin and Greek without the signs of sums.
fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic()
        || (matches!(c, 'α'..='ω' | 'Α'..='Ω') && c != 'Σ')
        || found(&ACCENTED, c).is_some()
}

/// Marks that stand over the letter before them.
pub fn is_accent(c: char) -> bool {
    matches!(c, '\u{304}' | '\u{307}' | '\u{308}')
}

/// All tokens of a formula.
pub fn tokens(formula: &str) -> Result<Vec<Token>> {
    let mut reader = Reader { text: formula, position: 0, spaced: false, tokens: Vec::new() };
    while let Some(c) = reader.peek() {
        if c == ' ' {
            reader.position += 1;
            reader.spaced = true;
        } else {
            reader.token(c)?;
        }
    }
    articles(&mut reader.tokens);
    Ok(reader.tokens)
}

/// `a` before a noun is a word: "over a period", not "share of a".
fn articles(tokens: &mut [Token]) {
    for index in 0..tokens.len() {
        let noun = tokens.get(index + 1).is_some_and(|next| {
            next.kind == Kind::Word && next.spaced && !NO_NOUNS.contains(&next.text.as_str())
        });
        let after = index.checked_sub(1).is_none_or(|before| tokens[before].kind == Kind::Word);
        if noun && after && tokens[index].kind == Kind::Letter && tokens[index].text == "a" {
            tokens[index].kind = Kind::Word;
        }
    }
}

struct Reader<'a> {
    text: &'a str,
    position: usize,
    spaced: bool,
    tokens: Vec<Token>,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        &self.text[self.position..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Takes characters as long as they fit.
    fn take(&mut self, fits: impl Fn(char) -> bool) -> String {
        let taken: String = self.rest().chars().take_while(|c| fits(*c)).collect();
        self.position += taken.len();
        taken
    }

    /// A token that began at `start` and ends here.
    fn push(&mut self, kind: Kind, text: impl Into<String>, start: usize) {
        let spaced = std::mem::take(&mut self.spaced);
        self.tokens.push(Token { kind, text: text.into(), spaced, at: start..self.position });
    }

    /// A token of the next `length` bytes.
    fn single(&mut self, kind: Kind, text: impl Into<String>, length: usize) {
        let start = self.position;
        self.position += length;
        self.push(kind, text, start);
    }

    /// Whether the token before ends here and can carry a script.
    fn follows_operand(&self) -> bool {
        !self.spaced
            && self.tokens.last().is_some_and(|last| {
                !matches!(
                    last.kind,
                    Kind::Open | Kind::Operator | Kind::Slash | Kind::Punctuation | Kind::Big | Kind::Root
                )
            })
    }

    fn token(&mut self, c: char) -> Result<()> {
        let start = self.position;
        if let Some((written, set)) = PAIRS.iter().find(|(written, _)| self.rest().starts_with(written)) {
            self.single(if *set == "…" { Kind::Letter } else { Kind::Operator }, *set, written.len());
            return Ok(());
        }
        match c {
            '0'..='9' => self.number(),
            '_' => self.script(Kind::Lower)?,
            '^' => self.script(Kind::Raise)?,
            '\'' if self.follows_operand() => {
                let ticks = self.take(|c| c == '\'').len();
                self.push(Kind::Raise, if ticks == 1 { "′" } else { "″" }, start);
            }
            '*' if self.follows_operand() => self.single(Kind::Raise, "*", 1),
            '×' if self.follows_operand() && self.tokens.last().is_some_and(|last| last.text == "]") => {
                self.single(Kind::Lower, "×", c.len_utf8());
            }
            '(' | '[' | '{' => self.single(Kind::Open, c, 1),
            ')' | ']' | '}' => self.single(Kind::Close, c, 1),
            '|' => self.single(Kind::Bar, c, 1),
            '/' => self.single(Kind::Slash, c, 1),
            ',' | ';' | ':' => self.single(Kind::Punctuation, c, 1),
            '½' => self.single(Kind::Number, c, c.len_utf8()),
            '…' | '∇' => self.single(Kind::Letter, c, c.len_utf8()),
            '∂' => {
                let attached =
                    self.rest()[c.len_utf8()..].starts_with(|c| is_letter(c) || c == '(' || c == '|');
                self.single(if attached { Kind::Differential } else { Kind::Letter }, c, c.len_utf8());
            }
            '√' => self.single(Kind::Root, c, c.len_utf8()),
            'Σ' | '∫' | '∬' | '∮' => self.single(Kind::Big, c, c.len_utf8()),
            '°' | '%' => self.single(Kind::Word, c, c.len_utf8()),
            '`' => {
                let Some(end) = self.rest()[1..].find('`') else {
                    bail!("the ` before {:?} is not closed", self.rest())
                };
                let code = self.rest()[1..=end].to_owned();
                self.single(Kind::Code, code, end + 2);
            }
            // "ψ-rate"
            '-' if self.follows_operand()
                && self.rest()[1..].bytes().take(2).all(|b| b.is_ascii_lowercase()) =>
            {
                self.position += 1;
                let word = self.take(|c| c.is_ascii_lowercase());
                self.push(Kind::Word, format!("-{word}"), start);
            }
            '-' => self.single(Kind::Operator, "−", 1),
            _ if OPERATORS.contains(c) => self.single(Kind::Operator, c, c.len_utf8()),
            _ if found(&RAISED, c).is_some() => self.written(&RAISED, Kind::Raise),
            _ if found(&LOWERED, c).is_some() => self.written(&LOWERED, Kind::Lower),
            _ if is_letter(c) => self.letters()?,
            _ => bail!("the character {c:?} has no meaning in a formula"),
        }
        Ok(())
    }

    fn number(&mut self) {
        let start = self.position;
        let mut number = self.take(|c| c.is_ascii_digit());
        let mut decimals = self.rest().chars();
        if decimals.next() == Some('.') && decimals.next().is_some_and(|c| c.is_ascii_digit()) {
            self.position += 1;
            number = format!("{number}.{}", self.take(|c| c.is_ascii_digit()));
        }
        // `A2` is a name with an index.
        let index = !self.spaced && self.tokens.last().is_some_and(|last| last.kind == Kind::Letter);
        self.push(if index { Kind::Lower } else { Kind::Number }, number, start);
    }

    /// `²` and its like, one after the other.
    fn written(&mut self, table: &'static [(char, &'static str)], kind: Kind) {
        let start = self.position;
        let text: String =
            self.take(|c| found(table, c).is_some()).chars().filter_map(|c| found(table, c)).collect();
        self.push(kind, text, start);
    }

    /// What `_` or `^` puts up or down: a bracket, or all that follows without a space.
    fn script(&mut self, kind: Kind) -> Result<()> {
        let start = self.position;
        if !self.follows_operand() {
            bail!("{:?} has nothing before it that it belongs to", self.rest());
        }
        self.position += 1;
        if self.rest().starts_with(['{', '(']) {
            self.push(kind, "", start);
            return Ok(());
        }
        let sign = self.rest().starts_with(['+', '−', '-']);
        let mut text = String::new();
        if sign {
            text = self.take(|c| matches!(c, '+' | '−' | '-')).replace('-', "−");
        }
        loop {
            text += &self.take(|c| c.is_ascii_digit() || is_letter(c));
            let mut next = self.rest().chars();
            let (point, after) = (next.next(), next.next().unwrap_or(' '));
            let goes_on = match point {
                Some('.') => after.is_ascii_digit(),
                Some(',') => kind == Kind::Lower && (after.is_ascii_digit() || is_letter(after)),
                _ => false,
            };
            if !goes_on {
                break;
            }
            text.extend(point);
            self.position += 1;
        }
        if text.is_empty() {
            bail!("nothing follows the mark in {:?}", &self.text[start..]);
        }
        self.push(kind, text, start);
        Ok(())
    }

    /// A run of letters: a word, a function, a differential, or letters one by one.
    fn letters(&mut self) -> Result<()> {
        let start = self.position;
        let run = self.take(|c| is_letter(c) || is_accent(c));
        let plain = run.bytes().all(|b| b.is_ascii_alphabetic());
        let count = run.chars().filter(|c| !is_accent(*c)).count();
        if plain && count > 1 {
            if let Some((_, symbol)) = BIG.iter().find(|(word, _)| *word == run) {
                self.push(Kind::Big, *symbol, start);
                return Ok(());
            }
            if run == "sqrt" {
                self.push(Kind::Root, "√", start);
                return Ok(());
            }
            if FUNCTIONS.contains(&run.as_str()) {
                self.push(Kind::Function, run, start);
                return Ok(());
            }
            let product = count == 2 && run.starts_with(['d', 'i']) && !SHORT_WORDS.contains(&run.as_str());
            if !product {
                return self.word(run, start);
            }
        }
        self.one_by_one(&run, start);
        Ok(())
    }

    /// A word with its apostrophes and hyphens.
    fn word(&mut self, first: String, start: usize) -> Result<()> {
        let mut word = first;
        loop {
            let mut next = self.rest().chars();
            let (joint, after) = (next.next(), next.next());
            if !matches!(joint, Some('\'' | '-')) || !after.is_some_and(|c| c.is_ascii_alphabetic()) {
                break;
            }
            word.extend(joint);
            self.position += 1;
            word += &self.take(|c| c.is_ascii_alphabetic());
        }
        if word.len() == 2 && !SHORT_WORDS.contains(&word.as_str()) {
            bail!(
                "{word:?} is neither a word nor a function: letters that are multiplied have a space between them"
            );
        }
        // The apostrophe of "axis' point" is no derivative.
        let mut next = self.rest().chars();
        if next.next() == Some('\'')
            && next.next() == Some(' ')
            && next.next().is_some_and(|c| c.is_ascii_lowercase())
            && next.next().is_some_and(|c| c.is_ascii_lowercase())
        {
            word.push('\'');
            self.position += 1;
        }
        self.push(Kind::Word, word, start);
        Ok(())
    }

    /// `nω`, `dθ`, `ẅ`: each letter for itself, the d of two a differential.
    fn one_by_one(&mut self, run: &str, start: usize) {
        let end = self.position;
        let mut letters: Vec<(usize, String)> = Vec::new();
        for (offset, c) in run.char_indices() {
            match letters.last_mut() {
                Some((_, last)) if is_accent(c) => last.push(c),
                _ => letters.push((start + offset, found(&ACCENTED, c).map_or(c.to_string(), str::to_owned))),
            }
        }
        let differential = letters.len() == 2 && letters[0].1 == "d";
        let ends: Vec<usize> = letters.iter().skip(1).map(|(at, _)| *at).chain([end]).collect();
        for (index, ((from, letter), to)) in letters.into_iter().zip(ends).enumerate() {
            self.position = to;
            let kind = if differential && index == 0 { Kind::Differential } else { Kind::Letter };
            self.push(kind, letter, from);
        }
    }
}
