//! `cargo xtask hostile`: what a tool must stand: mutated files, kills, laws over random engines, attacks on the studio.
//!
//! Every kind of trial has a share of the time. The seed is printed; the same seed draws the same trials, though kills fall where the
//! clock lets them.

mod attacks;
mod kills;
mod laws;
mod mutants;
mod random;

use crate::workspace::{program, scratch};
use anyhow::{Context, Result, bail, ensure};
use random::Random;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Seconds of a night's run, and of the short form in CI.
const NIGHT: u64 = 1200;
const SHORT: u64 = 16;
/// What CI draws from: a change is judged by its own trials only (decision 20).
const SHORT_SEED: u64 = 1;
/// Nothing that is refused or computed here may last longer.
const PATIENCE: Duration = Duration::from_secs(60);

/// What trials work with.
pub struct Ground {
    /// The program.
    program: PathBuf,
    /// A folder for files.
    folder: PathBuf,
    /// The trials end then.
    end: Instant,
    random: Random,
}

/// One kind of trials: gives how many there were.
type Kind = fn(&mut Ground) -> Result<u64>;

const KINDS: [(&str, Kind); 5] = [
    ("mutated engine files", mutants::engines),
    ("mutated workshop sheets", mutants::sheets),
    ("kills during writes and runs", kills::run),
    ("symmetry and scaling laws over random engines", laws::run),
    ("attacks on the studio", attacks::run),
];

/// Options: `--seconds N` in all (1200), `--seed N` (of the clock), `--only TEXT` for kinds whose names hold it, `--short` as in CI.
pub fn run(arguments: &[String]) -> Result<()> {
    let clock = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs();
    let (mut seconds, mut seed, mut only) = (NIGHT, clock, String::new());
    let mut arguments = arguments.iter();
    while let Some(option) = arguments.next() {
        if option == "--short" {
            (seconds, seed) = (SHORT, SHORT_SEED);
            continue;
        }
        let value = arguments.next().with_context(|| format!("`{option}` needs a value"))?;
        let number = || value.parse::<u64>().with_context(|| format!("`{value}` is no whole number"));
        match option.as_str() {
            "--seconds" => seconds = number()?,
            "--seed" => seed = number()?,
            "--only" => value.clone_into(&mut only),
            _ => bail!("unknown option `{option}`; there are --seconds, --seed, --only and --short"),
        }
    }
    println!("{}", trials(&program()?, seconds, seed, &only)?);
    Ok(())
}

/// The short form.
pub fn short(program: &Path) -> Result<String> {
    trials(program, SHORT, SHORT_SEED, "")
}

fn trials(program: &Path, seconds: u64, seed: u64, only: &str) -> Result<String> {
    let chosen: Vec<_> = KINDS.iter().filter(|(name, _)| name.contains(only)).collect();
    ensure!(!chosen.is_empty(), "no kind of trials has `{only}` in its name");
    println!("   seed {seed}, {seconds} s in all");
    let share = Duration::from_secs(seconds) / u32::try_from(chosen.len())?;
    let (mut all, mut failed) = (0, Vec::new());
    for (name, kind) in &chosen {
        let folder = scratch("hostile")?;
        let end = Instant::now() + share;
        let mut ground = Ground { program: program.to_path_buf(), folder, end, random: Random::new(seed) };
        match kind(&mut ground) {
            Ok(count) => {
                println!("   {count:6} trials: {name}");
                all += count;
            }
            Err(error) => {
                println!("   failed: {name}\n{error:#}");
                failed.push(format!("cargo xtask hostile --seed {seed} --seconds {seconds} --only '{name}'"));
            }
        }
    }
    ensure!(failed.is_empty(), "{} kinds of trials failed:\n{}", failed.len(), failed.join("\n"));
    Ok(format!("{all} trials, seed {seed}"))
}

impl Ground {
    /// Whether there is time for another trial; there is for a first one.
    fn goes_on(&self, count: u64) -> bool {
        count == 0 || Instant::now() < self.end
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(&self.folder).stdin(Stdio::null());
        command
    }

    /// Runs the program to its end with its output in files, which no pipe can hold up: status and what it said.
    fn run(&self, arguments: &[&str]) -> Result<Said> {
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
fn start(text: &str) -> String {
    text.chars().take(2000).collect()
}

/// What a run said.
struct Said {
    /// Exit status; `None` after a signal.
    status: Option<i32>,
    out: String,
    err: String,
}

impl Said {
    /// Whether it ended as a program ends that was asked nonsense: an answer, or a refusal that says why.
    fn is_sound(&self) -> bool {
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
