//! Tables of the file and lists of them, as they are written.

use super::splice::Splices;
use crate::expanded::quoted;
use std::fmt::Display;
use std::ops::Range;
use toml_spanner::{Array, ArrayStyle, Item, Key, Table, TableStyle};

/// Keys and values of a table that is to be written; values as TOML.
pub(super) type NewEntry = Vec<(&'static str, String)>;

/// A table of the file.
#[derive(Clone, Copy)]
pub(super) struct Entry<'a> {
    pub(super) item: &'a Item<'a>,
    pub(super) table: &'a Table<'a>,
}

impl<'a> Entry<'a> {
    pub(super) fn get(self, key: &str) -> Option<&'a Item<'a>> {
        self.table.get(key)
    }

    pub(super) fn has(self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// The text of a value.
    pub(super) fn text(self, key: &str) -> Option<&'a str> {
        self.get(key)?.as_str()
    }

    pub(super) fn start(self) -> usize {
        self.item.span().range().start
    }

    fn is_inline(self) -> bool {
        self.table.style() == TableStyle::Inline
    }

    /// From the key to the end of its value.
    fn whole(self, key: &str, splices: &Splices<'_>) -> Option<Range<usize>> {
        let (key, value) = self.table.get_key_value(key)?;
        Some(key_start(key, splices)..value.span().range().end)
    }

    /// Sets the key; a new one comes behind the first of `behind` that is there.
    pub(super) fn set(self, key: &'static str, value: &str, behind: &[&str], splices: &mut Splices<'_>) {
        match self.get(key) {
            Some(old) => splices.replace(old.span().range(), value),
            None => self.add(key, value, behind, splices),
        }
    }

    /// A new key behind the first of `behind` that is there.
    pub(super) fn add(self, key: &'static str, value: &str, behind: &[&str], splices: &mut Splices<'_>) {
        let anchor = behind
            .iter()
            .find_map(|key| self.whole(key, splices))
            .or_else(|| self.table.iter().next().and_then(|(key, _)| self.whole(key.name, splices)));
        let Some(anchor) = anchor else { return };
        if self.is_inline() {
            splices.insert(anchor.end, format!(", {key} = {value}"));
        } else {
            let (line_end, indentation) = (splices.line_end, splices.indentation(anchor.start));
            splices.insert(splices.line_stop(anchor.end), format!("{line_end}{indentation}{key} = {value}"));
        }
    }

    /// A new key behind the last of the table's own, however the table is written; `path` is what a header of it says.
    ///
    /// # Errors
    /// What would be needed, for a table within braces that is written with dots.
    pub(super) fn add_last(
        self,
        key: &str,
        path: &str,
        value: &str,
        splices: &mut Splices<'_>,
    ) -> Result<(), String> {
        let line_end = splices.line_end;
        match self.table.style() {
            TableStyle::Inline => {
                let inside = self.item.span().range();
                let last = self
                    .table
                    .iter()
                    .map(|(_, item)| full_end(item).unwrap_or(item.span().range().end))
                    .max();
                match last {
                    Some(last) => splices.insert(last, format!(", {key} = {value}")),
                    None => splices.replace(inside, format!("{{ {key} = {value} }}")),
                }
            }
            TableStyle::Implicit if !path.is_empty() => {
                splices.append_block(&format!("[{path}]{line_end}{key} = {value}"));
            }
            TableStyle::Dotted => {
                let first = self.table.iter().next().map(|(key, _)| key_start(key, splices));
                let end = own_end(self.item);
                let (Some(first), Some(end)) = (first, end) else { return Ok(()) };
                let line = splices.line_start(first);
                let before = splices.text[line..first].to_string();
                if before.contains(['{', '=']) {
                    return Err(format!("a table `{path}` with a header, or between braces without dots"));
                }
                splices.insert(splices.line_stop(end), format!("{line_end}{before}{key} = {value}"));
            }
            TableStyle::Header | TableStyle::Implicit => match own_end(self.item) {
                Some(end) => {
                    let indentation = splices.indentation(end);
                    // A list over several lines ends in a line of its own.
                    let indentation = if splices.text[splices.line_start(end)..end].contains('=') {
                        indentation
                    } else {
                        ""
                    };
                    splices.insert(splices.line_stop(end), format!("{line_end}{indentation}{key} = {value}"));
                }
                None if path.is_empty() => {
                    let start = splices.line_start(0);
                    splices.insert(start, format!("{key} = {value}{line_end}"));
                }
                None => {
                    let end = header_end(self.start(), splices);
                    splices.insert(splices.line_stop(end), format!("{line_end}{key} = {value}"));
                }
            },
        }
        Ok(())
    }

    /// Takes any key with its value out, and all entries of a list; comments stay.
    pub(super) fn take_out(self, key: &str, splices: &mut Splices<'_>) {
        let list = self.get(key).and_then(|item| List::of(Some(item))).filter(|list| !list.is_inline());
        if let Some(list) = list {
            for entry in list.entries {
                entry.remove_block(splices);
            }
        } else if self.table.style() == TableStyle::Dotted {
            let Some(range) = self.whole(key, splices) else { return };
            let line = splices.line_start(range.start);
            let start = line + splices.indentation(range.start).len();
            splices.remove(start..range.end);
        } else {
            self.unset(key, splices);
        }
    }

    /// Another key and value in place of a key and its value.
    pub(super) fn exchange(self, old: &str, key: &str, value: &str, splices: &mut Splices<'_>) {
        if let Some(range) = self.whole(old, splices) {
            splices.replace(range, format!("{key} = {value}"));
        }
    }

    /// Takes a key out that is not the only one.
    pub(super) fn unset(self, key: &str, splices: &mut Splices<'_>) {
        let Some(range) = self.whole(key, splices) else { return };
        if !self.is_inline() {
            splices.remove(range);
            return;
        }
        let table = self.item.span().range();
        let range = with_comma(splices.text, range, table);
        splices.remove(range);
    }

    /// The table with its header, without tables of their own below it.
    fn own_block(self, splices: &Splices<'_>) -> Range<usize> {
        let start = self.start();
        start..own_end(self.item).unwrap_or_else(|| header_end(start, splices))
    }

    /// Where everything ends that belongs to it.
    pub(super) fn end(self, splices: &Splices<'_>) -> usize {
        full_end(self.item).unwrap_or_else(|| header_end(self.start(), splices))
    }

    /// Takes a table with a header out for others to stand there; gives their place.
    pub(super) fn replace_block(self, splices: &mut Splices<'_>) -> usize {
        let block = self.own_block(splices);
        splices.make_way(block)
    }

    /// Takes a table with a header out, and the tables below it.
    pub(super) fn remove_block(self, splices: &mut Splices<'_>) {
        let block = self.own_block(splices);
        splices.remove(block);
        self.remove_below(splices);
    }

    /// Takes the tables with headers below it out.
    fn remove_below(self, splices: &mut Splices<'_>) {
        for (_, item) in self.table {
            if let Some(table) = item.as_table() {
                let entry = Entry { item, table };
                match table.style() {
                    TableStyle::Header => entry.remove_block(splices),
                    TableStyle::Implicit => entry.remove_below(splices),
                    TableStyle::Inline | TableStyle::Dotted => {}
                }
            }
            if let Some(list) = List::of(Some(item))
                && list.array.is_some_and(|array| array.style() == ArrayStyle::Header)
            {
                for entry in list.entries {
                    entry.remove_block(splices);
                }
            }
        }
    }

    /// Takes a table below it out, however it is written; its comments stay.
    pub(super) fn unset_table(self, key: &str, splices: &mut Splices<'_>) {
        let Some(item) = self.get(key) else { return };
        let Some(table) = item.as_table() else { return };
        let entry = Entry { item, table };
        match table.style() {
            TableStyle::Inline => self.unset(key, splices),
            TableStyle::Header => entry.remove_block(splices),
            TableStyle::Dotted | TableStyle::Implicit => {
                entry.remove_dotted(splices);
                entry.remove_below(splices);
            }
        }
    }

    /// Takes the lines of dotted keys out.
    pub(super) fn remove_dotted(self, splices: &mut Splices<'_>) {
        for (_, item) in self.table {
            let dotted = item.as_table().filter(|table| table.style() == TableStyle::Dotted);
            if let Some(table) = dotted {
                Entry { item, table }.remove_dotted(splices);
            } else if !has_header(item) {
                let value = item.span().range();
                let line = splices.line_start(value.start);
                let start = line + splices.indentation(line).len();
                splices.remove(start..value.end);
            }
        }
    }

    /// Whether a table below it stands between braces behind its key.
    pub(super) fn has_inline(self, key: &str) -> bool {
        self.get(key).and_then(Item::as_table).is_some_and(|table| table.style() == TableStyle::Inline)
    }
}

/// A key as TOML writes it: in quotes where it is no plain word.
pub(super) fn key_text(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(is_plain) { name.to_string() } else { quoted(name) }
}

/// Where the key begins, with its quotes.
fn key_start(key: &Key<'_>, splices: &Splices<'_>) -> usize {
    let start = key.span.range().start;
    let is_quoted = splices.text[..start].ends_with(['"', '\'']);
    if is_quoted { start - 1 } else { start }
}

/// Behind the brackets of the header.
fn header_end(start: usize, splices: &Splices<'_>) -> usize {
    let line = &splices.text[start..splices.line_stop(start)];
    start + line.split('#').next().unwrap_or("").trim_end().len()
}

fn has_header(item: &Item<'_>) -> bool {
    item.as_table().is_some_and(|table| table.style() == TableStyle::Header)
        || item.as_array().is_some_and(|array| array.style() == ArrayStyle::Header)
}

/// End of the last value between the header and the next.
fn own_end(item: &Item<'_>) -> Option<usize> {
    let table = item.as_table()?;
    table
        .iter()
        .filter(|(_, item)| !has_header(item))
        .filter_map(|(_, item)| match item.as_table().map(Table::style) {
            Some(TableStyle::Dotted | TableStyle::Implicit) => own_end(item),
            _ => Some(item.span().range().end),
        })
        .max()
}

/// End of the last value of the table and of every table below it.
fn full_end(item: &Item<'_>) -> Option<usize> {
    let below = |item: &Item<'_>| match (item.as_table(), item.as_array()) {
        (Some(table), _) if table.style() != TableStyle::Inline => full_end(item),
        (_, Some(array)) if array.style() == ArrayStyle::Header => {
            let ends = array.iter().map(|item| full_end(item).unwrap_or(item.span().range().end));
            ends.max()
        }
        _ => Some(item.span().range().end),
    };
    item.as_table()?.iter().filter_map(|(_, item)| below(item)).max()
}

/// A list of tables of the file.
pub(super) struct List<'a> {
    /// `None` if the file has none.
    array: Option<&'a Array<'a>>,
    pub(super) entries: Vec<Entry<'a>>,
    span: Range<usize>,
}

impl<'a> List<'a> {
    /// `None` if it is no list of tables.
    pub(super) fn of(item: Option<&'a Item<'a>>) -> Option<List<'a>> {
        let Some(item) = item else { return Some(List { array: None, entries: Vec::new(), span: 0..0 }) };
        let array = item.as_array()?;
        let entries: Option<Vec<Entry<'a>>> =
            array.iter().map(|item| Some(Entry { item, table: item.as_table()? })).collect();
        Some(List { array: Some(array), entries: entries?, span: item.span().range() })
    }

    /// Whether it is written between square brackets.
    pub(super) fn is_inline(&self) -> bool {
        self.array.is_some_and(|array| array.style() == ArrayStyle::Inline)
    }

    /// Takes an entry out; its comments stay.
    pub(super) fn remove(&self, index: usize, splices: &mut Splices<'_>) {
        let entry = self.entries[index];
        if self.is_inline() {
            let range = with_comma(splices.text, entry.item.span().range(), self.span.clone());
            splices.remove(range);
        } else {
            entry.remove_block(splices);
        }
    }

    /// Adds entries behind the last; `path` is the header of the list.
    pub(super) fn append<K: Display>(&self, path: &str, new: &[Vec<(K, String)>], splices: &mut Splices<'_>) {
        if new.is_empty() {
            return;
        }
        if self.is_inline() {
            self.append_inline(new, splices);
            return;
        }
        // At the end of the file if it is the first of its kind.
        let at = match self.entries.last() {
            Some(last) => splices.line_stop(last.end(splices)),
            None => splices.text.trim_end().len(),
        };
        let line_end = splices.line_end;
        let text: String =
            new.iter().map(|entry| format!("{line_end}{line_end}{}", block(path, entry, line_end))).collect();
        splices.insert(at, text);
    }

    fn append_inline<K: Display>(&self, new: &[Vec<(K, String)>], splices: &mut Splices<'_>) {
        let tables: Vec<String> = new.iter().map(|entry| inline(entry)).collect();
        let Some(last) = self.entries.last().map(|entry| entry.item.span().range()) else {
            splices.insert(self.span.start + 1, tables.join(", "));
            return;
        };
        let behind = &splices.text[last.end..self.span.end];
        let comma = comma(behind).map(|at| last.end + at);
        let is_lined = splices.text[self.span.start..last.start].contains('\n');
        if !is_lined {
            match comma {
                Some(comma) => splices.insert(comma + 1, format!(" {}", tables.join(", "))),
                None => splices.insert(last.end, format!(", {}", tables.join(", "))),
            }
            return;
        }
        let (line_end, indentation) = (splices.line_end, splices.indentation(last.start));
        if comma.is_none() {
            splices.insert(last.end, ",");
        }
        let from = comma.unwrap_or(last.end);
        let lines: String = tables.iter().map(|table| format!("{line_end}{indentation}{table},")).collect();
        // A bracket that closes the list in the last entry's line stays behind the new ones.
        let stop = splices.line_stop(from).min(self.span.end - 1);
        splices.insert(stop, lines);
    }
}

/// A list of inline tables, one a line if they are more than one; without `line_end` all in one line.
pub(super) fn list_value(entries: &[NewEntry], line_end: &str) -> String {
    let tables: Vec<String> = entries.iter().map(|entry| inline(entry)).collect();
    if tables.len() < 2 || line_end.is_empty() {
        return format!("[{}]", tables.join(", "));
    }
    let lines: String = tables.iter().map(|table| format!("    {table},{line_end}")).collect();
    format!("[{line_end}{lines}]")
}

/// `[[path]]` with its keys.
pub(super) fn block<K: Display>(path: &str, entry: &[(K, String)], line_end: &str) -> String {
    let lines: Vec<String> = entry.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    format!("[[{path}]]{line_end}{}", lines.join(line_end))
}

/// A table between braces.
pub(super) fn inline<K: Display>(entry: &[(K, String)]) -> String {
    let keys: Vec<String> = entry.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    format!("{{ {} }}", keys.join(", "))
}

/// Where the first comma of the piece stands that no comment hides; the piece begins behind a value.
fn comma(piece: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        let rest = &piece[at..];
        at += rest.len() - rest.trim_start().len();
        let rest = &piece[at..];
        if !rest.starts_with('#') {
            return rest.starts_with(',').then_some(at);
        }
        at += rest.find('\n').unwrap_or(rest.len());
    }
}

/// A value or a key with its value in a list or table between brackets, and the comma that parts it from the next; of
/// the last one the comma before it.
fn with_comma(text: &str, range: Range<usize>, outer: Range<usize>) -> Range<usize> {
    if let Some(comma) = comma(&text[range.end..outer.end]) {
        let end = range.end + comma + 1;
        let blanks = text[end..outer.end].len() - text[end..outer.end].trim_start_matches(' ').len();
        let is_lined = text[end + blanks..].starts_with(['\n', '\r', '#', ']', '}']);
        return range.start..if is_lined { end } else { end + blanks };
    }
    let before = text[outer.start..range.start].trim_end();
    match before.strip_suffix(',') {
        Some(kept) => outer.start + kept.len()..range.end,
        // A comment parts it from the comma: a comma too many is allowed in a list.
        None => range,
    }
}

/// A text in the quotes that the old value has.
pub(super) fn quoted_like(old: Option<&Item<'_>>, new: &str, splices: &Splices<'_>) -> String {
    let source = old.map_or("", |item| &splices.text[item.span().range()]);
    let is_literal = source.starts_with('\'') && !source.starts_with("'''");
    if is_literal && !new.contains('\'') { format!("'{new}'") } else { quoted(new) }
}
