//! Long runs: the same table whatever happens on the way.

use crate::explore::gallery;
use crate::program::{folder, lanchester, message, output};
use lanchester::table::{TableReader, Values};
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// A search, its rod ratios left open.
const SEARCH: [&str; 7] = [
    "explore",
    "v6-60.toml",
    "--bank-angle",
    "60 deg .. 120 deg by 15 deg",
    "--split-angle",
    "-60 deg .. 60 deg by 15 deg",
    "--rod-ratio",
];

/// The same with more or fewer rod ratios, into a table.
fn search<'a>(ratios: &'a str, table: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&SEARCH[..], &[ratios, "--save", table], more].concat()
}

pub fn bytes(folder: &Path, table: &str) -> Vec<u8> {
    fs::read(folder.join(table)).unwrap()
}

#[test]
fn threads_and_parts_give_the_same_bytes() {
    let folder = folder("runs-same");
    gallery(&folder, "v6-60");
    for (more, ending) in
        [(&[][..], "parquet"), (&["--front-only"][..], "parquet"), (&["--even-firing"][..], "csv")]
    {
        let name =
            |what: &str| format!("{what}-{}.{ending}", more.first().map_or("all", |option| &option[2..]));
        let run = |what: &str, options: &[&str]| {
            let table = name(what);
            let said = output(&folder, 0, &search("0.28, 0.3", &table, &[more, options].concat()));
            (said, bytes(&folder, &table))
        };
        let (said, whole) = run("whole", &[]);
        for threads in ["1", "2", "3"] {
            assert_eq!(
                run(threads, &["--threads", threads]),
                (said.clone(), whole.clone()),
                "{more:?} {threads}"
            );
        }
        // Parts are Parquet, and become either.
        let mut merge = vec!["merge".to_owned()];
        for part in ["3/3", "1/3", "2/3"] {
            let table =
                format!("part-{}-{}.parquet", &part[..1], more.first().map_or("all", |option| &option[2..]));
            output(&folder, 0, &search("0.28, 0.3", &table, &[more, &["--part", part]].concat()));
            merge.push(table);
        }
        let merged = name("merged");
        merge.extend(["--output".to_owned(), merged.clone()]);
        let merge: Vec<&str> = merge.iter().map(String::as_str).collect();
        assert_eq!(output(&folder, 0, &merge), said, "the answer is that of the whole run");
        assert_eq!(bytes(&folder, &merged), whole, "{more:?}");
        if ending == "csv" {
            assert_eq!(bytes(&folder, &(merged + ".json")), bytes(&folder, &(name("whole") + ".json")));
        }
        assert!(!folder.join(name("whole") + ".run").exists(), "a run that is done leaves its table alone");
    }
}

#[test]
fn the_table_holds_every_judged_case_with_its_inputs_and_its_request() {
    let folder = folder("runs-content");
    gallery(&folder, "v6-60");
    let arguments = search("0.3", "cases.parquet", &["--even-firing", "--format", "json"]);
    let answer: serde_json::Value = serde_json::from_str(&output(&folder, 0, &arguments)).unwrap();
    let mut reader = TableReader::open(File::open(folder.join("cases.parquet")).unwrap()).unwrap();
    assert_eq!(Some(reader.rows()), answer["counts"]["judged"].as_u64());
    let columns = reader.columns().unwrap();
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    assert_eq!(
        names.join(" "),
        "case bank_angle_deg split_angle_deg stagger_mm spacing_mm rod_ratio counterweights balance_shafts throw_1_deg \
         throw_2_deg throw_3_deg firing_order force_order_1_N couple_order_1_Nm force_order_2_N couple_order_2_Nm"
    );
    let engine = fs::read_to_string(folder.join("v6-60.toml")).unwrap();
    assert_eq!(reader.metadata("lanchester.engine"), Some(engine.as_str()));
    assert_eq!(reader.metadata("lanchester.study"), Some("explore"));
    let request: serde_json::Value =
        serde_json::from_str(reader.metadata("lanchester.request").unwrap()).unwrap();
    assert_eq!(request["request"]["space"]["cylinders"], 6);
    // The first layout of the front is a row with its values.
    let front = &answer["front"][0];
    let rows = reader.next(&columns).unwrap().unwrap();
    let Values::Whole(cases) = &rows.columns()[0] else { panic!("cases are whole numbers") };
    let row = cases.iter().position(|case| Some(*case as u64) == front["layout"]["case"].as_u64()).unwrap();
    for (k, value) in front["values"].as_array().unwrap().iter().enumerate() {
        let Values::Real(values) = &rows.columns()[12 + k] else { panic!("loads are real numbers") };
        assert_eq!(Some(values[row]), value.as_f64(), "{}", names[12 + k]);
    }
    // The same command again reads what is there, another one is refused.
    let again = lanchester(&folder, &arguments);
    assert!(String::from_utf8_lossy(&again.stderr).contains("holds this already"), "{again:?}");
    assert_eq!(serde_json::from_slice::<serde_json::Value>(&again.stdout).unwrap(), answer);
    let other = message(&folder, 2, &search("0.31", "cases.parquet", &["--even-firing"]));
    assert!(other.contains("cases.parquet holds something else and is not overwritten"), "{other}");
}

/// Starts a run twice and kills it as soon as another piece of it is on the disk. Where a run is done before it is killed twice, the
/// next one is twice as long, so that no machine is too fast; gives what makes the run that was killed.
pub fn kill_twice(folder: &Path, table: &str, run: impl Fn(u32) -> Vec<String>) -> Vec<String> {
    let run_folder = folder.join(table.to_owned() + ".run");
    for longer in 0..12 {
        let arguments = run(1 << longer);
        if is_killed_twice(folder, &arguments, &run_folder) {
            return arguments;
        }
        fs::remove_file(folder.join(table)).unwrap();
    }
    panic!(
        "a run four thousand times as long as the first is done before another piece of it is on the disk"
    );
}

/// Whether the run was killed twice before it was done.
fn is_killed_twice(folder: &Path, arguments: &[String], run_folder: &Path) -> bool {
    let tables = || {
        let entries =
            fs::read_dir(run_folder).map(|entries| entries.flatten().collect::<Vec<_>>()).unwrap_or_default();
        entries
            .into_iter()
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|e| e == "parquet"))
            .collect::<Vec<_>>()
    };
    for wanted in [1, 2] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
            .args(arguments)
            .current_dir(folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        while tables().len() < wanted && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(20));
        }
        let _ = child.kill();
        let ended = child.wait().unwrap();
        // What was written stays readable.
        for table in tables() {
            TableReader::open(File::open(table).unwrap()).unwrap();
        }
        if ended.success() {
            return false;
        }
        assert!(ended.code() != Some(2), "the run is refused: {arguments:?}");
    }
    true
}

/// A run killed again and again, without a warning, becomes the table of the run that was not.
#[test]
fn a_killed_run_goes_on_to_the_same_bytes() {
    let folder = folder("runs-killed");
    gallery(&folder, "v6-60");
    // Seconds of one thread; what is done is put on the disk four times a second.
    let more = ["--even-firing", "--throw-angles", "every 5 deg", "--threads", "1"];
    let ratios = |times: u32| format!("0.20 .. 0.45 by {}", 0.005 / f64::from(times));
    let killed = kill_twice(&folder, "killed.parquet", |times| {
        search(&ratios(times), "killed.parquet", &more).iter().map(ToString::to_string).collect()
    });
    let arguments: Vec<&str> = killed.iter().map(String::as_str).collect();
    let ratios = arguments[SEARCH.len()];
    let other = message(&folder, 2, &search("0.3", "killed.parquet", &[]));
    assert!(other.contains("holds what another run has begun"), "{other}");
    let went_on = lanchester(&folder, &arguments);
    assert!(went_on.status.success(), "{went_on:?}");
    let whole = search(ratios, "whole.parquet", &more[..3]);
    assert_eq!(output(&folder, 0, &whole).into_bytes(), went_on.stdout);
    assert!(bytes(&folder, "killed.parquet") == bytes(&folder, "whole.parquet"), "another table");
}

#[test]
fn mistakes_of_runs_are_told() {
    let folder = folder("runs-mistakes");
    gallery(&folder, "v6-60");
    let refused = |arguments: &[&str], said: &str| {
        let told = message(&folder, 2, arguments);
        assert!(told.contains(said), "{told}");
    };
    refused(&search("0.3", "cases.txt", &[]), "a table is written as .parquet or .csv, got cases.txt");
    refused(&search("0.3", "cases.csv", &["--part", "1/2"]), "a part must be a Parquet file");
    refused(&search("0.3", "cases.parquet", &["--part", "3/2"]), "a part is k/n with k from 1 to n");
    refused(
        &search("0.3", "missing/cases.parquet", &["--minimise", "length", "--minimise", "length"]),
        "names length twice",
    );
    fs::write(folder.join("old.parquet"), "something").unwrap();
    refused(&search("0.3", "old.parquet", &[]), "old.parquet exists and is not overwritten");
    fs::write(folder.join("old.csv"), "something").unwrap();
    refused(&search("0.3", "old.csv", &[]), "old.csv exists and is not overwritten");
    refused(&["merge", "old.parquet", "--output", "x.parquet"], "cannot read old.parquet");
    // Parts that are missing, there twice, or of another run.
    for (part, table, ratio) in
        [("1/3", "1.parquet", "0.3"), ("2/3", "2.parquet", "0.3"), ("2/3", "o.parquet", "0.31")]
    {
        output(&folder, 0, &search(ratio, table, &["--part", part]));
    }
    let merge = |parts: &[&str], said: &str| {
        refused(&[&["merge", "--output", "x.parquet"], parts].concat(), said);
    };
    merge(&["1.parquet", "2.parquet"], "a part is missing: blocks");
    merge(&["2.parquet"], "a part is missing: blocks 0 to");
    merge(&["1.parquet", "1.parquet"], "holds blocks that another part holds too");
    merge(&["1.parquet", "o.parquet"], "are not parts of one run");
    assert!(!folder.join("x.parquet").exists());
}

/// A disk that is full: what was done stays, and the message says what to do.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_and_loses_nothing() {
    let folder = folder("runs-full");
    gallery(&folder, "v6-60");
    for table in ["full.parquet", "full.csv"] {
        std::os::unix::fs::symlink("/dev/full", folder.join(table)).unwrap();
        let told = message(&folder, 2, &search("0.3", table, &[]));
        assert!(told.contains(&format!("cannot write {table}: No space left on device")), "{told}");
        assert!(told.contains("the same command goes on from there"), "{told}");
        // The disk has room again: nothing is computed twice.
        fs::remove_file(folder.join(table)).unwrap();
        let run = lanchester(&folder, &search("0.3", table, &[]));
        let said = String::from_utf8_lossy(&run.stderr);
        let blocks =
            said.strip_prefix("going on after ").and_then(|rest| rest.split(' ').next()).unwrap_or_default();
        assert!(
            run.status.success() && said.contains(&format!("after {blocks} of {blocks} blocks")),
            "{said}"
        );
    }
    let told = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .args(&SEARCH[..2])
        .current_dir(&folder)
        .stdout(File::options().write(true).open("/dev/full").unwrap())
        .stderr(Stdio::piped())
        .output()
        .unwrap();
    assert_eq!(told.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&told.stderr).contains("cannot write to standard output"), "{told:?}");
}
