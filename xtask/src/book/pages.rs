//! The pages of the book on their way to mdBook: blocks of formulas are typeset, numbers of equations in the text become links.

use super::block::html;
use super::equation::{anchor, equation_number};
use super::flow::flow;
use anyhow::{Context, Result, anyhow, bail};
use std::collections::BTreeMap;
use std::path::{Component, Path};

const FENCE: &str = "```";
/// The language of a fenced block of formulas.
const FORMULA: &str = "formula";

/// How the line begins that tells where a block of formulas comes from; it stands in italics right below it.
const SOURCES: [&str; 3] = ["*Source: ", "*Sources: ", "*Derived here"];

/// How a table of symbols begins.
const SYMBOLS: &str = "| symbol |";

/// Every equation's page, as a path within the book with `/`.
pub type Equations = BTreeMap<String, String>;

/// The equations of all pages, given as path and text. Two of one number are a mistake.
pub fn equations<'a>(pages: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Equations> {
    let mut equations: BTreeMap<String, (String, usize)> = BTreeMap::new();
    for (page, text) in pages {
        for block in blocks(text) {
            for (index, line) in block.text.lines().enumerate() {
                let place = block.line + index + 1;
                let tail = line.trim_end().rsplit_once("  ").map_or("", |(_, tail)| tail.trim());
                let Some(number) = equation_number(tail) else { continue };
                if let Some((other, line)) = equations.insert(number.to_owned(), (page.to_owned(), place)) {
                    bail!(
                        "{page}:{place}: equation ({number}) is there already, at {other}:{line}: give it a number of its own"
                    );
                }
            }
        }
    }
    Ok(equations.into_iter().map(|(number, (page, _))| (number, page)).collect())
}

/// A block of formulas: its lines and the line of its fence, from 1.
pub struct Block {
    /// The line of its fence.
    pub line: usize,
    /// What stands between the fences.
    pub text: String,
}

/// The blocks of formulas of a page.
pub fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (index, line) in page.lines().enumerate() {
        match &mut open {
            Some(_) if line == FENCE => blocks.extend(open.take()),
            Some(block) => {
                block.text += line;
                block.text.push('\n');
            }
            None if line.strip_prefix(FENCE) == Some(FORMULA) => {
                open = Some(Block { line: index + 1, text: String::new() });
            }
            None => {}
        }
    }
    blocks
}

/// A page with its formulas typeset and its references to equations as links.
pub fn typeset(page: &str, text: &str, equations: &Equations) -> Result<String> {
    let link = |number: &str| {
        let to = equations.get(number)?;
        let path = if to == page { String::new() } else { relative(page, to) };
        Some(format!("{path}#{}", anchor(number)))
    };
    // In HTML the link is written as the browser needs it.
    let html_link = |number: &str| link(number).map(|to| to.replace(".md#", ".html#"));
    let mut blocks = blocks(text).into_iter();
    let mut done = String::new();
    let mut fenced: Option<bool> = None;
    let mut of_symbols = false;
    let mut below_picture = false;
    for (index, line) in text.lines().enumerate() {
        let place = index + 1;
        let (head, row) = (line.starts_with(SYMBOLS), of_symbols && line.starts_with("| "));
        of_symbols = head || of_symbols && line.starts_with('|');
        if let Some(formulas) = fenced {
            if line.trim_start().starts_with(FENCE) {
                fenced = None;
                if formulas {
                    continue;
                }
            }
            if formulas {
                continue;
            }
            done += line;
        } else if line.strip_prefix(FENCE) == Some(FORMULA) {
            let block = blocks
                .next()
                .with_context(|| format!("{page}:{place}: the block of formulas is not closed"))?;
            done += &html(&block.text, &html_link)
                .map_err(|(within, error)| anyhow!("{page}:{}: {error:#}", block.line + within))?;
            fenced = Some(true);
        } else if line.trim_start().starts_with(FENCE) {
            done += line;
            fenced = Some(false);
        } else if line.starts_with('#') {
            done += line;
        } else {
            let line = referenced(line, &link).with_context(|| format!("{page}:{place}"))?;
            done += &if row && !head {
                symbols(&line).with_context(|| format!("{page}:{place}"))?
            } else if SOURCES.iter().any(|start| line.starts_with(start)) {
                classed("source", &line)
            } else if below_picture && line.starts_with('*') && line.ends_with('*') {
                classed("caption", &line)
            } else {
                line
            };
        }
        below_picture = line.starts_with("![") || below_picture && line.is_empty();
        done.push('\n');
    }
    Ok(done)
}

/// A paragraph with a class: with empty lines about it the text is Markdown still.
fn classed(class: &str, line: &str) -> String {
    format!("<div class=\"{class}\">\n\n{line}\n\n</div>")
}

/// A row of a table of symbols with its first cell typeset.
fn symbols(row: &str) -> Result<String> {
    let inner = &row[2..];
    let end = inner.find(" |").context("a row of a table ends with |")?;
    let set = flow(&inner[..end].replace("\\|", "|"), &|_| None)?;
    // What Markdown would read as marks of its own.
    Ok(format!("| {}{}", set.replace('|', "&#124;").replace('*', "&#42;"), &inner[end..]))
}

/// A line of text with `(43.2)` as a link, outside code and outside what is a link already.
fn referenced(line: &str, link: &dyn Fn(&str) -> Option<String>) -> Result<String> {
    let mut done = String::new();
    for (index, part) in line.split('`').enumerate() {
        if index > 0 {
            done.push('`');
        }
        if index % 2 == 1 {
            done += part;
            continue;
        }
        let mut rest = part;
        while let Some(at) = rest.find(['(', '[']) {
            done += &rest[..at];
            rest = &rest[at..];
            let length = match linked(rest) {
                Some(length) => {
                    done += &aimed(&rest[..length], link);
                    rest = &rest[length..];
                    continue;
                }
                None => match rest.find(')').and_then(|end| equation_number(&rest[..=end])) {
                    Some(number) => {
                        let to = link(number).with_context(|| {
                            format!("equation ({number}) is nowhere in the book: number an equation so, or write the number without brackets")
                        })?;
                        done += &format!("([{number}]({to}))");
                        rest = &rest[number.len() + 2..];
                        continue;
                    }
                    None => 1,
                },
            };
            done += &rest[..length];
            rest = &rest[length..];
        }
        done += rest;
    }
    Ok(done)
}

/// A link to a page whose text names an equation leads to the equation.
fn aimed(written: &str, link: &dyn Fn(&str) -> Option<String>) -> String {
    let aim = written.rsplit_once("](").and_then(|(text, target)| {
        let number = text
            .match_indices('(')
            .find_map(|(at, _)| equation_number(&text[at..=at + text[at..].find(')')?]))?;
        let to = link(number).filter(|to| to.starts_with(target.trim_end_matches(')')))?;
        Some(format!("{text}]({to})"))
    });
    aim.unwrap_or_else(|| written.to_owned())
}

/// Length of `[text](target)` at the beginning of the text.
fn linked(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, c) in text.strip_prefix('[').map(|_| text)?.char_indices() {
        match c {
            '[' => depth += 1,
            ']' if depth > 1 => depth -= 1,
            ']' => {
                let target = text[at + 1..].strip_prefix('(')?;
                return Some(at + 2 + target.find(')')? + 1);
            }
            _ => {}
        }
    }
    None
}

/// The way from one page to another.
fn relative(from: &str, to: &str) -> String {
    let folder: Vec<Component<'_>> =
        Path::new(from).parent().map(|p| p.components().collect()).unwrap_or_default();
    let target: Vec<Component<'_>> = Path::new(to).components().collect();
    let shared = folder.iter().zip(&target).take_while(|(a, b)| a == b).count();
    let up = vec!["..".to_owned(); folder.len() - shared];
    let down = target[shared..].iter().map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.into_iter().chain(down).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "theory/mounts.md";

    fn typeset_with(text: &str) -> Result<String> {
        let other = "```formula\ns = r cos φ      (2.2)\n```\n";
        let equations = equations([(PAGE, text), ("theory/kinematics.md", other)])?;
        typeset(PAGE, text, &equations)
    }

    #[test]
    fn numbers_of_equations_in_the_text_become_links() {
        let page = "# Of (9.9)\n\nBy (2.2) and eq. (27.1), `(2.2)`, [eq. (2.2)](kinematics.md).\n\n\
                    ```formula\nu = v      (27.1)\n```\n\n```text\n(2.2)\n```\n";
        let set = typeset_with(page).unwrap();
        let text = "# Of (9.9)\n\nBy ([2.2](kinematics.md#eq-2-2)) and eq. ([27.1](#eq-27-1)), `(2.2)`, \
                    [eq. (2.2)](kinematics.md#eq-2-2).\n\n<div class=\"formula\">";
        assert!(set.starts_with(text), "{set}");
        assert!(set.ends_with("</div>\n\n```text\n(2.2)\n```\n"), "{set}");
    }

    #[test]
    fn sources_and_captions_have_classes() {
        let page =
            "![alt](a.svg)\n\n*By (2.2).*\n\n*Said.*\n\n```formula\nu = v\n```\n\n*Source: [Key2000].*\n";
        let set = typeset_with(page).unwrap();
        let caption = "![alt](a.svg)\n\n<div class=\"caption\">\n\n*By ([2.2](kinematics.md#eq-2-2)).*\n\n</div>\n\n*Said.*\n";
        assert!(set.starts_with(caption), "{set}");
        assert!(set.ends_with("<div class=\"source\">\n\n*Source: [Key2000].*\n\n</div>\n"), "{set}");
    }

    #[test]
    fn references_and_numbers_must_fit() {
        let said = |page: &str| format!("{:#}", typeset_with(page).unwrap_err());
        assert!(
            said("a\n\nby (7.5)\n").contains("theory/mounts.md:3: equation (7.5) is nowhere in the book")
        );
        assert!(
            said("```formula\ns = r      (2.2)\n```\n")
                .contains("theory/kinematics.md:2: equation (2.2) is there already, at theory/mounts.md:2")
        );
        assert!(
            said("a\n\n```formula\nb = c\ns = #\n```\n")
                .contains("theory/mounts.md:5: cannot typeset \"s = #\": the character '#'")
        );
        assert!(
            said("```formula\nb = c\n").contains("theory/mounts.md:1: the block of formulas is not closed")
        );
    }

    #[test]
    fn symbols_of_tables_are_typeset() {
        let set =
            typeset_with("| symbol | unit |\n|---|---|\n| f_x, \\|a\\|, K* | N, `f_x` |\n\n| f_x | N |\n")
                .unwrap();
        let rows: Vec<&str> = set.lines().collect();
        assert_eq!(rows[0], "| symbol | unit |");
        assert!(
            rows[2].starts_with("| <span><math") && rows[2].ends_with("</math></span> | N, `f_x` |"),
            "{set}"
        );
        assert!(rows[2].contains("<mo>&#42;</mo>") && rows[2].contains("&#124;</mo><mi>a</mi>"), "{set}");
        assert_eq!(rows[4], "| f_x | N |");
        assert!(
            format!("{:#}", typeset_with("| symbol |\n|---|\n| a# |\n").unwrap_err())
                .contains("theory/mounts.md:3")
        );
    }

    #[test]
    fn the_way_from_page_to_page() {
        assert_eq!(relative("performance.md", "theory/orders.md"), "theory/orders.md");
        assert_eq!(relative("guide/torque.md", "theory/orders.md"), "../theory/orders.md");
        assert_eq!(relative("theory/a.md", "theory/orders.md"), "orders.md");
    }
}
