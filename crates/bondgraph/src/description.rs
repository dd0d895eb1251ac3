//! A bond graph as it is described: by a file or by calls, which are the same thing.

use crate::curve::Curve;
use std::ops::Range;

/// A text and its place in the file; empty for what was described by calls.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Its place in bytes.
    pub span: Range<usize>,
}

impl From<&str> for Text {
    fn from(text: &str) -> Text {
        Text { text: text.to_owned(), span: 0..0 }
    }
}

/// A named thing with keys, each with its text.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Entry {
    /// Its name.
    pub name: Text,
    /// Its keys in their order.
    pub keys: Vec<(Text, Text)>,
}

impl Entry {
    /// The text of a key.
    pub fn get(&self, key: &str) -> Option<&Text> {
        self.keys.iter().find(|(name, _)| name.text == key).map(|(_, text)| text)
    }
}

/// Another graph that is a part of this one.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Use {
    /// Name of its file.
    pub graph: Text,
    /// Prefix of all its names.
    pub prefix: Text,
    /// Parameters that are given anew.
    pub parameters: Vec<(Text, Text)>,
}

/// Something that happens where a quantity rises through zero: states are set anew, or the simulation ends.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Happening {
    /// The quantity.
    pub when: Text,
    /// States, `ball.momentum` or a signal that is an integral, and their new values by the values just before.
    pub set: Vec<(Text, Text)>,
    /// Whether the simulation ends there.
    pub stop: bool,
}

/// A bond graph as it is described, unchecked; [`crate::Graph::new`] checks it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Description {
    /// Name of the graph.
    pub name: String,
    /// Parameters: name and value or expression.
    pub parameters: Vec<(Text, Text)>,
    /// Elements with `kind` and the keys of their law.
    pub elements: Vec<Entry>,
    /// Signals with `value`, or with `integral_of` and `start`.
    pub signals: Vec<Entry>,
    /// Graphs that are parts of it, until they are put into it.
    pub uses: Vec<Use>,
    /// Bonds, `"from > to"`.
    pub bonds: Vec<Text>,
    /// Tables that expressions read: `table(name, x)`.
    pub tables: Vec<(Text, Curve)>,
    /// Stores before which a spring and a damper are put, with `stiffness` and `damping`.
    pub relax: Vec<Entry>,
    /// What happens on the way.
    pub events: Vec<Happening>,
    /// Duration, samples and tolerance of a simulation.
    pub simulation: Vec<(Text, Text)>,
}

impl Description {
    /// An empty graph.
    pub fn new(name: &str) -> Description {
        Description { name: name.to_owned(), ..Description::default() }
    }

    /// Adds a parameter, a quantity or an expression.
    #[must_use]
    pub fn parameter(mut self, name: &str, value: &str) -> Description {
        self.parameters.push((name.into(), value.into()));
        self
    }

    /// Adds an element of a kind with the keys of its law.
    #[must_use]
    pub fn element(mut self, name: &str, kind: &str, keys: &[(&str, &str)]) -> Description {
        let mut entry = Entry { name: name.into(), keys: vec![("kind".into(), kind.into())] };
        entry.keys.extend(keys.iter().map(|(key, value)| ((*key).into(), (*value).into())));
        self.elements.push(entry);
        self
    }

    /// Adds a signal with its keys.
    #[must_use]
    pub fn signal(mut self, name: &str, keys: &[(&str, &str)]) -> Description {
        let keys = keys.iter().map(|(key, value)| ((*key).into(), (*value).into())).collect();
        self.signals.push(Entry { name: name.into(), keys });
        self
    }

    /// Adds bonds, each `"from > to"`.
    #[must_use]
    pub fn bonds(mut self, bonds: &[&str]) -> Description {
        self.bonds.extend(bonds.iter().map(|bond| (*bond).into()));
        self
    }

    /// Adds what happens where `when` rises through zero: `set` gives states their new values.
    #[must_use]
    pub fn event(mut self, when: &str, set: &[(&str, &str)]) -> Description {
        let set = set.iter().map(|(state, value)| ((*state).into(), (*value).into())).collect();
        self.events.push(Happening { when: when.into(), set, stop: false });
        self
    }

    /// Ends a simulation where `when` rises through zero.
    #[must_use]
    pub fn stop(mut self, when: &str) -> Description {
        self.events.push(Happening { when: when.into(), set: Vec::new(), stop: true });
        self
    }

    /// Puts a spring, and where `damping` is given a damper, before a store that would follow.
    #[must_use]
    pub fn relax(mut self, store: &str, stiffness: &str, damping: Option<&str>) -> Description {
        let mut keys = vec![("stiffness".into(), stiffness.into())];
        keys.extend(damping.map(|damping| ("damping".into(), damping.into())));
        self.relax.push(Entry { name: store.into(), keys });
        self
    }

    /// Adds a table.
    #[must_use]
    pub fn table(mut self, name: &str, curve: Curve) -> Description {
        self.tables.push((name.into(), curve));
        self
    }
}
