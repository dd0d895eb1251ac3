//! `cargo xtask hostile`: what a tool must stand: mutated files, kills, laws over random engines, attacks on the studio.
//!
//! Every kind of trial has a share of the time; in the short form a number of trials. The seed is printed; the same seed draws the same trials, though kills fall where the
//! clock lets them.

mod attacks;
mod ground;
mod kills;
mod laws;
mod mutants;
mod random;

use crate::workspace::{Profile, program, scratch};
use anyhow::{Context, Result, bail, ensure};
use ground::{End, Ground};
use random::Random;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Seconds of a night's run.
const NIGHT: u64 = 1200;
/// What CI draws from: a change is judged by its own trials only (decision 20).
const SHORT_SEED: u64 = 1;

/// One kind of trials: gives how many there were.
type Kind = fn(&mut Ground) -> Result<u64>;

/// Names, trials, and how many of them the short form in CI has: as many on a slow machine as on a fast one.
const KINDS: [(&str, Kind, u64); 5] = [
    ("mutated engine files", mutants::engines, 120),
    ("mutated workshop sheets", mutants::sheets, 120),
    ("kills during writes and runs", kills::run, 15),
    ("symmetry and scaling laws over random engines", laws::run, 60),
    ("attacks on the studio", attacks::run, 120),
];

/// Options: `--seconds N` in all (1200), `--seed N` (of the clock), `--only TEXT` for kinds whose names hold it, `--short` as in CI.
pub fn run(arguments: &[String]) -> Result<()> {
    let clock = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs();
    let (mut seconds, mut seed, mut only) = (Some(NIGHT), clock, String::new());
    let mut arguments = arguments.iter();
    while let Some(option) = arguments.next() {
        if option == "--short" {
            (seconds, seed) = (None, SHORT_SEED);
            continue;
        }
        let value = arguments.next().with_context(|| format!("`{option}` needs a value"))?;
        let number = || value.parse::<u64>().with_context(|| format!("`{value}` is no whole number"));
        match option.as_str() {
            "--seconds" => seconds = Some(number()?),
            "--seed" => seed = number()?,
            "--only" => value.clone_into(&mut only),
            _ => bail!("unknown option `{option}`; there are --seconds, --seed, --only and --short"),
        }
    }
    println!("{}", trials(&program(Profile::Dev)?, seconds, seed, &only)?);
    Ok(())
}

/// The short form.
pub fn short(program: &Path) -> Result<String> {
    trials(program, None, SHORT_SEED, "")
}

fn trials(program: &Path, seconds: Option<u64>, seed: u64, only: &str) -> Result<String> {
    let chosen: Vec<_> = KINDS.iter().filter(|(name, ..)| name.contains(only)).collect();
    ensure!(!chosen.is_empty(), "no kind of trials has `{only}` in its name");
    let all_seconds = seconds.map_or("the short form".to_owned(), |seconds| format!("{seconds} s in all"));
    println!("   seed {seed}, {all_seconds}");
    let kinds = u32::try_from(chosen.len())?;
    let (mut all, mut failed) = (0, Vec::new());
    for (name, kind, short) in &chosen {
        let folder = scratch("hostile")?;
        let end = match seconds {
            Some(seconds) => End::At(Instant::now() + Duration::from_secs(seconds) / kinds),
            None => End::After(*short),
        };
        let mut ground = Ground { program: program.to_path_buf(), folder, end, random: Random::new(seed) };
        match kind(&mut ground) {
            Ok(count) => {
                println!("   {count:6} trials: {name}");
                all += count;
            }
            Err(error) => {
                println!("   failed: {name}\n{error:#}");
                let length = seconds
                    .map_or("--short".to_owned(), |seconds| format!("--seed {seed} --seconds {seconds}"));
                failed.push(format!("cargo xtask hostile {length} --only '{name}'"));
            }
        }
    }
    ensure!(failed.is_empty(), "{} kinds of trials failed:\n{}", failed.len(), failed.join("\n"));
    Ok(format!("{all} trials, seed {seed}"))
}
