//! Runs that tell nothing, too little or the contrary: what `workshop correct` says of each sheet in `bad-runs/`.

use crate::program::lanchester;
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn snap_bad_runs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad-runs");
    let mut sheets: Vec<PathBuf> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    sheets.sort();
    assert!(sheets.len() > 10, "bad runs are missing");
    for sheet in sheets {
        let name = sheet.file_stem().and_then(|name| name.to_str()).unwrap();
        let output = lanchester(&folder, &["workshop", "correct", &format!("{name}.toml")]);
        let out = String::from_utf8(output.stdout).unwrap();
        let status = output.status.code().unwrap();
        // What cannot be told is refused; what is doubtful is told with its doubt, and not to be acted upon.
        assert!(status == 2 && out.is_empty() || out.contains("\ndoubt: "), "{name}: {status}\n{out}");
        let said = format!("status {status}\n{}{out}", String::from_utf8(output.stderr).unwrap());
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false, snapshot_path => "../../bad-runs" }, {
            insta::assert_snapshot!(name, said);
        });
    }
}
