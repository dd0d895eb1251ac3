//! The README holds what it says: its commands run, its engine file is read.

use crate::command::quiet;
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, bail, ensure};
use std::path::Path;
use std::process::Command;

/// Runs the commands as they are printed, in a scratch folder for what they write.
pub fn run() -> Result<String> {
    let readme = std::fs::read_to_string(root().join("README.md")).context("cannot read README.md")?;
    let folder = scratch("readme")?;
    for (index, engine) in blocks(&readme, "toml").iter().enumerate() {
        let file = folder.join(format!("engine-{index}.toml"));
        std::fs::write(&file, engine)?;
        quiet(program().arg("check").arg(&file))?;
        quiet(program().arg("loads").arg(&file))?;
    }
    let commands = commands(&readme);
    ensure!(!commands.is_empty(), "the README names no command");
    let before = tracked_changes()?;
    for command in &commands {
        run_one(command, &folder).with_context(|| format!("README: `{command}`"))?;
    }
    let after = tracked_changes()?;
    ensure!(before == after, "the README's commands changed the working tree:\n{after}");
    Ok(format!("{} commands", commands.len()))
}

fn program() -> Command {
    let mut command = crate::command::cargo();
    command.args(["run", "--release", "--quiet", "--"]).current_dir(root());
    command
}

/// One command line: our own commands run, the tasks are known to exist, getting the source is left out.
fn run_one(command: &str, folder: &Path) -> Result<()> {
    let words: Vec<&str> = command.split_whitespace().collect();
    match words.as_slice() {
        ["git", "clone", ..] | ["cd", ..] => Ok(()),
        // This is that task; running it here would never end.
        ["cargo", "xtask", "ci"] => Ok(()),
        ["cargo", "run", "--release", "--", arguments @ ..] => {
            // Files named README-relative are read from the root; what is written goes to the scratch folder.
            let arguments = arguments.iter().map(|word| match word.strip_prefix("out/") {
                Some(name) => folder.join(name).into_os_string(),
                None => word.into(),
            });
            quiet(program().args(arguments)).map(drop)
        }
        _ => bail!("not a kind of command that the README may name"),
    }
}

/// Contents of the fenced blocks of a language.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut open: Option<(bool, String)> = None;
    for line in text.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((info.trim() == language, String::new())),
            (Some(_), Some(_)) => {
                let (wanted, block) = open.take().expect("invariant: a block is open");
                if wanted {
                    found.push(block);
                }
            }
            (Some((_, block)), None) => {
                block.push_str(line);
                block.push('\n');
            }
            (None, None) => {}
        }
    }
    found
}

/// Lines of the `sh` blocks without comments.
fn commands(readme: &str) -> Vec<String> {
    let lines = blocks(readme, "sh");
    let lines = lines.iter().flat_map(|block| block.lines());
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
        assert_eq!(commands(text), ["cargo xtask ci"]);
        assert_eq!(blocks(text, "toml"), ["a = 1\n"]);
    }

    #[test]
    fn unknown_commands_are_refused() {
        assert!(run_one("curl https://example.org", Path::new(".")).is_err());
        assert!(run_one("cargo xtask ci", Path::new(".")).is_ok());
    }
}
