//! The crates as packages of a registry: whole, described, and such that the program compiles from nothing but them.

use super::release::VERSION;
use crate::command::{cargo, in_view, quiet};
use crate::workspace::{metadata, root, scratch, target, text};
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Most bytes of a package that the registry takes.
const LARGEST: u64 = 10 << 20;

/// It embeds most files and needs no other crate: compiled from its package in every check.
const COMPILED: &str = "lanchester-data";

/// What every package must hold, beside its README.
const HELD: [&str; 3] = ["Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT"];

/// Files that name the version, and what stands before and behind it there.
const NAMED: [(&str, (&str, &str)); 3] = [
    ("CITATION.cff", ("version: ", "\n")),
    ("docs/src/guide/install.md", ("lanchester_", "_amd64.deb")),
    ("docs/src/guide/install.md", ("lanchester-", "-x86_64-linux.tar.gz")),
];

/// A crate in its package.
struct Package {
    name: String,
    bytes: u64,
}

/// Packs every crate that is published and looks whether its package is whole; they are told in the order of publication.
pub fn check() -> Result<String> {
    Ok(told(&packed(&scratch("packages")?)?))
}

/// The same, and compiles the program from the packages alone.
pub fn compile() -> Result<String> {
    let folder = scratch("packages")?;
    let packages = packed(&folder)?;
    let mut manifest =
        String::from("[workspace]\nresolver = \"3\"\nmembers = [\"lanchester*\"]\n\n[patch.crates-io]\n");
    for Package { name, .. } in &packages {
        manifest += &format!("{name} = {{ path = \"{name}-{VERSION}\" }}\n");
    }
    fs::write(folder.join("Cargo.toml"), manifest)?;
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock"))?;
    let mut checks = cargo();
    checks.args(["check", "--package", "lanchester-cli", "--target-dir"]).arg(target()?.join("packages"));
    in_view(checks.current_dir(&folder))?;
    Ok(format!("{}\nthe program compiles from the packages alone", told(&packages)))
}

fn told(packages: &[Package]) -> String {
    let names: Vec<&str> = packages.iter().map(|package| package.name.as_str()).collect();
    let bytes: u64 = packages.iter().map(|package| package.bytes).sum();
    format!("{} packages, {:.1} MB: {}", packages.len(), bytes as f64 / 1e6, names.join(", "))
}

/// The packages, each behind those that it needs, unpacked into a folder.
fn packed(into: &Path) -> Result<Vec<Package>> {
    let metadata = metadata()?;
    let mut faults = faults(&metadata);
    for (file, words) in NAMED {
        let text = text(file)?.with_context(|| format!("{file} is not UTF-8"))?;
        faults.extend(unnamed(file, &text, words));
    }
    ensure!(faults.is_empty(), "{}", faults.join("\n"));
    let published = in_order(&metadata)?;
    let mut packs = cargo();
    packs.args(["package", "--no-verify", "--allow-dirty", "--exclude-lockfile", "--quiet"]);
    for package in &published {
        packs.args(["--package", name(package)]);
    }
    quiet(packs.current_dir(root()))?;
    let folder = target()?.join("package");
    let mut packages = Vec::new();
    for published in published {
        let name = name(published).to_owned();
        let file = folder.join(format!("{name}-{VERSION}.crate"));
        let bytes = fs::metadata(&file).with_context(|| format!("no package {}", file.display()))?.len();
        if bytes > LARGEST {
            faults.push(format!("{name}: {bytes} bytes, the registry takes {LARGEST}"));
        }
        quiet(Command::new("tar").arg("--extract").arg("--file").arg(&file).arg("--directory").arg(into))?;
        let inside = into.join(format!("{name}-{VERSION}"));
        let readme = published["readme"].as_str();
        for held in HELD.into_iter().chain(readme).filter(|held| !is_whole(&inside, held)) {
            faults.push(format!("{name}: its package has no {held}"));
        }
        faults.extend(outside(&inside, &inside)?);
        packages.push(Package { name, bytes });
    }
    ensure!(faults.is_empty(), "{}", faults.join("\n"));
    let mut compiles = cargo();
    compiles.args(["package", "--allow-dirty", "--offline", "--quiet", "--package", COMPILED]);
    quiet(compiles.current_dir(root()))?;
    Ok(packages)
}

/// Whether a package has a file; licences are links in the repository, and must be the texts in the package.
fn is_whole(inside: &Path, held: &str) -> bool {
    let is_licence = held.starts_with("LICENSE");
    match fs::read(inside.join(held)) {
        Ok(bytes) => !is_licence || fs::read(root().join(held)).is_ok_and(|original| original == bytes),
        Err(_) => false,
    }
}

fn published(metadata: &Value) -> Vec<&Value> {
    let packages = metadata["packages"].as_array().map_or(&[][..], Vec::as_slice);
    packages.iter().filter(|package| package["publish"].is_null()).collect()
}

fn name(package: &Value) -> &str {
    package["name"].as_str().unwrap_or_default()
}

fn dependencies(package: &Value) -> &[Value] {
    package["dependencies"].as_array().map_or(&[][..], Vec::as_slice)
}

/// What manifests lack, from the output of `cargo metadata --no-deps`.
fn faults(metadata: &Value) -> Vec<String> {
    let published = published(metadata);
    let names: BTreeSet<&str> = published.iter().map(|package| name(package)).collect();
    let members = metadata["packages"].as_array().map_or(&[][..], Vec::as_slice);
    let is_ours = |name: &str| members.iter().any(|package| package["name"] == name);
    let mut faults = Vec::new();
    for package in published {
        let name = name(package);
        for key in ["description", "license", "readme", "keywords", "categories"] {
            let value = &package[key];
            if value.as_str().is_none_or(str::is_empty) && value.as_array().is_none_or(Vec::is_empty) {
                faults.push(format!("{name}: its manifest has no {key}"));
            }
        }
        if package["version"] != VERSION {
            faults.push(format!("{name}: version {}, the workspace has {VERSION}", package["version"]));
        }
        for dependency in dependencies(package) {
            let other = dependency["name"].as_str().unwrap_or_default();
            let (is_for_tests, needs) = (dependency["kind"] == "dev", &dependency["req"]);
            if !is_ours(other) {
                continue;
            } else if is_for_tests && needs != "*" {
                faults.push(format!(
                    "{name}: its tests name {other} with a version: packages would form a circle"
                ));
            } else if !is_for_tests && !names.contains(other) {
                faults.push(format!("{name}: needs {other}, which is not published"));
            } else if !is_for_tests && *needs != format!("^{VERSION}") {
                faults.push(format!("{name}: needs {other} {needs}, the workspace has {VERSION}"));
            }
        }
    }
    faults
}

/// The fault of a file that has not the version of the workspace between these words.
fn unnamed(file: &str, text: &str, (before, after): (&str, &str)) -> Option<String> {
    let words = format!("{before}{VERSION}{after}");
    (!text.contains(&words))
        .then(|| format!("{file}: does not say `{words}`, as the version of the workspace wants"))
}

/// What is published, each behind those that it needs.
fn in_order(metadata: &Value) -> Result<Vec<&Value>> {
    let mut waiting = published(metadata);
    let mut ordered = Vec::new();
    while !waiting.is_empty() {
        let left: BTreeSet<&str> = waiting.iter().map(|package| name(package)).collect();
        let (ready, rest): (Vec<&Value>, Vec<&Value>) = waiting.into_iter().partition(|package| {
            let mut needed = dependencies(package).iter().filter(|dependency| dependency["kind"] != "dev");
            !needed.any(|dependency| left.contains(name(dependency)))
        });
        ensure!(!ready.is_empty(), "these crates need one another in a circle: {left:?}");
        ordered.extend(ready);
        waiting = rest;
    }
    Ok(ordered)
}

/// Files that code embeds and that the package in `inside` lacks. Tests stay in the repository.
fn outside(inside: &Path, folder: &Path) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            faults.extend(outside(inside, &path)?);
        } else if path.extension().is_some_and(|ending| ending == "rs") && !path.ends_with("tests.rs") {
            let text = fs::read_to_string(&path)?;
            let lacking = embedded(&text).filter(|name| !folder.join(name).is_file());
            let file = path.strip_prefix(inside.parent().unwrap_or(inside))?.display().to_string();
            faults.extend(lacking.map(|name| format!("{file}: embeds {name}, which is not in the package")));
        }
    }
    Ok(faults)
}

/// Files that code embeds by name. A test module is the last item of its file, and comments embed nothing.
fn embedded(text: &str) -> impl Iterator<Item = &str> {
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(text);
    let calls = code.split("include_str!(").chain(code.split("include_bytes!("));
    let is_comment = |before: &str| before.rsplit('\n').next().is_some_and(|line| line.contains("//"));
    let mut before = "";
    calls.filter_map(move |after| {
        let commented = is_comment(std::mem::replace(&mut before, after));
        let name = after.trim_start().strip_prefix('"')?.split('"').next()?;
        (!commented).then_some(name)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn crate_of(name: &str, needs: &[(&str, &str, Option<&str>)]) -> Value {
        let needs: Vec<Value> =
            needs.iter().map(|(name, req, kind)| json!({ "name": name, "req": req, "kind": kind })).collect();
        json!({
            "name": name, "version": VERSION, "description": "a part", "license": "MIT", "readme": "README.md",
            "keywords": ["engine"], "categories": ["science"], "publish": null, "dependencies": needs,
        })
    }

    #[test]
    fn what_a_manifest_lacks_is_told() {
        let own = format!("^{VERSION}");
        let told = |packages: &[Value]| faults(&json!({ "packages": packages }));
        let rod = || crate_of("rod", &[]);
        let crank = |needs: &str, kind| crate_of("crank", &[("rod", needs, kind), ("serde", "^1", None)]);
        assert!(told(&[rod(), crank(&own, None)]).is_empty());
        assert!(told(&[rod(), crank("*", Some("dev"))]).is_empty());
        assert_eq!(told(&[rod(), crank("*", None)]).len(), 1);
        assert_eq!(told(&[rod(), crank(&own, Some("dev"))]).len(), 1);
        let mut private = rod();
        private["publish"] = json!([]);
        assert_eq!(told(&[private.clone(), crank(&own, None)]), ["crank: needs rod, which is not published"]);
        assert!(told(&[private, crank("*", Some("dev"))]).is_empty());
        for (key, value) in
            [("description", json!(null)), ("keywords", json!([])), ("version", json!("0.0.1"))]
        {
            let mut bare = rod();
            bare[key] = value;
            assert_eq!(told(&[bare]).len(), 1, "{key}");
        }
        let words = ("lanchester_", "_amd64.deb");
        assert!(unnamed("a.md", &format!("dpkg --install lanchester_{VERSION}_amd64.deb"), words).is_none());
        assert!(unnamed("a.md", "dpkg --install lanchester_0.0.1_amd64.deb", words).is_some());
    }

    #[test]
    fn a_crate_is_published_behind_those_that_it_needs() {
        let own = format!("^{VERSION}");
        let (rod, crank) =
            (crate_of("rod", &[("crank", "*", Some("dev"))]), crate_of("crank", &[("rod", &own, None)]));
        let packages = json!({ "packages": [crank, rod] });
        let names: Vec<&str> = in_order(&packages).unwrap().into_iter().map(name).collect();
        assert_eq!(names, ["rod", "crank"]);
        let (rod, crank) =
            (crate_of("rod", &[("crank", &own, None)]), crate_of("crank", &[("rod", &own, None)]));
        assert!(in_order(&json!({ "packages": [crank, rod] })).is_err());
    }

    #[test]
    fn embedded_files_are_those_of_code() {
        let text = "const A: &str = include_str!(\"a.toml\");\n/// include_str!(\"b\")\nconst C: &[u8] = include_bytes!(\n    \"c\"\n);\n\
                    const D: &str = include_str!(concat!(\"d\"));\n#[cfg(test)]\nmod tests {\n    const E: &str = include_str!(\"e\");\n}\n";
        assert_eq!(embedded(text).collect::<Vec<_>>(), ["a.toml", "c"]);
    }
}
