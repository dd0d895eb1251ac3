//! Kills at any moment: a file is the old one or the new one, and a run goes on to the same table.

use super::ground::Ground;
use crate::workspace::root;
use anyhow::{Result, ensure};
use std::fs;
use std::process::Stdio;
use std::time::Duration;

const SEARCH: [&str; 10] = [
    "explore",
    "v6.toml",
    "--bank-angle",
    "60 deg .. 120 deg by 15 deg",
    "--split-angle",
    "-60 deg .. 60 deg by 15 deg",
    "--rod-ratio",
    "0.2 .. 0.3 by 0.02",
    "--even-firing",
    "--save",
];

pub fn run(ground: &mut Ground) -> Result<u64> {
    let twin = fs::read_to_string(root().join("examples/twin-in-line-in-phase.toml"))?;
    fs::copy(root().join("examples/v6-60.toml"), ground.folder.join("v6.toml"))?;
    let (file, page) = (ground.folder.join("twin.toml"), ground.folder.join("twin.html"));
    fs::write(&file, &twin)?;
    ensure!(ground.run(&["balance", "twin.toml", "--write"])?.status == Some(0), "the twin is not balanced");
    let after = fs::read_to_string(&file)?;
    fs::write(&file, &twin)?;
    ensure!(ground.run(&["report", "twin.toml", "--output", "twin.html"])?.status == Some(0), "no report");
    let report = fs::read(&page)?;
    let whole = [&SEARCH[..], &["whole.parquet"]].concat();
    ensure!(ground.run(&whole)?.status == Some(0), "no search");
    let whole = fs::read(ground.folder.join("whole.parquet"))?;
    let table = [&SEARCH[..], &["table.parquet"]].concat();
    let mut count = 0;
    while ground.goes_on(count) {
        match count % 3 {
            0 => {
                fs::write(&file, &twin)?;
                kill(ground, &["balance", "twin.toml", "--write"], 60.0)?;
                let now = fs::read_to_string(&file)?;
                ensure!(now == twin || now == after, "a killed --write left\n{now}");
            }
            1 => {
                fs::write(&file, &twin)?;
                let _ = fs::remove_file(&page);
                kill(ground, &["report", "twin.toml", "--output", "twin.html"], 200.0)?;
                let is_whole = fs::read(&page).map_or(true, |now| now == report);
                ensure!(is_whole, "a killed report left a piece of a page");
            }
            _ => {
                kill(ground, &table, 600.0)?;
                if ground.random.below(3) == 0 {
                    let said = ground.run(&table)?;
                    ensure!(said.status == Some(0), "the run does not go on: {}", said.err);
                    let now = fs::read(ground.folder.join("table.parquet"))?;
                    ensure!(now == whole, "the killed run became another table");
                    fs::remove_file(ground.folder.join("table.parquet"))?;
                }
            }
        }
        count += 1;
    }
    Ok(count)
}

/// Starts the program and kills it within some milliseconds.
fn kill(ground: &mut Ground, arguments: &[&str], within: f64) -> Result<()> {
    let pause = ground.random.between(0.0, within);
    let mut child = ground.command(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    std::thread::sleep(Duration::from_secs_f64(pause / 1e3));
    child.kill()?;
    child.wait()?;
    Ok(())
}
