//! The text as a tree of typed values: TOML syntax, known keys, kinds, units. What the values mean together is for
//! [`read`](crate::read).

use crate::diagnostic::{Mistake, Mistakes};
use crate::nearest::nearest;
use crate::quantity::{self, Dimension, Refusal};
use crate::ratio::Ratio;
use crate::schema::{Bound, FILE, Key, Kind, Table};
use std::cell::Cell;
use std::ops::Range;
use toml_spanner::{Item, TableStyle, Value as Toml};

/// Bytes of the longest file that is read.
const LONGEST_FILE: usize = 4 * 1024 * 1024;
/// Longest list of values.
const LONGEST_LIST: usize = 256;
/// Largest numerator and denominator of a speed ratio: periods stay short and orders few.
const LARGEST_NUMERATOR: i64 = 64;
const LARGEST_DENOMINATOR: i64 = 64;

/// Place in the text [bytes].
pub(crate) type Span = Range<usize>;

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spot<T> {
    pub(crate) value: T,
    pub(crate) span: Span,
}

/// What a key of a table says.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Field<T> {
    /// The key is not there.
    Absent,
    /// It is there, and its mistake is already reported.
    Bad,
    Given(Spot<T>),
}

impl<T> Field<T> {
    /// The value; `default` if the key is not there; `None` if it is bad.
    pub(crate) fn or(self, default: T) -> Option<T> {
        match self {
            Field::Absent => Some(default),
            Field::Bad => None,
            Field::Given(spot) => Some(spot.value),
        }
    }

    /// The value, if there is a good one.
    pub(crate) fn given(self) -> Option<T> {
        match self {
            Field::Given(spot) => Some(spot.value),
            _ => None,
        }
    }

    pub(crate) fn is_bad(&self) -> bool {
        matches!(self, Field::Bad)
    }
}

/// A table of the file.
#[derive(Debug)]
pub(crate) struct Section {
    table: &'static Table,
    /// Its header, or the whole of an inline table.
    pub(crate) span: Span,
    entries: Vec<Entry>,
}

#[derive(Debug)]
struct Entry {
    key: &'static Key,
    key_span: Span,
    span: Span,
    value: Value,
    used: Cell<bool>,
}

#[derive(Debug)]
enum Value {
    Bad,
    Text(String),
    Word(&'static str),
    Whole(i64),
    Number(f64),
    Ratio(Ratio),
    Wholes(Vec<Spot<i64>>),
    Numbers(Vec<Spot<f64>>),
    Table(Section),
    Tables(Vec<Section>),
}

/// The file as a tree, and whether its syntax is whole: if not, nothing can be called missing.
#[derive(Debug)]
pub(crate) struct Document {
    pub(crate) root: Section,
    pub(crate) whole: bool,
}

/// Parses the text. Mistakes of syntax, keys, kinds and units are added to `mistakes`.
pub(crate) fn parse(text: &str, mistakes: &mut Mistakes) -> Document {
    let empty = || Section { table: &FILE, span: 0..0, entries: Vec::new() };
    if text.len() > LONGEST_FILE {
        let message = format!(
            "the file has {} bytes, more than the {LONGEST_FILE} that an engine file may have",
            text.len()
        );
        mistakes.push(Mistake::error("E0003", 0..0, message).hint("check that this is an engine file"));
        return Document { root: empty(), whole: false };
    }
    let arena = toml_spanner::Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    for error in document.errors() {
        mistakes.push(syntax_mistake(error, text));
    }
    let whole = document.errors().is_empty();
    // Keys below a header that cannot be read end up in the root: they are not its own.
    let foreign_from = document
        .errors()
        .iter()
        .map(|error| error.span().start as usize)
        .filter(|at| line_of(text, *at).trim_start().starts_with('['))
        .min()
        .unwrap_or(usize::MAX);
    let mut walk = Walk { text, mistakes, foreign_from };
    let root = walk.section(&FILE, document.table(), 0..0);
    Document { root, whole }
}

fn line_of(text: &str, at: usize) -> &str {
    let at = text.floor_char_boundary(at.min(text.len()));
    let start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    text[start..].lines().next().unwrap_or("").trim_start_matches('\u{feff}')
}

/// The first line of the span, to its end.
fn line_from(text: &str, span: Span) -> &str {
    text.get(span).and_then(|text| text.lines().next()).unwrap_or("")
}

/// What stands behind the `=` of the line, if it is a bare text or a bare number with a unit.
fn unquoted_value(text: &str, at: usize) -> Option<&str> {
    let (_, value) = line_of(text, at).split_once('=')?;
    let value = value.split('#').next().unwrap_or("").trim();
    let is_bare = value.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '-' || c == '+' || c == '.');
    (is_bare && value.len() < 60 && !value.contains('"')).then_some(value)
}

fn syntax_mistake(error: &toml_spanner::Error, text: &str) -> Mistake {
    use toml_spanner::ErrorKind;
    let kind = error.kind();
    let code = match kind {
        ErrorKind::DuplicateKey { .. } | ErrorKind::DuplicateTable { .. } => "E0002",
        _ => "E0001",
    };
    let span = error.span().range();
    let message = match kind {
        ErrorKind::DuplicateKey { .. } => {
            format!("the key `{}` stands twice in one table", text.get(span.clone()).unwrap_or(""))
        }
        ErrorKind::DuplicateTable { name, .. } => {
            format!("the table `{}` stands twice", text.get(name.range()).unwrap_or(""))
        }
        ErrorKind::OutOfRange { .. } => "too deeply nested".to_string(),
        _ => error.message(text),
    };
    let mut mistake = Mistake::error(code, span, message);
    if let Some((_, label)) = error.primary_label() {
        mistake = mistake.label(label);
    }
    if let Some((span, label)) = error.secondary_label() {
        let first_line = span.range().start..span.range().start + line_from(text, span.range()).len();
        mistake = mistake.related(first_line, label);
    }
    match kind {
        ErrorKind::DuplicateKey { .. } => mistake.hint("keep one of the two"),
        ErrorKind::DuplicateTable { .. } => {
            mistake.hint("write its keys under one header; tables that may repeat have [[two brackets]]")
        }
        ErrorKind::UnquotedString | ErrorKind::Wanted { .. } | ErrorKind::InvalidInteger(_) => {
            match unquoted_value(text, error.span().start as usize) {
                Some(value) => mistake.hint(format!("write texts and quantities in quotes: \"{value}\"")),
                None => mistake,
            }
        }
        ErrorKind::UnterminatedString(_) => {
            mistake.hint("close the text with the same quote on the same line")
        }
        _ => mistake,
    }
}

/// The table whose header names the key: itself, or the first of its list. `None` for a value.
fn header_of<'a, 'de>(item: &'a Item<'de>) -> Option<&'a Item<'de>> {
    match (item.as_table(), item.as_array()) {
        (Some(table), _) => {
            matches!(table.style(), TableStyle::Header | TableStyle::Implicit).then_some(item)
        }
        (_, Some(array)) if array.style() == toml_spanner::ArrayStyle::Header => array.get(0),
        _ => None,
    }
}

struct Walk<'a> {
    text: &'a str,
    mistakes: &'a mut Mistakes,
    foreign_from: usize,
}

impl Walk<'_> {
    fn section(&mut self, table: &'static Table, toml: &toml_spanner::Table<'_>, span: Span) -> Section {
        let is_root = table.header.is_empty();
        let mut entries: Vec<Entry> = Vec::new();
        let mut unknown = Vec::new();
        for (key, item) in toml {
            let mut key_span = key.span.range();
            let header = header_of(item);
            if is_root && header.is_none() && key_span.start >= self.foreign_from {
                continue;
            }
            let Some(known) = table.key(key.name) else {
                unknown.push((key.name, key_span));
                continue;
            };
            if let Some(header) = header {
                key_span = self.item_span(header, &key_span);
            }
            let value = self.value(known, item, &key_span).unwrap_or(Value::Bad);
            let span = self.item_span(item, &key_span);
            entries.push(Entry { key: known, key_span, span, value, used: Cell::new(false) });
        }
        for (name, span) in unknown {
            // A misspelled key stands for the one that was meant: nobody shall call that one missing.
            if let Some(meant) = self.unknown_key(table, name, span.clone())
                && !entries.iter().any(|entry| entry.key.name == meant.name)
            {
                let (key_span, used) = (span.clone(), Cell::new(false));
                entries.push(Entry { key: meant, key_span, span, value: Value::Bad, used });
            }
        }
        Section { table, span, entries }
    }

    /// Reports the key; gives the key that was probably meant.
    fn unknown_key(&mut self, table: &'static Table, name: &str, span: Span) -> Option<&'static Key> {
        let shown: String = name.chars().take(60).collect();
        let mut mistake =
            Mistake::error("E0201", span, format!("unknown key `{shown}` in {}", table.title()))
                .label("unknown key");
        if self.mistakes.crowded() {
            self.mistakes.push(mistake);
            return None;
        }
        let near = nearest(name, table.keys.iter().map(|key| key.name));
        let elsewhere: Vec<&str> = FILE
            .all()
            .into_iter()
            .filter(|other| !std::ptr::eq(*other, table) && other.key(name).is_some())
            .map(Table::title)
            .collect();
        mistake = if let Some(near) = near {
            mistake.hint(format!("did you mean `{near}`?"))
        } else if !elsewhere.is_empty() {
            mistake.hint(format!("`{name}` is a key of {}", quantity::one_of(elsewhere.into_iter())))
        } else {
            let keys: Vec<String> = table.keys.iter().map(|key| format!("`{}`", key.name)).collect();
            mistake.hint(format!(
                "{} knows {}",
                table.title(),
                quantity::one_of(keys.iter().map(String::as_str)).replace(" or ", " and ")
            ))
        };
        self.mistakes.push(mistake);
        near.and_then(|near| table.key(near))
    }

    /// Header of a table with one, the value else.
    fn item_span(&self, item: &Item<'_>, key_span: &Span) -> Span {
        let span = item.span().range();
        match item.as_table().map(toml_spanner::Table::style) {
            Some(TableStyle::Header) => {
                let line = line_of(self.text, span.start);
                let header = line.split('#').next().unwrap_or("").trim_end();
                let start = self.text[..span.start].rfind('\n').map_or(0, |newline| newline + 1);
                let indent = line.len() - line.trim_start().len();
                if line.trim_start().starts_with('[') && start + indent == span.start {
                    span.start..start + header.len()
                } else {
                    span.start..span.start + 1
                }
            }
            Some(TableStyle::Implicit | TableStyle::Dotted) => key_span.clone(),
            _ if span.is_empty() => key_span.clone(),
            _ => span,
        }
    }

    fn value(&mut self, key: &'static Key, item: &Item<'_>, key_span: &Span) -> Option<Value> {
        match (key.kind, item.value()) {
            (Kind::Text(most), Toml::String(text)) => self.text(key, text, item, most),
            (Kind::Choice(words), Toml::String(text)) => self.word(key, text, item, words),
            (Kind::Whole(least, most), Toml::Integer(_)) => {
                self.whole(key, item, least, most).map(|spot| Value::Whole(spot.value))
            }
            (Kind::WholeChoice(choices), Toml::Integer(_)) => self.whole_choice(key, item, choices),
            (Kind::Wholes(least, most), Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.whole(key, item, least, most)).map(Value::Wholes)
            }
            (
                Kind::Quantity(dimension, bound) | Kind::QuantityOrPair(dimension, bound),
                Toml::String(_) | Toml::Integer(_) | Toml::Float(_),
            ) => {
                let spot = self.quantity(key, item, dimension, bound)?;
                Some(if matches!(key.kind, Kind::Quantity(..)) {
                    Value::Number(spot.value)
                } else {
                    Value::Numbers(vec![spot])
                })
            }
            (Kind::Quantities(dimension, bound) | Kind::QuantityOrPair(dimension, bound), Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.quantity(key, item, dimension, bound))
                    .map(Value::Numbers)
            }
            (Kind::Share, Toml::String(_)) => self
                .quantity(key, item, Dimension::Share, Bound::NotNegative)
                .map(|spot| Value::Number(spot.value)),
            (Kind::Share, Toml::Integer(_) | Toml::Float(_)) => self.bare_share(key, item),
            (Kind::Ratio, Toml::Integer(_) | Toml::Float(_) | Toml::String(_)) => self.ratio(key, item),
            (Kind::Table(table), Toml::Table(toml)) => {
                let span = self.item_span(item, key_span);
                Some(Value::Table(self.section(table, toml, span)))
            }
            (Kind::Tables(table, most), Toml::Array(array)) => self.tables(key, table, most, array, item),
            _ => {
                self.wrong_kind(key, item, key_span);
                None
            }
        }
    }

    fn wrong_kind(&mut self, key: &Key, item: &Item<'_>, key_span: &Span) {
        let got = match item.value() {
            Toml::String(_) => "a text",
            Toml::Integer(_) => "a whole number",
            Toml::Float(_) => "a number",
            Toml::Boolean(_) => "true or false",
            Toml::Array(_) => "a list",
            Toml::Table(_) => "a table",
            Toml::DateTime(_) => "a date or time",
        };
        let hint = match (key.kind, item.value()) {
            (Kind::Tables(table, _), Toml::Table(_)) if table.header.starts_with("[[") => {
                format!("write the header with two brackets: {}", table.header)
            }
            (Kind::Table(table), Toml::Array(_)) => {
                format!("write the header with one bracket: {}", table.header)
            }
            (Kind::Whole(..) | Kind::WholeChoice(_), Toml::String(_)) => {
                format!("write it without quotes, such as {} = {}", key.name, key.example)
            }
            (Kind::Text(_) | Kind::Choice(_), Toml::Integer(_) | Toml::Float(_)) => {
                format!("write it in quotes, such as {} = {}", key.name, key.example)
            }
            _ => format!("for example {} = {}", key.name, key.example),
        };
        let mut span = item.span().range();
        if matches!(item.value(), Toml::Table(_) | Toml::Array(_)) {
            span = key_span.clone();
        }
        let message = format!("`{}` needs {}, got {got}", key.name, key.kind.wanted());
        self.mistakes.push(Mistake::error("E0107", span, message).label(got).hint(hint));
    }

    fn text(&mut self, key: &Key, text: &str, item: &Item<'_>, most: usize) -> Option<Value> {
        let span = item.span().range();
        let length = text.chars().count();
        if text.trim().is_empty() {
            self.mistakes.push(
                Mistake::error("E0108", span, format!("`{}` is empty", key.name))
                    .hint(format!("for example {} = {}", key.name, key.example)),
            );
            return None;
        }
        if length > most {
            let message = format!("`{}` has {length} characters, more than {most}", key.name);
            self.mistakes.push(Mistake::error("E0108", span, message).hint("write it shorter"));
            return None;
        }
        Some(Value::Text(text.to_string()))
    }

    fn word(
        &mut self,
        key: &Key,
        text: &str,
        item: &Item<'_>,
        words: &'static [&'static str],
    ) -> Option<Value> {
        if let Some(word) = words.iter().find(|word| **word == text) {
            return Some(Value::Word(word));
        }
        let near = nearest(text, words.iter().copied());
        let all = quantity::one_of(words.iter().copied());
        let shown: String = text.chars().take(60).collect();
        self.mistakes.push(
            Mistake::error("E0109", item.span().range(), format!("`{}` knows no \"{shown}\"", key.name))
                .label("unknown word")
                .hint(match near {
                    Some(near) => format!("did you mean \"{near}\"? it is one of {all}"),
                    None => format!("write one of {all}"),
                }),
        );
        None
    }

    fn whole(&mut self, key: &Key, item: &Item<'_>, least: i64, most: i64) -> Option<Spot<i64>> {
        let span = item.span().range();
        let Some(number) = item.as_i128() else {
            let message = format!("`{}` needs {}", key.name, key.kind.wanted());
            self.mistakes.push(
                Mistake::error("E0107", span, message)
                    .hint(format!("for example {} = {}", key.name, key.example)),
            );
            return None;
        };
        match i64::try_from(number) {
            Ok(value) if (least..=most).contains(&value) => Some(Spot { value, span }),
            _ => {
                let message =
                    format!("`{}` needs a whole number from {least} to {most}, got {number}", key.name);
                self.mistakes.push(Mistake::error("E0108", span, message).label("out of range"));
                None
            }
        }
    }

    fn whole_choice(&mut self, key: &Key, item: &Item<'_>, choices: &'static [i64]) -> Option<Value> {
        let number = item.as_i128()?;
        if let Some(choice) = choices.iter().find(|choice| i128::from(**choice) == number) {
            return Some(Value::Whole(*choice));
        }
        let message = format!("`{}` needs {}, got {number}", key.name, key.kind.wanted());
        self.mistakes.push(Mistake::error("E0108", item.span().range(), message).label("out of range"));
        None
    }

    fn list<T>(
        &mut self,
        key: &Key,
        item: &Item<'_>,
        mut element: impl FnMut(&mut Self, &Item<'_>) -> Option<Spot<T>>,
    ) -> Option<Vec<Spot<T>>> {
        let array = item.as_array()?;
        if array.len() > LONGEST_LIST {
            self.too_many(key, array.len(), LONGEST_LIST, item.span().range());
            return None;
        }
        // All elements are looked at, so that every mistake is told.
        let values: Vec<Option<Spot<T>>> = array.iter().map(|item| element(self, item)).collect();
        values.into_iter().collect()
    }

    fn too_many(&mut self, key: &Key, got: usize, most: usize, span: Span) {
        let message = format!("`{}` has {got} entries, more than the {most} that a file may have", key.name);
        self.mistakes.push(Mistake::error("E0004", span, message));
    }

    fn quantity(
        &mut self,
        key: &Key,
        item: &Item<'_>,
        dimension: Dimension,
        bound: Bound,
    ) -> Option<Spot<f64>> {
        let span = item.span().range();
        let source = self.text.get(span.clone()).unwrap_or("");
        let result = match item.value() {
            Toml::String(text) => quantity::parse(text, dimension, key.name),
            Toml::Float(number) if !number.is_finite() => Err(quantity::not_finite(key.name)),
            Toml::Integer(_) | Toml::Float(_) => Err(quantity::missing_unit(source, dimension, key.name)),
            _ => {
                self.wrong_kind(key, item, &span);
                return None;
            }
        };
        let value = match result {
            Ok(value) => value,
            Err(Refusal { code, message, label, hint }) => {
                self.mistakes.push(Mistake::error(code, span, message).label(label).hint(hint));
                return None;
            }
        };
        let needed = match bound {
            Bound::NotNegative if value < 0.0 => "must not be negative",
            Bound::Positive if value <= 0.0 => "must be more than 0",
            _ => return Some(Spot { value, span }),
        };
        let got = item.as_str().unwrap_or(source).trim();
        let message = format!("`{}` {needed}, got {got}", key.name);
        self.mistakes.push(Mistake::error("E0108", span, message).label("out of range"));
        None
    }

    fn bare_share(&mut self, key: &Key, item: &Item<'_>) -> Option<Value> {
        let span = item.span().range();
        let value = item.as_f64()?;
        if !value.is_finite() || value < 0.0 {
            let message = format!("`{}` needs a share of 0 or more, got {value}", key.name);
            self.mistakes.push(Mistake::error("E0108", span, message).label("out of range"));
            return None;
        }
        Some(Value::Number(value))
    }

    fn ratio(&mut self, key: &Key, item: &Item<'_>) -> Option<Value> {
        let span = item.span().range();
        let parts = match item.value() {
            Toml::Integer(number) => number.as_i64().map(|number| (number, 1)),
            Toml::String(text) => fraction(text),
            _ => None,
        };
        let Some((numerator, denominator)) = parts else {
            let message = format!("`{}` needs {}", key.name, key.kind.wanted());
            let hint = "write a whole number, or a fraction as text: \"1/2\"";
            self.mistakes.push(Mistake::error("E0107", span, message).label("no ratio").hint(hint));
            return None;
        };
        if numerator == 0 || denominator == 0 {
            let message = format!("`{}` must not be 0", key.name);
            let hint =
                "a shaft of ratio 0 stands still: leave it out, or give its speed over that of crankshaft 1";
            self.mistakes.push(Mistake::error("E0110", span, message).label("stands still").hint(hint));
            return None;
        }
        let in_range = numerator.checked_abs().is_some_and(|size| size <= LARGEST_NUMERATOR)
            && (1..=LARGEST_DENOMINATOR).contains(&denominator);
        let ratio = match (i32::try_from(numerator), u32::try_from(denominator)) {
            (Ok(numerator), Ok(denominator)) if in_range => Ratio::new(numerator, denominator),
            _ => None,
        };
        if ratio.is_none() {
            let message = format!(
                "`{}` needs a numerator up to {LARGEST_NUMERATOR} and a denominator from 1 to {LARGEST_DENOMINATOR}, \
                 got {numerator}/{denominator}",
                key.name
            );
            self.mistakes.push(Mistake::error("E0108", span, message).label("out of range"));
        }
        ratio.map(Value::Ratio)
    }

    fn tables(
        &mut self,
        key: &Key,
        table: &'static Table,
        most: usize,
        array: &toml_spanner::Array<'_>,
        item: &Item<'_>,
    ) -> Option<Value> {
        if array.len() > most {
            let span = array
                .get(most)
                .map_or(item.span().range(), |extra| self.item_span(extra, &item.span().range()));
            self.too_many(key, array.len(), most, span);
            return None;
        }
        let mut sections = Vec::new();
        let mut all_good = true;
        for element in array {
            let span = self.item_span(element, &element.span().range());
            match element.as_table() {
                Some(toml) => sections.push(self.section(table, toml, span)),
                None => {
                    let message = format!("`{}` needs a list of tables", key.name);
                    let hint = format!("for example {} = {}", key.name, key.example);
                    self.mistakes.push(Mistake::error("E0107", span, message).label("no table").hint(hint));
                    all_good = false;
                }
            }
        }
        all_good.then_some(Value::Tables(sections))
    }
}

/// `"-3/2"` or `"2"`.
fn fraction(text: &str) -> Option<(i64, i64)> {
    match text.split_once('/') {
        Some((numerator, denominator)) => {
            Some((numerator.trim().parse().ok()?, denominator.trim().parse().ok()?))
        }
        None => Some((text.trim().parse().ok()?, 1)),
    }
}

impl Section {
    /// `[rod]`, for messages.
    pub(crate) fn title(&self) -> &'static str {
        self.table.title()
    }

    /// `name = value` as an example of the key, for hints.
    pub(crate) fn example(&self, name: &str) -> String {
        self.table
            .key(name)
            .map_or(String::new(), |key| format!("for example {} = {}", key.name, key.example))
    }

    /// Whether the key is there, good or bad.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.entry(name).is_some()
    }

    /// Place of the key; the header if it is not there.
    pub(crate) fn key_span(&self, name: &str) -> Span {
        self.entry(name).map_or(self.span.clone(), |entry| entry.key_span.clone())
    }

    /// Place of the value; the header if it is not there.
    pub(crate) fn value_span(&self, name: &str) -> Span {
        self.entry(name).map_or(self.span.clone(), |entry| entry.span.clone())
    }

    pub(crate) fn number(&self, name: &str) -> Field<f64> {
        self.field(name, |value| if let Value::Number(number) = value { Some(*number) } else { None })
    }

    pub(crate) fn numbers(&self, name: &str) -> Field<Vec<Spot<f64>>> {
        self.field(
            name,
            |value| if let Value::Numbers(numbers) = value { Some(numbers.clone()) } else { None },
        )
    }

    pub(crate) fn whole(&self, name: &str) -> Field<i64> {
        self.field(name, |value| if let Value::Whole(number) = value { Some(*number) } else { None })
    }

    pub(crate) fn wholes(&self, name: &str) -> Field<Vec<Spot<i64>>> {
        self.field(
            name,
            |value| if let Value::Wholes(numbers) = value { Some(numbers.clone()) } else { None },
        )
    }

    pub(crate) fn ratio(&self, name: &str) -> Field<Ratio> {
        self.field(name, |value| if let Value::Ratio(ratio) = value { Some(*ratio) } else { None })
    }

    pub(crate) fn word(&self, name: &str) -> Field<&'static str> {
        self.field(name, |value| if let Value::Word(word) = value { Some(*word) } else { None })
    }

    pub(crate) fn text(&self, name: &str) -> Field<String> {
        self.field(name, |value| if let Value::Text(text) = value { Some(text.clone()) } else { None })
    }

    pub(crate) fn table(&self, name: &str) -> Field<&Section> {
        self.field(name, |value| if let Value::Table(section) = value { Some(section) } else { None })
    }

    /// `Absent` is an empty list here.
    pub(crate) fn tables(&self, name: &str) -> Field<&[Section]> {
        self.field(
            name,
            |value| if let Value::Tables(sections) = value { Some(sections.as_slice()) } else { None },
        )
    }

    fn entry(&self, name: &str) -> Option<&Entry> {
        debug_assert!(self.table.key(name).is_some(), "{} has no key {name}", self.title());
        self.entries.iter().find(|entry| entry.key.name == name)
    }

    fn field<'a, T>(&'a self, name: &str, get: impl Fn(&'a Value) -> Option<T>) -> Field<T> {
        let Some(entry) = self.entry(name) else { return Field::Absent };
        entry.used.set(true);
        match get(&entry.value) {
            Some(value) => Field::Given(Spot { value, span: entry.span.clone() }),
            None => Field::Bad,
        }
    }

    /// Keys that nobody asked for, in this table and below: path of keys, place.
    pub(crate) fn unused(&self) -> Vec<(String, Span)> {
        let mut found = Vec::new();
        self.collect_unused("", &mut found);
        found
    }

    fn collect_unused(&self, path: &str, found: &mut Vec<(String, Span)>) {
        for entry in &self.entries {
            let path = if path.is_empty() {
                entry.key.name.to_string()
            } else {
                format!("{path}.{}", entry.key.name)
            };
            match &entry.value {
                _ if !entry.used.get() => found.push((path, entry.key_span.clone())),
                Value::Table(section) => section.collect_unused(&path, found),
                Value::Tables(sections) => {
                    for section in sections {
                        section.collect_unused(&path, found);
                    }
                }
                _ => {}
            }
        }
    }
}
