//! Long runs whose saved blocks a disk or a copy has changed: nothing is computed from them.

use crate::explore::gallery;
use crate::long_runs::runs::bytes;
use crate::program::{folder, lanchester, message, output};
use std::fs;
use std::path::{Path, PathBuf};

const SEARCH: [&str; 8] = [
    "explore",
    "v6-60.toml",
    "--bank-angle",
    "60 deg .. 120 deg by 15 deg",
    "--split-angle",
    "-60 deg .. 60 deg by 15 deg",
    "--rod-ratio",
    "0.3",
];

fn search<'a>(table: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&SEARCH[..], &["--save", table], more].concat()
}

/// Flips one bit in each of some places, one after the other, and puts the file right again.
fn flip_each(file: &Path, mut then: impl FnMut(usize)) {
    let whole = fs::read(file).unwrap();
    for k in 0..24 {
        let byte = k * (whole.len() - 1) / 23;
        let mut damaged = whole.clone();
        damaged[byte] ^= 1 << (k % 8);
        fs::write(file, damaged).unwrap();
        then(byte);
    }
    fs::write(file, whole).unwrap();
}

/// A run whose blocks are on the disk, but whose table is not.
#[cfg(target_os = "linux")]
fn begun(folder: &Path, table: &str) -> Vec<PathBuf> {
    std::os::unix::fs::symlink("/dev/full", folder.join(table)).unwrap();
    message(folder, 2, &search(table, &["--threads", "1"]));
    fs::remove_file(folder.join(table)).unwrap();
    let entries = fs::read_dir(folder.join(format!("{table}.run"))).unwrap().flatten();
    let mut tables: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    tables.retain(|path| path.extension().is_some_and(|ending| ending == "parquet"));
    tables.sort();
    tables
}

#[cfg(target_os = "linux")]
#[test]
fn a_run_goes_on_from_no_damaged_block() {
    let folder = folder("runs-damaged");
    gallery(&folder, "v6-60");
    output(&folder, 0, &search("whole.parquet", &[]));
    let stretches = begun(&folder, "cases.parquet");
    let name = stretches[0].file_name().unwrap().to_str().unwrap();
    // Named from 0 with the end excluded, told from 1.
    let end: u64 = name.trim_end_matches(".parquet").split_once('-').unwrap().1.parse().unwrap();
    let blocks = if end == 1 { "block 1 of ".to_owned() } else { format!("blocks 1 to {end} of ") };
    flip_each(&stretches[0], |byte| {
        let told = message(&folder, 2, &search("cases.parquet", &[]));
        assert!(told.contains(&blocks), "byte {byte}: {told}");
        assert!(told.contains(name) && told.contains("hint: remove this file"), "byte {byte}: {told}");
        assert!(!folder.join("cases.parquet").exists());
    });
    // Its suggested fix: only what is removed is computed again.
    fs::remove_file(&stretches[0]).unwrap();
    let run = lanchester(&folder, &search("cases.parquet", &[]));
    assert!(run.status.success(), "{run:?}");
    assert!(bytes(&folder, "cases.parquet") == bytes(&folder, "whole.parquet"), "another table");
}

#[test]
fn a_gap_in_the_middle_of_a_run_is_filled() {
    let folder = folder("runs-gap");
    gallery(&folder, "v6-60");
    let more = ["--even-firing", "--throw-angles", "every 5 deg", "--threads", "1"];
    let killed = crate::long_runs::runs::kill_twice(&folder, "cases.parquet", |times| {
        let mut run: Vec<String> = search("cases.parquet", &more).iter().map(ToString::to_string).collect();
        run[7] = format!("0.20 .. 0.45 by {}", 0.005 / f64::from(times));
        run
    });
    let mut arguments: Vec<&str> = killed.iter().map(String::as_str).collect();
    let entries = fs::read_dir(folder.join("cases.parquet.run")).unwrap().flatten();
    let first = entries.map(|entry| entry.path()).filter(|path| path.extension().is_some()).min().unwrap();
    fs::remove_file(first).unwrap();
    let went_on = lanchester(&folder, &arguments);
    assert!(String::from_utf8_lossy(&went_on.stderr).contains("going on after"), "{went_on:?}");
    arguments[9] = "whole.parquet";
    arguments.truncate(arguments.len() - 2);
    assert_eq!(output(&folder, 0, &arguments).into_bytes(), went_on.stdout);
    assert!(bytes(&folder, "cases.parquet") == bytes(&folder, "whole.parquet"), "another table");
}

#[test]
fn no_damaged_part_is_merged_and_no_damaged_table_read() {
    let folder = folder("runs-damaged-parts");
    gallery(&folder, "v6-60");
    output(&folder, 0, &search("1.parquet", &["--part", "1/2"]));
    output(&folder, 0, &search("2.parquet", &["--part", "2/2"]));
    flip_each(&folder.join("2.parquet"), |byte| {
        let told = message(&folder, 2, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
        assert!(told.contains("cannot read 2.parquet") && told.contains("hint: "), "byte {byte}: {told}");
        assert!(!folder.join("x.parquet").exists());
    });
    // Rows that are not what was written: which, and which blocks the file holds.
    let whole = fs::read(folder.join("2.parquet")).unwrap();
    let mut damaged = whole.clone();
    damaged[whole.len() / 10] ^= 4;
    fs::write(folder.join("2.parquet"), damaged).unwrap();
    let told = message(&folder, 2, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
    assert!(
        told.contains("cannot read 2.parquet, which holds block") && told.contains(": rows 1 to "),
        "{told}"
    );
    fs::write(folder.join("2.parquet"), whole).unwrap();
    // A part that was cut short, and one without hashes: what an earlier version wrote.
    let part = fs::read(folder.join("1.parquet")).unwrap();
    fs::write(folder.join("1.parquet"), &part[..part.len() - 100]).unwrap();
    let told = message(&folder, 2, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
    assert!(told.contains("cannot read 1.parquet"), "{told}");
    let key = b"lanchester.block_sha256";
    let place = part.windows(key.len()).position(|some| some == key).unwrap();
    let mut old = part.clone();
    old[place..place + key.len()].copy_from_slice(b"lanchester.other_entry_");
    fs::write(folder.join("1.parquet"), old).unwrap();
    let told = message(&folder, 2, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
    assert!(
        told.contains("an older version wrote it") && told.contains("hint: run again what made it"),
        "{told}"
    );
    fs::write(folder.join("1.parquet"), part).unwrap();
    output(&folder, 0, &["merge", "1.parquet", "2.parquet", "--output", "x.parquet"]);
    // A table that is there already is not taken for what the command would give.
    flip_each(&folder.join("2.parquet"), |byte| {
        let told = message(&folder, 2, &search("2.parquet", &["--part", "2/2"]));
        assert!(told.contains("2.parquet"), "byte {byte}: {told}");
    });
    output(&folder, 0, &search("cases.csv", &[]));
    for file in ["cases.csv", "cases.csv.json"] {
        // White space between the entries of the JSON says nothing.
        let said = output(&folder, 0, &search("cases.csv", &[]));
        flip_each(&folder.join(file), |byte| {
            let again = lanchester(&folder, &search("cases.csv", &[]));
            let told = String::from_utf8_lossy(&again.stderr);
            let refused = again.status.code() == Some(2) && told.contains("cases.csv");
            let same = file.ends_with("json") && again.stdout == said.as_bytes();
            assert!(refused || same, "{file} byte {byte}: {again:?}");
        });
    }
}
