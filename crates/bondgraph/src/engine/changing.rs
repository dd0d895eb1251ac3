//! Which states the events of an engine's graph set.

use std::collections::BTreeSet;

/// States that events set, by name.
#[derive(Debug, Clone, Default)]
pub(crate) struct Changing {
    names: BTreeSet<String>,
}

impl Changing {
    /// Those of these names.
    pub(crate) fn of(names: impl Iterator<Item = String>) -> Changing {
        Changing { names: names.collect() }
    }

    /// Whether events set a state.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.names.contains(name)
    }
}
