//! Rules on the written pages: listed, linked, numbered and sourced.

use crate::book::is_equation_number;
use crate::workspace::{self, root};
use anyhow::{Context, Result};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

const BOOK: &str = "docs/src/";
const SUMMARY: &str = "docs/src/SUMMARY.md";
const REFERENCES: &str = "docs/refs.bib";
/// Pages whose formulas have a picture beside them.
const THEORY: &str = "docs/src/theory/";

/// Breaches in the Markdown pages, and in the equation and source references of the code.
pub fn check(files: &[String]) -> Result<Vec<String>> {
    let mut breaches = Vec::new();
    let mut equations = BTreeMap::new();
    let mut pages = Vec::new();
    for file in files {
        let markdown = file.ends_with(".md") && !file.starts_with("validation/");
        let code = file.starts_with("crates/") && file.ends_with(".rs");
        if !(markdown || code) {
            continue;
        }
        let text = workspace::text(file)?.with_context(|| format!("{file} is not UTF-8"))?;
        if file.starts_with(BOOK) && markdown {
            for (number, line) in numbered_equations(&text) {
                if let Some(first) = equations.insert(number.clone(), format!("{file}:{line}")) {
                    breaches.push(format!("{file}:{line}: equation {number} already stands at {first}"));
                }
            }
        }
        pages.push((file.as_str(), text, markdown));
    }
    breaches.extend(unlisted(&pages)?);
    let sources = source_keys(&workspace::text(REFERENCES)?.unwrap_or_default());
    for (file, text, markdown) in &pages {
        if *markdown {
            breaches.extend(broken_links(file, text));
        }
        if file.starts_with(THEORY) && lacks_picture(text) {
            breaches.push(format!("{file}: formulas without a picture"));
        }
        for (number, line) in equation_references(text) {
            if !equations.contains_key(&number) {
                breaches.push(format!("{file}:{line}: equation {number} is not in the book"));
            }
        }
        for (key, line) in source_references(text) {
            if !sources.contains(&key) {
                breaches.push(format!("{file}:{line}: source [{key}] is not in {REFERENCES}"));
            }
        }
    }
    Ok(breaches)
}

/// Pages of the book that the summary does not list.
fn unlisted(pages: &[(&str, String, bool)]) -> Result<Vec<String>> {
    let summary = workspace::text(SUMMARY)?.unwrap_or_default();
    let listed: BTreeSet<PathBuf> = links(&summary)
        .into_iter()
        .map(|(target, _)| Path::new(BOOK).join(target))
        .map(|p| normal(&p))
        .collect();
    let missing = pages.iter().filter(|(file, _, markdown)| {
        *markdown && file.starts_with(BOOK) && *file != SUMMARY && !listed.contains(Path::new(file))
    });
    Ok(missing.map(|(file, _, _)| format!("{file}: not listed in {SUMMARY}")).collect())
}

/// Links to files that do not exist or to headings that the page does not have.
fn broken_links(file: &str, text: &str) -> Vec<String> {
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    let mut breaches = Vec::new();
    for (target, line) in links(text) {
        if target.contains("://") || target.starts_with("mailto:") {
            continue;
        }
        let (path, heading) = target.split_once('#').unwrap_or((&target, ""));
        let to = if path.is_empty() { PathBuf::from(file) } else { normal(&folder.join(path)) };
        if !root().join(&to).exists() {
            breaches.push(format!("{file}:{line}: link to {target}, which does not exist"));
        } else if !heading.is_empty() && to.extension().is_some_and(|e| e == "md") {
            let page = std::fs::read_to_string(root().join(&to)).unwrap_or_default();
            if !headings(&page).contains(heading) {
                breaches.push(format!("{file}:{line}: link to {target}, which has no such heading"));
            }
        }
    }
    breaches
}

/// Whether a page has formulas and no picture.
fn lacks_picture(text: &str) -> bool {
    text.contains("```formula\n") && !text.contains("\n![")
}

/// Lines outside fenced blocks, with inline code blanked out.
fn prose(text: &str) -> impl Iterator<Item = (String, usize)> {
    let mut fenced = false;
    text.lines().enumerate().filter_map(move |(index, line)| {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        let words = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
        (!fenced && !fence).then_some((words, index + 1))
    })
}

/// Targets of `[text](target)`.
fn links(text: &str) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    for (line, number) in prose(text) {
        for (start, _) in line.match_indices("](") {
            let rest = &line[start + 2..];
            if let Some(end) = rest.find(')') {
                found.push((rest[..end].to_owned(), number));
            }
        }
    }
    found
}

/// Anchors as mdBook and GitHub make them.
fn headings(page: &str) -> BTreeSet<String> {
    let titles = page.lines().filter(|line| line.starts_with('#'));
    titles
        .map(|line| {
            let title = line.trim_start_matches('#').trim().to_lowercase();
            let kept = title.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
            kept.map(|c| if c == ' ' { '-' } else { c }).collect()
        })
        .collect()
}

/// `(2.3)` at the end of a line in a fenced block.
fn numbered_equations(text: &str) -> Vec<(String, usize)> {
    let mut fenced = false;
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if fenced && let Some((_, tail)) = line.trim_end().rsplit_once("  (") {
            let number = tail.strip_suffix(')').unwrap_or_default();
            if is_equation_number(number) {
                found.push((number.to_owned(), index + 1));
            }
        }
    }
    found
}

/// References to equations of the book: `eq. (2.3)` or `Eq. 2.3`, singly or as a list.
fn equation_references(text: &str) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let lower = line.to_lowercase();
        for (start, _) in lower.match_indices("book, eq") {
            let tail = lower[start + "book, eq".len()..].trim_start_matches(['s', '.', ' ']);
            let words = tail.split([' ', ',', ';', ']', ':']).map(|word| word.trim_matches(['(', ')', '.']));
            let numbers =
                words.take_while(|word| word.is_empty() || *word == "and" || is_equation_number(word));
            found.extend(numbers.filter(|n| is_equation_number(n)).map(|n| (n.to_owned(), index + 1)));
        }
        // Within the book itself a number in brackets is a reference.
        for (start, _) in line.match_indices('(') {
            let inner = line[start + 1..].split(')').next().unwrap_or_default();
            let before = line[..start].trim_end().to_lowercase();
            if is_equation_number(inner) && (before.ends_with("eq.") || before.ends_with("equation")) {
                found.push((inner.to_owned(), index + 1));
            }
        }
    }
    found.dedup();
    found
}

/// `[Louvigny2008]`: a capital, letters, a year, perhaps a letter.
fn source_references(text: &str) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        for (start, _) in line.match_indices('[') {
            let inner = line[start + 1..].split(']').next().unwrap_or_default();
            let letters = inner.bytes().take_while(u8::is_ascii_alphabetic).count();
            let (name, year) = inner.split_at(letters);
            let year = year.trim_end_matches(|c: char| c.is_ascii_lowercase());
            let capital = name.bytes().next().is_some_and(|b| b.is_ascii_uppercase());
            if capital && letters > 1 && year.len() == 4 && year.bytes().all(|b| b.is_ascii_digit()) {
                found.push((inner.to_owned(), index + 1));
            }
        }
    }
    found
}

/// Keys of a BibTeX file.
fn source_keys(bibliography: &str) -> BTreeSet<String> {
    let entries = bibliography.lines().filter(|line| line.starts_with('@'));
    entries
        .filter_map(|line| Some(line.split_once('{')?.1.trim_end().trim_end_matches(',').to_owned()))
        .collect()
}

/// The path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut result = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                result.pop();
            }
            Component::CurDir => {}
            other => result.push(other),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_numbered_in_blocks_and_referenced_in_prose() {
        let page =
            "text (1.1)\n```text\ns = r cos φ      (2.3)\nx = (2.4)\n```\nby equation (2.3) and eq. (9.1)";
        assert_eq!(numbered_equations(page), [("2.3".to_owned(), 3)]);
        assert_eq!(equation_references(page), [("2.3".to_owned(), 6), ("9.1".to_owned(), 6)]);
        let code = "/// (book, eqs. 2.3, 2.4 and 3.1), see 4.5";
        let numbers: Vec<String> = equation_references(code).into_iter().map(|(number, _)| number).collect();
        assert_eq!(numbers, ["2.3", "2.4", "3.1"]);
    }

    #[test]
    fn sources_are_keys_with_a_year() {
        assert_eq!(
            source_references("see [Louvigny2008], [text] and [Iso1940]"),
            [("Louvigny2008".to_owned(), 1), ("Iso1940".to_owned(), 1)]
        );
        assert!(source_references("error[E0101]: unit missing").is_empty());
        assert!(source_keys("@book{Heywood1988,\n title = {x}\n}").contains("Heywood1988"));
    }

    #[test]
    fn formulas_want_a_picture() {
        let page = "# A\n\n```formula\na = b\n```\n";
        assert!(lacks_picture(page) && !lacks_picture("# A\n"));
        assert!(!lacks_picture(&format!("{page}\n![b](b.svg)\n")));
    }

    #[test]
    fn links_headings_and_code() {
        assert_eq!(links("a [b](c.md#d) `[x](y)`\n```\n[p](q)\n```"), [("c.md#d".to_owned(), 1)]);
        assert!(headings("## Frame and signs").contains("frame-and-signs"));
        assert_eq!(broken_links("README.md", "[x](no-such-file.md)").len(), 1);
        assert!(broken_links("README.md", "[x](Cargo.toml)").is_empty());
    }
}
