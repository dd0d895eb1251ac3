//! The documents hold what they say: the commands of the README run, every engine file shown is read.

use crate::command::quiet;
use crate::workspace::{files, root, scratch, text};
use anyhow::{Context, Result, bail, ensure};
use std::path::Path;
use std::process::Command;

/// Every engine file in the README and in the book through `check` and `loads`, without a warning, and every quoted
/// output against what the program says.
///
/// A `toml` block with a `name` is a whole engine file; `toml,wrong` is one with mistakes. `toml,file=NAME` is a file of
/// that name, engine or not, and `toml,append=NAME` goes to its end. A `text,says` block quotes a part of what the last
/// `lanchester` line of the `sh` blocks above it prints, which finds shipped files at `examples/...` and `validation/...`;
/// `text,says-COMMAND` what that command says of the engine file above it. Every line of a `sh,run` block is run.
pub fn engines(program: &Path) -> Result<String> {
    let (mut shown, mut quoted) = (0, 0);
    for page in files()?.iter().filter(|file| *file == "README.md" || file.starts_with("docs/src/")) {
        let Some(text) = text(page)? else { continue };
        let folder = scratch("documents")?;
        let mut last_command: Option<String> = None;
        for block in blocks(&text) {
            let place = format!("{page}:{}", block.line);
            let said = |arguments: &[&str]| -> Result<(bool, String)> {
                let finished =
                    crate::command::output(Command::new(program).args(arguments).current_dir(&folder))?;
                let clean = finished.status == 0 && finished.stderr.is_empty();
                Ok((clean, format!("{}{}", finished.stderr, finished.stdout)))
            };
            let reads = |file: &str| -> Result<()> {
                for command in ["check", "loads"] {
                    let (clean, said) = said(&[command, file])?;
                    ensure!(clean != (block.tag == "wrong"), "{place}: `{command}` says\n{said}");
                }
                Ok(())
            };
            // A name below a header is that of a part.
            let mut head = block.text.lines().take_while(|line| !line.starts_with('['));
            let named = head.any(|line| line.starts_with("name = "));
            match (block.language, block.tag.split_once('=')) {
                ("toml", Some((put @ ("file" | "append"), name))) => {
                    let path = folder.join(name);
                    let before = match put {
                        "append" => std::fs::read_to_string(&path)
                            .with_context(|| format!("{place}: there is no {name} yet"))?,
                        _ => String::new(),
                    };
                    let whole = before + &block.text;
                    std::fs::write(&path, &whole)?;
                    if whole.contains("\n[layout]") || whole.contains("\n[[throw]]") {
                        reads(name)?;
                        shown += 1;
                    }
                }
                // Other blocks of TOML are fragments, which show a few keys.
                ("toml", _) if named => {
                    std::fs::write(folder.join("engine.toml"), &block.text)?;
                    reads("engine.toml")?;
                    shown += 1;
                }
                ("sh", _) => {
                    // A page makes its own files; engines of the gallery that later lines are about in any case.
                    let makes =
                        |line: &str| line.starts_with("lanchester new ") && line.contains(" --output");
                    for line in block.text.lines().filter(|line| block.tag == "run" || makes(line)) {
                        run_in(program, &folder, line).with_context(|| format!("{place}: `{line}`"))?;
                    }
                    let ours = block.text.lines().rfind(|line| line.starts_with("lanchester "));
                    last_command = ours.map(str::to_owned).or(last_command);
                }
                ("text", _) if block.tag.starts_with("says") => {
                    let (_, said) = match block.tag.strip_prefix("says-") {
                        Some(command) => said(&[command, "engine.toml"])?,
                        None => {
                            let line =
                                last_command.as_deref().with_context(|| format!("{place}: who says?"))?;
                            let words: Vec<String> = arguments(line).iter().skip(1).map(shipped).collect();
                            said(&words.iter().map(String::as_str).collect::<Vec<_>>())?
                        }
                    };
                    let said = words(&said);
                    let quote = words(block.text.trim_end().trim_end_matches("..."));
                    ensure!(said.contains(&quote), "{place}: quotes what is not said; it says\n{said}");
                    quoted += 1;
                }
                _ => {}
            }
        }
    }
    ensure!(shown > 0 && quoted > 0, "the documents show no engine");
    Ok(format!("{shown} engine files, {quoted} quotations"))
}

/// Runs a line of a page among the page's own files.
fn run_in(program: &Path, folder: &Path, line: &str) -> Result<()> {
    let words: Vec<String> = arguments(line).iter().map(shipped).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["cp", from, to] => std::fs::copy(folder.join(from), folder.join(to)).map(drop).map_err(Into::into),
        ["lanchester", words @ ..] => quiet(Command::new(program).args(words).current_dir(folder)).map(drop),
        _ => bail!("not a kind of command that a page may run"),
    }
}

/// A word of a command line, where it names a shipped example or engine of the validation with its whole path.
fn shipped(word: &String) -> String {
    match word.starts_with("examples/") || word.starts_with("validation/") {
        true => root().join(word).display().to_string(),
        false => word.clone(),
    }
}

/// A file as a page shows it, with all that goes to its end.
pub fn file_of(page: &str, name: &str) -> Result<String> {
    let text = text(page)?.with_context(|| format!("{page} is not UTF-8"))?;
    let mut file = String::new();
    for block in blocks(&text) {
        match block.tag.split_once('=') {
            Some(("file", of)) if of == name => file = block.text,
            Some(("append", of)) if of == name => file += &block.text,
            _ => {}
        }
    }
    ensure!(!file.is_empty(), "{page} shows no file {name}");
    Ok(file)
}

/// The words of a command line, quoted ones whole, without a comment.
pub fn arguments(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for letter in line.chars() {
        match (quote, letter) {
            (None, '#') if word.is_none() => break,
            (None, '"' | '\'') => {
                word.get_or_insert_default();
                quote = Some(letter);
            }
            (Some(open), _) if letter == open => quote = None,
            (None, _) if letter.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words
}

/// The text without its line breaks.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Runs the README's commands as they are printed.
pub fn commands() -> Result<String> {
    let readme = text("README.md")?.context("README.md is not UTF-8")?;
    let commands = command_lines(&readme);
    ensure!(!commands.is_empty(), "the README names no command");
    compiled_once()?;
    let before = tracked_changes()?;
    for command in &commands {
        run_one(command).with_context(|| format!("README: `{command}`"))?;
    }
    let after = tracked_changes()?;
    ensure!(before == after, "the README's commands changed the working tree:\n{after}");
    Ok(format!("{} commands", commands.len()))
}

/// The program that the README's commands build is the one that was built with the tests: nothing is compiled for it alone.
fn compiled_once() -> Result<()> {
    let mut build = crate::command::cargo();
    build.args(["build", "--release", "--message-format", "json-render-diagnostics"]).current_dir(root());
    let said = quiet(&mut build)?;
    let messages = said.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok());
    let compiled: Vec<String> = messages
        .filter(|message| message["fresh"].as_bool() == Some(false))
        // The program itself may be linked anew: its build script reads the commit.
        .filter(|message| message["target"]["kind"][0] != "bin")
        .map(|message| message["target"]["name"].to_string())
        .collect();
    ensure!(
        compiled.is_empty(),
        "compiled with other features than for the tests: {}; `cargo tree -e features` tells which, `crates/cli/Cargo.toml` asks for them",
        compiled.join(", ")
    );
    Ok(())
}

/// One command line: our own commands run, that task is known to exist, getting the source is left out.
fn run_one(command: &str) -> Result<()> {
    let words = arguments(command);
    match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["git", "clone", ..] | ["cd", ..] => Ok(()),
        // `cargo xtask python` builds, installs and tests the package.
        ["pip", "install", ".[notebooks]"] => Ok(()),
        // This is that task; running it here would never end.
        ["cargo", "xtask", "ci"] => Ok(()),
        ["cargo", "run", "--release", "--", arguments @ ..] => {
            let mut run = crate::command::cargo();
            run.args(["run", "--release", "--quiet", "--"]).args(arguments).current_dir(root());
            quiet(&mut run).map(drop)
        }
        _ => bail!("not a kind of command that the README may name"),
    }
}

/// A fenced block: its language, what follows the language after a comma, its text and its first line.
pub struct Block<'a> {
    /// "toml", "sh", "text".
    pub language: &'a str,
    /// What follows the language after a comma.
    pub tag: &'a str,
    /// Its lines.
    pub text: String,
    line: usize,
}

/// The fenced blocks of a page.
pub fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut found = Vec::new();
    let mut open: Option<Block> = None;
    for (index, line) in page.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => {
                let (language, tag) = info.trim().split_once(',').unwrap_or((info.trim(), ""));
                open = Some(Block { language, tag, text: String::new(), line: index + 2 });
            }
            (Some(_), Some(_)) => found.extend(open.take()),
            (Some(block), None) => {
                block.text.push_str(line);
                block.text.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// Lines of the `sh` blocks without comments.
fn command_lines(readme: &str) -> Vec<String> {
    let blocks = blocks(readme);
    let lines = blocks.iter().filter(|block| block.language == "sh").flat_map(|block| block.text.lines());
    let bare = lines.map(|line| line.split(" #").next().unwrap_or_default().trim());
    bare.filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect()
}

fn tracked_changes() -> Result<String> {
    quiet(Command::new("git").args(["status", "--porcelain"]).current_dir(root()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_the_lines_of_shell_blocks() {
        let text =
            "```sh\n# first\ncargo xtask ci   # all tests\n```\n```toml\na = 1\n```\n```text\nx\n```\n";
        assert_eq!(command_lines(text), ["cargo xtask ci"]);
        let toml = &blocks("```toml,wrong\na = 1\n```\n")[0];
        assert_eq!((toml.language, toml.tag, toml.text.as_str(), toml.line), ("toml", "wrong", "a = 1\n", 2));
    }

    #[test]
    fn quoted_words_stay_whole() {
        assert_eq!(
            arguments("lanchester balance a.toml --limit 'couple = 40 N m' --most \"3 g mm\" # so"),
            ["lanchester", "balance", "a.toml", "--limit", "couple = 40 N m", "--most", "3 g mm"]
        );
    }

    #[test]
    fn unknown_commands_are_refused() {
        assert!(run_one("curl https://example.org").is_err());
        assert!(run_one("cargo xtask ci").is_ok());
    }
}
