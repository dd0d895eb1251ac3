//! `export fmu`: the archive, and what is said where its binary is missing. That units run is tested with FMPy beside the Python package.

use crate::program::{examples, folder};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Runs the program from `folder`, linked there. A copy would be open for writing while another test starts a program,
/// which then holds it open until it runs itself: for that moment the system refuses to run the copy.
fn placed(folder: &Path, arguments: &[&str]) -> Output {
    let program = folder.join(format!("lanchester{EXE_SUFFIX}"));
    if !program.exists() {
        fs::hard_link(env!("CARGO_BIN_EXE_lanchester"), &program).unwrap();
    }
    Command::new(&program).args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn units_hold_description_binary_and_engine_file() {
    let folder = folder("export-unit");
    let engine = examples().join("v6-60.toml").display().to_string();
    let said = placed(&folder, &["export", "fmu", &engine, "--output", "v6.fmu"]);
    let told = String::from_utf8(said.stderr).unwrap();
    assert_eq!(said.status.code(), Some(2), "{told}");
    assert!(told.contains("binary for units is missing") && told.contains("hint: build it with"), "{told}");
    assert!(!folder.join("v6.fmu").exists());
    fs::write(folder.join(format!("{DLL_PREFIX}lanchester_fmu{DLL_SUFFIX}")), "a library").unwrap();
    for (version, binary) in [("2", "binaries/linux64/"), ("3", "binaries/x86_64-linux/")] {
        let unit = format!("{version}.fmu");
        let said = placed(&folder, &["export", "fmu", &engine, "--fmi", version, "--output", &unit]);
        assert!(said.status.success(), "{said:?}");
        let bytes = fs::read(folder.join(&unit)).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        let mut names = vec!["modelDescription.xml", "resources/engine.toml"];
        if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
            names.push(binary);
        }
        for name in names {
            assert!(text.contains(name), "{name}");
        }
        let again = placed(&folder, &["export", "fmu", &engine, "--fmi", version, "--output", &unit]);
        assert_eq!(again.status.code(), Some(2), "a file is never overwritten");
        assert_eq!(fs::read(folder.join(&unit)).unwrap(), bytes);
    }
}

#[test]
fn a_unit_of_another_ending_is_not_written() {
    let folder = folder("export-ending");
    fs::write(folder.join(format!("{DLL_PREFIX}lanchester_fmu{DLL_SUFFIX}")), "a library").unwrap();
    let engine = examples().join("v6-60.toml").display().to_string();
    for name in ["v6.zip", "v6"] {
        let said = placed(&folder, &["export", "fmu", &engine, "--output", name]);
        let told = String::from_utf8(said.stderr).unwrap();
        assert_eq!(said.status.code(), Some(2), "{told}");
        assert!(told.contains("a unit is written as .fmu"), "{told}");
        assert!(!folder.join(name).exists());
    }
}

#[test]
fn forces_by_order_need_speeds() {
    let folder = folder("export-speeds");
    let engine = examples().join("in-line-4.toml").display().to_string();
    let one = placed(&folder, &["export", "nastran", &engine]);
    let told = String::from_utf8(one.stderr).unwrap();
    assert!(one.status.code() == Some(2) && told.contains("hint: add --speeds"), "{told}");
    let falling = ["export", "nastran", &engine, "--speeds", "700 rpm .. 600 rpm by 100 rpm"];
    let told = String::from_utf8(placed(&folder, &falling).stderr).unwrap();
    assert!(told.contains("hint: write the smaller value first") && !told.contains("deg"), "{told}");
}

#[test]
fn the_crank_train_is_a_second_model() {
    let folder = folder("export-crank-train");
    fs::write(folder.join(format!("{DLL_PREFIX}lanchester_fmu{DLL_SUFFIX}")), "a library").unwrap();
    let engine = examples().join("generator-set-3.toml").display().to_string();
    let export = |engine: &str, unit: &str| {
        placed(&folder, &["export", "fmu", engine, "--model", "crank-train", "--output", unit])
    };
    let said = export(&engine, "set.fmu");
    assert!(said.status.success(), "{said:?}");
    let notes = String::from_utf8(said.stderr).unwrap();
    assert!(notes.contains("note: Friction: "), "{notes}");
    assert!(folder.join("set.fmu").exists());
    // Free speed needs a moment of inertia; nothing is written.
    let engine = examples().join("v6-60.toml").display().to_string();
    let said = export(&engine, "v6.fmu");
    let told = String::from_utf8(said.stderr).unwrap();
    assert_eq!(said.status.code(), Some(2), "{told}");
    assert!(told.contains("moment of inertia"), "{told}");
    assert!(!folder.join("v6.fmu").exists());
}
