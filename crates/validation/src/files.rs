//! The sources that the files of `validation/` make up.

use crate::result::Deferred;
use crate::source::{Change, KinematicsName, Table};
use lanchester_data::FILES;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A source: its `source.json`, tables and engine files.
pub(crate) struct Source {
    pub key: String,
    pub title: String,
    pub citation: String,
    pub kinematics: KinematicsName,
    pub grid: Option<usize>,
    pub changes: BTreeMap<String, Change>,
    pub deferred: Vec<Deferred>,
    pub tables: Vec<Table>,
    /// Engine files by name.
    pub engines: BTreeMap<String, &'static str>,
}

/// `source.json`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    title: String,
    citation: String,
    /// Motion that its tables were computed with.
    kinematics: KinematicsName,
    /// Angles of a revolution among which its extremes were looked for; none: true extremes.
    grid: Option<usize>,
    /// Named changes of engine files.
    changes: BTreeMap<String, Change>,
    deferred: Vec<Deferred>,
}

/// All sources, in the order of [`FILES`].
pub(crate) fn sources() -> Vec<Source> {
    FILES
        .iter()
        .filter_map(|(path, text)| path.strip_suffix("/source.json").map(|key| (key, text)))
        .map(|(key, text)| {
            let head: Head = serde_json::from_str(text).expect("invariant: a test reads every embedded file");
            let own =
                || FILES.iter().filter_map(move |(p, t)| Some((p.strip_prefix(key)?.strip_prefix('/')?, *t)));
            Source {
                key: key.to_string(),
                title: head.title,
                citation: head.citation,
                kinematics: head.kinematics,
                grid: head.grid,
                changes: head.changes,
                deferred: head.deferred,
                tables: own()
                    .filter(|(name, _)| {
                        name.ends_with(".json") && !["source.json", "figures.json"].contains(name)
                    })
                    .map(|(_, t)| {
                        serde_json::from_str(t).expect("invariant: a test reads every embedded file")
                    })
                    .collect(),
                engines: own()
                    .filter_map(|(name, t)| Some((name.strip_suffix(".toml")?.to_string(), t)))
                    .collect(),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::Verdict;

    #[test]
    fn files_can_be_read_and_explain_what_is_no_match() {
        for source in sources() {
            // Bodies, mechanisms and films that are no engines stand alone.
            let has_engines = ["elastic-bodies", "mechanisms", "oil-films"].contains(&source.key.as_str())
                || !source.engines.is_empty();
            assert!(!source.tables.is_empty() && has_engines, "{}", source.key);
            for table in &source.tables {
                for row in &table.rows {
                    let cells = row.printed.cells();
                    let place = format!("{} {}: {}", source.key, table.table, row.quantity);
                    assert_eq!(cells.len(), table.columns.len().max(1), "{place}");
                    for cell in cells.iter().filter(|c| c.expected() != Verdict::Match) {
                        let is_held = match cell.expected() {
                            Verdict::Residual => cell.residual().is_some() && cell.correct().is_none(),
                            Verdict::InputItself => true,
                            _ => cell.correct().is_some(),
                        };
                        assert!(cell.reason().is_some() && is_held, "{place}");
                    }
                }
            }
        }
    }
}
