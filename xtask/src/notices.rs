//! Notices of third parties: who wrote what the program and its page contain, and under which licence.

use crate::licence::is_allowed;
use crate::packages::{Crates, Package, of_page};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The file, which the program prints and the studio serves.
const FILE: &str = "crates/studio/third-party.txt";

/// How files of licences and notices are called.
const NAMES: [&str; 6] = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"];

const RULE: &str = "================================================================================";

/// Writes the file.
pub fn write() -> Result<String> {
    let text = text()?;
    std::fs::write(root().join(FILE), &text)?;
    Ok(format!("{FILE}, {} kB", text.len() / 1000))
}

/// Fails where the file is not what the lock files and the installed packages give.
pub fn check() -> Result<String> {
    let text = text()?;
    let kept = std::fs::read_to_string(root().join(FILE)).with_context(|| format!("cannot read {FILE}"))?;
    ensure!(kept == text, "{FILE} is stale; run `cargo xtask notices`");
    Ok(format!("{} kB", text.len() / 1000))
}

fn text() -> Result<String> {
    let crates = Crates::read()?.of_program()?;
    let page = of_page()?;
    let mut out = String::from(
        "Notices of third parties\n\n\
         Lanchester is under MIT OR Apache-2.0. The program contains the crates listed first, for one platform or\n\
         another; the page of the studio contains the packages listed next. Their licences and notices follow, each\n\
         text once.\n",
    );
    // By their words: the same licence comes with many line breaks.
    let mut texts: BTreeMap<String, (String, Vec<String>)> = BTreeMap::new();
    for (title, packages) in [("Crates", &crates), ("Packages of the page", &page)] {
        let _ = write!(out, "\n{title}\n\n");
        for package in packages {
            let name = format!("{} {}", package.name, package.version);
            let licence = package.licence.as_deref().unwrap_or("licence: see its text below");
            let _ = writeln!(out, "  {name}: {licence}");
            for text in licences(package)? {
                let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
                texts.entry(words).or_insert_with(|| (text, Vec::new())).1.push(name.clone());
            }
        }
    }
    // The longest lists first, so that the common texts stand in front.
    let mut texts: Vec<(String, Vec<String>)> = texts.into_values().collect();
    texts.sort_by(|a, b| b.1.len().cmp(&a.1.len()).then_with(|| (&a.1, &a.0).cmp(&(&b.1, &b.0))));
    for (text, mut names) in texts {
        names.dedup();
        let _ = write!(out, "\n{RULE}\n");
        let mut line = String::new();
        for (k, name) in names.iter().enumerate() {
            let end = if k + 1 < names.len() { "," } else { ":" };
            if line.len() + name.len() > 110 {
                let _ = writeln!(out, "{}", line.trim_end());
                line.clear();
            }
            let _ = write!(line, "{name}{end} ");
        }
        let _ = write!(out, "{}\n\n{text}\n", line.trim_end());
    }
    Ok(out)
}

/// The texts that a package brings, of MIT alone where it gives that choice, and its notices; where it brings none, the text that its licence asks for with its name in it.
fn licences(package: &Package) -> Result<Vec<String>> {
    let mut found = Vec::new();
    let licence = package.licence.as_deref().unwrap_or_default();
    let takes_mit = is_allowed(licence, &["MIT".to_owned()]);
    let mut names = Vec::new();
    let entries = std::fs::read_dir(&package.folder)
        .with_context(|| format!("{} is not there: install it first", package.folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        let is_source = name.ends_with(".RS") || name.ends_with(".HTML") || name.ends_with(".TOML");
        if path.is_file() && !is_source && NAMES.iter().any(|start| name.starts_with(start)) {
            names.push((name, path));
        }
    }
    let is_other =
        |name: &str| !name.contains("MIT") && !name.starts_with("NOTICE") && !name.starts_with("COPYRIGHT");
    let brings_mit = names.iter().any(|(name, _)| name.contains("MIT"));
    names.retain(|(name, _)| !(takes_mit && brings_mit && is_other(name)));
    for (_, path) in names {
        let text = String::from_utf8_lossy(&std::fs::read(&path)?).into_owned();
        found.push(tidied(&text));
    }
    found.sort();
    found.dedup();
    if found.is_empty() {
        let mit = std::fs::read_to_string(root().join("LICENSE-MIT"))?;
        let apache = std::fs::read_to_string(root().join("LICENSE-APACHE"))?;
        if licence.contains("MIT") {
            let line = mit.lines().find(|line| line.starts_with("Copyright")).unwrap_or_default();
            found.push(tidied(&mit.replace(line, &format!("Copyright (c) the authors of {}", package.name))));
        } else if licence.contains("Apache-2.0") {
            found.push(tidied(&apache));
        }
    }
    ensure!(!found.is_empty(), "{} {} has no text of its licence", package.name, package.version);
    Ok(found)
}

/// The text without carriage returns, trailing blanks and empty lines at its ends.
fn tidied(text: &str) -> String {
    let text = text.replace(['\r', '\u{feff}', '\u{c}'], "");
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}
