//! Tables and keys: what the file may hold, and where it stands.

use super::section::{Entry, Section, Span, Value};
use super::syntax::line_of;
use crate::schema::{Bound, Key, Kind, Table};
use lanchester_diagnostic::{Mistake, Mistakes};
use lanchester_units::Dimension;
use lanchester_units::nearest;
use std::cell::Cell;
use toml_spanner::{ArrayStyle, Item, TableStyle, Value as Toml};

/// The table whose header names the key: itself, or the first of its list. `None` for a value.
fn header_of<'a, 'de>(item: &'a Item<'de>) -> Option<&'a Item<'de>> {
    match (item.as_table(), item.as_array()) {
        (Some(table), _) => {
            matches!(table.style(), TableStyle::Header | TableStyle::Implicit).then_some(item)
        }
        (_, Some(array)) if array.style() == ArrayStyle::Header => array.get(0),
        _ => None,
    }
}

/// Walks the TOML tree along the schema.
pub(super) struct Walk<'a> {
    pub(super) text: &'a str,
    /// The root of the schema.
    pub(super) file: &'static Table,
    pub(super) mistakes: &'a mut Mistakes,
    /// Values of the root from this place on stand below a header that cannot be read.
    pub(super) foreign_from: usize,
}

impl Walk<'_> {
    pub(super) fn section(
        &mut self,
        table: &'static Table,
        toml: &toml_spanner::Table<'_>,
        span: Span,
    ) -> Section {
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
        let elsewhere: Vec<&str> = self
            .file
            .all()
            .into_iter()
            .filter(|other| !std::ptr::eq(*other, table) && other.key(name).is_some())
            .map(Table::title)
            .collect();
        mistake = if let Some(near) = near {
            mistake.hint(format!("did you mean `{near}`?"))
        } else if !elsewhere.is_empty() {
            mistake.hint(format!("`{name}` is a key of {}", lanchester_units::one_of(elsewhere.into_iter())))
        } else {
            let keys: Vec<String> = table.keys.iter().map(|key| format!("`{}`", key.name)).collect();
            mistake.hint(format!(
                "{} knows {}",
                table.title(),
                lanchester_units::one_of(keys.iter().map(String::as_str)).replace(" or ", " and ")
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
            (Kind::Flag, Toml::Boolean(flag)) => Some(Value::Flag(*flag)),
            (Kind::Text(most), Toml::String(text)) => self.text(key, text, item, most),
            (Kind::Choice(words), Toml::String(text)) => self.word(key, text, item, words),
            (Kind::Whole(least, most), Toml::Integer(_)) => {
                self.whole(key, item, least, most).map(|spot| Value::Whole(spot.value))
            }
            (Kind::WholeChoice(choices), Toml::Integer(_)) => self.whole_choice(key, item, choices),
            (Kind::Wholes(least, most), Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.whole(key, item, least, most)).map(Value::Wholes)
            }
            (Kind::QuantityOrWord(_, _, word), Toml::String(text)) if text.trim() == word => {
                Some(Value::Word(word))
            }
            (
                Kind::Quantity(dimension, bound)
                | Kind::QuantityOrWord(dimension, bound, _)
                | Kind::QuantityOrPair(dimension, bound)
                | Kind::QuantityOrThree(dimension, bound),
                Toml::String(_) | Toml::Integer(_) | Toml::Float(_),
            ) => {
                if let (Kind::QuantityOrWord(.., word), Some(text)) = (key.kind, item.as_str())
                    && let Err(refusal) = lanchester_units::parse(text, dimension, key.name)
                    && nearest(text, [word].into_iter()).is_some()
                {
                    let mistake = Mistake::error(refusal.code, item.span().range(), refusal.message);
                    let hint = format!("did you mean \"{word}\"?");
                    self.mistakes.push(mistake.label(refusal.label).hint(hint));
                    return None;
                }
                let spot = self.quantity(key, item, dimension, bound)?;
                Some(if matches!(key.kind, Kind::Quantity(..) | Kind::QuantityOrWord(..)) {
                    Value::Number(spot.value)
                } else {
                    Value::Numbers(vec![spot])
                })
            }
            (
                Kind::Quantities(dimension, bound)
                | Kind::QuantityOrPair(dimension, bound)
                | Kind::QuantityOrThree(dimension, bound),
                Toml::Array(_),
            ) => self
                .list(key, item, |walk, item| walk.quantity(key, item, dimension, bound))
                .map(Value::Numbers),
            (Kind::Direction, Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.component(key, item)).map(Value::Numbers)
            }
            (Kind::Share, Toml::String(_)) => self
                .quantity(key, item, Dimension::Share, Bound::NotNegative)
                .map(|spot| Value::Number(spot.value)),
            (Kind::Share, Toml::Integer(_) | Toml::Float(_)) => {
                self.bare_share(key, item).map(|spot| Value::Number(spot.value))
            }
            (Kind::ShareOrPair | Kind::ShareOrThree, Toml::String(_) | Toml::Integer(_) | Toml::Float(_)) => {
                self.share(key, item).map(|spot| Value::Numbers(vec![spot]))
            }
            (Kind::ShareOrPair | Kind::ShareOrThree, Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.share(key, item)).map(Value::Numbers)
            }
            (Kind::Number(bound), Toml::Integer(_) | Toml::Float(_)) => self.bare_number(key, item, bound),
            (Kind::Truth, Toml::Boolean(truth)) => Some(Value::Truth(*truth)),
            (Kind::Stages, Toml::Array(array)) => self.stages(key, array, item),
            (Kind::Orders | Kind::Durabilities, Toml::Array(array)) => self.orders(key, array, item),
            (Kind::Limits | Kind::AtLeast | Kind::GiveUps, Toml::Table(table)) => {
                self.terms(key, table).map(Value::Terms)
            }
            (Kind::Amounts, Toml::String(_) | Toml::Integer(_) | Toml::Float(_)) => {
                self.amount(key, item, key_span).map(|one| Value::Texts(vec![one]))
            }
            (Kind::Amounts, Toml::Array(_)) => {
                self.list(key, item, |walk, item| walk.amount(key, item, key_span)).map(Value::Texts)
            }
            (Kind::Order, Toml::Integer(_) | Toml::Float(_)) => {
                self.bare_number(key, item, Bound::NotNegative)
            }
            (Kind::Order, Toml::String(_)) => self.order(key, item),
            (Kind::Ratio, Toml::Integer(_) | Toml::Float(_) | Toml::String(_)) => self.ratio(key, item),
            (Kind::Table(table), Toml::Table(toml)) => {
                let span = self.item_span(item, key_span);
                Some(Value::Table(self.section(table, toml, span)))
            }
            (Kind::Tables(table, most), Toml::Array(array)) => self.tables(key, table, most, array, item),
            (Kind::ValuesOrTables(table, most), Toml::Array(array)) => {
                self.values_or_tables(key, table, most, array, item)
            }
            _ => {
                self.wrong_kind(key, item, key_span);
                None
            }
        }
    }

    /// Tables, and values that stand for tables with nothing but their first key.
    fn values_or_tables(
        &mut self,
        key: &Key,
        table: &'static Table,
        most: usize,
        array: &toml_spanner::Array<'_>,
        item: &Item<'_>,
    ) -> Option<Value> {
        if array.len() > most {
            self.too_many(key, array.len(), most, item.span().range());
            return None;
        }
        let first = table.keys.first()?;
        let mut sections = Vec::new();
        let mut all_good = true;
        for element in array {
            let span = element.span().range();
            if let Some(toml) = element.as_table() {
                sections.push(self.section(table, toml, span));
                continue;
            }
            match self.value(first, element, &span) {
                Some(value) => sections.push(Section::of_one(table, first, span, value)),
                None => all_good = false,
            }
        }
        all_good.then_some(Value::Tables(sections))
    }

    pub(super) fn wrong_kind(&mut self, key: &Key, item: &Item<'_>, key_span: &Span) {
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

    pub(super) fn too_many(&mut self, key: &Key, got: usize, most: usize, span: Span) {
        let message = format!("`{}` has {got} entries, more than the {most} that a file may have", key.name);
        self.mistakes.push(Mistake::error("E0004", span, message));
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
