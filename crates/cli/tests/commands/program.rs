//! Running the program.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of its own for one test.
pub fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// A folder with one example as `engine.toml`, changed.
pub fn changed_example(test: &str, name: &str, change: impl Fn(String) -> String) -> PathBuf {
    let folder = folder(test);
    let text = fs::read_to_string(examples().join(name)).unwrap();
    fs::write(folder.join("engine.toml"), change(text)).unwrap();
    folder
}

/// The change that is none.
pub fn same(text: String) -> String {
    text
}

pub fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// Path of an example.
pub fn example(name: &str) -> String {
    examples().join(format!("{name}.toml")).display().to_string()
}

/// The number at a place of some JSON.
pub fn number(value: &serde_json::Value, pointer: &str) -> f64 {
    let found = value.pointer(pointer).and_then(serde_json::Value::as_f64);
    found.unwrap_or_else(|| panic!("no number at {pointer}: {value}"))
}

pub fn lanchester(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lanchester")).args(arguments).current_dir(folder).output().unwrap()
}

/// What stands on standard output of a run that must end with `status`.
pub fn output(folder: &Path, status: i32, arguments: &[&str]) -> String {
    let output = lanchester(folder, arguments);
    let (out, err) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(status), "{arguments:?}\n{out}\n{err}");
    out
}

pub fn message(folder: &Path, status: i32, arguments: &[&str]) -> String {
    let output = lanchester(folder, arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}");
    assert!(output.stdout.is_empty(), "no data on a failure: {arguments:?}");
    String::from_utf8(output.stderr).unwrap()
}

pub fn twin() -> String {
    example("twin-in-line-in-phase")
}

/// The same as JSON.
pub fn output_json(folder: &Path, status: i32, arguments: &[&str]) -> serde_json::Value {
    serde_json::from_str(&output(folder, status, arguments)).unwrap()
}

/// A run with `text` on standard input.
pub fn piped(folder: &Path, arguments: &[&str], text: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that refuses before it reads closes the pipe.
    let _ = child.stdin.take().unwrap().write_all(text);
    child.wait_with_output().unwrap()
}
