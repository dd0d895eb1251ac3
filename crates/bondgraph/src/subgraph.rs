//! Graphs within graphs: a used graph's names get a prefix, and its parameters may be given anew.

use crate::description::{Description, Entry, Happening, Text, Use};
use crate::mistake::Mistakes;
use crate::unit::leading_unit;
use std::collections::HashSet;
use std::ops::Range;

/// Graphs within graphs deeper than this are refused: one would use itself.
const DEEPEST: usize = 8;

impl Description {
    /// Adds all of another graph under a prefix, `spring` of it as `prefix_spring`; parameters given here replace its own.
    #[must_use]
    pub fn part(mut self, prefix: &str, other: &Description, parameters: &[(&str, &str)]) -> Description {
        let given = parameters.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect();
        let used = Use { graph: Text::default(), prefix: prefix.into(), parameters: given };
        let mut mistakes = Mistakes::default();
        include(&mut self, other, &used, &mut mistakes);
        self
    }
}

/// Puts the graphs that a description uses into it; `look_up` gives their texts.
pub(crate) fn assemble(
    description: &mut Description,
    look_up: &dyn Fn(&str) -> Option<String>,
    depth: usize,
    mistakes: &mut Mistakes,
) {
    for used in std::mem::take(&mut description.uses) {
        let name = &used.graph.text;
        if depth >= DEEPEST {
            let message = format!("`{name}` is used {DEEPEST} graphs deep");
            mistakes.push("E1715", &used.graph.span, message, "no graph may use itself");
            continue;
        }
        let Some(text) = look_up(name) else {
            let message = format!("there is no graph `{name}`");
            mistakes.push("E1702", &used.graph.span, message, "give its place from the folder of this file");
            continue;
        };
        let mut own = Mistakes::default();
        let mut other = crate::file::read(&text, look_up, &mut own);
        assemble(&mut other, look_up, depth + 1, &mut own);
        for (code, message, hint) in own.said() {
            mistakes.push(code, &used.graph.span, format!("in `{name}`: {message}"), hint);
        }
        include(description, &other, &used, mistakes);
    }
}

fn include(description: &mut Description, other: &Description, used: &Use, mistakes: &mut Mistakes) {
    let names: HashSet<&str> = (other.parameters.iter().map(|(name, _)| name.text.as_str()))
        .chain(other.elements.iter().chain(&other.signals).map(|entry| entry.name.text.as_str()))
        .chain(other.tables.iter().map(|(name, _)| name.text.as_str()))
        .collect();
    let span = &used.graph.span;
    let prefixed = |name: &str| Text { text: format!("{}_{name}", used.prefix.text), span: span.clone() };
    let renamed =
        |text: &Text| Text { text: rename(&text.text, &names, &used.prefix.text), span: span.clone() };
    for (name, _) in &used.parameters {
        if !other.parameters.iter().any(|(known, _)| known.text == name.text) {
            let message = format!("`{}` has no parameter `{}`", used.graph.text, name.text);
            mistakes.push("E1706", &name.span, message, "name one of its [parameters]");
        }
    }
    for (name, value) in &other.parameters {
        let given = used.parameters.iter().find(|(own, _)| own.text == name.text);
        let value = given.map_or_else(|| renamed(value), |(_, value)| value.clone());
        description.parameters.push((prefixed(&name.text), value));
    }
    for (name, curve) in &other.tables {
        description.tables.push((prefixed(&name.text), curve.clone()));
    }
    let entry = |entry: &Entry| Entry {
        name: prefixed(&entry.name.text),
        keys: entry
            .keys
            .iter()
            .map(|(key, value)| {
                let plain = matches!(key.text.as_str(), "kind" | "domain");
                let value = if plain { value.text.as_str().into() } else { renamed(value) };
                (Text { text: key.text.clone(), span: span.clone() }, Text { span: span.clone(), ..value })
            })
            .collect(),
    };
    description.elements.extend(other.elements.iter().map(entry));
    description.signals.extend(other.signals.iter().map(entry));
    description.relax.extend(other.relax.iter().map(entry));
    for event in &other.events {
        let set = event.set.iter().map(|(state, value)| (renamed(state), renamed(value))).collect();
        description.events.push(Happening { when: renamed(&event.when), set, stop: event.stop });
    }
    for bond in &other.bonds {
        let ends: Vec<String> = bond.text.split('>').map(|end| prefixed(end.trim()).text).collect();
        description.bonds.push(Text { text: ends.join(" > "), span: span.clone() });
    }
}

/// An expression with a prefix before every name of the graph; units behind numbers stay.
fn rename(text: &str, names: &HashSet<&str>, prefix: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    while let Some(first) = rest.chars().next() {
        if first.is_ascii_digit() || (first == '.' && rest[1..].starts_with(|c: char| c.is_ascii_digit())) {
            let Range { end, .. } = number(rest);
            let unit = leading_unit(&rest[end..]).map_or(0, |(length, ..)| length);
            out += &rest[..end + unit];
            rest = &rest[end + unit..];
        } else if first.is_alphabetic() || first == '_' {
            let end = rest.find(|c: char| !is_word(c)).unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            let name = word.split('.').next().unwrap_or(word);
            if names.contains(name) && !after.starts_with('(') {
                out += prefix;
                out.push('_');
            }
            out += word;
            rest = after;
        } else {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
    out
}

/// The digits of a number at the start of a text.
fn number(text: &str) -> Range<usize> {
    let bytes = text.as_bytes();
    let mut end = bytes.iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let digits = bytes[end + 1 + sign..].iter().take_while(|b| b.is_ascii_digit()).count();
        if digits > 0 {
            end += 1 + sign + digits;
        }
    }
    0..end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_the_prefix_and_units_do_not() {
        let names = HashSet::from(["m", "k", "spring", "sin", "t1"]);
        let renamed = |text| rename(text, &names, "a");
        assert_eq!(
            renamed("k*spring.displacement + 2 m/s*m"),
            "a_k*spring.displacement + 2 m/s*a_m".replace("*spring", "*a_spring")
        );
        assert_eq!(renamed("sin(m) + 1.5e3 m + t1*t"), "sin(a_m) + 1.5e3 m + a_t1*t");
        assert_eq!(renamed("table(\"k\", 3)"), "table(\"a_k\", 3)");
    }
}
