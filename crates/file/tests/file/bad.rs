//! Every mistake that a file can make, as its author sees it.

use lanchester_file::workshop::read_sheet;
use lanchester_file::{Diagnostic, Severity, diagnostic_codes, read, render};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Bad engine files.
fn bad_files() -> Vec<PathBuf> {
    let paths = files("tests/bad");
    assert!(paths.len() > 40, "bad files are missing");
    paths
}

/// Bad workshop sheets.
fn bad_sheets() -> Vec<PathBuf> {
    let paths = files("tests/bad-sheets");
    assert!(paths.len() > 8, "bad sheets are missing");
    paths
}

/// What is said about each bad engine file and each bad sheet, with its text.
fn complaints() -> impl Iterator<Item = (PathBuf, String, Vec<Diagnostic>)> {
    let engines = bad_files().into_iter().map(|path| (path, false));
    let sheets = bad_sheets().into_iter().map(|path| (path, true));
    engines.chain(sheets).map(|(path, is_sheet)| {
        let text = fs::read_to_string(&path).expect("cannot read the file");
        let diagnostics = if is_sheet { read_sheet(&text).diagnostics } else { read(&text).diagnostics };
        (path, text, diagnostics)
    })
}

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .expect("no folder of bad files")
        .map(|entry| entry.expect("no entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    paths.sort();
    paths
}

#[test]
fn snap_bad_files() {
    for path in bad_files() {
        let text = fs::read_to_string(&path).expect("cannot read the file");
        let reading = read(&text);
        let has_error = reading.diagnostics.iter().any(|d| d.severity == Severity::Error);
        assert_eq!(reading.file.is_none(), has_error);
        let file_name = path.file_name().and_then(|name| name.to_str()).expect("a file has a name");
        assert!(!reading.diagnostics.is_empty(), "nothing said about {file_name}");
        let name = file_name.trim_end_matches(".toml");
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false, snapshot_path => "../bad" }, {
            insta::assert_snapshot!(name, render(&reading.diagnostics, file_name, &text, false));
        });
    }
}

#[test]
fn snap_bad_sheets() {
    for path in bad_sheets() {
        let text = fs::read_to_string(&path).expect("cannot read the file");
        let reading = read_sheet(&text);
        let has_error = reading.diagnostics.iter().any(|d| d.severity == Severity::Error);
        assert_eq!(reading.sheet.is_none(), has_error);
        let file_name = path.file_name().and_then(|name| name.to_str()).expect("a file has a name");
        assert!(!reading.diagnostics.is_empty(), "nothing said about {file_name}");
        let name = file_name.trim_end_matches(".toml");
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false, snapshot_path => "../bad-sheets" }, {
            insta::assert_snapshot!(name, render(&reading.diagnostics, file_name, &text, false));
        });
    }
}

#[test]
fn every_value_out_of_range_has_a_suggested_fix() {
    let mut seen = 0;
    for (path, _, diagnostics) in complaints() {
        for one in diagnostics.iter().filter(|one| one.code == "E0108" || one.label == "out of range") {
            seen += 1;
            assert!(
                one.hint.as_ref().is_some_and(|hint| !hint.is_empty()),
                "{}: {}",
                path.display(),
                one.message
            );
        }
    }
    assert!(seen > 20, "only {seen}");
}

#[test]
fn diagnostics_are_sorted_unique_and_in_the_house_style() {
    for (path, text, diagnostics) in complaints() {
        let shown = path.display();
        for (place, diagnostic) in diagnostics.iter().enumerate() {
            let Diagnostic { span, message, .. } = diagnostic;
            assert!(text.get(span.clone()).is_some(), "{message} lies off the text of {shown}");
            assert!(!diagnostics[..place].contains(diagnostic), "{message} twice in {shown}");
            assert!(place == 0 || diagnostics[place - 1].span.start <= span.start, "{shown} is not sorted");
            for text in [Some(message), diagnostic.hint.as_ref()].into_iter().flatten() {
                assert!(!text.starts_with(char::is_uppercase) && !text.ends_with('.'), "{text}");
            }
        }
    }
}

#[test]
fn the_codes_are_stable_data() {
    let text = "name = \"x\"\nspeed = \"79,5 rpm\"\n";
    let reading = read(text);
    let json = serde_json::to_value(&reading.diagnostics).expect("diagnostics serialise");
    let comma = json.as_array().and_then(|all| all.iter().find(|d| d["code"] == "E0104")).expect("the comma");
    assert_eq!(
        (&comma["severity"], &comma["line"], &comma["column"]),
        (&"error".into(), &2.into(), &9.into())
    );
}

/// Codes that need more text than a file here should have; `any_file.rs` shows them.
const LARGE: [&str; 3] = ["E0003", "E0004", "E0005"];

#[test]
fn every_code_is_listed_and_has_a_bad_file() {
    let mut seen = BTreeSet::new();
    for (_, _, diagnostics) in complaints() {
        for diagnostic in diagnostics {
            let is_error = diagnostic.severity == Severity::Error;
            assert_eq!(diagnostic.code.starts_with('E'), is_error, "{}", diagnostic.code);
            seen.insert(diagnostic.code);
        }
    }
    seen.extend(LARGE);
    let listed: BTreeSet<&str> = diagnostic_codes().iter().map(|(code, _)| *code).collect();
    assert_eq!(seen, listed);
}
