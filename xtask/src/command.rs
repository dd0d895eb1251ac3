//! Running a program: quietly with its output on failure, or in view.

use anyhow::{Context, Result, bail};
use std::process::Command;

/// The cargo that runs this task.
pub fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// What a program printed and how it ended.
pub struct Finished {
    /// Exit status; -1 after a signal.
    pub status: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// Runs it to its end, whatever its exit status.
pub fn output(command: &mut Command) -> Result<Finished> {
    let output = command.output().with_context(|| format!("cannot start `{}`", line(command)))?;
    Ok(Finished {
        status: output.status.code().unwrap_or(-1),
        stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
        stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
    })
}

/// Runs it and returns its standard output; any exit status but 0 is an error with all that it printed.
pub fn quiet(command: &mut Command) -> Result<String> {
    let finished = output(command)?;
    if finished.status != 0 {
        bail!("`{}` ended with {}\n{}{}", line(command), finished.status, finished.stdout, finished.stderr);
    }
    Ok(finished.stdout)
}

/// Runs it with its output in view.
pub fn in_view(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("cannot start `{}`", line(command)))?;
    if !status.success() {
        bail!("`{}` failed: {status}", line(command));
    }
    Ok(())
}

/// The command as one would type it.
pub fn line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

/// Whether a program of this name can be started: some know one word for their version, some the other.
pub fn exists(program: &str) -> bool {
    let says = |word| Command::new(program).arg(word).output().is_ok_and(|output| output.status.success());
    says("--version") || says("-v")
}
