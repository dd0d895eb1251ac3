//! The book's table of tolerances: every small number by which the program decides that something is rounding, equal, closed or gone.
//!
//! It is read from the sources, so that it cannot miss one: each constant that is a plain number of at most [`LARGEST`], with what its
//! documentation says of it.

use crate::workspace::{self, root};
use anyhow::{Context, Result, bail};
use std::fmt::Write;

/// The page.
const PAGE: &str = "docs/src/theory/tolerances.md";
/// Larger constants are sizes, not tolerances.
const LARGEST: f64 = 1e-2;

/// A constant of the sources.
struct Tolerance {
    file: String,
    name: String,
    value: String,
    meaning: String,
}

/// Writes the page.
pub fn write() -> Result<()> {
    std::fs::write(root().join(PAGE), page()?)?;
    println!("{PAGE}");
    Ok(())
}

/// Fails where the page is not what the sources say now.
pub fn check() -> Result<()> {
    let kept = std::fs::read_to_string(root().join(PAGE)).with_context(|| format!("cannot read {PAGE}"))?;
    if kept != page()? {
        bail!("stale: {PAGE}; run `cargo xtask generate`");
    }
    Ok(())
}

fn page() -> Result<String> {
    let mut all = Vec::new();
    for file in workspace::files()? {
        let is_ours = file.starts_with("crates/") && file.ends_with(".rs") && file.contains("/src/");
        if !is_ours || file.contains("/tests") || file.contains("/testkit/") {
            continue;
        }
        if let Some(text) = workspace::text(&file)? {
            all.extend(tolerances_of(&file, &text)?);
        }
    }
    let mut page = String::from(
        "# Tolerances\n\nEvery small number by which the program decides that something is rounding, equal, closed or gone. The table is read from \
         the sources; a share is one of what the text names, and has no unit. What a user may choose instead (`--tolerance`, `--gap`) is in the \
         help of the commands.\n",
    );
    let mut room = "";
    for tolerance in &all {
        let own = tolerance.file.split('/').nth(1).unwrap_or_default();
        if own != room {
            room = own;
            write!(page, "\n## `{room}`\n\n| value | what it decides | where |\n|---|---|---|\n")?;
        }
        let place = tolerance.file.splitn(4, '/').nth(3).unwrap_or_default();
        let meaning = tolerance.meaning.replace('|', "\\|").replace("[`", "`").replace("`]", "`");
        writeln!(page, "| {} | {meaning} | `{}` in `{place}` |", tolerance.value, tolerance.name)?;
    }
    Ok(page)
}

/// The constants of a file, its tests left out; one without documentation is an error.
fn tolerances_of(file: &str, text: &str) -> Result<Vec<Tolerance>> {
    let mut found = Vec::new();
    let mut meaning: Vec<&str> = Vec::new();
    for line in text.lines().map(str::trim) {
        if line.starts_with("#[cfg(test)]") {
            break;
        }
        if let Some(words) = line.strip_prefix("///") {
            meaning.push(words.trim());
            continue;
        }
        if line.starts_with("#[") {
            continue;
        }
        let Some((name, value)) = constant(line) else {
            // Constants beside one another share what stands above the first.
            if !line.contains("const ") {
                meaning.clear();
            }
            continue;
        };
        if value.replace('_', "").parse::<f64>().is_ok_and(|value| value > 0.0 && value <= LARGEST) {
            if meaning.is_empty() {
                bail!(
                    "{file}: {name} = {value} has no documentation, which the book's table of tolerances needs"
                );
            }
            let meaning = meaning.join(" ");
            let (name, value, file) = (name.to_owned(), value.to_owned(), file.to_owned());
            found.push(Tolerance { file, name, value, meaning });
        }
    }
    Ok(found)
}

/// Name and value of a line that defines a plain number.
fn constant(line: &str) -> Option<(&str, &str)> {
    let (before, rest) = line.split_once("const ")?;
    if !(before.is_empty() || before.starts_with("pub")) {
        return None;
    }
    let (name, rest) = rest.split_once(": f64 = ")?;
    Some((name, rest.strip_suffix(';')?))
}

#[cfg(test)]
mod tests {
    use super::tolerances_of;

    #[test]
    fn small_constants_are_found_with_what_they_mean() {
        let text = "/// Angles closer than this\n/// are one [rad].\npub(super) const SAME: f64 = 1e-9;\nconst FINER: f64 = 1e-12;\n\n/// A size.\nconst \
                    WIDE: f64 = 3.0;\n#[cfg(test)]\nmod tests {\n    const HIDDEN: f64 = 1e-3;\n}\n";
        let found = tolerances_of("crates/model/src/angle.rs", text).expect("all are documented");
        let told: Vec<_> =
            found.iter().map(|t| (t.name.as_str(), t.value.as_str(), t.meaning.as_str())).collect();
        let meaning = "Angles closer than this are one [rad].";
        assert_eq!(told, [("SAME", "1e-9", meaning), ("FINER", "1e-12", meaning)]);
        assert!(tolerances_of("crates/model/src/angle.rs", "\nconst SAME: f64 = 1e-9;\n").is_err());
    }
}
