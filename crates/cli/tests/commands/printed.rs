//! `--brief` and `--units`: every command that has them, on one engine with typical values.

use crate::program::{example, folder, message, number, output, output_json};
use std::fs;
use std::path::PathBuf;

/// Completed engines of the gallery as `four.toml` and `twin.toml`.
fn four(test: &str) -> PathBuf {
    let folder = folder(test);
    for (name, layout) in [("four.toml", "in-line-4"), ("twin.toml", "twin-180")] {
        let text = output(&folder, 0, &["new", layout, "--complete"]);
        fs::write(folder.join(name), text).unwrap();
    }
    folder
}

/// Every command that answers in sentences and tables.
const COMMANDS: [&[&str]; 12] = [
    &["loads", "four.toml"],
    &["balance", "four.toml"],
    &["torque", "four.toml", "--flywheel", "0.1 kg m^2"],
    &["bearings", "four.toml"],
    &["mounts", "four.toml"],
    &["compare", "four.toml", "twin.toml"],
    &["simulate", "four.toml"],
    &["torsion", "four.toml"],
    &["stress", "rule", "four.toml", "--without-torsion"],
    &["balance", "four.toml", "--method", "matrix"],
    &["scatter", "four.toml", "--samples", "2000"],
    &["explore", "four.toml"],
];

/// Units that no text for an American has: between a number and the end of a word, or in brackets.
const SI: [&str; 17] = [
    "N", "kN", "N m", "kN m", "mm", "um", "kg", "g", "g mm", "kg mm", "kg m", "bar", "MPa", "J", "kW", "m/s",
    "cm^3",
];

/// Where the text has a quantity in one of these units; names between backquotes are as the file writes them.
fn left_in_si(text: &str) -> Vec<String> {
    let plain = text.split('`').step_by(2).collect::<Vec<_>>().join("");
    let ends = |rest: &str| {
        !rest.starts_with(|c: char| c.is_alphanumeric() || matches!(c, '/' | '^' | '\u{b2}' | '\u{b3}'))
    };
    let mut found = Vec::new();
    for unit in SI {
        for head in [format!("[{unit}]"), format!("  {unit}  ")] {
            found.extend(plain.contains(&head).then(|| head.clone()));
        }
        for (at, _) in plain.match_indices(&format!(" {unit}")) {
            let before = plain[..at].ends_with(|c: char| c.is_ascii_digit());
            if before && ends(&plain[at + 1 + unit.len()..]) {
                found.push(plain[at.saturating_sub(12)..].chars().take(24).collect());
            }
        }
    }
    found
}

#[test]
fn a_brief_answer_is_a_few_lines_and_no_table() {
    let folder = four("a_brief_answer_is_a_few_lines_and_no_table");
    // Without other units: shares, orders, derivatives by what the file has in its own.
    let plain: [&[&str]; 2] = [&["sensitivity", "four.toml"], &["crosscheck", "four.toml"]];
    for command in COMMANDS.into_iter().chain(plain) {
        let brief = output(&folder, 0, &[command, &["--brief"]].concat());
        let whole = output(&folder, 0, command);
        let lines = brief.lines().count();
        assert!((2..=12).contains(&lines), "{command:?} has {lines} lines\n{brief}");
        assert!(lines < whole.lines().count() / 2, "{command:?}");
        assert!(!brief.contains("---") && brief.ends_with('\n'), "{brief}");
        assert!(brief.contains("line 4"), "it says of what it is: {brief}");
    }
    let loads = output(&folder, 0, &["loads", "four.toml", "--brief"]);
    assert!(loads.contains("largest resultant force |F|   16\u{a0}733 N\n"), "{loads}");
    // What a search and a check are asked for, not how they went.
    let layouts = output(&folder, 0, &["explore", "four.toml", "--brief"]);
    assert!(layouts.contains("Pareto-optimal layouts") && layouts.contains("least couple 1"), "{layouts}");
    let parts = example("in-line-3-counterweights");
    let checked = output(&folder, 0, &["counterweight", "check", &parts, "--brief"]);
    assert!(
        checked.contains("The smallest clearance is 4.146 mm") && checked.lines().count() < 4,
        "{checked}"
    );
}

#[test]
fn every_text_can_have_units_of_the_united_states() {
    let folder = four("every_text_can_have_units_of_the_united_states");
    for command in COMMANDS {
        for more in [&["--units", "us"][..], &["--units", "us", "--brief"]] {
            let us = output(&folder, 0, &[command, more].concat());
            assert_eq!(left_in_si(&us), Vec::<String>::new(), "{command:?} {more:?}\n{us}");
        }
        // The search for what is left finds something where there is something.
        let si = output(&folder, 0, &[command, &["--units", "si"]].concat());
        assert!(!left_in_si(&si).is_empty(), "{command:?}");
    }
    let loads = output(&folder, 0, &["loads", "four.toml", "--units", "us", "--brief"]);
    assert!(loads.contains("3761.7 lbf\n") && loads.contains("872.46 lbf ft\n"), "{loads}");
}

#[test]
fn csv_is_converted_column_by_column_and_json_stays_si() {
    let folder = four("csv_is_converted_column_by_column_and_json_stays_si");
    for command in [
        &["loads", "four.toml", "--table", "trace"][..],
        &["bearings", "four.toml"],
        &["mounts", "four.toml", "--speed", "3000 rpm"],
        &["simulate", "four.toml", "--table", "orders"],
        &["torsion", "four.toml", "--table", "torques"],
        &["explore", "four.toml"],
    ] {
        let si = output(&folder, 0, &[command, &["--format", "csv"]].concat());
        let us = output(&folder, 0, &[command, &["--format", "csv", "--units", "us"]].concat());
        assert_eq!(si.lines().count(), us.lines().count());
        let cells = |text: &str| -> Vec<Vec<String>> {
            text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
        };
        let (si, us) = (cells(&si), cells(&us));
        let mut changed = 0;
        for (column, head) in si[0].iter().enumerate() {
            // Factors of NIST SP 811, apart from the program's own.
            let (name, factor) = match head.rsplit_once('[').map(|(_, unit)| unit.trim_end_matches(']')) {
                Some("N") => ("lbf", 0.224_808_943),
                Some("N m") => ("lbf ft", 0.737_562_149),
                Some("mm") => ("in", 1.0 / 25.4),
                _ => ("", 1.0),
            };
            if name.is_empty() {
                continue;
            }
            changed += 1;
            assert!(us[0][column].ends_with(&format!("[{name}]")), "{head}: {}", us[0][column]);
            for (before, after) in si.iter().zip(&us).skip(1) {
                let value = |cell: &str| cell.parse::<f64>().unwrap_or(f64::NAN);
                let (before, after) = (value(&before[column]), value(&after[column]));
                // Nine digits of the factors.
                assert!(
                    before.is_nan() || (after - factor * before).abs() <= 2e-9 * after.abs(),
                    "{head} {before} {after}"
                );
            }
        }
        assert!(changed > 0, "{command:?} has no force, moment or length");
    }
    let [si, us] = ["si", "us"].map(|units| {
        let json = output_json(&folder, 0, &["loads", "four.toml", "--format", "json", "--units", units]);
        number(&json, "/total/peaks/force/max/value")
    });
    assert_eq!(si, us);
}

#[test]
fn wrong_values_are_refused_with_the_list() {
    let folder = four("wrong_values_are_refused_with_the_list");
    let words = message(&folder, 2, &["loads", "four.toml", "--units", "imperial"]);
    assert!(words.contains("imperial") && words.contains("[possible values: si, us]"), "{words}");
    let words = message(&folder, 2, &["torque", "four.toml", "--brief", "--format", "csv"]);
    assert!(words.contains("--brief is a form of text"), "{words}");
    fs::write(folder.join("cases.csv"), "rod.length [mm]\n150\n").unwrap();
    let words = message(&folder, 2, &["loads", "four.toml", "--brief", "--cases", "cases.csv"]);
    assert!(words.contains("--brief is of one engine"), "{words}");
    let words = message(
        &folder,
        2,
        &["loads", "four.toml", "--units", "us", "--cases", "cases.csv", "--output", "out.xlsx"],
    );
    assert!(words.contains("a workbook of cases is written in SI units"), "{words}");
}
