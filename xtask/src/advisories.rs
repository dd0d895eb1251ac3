//! Security advisories of the crates in the lock file, from a stored snapshot of the RustSec database.

use crate::command::quiet;
use crate::packages::{Crates, Package};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use semver::{Version, VersionReq};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

const FILE: &str = "advisories.json";

/// What the database says of our crates, and of which.
#[derive(Debug, Serialize, Deserialize)]
pub struct Snapshot {
    /// The database.
    source: String,
    /// Its commit.
    commit: String,
    /// The day of that commit.
    date: String,
    /// Under which licence it is.
    licence: String,
    /// The crates that were looked up.
    crates: BTreeSet<String>,
    advisories: Vec<Advisory>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Advisory {
    id: String,
    package: String,
    date: String,
    title: String,
    /// "unmaintained", "unsound", "notice"; none: a vulnerability.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    informational: Option<String>,
    /// Versions that have the fix.
    patched: Vec<String>,
    /// Versions that never had the flaw.
    unaffected: Vec<String>,
}

/// The head of an advisory of the database, as it stands there.
#[derive(Debug, Deserialize)]
struct Entry {
    advisory: EntryHead,
    versions: EntryVersions,
}

#[derive(Debug, Deserialize)]
struct EntryHead {
    id: String,
    package: String,
    date: String,
    informational: Option<String>,
    withdrawn: Option<String>,
}

#[derive(Debug, Deserialize)]
struct EntryVersions {
    #[serde(default)]
    patched: Vec<String>,
    #[serde(default)]
    unaffected: Vec<String>,
}

/// Takes from a clone of the database what concerns the crates of the lock file.
pub fn write(clone: &Path) -> Result<String> {
    let git = |arguments: &[&str]| quiet(Command::new("git").arg("-C").arg(clone).args(arguments));
    let crates: BTreeSet<String> = Crates::read()?.others()?.into_iter().map(|other| other.name).collect();
    let commit = git(&["log", "-1", "--format=%H %cs"])?;
    let (commit, date) = commit.trim().split_once(' ').context("the clone has no commit")?;
    let mut advisories = Vec::new();
    for file in git(&["ls-tree", "-r", "--name-only", "HEAD", "crates"])?.lines() {
        let name = file.strip_prefix("crates/").and_then(|rest| rest.split('/').next()).unwrap_or_default();
        if crates.contains(name) {
            let text = git(&["show", &format!("HEAD:{file}")])?;
            advisories.extend(advisory(&text).with_context(|| file.to_owned())?);
        }
    }
    advisories.sort_by(|a, b| a.id.cmp(&b.id));
    let count = advisories.len();
    let snapshot = Snapshot {
        source: "https://github.com/rustsec/advisory-db".to_owned(),
        commit: commit.to_owned(),
        date: date.to_owned(),
        licence: "CC0-1.0; what comes from the GitHub Advisory Database: CC-BY-4.0".to_owned(),
        crates,
        advisories,
    };
    std::fs::write(root().join(FILE), serde_json::to_string_pretty(&snapshot)? + "\n")?;
    Ok(format!("{FILE}: {count} advisories of {} crates, {date}", snapshot.crates.len()))
}

/// An advisory of the database; none where it was withdrawn.
fn advisory(text: &str) -> Result<Option<Advisory>> {
    let head = text.split_once("```toml").and_then(|(_, rest)| rest.split_once("```"));
    let (head, body) = head.context("it has no head in TOML")?;
    let Entry { advisory, versions } = basic_toml::from_str(head)?;
    let title = body.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default().trim();
    Ok(advisory.withdrawn.is_none().then(|| Advisory {
        id: advisory.id,
        package: advisory.package,
        date: advisory.date,
        title: title.to_owned(),
        informational: advisory.informational,
        patched: versions.patched,
        unaffected: versions.unaffected,
    }))
}

impl Advisory {
    /// Whether a version has the flaw: neither fixed nor never affected.
    fn concerns(&self, version: &Version) -> Result<bool> {
        for range in self.patched.iter().chain(&self.unaffected) {
            let range = VersionReq::parse(range).with_context(|| format!("{}: `{range}`", self.id))?;
            if range.matches(version) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Fails where an advisory concerns a crate and is not in the list of those that are known and borne, or a crate was never looked up.
pub fn check(others: &[Package], ignored: &[String]) -> Result<String> {
    let text = std::fs::read_to_string(root().join(FILE)).with_context(|| format!("cannot read {FILE}"))?;
    let snapshot: Snapshot = serde_json::from_str(&text).context(FILE)?;
    let faults = faults(&snapshot, others, ignored)?;
    ensure!(faults.is_empty(), "{}", faults.join("\n"));
    Ok(format!("{} advisories of {}", snapshot.advisories.len(), snapshot.date))
}

fn faults(snapshot: &Snapshot, others: &[Package], ignored: &[String]) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    let mut met = BTreeSet::new();
    for other in others {
        if !snapshot.crates.contains(&other.name) {
            faults.push(format!(
                "{}: not in the snapshot of advisories; run `cargo xtask advisories CLONE` with a clone of {}",
                other.name, snapshot.source
            ));
        }
        let version = Version::parse(&other.version).with_context(|| other.name.clone())?;
        for advisory in snapshot.advisories.iter().filter(|advisory| advisory.package == other.name) {
            if !advisory.concerns(&version)? {
                continue;
            }
            met.insert(&advisory.id);
            if !ignored.contains(&advisory.id) {
                let what = advisory.informational.as_deref().unwrap_or("vulnerable");
                let patched = advisory.patched.join(", ");
                faults.push(format!(
                    "{} {version}: {} ({what}): {}; fixed in: {patched}",
                    other.name, advisory.id, advisory.title
                ));
            }
        }
    }
    for id in ignored.iter().filter(|id| !met.contains(id)) {
        faults.push(format!("{id} concerns no crate any more: take it out of deny.toml"));
    }
    Ok(faults)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENTRY: &str = "```toml\n[advisory]\nid = \"RUSTSEC-2099-0001\"\npackage = \"wheel\"\ndate = \"2099-01-02\"\n\
                         [versions]\npatched = [\"^0.9.3\", \">= 1.2\"]\nunaffected = [\"< 0.5\"]\n```\n\n# Comes off\n\nText.\n";

    fn wheel(version: &str) -> Vec<Package> {
        let version = version.to_owned();
        vec![Package { name: "wheel".into(), version, licence: None, folder: "".into(), source: "".into() }]
    }

    #[test]
    fn an_advisory_concerns_what_is_neither_fixed_nor_never_affected() {
        let advisory = advisory(ENTRY).unwrap().unwrap();
        assert_eq!((advisory.title.as_str(), advisory.informational.as_deref()), ("Comes off", None));
        for (version, concerns) in [
            ("0.4.9", false),
            ("0.5.0", true),
            ("0.9.2", true),
            ("0.9.5", false),
            ("1.1.0", true),
            ("1.2.0", false),
        ] {
            assert_eq!(advisory.concerns(&version.parse().unwrap()).unwrap(), concerns, "{version}");
        }
        assert!(
            super::advisory(&ENTRY.replace("[versions]", "withdrawn = \"2099-02-01\"\n[versions]"))
                .unwrap()
                .is_none()
        );
    }

    #[test]
    fn what_is_not_borne_and_what_is_borne_for_nothing_are_faults() {
        let snapshot = Snapshot {
            source: String::new(),
            commit: String::new(),
            date: String::new(),
            licence: String::new(),
            crates: BTreeSet::from(["wheel".to_owned()]),
            advisories: vec![advisory(ENTRY).unwrap().unwrap()],
        };
        let id = ["RUSTSEC-2099-0001".to_owned()];
        assert_eq!(faults(&snapshot, &wheel("1.0.0"), &[]).unwrap().len(), 1);
        assert!(faults(&snapshot, &wheel("1.0.0"), &id).unwrap().is_empty());
        assert!(faults(&snapshot, &wheel("1.3.0"), &[]).unwrap().is_empty());
        assert_eq!(faults(&snapshot, &wheel("1.3.0"), &id).unwrap().len(), 1);
        let other = vec![Package { name: "axle".into(), ..wheel("1.3.0").remove(0) }];
        assert!(faults(&snapshot, &other, &[]).unwrap()[0].contains("not in the snapshot"));
    }
}
