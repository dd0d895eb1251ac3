//! Packages of others: the crates of the lock file, and what the studio's page is built from.

use crate::command::{cargo, quiet};
use crate::workspace::root;
use anyhow::{Context, Result};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A package that is not ours.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Package {
    pub name: String,
    pub version: String,
    /// Its licence, as an SPDX expression.
    pub licence: Option<String>,
    /// Where its files are.
    pub folder: PathBuf,
    /// The registry that it comes from.
    pub source: String,
}

/// The graph of all crates, as cargo resolves it for every platform.
pub struct Crates(Value);

impl Crates {
    pub fn read() -> Result<Crates> {
        let text =
            quiet(cargo().args(["metadata", "--format-version", "1", "--locked"]).current_dir(root()))?;
        Ok(Crates(serde_json::from_str(&text).context("cargo metadata did not print JSON")?))
    }

    fn list(&self, pointer: &str) -> &[Value] {
        self.0.pointer(pointer).and_then(Value::as_array).map_or(&[], Vec::as_slice)
    }

    /// Our own packages.
    pub fn own(&self) -> Vec<&Value> {
        self.list("/packages").iter().filter(|package| package["source"].is_null()).collect()
    }

    /// Every crate of others.
    pub fn others(&self) -> Result<Vec<Package>> {
        let others = self.list("/packages").iter().filter(|package| !package["source"].is_null());
        others.map(package).collect()
    }

    /// The crates of others that the program is linked from, or that write code of it.
    pub fn of_program(&self) -> Result<Vec<Package>> {
        let nodes: BTreeMap<&str, &Value> = self
            .list("/resolve/nodes")
            .iter()
            .filter_map(|node| Some((node["id"].as_str()?, node)))
            .collect();
        let root = self.own().into_iter().find(|package| package["name"] == "lanchester-cli");
        let root = root.and_then(|package| package["id"].as_str()).context("there is no lanchester-cli")?;
        let (mut found, mut waiting) = (BTreeSet::from([root]), vec![root]);
        while let Some(id) = waiting.pop() {
            let node = nodes.get(id).with_context(|| format!("{id} is not resolved"))?;
            for other in node["deps"].as_array().map_or(&[][..], Vec::as_slice) {
                let kinds = other["dep_kinds"].as_array().map_or(&[][..], Vec::as_slice);
                let is_normal = kinds.iter().any(|kind| kind["kind"].is_null());
                if let Some(id) = other["pkg"].as_str().filter(|id| is_normal && found.insert(id)) {
                    waiting.push(id);
                }
            }
        }
        let all = self.list("/packages").iter();
        let linked = all.filter(|package| package["id"].as_str().is_some_and(|id| found.contains(id)));
        let mut packages: Vec<Package> =
            linked.filter(|package| !package["source"].is_null()).map(package).collect::<Result<_>>()?;
        packages.sort();
        Ok(packages)
    }
}

fn package(value: &Value) -> Result<Package> {
    let text = |key: &str| value[key].as_str().map(str::to_owned);
    let manifest = PathBuf::from(text("manifest_path").context("a crate has no manifest")?);
    Ok(Package {
        name: text("name").context("a crate has no name")?,
        version: text("version").context("a crate has no version")?,
        licence: text("license"),
        folder: manifest.parent().map(Path::to_path_buf).unwrap_or_default(),
        source: text("source").unwrap_or_default(),
    })
}

/// The packages that the page imports, and those that they need. They must be installed.
pub fn of_page() -> Result<Vec<Package>> {
    let page = root().join("crates/studio/page");
    let lock = std::fs::read_to_string(page.join("package-lock.json"))?;
    let lock: Value = serde_json::from_str(&lock).context("package-lock.json is no JSON")?;
    let mut waiting = imports(&page.join("src"))?;
    waiting.insert("svelte".to_owned());
    let mut waiting: Vec<String> = waiting.into_iter().collect();
    let mut packages = BTreeMap::new();
    while let Some(name) = waiting.pop() {
        let place = format!("node_modules/{name}");
        let Some(entry) = lock["packages"].get(&place) else { continue };
        if packages.contains_key(&name) {
            continue;
        }
        let needed = entry["dependencies"].as_object().into_iter().flat_map(|needed| needed.keys().cloned());
        waiting.extend(needed);
        let text = |key: &str| entry[key].as_str().map(str::to_owned);
        let package = Package {
            name: name.clone(),
            version: text("version").unwrap_or_default(),
            licence: text("license"),
            folder: page.join(place),
            source: "npm".to_owned(),
        };
        packages.insert(name, package);
    }
    Ok(packages.into_values().collect())
}

/// Names of packages that sources import: `import x from "three/addons/y"` names three.
fn imports(folder: &Path) -> Result<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).with_context(|| format!("cannot read {}", next.display()))? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.to_string_lossy();
            if !(name.ends_with(".ts") || name.ends_with(".svelte")) || name.ends_with(".test.ts") {
                continue;
            }
            found.extend(std::fs::read_to_string(&path)?.lines().filter_map(imported));
        }
    }
    Ok(found)
}

/// The package that a line imports, if it imports one.
fn imported(line: &str) -> Option<String> {
    let after = line
        .split_once(" from \"")
        .or_else(|| line.split_once("import(\""))
        .or_else(|| line.split_once("import \""))?
        .1;
    let path = after.split('"').next()?;
    if path.starts_with(['.', '/', '$']) || path.is_empty() {
        return None;
    }
    let mut parts = path.split('/');
    let first = parts.next()?;
    Some(match first.starts_with('@') {
        true => format!("{first}/{}", parts.next()?),
        false => first.to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_name_packages() {
        let name = |line: &str| imported(line);
        assert_eq!(name("import { scaleLinear } from \"d3-scale\";").as_deref(), Some("d3-scale"));
        assert_eq!(name("} from \"three/addons/a.js\";").as_deref(), Some("three"));
        assert_eq!(name("import { lint } from \"@codemirror/lint\";").as_deref(), Some("@codemirror/lint"));
        assert_eq!(name("const m = await import(\"three\");").as_deref(), Some("three"));
        assert_eq!(name("import { a } from \"./a\";"), None);
        assert_eq!(name("const a = 1;"), None);
    }
}
