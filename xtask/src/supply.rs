//! `cargo xtask supply`: what comes from others has an allowed licence, an allowed source and no advisory that nobody has looked at.
//!
//! The rules stand in `deny.toml`, which cargo-deny reads too; where that is installed it runs as well.

use crate::command::{cargo, exists, quiet};
use crate::packages::{Crates, Package, of_page};
use crate::workspace::root;
use crate::{advisories, licence};
use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use serde_json::Value;

/// The one registry, as lock files name it.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// What we read of `deny.toml`.
#[derive(Debug, Deserialize)]
struct Rules {
    advisories: AdvisoryRules,
    licenses: LicenceRules,
    bans: BanRules,
}

#[derive(Debug, Deserialize)]
struct AdvisoryRules {
    ignore: Vec<Ignored>,
}

#[derive(Debug, Deserialize)]
struct Ignored {
    id: String,
}

#[derive(Debug, Deserialize)]
struct LicenceRules {
    allow: Vec<String>,
}

#[derive(Debug, Deserialize)]
struct BanRules {
    deny: Vec<Banned>,
}

#[derive(Debug, Deserialize)]
struct Banned {
    #[serde(rename = "crate")]
    name: String,
}

/// All rules; with `page`, the licences of the page's packages too, which must be installed for that.
pub fn check(page: bool) -> Result<String> {
    let text = std::fs::read_to_string(root().join("deny.toml")).context("cannot read deny.toml")?;
    let rules: Rules = basic_toml::from_str(&text).context("deny.toml")?;
    let crates = Crates::read()?;
    let others = crates.others()?;
    let mut faults = faults(&rules, &others, &crates.own());
    if page {
        faults.extend(of_page()?.iter().filter_map(|package| unlicensed(&rules, package)));
    }
    ensure!(faults.is_empty(), "{}", faults.join("\n"));
    let ignored: Vec<String> = rules.advisories.ignore.into_iter().map(|ignored| ignored.id).collect();
    let advisories = advisories::check(&others, &ignored)?;
    let denied = match exists("cargo-deny") {
        true => {
            let mut deny = cargo();
            deny.args(["deny", "--offline", "check", "licenses", "bans", "sources"]).current_dir(root());
            quiet(&mut deny)?;
            "cargo-deny agrees"
        }
        false => "cargo-deny is not installed",
    };
    Ok(format!("{} crates, {advisories}; {denied}", others.len()))
}

fn unlicensed(rules: &Rules, package: &Package) -> Option<String> {
    let licence = package.licence.as_deref().unwrap_or_default();
    let allowed = licence::is_allowed(licence, &rules.licenses.allow);
    (!allowed).then(|| format!("{} {}: licence `{licence}` is not allowed", package.name, package.version))
}

fn faults(rules: &Rules, others: &[Package], own: &[&Value]) -> Vec<String> {
    let mut faults = Vec::new();
    for other in others {
        let name = format!("{} {}", other.name, other.version);
        faults.extend(unlicensed(rules, other));
        if other.source != REGISTRY {
            faults.push(format!("{name}: source `{}` is not allowed", other.source));
        }
        if rules.bans.deny.iter().any(|banned| banned.name == other.name) {
            faults.push(format!("{name} is banned"));
        }
    }
    for package in own {
        for dependency in package["dependencies"].as_array().map_or(&[][..], Vec::as_slice) {
            if dependency["req"] == "*" && dependency["path"].is_null() {
                faults.push(format!("{} takes any version of {}", package["name"], dependency["name"]));
            }
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_rule_finds_what_breaks_it() {
        let rules: Rules = basic_toml::from_str(
            "[advisories]\nignore = []\n[licenses]\nallow = [\"MIT\"]\n[bans]\ndeny = [{ crate = \"brake\" }]\n",
        )
        .unwrap();
        let package = |name: &str, licence: &str, source: &str| Package {
            name: name.into(),
            version: "1.0.0".into(),
            licence: Some(licence.into()),
            folder: "".into(),
            source: source.into(),
        };
        let good = package("wheel", "MIT OR GPL-3.0", REGISTRY);
        let found = |other: Package, own: &[&Value]| faults(&rules, &[other], own);
        assert!(found(good.clone(), &[]).is_empty());
        assert_eq!(found(package("wheel", "GPL-3.0", REGISTRY), &[]).len(), 1);
        assert_eq!(found(Package { licence: None, ..good.clone() }, &[]).len(), 1);
        assert_eq!(found(package("brake", "MIT", REGISTRY), &[]).len(), 1);
        assert_eq!(found(package("wheel", "MIT", "git+https://example.org/wheel"), &[]).len(), 1);
        let own = json!({ "name": "car", "dependencies": [{ "name": "wheel", "req": "*", "path": null }] });
        assert_eq!(found(good.clone(), &[&own]).len(), 1);
        let own = json!({ "name": "car", "dependencies": [{ "name": "axle", "req": "*", "path": "/axle" }] });
        assert!(found(good, &[&own]).is_empty());
    }
}
