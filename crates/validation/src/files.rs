//! The files of `validation/` as the program keeps them, and the sources that they make up.

use crate::result::Deferred;
use crate::source::{Change, KinematicsName, Table};
use serde::Deserialize;
use std::collections::BTreeMap;

macro_rules! embedded {
    ($($path:literal),* $(,)?) => {
        &[$(($path, include_str!(concat!("../../../validation/", $path)))),*]
    };
}

/// Every data file of `validation/`, by its path there, in the order of the page.
pub(crate) const FILES: &[(&str, &str)] = embedded![
    "twin-cylinder-thesis/source.json",
    "twin-cylinder-thesis/boxer-in-phase.toml",
    "twin-cylinder-thesis/boxer-out-of-phase.toml",
    "twin-cylinder-thesis/in-line-four.toml",
    "twin-cylinder-thesis/in-line-in-phase.toml",
    "twin-cylinder-thesis/in-line-out-of-phase.toml",
    "twin-cylinder-thesis/single.toml",
    "twin-cylinder-thesis/table-01.json",
    "twin-cylinder-thesis/table-02.json",
    "twin-cylinder-thesis/table-03.json",
    "twin-cylinder-thesis/table-04.json",
    "twin-cylinder-thesis/table-05.json",
    "twin-cylinder-thesis/table-06.json",
    "twin-cylinder-thesis/table-07.json",
    "twin-cylinder-thesis/table-08.json",
    "twin-cylinder-thesis/table-09.json",
    "twin-cylinder-thesis/table-10.json",
    "twin-cylinder-thesis/table-11.json",
    "twin-cylinder-thesis/table-12.json",
    "twin-cylinder-thesis/table-13.json",
    "twin-cylinder-thesis/table-14.json",
    "twin-cylinder-thesis/table-15.json",
    "twin-cylinder-thesis/table-16.json",
    "twin-cylinder-thesis/table-17.json",
    "twin-cylinder-thesis/table-18.json",
    "twin-cylinder-thesis/table-19.json",
    "twin-cylinder-thesis/table-20.json",
    "twin-cylinder-thesis/table-21.json",
    "twin-cylinder-thesis/table-22.json",
    "twin-cylinder-thesis/table-23.json",
    "twin-cylinder-thesis/table-24.json",
    "twin-cylinder-thesis/table-25.json",
    "twin-cylinder-thesis/table-26.json",
    "twin-cylinder-thesis/table-27.json",
    "twin-cylinder-thesis/table-28.json",
    "twin-cylinder-thesis/table-29.json",
    "twin-cylinder-thesis/table-30.json",
    "twin-cylinder-thesis/table-31.json",
    "twin-cylinder-thesis/table-32.json",
    "twin-cylinder-thesis/table-33.json",
    "twin-cylinder-thesis/table-34.json",
    "twin-cylinder-thesis/table-35.json",
    "twin-cylinder-thesis/table-36.json",
    "twin-cylinder-thesis/table-37.json",
    "twin-cylinder-thesis/table-38.json",
    "twin-cylinder-thesis/table-39.json",
    "twin-cylinder-thesis/table-40.json",
    "twin-cylinder-thesis/table-41.json",
    "twin-cylinder-thesis/table-42.json",
    "twin-cylinder-thesis/table-43.json",
    "twin-cylinder-thesis/table-44.json",
    "twin-cylinder-thesis/table-45.json",
    "twin-cylinder-thesis/table-46.json",
    "twin-cylinder-thesis/table-47.json",
    "twin-cylinder-thesis/table-48.json",
    "twin-cylinder-thesis/table-49.json",
    "twin-cylinder-thesis/table-50.json",
    "twin-cylinder-thesis/table-51.json",
    "twin-cylinder-thesis/table-52.json",
    "twin-cylinder-thesis/table-53.json",
    "twin-cylinder-thesis/table-54.json",
    "twin-cylinder-thesis/table-55.json",
    "twin-cylinder-thesis/section-5.json",
    "twin-cylinder-thesis/text.json",
    "three-four-cylinder-thesis/source.json",
    "three-four-cylinder-thesis/four-cylinder.toml",
    "three-four-cylinder-thesis/four-cylinder-simulated.toml",
    "three-four-cylinder-thesis/three-cylinder.toml",
    "three-four-cylinder-thesis/three-cylinder-simulated.toml",
    "three-four-cylinder-thesis/table-3.1.json",
    "three-four-cylinder-thesis/table-3.2.json",
    "three-four-cylinder-thesis/table-3.3.json",
    "three-four-cylinder-thesis/tables-3.4-3.8.json",
    "three-four-cylinder-thesis/section-3.6.json",
    "three-four-cylinder-thesis/table-4.2.json",
    "three-four-cylinder-thesis/table-4.3.json",
    "three-four-cylinder-thesis/table-4.4.json",
    "three-four-cylinder-thesis/table-3.9.json",
    "three-four-cylinder-thesis/figures-3.23-3.27.json",
    "three-four-cylinder-thesis/figures-4.12-4.16.json",
    "flexible-paper/source.json",
    "flexible-paper/single.toml",
    "flexible-paper/rigid-run.toml",
    "flexible-paper/three-mains.toml",
    "flexible-paper/two-mains.toml",
    "flexible-paper/thin-web.toml",
    "flexible-paper/bearing-films.json",
    "flexible-paper/crankpin.json",
    "flexible-paper/text.json",
    "flexible-paper/static-case.json",
    "balancing-tool-paper/source.json",
    "balancing-tool-paper/in-line-three.toml",
    "balancing-tool-paper/v4-90.toml",
    "balancing-tool-paper/table-2.json",
    "balancing-tool-paper/table-3.json",
    "balancing-tool-paper/table-5.json",
    "balancing-tool-paper/text.json",
    "two-plane-example/source.json",
    "two-plane-example/two-planes.toml",
    "two-plane-example/two-planes.json",
    "balance-grade-example/source.json",
    "balance-grade-example/tool-holder.toml",
    "balance-grade-example/grade.json",
    "bobweight-example/source.json",
    "bobweight-example/ford-400.toml",
    "bobweight-example/bobweight.json",
    "torsional-chains/source.json",
    "torsional-chains/marine-geared-set.toml",
    "torsional-chains/marine-geared-set.json",
    "torsional-chains/six-masses.toml",
    "torsional-chains/six-masses.json",
    "modelica-engines/source.json",
    "modelica-engines/v6.toml",
    "modelica-engines/single-gas.toml",
    "modelica-engines/single.toml",
    "modelica-engines/slider-crank.toml",
    "modelica-engines/v6.json",
    "modelica-engines/single-gas.json",
    "modelica-engines/single.json",
    "modelica-engines/slider-crank.json",
    "oil-films/source.json",
    "oil-films/finite-films.json",
    "oil-films/short-bearing.json",
    "mechanisms/source.json",
    "mechanisms/squeezer.json",
];

/// The synthetic pressure traces, and gas laws of others as traces, by the names under which engine files ask for them.
pub(crate) const TRACES: [(&str, &str); 6] = [
    ("pressure-1000.csv", include_str!("../../../validation/traces/pressure-1000.csv")),
    ("pressure-2000.csv", include_str!("../../../validation/traces/pressure-2000.csv")),
    ("pressure-3000.csv", include_str!("../../../validation/traces/pressure-3000.csv")),
    ("pressure-4000.csv", include_str!("../../../validation/traces/pressure-4000.csv")),
    ("../traces/modelica-v6.csv", include_str!("../../../validation/traces/modelica-v6.csv")),
    ("../traces/modelica-single.csv", include_str!("../../../validation/traces/modelica-single.csv")),
];

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
                    .filter(|(name, _)| name.ends_with(".json") && *name != "source.json")
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
    use std::path::Path;

    #[test]
    fn every_file_of_the_folder_is_embedded_once() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
        let mut found = Vec::new();
        for source in std::fs::read_dir(folder).unwrap() {
            let source = source.unwrap().path();
            // Other folders hold evidence that tests read, not printed numbers.
            if !source.join("source.json").is_file() {
                continue;
            }
            for file in std::fs::read_dir(&source).unwrap() {
                let file = file.unwrap().path();
                let name = |p: &Path| p.file_name().unwrap().to_str().unwrap().to_string();
                if name(&file) != "README.md" {
                    found.push(format!("{}/{}", name(&source), name(&file)));
                }
            }
        }
        let mut embedded: Vec<_> = FILES.iter().map(|(path, _)| path.to_string()).collect();
        found.sort();
        embedded.sort();
        assert_eq!(found, embedded);
    }

    #[test]
    fn files_can_be_read_and_explain_what_is_no_match() {
        for source in sources() {
            // Mechanisms and films that are no engines stand alone.
            let has_engines =
                ["mechanisms", "oil-films"].contains(&source.key.as_str()) || !source.engines.is_empty();
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
