//! The documents hold what they say: the commands of the README run, every engine file shown is read.

use crate::command::quiet;
use crate::workspace::{files, root, scratch, text};
use anyhow::{Context, Result, bail, ensure};
use std::path::Path;
use std::process::Command;

/// Every whole engine file in the README and in the book through `check` and `loads`, without a warning.
pub fn engines(program: &Path) -> Result<String> {
    let folder = scratch("documents")?;
    let mut count = 0;
    for page in files()?.iter().filter(|file| *file == "README.md" || file.starts_with("docs/src/")) {
        let Some(text) = text(page)? else { continue };
        for (block, start) in blocks(&text, "toml") {
            // Others are fragments, which show a few keys.
            if !block.lines().any(|line| line.starts_with("name = ")) {
                continue;
            }
            let file = folder.join("engine.toml");
            std::fs::write(&file, block)?;
            for command in ["check", "loads"] {
                let mut run = Command::new(program);
                let finished = crate::command::output(run.arg(command).arg(&file))?;
                let said = format!("{}{}", finished.stdout, finished.stderr);
                ensure!(
                    finished.status == 0 && finished.stderr.is_empty(),
                    "{page}:{start}: `{command}` says\n{said}"
                );
            }
            count += 1;
        }
    }
    ensure!(count > 0, "the documents show no engine");
    Ok(format!("{count} engine files"))
}

/// Runs the README's commands as they are printed.
pub fn commands() -> Result<String> {
    let readme = text("README.md")?.context("README.md is not UTF-8")?;
    let commands = command_lines(&readme);
    ensure!(!commands.is_empty(), "the README names no command");
    let before = tracked_changes()?;
    for command in &commands {
        run_one(command).with_context(|| format!("README: `{command}`"))?;
    }
    let after = tracked_changes()?;
    ensure!(before == after, "the README's commands changed the working tree:\n{after}");
    Ok(format!("{} commands", commands.len()))
}

/// One command line: our own commands run, that task is known to exist, getting the source is left out.
fn run_one(command: &str) -> Result<()> {
    let words: Vec<&str> = command.split_whitespace().collect();
    match words.as_slice() {
        ["git", "clone", ..] | ["cd", ..] => Ok(()),
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

/// Contents of the fenced blocks of a language, each with the line that it starts on.
fn blocks(text: &str, language: &str) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    let mut open: Option<(bool, String, usize)> = None;
    for (index, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((info.trim() == language, String::new(), index + 2)),
            (Some(_), Some(_)) => {
                let (wanted, block, start) = open.take().expect("invariant: a block is open");
                if wanted {
                    found.push((block, start));
                }
            }
            (Some((_, block, _)), None) => {
                block.push_str(line);
                block.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// Lines of the `sh` blocks without comments.
fn command_lines(readme: &str) -> Vec<String> {
    let blocks = blocks(readme, "sh");
    let lines = blocks.iter().flat_map(|(block, _)| block.lines());
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
        assert_eq!(blocks(text, "toml"), [("a = 1\n".to_owned(), 6)]);
    }

    #[test]
    fn unknown_commands_are_refused() {
        assert!(run_one("curl https://example.org").is_err());
        assert!(run_one("cargo xtask ci").is_ok());
    }
}
