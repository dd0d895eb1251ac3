//! What trials work with: the program, a folder, the time that is left, chance.

use super::random::Random;
use anyhow::{Result, bail};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Nothing that is refused or computed here may last longer.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// When trials end.
pub enum End {
    /// At a time.
    At(Instant),
    /// After as many.
    After(u64),
}

/// What trials work with.
pub struct Ground {
    /// The program.
    pub program: PathBuf,
    /// A folder for files.
    pub folder: PathBuf,
    /// When the trials end.
    pub end: End,
    pub random: Random,
}

impl Ground {
    /// Whether there is another trial; there is a first one.
    pub fn goes_on(&self, count: u64) -> bool {
        match self.end {
            End::At(time) => count == 0 || Instant::now() < time,
            End::After(most) => count < most,
        }
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(&self.folder).stdin(Stdio::null());
        command
    }

    /// Runs the program to its end with its output in files, which no pipe can hold up: status and what it said.
    pub fn run(&self, arguments: &[&str]) -> Result<Said> {
        let open = |name: &str| std::fs::File::create(self.folder.join(name));
        let mut command = self.command(arguments);
        let mut child = command.stdout(open("stdout")?).stderr(open("stderr")?).spawn()?;
        let since = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if since.elapsed() > PATIENCE {
                child.kill()?;
                child.wait()?;
                bail!("`{}` lasts more than {} s", arguments.join(" "), PATIENCE.as_secs());
            }
            std::thread::sleep(Duration::from_millis(1));
        };
        let read = |name: &str| {
            std::fs::read(self.folder.join(name)).map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
        };
        Ok(Said { status: status.code(), out: read("stdout")?, err: read("stderr")? })
    }
}

/// The first letters of a text, for a message.
pub fn start(text: &str) -> String {
    text.chars().take(2000).collect()
}

/// What a run said.
pub struct Said {
    /// Exit status; `None` after a signal.
    pub status: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Said {
    /// Whether it ended as a program ends that was asked nonsense: an answer, or a refusal that says why.
    pub fn is_sound(&self) -> bool {
        let panicked = self.err.contains("panicked at");
        let acts =
            self.err.chars().any(|letter| letter.is_control() && !matches!(letter, '\n' | '\r' | '\t'));
        match self.status {
            Some(0 | 1) => !panicked && !acts,
            // As text on standard error; as JSON among the data.
            Some(2) => !panicked && !acts && (self.err.contains("error") || self.out.contains("\"error\"")),
            _ => false,
        }
    }
}
