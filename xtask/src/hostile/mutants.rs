//! Engine files and workshop sheets with mistakes that nobody makes on purpose.

use super::ground::{Ground, Said, start};
use super::random::Random;
use crate::workspace::{files, root};
use anyhow::{Context, Result, ensure};

const OF_ENGINES: [&[&str]; 12] = [
    &["check", "FILE"],
    &["check", "FILE", "--format", "json"],
    &["loads", "FILE"],
    &["loads", "FILE", "--format", "csv"],
    &["show", "FILE"],
    &["bearings", "FILE"],
    &["torque", "FILE"],
    &["mounts", "FILE"],
    &["counterweight", "check", "FILE"],
    &["report", "FILE", "--output", "-"],
    &["scatter", "FILE", "--samples", "50"],
    &["balance", "FILE", "--dry-run"],
];

const OF_SHEETS: [&[&str]; 4] = [
    &["workshop", "correct", "FILE"],
    &["workshop", "correct", "FILE", "--format", "json"],
    &["workshop", "drill", "FILE"],
    &["workshop", "grade", "FILE"],
];

/// What stands in the place of a value.
const VALUES: [&str; 22] = [
    "0",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "nan",
    "inf",
    "\"0 mm\"",
    "\"-3 kg\"",
    "\"1e300 m\"",
    "\"NaN kg\"",
    "\"5\"",
    "\"\"",
    "[]",
    "[[]]",
    "{}",
    "true",
    "9223372036854775808",
    "\"\\u0000\\u001b[31m\"",
    "\"1 2 3 mm\"",
    "\"\u{202e}mm\"",
    "[1, \"2\", {}]",
];

pub fn engines(ground: &mut Ground) -> Result<u64> {
    let sources = sources(|file| {
        file.ends_with(".toml")
            && (file.starts_with("examples/in-line")
                || file.starts_with("examples/twin")
                || file.starts_with("examples/v6")
                || file.starts_with("examples/single"))
    })?;
    mutate_all(ground, &sources, &OF_ENGINES)
}

pub fn sheets(ground: &mut Ground) -> Result<u64> {
    let sources = sources(|file| {
        file.ends_with(".toml") && (file.starts_with("examples/workshop/") || file.contains("/bad-runs/"))
    })?;
    mutate_all(ground, &sources, &OF_SHEETS)
}

fn sources(wanted: impl Fn(&str) -> bool) -> Result<Vec<String>> {
    let names: Vec<String> = files()?.into_iter().filter(|file| wanted(file)).collect();
    ensure!(names.len() > 2, "there are no files to mutate");
    names
        .iter()
        .map(|name| std::fs::read_to_string(root().join(name)).with_context(|| name.clone()))
        .collect()
}

fn mutate_all(ground: &mut Ground, sources: &[String], commands: &[&[&str]]) -> Result<u64> {
    let mut count = 0;
    while ground.goes_on(count) {
        let text = ground.random.pick(sources).clone();
        let bytes = mutated(text, &mut ground.random);
        std::fs::write(ground.folder.join("mutant.toml"), &bytes)?;
        let arguments: Vec<&str> = ground
            .random
            .pick(commands)
            .iter()
            .map(|word| if *word == "FILE" { "mutant.toml" } else { word })
            .collect();
        let said = ground.run(&arguments)?;
        if !said.is_sound() {
            let kept = crate::workspace::target()?.join("xtask").join("hostile-mutant.toml");
            std::fs::write(&kept, &bytes)?;
            let Said { status, out, err } = said;
            let (out, err) = (start(&out), start(&err));
            anyhow::bail!("`{}` of {}: {status:?}\n{out}{err}", arguments.join(" "), kept.display());
        }
        count += 1;
    }
    Ok(count)
}

/// A text with one to four mistakes.
fn mutated(text: String, random: &mut Random) -> Vec<u8> {
    let mut lines: Vec<Vec<u8>> = text.lines().map(|line| line.as_bytes().to_vec()).collect();
    for _ in 0..=random.below(4) {
        if lines.is_empty() {
            break;
        }
        let at = random.below(lines.len());
        match random.below(8) {
            0 => drop(lines.remove(at)),
            1 => {
                let line = lines[at].clone();
                lines.insert(random.below(lines.len()), line);
            }
            2 => {
                let other = random.below(lines.len());
                lines.swap(at, other);
            }
            3 if !lines[at].is_empty() => {
                let byte = random.below(lines[at].len());
                lines[at][byte] ^= 1 << random.below(8);
            }
            4 => lines[at].push(random.byte()),
            5 if random.below(4) == 0 => lines.truncate(at),
            // Values of engine files stand behind an equals sign.
            _ => {
                if let Some(equals) = lines[at].iter().position(|byte| *byte == b'=') {
                    lines[at].truncate(equals + 1);
                    let value = *random.pick(&VALUES);
                    lines[at].extend_from_slice(value.as_bytes());
                }
            }
        }
    }
    lines.join(&b'\n')
}
