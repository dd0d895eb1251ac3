//! Claims of the README and the book that a change of the program can make false without a word: files and options of
//! the commands that a reader is given, codes of messages, what the program lacks, what the studio lacks.

use crate::command::{output, quiet};
use crate::documents::{Block, arguments, blocks};
use crate::workspace::{files, root, text};
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Options whose value is a file that the command makes.
const MADE_BY: [&str; 6] = ["--output", "--save", "--figures", "--figure", "--drawing", "--suite"];

/// Endings of files that a command reads.
const ENDINGS: [&str; 8] = ["toml", "csv", "parquet", "dxf", "svg", "json", "step", "html"];

/// How a page claims that something is missing.
const ABSENT: [&str; 5] =
    ["not there yet", "not modelled", "not computed yet", "planned", "not in the program"];

/// How the one paragraph begins that may claim it: what it names in code is neither a command nor a table of the file.
const ABSENT_TODAY: &str = "Not in the program today:";

/// Commands that the studio answers under another name.
const IN_STUDIO: [(&str, &str); 3] =
    [("check", "/api/engine"), ("show", "/api/expanded"), ("new", "/api/session")];

/// The page and the heading under which the book names the commands that the studio lacks.
const STUDIO_LACKS: (&str, &str) = ("docs/src/guide/studio.md", "## Only on the command line");

/// Checks every page.
pub fn check(program: &Path) -> Result<String> {
    let commands = command_names(&quiet(Command::new(program).arg("--help"))?);
    let reference = text("docs/src/engine-file.md")?.context("the reference is not UTF-8")?;
    // Mistakes in graph files are listed in their guide.
    let graphs = text("docs/src/guide/bond-graphs.md")?.context("the guide is not UTF-8")?;
    let listed = format!("{reference}\n{graphs}");
    let codes = codes(&listed);
    ensure!(!commands.is_empty() && !codes.is_empty(), "no commands or no codes are listed");
    let (mut given, mut named) = (0, 0);
    for page in files()?.iter().filter(|file| *file == "README.md" || file.starts_with("docs/src/")) {
        let Some(text) = text(page)? else { continue };
        let place = |error: anyhow::Error| error.context(page.clone());
        given += given_commands(program, &text).map_err(place)?;
        for code in codes_in(&text) {
            ensure!(codes.contains(code), "{page}: there is no code {code}");
            named += 1;
        }
        for paragraph in prose(&text) {
            absent(&paragraph, &commands, &reference).map_err(place)?;
        }
    }
    studio_lacks(&commands)?;
    ensure!(given > 0, "no page gives a command");
    Ok(format!("{given} commands with their files and options, {named} codes"))
}

/// The commands that a page gives: their options are known, their files are shipped, shown, or made above.
fn given_commands(program: &Path, page: &str) -> Result<usize> {
    let mut there = BTreeSet::new();
    let mut count = 0;
    let mut given = |line: &str, there: &mut BTreeSet<String>| -> Result<()> {
        let words = arguments(line);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        match words.as_slice() {
            ["cp", from, to] => {
                is_there(from, there)?;
                there.insert((*to).to_string());
            }
            ["lanchester", words @ ..] | ["cargo", "run", "--release", "--", words @ ..] => {
                for made in read_and_made(words, there)? {
                    there.insert(made);
                }
                known_options(program, words)?;
                count += 1;
            }
            _ => {}
        }
        Ok(())
    };
    for block in blocks(page) {
        let Block { language, tag, text, .. } = &block;
        match (*language, tag.split_once('=')) {
            ("toml", Some(("file" | "append", name))) => drop(there.insert(name.to_string())),
            ("sh", _) => {
                for line in text.lines() {
                    given(line, &mut there).with_context(|| format!("`{line}`"))?;
                }
            }
            _ => {
                let command = text.lines().find(|line| line.starts_with("lanchester "));
                ensure!(command.is_none(), "a command outside of a block of `sh`: {command:?}");
            }
        }
    }
    for span in prose(page).iter().flat_map(|paragraph| code_spans(paragraph)) {
        if span.starts_with("lanchester ") && !span.contains(['<', '…']) {
            given(&span, &mut there).with_context(|| format!("`{span}`"))?;
        }
    }
    Ok(count)
}

/// Files that a command makes; every file that it reads must be there.
fn read_and_made(words: &[&str], there: &BTreeSet<String>) -> Result<Vec<String>> {
    let mut made = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        if MADE_BY.contains(word) || *word == ">" {
            made.extend(words.next().map(|word| (*word).to_string()));
        } else if !word.starts_with('-') && !word.contains(char::is_whitespace) {
            let ending = Path::new(word).extension().and_then(|ending| ending.to_str());
            if ending.is_some_and(|ending| ENDINGS.contains(&ending)) {
                is_there(word, there)?;
            }
        }
    }
    Ok(made)
}

/// Whether a file is shipped, or was shown or made above.
fn is_there(name: &str, there: &BTreeSet<String>) -> Result<()> {
    let is_shipped = ["examples/", "validation/"].iter().any(|folder| name.starts_with(folder));
    let fits = |made: &String| match name.split_once('*') {
        Some((head, tail)) => made.starts_with(head) && made.ends_with(tail),
        None => made == name,
    };
    ensure!(
        is_shipped && root().join(name).is_file() || there.iter().any(fits),
        "the reader was never given {name}: ship it, show it in a block `toml,file={name}`, or make it above"
    );
    Ok(())
}

/// Whether the program takes these words: its help stands before anything is read.
fn known_options(program: &Path, words: &[&str]) -> Result<()> {
    let words = words.iter().take_while(|word| **word != ">").map(|word| word.replace("$TASK", "1"));
    let finished = output(Command::new(program).args(words).arg("--help"))?;
    ensure!(finished.status == 0, "the program says\n{}", finished.stderr);
    Ok(())
}

/// A paragraph that says that something is missing says it in the one form that can be checked.
fn absent(paragraph: &str, commands: &BTreeSet<String>, reference: &str) -> Result<()> {
    let lower = paragraph.to_lowercase();
    let Some(claim) = ABSENT.iter().find(|claim| lower.contains(*claim)) else { return Ok(()) };
    let Some(rest) = paragraph.strip_prefix(ABSENT_TODAY) else {
        anyhow::bail!("\"{claim}\" outside of a paragraph that begins with \"{ABSENT_TODAY}\": {paragraph}")
    };
    let names = code_spans(rest.split(". ").next().unwrap_or(rest));
    ensure!(!names.is_empty(), "\"{ABSENT_TODAY}\" names nothing that can be looked for");
    for name in names {
        let is_table =
            [format!("## `[{name}]`"), format!("## `[[{name}]]`")].iter().any(|h| reference.contains(h));
        ensure!(
            !commands.contains(&name) && !is_table,
            "`{name}` is in the program, and a page says it is not"
        );
    }
    Ok(())
}

/// The studio's guide names exactly the commands that the studio has no question for.
fn studio_lacks(commands: &BTreeSet<String>) -> Result<()> {
    let (page, heading) = STUDIO_LACKS;
    let text = text(page)?.context("the studio's guide is not UTF-8")?;
    let (_, section) = text.split_once(heading).with_context(|| format!("{page} has no {heading}"))?;
    let sentence = section.trim_start().split(['\n', ';']).next().unwrap_or_default();
    let named: BTreeSet<String> = code_spans(sentence).into_iter().collect();
    let description = crate::workspace::text("crates/studio/openapi.json")?.unwrap_or_default();
    let description: Value = serde_json::from_str(&description).context("openapi.json is no JSON")?;
    let paths = description["paths"].as_object().context("openapi.json has no paths")?;
    let answered = |command: &String| {
        let own = format!("/api/{command}");
        let other = IN_STUDIO.iter().find(|(name, _)| name == command).map(|(_, path)| *path);
        paths
            .keys()
            .any(|path| *path == own || path.starts_with(&format!("{own}/")) || Some(path.as_str()) == other)
    };
    let lacking: BTreeSet<String> =
        commands.iter().filter(|command| *command != "studio" && !answered(command)).cloned().collect();
    ensure!(named == lacking, "{page}: the studio lacks {lacking:?}, the page says {named:?}");
    Ok(())
}

/// Commands that the help lists.
fn command_names(help: &str) -> BTreeSet<String> {
    let list =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names = list.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = names.filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(str::to_string).collect()
}

/// Codes that the reference lists.
fn codes(reference: &str) -> BTreeSet<&str> {
    let first_cells = reference.lines().filter_map(|line| line.strip_prefix("| ")?.split(" |").next());
    first_cells.filter(|cell| is_code(cell)).collect()
}

fn codes_in(page: &str) -> impl Iterator<Item = &str> {
    page.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| is_code(word))
}

fn is_code(word: &str) -> bool {
    let digits = word.strip_prefix(['E', 'W']);
    digits.is_some_and(|digits| digits.len() == 4 && digits.bytes().all(|digit| digit.is_ascii_digit()))
}

/// Paragraphs outside of fenced blocks, each in one line.
fn prose(page: &str) -> Vec<String> {
    let mut paragraphs = vec![String::new()];
    let mut is_fenced = false;
    for line in page.lines() {
        if line.starts_with("```") {
            is_fenced = !is_fenced;
        }
        let ends = is_fenced || line.starts_with("```") || line.trim().is_empty() || line.starts_with('#');
        match paragraphs.last_mut() {
            Some(last) if !ends => {
                *last += line.trim();
                last.push(' ');
            }
            Some(last) if last.is_empty() => {}
            _ => paragraphs.push(String::new()),
        }
    }
    paragraphs
}

/// What stands between backquotes.
fn code_spans(paragraph: &str) -> Vec<String> {
    paragraph.split('`').skip(1).step_by(2).map(str::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(names: &[&str]) -> BTreeSet<String> {
        names.iter().map(|name| name.to_string()).collect()
    }

    #[test]
    fn a_file_that_was_never_given_is_found() {
        let read = |line: &str, there: &[&str]| {
            let words = arguments(line);
            read_and_made(&words.iter().map(String::as_str).collect::<Vec<_>>(), &files(there))
        };
        assert!(read("loads three.toml", &[]).is_err());
        assert!(read("loads three.toml", &["three.toml"]).is_ok_and(|made| made.is_empty()));
        assert!(read("loads examples/in-line-3.toml", &[]).is_ok());
        assert!(read("loads examples/in-line-99.toml", &[]).is_err());
        assert_eq!(read("new in-line-3 > three.toml", &[]).unwrap(), ["three.toml"]);
        assert_eq!(
            read("explore examples/v6-60.toml --save part-$TASK.parquet", &[]).unwrap(),
            ["part-$TASK.parquet"]
        );
        assert!(read("merge part-*.parquet --output all.parquet", &["part-$TASK.parquet"]).is_ok());
        assert!(read("merge part-*.parquet --output all.parquet", &["all.parquet"]).is_err());
    }

    #[test]
    fn what_is_there_is_not_called_absent() {
        let commands = files(&["torque"]);
        let reference = "## `[gas]`\n";
        let absent = |text: &str| absent(text, &commands, reference);
        assert!(absent("Not in the program today: simulation (`simulate`). So `torque` it is.").is_ok());
        assert!(absent("Not in the program today: torque (`torque`).").is_err());
        assert!(absent("Not in the program today: gas loads (`gas`).").is_err());
        assert!(absent("Not in the program today: much.").is_err());
        assert!(absent("What is not there yet: `simulate`.").is_err());
        assert!(absent("They are Planned.").is_err());
        assert!(absent("All is there.").is_ok());
    }

    #[test]
    fn commands_codes_and_prose_are_found() {
        let help = "Shaking\n\nUsage: x\n\nCommands:\n  check  reads\n         on\n  help   this\n\nOptions:\n  --colour\n";
        assert_eq!(command_names(help), files(&["check"]));
        let reference = "| 14 | mounts |\n| E1401 | a mount |\n| W0901 | a shape |\n";
        assert_eq!(codes(reference), ["E1401", "W0901"].into());
        assert_eq!(codes_in("see E1401, W0901; SAE2008 and E14").collect::<Vec<_>>(), ["E1401", "W0901"]);
        let page = "# Head\none `a`\ntwo\n\n```sh\nlanchester x\n```\nthree `b`\n";
        let found: Vec<String> = prose(page).into_iter().filter(|paragraph| !paragraph.is_empty()).collect();
        assert_eq!(found, ["one `a` two ", "three `b` "]);
        assert_eq!(code_spans(&found[0]), ["a"]);
    }
}
