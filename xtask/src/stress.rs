//! `cargo xtask stress`: the properties over random engines with new cases, again and again.

use crate::command::output;
use crate::test_programs;
use crate::workspace::Profile;
use anyhow::{Context, Result, bail, ensure};
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// One property: the program that holds it, the folder it runs in, its name.
struct Property {
    program: PathBuf,
    folder: PathBuf,
    name: String,
}

/// Options: `--seconds N` for each property (10), `--only TEXT` for those whose names hold it.
pub fn run(arguments: &[String]) -> Result<()> {
    let (mut seconds, mut only) = (10_u64, String::new());
    let mut arguments = arguments.iter();
    while let Some(option) = arguments.next() {
        let value = arguments.next().with_context(|| format!("`{option}` needs a value"))?;
        match option.as_str() {
            "--seconds" => {
                seconds = value.parse().with_context(|| format!("`{value}` is no number of seconds"))?;
            }
            "--only" => value.clone_into(&mut only),
            _ => bail!("unknown option `{option}`; there are --seconds and --only"),
        }
    }
    let found = properties(&only)?;
    ensure!(!found.is_empty(), "no property has `{only}` in its name");
    let mut seed = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs();
    let mut failed = Vec::new();
    for property in &found {
        let (start, mut rounds) = (Instant::now(), 0);
        while rounds == 0 || start.elapsed() < Duration::from_secs(seconds) {
            (seed, rounds) = (seed + 1, rounds + 1);
            if let Err(said) = property.holds(seed) {
                println!("\n{said:#}");
                failed.push(format!("PROPTEST_RNG_SEED={seed} cargo test {} -- --exact", property.name));
                break;
            }
        }
        println!("{:4} times  {}", rounds, property.name);
    }
    ensure!(
        failed.is_empty(),
        "{} of {} properties failed:\n{}",
        failed.len(),
        found.len(),
        failed.join("\n")
    );
    println!("{} properties held", found.len());
    Ok(())
}

impl Property {
    /// Runs it once with the cases of a seed; an error is all that it printed.
    fn holds(&self, seed: u64) -> Result<()> {
        let mut test = Command::new(&self.program);
        test.args([self.name.as_str(), "--exact"]).current_dir(&self.folder);
        test.env("PROPTEST_RNG_SEED", seed.to_string());
        let finished = output(&mut test)?;
        ensure!(finished.status == 0, "{}{}", finished.stdout, finished.stderr);
        ensure!(finished.stdout.contains("1 passed"), "{} was not run:\n{}", self.name, finished.stdout);
        Ok(())
    }
}

/// All tests of the workspace named `prop_` whose names hold a text.
fn properties(only: &str) -> Result<Vec<Property>> {
    let mut found = Vec::new();
    for program in test_programs::programs(Profile::Dev)? {
        for name in program.tests()? {
            let own = name.rsplit("::").next().unwrap_or(&name);
            if own.starts_with("prop_") && name.contains(only) {
                found.push(Property { program: program.path.clone(), folder: program.folder.clone(), name });
            }
        }
    }
    Ok(found)
}
