//! Building the book with mdBook, which is installed below the target folder where it is missing.
//!
//! mdBook builds from a copy of `docs`, in which the formulas of the pages are typeset. The pages themselves hold them as plain text.

mod block;
mod columns;
mod equation;
mod expression;
mod flow;
mod fractions;
mod mathml;
mod pages;
mod tokens;

pub use equation::is_equation_number;

use crate::command::{cargo, exists, quiet};
use crate::workspace::{files, root, scratch, target};
use anyhow::{Context, Result};
use std::path::PathBuf;
use std::process::Command;

const MDBOOK: &str = "0.4.52";
/// What mdBook needs: its settings, the style of formulas, and the pages with their pictures.
const SETTINGS: [&str; 2] = ["docs/book.toml", "docs/formulas.css"];
const PAGES: &str = "docs/src/";

/// Builds `docs/book`.
pub fn build() -> Result<()> {
    let copy = scratch("book")?;
    let pages = pages()?;
    let equations = pages::equations(pages.iter().map(|(page, text)| (page.as_str(), text.as_str())))?;
    let write = |name: &str, content: &[u8]| -> Result<()> {
        let to = copy.join(name);
        std::fs::create_dir_all(to.parent().context("a file lies in a folder")?)?;
        std::fs::write(&to, content).with_context(|| format!("cannot write {}", to.display()))
    };
    for (page, text) in &pages {
        write(&format!("src/{page}"), pages::typeset(page, text, &equations)?.as_bytes())?;
    }
    for file in files()? {
        let picture = file.starts_with(PAGES) && !file.ends_with(".md");
        if picture || SETTINGS.contains(&file.as_str()) {
            let content = std::fs::read(root().join(&file)).with_context(|| format!("cannot read {file}"))?;
            write(file.trim_start_matches("docs/"), &content)?;
        }
    }
    let mut build = Command::new(mdbook()?);
    build.arg("build").arg(&copy).arg("--dest-dir").arg(root().join("docs/book"));
    quiet(build.current_dir(root())).map(drop)
}

/// The pages of the book, as path within it and text.
fn pages() -> Result<Vec<(String, String)>> {
    let files = files()?;
    let pages = files.iter().filter(|file| file.starts_with(PAGES) && file.ends_with(".md"));
    pages
        .map(|file| {
            let text = crate::workspace::text(file)?.with_context(|| format!("{file} is not UTF-8"))?;
            Ok((file.trim_start_matches(PAGES).to_owned(), text))
        })
        .collect()
}

/// The mdBook on the path, or our own.
fn mdbook() -> Result<PathBuf> {
    if exists("mdbook") {
        return Ok("mdbook".into());
    }
    let tools = target()?.join("tools");
    let own = tools.join("bin").join(format!("mdbook{}", std::env::consts::EXE_SUFFIX));
    if !own.exists() {
        println!("   mdbook is missing: installing {MDBOOK} below {}", tools.display());
        let mut install = cargo();
        install.args(["install", "mdbook", "--version", MDBOOK, "--locked", "--quiet", "--debug"]);
        // It builds one book: neither server nor optimised code is worth the minutes.
        install.args(["--no-default-features", "--features", "search", "--root"]);
        quiet(install.arg(&tools).current_dir(root()))?;
    }
    Ok(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every formula of the book is typeset, is well-formed, and says what its text says, in the same order.
    #[test]
    fn nothing_of_the_books_formulas_is_lost_or_moved() {
        let mut wrong = Vec::new();
        let mut count = 0;
        for (page, text) in pages().unwrap() {
            for block in pages::blocks(&text) {
                count += 1;
                match block::html(&block.text, &|_| None) {
                    Err((line, error)) => wrong.push(format!("{page}:{}: {error:#}", block.line + line)),
                    Ok(html) => {
                        let (written, set) = (plain(&block.text), shown(&html));
                        if written != set {
                            wrong.push(format!("{page}:{}:\n  {written}\n  {set}", block.line));
                        }
                    }
                }
            }
        }
        assert!(count > 200, "{count} blocks of formulas: the book has more than 200");
        assert!(wrong.is_empty(), "{} blocks:\n{}", wrong.len(), wrong.join("\n"));
    }

    /// Numbers of equations are unique and those in the text are equations of the book.
    #[test]
    fn references_to_equations_lead_to_them() {
        let pages = pages().unwrap();
        let equations =
            pages::equations(pages.iter().map(|(page, text)| (page.as_str(), text.as_str()))).unwrap();
        assert!(equations.len() > 250, "{} equations: the book has more than 250", equations.len());
        for (page, text) in &pages {
            let set = pages::typeset(page, text, &equations).unwrap();
            let own = equations.iter().filter(|(_, of)| *of == page);
            for (number, _) in own {
                assert_eq!(
                    set.matches(&format!("id=\"{}\"", equation::anchor(number))).count(),
                    1,
                    "{page}: ({number})"
                );
            }
        }
    }

    /// What the page shows of a block: the text of its cells, without what brackets a formula.
    fn shown(html: &str) -> String {
        let document = roxmltree::Document::parse(html).unwrap_or_else(|error| panic!("{error}: {html}"));
        let table = document.descendants().find(|node| node.has_tag_name("table")).unwrap();
        let texts: Vec<&str> =
            table.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
        unbracketed(&texts.join(" "))
    }

    /// The plain text of a block as its typeset form shows it: the signs that are set otherwise replaced.
    fn plain(text: &str) -> String {
        let mut text = text.replace('`', " ");
        // Separators of a matrix are its rows and columns.
        while let Some(semicolon) = text.match_indices(';').map(|(at, _)| at).find(|at| in_matrix(&text, *at))
        {
            let open = text[..semicolon].rfind('[').unwrap();
            let close = semicolon + text[semicolon..].find(']').unwrap();
            let inside = text[open..close].replace([';', ','], " ");
            text.replace_range(open..close, &inside);
        }
        for (written, set) in REPLACED {
            text = text.replace(written, set);
        }
        unbracketed(&text.lines().map(without_limit_words).collect::<Vec<_>>().join(" "))
    }

    /// Without the "over", "of", "from" and "to" of sums and integrals, which their limits say by their places.
    fn without_limit_words(line: &str) -> String {
        let mut words: Vec<&str> = line.split(' ').collect();
        for index in 0..words.len() {
            let sign = words[index].trim_start_matches(['(', '|', '[', '−']);
            let next = words.get(index + 1).copied();
            let end = words.iter().skip(index).position(|word| *word == "of").map(|end| index + end);
            if !(["∑", "∏", "∫", "max", "min"].contains(&sign)) {
                continue;
            }
            match (next, end) {
                (Some("of"), _) => words[index + 1] = "",
                (Some("over" | "from"), Some(end)) => {
                    if next == Some("from") {
                        let to = words.iter().skip(index).position(|word| *word == "to").unwrap();
                        words[index + to] = "";
                    }
                    words[index + 1] = "";
                    words[end] = "";
                }
                _ => {}
            }
        }
        words.join(" ")
    }

    /// Whether the innermost bracket here is a square one.
    fn in_matrix(text: &str, at: usize) -> bool {
        let mut depth = 0_i32;
        for c in text[..at].chars().rev() {
            depth += i32::from(matches!(c, ')' | ']' | '}')) - i32::from(matches!(c, '(' | '[' | '{'));
            if depth < 0 {
                return c == '[';
            }
        }
        false
    }

    const REPLACED: [(&str, &str); 59] = [
        ("SUM", "∑"),
        ("Σ", "∑"),
        ("PRODUCT", "∏"),
        ("INTEGRAL", "∫"),
        ("sqrt(", "("),
        ("√", ""),
        ("½", "1 2"),
        ("..", "…"),
        ("<=", "≤"),
        (">=", "≥"),
        ("->", "→"),
        ("''", "″"),
        ("\u{308}", "¨"),
        ("\u{307}", "˙"),
        ("\u{304}", "¯"),
        ("ẅ", "w¨"),
        ("ẍ", "x¨"),
        ("ÿ", "y¨"),
        ("ẇ", "w˙"),
        ("Ẇ", "W˙"),
        ("ẏ", "y˙"),
        ("ṁ", "m˙"),
        ("ṡ", "s˙"),
        ("ḋ", "d˙"),
        ("ė", "e˙"),
        ("¹", "1"),
        ("²", "2"),
        ("³", "3"),
        ("⁴", "4"),
        ("⁵", "5"),
        ("⁶", "6"),
        ("⁸", "8"),
        ("⁻", "−"),
        ("ᵀ", "T"),
        ("ᵏ", "k"),
        ("ᵖ", "p"),
        ("₀", "0"),
        ("₁", "1"),
        ("₂", "2"),
        ("₃", "3"),
        ("₊", "+"),
        ("₋", "−"),
        ("ₙ", "n"),
        ("ₘ", "m"),
        ("'", "′"),
        ("-", "−"),
        ("⁰", "0"),
        ("⁷", "7"),
        ("⁹", "9"),
        ("⁺", "+"),
        ("ⁿ", "n"),
        ("ᴴ", "H"),
        ("₄", "4"),
        ("₅", "5"),
        ("₆", "6"),
        ("₇", "7"),
        ("ₖ", "k"),
        ("ᵢ", "i"),
        ("ⱼ", "j"),
    ];

    /// Without spaces, brackets, slashes and marks of scripts.
    fn unbracketed(text: &str) -> String {
        let apart: String = text.chars().map(|c| if "()[]{}/_^".contains(c) { ' ' } else { c }).collect();
        apart.split_whitespace().collect::<String>().replace('\'', "′").replace('-', "−")
    }
}
