//! Single keys of an engine file, found and changed by their path; all else stays byte for byte.

use super::entry::{Entry, List, inline, key_text};
use super::splice::Splices;
use crate::expanded::quoted;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use std::ops::Range;
use toml_spanner::{Arena, Item, Table, TableStyle, Value as Toml};

/// A value of the file and where it stands.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FileEntry {
    /// Keys and indices down to it: `crank.stroke`, `cylinder[1].piston.mass`.
    pub path: String,
    /// The value as it is written, units and all.
    pub value: Json,
    /// Its place in the text, in bytes.
    pub span: Range<usize>,
}

/// A change of one key.
#[derive(Debug, Clone, PartialEq, Deserialize, schemars::JsonSchema)]
pub struct Edit {
    /// Keys and indices down to the value: `crank.stroke`, `counterweight[0].unbalance`. The index behind the last entry of a
    /// list adds one; tables on the way that are not there come to be.
    pub path: String,
    /// The new value; `null` takes the key, the table or the entry of a list out. The keys of an object are set one by one,
    /// those that it does not name stay.
    pub value: Json,
}

/// Why a text was not changed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EditError {
    /// Places in a text with mistakes of syntax cannot be trusted.
    #[error(
        "the text cannot be read from line {line} on, so that no key can be changed\nhint: mend the text first"
    )]
    Syntax {
        /// Line of the first mistake, from 1.
        line: usize,
    },
    /// The path leads nowhere.
    #[error(
        "`{path}` needs {needed}\nhint: paths are written like `crank.stroke` or `counterweight[0].unbalance`"
    )]
    Path {
        /// The path that was given.
        path: String,
        /// What it needs at the place where it fails.
        needed: String,
    },
}

/// One step of a path.
#[derive(Debug, Clone, PartialEq)]
enum Step {
    Key(String),
    Index(usize),
}

/// All values of the text in the order of the file; what a broken text still tells.
pub fn file_entries(text: &str) -> Vec<FileEntry> {
    let arena = Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    let mut found = Vec::new();
    collect(document.table(), "", &mut found);
    found.sort_by_key(|entry| entry.span.start);
    found
}

fn collect(table: &Table<'_>, path: &str, found: &mut Vec<FileEntry>) {
    for (key, item) in table {
        let path =
            if path.is_empty() { key_text(key.name) } else { format!("{path}.{}", key_text(key.name)) };
        collect_item(item, path, found);
    }
}

fn collect_item(item: &Item<'_>, path: String, found: &mut Vec<FileEntry>) {
    if let Some(table) = item.as_table() {
        collect(table, &path, found);
        return;
    }
    let tables =
        item.as_array().filter(|array| !array.is_empty() && array.iter().all(|i| i.as_table().is_some()));
    if let Some(tables) = tables {
        for (index, item) in tables.iter().enumerate() {
            collect_item(item, format!("{path}[{index}]"), found);
        }
        return;
    }
    found.push(FileEntry { path, value: json(item), span: item.span().range() });
}

fn json(item: &Item<'_>) -> Json {
    match item.value() {
        Toml::String(text) => Json::from(*text),
        Toml::Integer(_) => item.as_i64().map_or(Json::Null, Json::from),
        Toml::Float(_) => item.as_f64().map_or(Json::Null, Json::from),
        Toml::Boolean(flag) => Json::from(*flag),
        Toml::DateTime(_) => Json::Null,
        Toml::Array(array) => array.iter().map(json).collect(),
        Toml::Table(table) => {
            let keys = table.iter().map(|(key, item)| (key.name.to_string(), json(item)));
            Json::Object(keys.collect())
        }
    }
}

/// The text with its keys changed, one edit after the other. Comments, the order of keys and the spelling of all other values
/// stay; whether the new text makes an engine is for [`read`](crate::read) to tell.
///
/// # Errors
/// [`EditError`] if the text has mistakes of syntax or a path leads through a value that is no table or list.
pub fn edit(text: &str, edits: &[Edit]) -> Result<String, EditError> {
    let mut text = text.to_string();
    for edit in edits {
        let steps = steps(&edit.path)?;
        text = apply(&text, edit, &steps)?;
    }
    Ok(text)
}

fn steps(path: &str) -> Result<Vec<Step>, EditError> {
    let wrong = |needed: &str| EditError::Path { path: path.to_string(), needed: needed.to_string() };
    let mut steps = Vec::new();
    let mut rest = path;
    loop {
        let (key, behind) = if let Some(inside) = rest.strip_prefix('"') {
            inside.split_once('"').ok_or_else(|| wrong("a closing quote"))?
        } else {
            rest.split_at(rest.find(['.', '[']).unwrap_or(rest.len()))
        };
        if key.is_empty() {
            return Err(wrong("a key between its dots"));
        }
        steps.push(Step::Key(key.to_string()));
        rest = behind;
        while let Some(inside) = rest.strip_prefix('[') {
            let (index, behind) = inside.split_once(']').ok_or_else(|| wrong("a closing bracket"))?;
            steps.push(Step::Index(index.parse().map_err(|_| wrong("a whole number between brackets"))?));
            rest = behind;
        }
        match rest.strip_prefix('.') {
            Some(behind) => rest = behind,
            None if rest.is_empty() => return Ok(steps),
            None => return Err(wrong("a dot between its keys")),
        }
    }
}

fn apply(text: &str, edit: &Edit, steps: &[Step]) -> Result<String, EditError> {
    let arena = Arena::new();
    let document = toml_spanner::parse_recoverable(text, &arena);
    if let Some(error) = document.errors().first() {
        let at = (error.span().start as usize).min(text.len());
        return Err(EditError::Syntax {
            line: text.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1,
        });
    }
    let wrong = |needed: String| EditError::Path { path: edit.path.clone(), needed };
    let mut splices = Splices::new(text);
    let root = document.table();
    // Down to the last table that is there.
    let mut here = Entry { item: root.as_item(), table: root };
    let mut header = String::new();
    let mut at = 0;
    loop {
        let Some(Step::Key(key)) = steps.get(at) else { return Err(wrong("a key before each index".into())) };
        let path = if header.is_empty() { key_text(key) } else { format!("{header}.{}", key_text(key)) };
        let rest = &steps[at + 1..];
        let Some(item) = here.get(key) else {
            if edit.value.is_null() {
                return Ok(text.to_string());
            }
            add(here, at == 0, key, &path, rest, &edit.value, &mut splices).map_err(wrong)?;
            return Ok(splices.apply());
        };
        match rest {
            [] => {
                match (&edit.value, item.as_table()) {
                    (Json::Null, Some(_)) => here.unset_table(key, &mut splices),
                    (Json::Null, None) => here.take_out(key, &mut splices),
                    (Json::Object(keys), Some(_)) => return set_each(text, &edit.path, keys),
                    (_, None)
                        if List::of(Some(item))
                            .is_some_and(|list| !list.entries.is_empty() && !list.is_inline()) =>
                    {
                        return Err(wrong(format!("an index for the list `{path}`")));
                    }
                    (value, None) => splices.replace(item.span().range(), toml(value)),
                    (_, Some(_)) => return Err(wrong(format!("keys for the table `{path}`"))),
                }
                return Ok(splices.apply());
            }
            [Step::Index(index), below @ ..] => {
                let list =
                    List::of(Some(item)).ok_or_else(|| wrong(format!("a list of tables at `{path}`")))?;
                let count = list.entries.len();
                match (list.entries.get(*index), below) {
                    (None, _) if edit.value.is_null() => return Ok(text.to_string()),
                    (None, _) if *index == count => {
                        let entry = new_entry(below, &edit.value).map_err(wrong)?;
                        list.append(&path, &[entry], &mut splices);
                        return Ok(splices.apply());
                    }
                    (None, _) => {
                        return Err(wrong(format!("an index up to {count}: `{path}` has {count} entries")));
                    }
                    (Some(_), []) => {
                        match &edit.value {
                            Json::Null if count == 1 => here.take_out(key, &mut splices),
                            Json::Null => list.remove(*index, &mut splices),
                            Json::Object(keys) => return set_each(text, &edit.path, keys),
                            _ => return Err(wrong(format!("keys for an entry of `{path}`"))),
                        }
                        return Ok(splices.apply());
                    }
                    (Some(entry), _) => here = *entry,
                }
                // A table below the entry of a list is written into the entry, never as a header.
                header = format!("{path}[{index}]");
                at += 2;
            }
            _ => {
                let table = item.as_table().ok_or_else(|| wrong(format!("a table at `{path}`")))?;
                here = Entry { item, table };
                header = path;
                at += 1;
            }
        }
    }
}

/// Each key of an object on its own, so that the others and all comments stay.
fn set_each(text: &str, path: &str, keys: &serde_json::Map<String, Json>) -> Result<String, EditError> {
    let edits: Vec<Edit> = keys
        .iter()
        .map(|(key, value)| Edit { path: format!("{path}.{}", key_text(key)), value: value.clone() })
        .collect();
    edit(text, &edits)
}

/// A key that is not there, with the tables on the way to it.
fn add(
    here: Entry<'_>,
    is_root: bool,
    key: &str,
    path: &str,
    rest: &[Step],
    value: &Json,
    splices: &mut Splices<'_>,
) -> Result<(), String> {
    let line_end = splices.line_end;
    if let [Step::Index(index), below @ ..] = rest {
        if *index != 0 {
            return Err(format!("the index 0: `{path}` has no entries"));
        }
        let entry = new_entry(below, value)?;
        match is_root {
            true => List::of(None).map_or((), |list| list.append(path, &[entry], splices)),
            false => {
                here.add_last(&key_text(key), parent(path), &format!("[{}]", inline(&entry)), splices)?
            }
        }
        return Ok(());
    }
    let is_header = here.table.style() != TableStyle::Inline && !path.contains('[');
    match (rest, value) {
        ([], Json::Object(keys)) if is_header => {
            let lines =
                keys.iter().map(|(key, value)| format!("{line_end}{} = {}", key_text(key), toml(value)));
            splices.append_block(&format!("[{path}]{}", lines.collect::<String>()));
        }
        ([], value) => here.add_last(&key_text(key), parent(path), &toml(value), splices)?,
        (below, value) if is_header => {
            // The innermost table gets the header.
            let mut header = path.to_string();
            let mut below = below;
            while let [Step::Key(next), more @ ..] = below
                && (!more.is_empty() || value.is_object())
            {
                header = format!("{header}.{}", key_text(next));
                below = more;
            }
            let entry = new_entry(below, value)?;
            let lines: String =
                entry.iter().map(|(key, value)| format!("{line_end}{key} = {value}")).collect();
            splices.append_block(&format!("[{header}]{lines}"));
        }
        (below, value) => {
            here.add_last(&key_text(key), parent(path), &inline(&new_entry(below, value)?), splices)?;
        }
    }
    Ok(())
}

/// The path of the table that a key stands in; empty for the file itself.
fn parent(path: &str) -> &str {
    path.rfind('.').map_or("", |dot| &path[..dot])
}

/// Keys and values of a new table, as TOML.
type NewKeys = Vec<(String, String)>;

/// What a table holds that has `value` at the end of `below`.
fn new_entry(below: &[Step], value: &Json) -> Result<NewKeys, String> {
    match (below, value) {
        ([], Json::Object(keys)) => {
            Ok(keys.iter().map(|(key, value)| (key_text(key), toml(value))).collect())
        }
        ([], _) => Err("keys for a new entry of a list".to_string()),
        ([Step::Key(key)], value) => Ok(vec![(key_text(key), toml(value))]),
        ([Step::Key(key), more @ ..], value) => Ok(vec![(key_text(key), inline(&new_entry(more, value)?))]),
        ([Step::Index(_), ..], _) => {
            Err("a list that is there: lists within new tables are set as a whole".to_string())
        }
    }
}

/// A value as TOML writes it.
fn toml(value: &Json) -> String {
    match value {
        // TOML has no null; `edit` never asks for one but within a list, which no engine file holds.
        Json::Null => quoted(""),
        Json::Bool(flag) => flag.to_string(),
        Json::Number(number) => number.to_string(),
        Json::String(text) => quoted(text),
        Json::Array(list) => format!("[{}]", list.iter().map(toml).collect::<Vec<_>>().join(", ")),
        Json::Object(keys) => {
            let keys: NewKeys = keys.iter().map(|(key, value)| (key_text(key), toml(value))).collect();
            inline(&keys)
        }
    }
}
